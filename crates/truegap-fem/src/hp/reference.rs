//! Integrals of products of shapes over the reference triangle, from which the matrices of straight triangles are sums.
//!
//! On a straight triangle the derivatives of coordinates are constant and the weight 2 pi r is linear, so that every integral of a form
//! without division by r is a fixed combination of integrals that are known beforehand.

use super::shapes::{Jet, count, shapes};
use crate::mesh::Point;
use crate::space::{QuadraturePoint, triangle_rule};
use crate::symmetry::Symmetry;

/// The integrals for shapes up to a degree.
#[derive(Debug)]
pub(crate) struct Reference {
    count: usize,
    /// Of `l_c d_a N_i d_b N_j`, by corner c and by (a, b) = (0, 0), (0, 1), (1, 1).
    slopes: [[Vec<f64>; 3]; 3],
    /// Of `d_a N_i N_j`.
    mixed: [Vec<f64>; 2],
    /// For what divides by r: points of a finer rule, and the shapes there.
    points: Vec<(QuadraturePoint, Vec<f64>)>,
}

/// Quantities of a straight triangle: integrals of `w dN_i/dx_a dN_j/dx_b`, and in axisymmetric bodies those with 1 / r.
pub(crate) struct AffineElement<'a> {
    reference: &'a Reference,
    corners: [Point; 3],
    /// Twice the area (m^2).
    jacobian: f64,
    /// `[reference][physical]` (1/m).
    inverse: [[f64; 2]; 2],
    weights: [f64; 3],
    symmetry: Symmetry,
}

impl Reference {
    /// Integrals for shapes up to the degree `p`; those with a division by r only where `divided`.
    pub fn new(p: usize, divided: bool) -> Reference {
        let n = count(p);
        let mut slopes: [[Vec<f64>; 3]; 3] = Default::default();
        let mut mixed: [Vec<f64>; 2] = Default::default();
        slopes.iter_mut().flatten().chain(&mut mixed).for_each(|m| m.resize(n * n, 0.0));
        for q in triangle_rule(2 * p - 1) {
            let at = shapes(p, q.at);
            let corner = [1.0 - q.at[0] - q.at[1], q.at[0], q.at[1]].map(|l| l * q.weight);
            for (i, u) in at.iter().enumerate() {
                for (ab, slope) in [(0, u.slope[0]), (1, u.slope[0]), (2, u.slope[1])] {
                    let side = usize::from(ab > 0);
                    let row = i * n..(i + 1) * n;
                    let [s0, s1, s2] = &mut slopes;
                    let rows = (&mut s0[ab][row.clone()], &mut s1[ab][row.clone()], &mut s2[ab][row]);
                    for (j, v) in at.iter().enumerate() {
                        let product = slope * v.slope[side];
                        rows.0[j] += corner[0] * product;
                        rows.1[j] += corner[1] * product;
                        rows.2[j] += corner[2] * product;
                    }
                }
                if divided {
                    for (j, v) in at.iter().enumerate() {
                        (0..2).for_each(|a| mixed[a][i * n + j] += q.weight * u.slope[a] * v.value);
                    }
                }
            }
        }
        let values = |q: QuadraturePoint| (q, shapes(p, q.at).iter().map(|j: &Jet| j.value).collect());
        let points = if divided { triangle_rule(2 * p + 2).into_iter().map(values).collect() } else { Vec::new() };
        Reference { count: n, slopes, mixed, points }
    }

    /// The straight triangle of these corners (m), counter-clockwise.
    pub fn element(&self, corners: [Point; 3], symmetry: Symmetry) -> AffineElement<'_> {
        let [a, b, c] = corners;
        let d = [[b[0] - a[0], b[1] - a[1]], [c[0] - a[0], c[1] - a[1]]];
        let jacobian = d[0][0] * d[1][1] - d[0][1] * d[1][0];
        let s = 1.0 / jacobian;
        let inverse = [[d[1][1] * s, -d[1][0] * s], [-d[0][1] * s, d[0][0] * s]];
        let weights = corners.map(|p| jacobian * symmetry.weight(p[0]));
        AffineElement { reference: self, corners, jacobian, inverse, weights, symmetry }
    }
}

impl AffineElement<'_> {
    /// Integral of `w grad N_i . grad N_j` (m, planar: 1).
    pub fn gradients(&self, i: usize, j: usize) -> f64 {
        let g = &self.inverse;
        let metric = |a: usize, b: usize| g[a][0] * g[b][0] + g[a][1] * g[b][1];
        let [s00, s01, s10, s11] = self.reference_slopes(i, j);
        metric(0, 0) * s00 + metric(0, 1) * (s01 + s10) + metric(1, 1) * s11
    }

    /// Integrals of `w dN_i/dx_a dN_j/dx_b` as `[a][b]`.
    pub fn slopes(&self, i: usize, j: usize) -> [[f64; 2]; 2] {
        let g = &self.inverse;
        let [s00, s01, s10, s11] = self.reference_slopes(i, j);
        [0, 1].map(|a| {
            [0, 1].map(|b| g[0][a] * g[0][b] * s00 + g[0][a] * g[1][b] * s01 + g[1][a] * g[0][b] * s10 + g[1][a] * g[1][b] * s11)
        })
    }

    /// Integrals over reference slopes (0, 0), (0, 1), (1, 0), (1, 1).
    #[inline]
    fn reference_slopes(&self, i: usize, j: usize) -> [f64; 4] {
        let n = self.reference.count;
        let (ij, ji) = (i * n + j, j * n + i);
        let sum = |ab: usize, k: usize| (0..3).map(|c| self.weights[c] * self.reference.slopes[c][ab][k]).sum::<f64>();
        [sum(0, ij), sum(1, ij), sum(1, ji), sum(2, ij)]
    }

    /// Integrals of `(w / r) dN_i/dx_a N_j`, zero in planar bodies.
    pub fn mixed(&self, i: usize, j: usize) -> [f64; 2] {
        let k = i * self.reference.count + j;
        let factor = self.jacobian * self.symmetry.weight_slope();
        let m = [0, 1].map(|a| factor * self.reference.mixed[a][k]);
        [0, 1].map(|a| self.inverse[0][a] * m[0] + self.inverse[1][a] * m[1])
    }

    /// Integrals of `(w / r^2) N_i N_j` for the shapes of `numbers`, row by row; empty in planar bodies.
    ///
    /// Shapes that do not vanish on the axis have none: what stands there for them is finite and of no meaning.
    pub fn divided(&self, numbers: &[usize]) -> Vec<f64> {
        if self.symmetry == Symmetry::Planar {
            return Vec::new();
        }
        let n = numbers.len();
        let mut out = vec![0.0; n * n];
        let mut values = vec![0.0; n];
        for (q, shapes) in &self.reference.points {
            let r = (1.0 - q.at[0] - q.at[1]) * self.corners[0][0] + q.at[0] * self.corners[1][0] + q.at[1] * self.corners[2][0];
            let weight = q.weight * self.jacobian * self.symmetry.weight_slope() / r;
            values.iter_mut().zip(numbers).for_each(|(v, &i)| *v = shapes[i]);
            for i in 0..n {
                let scaled = weight * values[i];
                out[i * n..i * n + i + 1].iter_mut().zip(&values).for_each(|(o, v)| *o += scaled * v);
            }
        }
        for i in 0..n {
            (0..i).for_each(|j| out[j * n + i] = out[i * n + j]);
        }
        out
    }
}
