//! Quadrature on the reference triangle and the unit interval.
//!
//! Symmetric rules up to degree 6, products of Gauss rules (in Duffy coordinates) above.

/// A point of the reference triangle and its weight.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct QuadraturePoint {
    /// Reference coordinates.
    pub at: [f64; 2],
    /// Weight; the weights of a rule sum to 1/2.
    pub weight: f64,
}

/// A rule that integrates polynomials up to `degree` exactly on the reference triangle.
///
/// **Source:** closed forms of degree 1, 2, 4, 5 (Strang & Fix 1973; Dunavant 1985), digits of degree 6 from Dunavant;
/// `rules_are_exact_to_their_degree` pins all of them.
pub fn triangle_rule(degree: usize) -> Vec<QuadraturePoint> {
    match degree {
        0 | 1 => vec![QuadraturePoint { at: [1.0 / 3.0; 2], weight: 0.5 }],
        2 => orbit(1.0 / 6.0, 1.0 / 3.0),
        3 | 4 => degree_four(),
        5 => degree_five(),
        6 => degree_six(),
        _ => product_rule(degree),
    }
}

/// The three points with barycentric coordinates (a, a, 1 - 2a); `weight` is relative to the area.
fn orbit(a: f64, weight: f64) -> Vec<QuadraturePoint> {
    let b = 1.0 - 2.0 * a;
    [[a, a], [a, b], [b, a]].map(|at| QuadraturePoint { at, weight: 0.5 * weight }).to_vec()
}

fn degree_four() -> Vec<QuadraturePoint> {
    let root = (38.0 - 44.0 * 0.4f64.sqrt()).sqrt();
    let spread = (213125.0 - 53320.0 * 10f64.sqrt()).sqrt();
    let base = 8.0 - 10f64.sqrt();
    let mut rule = orbit((base + root) / 18.0, (620.0 + spread) / 3720.0);
    rule.extend(orbit((base - root) / 18.0, (620.0 - spread) / 3720.0));
    rule
}

fn degree_five() -> Vec<QuadraturePoint> {
    let s = 15f64.sqrt();
    let mut rule = vec![QuadraturePoint { at: [1.0 / 3.0; 2], weight: 0.1125 }];
    rule.extend(orbit((6.0 + s) / 21.0, (155.0 + s) / 1200.0));
    rule.extend(orbit((6.0 - s) / 21.0, (155.0 - s) / 1200.0));
    rule
}

fn degree_six() -> Vec<QuadraturePoint> {
    let mut rule = orbit(0.063_089_014_491_502_23, 0.050_844_906_370_206_82);
    rule.extend(orbit(0.249_286_745_170_910_42, 0.116_786_275_726_379_37));
    let (a, b) = (0.053_145_049_844_816_95, 0.310_352_451_033_784_4);
    let c = 1.0 - a - b;
    let weight = 0.5 * 0.082_851_075_618_373_58;
    rule.extend([[a, b], [b, a], [a, c], [c, a], [b, c], [c, b]].map(|at| QuadraturePoint { at, weight }));
    rule
}

fn product_rule(degree: usize) -> Vec<QuadraturePoint> {
    let line = edge_rule(degree + 1);
    let mut rule = Vec::with_capacity(line.len() * line.len());
    for &(u, wu) in &line {
        for &(v, wv) in &line {
            rule.push(QuadraturePoint { at: [u, v * (1.0 - u)], weight: wu * wv * (1.0 - u) });
        }
    }
    rule
}

/// Gauss points and weights on [0, 1], exact up to `degree`; the weights sum to 1.
pub(crate) fn edge_rule(degree: usize) -> Vec<(f64, f64)> {
    let n = degree / 2 + 1;
    (0..n)
        .map(|i| {
            let mut x = (std::f64::consts::PI * (i as f64 + 0.75) / (n as f64 + 0.5)).cos();
            let mut slope = 1.0;
            // Newton's method on the Legendre polynomial; six steps double 1e-3 to rounding with room to spare.
            for _ in 0..8 {
                let (p, d) = legendre(n, x);
                x -= p / d;
                slope = legendre(n, x).1;
            }
            (0.5 * (1.0 - x), 1.0 / ((1.0 - x * x) * slope * slope))
        })
        .collect()
}

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

    fn factorial(n: usize) -> f64 {
        (1..=n).map(|k| k as f64).product()
    }

    #[test]
    fn rules_are_exact_to_their_degree() {
        // Integral of x^i y^j over the triangle = i! j! / (i + j + 2)!; tolerance: digits of the degree-6 rule.
        for degree in 0..=12 {
            for i in 0..=degree {
                for j in 0..=degree - i {
                    let exact = factorial(i) * factorial(j) / factorial(i + j + 2);
                    let sum: f64 =
                        triangle_rule(degree).iter().map(|q| q.weight * q.at[0].powi(i as i32) * q.at[1].powi(j as i32)).sum();
                    assert!((sum - exact).abs() < 3e-15, "degree {degree}, x^{i} y^{j}: {sum} against {exact}");
                }
            }
        }
    }

    #[test]
    fn gauss_points_integrate_powers() {
        for degree in 0..=15 {
            for k in 0..=degree {
                let sum: f64 = edge_rule(degree).iter().map(|&(t, w)| w * t.powi(k as i32)).sum();
                assert!((sum - 1.0 / (k as f64 + 1.0)).abs() < 1e-14, "degree {degree}, t^{k}: {sum}");
            }
        }
    }
}
