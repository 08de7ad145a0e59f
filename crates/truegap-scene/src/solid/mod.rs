//! Axisymmetric layers turned into closed surfaces: full solids or solids with a wedge cut out, at rest and deformed.
//!
//! Input is a triangulated section in (r, z), metres. Only what can be seen is made: the turned outline and the two cut
//! faces. Creases of more than 40 degrees stay sharp. Planar (extruded) sections are not made here.

mod boundary;
mod error;
mod layer;
mod profile;
mod revolve;
mod sweep;

pub use error::SolidError;
pub use layer::Layer;
pub use revolve::{Shape, Surface, revolve};
pub use sweep::Sweep;
