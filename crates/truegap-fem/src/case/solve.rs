//! From a case to its quantities, whatever its physics.

use super::description::{Case, Physics};
use super::result::CaseResult;
use super::{elasticity, electrostatics};
use crate::error::FemError;
use crate::mesh::Mesh;

/// Solves a case.
pub fn solve_case(case: &Case) -> Result<CaseResult, FemError> {
    match case.physics {
        Physics::Electrostatics => Ok(electrostatics::solve(case)?.0),
        Physics::Elasticity => Ok(elasticity::solve(case)?.0),
    }
}

/// Solves a case and returns the last mesh as well, with the potential (V) at its quadratic nodes in
/// electrostatics, the displacement (m, `2 node + component`) in elasticity.
pub fn solve_case_with_fields(case: &Case) -> Result<(CaseResult, Mesh, Vec<f64>), FemError> {
    match case.physics {
        Physics::Electrostatics => {
            let (result, mesh, outcome) = electrostatics::solve(case)?;
            Ok((result, mesh, outcome.potential))
        }
        Physics::Elasticity => {
            let (result, outcome) = elasticity::solve(case)?;
            let body = outcome.solution.body();
            let displacement = outcome.solution.state()[..body.displacements].to_vec();
            Ok((result, body.problem.mesh.clone(), displacement))
        }
    }
}
