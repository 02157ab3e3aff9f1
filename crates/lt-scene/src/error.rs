//! What can go wrong with a scene.

use std::path::PathBuf;

/// An error that names the file or scene, the place in it, and what to do about it.
#[derive(Debug, thiserror::Error)]
#[non_exhaustive]
pub enum SceneError {
    /// A file could not be read.
    #[error("{path}: {source}")]
    Io {
        /// The file.
        path: PathBuf,
        /// What the system said.
        source: std::io::Error,
    },
    /// A file is malformed at a place that can be named.
    #[error("{path}: {place}: {problem}")]
    Malformed {
        /// The file.
        path: PathBuf,
        /// Where in it, e.g. `meshes[3].primitives[0].attributes.POSITION`.
        place: String,
        /// What is wrong and how to mend it.
        problem: String,
    },
    /// A file requires a glTF extension that this importer does not know.
    #[error("{path}: extensionsRequired: {extension} is not supported; {remedy}")]
    UnsupportedExtension {
        /// The file.
        path: PathBuf,
        /// The extension's name, e.g. `KHR_draco_mesh_compression`.
        extension: String,
        /// How to get a file without it.
        remedy: String,
    },
    /// A name that is no built-in scene, or a parameter out of range.
    #[error("{0}")]
    UnknownScene(String),
}
