//! Compressible neo-Hookean rubber.
//!
//! One modulus for shear and one for volume; no stiffening at large stretch.

use super::law::{Law, Tensor};

/// `W = mu / 2 (tr F^T F - 3 - 2 ln J) + lambda / 2 (J - 1)^2`, J = det F.
///
/// **Source:** Bonet & Wood, Nonlinear Continuum Mechanics for Finite Element Analysis, section 6.4, with
/// `(J - 1)^2` in place of `(ln J)^2`: the volume part then stays convex, and its mixed form is polynomial in `F`.
pub struct NeoHookean {
    h: Tensor,
    inverse_transpose: Tensor,
    /// `J - 1`, from the invariants of `H` so that small changes of volume keep their digits.
    growth: f64,
}

impl Law for NeoHookean {
    const QUADRATURE_DEGREE: usize = 5;

    #[inline]
    fn at(h: &Tensor) -> Self {
        let deformation = Tensor::identity() + h;
        let minors = 0.5 * (h.trace() * h.trace() - (h * h).trace());
        NeoHookean {
            h: *h,
            // A singular F has no admissible state; the energy below is then NaN.
            inverse_transpose: deformation.try_inverse().unwrap_or(Tensor::repeat(f64::NAN)).transpose(),
            growth: h.trace() + minors + h.determinant(),
        }
    }

    fn shear_energy(&self) -> f64 {
        self.h.trace() + 0.5 * self.h.dot(&self.h) - self.growth.ln_1p()
    }

    #[inline]
    fn shear_stress(&self) -> Tensor {
        Tensor::identity() + self.h - self.inverse_transpose
    }

    #[inline]
    fn shear_tangent(&self, dh: &Tensor) -> Tensor {
        let g = &self.inverse_transpose;
        dh + g * dh.transpose() * g
    }

    #[inline]
    fn volume(&self) -> f64 {
        self.growth
    }

    #[inline]
    fn volume_slope(&self) -> Tensor {
        self.inverse_transpose * (1.0 + self.growth)
    }

    #[inline]
    fn volume_curvature(&self, dh: &Tensor) -> Tensor {
        let g = &self.inverse_transpose;
        (g * g.dot(dh) - g * dh.transpose() * g) * (1.0 + self.growth)
    }
}
