//! Sobol indices of the metrics over a sensor's tolerances.
//!
//! Limits: independent normal tolerances, as in a batch.

use super::sobol::{Index, SobolOptions, watched_indices};
use crate::sample::normal_quantile;
use crate::tolerance::toleranced;
use crate::{
    error::DesignError,
    metric::METRICS,
    metrics::{MetricOptions, metrics},
    quantity::Quantity,
};
use serde::Serialize;
use truegap_core::Sensor;

/// Indices of one quantity for every metric, in the order of [`METRICS`].
#[derive(Clone, Debug, PartialEq, Serialize)]
pub struct QuantityIndices {
    /// the quantity
    pub quantity: Quantity,
    /// first-order indices
    pub first: Vec<Index>,
    /// total indices
    pub total: Vec<Index>,
}

/// Indices over all tolerances.
#[derive(Clone, Debug, PartialEq, Serialize)]
pub struct ToleranceIndices {
    /// rows evaluated
    pub rows: usize,
    /// seed
    pub seed: u64,
    /// one entry a tolerance
    pub quantities: Vec<QuantityIndices>,
}

/// Indices of every quantity that has a tolerance, by rows of quasi-random sensors. `watch` is told how many rows are done; where it answers `false` these
/// rows are all there will be.
///
/// # Errors
/// [`DesignError::NoTolerance`]; [`DesignError::TooFewSamples`] and [`DesignError::TooManySamples`] for the rows; [`DesignError::Refused`] where more than
/// 1 % of them have no answer.
pub fn tolerance_indices(
    sensor: &Sensor,
    metric_options: MetricOptions,
    options: SobolOptions,
    watch: impl Fn(usize) -> bool,
) -> Result<ToleranceIndices, DesignError> {
    let spread = toleranced(sensor);
    if spread.is_empty() {
        return Err(DesignError::NoTolerance { sensor: sensor.name.clone() });
    }
    let function = |u: &[f64]| {
        let mut mine = sensor.clone();
        spread.iter().zip(u).for_each(|((q, m), &u)| q.set(&mut mine, m.value + m.sd * normal_quantile(u)));
        metrics(&mine, metric_options).map_or([f64::NAN; METRICS.len()], |m| m.0)
    };
    let indices = watched_indices(function, spread.len(), options, watch)?;
    let rows = spread.iter().zip(indices.first).zip(indices.total);
    let quantities = rows.map(|((&(quantity, _), first), total)| QuantityIndices { quantity, first, total }).collect();
    Ok(ToleranceIndices { rows: indices.rows, seed: options.seed, quantities })
}
