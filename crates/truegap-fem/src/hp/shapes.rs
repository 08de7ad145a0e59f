//! Hierarchical shapes of any degree on the reference triangle and on the unit interval.
//!
//! Corners, then edges, then the inside: a shape of higher degree never changes those below it, so that a space of lower degree is part
//! of one of higher degree. A shape of the degree k on an edge changes its sign by (-1)^k where the edge is walked the other way.
//!
//! **Source:** Zaglmayr, High Order Finite Element Methods for Electromagnetic Field Computation (2006), sections 5.2.1 and 5.2.3.

use std::ops::{Add, Mul, Sub};

/// A value and its slopes along the two reference coordinates.
#[derive(Debug, Clone, Copy, PartialEq, Default)]
pub(super) struct Jet {
    pub value: f64,
    pub slope: [f64; 2],
}

impl Add for Jet {
    type Output = Jet;
    fn add(self, o: Jet) -> Jet {
        Jet { value: self.value + o.value, slope: [0, 1].map(|k| self.slope[k] + o.slope[k]) }
    }
}

impl Sub for Jet {
    type Output = Jet;
    fn sub(self, o: Jet) -> Jet {
        self + o * -1.0
    }
}

impl Mul for Jet {
    type Output = Jet;
    #[allow(clippy::suspicious_arithmetic_impl)] // the slope of a product is a sum
    fn mul(self, o: Jet) -> Jet {
        Jet { value: self.value * o.value, slope: [0, 1].map(|k| self.value * o.slope[k] + self.slope[k] * o.value) }
    }
}

impl Mul<f64> for Jet {
    type Output = Jet;
    fn mul(self, by: f64) -> Jet {
        Jet { value: self.value * by, slope: self.slope.map(|s| s * by) }
    }
}

/// Shapes of an element up to the degree `p`: three corners, `p - 1` on each edge, the rest inside.
pub(super) fn count(p: usize) -> usize {
    (p + 1) * (p + 2) / 2
}

/// Number of the shape of degree `k` (2 to `p`) on the local edge `edge`.
pub(super) fn on_edge(p: usize, edge: usize, k: usize) -> usize {
    3 + edge * (p - 1) + k - 2
}

/// Numbers of the inner shapes of at most the degree `d`.
pub(super) fn inside(p: usize, d: usize) -> std::ops::Range<usize> {
    let first = 3 * p;
    first..first + d.saturating_sub(1) * d.saturating_sub(2) / 2
}

/// All shapes up to the degree `p` at a point of the reference triangle; the local edge k runs from corner k to corner k + 1.
pub(super) fn shapes(p: usize, [x, y]: [f64; 2]) -> Vec<Jet> {
    let jet = |value, a, b| Jet { value, slope: [a, b] };
    let l = [jet(1.0 - x - y, -1.0, -1.0), jet(x, 1.0, 0.0), jet(y, 0.0, 1.0)];
    let mut out = Vec::with_capacity(count(p));
    out.extend(l);
    for edge in 0..3 {
        let (a, b) = (l[edge], l[(edge + 1) % 3]);
        out.extend(&integrated_legendre(p, b - a, a + b)[2..]);
    }
    // integrated Legendre polynomials along the first edge, Jacobi polynomials that are orthogonal to one another across
    let along = integrated_legendre(p, l[1] - l[0], l[0] + l[1]);
    let across: Vec<Vec<Jet>> = (0..=p).map(|i| jacobi(p, 2.0 * i as f64 - 1.0, l[2] * 2.0 - jet(1.0, 0.0, 0.0))).collect();
    for d in 3..=p {
        out.extend((2..d).map(|i| along[i] * l[2] * across[i][d - 1 - i]));
    }
    out
}

/// Shapes of an edge at `t` in [0, 1] up to the degree `p`: start, end, degree 2, ..., p; value and slope by `t`.
pub(crate) fn line_shapes(p: usize, t: f64) -> Vec<[f64; 2]> {
    let at = |value, slope| Jet { value, slope: [slope, 0.0] };
    let mut out = vec![[1.0 - t, -1.0], [t, 1.0]];
    out.extend(integrated_legendre(p, at(2.0 * t - 1.0, 2.0), at(1.0, 0.0))[2..].iter().map(|j| [j.value, j.slope[0]]));
    out
}

