//! The numbers of a data sheet, their names and units.
//!
//! Limits: the seven that the paper's equations give.

use serde::{Deserialize, Serialize};
use std::fmt;

/// A number of a data sheet.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Serialize, Deserialize)]
#[serde(rename_all = "snake_case")]
pub enum Metric {
    /// capacitance without load at the lower temperature, pF
    Baseline,
    /// capacitance from no load to full load at the lower temperature, pF
    Span,
    /// greatest deviation from the line through the ends, % of the span
    Linearity,
    /// drift of the baseline, pF/K: (24) as printed
    KBaseline,
    /// drift of the baseline, % of the span per kelvin
    KBaselineShare,
    /// drift of the sensitivity, %/K
    KSensitivity,
    /// drift of the linearity, %/K
    KLinearity,
}

/// All metrics, in the order of [`Metrics`].
pub const METRICS: [Metric; 7] = [
    Metric::Baseline,
    Metric::Span,
    Metric::Linearity,
    Metric::KBaseline,
    Metric::KBaselineShare,
    Metric::KSensitivity,
    Metric::KLinearity,
];

impl Metric {
    /// Name as in files and on the command line.
    pub fn name(self) -> &'static str {
        match self {
            Self::Baseline => "baseline",
            Self::Span => "span",
            Self::Linearity => "linearity",
            Self::KBaseline => "k_baseline",
            Self::KBaselineShare => "k_baseline_share",
            Self::KSensitivity => "k_sensitivity",
            Self::KLinearity => "k_linearity",
        }
    }

    /// Unit of the number.
    pub fn unit(self) -> &'static str {
        match self {
            Self::Baseline | Self::Span => "pF",
            Self::Linearity => "% of span",
            Self::KBaseline => "pF/K",
            Self::KBaselineShare => "% of span/K",
            Self::KSensitivity | Self::KLinearity => "%/K",
        }
    }

    /// The metric of a name.
    pub fn named(name: &str) -> Option<Self> {
        METRICS.into_iter().find(|m| m.name() == name)
    }
}

impl fmt::Display for Metric {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.write_str(self.name())
    }
}

/// The seven metrics of one sensor, in the order of [`METRICS`].
#[derive(Clone, Copy, Debug, PartialEq, Serialize)]
pub struct Metrics(pub [f64; METRICS.len()]);

impl Metrics {
    /// One of them.
    pub fn of(&self, metric: Metric) -> f64 {
        self.0[metric as usize]
    }
}
