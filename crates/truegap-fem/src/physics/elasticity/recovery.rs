//! Gradients at a point from a cubic fitted to the displacements of the nodes around it.
//!
//! Polynomial-preserving recovery: one order better than the gradient of the quadratic shapes, also at the edge of the
//! body. The fit never crosses from one region to another. At a singular corner there is no limit to converge to.

use super::body::Body;
use super::problem::Order;
use crate::mesh::Point;
use crate::space::P1;
use nalgebra::{DMatrix, DVector};

/// Value and gradient of a fitted polynomial.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(crate) struct Fitted {
    pub value: f64,
    pub gradient: [f64; 2],
}

/// The nodes around a point.
pub(crate) struct Patch {
    at: Point,
    element: usize,
    nodes: Vec<usize>,
    /// Distance of the farthest node (m).
    pub reach: f64,
}

/// Terms of a cubic in two variables.
const CUBIC: usize = 10;
/// Terms of a quadratic.
const QUADRATIC: usize = 6;

impl Patch {
    /// Collects the nodes of the elements of the same region that touch `element`, and more while they do not
    /// determine a cubic.
    pub(crate) fn around(body: &Body, element: usize, at: Point) -> Patch {
        let mesh = &body.problem.mesh;
        let region = mesh.triangle_regions[element];
        let mut corners: Vec<u32> = mesh.triangles[element].to_vec();
        let mut patch = Patch { at, element, nodes: Vec::new(), reach: 0.0 };
        for _ in 0..4 {
            let elements: Vec<usize> = (0..mesh.triangles.len())
                .filter(|&t| mesh.triangle_regions[t] == region)
                .filter(|&t| mesh.triangles[t].iter().any(|c| corners.contains(c)))
                .collect();
            patch.nodes = elements
                .iter()
                .flat_map(|&t| &body.nodes.triangles[t][..body.problem.order.nodes()])
                .map(|&n| n as usize)
                .collect();
            patch.nodes.sort_unstable();
            patch.nodes.dedup();
            if patch.nodes.len() >= 3 * CUBIC {
                break;
            }
            corners = elements.iter().flat_map(|&t| mesh.triangles[t]).collect();
            corners.sort_unstable();
            corners.dedup();
        }
        let points = &body.nodes.points;
        let away = |n: &usize| (points[*n][0] - at[0]).hypot(points[*n][1] - at[1]);
        patch.reach = patch.nodes.iter().map(away).fold(0.0, f64::max);
        patch
    }

    /// Least-squares polynomial through `value(node)`: cubic, or quadratic for linear elements.
    pub(crate) fn fit(&self, body: &Body, value: impl Fn(usize) -> f64) -> Fitted {
        let terms = match body.problem.order {
            Order::Linear => QUADRATIC,
            Order::Quadratic if self.nodes.len() < CUBIC => QUADRATIC,
            Order::Quadratic => CUBIC,
        };
        let spread = [0, 1]
            .map(|k| self.nodes.iter().map(|&n| (body.nodes.points[n][k] - self.at[k]).abs()).fold(f64::MIN_POSITIVE, f64::max));
        let rows: Vec<[f64; CUBIC]> = self
            .nodes
            .iter()
            .map(|&n| {
                let p = body.nodes.points[n];
                monomials((p[0] - self.at[0]) / spread[0], (p[1] - self.at[1]) / spread[1])
            })
            .collect();
        let a = DMatrix::from_fn(rows.len(), terms, |i, j| rows[i][j]);
        let b = DVector::from_iterator(rows.len(), self.nodes.iter().map(|&n| value(n)));
        let x = a.svd(true, true).solve(&b, 1e-12).unwrap_or(DVector::from_element(terms, f64::NAN));
        Fitted { value: x[0], gradient: [x[1] / spread[0], x[2] / spread[1]] }
    }

    /// Pressure unknown at the point (Pa).
    pub(crate) fn pressure(&self, body: &Body, state: &[f64]) -> f64 {
        let of = body.dofs.of(self.element);
        let reference = body.nodes.element(self.element).locate(self.at, 1.0).unwrap_or([1.0 / 3.0; 2]);
        let value = P1::at(reference).0;
        (0..3).map(|i| value[i] * state[of[12 + i] as usize]).sum()
    }
}

fn monomials(x: f64, y: f64) -> [f64; CUBIC] {
    [1.0, x, y, x * x, x * y, y * y, x * x * x, x * x * y, x * y * y, y * y * y]
}

/// Element of a region (of any, if none is named) that holds a point, and the reference coordinates there.
pub(crate) fn locate(body: &Body, at: Point, region: Option<&str>) -> Option<(usize, [f64; 2])> {
    const SLACK: f64 = 1e-9;
    let mesh = &body.problem.mesh;
    (0..mesh.triangles.len())
        .filter(|&t| region.is_none_or(|r| mesh.region_names[mesh.triangle_regions[t] as usize] == r))
        .filter(|&t| near(&body.nodes.element(t).nodes, at))
        .find_map(|t| Some((t, body.nodes.element(t).locate(at, SLACK)?)))
}

/// Whether a point lies in the box around an element, widened by a tenth.
fn near(nodes: &[Point; 6], at: Point) -> bool {
    (0..2).all(|k| {
        let low = nodes.iter().map(|p| p[k]).fold(f64::INFINITY, f64::min);
        let high = nodes.iter().map(|p| p[k]).fold(f64::NEG_INFINITY, f64::max);
        let slack = 0.1 * (high - low);
        at[k] >= low - slack && at[k] <= high + slack
    })
}
