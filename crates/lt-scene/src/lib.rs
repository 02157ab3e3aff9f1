//! Scenes for the shadow toolkit: what is drawn, what lights it, who looks at it.
//!
//! # Idea
//! A [`Scene`] is a plain value: triangle [`Mesh`]es with one [`Material`] each, placed in the world by
//! [`Instance`]s, plus [`Light`]s and [`Camera`]s. It is *posed*: everything that moves (node animation, skins,
//! morph targets) has already been sampled at one moment. What can be posed again and again is a [`Source`]: a glTF
//! file ([`gltf::GltfAsset`]) or a procedural place ([`builtin::Builtin`]).
//!
//! # Conventions
//! Right-handed, +Y up, metres unless a file says otherwise; triangles wind counter-clockwise seen from outside;
//! texture coordinates have (0, 0) at the top left of the image, as in glTF; colours are linear RGB except texel
//! data, which is stored as the image holds it (sRGB colour, linear alpha).
//!
//! ```
//! use lt_scene::{Source, builtin::Builtin};
//! let source = Source::from(Builtin::parse("cornell").unwrap());
//! let scene = source.pose(0.0).unwrap();
//! assert!(scene.triangle_count() > 10);
//! ```

pub mod builtin;
mod camera;
mod error;
mod file;
pub mod gltf;
mod keyframes;
mod light;
mod material;
mod mesh;
mod path;
mod scene;
mod source;

pub use camera::Camera;
pub use error::SceneError;
pub use keyframes::Keyframes;
pub use light::{Light, LightKind};
pub use material::{AlphaMode, Material, Texture, TextureRef, UvTransform, Wrap};
pub use mesh::{Instance, Mesh};
pub use path::CameraPath;
pub use scene::{Bounds, Repairs, Scene};
pub use source::Source;
