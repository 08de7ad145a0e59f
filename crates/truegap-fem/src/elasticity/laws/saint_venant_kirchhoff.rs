//! Saint Venant-Kirchhoff: Hooke's law in the Green strain. Large rotations, small strains: thin metal layers.
//!
//! Softens under strong compression (beyond a stretch of about 0.6) and must not be used for rubber.

use super::law::{Law, Tensor};

/// `W = mu E : E + lambda / 2 (tr E)^2` with `E = (F^T F - I) / 2 = (H + H^T + H^T H) / 2`.
///
/// **Source:** Holzapfel, Nonlinear Solid Mechanics, section 6.5. The strain is formed from `H`, not from `F`, so that
/// strains of 1e-6 keep their digits.
pub struct SaintVenantKirchhoff {
    deformation: Tensor,
    strain: Tensor,
}

impl Law for SaintVenantKirchhoff {
    const QUADRATURE_DEGREE: usize = 5;

    #[inline]
    fn at(h: &Tensor) -> Self {
        SaintVenantKirchhoff { deformation: Tensor::identity() + h, strain: (h + h.transpose() + h.tr_mul(h)) * 0.5 }
    }

    fn shear_energy(&self) -> f64 {
        self.strain.dot(&self.strain)
    }

    #[inline]
    fn shear_stress(&self) -> Tensor {
        self.deformation * self.strain * 2.0
    }

    #[inline]
    fn shear_tangent(&self, dh: &Tensor) -> Tensor {
        let half = self.deformation.tr_mul(dh);
        dh * self.strain * 2.0 + self.deformation * (half + half.transpose())
    }

    #[inline]
    fn volume(&self) -> f64 {
        self.strain.trace()
    }

    #[inline]
    fn volume_slope(&self) -> Tensor {
        self.deformation
    }

    #[inline]
    fn volume_curvature(&self, dh: &Tensor) -> Tensor {
        *dh
    }
}
