//! Hooke's law in the small strain `e = (H + H^T) / 2`.
//!
//! Valid for small strains *and* small rotations.

use super::law::{Law, Tensor};

/// `W = mu e : e + lambda / 2 (tr e)^2`.
///
/// **Source:** Timoshenko & Goodier, Theory of Elasticity.
pub struct Linear {
    strain: Tensor,
}

fn symmetric(h: &Tensor) -> Tensor {
    (h + h.transpose()) * 0.5
}

impl Law for Linear {
    const QUADRATURE_DEGREE: usize = 4;

    #[inline]
    fn at(h: &Tensor) -> Self {
        Linear { strain: symmetric(h) }
    }

    fn shear_energy(&self) -> f64 {
        self.strain.dot(&self.strain)
    }

    #[inline]
    fn shear_stress(&self) -> Tensor {
        self.strain * 2.0
    }

    #[inline]
    fn shear_tangent(&self, dh: &Tensor) -> Tensor {
        symmetric(dh) * 2.0
    }

    #[inline]
    fn volume(&self) -> f64 {
        self.strain.trace()
    }

    #[inline]
    fn volume_slope(&self) -> Tensor {
        Tensor::identity()
    }

    #[inline]
    fn volume_curvature(&self, _dh: &Tensor) -> Tensor {
        Tensor::zeros()
    }
}
