//! Figures and pages of the studies.
//!
//! Limits: tells what an answer says; decides nothing.

#[cfg(feature = "fem")]
pub(super) mod audit;
pub(super) mod optimise;
pub(super) mod sensitivity;
pub(super) mod tolerance;

use truegap_design::{METRICS, Metric, Metrics};
use truegap_diagnose::text::significant;

/// A metric as a reader calls it.
fn spoken(metric: Metric) -> &'static str {
    match metric {
        Metric::Baseline => "baseline",
        Metric::Span => "span",
        Metric::Linearity => "linearity error",
        Metric::KBaseline => "baseline drift",
        Metric::KBaselineShare => "baseline drift (share of span)",
        Metric::KSensitivity => "sensitivity drift",
        Metric::KLinearity => "linearity drift",
    }
}

fn number(value: f64) -> String {
    significant(value, 4)
}

/// Cells of a row of metrics: a name, then a number a metric.
fn row(name: &str, values: &[f64]) -> Vec<String> {
    std::iter::once(name.to_owned()).chain(values.iter().map(|&v| significant(v, 3))).collect()
}

/// Header of such rows.
fn header(first: &str) -> Vec<String> {
    std::iter::once(first.to_owned()).chain(METRICS.iter().map(|m| format!("{}, {}", spoken(*m), m.unit()))).collect()
}

fn values(metrics: &Metrics) -> [f64; METRICS.len()] {
    metrics.0
}
