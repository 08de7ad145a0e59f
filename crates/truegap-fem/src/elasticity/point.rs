//! The forms at one quadrature point: energy density, residual and tangent, pure in displacement or mixed.
//!
//! $$ \Pi = c \left[ \mu s(H_e) + p\, g(H_e) - p^2 / (2 \lambda) \right] $$
//!
//! with `H_e` the elastic displacement gradient and `c` the thermal growth of volume. In the displacement formulation
//! `p = lambda g` at every point, which gives `mu s + lambda g^2 / 2`.

use super::kinematics::{R, T, Z, trial_gradient, work};
use super::laws::{Law, Tensor};
use super::material::Lame;
use super::quadrature_point::MappedQuadraturePoint;
use super::thermal::ThermalStretch;
use crate::symmetry::Symmetry;

/// Moduli of a point.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(crate) struct Moduli {
    /// Shear modulus (Pa).
    pub mu: f64,
    /// `lambda` (Pa), used without pressure unknowns.
    pub lambda: f64,
    /// `1 / lambda` (1/Pa), used with them.
    pub compliance: f64,
}

impl From<Lame> for Moduli {
    fn from(lame: Lame) -> Moduli {
        Moduli { mu: lame.mu, lambda: lame.lambda(), compliance: lame.inverse_lambda }
    }
}

/// Something to be done at every quadrature point of an element, whatever its law.
pub(crate) trait Visitor {
    /// Visits one point.
    fn visit<L: Law>(&mut self, at: &At<L>, q: &MappedQuadraturePoint);
}

/// A law, evaluated at a point of a body.
pub(crate) struct At<L> {
    symmetry: Symmetry,
    law: L,
    /// Pressure unknown at the point, if there is one (Pa).
    mixed: Option<f64>,
    split: ThermalStretch,
    moduli: Moduli,
}

impl<L: Law> At<L> {
    pub(crate) fn new(symmetry: Symmetry, h: &Tensor, mixed: Option<f64>, split: ThermalStretch, moduli: Moduli) -> At<L> {
        At { symmetry, law: L::at(&split.elastic(h)), mixed, split, moduli }
    }

    /// Volumetric stress `p` (Pa).
    fn volumetric(&self) -> f64 {
        match self.mixed {
            Some(p) => p,
            None => self.moduli.lambda * self.law.volume(),
        }
    }

    /// Energy per reference volume (J/m^3); the stationary functional where there is a pressure.
    pub(crate) fn energy(&self) -> f64 {
        let g = self.law.volume();
        let volumetric = match self.mixed {
            Some(p) => p * g - 0.5 * self.moduli.compliance * p * p,
            None => 0.5 * self.moduli.lambda * g * g,
        };
        self.split.volume * (self.moduli.mu * self.law.shear_energy() + volumetric)
    }

    /// Derivative of the volume by the displacement gradient, thermal growth included.
    pub(crate) fn volume_slope(&self) -> Tensor {
        self.law.volume_slope() * self.split.stress_factor()
    }

    /// Second derivative of the energy by the pressure unknown, with the sign turned (1/Pa).
    pub(crate) fn pressure_compliance(&self) -> f64 {
        self.split.volume * self.moduli.compliance
    }

    /// Volume measure that the pressure does not account for, thermal growth included; zero without pressure.
    pub(crate) fn gap(&self) -> f64 {
        self.mixed.map_or(0.0, |p| self.split.volume * (self.law.volume() - self.moduli.compliance * p))
    }

    /// Nominal (first Piola-Kirchhoff) stress (Pa).
    pub(crate) fn stress(&self) -> Tensor {
        (self.law.shear_stress() * self.moduli.mu + self.law.volume_slope() * self.volumetric()) * self.split.stress_factor()
    }

    /// Change of the nominal stress with the displacement gradient, the pressure unknown held.
    pub(crate) fn tangent(&self, dh: &Tensor) -> Tensor {
        let mut stress = self.law.shear_tangent(dh) * self.moduli.mu + self.law.volume_curvature(dh) * self.volumetric();
        if self.mixed.is_none() {
            let slope = self.law.volume_slope();
            stress += slope * (self.moduli.lambda * slope.dot(dh));
        }
        stress * self.split.tangent_factor()
    }

    /// Adds `dPi / d(unknowns)`.
    pub(crate) fn add_residual(&self, s: &MappedQuadraturePoint, out: &mut [f64]) {
        let stress = self.stress();
        for (i, shape) in s.shapes.iter().enumerate() {
            let [r, z] = work(self.symmetry, s.at[0], &stress, *shape);
            out[2 * i] += s.weight * r;
            out[2 * i + 1] += s.weight * z;
        }
        for (a, n) in s.pressures.iter().enumerate() {
            out[2 * s.shapes.len() + a] += s.weight * n * self.gap();
        }
    }

    /// Adds the second derivative of `Pi` by the unknowns, column by column (lower triangle).
    pub(crate) fn add_tangent(&self, s: &MappedQuadraturePoint, out: &mut [f64]) {
        let inner = 2 * s.shapes.len();
        let m = inner + s.pressures.len();
        for (j, trial) in s.shapes.iter().enumerate() {
            for c in [R, Z] {
                let dh = trial_gradient(self.symmetry, s.at[0], *trial, c);
                let stress = self.tangent(&dh) * s.weight;
                let column = &mut out[(2 * j + c) * m..(2 * j + c + 1) * m];
                for (i, test) in s.shapes.iter().enumerate().skip(j) {
                    let [r, z] = work(self.symmetry, s.at[0], &stress, *test);
                    column[2 * i] += r;
                    column[2 * i + 1] += z;
                }
            }
        }
        if self.mixed.is_some() {
            self.add_mixed(s, inner, m, out);
        }
    }

    fn add_mixed(&self, s: &MappedQuadraturePoint, inner: usize, m: usize, out: &mut [f64]) {
        let slope = self.volume_slope() * s.weight;
        let diagonal = s.weight * self.pressure_compliance();
        for (a, na) in s.pressures.iter().enumerate() {
            for (j, shape) in s.shapes.iter().enumerate() {
                let [r, z] = work(self.symmetry, s.at[0], &slope, *shape);
                out[2 * j * m + inner + a] += na * r;
                out[(2 * j + 1) * m + inner + a] += na * z;
            }
            for (b, nb) in s.pressures.iter().enumerate() {
                out[(inner + b) * m + inner + a] -= diagonal * na * nb;
            }
        }
    }

    /// Cauchy stress (Pa) at the displacement gradient `h`, for a law that distinguishes it from the nominal one.
    pub(crate) fn cauchy(&self, h: &Tensor) -> Tensor {
        let f = Tensor::identity() + h;
        let mut stress = self.stress() * f.transpose() / f.determinant();
        for (i, j) in [(R, T), (Z, T), (T, R), (T, Z)] {
            stress[(i, j)] = 0.0;
        }
        stress
    }
}
