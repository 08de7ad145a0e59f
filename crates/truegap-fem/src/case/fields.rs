//! What a solved case holds at every node and in every triangle of its last mesh.

use super::result::CaseResult;
use crate::elasticity::{Components, Solution};
use crate::mesh::{Mesh, Topology};
use crate::space::{Nodes, P2};

/// A solved case with its fields.
#[derive(Debug, Clone)]
pub struct SolvedCase {
    /// The quantities that it asked for.
    pub result: CaseResult,
    /// The last mesh.
    pub mesh: Mesh,
    /// At its quadratic nodes: the potential (V) in electrostatics, the displacement (m, `2 node + component`) in elasticity.
    pub at_nodes: Vec<f64>,
    /// In the middle of its triangles.
    pub in_triangles: InTriangles,
}

/// Values in the middle of each triangle.
#[derive(Debug, Clone, PartialEq)]
pub enum InTriangles {
    /// The electric field (V/m) along r and z (or x and y).
    Electric(Vec<[f64; 2]>),
    /// Total strain (1) and Cauchy stress (Pa).
    Elastic {
        /// small strain in linear materials, Green strain in the others
        strain: Vec<Components>,
        /// force on the deformed area
        stress: Vec<Components>,
    },
}

/// E = -grad(potential) in the middle of each triangle, V/m.
pub(super) fn electric(mesh: &Mesh, potential: &[f64]) -> InTriangles {
    let nodes = Nodes::new(mesh, &Topology::new(mesh));
    let middle = [1.0 / 3.0; 2];
    let (_, slopes) = P2::at(middle);
    let field = |t: usize| {
        let map = nodes.element(t).map_at(middle);
        nodes.triangles[t].iter().zip(slopes).fold([0.0; 2], |e, (&node, slope)| {
            let (g, u) = (map.gradient(slope), potential[node as usize]);
            [e[0] - u * g[0], e[1] - u * g[1]]
        })
    };
    InTriangles::Electric((0..mesh.triangles.len()).map(field).collect())
}

/// Strain and stress of a solution in the middle of each triangle.
pub(super) fn elastic(solution: &Solution) -> InTriangles {
    let triangles = solution.body().problem.mesh.triangles.len();
    let (strain, stress) = (0..triangles).map(|t| solution.in_middle(t)).unzip();
    InTriangles::Elastic { strain, stress }
}
