//! From a case to its quantities, whatever its physics.

use super::description::{Case, Method, Physics};
use super::fields::SolvedCase;
use super::result::CaseResult;
use super::{elasticity, electrostatics, fields, hp};
use crate::error::FemError;

/// Solves a case.
pub fn solve_case(case: &Case) -> Result<CaseResult, FemError> {
    if case.mesh.method == Method::Hp {
        return hp::solve(case);
    }
    match case.physics {
        Physics::Electrostatics => Ok(electrostatics::solve(case)?.0),
        Physics::Elasticity => Ok(elasticity::solve(case)?.0),
    }
}

/// Solves a case and returns the last mesh with its fields as well; refuses the hp version, which keeps none.
pub fn solve_case_with_fields(case: &Case) -> Result<SolvedCase, FemError> {
    hp::check_fields(case)?;
    match case.physics {
        Physics::Electrostatics => {
            let (result, mesh, outcome) = electrostatics::solve(case)?;
            let in_triangles = fields::electric(&mesh, &outcome.potential);
            Ok(SolvedCase { result, mesh, at_nodes: outcome.potential, in_triangles })
        }
        Physics::Elasticity => {
            let (result, outcome) = elasticity::solve(case)?;
            let body = outcome.solution.body();
            let at_nodes = outcome.solution.state()[..body.displacements].to_vec();
            let in_triangles = fields::elastic(&outcome.solution);
            Ok(SolvedCase { result, mesh: body.problem.mesh.clone(), at_nodes, in_triangles })
        }
    }
}
