//! Gauss-Legendre points by Newton's method on the Legendre recursion.
//!
//! Limits: meant for a few dozen points; the points are computed, not tabulated.

/// A point and its weight on (0, 1).
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Point {
    /// Abscissa in (0, 1).
    pub x: f64,
    /// Weight; all weights sum to 1.
    pub weight: f64,
}

/// The `n`-point rule on (0, 1).
///
/// **Source:** Davis and Rabinowitz, Methods of Numerical Integration, 2.7: roots of P_n, weights 2 / ((1 - x^2) P_n'(x)^2).
pub fn rule(n: usize) -> Vec<Point> {
    (0..n).map(|i| point(n, i)).collect()
}

fn point(n: usize, i: usize) -> Point {
    let mut x = (std::f64::consts::PI * (i as f64 + 0.75) / (n as f64 + 0.5)).cos();
    for _ in 0..50 {
        let (p, slope) = legendre(n, x);
        let step = p / slope;
        x -= step;
        if step.abs() < 1e-16 {
            break;
        }
    }
    let (_, slope) = legendre(n, x);
    Point { x: 0.5 * (1.0 - x), weight: 1.0 / ((1.0 - x * x) * slope * slope) }
}

/// P_n(x) and its derivative.
fn legendre(n: usize, x: f64) -> (f64, f64) {
    let (mut before, mut p) = (1.0, x);
    for k in 2..=n {
        let k = k as f64;
        (before, p) = (p, ((2.0 * k - 1.0) * x * p - (k - 1.0) * before) / k);
    }
    (p, n as f64 * (x * p - before) / (x * x - 1.0))
}

#[cfg(test)]
mod tests {
    use super::*;

    /// An n-point rule is exact to degree 2n - 1; the tolerance is rounding over n terms.
    #[test]
    fn the_rule_integrates_every_power_up_to_its_degree() {
        let points = rule(7);
        for power in 0..14 {
            let sum: f64 = points.iter().map(|p| p.weight * p.x.powi(power)).sum();
            assert!((sum * f64::from(power + 1) - 1.0).abs() < 1e-14, "power {power}: {sum}");
        }
    }
}
