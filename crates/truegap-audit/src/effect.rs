//! What a replaced piece of the chain does to baseline, span and the three temperature coefficients.
//!
//! Limits: (24)-(28) between two temperatures and no and full load; a change of a coefficient that is zero has no percentage.

use crate::error::AuditError;
use serde::{Deserialize, Serialize};
use truegap_model::{
    Coefficients,
    equations::coefficients::{
        Pair, Range, baseline_coefficient, baseline_drift, linearity, linearity_coefficient, sensitivity, sensitivity_coefficient,
    },
};

/// Change of each coefficient when finite elements replace the assumed piece, % of the analytic model's value; `None` where that is zero.
#[derive(Clone, Copy, Debug, Default, PartialEq, Serialize, Deserialize)]
pub struct EffectOn {
    /// capacitance without load at the cold temperature
    pub baseline_pct: Option<f64>,
    /// span from no to full load at the cold temperature
    pub span_pct: Option<f64>,
    /// drift of the baseline in %FSR/K
    pub k_baseline_pct: Option<f64>,
    /// drift of the sensitivity
    pub k_sensitivity_pct: Option<f64>,
    /// drift of the linearity
    pub k_linearity_pct: Option<f64>,
}

impl EffectOn {
    /// Names of the coefficients, in the order of [`EffectOn::values`].
    pub const NAMES: [&'static str; 5] = ["baseline", "span", "K_baseline", "K_sensitivity", "K_linearity"];

    /// The change from one set of coefficients to another.
    pub(crate) fn between(base: &Coefficients, other: &Coefficients) -> Self {
        let change = |base: f64, other: f64| (base != 0.0).then(|| 100.0 * (other - base) / base.abs()).filter(|p| p.is_finite());
        Self {
            baseline_pct: change(base.baseline_pf, other.baseline_pf),
            span_pct: change(base.span_pf, other.span_pf),
            k_baseline_pct: change(base.k_baseline_pct_fsr_per_k, other.k_baseline_pct_fsr_per_k),
            k_sensitivity_pct: change(base.k_sensitivity_pct_per_k, other.k_sensitivity_pct_per_k),
            k_linearity_pct: change(base.k_linearity_pct_per_k, other.k_linearity_pct_per_k),
        }
    }

    /// The changes in the order of [`EffectOn::NAMES`], %.
    pub fn values(&self) -> [Option<f64>; 5] {
        [self.baseline_pct, self.span_pct, self.k_baseline_pct, self.k_sensitivity_pct, self.k_linearity_pct]
    }

    /// Name and size (%) of the largest change.
    pub fn worst(&self) -> (&'static str, f64) {
        let known = Self::NAMES.into_iter().zip(self.values()).filter_map(|(name, value)| Some((name, value?)));
        known.max_by(|a, b| a.1.abs().total_cmp(&b.1.abs())).unwrap_or((Self::NAMES[0], 0.0))
    }
}

/// Where coefficients are taken.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Corners {
    /// T0, degrees Celsius
    pub cold_c: f64,
    /// T1, degrees Celsius
    pub hot_c: f64,
    /// full load, N
    pub full_n: f64,
}

/// Number of equal load steps on which the greatest deviation from a line is sought; a parabola through the best one refines it.
const STEPS: usize = 40;

/// Coefficients (24)-(28) of any response in pF over (force in N, temperature in degrees Celsius).
///
/// **Accuracy:** as `truegap_model::coefficients` to 1e-4 of the linearity, `coefficients_of_the_plain_chain_are_those_of_the_model`.
///
/// # Errors
/// What the response refuses.
pub fn coefficients_of(response: &dyn Fn(f64, f64) -> Result<f64, AuditError>, at: Corners) -> Result<Coefficients, AuditError> {
    let curve = |temperature| -> Result<(Range, f64), AuditError> {
        let share = |i: usize| i as f64 / STEPS as f64;
        let values = (0..=STEPS).map(|i| Ok((share(i), response(share(i) * at.full_n, temperature)?)));
        let values = values.collect::<Result<Vec<_>, AuditError>>()?;
        let range = Range { unloaded: values[0].1, loaded: values[STEPS].1 };
        Ok((range, greatest(range, &values)))
    };
    let (cold, cold_off) = curve(at.cold_c)?;
    let (hot, hot_off) = curve(at.hot_c)?;
    let kelvin = at.hot_c - at.cold_c;
    let baseline = Pair { cold: cold.unloaded, hot: hot.unloaded };
    let sensitivities = Pair { cold: sensitivity(cold, at.full_n), hot: sensitivity(hot, at.full_n) };
    Ok(Coefficients {
        baseline_pf: cold.unloaded,
        span_pf: cold.span(),
        k_baseline_pf_per_k: baseline_drift(baseline, kelvin),
        k_baseline_pct_fsr_per_k: baseline_coefficient(baseline, kelvin, cold.span()),
        k_sensitivity_pct_per_k: sensitivity_coefficient(sensitivities, kelvin),
        linearity_pct: cold_off,
        k_linearity_pct_per_k: linearity_coefficient(Pair { cold: cold_off, hot: hot_off }, kelvin),
    })
}

/// Greatest deviation from the end-point line, % of the span: the best step and the parabola through it and its neighbours.
fn greatest(range: Range, values: &[(f64, f64)]) -> f64 {
    let off: Vec<f64> = values.iter().map(|&value| linearity(range, [value])).collect();
    let best = (0..off.len()).max_by(|&a, &b| off[a].total_cmp(&off[b])).unwrap_or(0);
    if best == 0 || best + 1 == off.len() {
        return off[best];
    }
    let (left, right) = (off[best - 1] - off[best], off[best + 1] - off[best]);
    let bend = left + right;
    if bend < 0.0 { off[best] - (left - right) * (left - right) / (8.0 * bend) } else { off[best] }
}
