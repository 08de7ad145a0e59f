//! A stack of layers as a binary glTF 2.0 file: named parts, colours by field, the deformation as morph targets.
//!
//! One mesh coordinate is a millimetre and the root node scales by 0.001, so that the file is in metres as glTF asks and
//! single precision and viewers' clipping planes get numbers near one. Colours do not change with the morph: the field
//! belongs to the deformed state. Not written: textures, compression (Blender and trimesh cannot read it).

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
