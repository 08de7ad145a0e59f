//! Strain and stress in the middle of a triangle, from the displacements of that triangle alone.
//!
//! For pictures of a whole body: no fit to neighbours (see `recovery`), so less accurate by one order and exact at no edge.

use super::element::material;
use super::kinematics::displacement_gradient;
use super::laws::Tensor;
use super::material::Formulation;
use super::solution::{Components, Solution};
use crate::space::{Order, P1, P2, PointMap, Shape};

const MIDDLE: [f64; 2] = [1.0 / 3.0; 2];

impl Solution {
    /// Total strain (as [`Solution::strain_at`]) and Cauchy stress (Pa) in the middle of a triangle.
    pub fn in_middle(&self, triangle: usize) -> (Components, Components) {
        let map = self.body().nodes.element(triangle).map_at(MIDDLE);
        let h = self.gradient_of(triangle, &map);
        let pressure = self.pressure_of(triangle);
        let tensor = |stress| self.tensor(triangle, map.at, &h, pressure, stress);
        (tensor(false), tensor(true))
    }

    fn gradient_of(&self, triangle: usize, map: &PointMap) -> Tensor {
        let problem = &self.body().problem;
        let shapes: Vec<Shape> = match problem.order {
            Order::Linear => shapes(map, P1::at(MIDDLE)).into(),
            Order::Quadratic => shapes(map, P2::at(MIDDLE)).into(),
        };
        let of = self.body().dofs.of(triangle);
        let local: Vec<f64> = of[..2 * shapes.len()].iter().map(|&d| self.state()[d as usize]).collect();
        displacement_gradient(problem.symmetry, map.at[0], &shapes, &local)
    }

    /// Mean of the three pressures of a mixed element.
    fn pressure_of(&self, triangle: usize) -> Option<f64> {
        let body = self.body();
        let mixed = material(body, triangle).formulation == Formulation::Mixed;
        let inner = 2 * body.problem.order.nodes();
        let sum = || body.dofs.of(triangle)[inner..inner + 3].iter().map(|&d| self.state()[d as usize]).sum::<f64>();
        mixed.then(|| sum() / 3.0)
    }
}

fn shapes<const N: usize>(map: &PointMap, (value, slope): ([f64; N], [[f64; 2]; N])) -> [Shape; N] {
    std::array::from_fn(|i| Shape { value: value[i], gradient: map.gradient(slope[i]) })
}
