//! What a region is made of.
//!
//! Isotropic only; moduli do not depend on temperature (give the material at the temperature of interest).

use super::error::ElasticityError;

/// Relation of stress to deformation.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum LawKind {
    /// Hooke's law in the small strain.
    Linear,
    /// Hooke's law in the Green strain: large rotations of thin metal.
    SaintVenantKirchhoff,
    /// Rubber.
    NeoHookean,
}

/// Whether the volumetric stress is an unknown of its own.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Formulation {
    /// Displacements only; locks as Poisson's ratio nears 1/2 and does not take 1/2.
    Displacement,
    /// Quadratic displacements and continuous linear pressure (Taylor-Hood); takes Poisson's ratios up to 1/2.
    Mixed,
}

impl Formulation {
    /// Mixed from a Poisson's ratio of 0.45 on, where pure displacements begin to lose accuracy.
    pub fn suited(poisson: f64) -> Formulation {
        if poisson >= 0.45 { Formulation::Mixed } else { Formulation::Displacement }
    }
}

/// An isotropic material.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Material {
    /// Young's modulus (Pa).
    pub young: f64,
    /// Poisson's ratio, above -1 and up to 1/2.
    pub poisson: f64,
    /// Linear thermal expansion (1/K).
    pub expansion: f64,
    /// The law.
    pub law: LawKind,
    /// The formulation.
    pub formulation: Formulation,
}

/// Moduli as the laws use them.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Lame {
    /// Second parameter, the shear modulus (Pa).
    pub mu: f64,
    /// Inverse of the first parameter (1/Pa); zero if incompressible.
    pub inverse_lambda: f64,
}

impl Lame {
    /// First parameter (Pa), infinite if incompressible.
    pub fn lambda(&self) -> f64 {
        1.0 / self.inverse_lambda
    }
}

impl Material {
    /// `mu = E / (2 (1 + nu))`, `1 / lambda = (1 + nu) (1 - 2 nu) / (E nu)`.
    ///
    /// **Source:** Timoshenko & Goodier, Theory of Elasticity.
    pub fn lame(&self) -> Lame {
        let (e, nu) = (self.young, self.poisson);
        Lame { mu: e / (2.0 * (1.0 + nu)), inverse_lambda: (1.0 + nu) * (1.0 - 2.0 * nu) / (e * nu) }
    }

    /// Checks the numbers of the material of `region`.
    pub(crate) fn check(&self, region: &str) -> Result<(), ElasticityError> {
        let bad = |quantity: &'static str, value: f64, remedy: &'static str| {
            Err(ElasticityError::Material { region: region.into(), quantity, value, remedy })
        };
        let nu = self.poisson;
        if !(self.young > 0.0 && self.young.is_finite()) {
            return bad("Young's modulus", self.young, "give a positive number of pascals");
        }
        if !(nu > -1.0 && nu <= 0.5) {
            return bad("Poisson's ratio", nu, "it lies above -1 and is at most 0.5");
        }
        if !self.expansion.is_finite() {
            return bad("the expansion", self.expansion, "give a finite number of 1/K");
        }
        if nu == 0.5 && self.formulation == Formulation::Displacement {
            return bad(
                "Poisson's ratio",
                nu,
                "an incompressible material needs the mixed formulation; with displacements alone stay below 0.5",
            );
        }
        if self.formulation == Formulation::Mixed && !(nu > 0.0) {
            return bad("Poisson's ratio", nu, "the mixed formulation needs a positive value; use displacements alone");
        }
        Ok(())
    }
}
