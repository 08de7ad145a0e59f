//! Mesh files: gmsh `.msh` 4.1 (ASCII) in and out, `.vtu` out.
//!
//! ```
//! use truegap_fem::io::{read_msh, write_msh};
//! use truegap_fem::mesh::{Layer, layered_grid};
//!
//! let film = Layer { name: "film".into(), thickness: 25e-6, rows: 2 };
//! let mesh = layered_grid(&[0.0, 1e-3, 2e-3], 0.0, &[film])?;
//! let mut file = Vec::new();
//! write_msh(&mut file, &mesh)?;
//! let back = read_msh(&String::from_utf8(file)?, "film.msh")?;
//! assert_eq!(back.triangles.len(), 8);
//! assert_eq!(back.region_names, ["film"]);
//! # Ok::<(), Box<dyn std::error::Error>>(())
//! ```

mod msh_read;
mod msh_write;
mod vtu;

pub use msh_read::read_msh;
pub use msh_write::write_msh;
pub use vtu::{Field, write_vtu};
