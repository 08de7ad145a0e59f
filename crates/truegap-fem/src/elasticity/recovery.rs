//! Gradients at a point from a cubic fitted to the displacements of the nodes around it.
//!
//! Polynomial-preserving recovery: one order better than the gradient of the quadratic shapes, also at the edge of the
//! body. The fit never crosses from one region to another. At a singular corner there is no limit to converge to.

use super::body::Body;
use crate::mesh::Point;
use crate::space::{Order, P1};
use nalgebra::{DMatrix, DVector};

/// The nodes around a point.
pub(crate) struct Patch {
    at: Point,
    element: usize,
    nodes: Vec<usize>,
    /// Distance of the farthest node (m).
    pub reach: f64,
}

/// Terms of a quartic in two variables.
const QUARTIC: usize = 15;
/// Terms of a cubic.
const CUBIC: usize = 10;
/// Terms of a quadratic.
const QUADRATIC: usize = 6;
/// Terms of a linear function.
const LINEAR: usize = 3;

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

    /// For every node, its weights in the fitted value and in the two derivatives: cubic, quartic if `higher`; lower
    /// where there are too few nodes, or where they lie on too few lines to tell its terms apart.
    pub(crate) fn weights(&self, body: &Body, higher: bool) -> Vec<(usize, [f64; 3])> {
        let wanted = match (body.problem.order, higher) {
            (Order::Linear, false) => QUADRATIC,
            (Order::Linear, true) | (Order::Quadratic, false) => CUBIC,
            (Order::Quadratic, true) => QUARTIC,
        };
        let terms = [wanted, CUBIC, QUADRATIC].into_iter().find(|&t| t <= wanted && self.nodes.len() >= t + 2).unwrap_or(LINEAR);
        let away = |n: usize, k: usize| body.nodes.points[n][k] - self.at[k];
        let spread = [0, 1].map(|k| self.nodes.iter().map(|&n| away(n, k).abs()).fold(f64::MIN_POSITIVE, f64::max));
        let rows: Vec<_> = self.nodes.iter().map(|&n| monomials(away(n, 0) / spread[0], away(n, 1) / spread[1])).collect();
        let kept = told_apart(&rows, terms);
        let a = DMatrix::from_fn(rows.len(), kept.len(), |i, j| rows[i][kept[j]]);
        let inverse = a.svd(true, true).pseudo_inverse(1e-12).unwrap_or(DMatrix::repeat(kept.len(), rows.len(), f64::NAN));
        let weight = |i: usize| [inverse[(0, i)], inverse[(1, i)] / spread[0], inverse[(2, i)] / spread[1]];
        self.nodes.iter().enumerate().map(|(i, &n)| (n, weight(i))).collect()
    }

    /// The pressure unknowns of the element and their weights at the point.
    pub(crate) fn pressure_weights(&self, body: &Body) -> [(usize, f64); 3] {
        let of = body.dofs.of(self.element);
        let reference = body.nodes.element(self.element).locate(self.at, 1.0).unwrap_or([1.0 / 3.0; 2]);
        let value = P1::at(reference).0;
        [0, 1, 2].map(|i| (of[12 + i] as usize, value[i]))
    }
}

/// Part of a term, over its size, that must be left beside the terms before it; rounding leaves 1e-15.
const OWN_PART: f64 = 1e-6;

/// The first `terms` monomials without those that are a combination of earlier ones at the nodes; the linear ones always stay.
///
/// On a body one element wide the nodes lie on three lines, on which x³ is x: a pseudo-inverse would give each half of the slope.
fn told_apart(rows: &[[f64; QUARTIC]], terms: usize) -> Vec<usize> {
    let mut basis: Vec<DVector<f64>> = Vec::new();
    let mut kept = Vec::new();
    for term in 0..terms {
        let mut own = DVector::from_iterator(rows.len(), rows.iter().map(|row| row[term]));
        let size = own.norm();
        // twice, since one pass of Gram-Schmidt leaves what it lost to rounding
        for direction in basis.iter().chain(&basis) {
            own -= direction * direction.dot(&own);
        }
        let left = own.norm();
        let has_own_part = left > OWN_PART * size;
        if has_own_part {
            basis.push(own / left);
        }
        if has_own_part || term < LINEAR {
            kept.push(term);
        }
    }
    kept
}

fn monomials(x: f64, y: f64) -> [f64; QUARTIC] {
    let (xx, xy, yy) = (x * x, x * y, y * y);
    [1.0, x, y, xx, xy, yy, x * xx, x * xy, y * xy, y * yy, xx * xx, xx * xy, xx * yy, xy * yy, yy * yy]
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