/// Scaled integrated Legendre polynomials `t^n L_n(x / t)` for n = 0 to `p`; the first two are 1 and x.
fn integrated_legendre(p: usize, x: Jet, t: Jet) -> Vec<Jet> {
    let mut out = vec![Jet { value: 1.0, slope: [0.0; 2] }, x, (x * x - t * t) * 0.5];
    for n in 2..p {
        let m = n as f64;
        out.push((x * out[n] * (2.0 * m - 1.0) - t * t * out[n - 1] * (m - 2.0)) * (1.0 / (m + 1.0)));
    }
    out.truncate(p.max(1) + 1);
    out
}

/// Jacobi polynomials of the weight (1 - x)^a for n = 0 to `p`.
fn jacobi(p: usize, a: f64, x: Jet) -> Vec<Jet> {
    let one = Jet { value: 1.0, slope: [0.0; 2] };
    let mut out = vec![one, x * (0.5 * (a + 2.0)) + one * (0.5 * a)];
    for n in 1..p {
        let m = n as f64;
        let s = 2.0 * m + a;
        let [c0, c1, c2] = [(s + 1.0) * a * a, (s + 1.0) * s * (s + 2.0), 2.0 * (m + a) * m * (s + 2.0)];
        let below = 1.0 / (2.0 * (m + 1.0) * (m + 1.0 + a) * s);
        let next = (out[n] * c0 + x * out[n] * c1 - out[n - 1] * c2) * below;
        out.push(next);
    }
    out
}

#[cfg(test)]
mod tests {
    use super::*;

    const P: usize = 7;

    #[test]
    fn slopes_are_those_of_the_values() {
        let (at, h) = ([0.3, 0.45], 1e-6);
        let middle = shapes(P, at);
        assert_eq!(middle.len(), count(P));
        for k in 0..2 {
            let mut ends = [at, at];
            ends[0][k] -= h;
            ends[1][k] += h;
            let [low, high] = ends.map(|p| shapes(P, p));
            for (i, j) in middle.iter().enumerate() {
                // central differences: h^2 times third derivatives of at most 1e3
                assert!((j.slope[k] - (high[i].value - low[i].value) / (2.0 * h)).abs() < 1e-7, "{i}");
            }
        }
    }

    #[test]
    fn shapes_of_an_edge_are_those_of_the_line_and_vanish_on_the_others() {
        for t in [0.2, 0.7] {
            let line = line_shapes(P, t);
            for (edge, at) in [[t, 0.0], [1.0 - t, t], [0.0, 1.0 - t]].into_iter().enumerate() {
                let found = shapes(P, at);
                for k in 2..=P {
                    assert!((found[on_edge(P, edge, k)].value - line[k][0]).abs() < 1e-14);
                    let backwards = line_shapes(P, 1.0 - t)[k][0];
                    assert!((line[k][0] - if k % 2 == 0 { backwards } else { -backwards }).abs() < 1e-14);
                    (0..3).filter(|e| *e != edge).for_each(|e| assert!(found[on_edge(P, e, k)].value.abs() < 1e-15));
                }
                assert!(found[inside(P, P)].iter().all(|j| j.value.abs() < 1e-15));
            }
        }
    }

    #[test]
    fn shapes_span_all_polynomials_of_their_degree() {
        // interpolation at as many points as there are shapes: x^i y^j comes back at another point
        let points: Vec<[f64; 2]> =
            (0..=P).flat_map(|i| (0..=P - i).map(move |j| [i as f64 / P as f64, j as f64 / P as f64])).collect();
        let n = count(P);
        let matrix = nalgebra::DMatrix::from_fn(n, n, |r, c| shapes(P, points[r])[c].value);
        let lu = matrix.lu();
        let at = [0.21, 0.34];
        for (i, j) in [(0, 0), (3, 2), (7, 0), (2, 5), (4, 3)] {
            let power = |p: [f64; 2]| p[0].powi(i) * p[1].powi(j);
            let c =
                lu.solve(&nalgebra::DVector::from_iterator(n, points.iter().map(|p| power(*p)))).expect("shapes are independent");
            let value: f64 = shapes(P, at).iter().zip(c.iter()).map(|(s, c)| s.value * c).sum();
            assert!((value - power(at)).abs() < 1e-11, "x^{i} y^{j}: {value}");
        }
    }
}
