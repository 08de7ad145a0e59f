//! Coefficients of the coupled disc from its four corners: no and full load, cold and hot.
//!
//! Limits: linearity would need loads between.

use super::coupled::Whole;
use crate::effect::Corners;
use crate::{error::AuditError, study::Study};
use truegap_model::equations::coefficients::{Pair, Range, baseline_coefficient, sensitivity, sensitivity_coefficient};

/// What four solutions of the coupled disc say.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct CornerCoefficients {
    /// capacitance without load at T0, pF
    pub baseline_pf: f64,
    /// span from no load to full load at T0, pF
    pub span_pf: f64,
    /// drift of the baseline, % of the span per kelvin
    pub k_baseline_pct_fsr_per_k: f64,
    /// drift of the sensitivity, %/K
    pub k_sensitivity_pct_per_k: f64,
}

/// Coefficients (24)-(26) of any response in pF over (force in N, temperature in degrees Celsius), from the corners alone.
///
/// # Errors
/// What the response refuses.
pub fn corner_coefficients(
    response: &dyn Fn(f64, f64) -> Result<f64, AuditError>,
    at: Corners,
) -> Result<CornerCoefficients, AuditError> {
    let range = |celsius| -> Result<Range, AuditError> {
        Ok(Range { unloaded: response(0.0, celsius)?, loaded: response(at.full_n, celsius)? })
    };
    let (cold, hot) = (range(at.cold_c)?, range(at.hot_c)?);
    let kelvin = at.hot_c - at.cold_c;
    let slopes = Pair { cold: sensitivity(cold, at.full_n), hot: sensitivity(hot, at.full_n) };
    Ok(CornerCoefficients {
        baseline_pf: cold.unloaded,
        span_pf: cold.span(),
        k_baseline_pct_fsr_per_k: baseline_coefficient(Pair { cold: cold.unloaded, hot: hot.unloaded }, kelvin, cold.span()),
        k_sensitivity_pct_per_k: sensitivity_coefficient(slopes, kelvin),
    })
}

impl Whole<'_> {
    /// Coefficients of the coupled disc over the range of a study.
    ///
    /// # Errors
    /// As [`Whole::solve`].
    pub fn coefficients(&self, study: &Study<'_>) -> Result<CornerCoefficients, AuditError> {
        corner_coefficients(&|force, celsius| self.capacitance_pf(force, celsius), study.corners())
    }
}
