//! Sobol indices of the metrics over a sensor's tolerances.
//!
//! Limits: independent normal tolerances, as in a batch.

use super::sobol::{Index, SobolOptions, watched_indices};
use crate::sample::normal_quantile;
use crate::tolerance::toleranced;
use crate::{DesignError, METRICS, MetricOptions, Quantity, metrics};
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

/// Indices of every quantity that has a tolerance; `watch` as in [`watched_indices`].
///
/// # Errors
/// [`DesignError::NoTolerance`]; otherwise as [`watched_indices`].
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
