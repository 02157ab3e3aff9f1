//! Fetches what a URI names: inline data (RFC 2397), or a file that must lie inside the asset's folder.

use std::{
    borrow::Cow,
    collections::HashMap,
    fs,
    path::{Component, Path, PathBuf},
    sync::Arc,
};

use base64::{
    Engine,
    alphabet::STANDARD,
    engine::{DecodePaddingMode, GeneralPurpose, GeneralPurposeConfig},
};
use percent_encoding::percent_decode_str;

use super::{container::read_file, fault::Fault};
use crate::SceneError;

/// Base64 with or without its padding, as exporters disagree.
const BASE64: GeneralPurpose = GeneralPurpose::new(
    &STANDARD,
    GeneralPurposeConfig::new().with_decode_padding_mode(DecodePaddingMode::Indifferent),
);

/// Bytes behind URIs; a file named twice is read once.
pub(super) struct Files {
    folder: PathBuf,
    read: HashMap<PathBuf, Arc<[u8]>>,
    total_bytes: usize,
}

impl Files {
    /// Beside the asset at `path`.
    pub(super) fn beside(path: &Path) -> Self {
        let folder = path.parent().filter(|p| !p.as_os_str().is_empty()).unwrap_or(Path::new("."));
        Self { folder: folder.to_owned(), read: HashMap::new(), total_bytes: 0 }
    }

    /// The bytes that `uri`, found at `place`, stands for.
    pub(super) fn fetch(&mut self, uri: &str, place: &str) -> Result<Arc<[u8]>, Fault> {
        if uri.get(..5).is_some_and(|s| s.eq_ignore_ascii_case("data:")) {
            let bytes = inline(&uri[5..], place)?;
            self.total_bytes += bytes.len();
            return Ok(bytes.into());
        }
        let path = self.resolve(uri, place)?;
        if let Some(bytes) = self.read.get(&path) {
            return Ok(Arc::clone(bytes));
        }
        let bytes: Arc<[u8]> = read_file(&path)?.into();
        self.total_bytes += bytes.len();
        self.read.insert(path, Arc::clone(&bytes));
        Ok(bytes)
    }

    /// Bytes in memory so far; a file counts once however often it was named.
    pub(super) fn total_bytes(&self) -> usize {
        self.total_bytes
    }

    /// The file that a relative URI names, symbolic links followed, if it lies inside the folder.
    fn resolve(&self, uri: &str, place: &str) -> Result<PathBuf, Fault> {
        let fault = |problem: &str| Fault::at(place, format!("{uri:?} {problem}"));
        let has_scheme = uri.split(['/', '?', '#']).next().is_some_and(|head| head.contains(':'));
        if has_scheme {
            return Err(fault("is not a relative path: put the file beside the asset"));
        }
        let decoded = percent_decode_str(uri).decode_utf8().map_err(|_| fault("does not decode to UTF-8"))?;
        if decoded.is_empty() || decoded.contains('\0') {
            return Err(fault("names no file"));
        }
        let relative = Path::new(decoded.as_ref());
        if escapes(relative) {
            return Err(fault("leads out of the asset's folder: put the file inside it"));
        }
        let joined = self.folder.join(relative);
        let real = |path: &Path| {
            let path = path.to_owned();
            fs::canonicalize(&path).map_err(|source| Fault::Whole(SceneError::Io { path, source }))
        };
        let (file, folder) = (real(&joined)?, real(&self.folder)?);
        if !file.starts_with(&folder) {
            return Err(fault("leads out of the asset's folder through a link: put the file inside it"));
        }
        Ok(file)
    }
}

/// Whether a path is absolute or climbs above where it starts.
fn escapes(path: &Path) -> bool {
    let mut depth = 0_i64;
    for part in path.components() {
        match part {
            Component::Normal(_) => depth += 1,
            Component::CurDir => {}
            Component::ParentDir => depth -= 1,
            Component::RootDir | Component::Prefix(_) => return true,
        }
        if depth < 0 {
            return true;
        }
    }
    false
}

/// Decodes what follows `data:`.
fn inline(rest: &str, place: &str) -> Result<Vec<u8>, Fault> {
    let (kind, data) = rest.split_once(',').ok_or_else(|| Fault::at(place, "data URI without a comma"))?;
    let bytes: Cow<'_, [u8]> = percent_decode_str(data).into();
    if !kind.to_ascii_lowercase().ends_with(";base64") {
        return Ok(bytes.into_owned());
    }
    BASE64.decode(&bytes).map_err(|e| Fault::at(place, format!("data URI is not base64: {e}")))
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_path_may_turn_but_not_climb_out() {
        for (path, expected) in [
            ("a.bin", false),
            ("./a/../b.bin", false),
            ("a/b/../../c.bin", false),
            ("../a.bin", true),
            ("a/../../b.bin", true),
            ("/etc/passwd", true),
        ] {
            assert_eq!(escapes(Path::new(path)), expected, "{path}");
        }
    }

    #[test]
    fn inline_data_decodes_with_and_without_padding() {
        assert_eq!(inline("application/octet-stream;base64,AQI=", "x").unwrap(), [1, 2]);
        assert_eq!(inline(";base64,AQI", "x").unwrap(), [1, 2]);
        assert_eq!(inline("text/plain,a%20b", "x").unwrap(), b"a b");
        assert!(inline("text/plain", "x").is_err());
        assert!(inline(";base64,A*==", "x").is_err());
    }
}
