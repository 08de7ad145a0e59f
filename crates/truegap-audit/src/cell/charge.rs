//! The electric field in the unit cell around a bead of any profile.
//!
//! Limits: plates are flat; the side wall has no normal field, as in an endless pattern of equal cells.

use super::{
    filled::Filled,
    geometry::{Cell, Profile},
};
use crate::error::AuditError;
use truegap_core::VACUUM_PERMITTIVITY;
use truegap_fem::{
    Symmetry,
    electrostatics::{Accuracy, Conductor, Goal, Problem, Quantity, solve_adaptive},
    mesh::{Geometry, MeshOptions, Outline, Point, SizeField, mesh_geometry},
};

/// Capacitance of a cell.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Charged {
    /// F
    pub capacitance: f64,
    /// estimated magnitude of its error, F
    pub error_estimate: f64,
    /// free unknowns
    pub unknowns: usize,
}

/// Capacitance between the plates of a cell, the film below the bead.
///
/// **Accuracy:** `the_field_of_a_bead_cell_is_that_of_other_programs`.
///
/// # Errors
/// [`AuditError::Fem`] where the profile makes no mesh or the target is not reached; [`AuditError::OutOfRange`] where the bead is wider than its cell.
pub fn cell_capacitance(cell: &Cell, profile: &Profile, filled: Filled, target: f64) -> Result<Charged, AuditError> {
    let belly = profile.belly() * cell.bead;
    if belly >= cell.outer {
        let what = "radius of the squeezed bead (m)";
        return Err(AuditError::OutOfRange {
            what,
            value: belly,
            low: 0.0,
            high: cell.outer,
            remedy: "use fewer or smaller beads",
        });
    }
    let failed = "field in the bead cell";
    let drawing = drawing(cell, profile);
    let size = SizeField::uniform(0.35 * (cell.height + cell.film));
    let mut mesh = mesh_geometry(&drawing, &MeshOptions { size, ..MeshOptions::default() }).map_err(AuditError::fem(failed))?;
    let problem = problem(filled);
    let goal = Quantity { name: "C".into(), goal: Goal::Capacitance { boundary: "top".into() } };
    let accuracy = Accuracy { target, max_unknowns: 200_000, ..Accuracy::default() };
    let outcome = solve_adaptive(&problem, &[goal], &mut mesh, &accuracy).map_err(AuditError::fem(failed))?;
    let answer = &outcome.answers[0];
    Ok(Charged { capacitance: answer.value, error_estimate: answer.error_estimate, unknowns: outcome.unknowns })
}

fn problem(filled: Filled) -> Problem {
    let conductor = |boundary: &str, potential| Conductor { boundary: boundary.into(), potential };
    let regions = [("air", filled.air), ("film", filled.film), ("bead", filled.bead)];
    Problem {
        symmetry: Symmetry::Axisymmetric,
        permittivity: regions.map(|(name, e)| (name.to_owned(), VACUUM_PERMITTIVITY * e)).to_vec(),
        conductors: vec![conductor("top", 1.0), conductor("bottom", 0.0)],
        open: Vec::new(),
    }
}

fn drawing(cell: &Cell, profile: &Profile) -> Geometry {
    let top = cell.film + cell.height * (1.0 - profile.strain);
    let side = profile.points.iter().map(|p| [p[0] * cell.bead, cell.film + p[1] * cell.height]);
    let mut bead: Vec<Point> = vec![[0.0, cell.film]];
    bead.extend(side);
    bead.push([0.0, top]);
    Geometry::default()
        .region("air", Outline::rectangle([0.0, 0.0], [cell.outer, top]))
        .region("film", Outline::rectangle([0.0, 0.0], [cell.outer, cell.film]))
        .region("bead", Outline::polygon(&bead))
        .boundary("top", &[[0.0, top], [cell.outer, top]])
        .boundary("bottom", &[[0.0, 0.0], [cell.outer, 0.0]])
}
