//! Reads a file and splits the GLB container (glTF 2.0 specification, chapter 4) into JSON and binary chunk.

use std::path::Path;

use super::fault::Fault;
use crate::SceneError;

/// Largest file read: what a GLB header can express.
const MAX_FILE_BYTES: u64 = u32::MAX as u64;
const MAGIC: &[u8] = b"glTF";
const HEADER_BYTES: usize = 12;
const CHUNK_HEADER_BYTES: usize = 8;
const JSON_CHUNK: u32 = 0x4E4F_534A;
const BIN_CHUNK: u32 = 0x004E_4942;

/// Reads a file whole.
pub(super) fn read_file(path: &Path) -> Result<Vec<u8>, Fault> {
    let io_fault = |source| Fault::Whole(SceneError::Io { path: path.to_owned(), source });
    crate::file::read(path, MAX_FILE_BYTES).map_err(io_fault)
}

/// The JSON text and, in a GLB, the binary chunk.
pub(super) fn split(bytes: &[u8]) -> Result<(&[u8], Option<&[u8]>), Fault> {
    if bytes.is_empty() {
        return Err(Fault::at("file", "empty: neither glTF JSON nor GLB"));
    }
    if !bytes.starts_with(MAGIC) {
        return Ok((bytes.strip_prefix(b"\xEF\xBB\xBF").unwrap_or(bytes), None));
    }
    let header = |offset| {
        u32_at(bytes, offset).ok_or_else(|| {
            Fault::at(
                "GLB header",
                format!("expected {HEADER_BYTES} bytes, found {}: the file is truncated", bytes.len()),
            )
        })
    };
    let (version, length) = (header(4)?, header(8)?);
    if version != 2 {
        return Err(Fault::at(
            "GLB header",
            format!("version {version}, only 2 is supported: re-export as glTF 2.0"),
        ));
    }
    if length as usize != bytes.len() {
        return Err(Fault::at(
            "GLB header",
            format!(
                "expected a file of {length} bytes, found {}: it is truncated or was altered; copy it again",
                bytes.len()
            ),
        ));
    }
    chunks(bytes)
}

fn chunks(bytes: &[u8]) -> Result<(&[u8], Option<&[u8]>), Fault> {
    let (mut json, mut bin) = (None, None);
    let mut at = HEADER_BYTES;
    for index in 0.. {
        if at == bytes.len() || (json.is_some() && bin.is_some()) {
            break;
        }
        let place = || format!("GLB chunk {index} at byte {at}");
        let left = bytes.len() - at;
        let (Some(length), Some(kind)) = (u32_at(bytes, at), u32_at(bytes, at + 4)) else {
            let problem = format!("expected a header of {CHUNK_HEADER_BYTES} bytes, found {left}");
            return Err(Fault::at(place(), problem));
        };
        let start = at + CHUNK_HEADER_BYTES;
        let Some(data) = start.checked_add(length as usize).and_then(|end| bytes.get(start..end)) else {
            let found = left - CHUNK_HEADER_BYTES;
            return Err(Fault::at(
                place(),
                format!("expected {length} bytes, found {found}: the file is truncated"),
            ));
        };
        match (index, kind) {
            (0, JSON_CHUNK) => json = Some(data),
            (0, _) => {
                return Err(Fault::at(place(), format!("expected JSON, found chunk type {kind:#010x}")));
            }
            (1, BIN_CHUNK) => bin = Some(data),
            // The specification has readers ignore chunks they do not know.
            _ => {}
        }
        at = start + data.len();
    }
    let json = json.ok_or_else(|| Fault::at("GLB", "expected a JSON chunk, found none"))?;
    Ok((json, bin))
}

fn u32_at(bytes: &[u8], offset: usize) -> Option<u32> {
    Some(u32::from_le_bytes(bytes.get(offset..)?.first_chunk::<4>().copied()?))
}
