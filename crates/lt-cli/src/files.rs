//! Files that appear whole or not at all: written under a temporary name beside the target, then renamed.

use std::{
    fs::{self, File},
    io::{BufWriter, Write},
    path::Path,
};

use anyhow::Context;
use tempfile::{Builder, NamedTempFile};

/// Creates `dir` with its parents and proves that files can be written there, before any long work.
///
/// # Errors
/// Names the folder and what the system said.
pub fn prepare_dir(dir: &Path) -> anyhow::Result<()> {
    fs::create_dir_all(dir).with_context(|| format!("{}: cannot create this folder", dir.display()))?;
    temporary_in(dir)
        .map(drop)
        .with_context(|| format!("{}: cannot write into this folder; choose another", dir.display()))
}

/// Writes `path` through `fill`; whatever stood there before stays until the new file is complete.
///
/// # Errors
/// Names the path and what `fill` or the system said.
pub fn write(
    path: &Path,
    fill: impl FnOnce(&mut BufWriter<&File>) -> anyhow::Result<()>,
) -> anyhow::Result<()> {
    try_write(path, fill).with_context(|| format!("{}: cannot be written", path.display()))
}

fn try_write(
    path: &Path,
    fill: impl FnOnce(&mut BufWriter<&File>) -> anyhow::Result<()>,
) -> anyhow::Result<()> {
    let file = temporary_in(folder_of(path))?;
    let mut writer = BufWriter::new(file.as_file());
    fill(&mut writer)?;
    writer.flush()?;
    drop(writer);
    file.persist(path)?;
    Ok(())
}

/// The folder a file lies in: `.` for a bare name.
pub fn folder_of(path: &Path) -> &Path {
    path.parent().filter(|p| !p.as_os_str().is_empty()).unwrap_or(Path::new("."))
}

fn temporary_in(dir: &Path) -> std::io::Result<NamedTempFile> {
    let mut builder = Builder::new();
    builder.prefix(".lt-").suffix(".tmp");
    #[cfg(unix)]
    {
        use std::os::unix::fs::PermissionsExt;
        // As any other new file: the user's mask decides (the default is for secrets, 0600).
        builder.permissions(fs::Permissions::from_mode(0o666));
    }
    builder.tempfile_in(dir)
}

/// A technique id as a file stem: `ltt-evsm:eps=0.02` becomes `ltt-evsm_eps_0.02`.
pub fn stem(technique_id: &str) -> String {
    technique_id.replace(|c: char| !c.is_ascii_alphanumeric() && c != '-' && c != '.', "_")
}

#[cfg(test)]
mod tests {
    use super::*;

    fn bytes_of(path: &Path) -> Vec<u8> {
        fs::read(path).unwrap()
    }

    #[test]
    fn a_failed_write_keeps_the_old_file_and_leaves_nothing_behind() {
        let dir = tempfile::tempdir().unwrap();
        let path = dir.path().join("results.json");
        write(&path, |w| Ok(w.write_all(b"old")?)).unwrap();
        let error = write(&path, |w| {
            w.write_all(b"half")?;
            anyhow::bail!("no more ink")
        });
        let text = format!("{:#}", error.unwrap_err());
        assert!(text.contains("results.json") && text.contains("no more ink"), "{text}");
        assert_eq!(bytes_of(&path), b"old");
        assert_eq!(fs::read_dir(dir.path()).unwrap().count(), 1);
    }

    #[test]
    fn a_new_file_replaces_the_old() {
        let dir = tempfile::tempdir().unwrap();
        let path = dir.path().join("a");
        for text in [&b"one"[..], b"two"] {
            write(&path, |w| Ok(w.write_all(text)?)).unwrap();
            assert_eq!(bytes_of(&path), text);
        }
    }

    #[test]
    fn a_folder_that_is_a_file_is_named() {
        let dir = tempfile::tempdir().unwrap();
        let path = dir.path().join("taken");
        fs::write(&path, b"x").unwrap();
        assert!(format!("{:#}", prepare_dir(&path).unwrap_err()).contains("taken"));
        prepare_dir(&dir.path().join("a/b")).unwrap();
        assert!(dir.path().join("a/b").is_dir());
    }

    #[test]
    fn stems_are_portable() {
        assert_eq!(stem("ltt-evsm:prefiltered:eps=0.02"), "ltt-evsm_prefiltered_eps_0.02");
    }
}
