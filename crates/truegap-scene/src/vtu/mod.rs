//! Meshes with fields as `.vtu` files (VTK XML unstructured grid) for ParaView and everything else that reads VTK.
//!
//! Sections keep their plane: x = r, y = z, and the third direction is θ. Numbers are stored as base64 of 64-bit floats, so
//! nothing is rounded. Not written: time series, polyhedra, compression.

mod error;
mod grid;
mod write;

pub use error::VtuError;
pub use grid::{Cells, Data, Grid};
