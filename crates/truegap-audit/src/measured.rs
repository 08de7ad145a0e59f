//! What an assumption measured, and how that becomes a row of the audit.
//!
//! Limits: a scalar comparison; what depends on load or temperature goes into the figure.

use crate::{
    assumption::Assumption,
    effect::EffectOn,
    finding::{FemValue, Figure, Finding, Measure, Value, Verdict},
};

/// What an assumption measured, before the verdict.
#[derive(Clone, Debug, PartialEq)]
pub(crate) struct Measured {
    /// unit of both values; empty for a ratio
    pub unit: &'static str,
    /// by the analytic model
    pub analytic: f64,
    /// by finite elements
    pub fem: f64,
    /// estimated magnitude of the error of `fem`
    pub error_estimate: f64,
    /// the number that decides
    pub measure: Measure,
    /// effect on the coefficients
    pub effect_on: EffectOn,
    /// both routes as curves
    pub figure: Option<Figure>,
}

impl Measured {
    /// The row of an assumption, with the verdict of [`Verdict::of`].
    pub(crate) fn finding(self, assumption: &dyn Assumption) -> Finding {
        let (verdict, reason) = Verdict::of(&self.effect_on, &self.measure);
        Finding {
            id: assumption.id().into(),
            says: assumption.says().into(),
            analytic: Value { value: self.analytic, unit: self.unit.into() },
            fem: FemValue { value: self.fem, unit: self.unit.into(), error_estimate: self.error_estimate },
            relative_error: self.analytic / self.fem - 1.0,
            verdict,
            reason,
            effect_on: self.effect_on,
            measure: self.measure,
            source: assumption.source().into(),
            figure: self.figure,
        }
    }
}
