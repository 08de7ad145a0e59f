//! Cases with `method = "hp"`: what the hp version is given, what comes of it, and what is refused.

use super::description::{Case, Method, Physics};
use super::error::CaseError;
use super::first_mesh::mesh_case;
use super::result::{CaseResult, ErrorsFrom, MeshCounts, SecondsSpent, quantities};
use super::{elastic_outputs, elasticity, electrostatics};
use crate::error::FemError;
use crate::hp::{HpError, HpOutcome};
use std::time::Instant;

/// Refuses what is known before the drawing is meshed; then as the physics does.
pub(super) fn solve(case: &Case) -> Result<CaseResult, FemError> {
    let Some(target) = case.mesh.target_error else {
        let what = "goes on until an error is met, and max_edge alone gives none; add target_error = 1e-4 or leave method out";
        return Err(invalid(case, what.into()).into());
    };
    if let Some(c) = case.conditions.iter().find(|c| c.plate.is_some()) {
        let error = HpError::Load { place: format!("boundary `{}`", c.boundary), load: "a plate" };
        return Err(refused(case, error.into()));
    }
    let begin = Instant::now();
    let found = match case.physics {
        Physics::Electrostatics => {
            let problem = electrostatics::problem(case)?;
            let quantities = case.outputs.iter().map(|o| electrostatics::quantity(case, o)).collect::<Result<Vec<_>, _>>()?;
            let mesh = mesh_case(case)?;
            let meshing = begin.elapsed().as_secs_f64();
            crate::electrostatics::solve_hp(&problem, &quantities, &mesh, target).map(|outcome| result(&outcome, meshing))
        }
        Physics::Elasticity => {
            let quantities = case.outputs.iter().map(|o| elastic_outputs::quantity(case, o)).collect::<Result<Vec<_>, _>>()?;
            let problem = elasticity::problem(case, mesh_case(case)?)?;
            elasticity::check_following(case, &problem)?;
            let meshing = begin.elapsed().as_secs_f64();
            crate::elasticity::solve_hp(&problem, &quantities, target).map(|outcome| result(&outcome, meshing))
        }
    };
    found.map_err(|error| refused(case, error))
}

/// Refuses the fields of a case that is solved without any.
pub(super) fn check_fields(case: &Case) -> Result<(), CaseError> {
    if case.mesh.method == Method::Refine {
        return Ok(());
    }
    let what = "the hp version gives quantities and keeps neither field nor refined mesh; leave method out where these are to be \
                written, or ask `truegap solve` for the quantities";
    Err(invalid(case, what.into()))
}

fn result(outcome: &HpOutcome, meshing: f64) -> CaseResult {
    let seconds = outcome.seconds;
    CaseResult {
        method: Method::Hp,
        errors: ErrorsFrom::Spaces,
        quantities: quantities(&outcome.answers),
        pressures: Vec::new(),
        mesh: MeshCounts { triangles: outcome.triangles, unknowns: outcome.unknowns },
        seconds: SecondsSpent { mesh: meshing + seconds.mesh, assemble: seconds.assemble, solve: seconds.solve },
    }
}

/// What the hp version leaves to the other method, with the key that asked for it and what to do.
fn refused(case: &Case, error: FemError) -> FemError {
    let FemError::Hp(error) = error else { return error };
    let first = match error {
        HpError::NotReached { .. } => "raise target_error, or ",
        HpError::FirstMesh { .. } if case.mesh.max_edge.is_some() => "raise max_edge, or ",
        HpError::Touching { .. } => "give one conductor one name, or ",
        _ => "",
    };
    invalid(case, format!("{error}; {first}leave method out: quadratic elements are refined then")).into()
}

fn invalid(case: &Case, what: String) -> CaseError {
    CaseError::Invalid { file: case.file.clone(), place: "mesh, method = \"hp\"".into(), what }
}
