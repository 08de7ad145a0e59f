//! Which tolerance to tighten first: the same sensors once more, with one spread halved.
//!
//! Limits: one tolerance at a time; the gain is a difference on the same random numbers, so small gains are seen as well.

use super::{BatchOptions, Specification, batch};
use crate::{DesignError, METRICS, Quantity};
use serde::Serialize;
use truegap_core::Sensor;

/// What halving one tolerance does.
#[derive(Clone, Debug, PartialEq, Serialize)]
pub struct Tightened {
    /// the quantity whose spread is halved
    pub quantity: Quantity,
    /// yield after that
    pub share: f64,
    /// yield gained
    pub gain: f64,
    /// by how many per cent the standard deviation of each metric falls, in the order of [`METRICS`]
    pub scatter_falls_pct: [f64; METRICS.len()],
}

/// Every tolerance halved in turn, the largest gain in yield first; without limits, the largest mean fall of the scatter first.
///
/// # Errors
/// As [`batch`].
pub fn tighten(sensor: &Sensor, specification: &Specification, options: BatchOptions) -> Result<Vec<Tightened>, DesignError> {
    let before = batch(sensor, options)?;
    let (share, scatter) = (before.yield_of(specification).share, before.scatter());
    let mut rows = Vec::new();
    for (quantity, _) in super::toleranced(sensor) {
        let after = batch(&halved(sensor, quantity), options)?;
        let now = after.yield_of(specification).share;
        let mut falls = [0.0; METRICS.len()];
        for ((fall, old), new) in falls.iter_mut().zip(&scatter).zip(after.scatter()) {
            *fall = 100.0 * (1.0 - new.sd / old.sd);
        }
        rows.push(Tightened { quantity, share: now, gain: now - share, scatter_falls_pct: falls });
    }
    let mean = |row: &Tightened| row.scatter_falls_pct.iter().sum::<f64>();
    rows.sort_by(|a, b| b.gain.total_cmp(&a.gain).then(mean(b).total_cmp(&mean(a))));
    Ok(rows)
}

/// The sensor with one spread halved.
fn halved(sensor: &Sensor, quantity: Quantity) -> Sensor {
    let mut sensor = sensor.clone();
    if let Some(measure) = quantity.of(&sensor) {
        quantity.set_spread(&mut sensor, 0.5 * measure.sd);
    }
    sensor
}
