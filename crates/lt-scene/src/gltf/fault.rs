//! What went wrong, before the file it went wrong in is known.

use std::path::Path;

use crate::SceneError;

/// A failure inside the asset.
#[derive(Debug)]
pub(super) enum Fault {
    /// Malformed at a place of the JSON, such as `accessors[3].count`.
    Place { place: String, problem: String },
    /// An extension is required that nobody here knows.
    Extension { extension: String, remedy: String },
    /// Complete already, it names its own file.
    Whole(SceneError),
}

impl Fault {
    pub(super) fn at(place: impl Into<String>, problem: impl Into<String>) -> Self {
        Self::Place { place: place.into(), problem: problem.into() }
    }

    /// Names the file.
    pub(super) fn in_file(self, path: &Path) -> SceneError {
        let path = path.to_owned();
        match self {
            Self::Place { place, problem } => SceneError::Malformed { path, place, problem },
            Self::Extension { extension, remedy } => {
                SceneError::UnsupportedExtension { path, extension, remedy }
            }
            Self::Whole(error) => error,
        }
    }
}

/// The element an index points at, or a fault at `place` saying how many there are.
pub(super) fn pick<'a, T>(
    list: &'a [T],
    index: usize,
    name: &str,
    place: impl FnOnce() -> String,
) -> Result<&'a T, Fault> {
    list.get(index).ok_or_else(|| {
        Fault::at(place(), format!("points at {name}[{index}], but the file has {} of them", list.len()))
    })
}
