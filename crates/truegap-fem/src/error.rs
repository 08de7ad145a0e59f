//! The one error type that leaves the crate, gathering those of its parts.

use crate::algebra::SolveError;
use crate::case::CaseError;
use crate::elasticity::ElasticityError;
use crate::electrostatics::ElectrostaticsError;
use crate::hp::HpError;
use crate::mesh::MeshError;

/// Anything that can go wrong between a description and its numbers.
#[derive(Debug, Clone, PartialEq, thiserror::Error)]
#[non_exhaustive]
pub enum FemError {
    /// The geometry or the mesh is not usable.
    #[error(transparent)]
    Mesh(#[from] MeshError),
    /// The linear algebra failed.
    #[error(transparent)]
    Solve(#[from] SolveError),
    /// The electrostatic problem is not well posed.
    #[error(transparent)]
    Electrostatics(#[from] ElectrostaticsError),
    /// The hp version does not take the problem.
    #[error("{0}; solve it by the refinement of quadratic elements")]
    Hp(#[from] HpError),
    /// The case file is not usable.
    #[error(transparent)]
    Case(#[from] CaseError),
    /// An elastic problem failed.
    #[error(transparent)]
    Elasticity(#[from] ElasticityError),
}
