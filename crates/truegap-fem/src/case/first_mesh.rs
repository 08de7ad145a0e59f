//! The mesh that a case starts from.

use super::description::Case;
use crate::error::FemError;
use crate::mesh::{Mesh, MeshOptions, SizeField, mesh_geometry};

/// The first mesh of a case: as coarse as the drawing and `max_edge` allow; adaptive cases refine it while solving.
pub fn mesh_case(case: &Case) -> Result<Mesh, FemError> {
    let max_edge = case.mesh.max_edge.unwrap_or(f64::INFINITY);
    // A quadratic arc of the angle a misses a^4 / 480 of the area: a tenth of the target, 10 degrees at most.
    let arc = case.mesh.target_error.map_or(10.0, |t| (48.0 * t).powf(0.25).to_degrees().clamp(0.5, 10.0));
    let options =
        MeshOptions { size: SizeField { max_edge, ..SizeField::default() }, arc_step_degrees: arc, ..MeshOptions::default() };
    Ok(mesh_geometry(&case.geometry, &options)?)
}
