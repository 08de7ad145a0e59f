//! One row of the audit, as `audit.json` holds it.
//!
//! Limits: a scalar comparison; what depends on load or temperature goes into the figure.

use crate::effect::EffectOn;
use serde::{Deserialize, Serialize};

/// A number with its unit.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
pub struct Value {
    /// value in `unit`
    pub value: f64,
    /// unit; empty for a ratio
    pub unit: String,
}

/// A number from finite elements, with how far off it may be.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
pub struct FemValue {
    /// value in `unit`
    pub value: f64,
    /// unit; empty for a ratio
    pub unit: String,
    /// estimated magnitude of its error, in `unit`
    pub error_estimate: f64,
}

/// The dimensionless number that decides whether an assumption can hold: at most `limit` where it does.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
pub struct Measure {
    /// what it is, e.g. `gap / radius`
    pub name: String,
    /// for this sensor
    pub value: f64,
    /// up to which the assumption is taken to hold
    pub limit: f64,
}

/// What became of an assumption.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash, PartialOrd, Ord, Serialize, Deserialize)]
#[serde(rename_all = "snake_case")]
pub enum Verdict {
    /// no coefficient moves by 1 %
    Holds,
    /// some coefficient moves by 1 % or more, none by 10 %
    Strained,
    /// some coefficient moves by 10 % or more
    Broken,
}

impl Verdict {
    /// Effect, in per cent, from which an assumption is strained.
    const STRAINED_PCT: f64 = 1.0;
    /// Effect, in per cent, from which an assumption is broken.
    const BROKEN_PCT: f64 = 10.0;

    /// The verdict on an effect and a measure, with the reason as a sentence.
    ///
    /// A measure beyond its limit makes an assumption strained at least: the sensor is outside of where the equation is known to be good.
    pub fn of(effect: &EffectOn, measure: &Measure) -> (Self, String) {
        let (name, worst) = effect.worst();
        let verdict = match worst.abs() {
            worst if worst >= Self::BROKEN_PCT => Self::Broken,
            worst if worst >= Self::STRAINED_PCT || measure.value > measure.limit => Self::Strained,
            _ => Self::Holds,
        };
        let side = if measure.value > measure.limit { "beyond" } else { "within" };
        let reason = format!(
            "the largest effect is {worst:+.3} % on {name}; {}, {}, is {side} its limit {}",
            measure.name,
            readable(measure.value),
            measure.limit
        );
        (verdict, reason)
    }
}

/// Four digits, in powers of ten where the number is small.
fn readable(value: f64) -> String {
    if value == 0.0 || (1e-3..1e5).contains(&value.abs()) { format!("{value:.4}") } else { format!("{value:.3e}") }
}

/// A named line of a figure.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
pub struct Curve {
    /// legend
    pub name: String,
    /// `(x, y)`
    pub points: Vec<(f64, f64)>,
    /// estimated error of each y; empty for a closed form
    #[serde(default, skip_serializing_if = "Vec::is_empty")]
    pub errors: Vec<f64>,
}

/// Both routes over a load, a temperature or a dimension.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
pub struct Figure {
    /// caption
    pub title: String,
    /// quantity and unit along x
    pub x: String,
    /// quantity and unit along y
    pub y: String,
    /// the routes
    pub curves: Vec<Curve>,
}

impl Figure {
    /// The figure with a band of relative errors about one of its curves.
    #[must_use]
    pub(crate) fn with_errors(mut self, curve: usize, relative: f64) -> Self {
        if let Some(curve) = self.curves.get_mut(curve) {
            curve.errors = curve.points.iter().map(|p| relative * p.1.abs()).collect();
        }
        self
    }
}

/// One row of the audit.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
pub struct Finding {
    /// stable name of the assumption
    pub id: String,
    /// the assumption as a sentence
    pub says: String,
    /// what the analytic model says
    pub analytic: Value,
    /// what finite elements say of the same quantity
    pub fem: FemValue,
    /// analytic over finite elements, less 1
    pub relative_error: f64,
    /// what became of the assumption
    pub verdict: Verdict,
    /// why, as a sentence with numbers
    pub reason: String,
    /// what the finite elements' answer does to the coefficients
    pub effect_on: EffectOn,
    /// the number that decides
    pub measure: Measure,
    /// where the model assumes it, and what it is measured against
    pub source: String,
    /// both routes as curves
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub figure: Option<Figure>,
}
