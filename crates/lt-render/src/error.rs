//! What can go wrong while rendering.

/// An error of the frame driver or a backend.
#[derive(Debug, thiserror::Error)]
#[non_exhaustive]
pub enum RenderError {
    /// A setup that cannot be drawn.
    #[error("{0}")]
    BadSetup(String),
    /// The BVH could not be built.
    #[error("acceleration structure: {0}")]
    Build(String),
    /// A technique that this backend or scene has no means for.
    #[error("{0}")]
    Unsupported(String),
    /// The caller asked to stop.
    #[error("stopped")]
    Cancelled,
    /// No usable GPU.
    #[error(
        "no GPU adapter: {0}; use --backend cpu, or install a Vulkan driver (Debian: apt-get install mesa-vulkan-drivers)"
    )]
    NoAdapter(String),
    /// The GPU lacks something the scene needs.
    #[error("GPU {device}: {problem}")]
    Gpu {
        /// Adapter name.
        device: String,
        /// What is lacking or went wrong, and the remedy.
        problem: String,
    },
}
