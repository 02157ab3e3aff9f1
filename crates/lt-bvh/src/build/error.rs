//! What can be wrong with input to a build.

use std::fmt;

/// Why nothing was built.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
#[non_exhaustive]
pub enum BuildError {
    /// A triangle names a vertex that is not there.
    VertexOutOfRange {
        /// The triangle's index.
        triangle: usize,
        /// The vertex it names.
        vertex: u32,
        /// How many vertices there are.
        vertices: usize,
    },
    /// A refit to another mesh than the tree was built over.
    OtherTriangleCount {
        /// Triangles handed over.
        found: usize,
        /// Triangles it was built over.
        expected: usize,
    },
    /// A refit after which a triangle can be hit that could not before, or the reverse: NaN, infinity, or all three
    /// vertices on one line.
    OtherTriangleDropped {
        /// The triangle's index.
        triangle: usize,
    },
    /// More triangles, vertices or instances than the 31-bit indices of the buffers can name.
    TooMany {
        /// How many there are.
        found: usize,
        /// How many there may be.
        limit: usize,
    },
    /// A placement names a BLAS that is not there.
    BlasOutOfRange {
        /// The placement's index.
        placement: usize,
        /// The BLAS it names.
        blas: u32,
        /// How many BLASes there are.
        count: usize,
    },
    /// A placement's matrix holds NaN, infinity or too large a number, or cannot be inverted in f32.
    Singular {
        /// The placement's index.
        placement: usize,
    },
}

impl fmt::Display for BuildError {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            BuildError::VertexOutOfRange { triangle, vertex, vertices } => write!(
                f,
                "triangle {triangle} names vertex {vertex}, but there are {vertices}: \
                 remove the triangle or add the vertex"
            ),
            BuildError::OtherTriangleCount { found, expected } => {
                write!(f, "{found} triangles for a tree built over {expected}: build anew")
            }
            BuildError::OtherTriangleDropped { triangle } => write!(
                f,
                "triangle {triangle} lost its area or its finite vertices, or got them back: build anew"
            ),
            BuildError::TooMany { found, limit } => {
                write!(f, "{found} triangles, vertices or instances, of at most {limit}: split the mesh")
            }
            BuildError::BlasOutOfRange { placement, blas, count } => {
                write!(f, "placement {placement} names mesh {blas}, but there are {count}")
            }
            BuildError::Singular { placement } => write!(
                f,
                "placement {placement} has a matrix that cannot be inverted: \
                 check it for NaN, infinity and scales of zero"
            ),
        }
    }
}

impl std::error::Error for BuildError {}
