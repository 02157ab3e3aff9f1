//! Reads files that a user names.

use std::{fs, io, path::Path};

/// A regular file whole. Devices and pipes, which may never end, are refused, and files of more than `most` bytes.
pub(crate) fn read(path: &Path, most: u64) -> io::Result<Vec<u8>> {
    let meta = fs::metadata(path)?;
    if !meta.is_file() {
        return Err(io::Error::new(io::ErrorKind::InvalidInput, "not a regular file"));
    }
    if meta.len() > most {
        let problem = format!("{} bytes, more than the {most} that such a file can hold", meta.len());
        return Err(io::Error::new(io::ErrorKind::FileTooLarge, problem));
    }
    fs::read(path)
}
