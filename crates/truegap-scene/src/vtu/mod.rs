//! Meshes with fields as `.vtu` files (VTK XML unstructured grid) for ParaView and everything else that reads VTK.
//!
//! Sections keep their plane: x = r, y = z, and the third direction is θ. Numbers are stored as base64 of 64-bit floats, so
//! nothing is rounded. Texts are written as numbers, since meshio refuses a file with text arrays. Not written: time series,
//! polyhedra, compression.
//!
//! ```
//! use truegap_scene::vtu::{Cells, Data, Grid};
//!
//! let file = Grid::new(vec![[0.0, 0.0], [1e-3, 0.0], [0.0, 1e-3]], Cells::Triangles(vec![[0, 1, 2]]))
//!     .on_points("temperature (K)", Data::Scalar(vec![300.0, 301.0, 299.5]))
//!     .to_vtu()?;
//! assert!(file.contains("NumberOfPoints=\"3\""));
//! # Ok::<(), truegap_scene::vtu::VtuError>(())
//! ```

mod error;
mod grid;
mod write;

pub use error::VtuError;
pub use grid::{Cells, Data, Grid};
