//! Thermal stretch: which part of a deformation is elastic.
//!
//! Isotropic, and linear in the temperature.

use super::laws::Tensor;
use super::material::LawKind;

/// Splits a deformation into a free thermal stretch and an elastic rest.
///
/// | law | elastic displacement gradient | energy per reference volume |
/// |-----|-------------------------------|-----------------------------|
/// | linear | `H - a dT I` | `W` |
/// | finite | `F / t - I = (H - a dT I) / t`, `t = 1 + a dT` | `t^3 W` |
///
/// **Source:** multiplicative split, Holzapfel, Nonlinear Solid Mechanics, section 7.9.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(crate) struct ThermalStretch {
    /// `a dT`.
    pub expansion: f64,
    /// `1 / t`: derivative of the elastic gradient by the total one.
    pub inverse_stretch: f64,
    /// Factor of the energy: thermally grown volume per reference volume.
    pub volume: f64,
}

impl ThermalStretch {
    /// The split for a law at the free thermal strain `expansion = a dT`.
    #[inline]
    pub fn new(law: LawKind, expansion: f64) -> ThermalStretch {
        let t = match law {
            LawKind::Linear => 1.0,
            LawKind::SaintVenantKirchhoff | LawKind::NeoHookean => 1.0 + expansion,
        };
        ThermalStretch { expansion, inverse_stretch: 1.0 / t, volume: t * t * t }
    }

    /// Elastic displacement gradient.
    #[inline]
    pub fn elastic(&self, h: &Tensor) -> Tensor {
        (h - Tensor::identity() * self.expansion) * self.inverse_stretch
    }

    /// Factor from the law's stress to the nominal stress of the reference body.
    #[inline]
    pub fn stress_factor(&self) -> f64 {
        self.volume * self.inverse_stretch
    }

    /// Factor from the law's tangent to that of the nominal stress.
    #[inline]
    pub fn tangent_factor(&self) -> f64 {
        self.volume * self.inverse_stretch * self.inverse_stretch
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn free_expansion_is_not_elastic() {
        for law in [LawKind::Linear, LawKind::SaintVenantKirchhoff, LawKind::NeoHookean] {
            let split = ThermalStretch::new(law, 0.1);
            assert!(split.elastic(&(Tensor::identity() * 0.1)).norm() < 1e-16);
        }
    }

    #[test]
    fn a_held_finite_body_is_compressed_by_the_whole_stretch() {
        let split = ThermalStretch::new(LawKind::NeoHookean, 0.25);
        // F = I, so F / t - I = 1 / 1.25 - 1 = -0.2.
        let held = split.elastic(&Tensor::zeros());
        assert!((held + Tensor::identity() * 0.2).norm() < 1e-15);
        assert!((split.volume - 1.953125).abs() < 1e-15);
        assert!((split.stress_factor() - 1.5625).abs() < 1e-15);
        assert!((split.tangent_factor() - 1.25).abs() < 1e-15);
    }
}
