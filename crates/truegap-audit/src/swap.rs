//! The analytic chain with single pieces replaced.
//!
//! Limits: the pieces of `truegap_model::stack::Device`; a replacement sees one load and one temperature.

use crate::error::AuditError;
use truegap_model::stack::{Capacitances, Device, Refusal, Squeeze, Warm};

type Warming<'a> = Box<dyn Fn(&mut Warm) -> Result<(), AuditError> + Send + Sync + 'a>;
type Straining<'a> = Box<dyn Fn(&Warm, f64) -> Result<f64, AuditError> + Send + Sync + 'a>;
type Squeezing<'a> = Box<dyn Fn(&Warm, &mut Squeeze) -> Result<(), AuditError> + Send + Sync + 'a>;
type Charging<'a> = Box<dyn Fn(&Warm, &Squeeze, &mut Capacitances) -> Result<(), AuditError> + Send + Sync + 'a>;

/// Replacements for pieces of the analytic chain; what is not replaced stays the paper's.
#[derive(Default)]
pub struct Swap<'a> {
    warm: Vec<Warming<'a>>,
    strain: Option<Straining<'a>>,
    squeeze: Vec<Squeezing<'a>>,
    parts: Vec<Charging<'a>>,
}

impl<'a> Swap<'a> {
    /// Nothing replaced.
    pub fn none() -> Self {
        Self::default()
    }

    /// Changes the warm, unloaded sensor: areas, modulus, layer heights ((3)-(7)).
    #[must_use]
    pub fn warm(mut self, change: impl Fn(&mut Warm) -> Result<(), AuditError> + Send + Sync + 'a) -> Self {
        self.warm.push(Box::new(change));
        self
    }

    /// Replaces the beads' force-strain law (12): compressive strain for a warm sensor and a force in N.
    #[must_use]
    pub fn strain(mut self, law: impl Fn(&Warm, f64) -> Result<f64, AuditError> + Send + Sync + 'a) -> Self {
        self.strain = Some(Box::new(law));
        self
    }

    /// Changes the geometry of a row: factor on the curvature, temperature that bends, sag by load, extra gap, permittivity factors.
    #[must_use]
    pub fn squeeze(mut self, change: impl Fn(&Warm, &mut Squeeze) -> Result<(), AuditError> + Send + Sync + 'a) -> Self {
        self.squeeze.push(Box::new(change));
        self
    }

    /// Changes the capacitances of a row, F: `parts.shares.{main, backing, tail}` are what is added up.
    #[must_use]
    pub fn parts(
        mut self,
        change: impl Fn(&Warm, &Squeeze, &mut Capacitances) -> Result<(), AuditError> + Send + Sync + 'a,
    ) -> Self {
        self.parts.push(Box::new(change));
        self
    }
}

/// A device and what is replaced in it.
pub struct Chain<'a> {
    /// the analytic sensor
    pub device: &'a Device,
    /// what is replaced
    pub swap: Swap<'a>,
}

/// Every quantity of one row.
#[derive(Clone, Copy, Debug)]
pub struct Row {
    /// the warm, unloaded sensor
    pub warm: Warm,
    /// what the row does to it
    pub squeeze: Squeeze,
    /// capacitances, F
    pub parts: Capacitances,
    /// what is read, F
    pub total: f64,
}

impl Chain<'_> {
    /// Every quantity at a force (N) and a temperature (degrees Celsius).
    ///
    /// # Errors
    /// [`AuditError::NoResponse`] where the gap closes, and what the replacements refuse.
    pub fn row(&self, force_n: f64, temperature_c: f64) -> Result<Row, AuditError> {
        let refuse = |refusal| {
            let strain = if let Refusal::Touches { strain } = refusal { strain } else { f64::NAN };
            AuditError::NoResponse { force_n, temperature_c, strain }
        };
        let mut warm = self.device.at(temperature_c);
        self.swap.warm.iter().try_for_each(|change| change(&mut warm))?;
        let strain = match &self.swap.strain {
            Some(law) => law(&warm, force_n)?,
            None => self.device.strain(&warm, force_n, 1.0, [0.0; 2]).map_err(refuse)?,
        };
        let mut squeeze = self.device.plain(&warm, force_n, strain);
        self.swap.squeeze.iter().try_for_each(|change| change(&warm, &mut squeeze))?;
        let mut parts = self.device.capacitances(&warm, &squeeze).map_err(refuse)?;
        self.swap.parts.iter().try_for_each(|change| change(&warm, &squeeze, &mut parts))?;
        Ok(Row { warm, squeeze, parts, total: self.device.total(parts.shares) })
    }

    /// What is read at a force (N) and a temperature (degrees Celsius), pF.
    ///
    /// # Errors
    /// As [`Chain::row`].
    pub fn capacitance_pf(&self, force_n: f64, temperature_c: f64) -> Result<f64, AuditError> {
        Ok(self.row(force_n, temperature_c)?.total * 1e12)
    }
}
