//! A stack of layers as a binary glTF 2.0 file: named parts, colours by field, the deformation as morph targets.
//!
//! One mesh coordinate is a millimetre and the root node scales by 0.001, so that the file is in metres as glTF asks and
//! single precision and viewers' clipping planes get numbers near one. Colours do not change with the morph: the field
//! belongs to the deformed state. Not written: textures, compression (Blender and trimesh cannot read it).
//!
//! ```
//! use truegap_scene::colour::Rgb;
//! use truegap_scene::glb::{Provenance, Scene};
//! use truegap_scene::solid::{Layer, Sweep};
//!
//! // A ring of 3 to 5 mm radius and 1 mm height: two triangles of its section.
//! let ring = Layer {
//!     name: "copper ring".into(),
//!     colour: Rgb::hex(0xB87333),
//!     points: vec![[3e-3, 0.0], [5e-3, 0.0], [5e-3, 1e-3], [3e-3, 1e-3]],
//!     triangles: vec![[0, 1, 2], [0, 2, 3]],
//!     displacement: vec![],
//!     fields: vec![],
//! };
//! let scene = Scene {
//!     title: "ring".into(),
//!     layers: vec![ring],
//!     fields: vec![],
//!     sweep: Sweep::CUT_AWAY,
//!     exaggeration: None,
//!     provenance: Provenance::default(),
//! };
//! let bytes = scene.to_glb()?;
//! assert_eq!(&bytes[..4], b"glTF");
//! # Ok::<(), truegap_scene::glb::SceneError>(())
//! ```

mod accessors;
mod animation;
mod document;
mod error;
mod extras;
mod field;
mod scene;
mod view;

pub use error::SceneError;
pub use field::Field;
pub use scene::{Provenance, Scene, suggested_exaggeration};
