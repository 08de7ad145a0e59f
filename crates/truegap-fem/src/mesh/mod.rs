//! Triangle meshes: drawn outlines in, graded triangulations with named regions and boundaries out.
//!
//! Two dimensions, triangles only; edges on arcs know their circle, so that quadratic elements follow it.

mod arrangement;
mod bisect;
mod check;
mod constrained;
mod curve;
mod error;
mod estimate;
mod grid;
mod inside;
mod label;
mod mark;
#[expect(clippy::module_inception, reason = "the type and its module share the word")]
mod mesh;
mod options;
mod outline;
pub mod plane;
mod size;
mod topology;
mod triangulate;

pub(crate) use bisect::bisect_repeatedly;
pub use bisect::{bisect, longest_edge_first};
pub use curve::Circle;
pub use error::MeshError;
pub use grid::{Layer, layered_grid};
pub use mark::mark_largest;
pub use mesh::{BoundaryEdge, CurvedEdge, Mesh, Quality};
pub use options::MeshOptions;
pub use outline::{Boundary, BoundaryPath, Geometry, Outline, Region, Step};
pub use plane::Point;
pub use size::{SizeField, SizeSource};
pub use topology::{NONE, Topology};
pub use triangulate::mesh_geometry;
