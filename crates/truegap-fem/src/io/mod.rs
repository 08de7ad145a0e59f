//! Mesh files: gmsh `.msh` 4.1 (ASCII) in and out, `.vtu` out.

mod msh_read;
mod msh_write;
mod vtu;

pub use msh_read::read_msh;
pub use msh_write::write_msh;
pub use vtu::{Field, write_vtu};
