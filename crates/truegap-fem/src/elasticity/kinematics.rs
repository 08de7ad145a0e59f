//! From shape functions to displacement gradients, and from stresses to the work they do on a test function.
//!
//! Directions are (r, z, theta) in axisymmetric bodies, (x, y, out of plane) in planar ones (plane strain).

use super::laws::Tensor;
use crate::space::Shape;
use crate::symmetry::Symmetry;

/// First direction: r or x.
pub const R: usize = 0;
/// Second direction: z or y.
pub const Z: usize = 1;
/// Third direction: theta, or out of plane.
pub const T: usize = 2;

/// Hoop factor of a shape: `N / r` in axisymmetric bodies, 0 in planar ones (1/m).
#[inline]
fn hoop(symmetry: Symmetry, r: f64, shape: Shape) -> f64 {
    match symmetry {
        Symmetry::Axisymmetric => shape.value / r,
        Symmetry::Planar => 0.0,
    }
}

/// Gradient of the displacement `shape` in direction `component` (0 = r, 1 = z).
///
/// $$ H_{ij} = \partial u_i / \partial x_j, \qquad H_{\theta\theta} = u_r / r $$
#[inline]
pub fn trial_gradient(symmetry: Symmetry, r: f64, shape: Shape, component: usize) -> Tensor {
    let mut h = Tensor::zeros();
    h[(component, R)] = shape.gradient[0];
    h[(component, Z)] = shape.gradient[1];
    if component == R {
        h[(T, T)] = hoop(symmetry, r, shape);
    }
    h
}

/// Gradient of the displacement with nodal values `u` (node by node, two components).
#[inline]
pub fn displacement_gradient(symmetry: Symmetry, r: f64, shapes: &[Shape], u: &[f64]) -> Tensor {
    let mut h = Tensor::zeros();
    for (i, s) in shapes.iter().enumerate() {
        for c in [R, Z] {
            h[(c, R)] += s.gradient[0] * u[2 * i + c];
            h[(c, Z)] += s.gradient[1] * u[2 * i + c];
        }
        h[(T, T)] += hoop(symmetry, r, *s) * u[2 * i];
    }
    h
}

/// Work density of a stress on the test functions `shape e_r` and `shape e_z`.
#[inline]
pub fn work(symmetry: Symmetry, r: f64, stress: &Tensor, shape: Shape) -> [f64; 2] {
    let g = shape.gradient;
    [
        stress[(R, R)] * g[0] + stress[(R, Z)] * g[1] + stress[(T, T)] * hoop(symmetry, r, shape),
        stress[(Z, R)] * g[0] + stress[(Z, Z)] * g[1],
    ]
}

#[cfg(test)]
mod tests {
    use super::*;

    const SHAPE: Shape = Shape { value: 0.6, gradient: [3.0, -2.0] };

    fn only(entries: &[((usize, usize), f64)]) -> Tensor {
        let mut h = Tensor::zeros();
        entries.iter().for_each(|&(at, v)| h[at] = v);
        h
    }

    #[test]
    fn radial_displacement_strains_rr_rz_and_the_hoop() {
        let h = trial_gradient(Symmetry::Axisymmetric, 2.0, SHAPE, R);
        assert_eq!(h, only(&[((R, R), 3.0), ((R, Z), -2.0), ((T, T), 0.3)]));
    }

    #[test]
    fn axial_displacement_strains_zz_and_zr_and_no_hoop() {
        let h = trial_gradient(Symmetry::Axisymmetric, 2.0, SHAPE, Z);
        assert_eq!(h, only(&[((Z, R), 3.0), ((Z, Z), -2.0)]));
    }

    #[test]
    fn planar_displacement_strains_nothing_out_of_plane() {
        let h = trial_gradient(Symmetry::Planar, 2.0, SHAPE, R);
        assert_eq!(h, only(&[((R, R), 3.0), ((R, Z), -2.0)]));
    }

    #[test]
    fn each_stress_component_works_on_its_own_gradient_only() {
        for symmetry in [Symmetry::Axisymmetric, Symmetry::Planar] {
            for i in 0..3 {
                for j in 0..3 {
                    let stress = only(&[((i, j), 1.0)]);
                    let got = work(symmetry, 2.0, &stress, SHAPE);
                    for c in [R, Z] {
                        assert_eq!(got[c], trial_gradient(symmetry, 2.0, SHAPE, c)[(i, j)]);
                    }
                }
            }
        }
    }

    #[test]
    fn the_gradient_of_a_field_is_the_sum_of_its_parts() {
        let other = Shape { value: 0.4, gradient: [-1.0, 5.0] };
        let u = [0.1, -0.2, 0.3, 0.7];
        let sum = trial_gradient(Symmetry::Axisymmetric, 1.5, SHAPE, R) * u[0]
            + trial_gradient(Symmetry::Axisymmetric, 1.5, SHAPE, Z) * u[1]
            + trial_gradient(Symmetry::Axisymmetric, 1.5, other, R) * u[2]
            + trial_gradient(Symmetry::Axisymmetric, 1.5, other, Z) * u[3];
        let h = displacement_gradient(Symmetry::Axisymmetric, 1.5, &[SHAPE, other], &u);
        assert!((h - sum).norm() < 1e-15);
    }
}
