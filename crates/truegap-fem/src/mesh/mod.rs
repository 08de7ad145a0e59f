//! Triangle meshes: drawn outlines in, graded triangulations with named regions and boundaries out.
//!
//! Two dimensions, triangles only; edges on arcs know their circle, so that quadratic elements follow it.

mod arrangement;
mod curve;
mod error;
mod grid;
mod label;
#[expect(clippy::module_inception, reason = "the type and its module share the word")]
mod mesh;
mod outline;
pub mod plane;
mod size;
mod topology;
mod triangulate;

pub use curve::{Circle, Curve};
pub use error::MeshError;
pub use grid::{Layer, layered_grid};
pub use mesh::{BoundaryEdge, CurvedEdge, Mesh, Quality};
pub use outline::{Boundary, BoundaryPath, Geometry, Outline, Region, Step};
pub use plane::Point;
pub use size::{SizeField, SizeSource};
pub use topology::{NONE, Topology};
pub use triangulate::{MeshOptions, mesh_geometry};
