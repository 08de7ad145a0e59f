//! What keeps a sensor useful.
//!
//! Limits: the paper says "useful baseline, FSR, and linearity" without numbers; the shares here are ours.

use crate::{
    error::DesignError,
    metric::{Metric, Metrics},
};
use serde::{Deserialize, Serialize};
use truegap_core::{Sensor, sensor::Filling};

/// A condition on a design.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Serialize)]
#[serde(rename_all = "snake_case")]
pub enum Constraint {
    /// the plates stay apart up to full load, cold and hot
    PlatesApart,
    /// the unloaded beads leave room between them to spread
    BeadsFit,
    /// enough baseline
    Baseline,
    /// enough span
    Span,
    /// straight enough
    Linearity,
}

/// All constraints, in the order in which violations are listed.
pub const CONSTRAINTS: [Constraint; 5] =
    [Constraint::PlatesApart, Constraint::BeadsFit, Constraint::Baseline, Constraint::Span, Constraint::Linearity];

impl Constraint {
    /// In words.
    pub fn says(self) -> &'static str {
        match self {
            Self::PlatesApart => "the plates stay apart up to full load",
            Self::BeadsFit => "the beads fit on the electrode",
            Self::Baseline => "the baseline stays useful",
            Self::Span => "the span stays useful",
            Self::Linearity => "the linearity stays useful",
        }
    }
}

/// How useful a sensor must stay.
#[derive(Clone, Copy, Debug, PartialEq, Serialize, Deserialize)]
pub struct Useful {
    /// least baseline, share of the starting design's
    pub baseline: f64,
    /// least span, share of the starting design's
    pub span: f64,
    /// greatest linearity error, multiple of the starting design's
    pub linearity: f64,
    /// greatest share of the electrode that the unloaded beads may cover
    pub covered: f64,
}

impl Default for Useful {
    fn default() -> Self {
        Self { baseline: 0.25, span: 0.25, linearity: 2.0, covered: 0.75 }
    }
}

impl Useful {
    /// Shares that something can meet.
    ///
    /// # Errors
    /// [`DesignError::NoSuchLimit`] for a limit that is not a positive number, or a coverage above 1.
    pub fn check(&self) -> Result<(), DesignError> {
        let limits = [
            ("baseline", self.baseline, f64::INFINITY),
            ("span", self.span, f64::INFINITY),
            ("linearity", self.linearity, f64::INFINITY),
            ("coverage", self.covered, 1.0),
        ];
        match limits.into_iter().find(|(_, value, most)| !(*value > 0.0 && value.is_finite() && value <= most)) {
            Some((limit, value, _)) => Err(DesignError::NoSuchLimit { limit, value }),
            None => Ok(()),
        }
    }

    /// By how much each constraint is violated, relative to its limit, 0 where it holds; `metrics` is `None` where the plates touch.
    pub fn violations(&self, sensor: &Sensor, metrics: Option<&Metrics>, base: &Metrics) -> [f64; CONSTRAINTS.len()] {
        let ratio = |metric: Metric| metrics.map(|m| m.of(metric) / base.of(metric));
        let least = |metric: Metric, limit: f64| ratio(metric).map_or(0.0, |r| (1.0 - r / limit).max(0.0));
        [
            f64::from(u8::from(metrics.is_none())),
            (covered(sensor) / self.covered - 1.0).max(0.0),
            least(Metric::Baseline, self.baseline),
            least(Metric::Span, self.span),
            ratio(Metric::Linearity).map_or(0.0, |r| (r / self.linearity - 1.0).max(0.0)),
        ]
    }
}

/// Share of the electrode that the unloaded beads cover; a solid has no room to leave.
fn covered(sensor: &Sensor) -> f64 {
    match sensor.dielectric.filling {
        Filling::Beads { count, diameter } => f64::from(count) * (diameter.value / sensor.diameter.value).powi(2),
        Filling::Solid { .. } => 0.0,
    }
}
