//! Integrals of products of shapes over the reference triangle, from which the matrices of straight triangles are sums.
//!
//! On a straight triangle the derivatives of coordinates are constant and the weight 2 pi r is linear, so that every integral of a form
//! without division by r is a fixed combination of integrals that are known beforehand.

use super::shapes::{Jet, count, shapes};
use crate::mesh::Point;
use crate::space::{QuadraturePoint, triangle_rule};
use crate::symmetry::Symmetry;
use nalgebra::DMatrix;

/// The integrals for shapes up to a degree.
#[derive(Debug)]
pub(crate) struct Reference {
    count: usize,
    /// Of `l_c d_a N_i d_b N_j`, by (a, b) = (0, 0), (0, 1), (1, 1) and by corner c, shape by shape: what an entry needs lies together.
    slopes: Vec<[[f64; 3]; 3]>,
    /// Of `l_c` and the products that a metric multiplies, symmetric in i and j: (0, 0), (0, 1) with (1, 0), (1, 1), by corners each.
    gradients: Vec<[f64; 9]>,
    /// Of `d_a N_i N_j`.
    mixed: [Vec<f64>; 2],
    /// For what divides by r: points of a finer rule, and the shapes there, point by shape.
    points: Vec<QuadraturePoint>,
    values: DMatrix<f64>,
}

/// Quantities of a straight triangle: integrals of `w dN_i/dx_a dN_j/dx_b`, and in axisymmetric bodies those with 1 / r.
pub(crate) struct AffineElement<'a> {
    reference: &'a Reference,
    corners: [Point; 3],
    /// Twice the area (m^2).
    jacobian: f64,
    /// `[reference][physical]` (1/m).
    inverse: [[f64; 2]; 2],
    /// Factors of [`Reference::gradients`]: products of the gradients of the reference coordinates times the weights at the corners.
    metric: [f64; 9],
    weights: [f64; 3],
    symmetry: Symmetry,
}

impl Reference {
    /// Integrals for shapes up to the degree `p`; those with a division by r only where `divided`.
    pub fn new(p: usize, divided: bool) -> Reference {
        let n = count(p);
        let rule = triangle_rule(2 * p - 1);
        let at: Vec<Vec<Jet>> = rule.iter().map(|q| shapes(p, q.at)).collect();
        // shapes by points, and points by shapes with the weights
        let slope = [0, 1].map(|a| DMatrix::from_fn(n, rule.len(), |i, q| at[q][i].slope[a]));
        let weighted = |of: &dyn Fn(&Jet) -> f64, l: &dyn Fn([f64; 2]) -> f64| {
            DMatrix::from_fn(rule.len(), n, |q, i| rule[q].weight * l(rule[q].at) * of(&at[q][i]))
        };
        let corner: [&dyn Fn([f64; 2]) -> f64; 3] = [&|[x, y]| 1.0 - x - y, &|[x, _]| x, &|[_, y]| y];
        let mut slopes = vec![[[0.0; 3]; 3]; n * n];
        for b in 0..2 {
            for (c, l) in corner.iter().enumerate() {
                let right = weighted(&|j| j.slope[b], l);
                for a in 0..=b {
                    let products = &slope[a] * &right;
                    slopes.iter_mut().enumerate().for_each(|(k, s)| s[a + b][c] = products[(k / n, k % n)]);
                }
            }
        }
        let gradient = |k: usize| {
            let ([s00, s01, s11], [_, s10, _]) = (slopes[k], slopes[k % n * n + k / n]);
            std::array::from_fn(|q| [s00[q % 3], s01[q % 3] + s10[q % 3], s11[q % 3]][q / 3])
        };
        let gradients = (0..n * n).map(gradient).collect();
        if !divided {
            let (mixed, values) = ([0, 1].map(|_| vec![0.0; n * n]), DMatrix::zeros(0, n));
            return Reference { count: n, slopes, gradients, mixed, points: Vec::new(), values };
        }
        let right = weighted(&|j| j.value, &|_| 1.0);
        let mixed = slope.map(|left| (left * &right).transpose().as_slice().to_vec());
        let points = triangle_rule(2 * p + 2);
        let at: Vec<Vec<Jet>> = points.iter().map(|q| shapes(p, q.at)).collect();
        let values = DMatrix::from_fn(points.len(), n, |q, i| at[q][i].value);
        Reference { count: n, slopes, gradients, mixed, points, values }
    }

    /// The straight triangle of these corners (m), counter-clockwise.
    pub fn element(&self, corners: [Point; 3], symmetry: Symmetry) -> AffineElement<'_> {
        let [a, b, c] = corners;
        let d = [[b[0] - a[0], b[1] - a[1]], [c[0] - a[0], c[1] - a[1]]];
        let jacobian = d[0][0] * d[1][1] - d[0][1] * d[1][0];
        let s = 1.0 / jacobian;
        let inverse = [[d[1][1] * s, -d[1][0] * s], [-d[0][1] * s, d[0][0] * s]];
        let metric = [(0, 0), (0, 1), (1, 1)].map(|(a, b)| inverse[a][0] * inverse[b][0] + inverse[a][1] * inverse[b][1]);
        let weights = corners.map(|p| jacobian * symmetry.weight(p[0]));
        let metric = std::array::from_fn(|q| metric[q / 3] * weights[q % 3]);
        AffineElement { reference: self, corners, jacobian, inverse, metric, weights, symmetry }
    }
}

impl AffineElement<'_> {
    /// Integral of `w grad N_i . grad N_j` (m, planar: 1).
    #[inline]
    pub fn gradients(&self, i: usize, j: usize) -> f64 {
        let [a, b, c, d, e, f, g, h, k] = self.reference.gradients[i * self.reference.count + j];
        let m = &self.metric;
        (m[0] * a + m[1] * b + m[2] * c) + (m[3] * d + m[4] * e + m[5] * f) + (m[6] * g + m[7] * h + m[8] * k)
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
        let (n, w) = (self.reference.count, &self.weights);
        let [ij, ji] = [i * n + j, j * n + i].map(|k| &self.reference.slopes[k]);
        let sum = |s: &[f64; 3]| w[0] * s[0] + w[1] * s[1] + w[2] * s[2];
        [sum(&ij[0]), sum(&ij[1]), sum(&ji[1]), sum(&ij[2])]
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
        let [a, b, c] = self.corners.map(|p| p[0]);
        let weight = |q: &QuadraturePoint| {
            let r = (1.0 - q.at[0] - q.at[1]) * a + q.at[0] * b + q.at[1] * c;
            q.weight * self.jacobian * self.symmetry.weight_slope() / r
        };
        let weights: Vec<f64> = self.reference.points.iter().map(weight).collect();
        let values = self.reference.values.select_columns(numbers);
        let mut weighted = values.clone();
        weighted.column_iter_mut().for_each(|mut v| v.iter_mut().zip(&weights).for_each(|(v, w)| *v *= w));
        (values.transpose() * weighted).data.into()
    }
}
