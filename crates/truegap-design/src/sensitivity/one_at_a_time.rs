//! Every quantity a few per cent down and up, all others at their values: the paper's Figs 7 and 9.
//!
//! Limits: no interactions; foils are varied by the same share as everything else, although nobody sells them so.

use crate::{
    error::DesignError,
    metric::{METRICS, Metric, Metrics},
    metrics::{MetricOptions, metrics},
    quantity::Quantity,
};
use serde::Serialize;
use truegap_core::Sensor;

/// The variables of the paper's Table 2 that its equations contain.
pub const PAPER_QUANTITIES: [Quantity; 8] = [
    Quantity::Young,
    Quantity::Height,
    Quantity::Conductor,
    Quantity::Plating,
    Quantity::Insulator,
    Quantity::BeadDiameter,
    Quantity::BeadCount,
    Quantity::Diameter,
];

/// What a quantity does to every metric.
#[derive(Clone, Debug, PartialEq, Serialize)]
pub struct OneAtATime {
    /// the quantity
    pub quantity: Quantity,
    /// change of each metric when the quantity goes down, in the metric's own unit; NaN where the plates touch
    pub down: [f64; METRICS.len()],
    /// change of each metric when the quantity goes up
    pub up: [f64; METRICS.len()],
}

impl OneAtATime {
    /// The larger of the two changes of a metric, without sign.
    pub fn size(&self, metric: Metric) -> f64 {
        self.down[metric as usize].abs().max(self.up[metric as usize].abs())
    }
}

/// Changes of every metric for quantities that go down and up by a share of their values.
///
/// **Source:** \[hampson2023\] VII-C, VIII-C with `share` = 0.1.
///
/// # Errors
/// As [`metrics`] for the sensor itself.
pub fn one_at_a_time(
    sensor: &Sensor,
    quantities: &[Quantity],
    share: f64,
    options: MetricOptions,
) -> Result<Vec<OneAtATime>, DesignError> {
    let base = metrics(sensor, options)?;
    let moved = |quantity: Quantity, factor: f64| {
        let mut sensor = sensor.clone();
        if let Some(measure) = quantity.of(&sensor) {
            quantity.set(&mut sensor, measure.value * factor);
        }
        metrics(&sensor, options).map_or([f64::NAN; METRICS.len()], |m| difference(&m, &base))
    };
    let present = quantities.iter().filter(|q| q.of(sensor).is_some());
    Ok(present.map(|&q| OneAtATime { quantity: q, down: moved(q, 1.0 - share), up: moved(q, 1.0 + share) }).collect())
}

fn difference(a: &Metrics, b: &Metrics) -> [f64; METRICS.len()] {
    std::array::from_fn(|i| a.0[i] - b.0[i])
}

/// Quantities in the order in which they move a metric, the first the most.
pub fn ranked(rows: &[OneAtATime], metric: Metric) -> Vec<(Quantity, f64)> {
    let mut ranked: Vec<_> = rows.iter().map(|row| (row.quantity, row.size(metric))).collect();
    ranked.sort_by(|a, b| b.1.total_cmp(&a.1));
    ranked
}
