//! Digest of everything in the checkout that decides what the shader modules contain.
//!
//! Host-only files do not count: the list of sources comes from the compiler, which never opened them.

use std::collections::BTreeSet;
use std::fs;
use std::path::Path;

use anyhow::{Context, Result};
use sha2::{Digest, Sha256};

use crate::{backend, compile, files};

/// Crates from the registry whose code ends up in modules.
const LIBRARIES: [&str; 5] = ["bytemuck", "glam", "num-traits", "spirv-std", "spirv-std-macros"];

/// The SHA-256 over `sources`, the `Cargo.toml` of each of their crates, the locked versions of the libraries
/// they use, and the compiler with its options.
///
/// `sources` are paths relative to `root`, with forward slashes. Line ends do not matter.
///
/// # Errors
/// A file cannot be read; one that was moved or deleted counts as such.
pub fn digest(root: &Path, sources: &[String]) -> Result<String> {
    let mut paths: BTreeSet<String> = sources.iter().cloned().collect();
    for source in sources {
        // crates/lt-math/src/warp.rs -> crates/lt-math/Cargo.toml
        if let Some((package, _)) = source.split_once("/src/") {
            paths.insert(format!("{package}/Cargo.toml"));
        }
    }
    let mut hasher = Sha256::new();
    for path in paths {
        feed(&mut hasher, &path, &read(&root.join(&path))?);
    }
    feed(&mut hasher, "Cargo.lock", &locked(&read(&root.join("Cargo.lock"))?));
    feed(&mut hasher, "compiler", &recipe());
    Ok(files::hex(hasher.finalize().as_slice()))
}

/// Length prefixes keep neighbouring fields apart.
fn feed(hasher: &mut Sha256, name: &str, content: &str) {
    for part in [name, content] {
        hasher.update((part.len() as u64).to_le_bytes());
        hasher.update(part);
    }
}

fn read(path: &Path) -> Result<String> {
    let text = fs::read_to_string(path).with_context(|| format!("cannot read {}", path.display()))?;
    Ok(text.replace("\r\n", "\n"))
}

fn recipe() -> String {
    format!(
        "{} {} {} {}",
        backend::TOOLCHAIN,
        backend::VERSION,
        compile::TARGET,
        compile::BACKEND_ARGS.join(" ")
    )
}

/// One line `name = "…" version = "…"` for each of [`LIBRARIES`] in the text of a lock file.
fn locked(lock: &str) -> String {
    let mut lines = lock.lines().peekable();
    let mut found = String::new();
    while let Some(line) = lines.next() {
        let name = line.strip_prefix("name = \"").and_then(|rest| rest.strip_suffix('"'));
        if name.is_some_and(|name| LIBRARIES.contains(&name)) {
            let version = lines.peek().copied().unwrap_or_default();
            found.push_str(&format!("{line} {version}\n"));
        }
    }
    found
}

#[cfg(test)]
mod tests {
    use super::*;

    fn checkout() -> (tempfile::TempDir, Vec<String>) {
        let dir = tempfile::tempdir().unwrap();
        fs::create_dir_all(dir.path().join("crates/a/src")).unwrap();
        for (path, text) in [
            ("crates/a/src/lib.rs", "pub fn one() {}\n"),
            ("crates/a/src/host.rs", "pub fn two() {}\n"),
            ("crates/a/Cargo.toml", "[package]\n"),
            ("Cargo.lock", "name = \"glam\"\nversion = \"1\"\n\nname = \"serde\"\nversion = \"1\"\n"),
        ] {
            fs::write(dir.path().join(path), text).unwrap();
        }
        (dir, vec!["crates/a/src/lib.rs".to_owned()])
    }

    /// The digest after replacing the content of one file.
    fn after(path: &str, text: &str) -> String {
        let (dir, sources) = checkout();
        fs::write(dir.path().join(path), text).unwrap();
        digest(dir.path(), &sources).unwrap()
    }

    fn unchanged() -> String {
        let (dir, sources) = checkout();
        digest(dir.path(), &sources).unwrap()
    }

    #[test]
    fn what_reaches_modules_changes_the_digest() {
        assert_ne!(after("crates/a/src/lib.rs", "pub fn one() { }\n"), unchanged());
        assert_ne!(after("crates/a/Cargo.toml", "[package]\n\n"), unchanged());
        assert_ne!(after("Cargo.lock", "name = \"glam\"\nversion = \"2\"\n"), unchanged());
    }

    #[test]
    fn what_does_not_reach_modules_leaves_the_digest() {
        assert_eq!(after("crates/a/src/host.rs", ""), unchanged());
        assert_eq!(after("crates/a/src/lib.rs", "pub fn one() {}\r\n"), unchanged());
        assert_eq!(after("Cargo.lock", "name = \"glam\"\nversion = \"1\"\n"), unchanged());
    }

    #[test]
    fn a_missing_source_is_an_error() {
        let (dir, _) = checkout();
        assert!(digest(dir.path(), &["crates/a/src/gone.rs".to_owned()]).is_err());
    }
}
