//! Atomic replacement of files, and digests of their content.

use std::fs;
use std::path::Path;

use anyhow::{Context, Result};
use sha2::{Digest, Sha256};

/// Puts `content` at `path` through a temporary file and a rename; leaves an equal file untouched.
///
/// Returns whether the file changed. The folder must exist.
///
/// # Errors
/// Reading, writing or renaming fails.
pub fn replace(path: &Path, content: &[u8]) -> Result<bool> {
    if fs::read(path).is_ok_and(|old| old == content) {
        return Ok(false);
    }
    let mut name = path.file_name().unwrap_or_default().to_os_string();
    name.push(format!(".{}.tmp", std::process::id()));
    let temporary = path.with_file_name(name);
    let outcome = fs::write(&temporary, content).and_then(|()| fs::rename(&temporary, path));
    if outcome.is_err() {
        // The write error is the one worth reporting; the leftover may not even exist.
        let _ = fs::remove_file(&temporary);
    }
    outcome.with_context(|| format!("cannot write {}", path.display()))?;
    Ok(true)
}

/// The SHA-256 of `content` as 64 lower-case hexadecimal digits.
pub fn sha256(content: &[u8]) -> String {
    hex(Sha256::digest(content).as_slice())
}

/// Bytes as lower-case hexadecimal digits.
pub fn hex(bytes: &[u8]) -> String {
    bytes.iter().map(|byte| format!("{byte:02x}")).collect()
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn digest_matches_the_published_example() {
        // FIPS 180-4 example: "abc".
        assert_eq!(sha256(b"abc"), "ba7816bf8f01cfea414140de5dae2223b00361a396177a9cb410ff61f20015ad");
    }

    #[test]
    fn an_equal_file_is_left_untouched_and_a_different_one_is_replaced() {
        let dir = tempfile::tempdir().unwrap();
        let path = dir.path().join("a.spv");
        assert!(replace(&path, b"one").unwrap());
        assert!(!replace(&path, b"one").unwrap());
        assert!(replace(&path, b"two").unwrap());
        assert_eq!(fs::read(&path).unwrap(), b"two");
        assert_eq!(fs::read_dir(dir.path()).unwrap().count(), 1, "no temporary file remains");
    }

    #[test]
    fn a_missing_folder_is_an_error() {
        let dir = tempfile::tempdir().unwrap();
        assert!(replace(&dir.path().join("no/such/file"), b"").is_err());
    }
}
