//! Displacements that run around the axis as harmonics, on the axisymmetric mesh.
//!
//! $$ u = (u_r \cos n\theta,\; u_z \cos n\theta,\; u_\theta \sin n\theta) $$
//!
//! Linearised about an axisymmetric state: waves of different `n` do not mix.

use super::kinematics::{R, T, Z};
use super::laws::Tensor;
use crate::space::Shape;

/// Gradient of the harmonic displacement `shape` in direction `component` (0 = r, 1 = z, 2 = theta).
///
/// The entries (r, theta), (z, theta), (theta, r), (theta, z) go with `sin n theta`, the others with `cos n theta`.
///
/// $$ H_{r\theta} = -(n u_r + u_\theta) / r, \quad H_{z\theta} = -n u_z / r, \quad
///    H_{\theta\theta} = (n u_\theta + u_r) / r $$
///
/// **Source:** gradient of a vector in cylindrical coordinates, e.g. Holzapfel, Nonlinear Solid Mechanics, section 1.8.
#[inline]
pub(crate) fn harmonic_gradient(n: u32, r: f64, shape: Shape, component: usize) -> Tensor {
    let (over_r, n) = (shape.value / r, f64::from(n));
    let mut h = Tensor::zeros();
    h[(component, R)] = shape.gradient[0];
    h[(component, Z)] = shape.gradient[1];
    match component {
        R => {
            h[(R, T)] = -n * over_r;
            h[(T, T)] = over_r;
        }
        Z => h[(Z, T)] = -n * over_r,
        _ => {
            h[(R, T)] = -over_r;
            h[(T, T)] = n * over_r;
        }
    }
    h
}

/// Integral of `cos^2` (and `sin^2`) of `n theta` around the axis, over `2 pi`.
#[inline]
pub(crate) fn share_of_circle(n: u32) -> f64 {
    if n == 0 { 1.0 } else { 0.5 }
}

#[cfg(test)]
mod tests {
    use super::*;

    /// Gradient by differences in Cartesian coordinates, turned into the cylindrical basis.
    fn by_differences(n: u32, amplitude: impl Fn(f64, f64) -> [f64; 3], at: [f64; 3]) -> Tensor {
        let field = |x: [f64; 3]| {
            let (r, t) = (x[0].hypot(x[1]), x[1].atan2(x[0]));
            let a = amplitude(r, x[2]);
            let (c, s) = ((f64::from(n) * t).cos(), (f64::from(n) * t).sin());
            let (ur, uz, ut) = (a[0] * c, a[1] * c, a[2] * s);
            [ur * t.cos() - ut * t.sin(), ur * t.sin() + ut * t.cos(), uz]
        };
        let [r, z, t] = at;
        let x = [r * t.cos(), r * t.sin(), z];
        // Cylindrical basis vectors in the order (r, z, theta).
        let basis = [[t.cos(), t.sin(), 0.0], [0.0, 0.0, 1.0], [-t.sin(), t.cos(), 0.0]];
        let step = 1e-5;
        Tensor::from_fn(|i, j| {
            let shifted = |s: f64| field([0, 1, 2].map(|k| x[k] + s * step * basis[j][k]));
            let (p, m) = (shifted(1.0), shifted(-1.0));
            (0..3).map(|k| basis[i][k] * (p[k] - m[k]) / (2.0 * step)).sum()
        })
    }

    #[test]
    fn a_wave_has_the_mean_square_of_its_cosine() {
        for n in [0, 2, 3, 7] {
            // The trapezoidal rule is exact for trigonometric polynomials below half of its points; rounding remains.
            let square = |k: u32| (f64::from(n) * f64::from(k) * std::f64::consts::TAU / 64.0).cos().powi(2);
            let mean = (0..64).map(square).sum::<f64>() / 64.0;
            assert!((share_of_circle(n) - mean).abs() < 1e-14, "n {n}");
        }
    }

    #[test]
    fn the_gradient_is_that_of_the_field_in_space() {
        for n in [0, 2, 3] {
            for component in [R, Z, T] {
                let amplitude = |r: f64, z: f64| {
                    let mut a = [0.0; 3];
                    a[component] = r * r * (1.0 + 2.0 * z);
                    a
                };
                let (r, z, t) = (1.3, 0.4, 0.7);
                let shape = Shape { value: r * r * 1.8, gradient: [2.0 * r * 1.8, 2.0 * r * r] };
                let h = harmonic_gradient(n, r, shape, component);
                let (c, s) = ((f64::from(n) * t).cos(), (f64::from(n) * t).sin());
                let turned = Tensor::from_fn(|i, j| h[(i, j)] * if (i == T) == (j == T) { c } else { s });
                // The theta row and column other than the corner go with sin.
                let exact = by_differences(n, amplitude, [r, z, t]);
                // Differences: step^2 and rounding / step, both about 1e-10.
                assert!((turned - exact).norm() < 1e-8, "n {n}, component {component}: {turned} {exact}");
            }
        }
    }
}
