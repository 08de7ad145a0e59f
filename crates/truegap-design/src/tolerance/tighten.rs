//! Which tolerance to tighten first: the same sensors once more, with one spread halved.
//!
//! Limits: one tolerance at a time; the gain is a difference on the same random numbers, so small gains are seen as well.

use super::{
    batch::{BatchOptions, Scatter, batch, toleranced},
    count::Yield,
    spec::Specification,
};
use crate::{error::DesignError, metric::METRICS, quantity::Quantity};
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
    let numbers = |sensor: &Sensor| -> Result<_, DesignError> {
        let made = batch(sensor, options)?;
        Ok((made.scatter(), made.yield_of(specification)))
    };
    let before = numbers(sensor)?;
    let rows = tolerances(sensor).into_iter().map(|quantity| {
        let (scatter, good) = numbers(&halved(sensor, quantity))?;
        Ok(Tightened::new(quantity, (&before.0, &before.1), (&scatter, &good)))
    });
    Ok(rank(rows.collect::<Result<_, DesignError>>()?))
}

impl Tightened {
    /// What scatter and yield say before and after; both from the same random numbers.
    pub fn new(quantity: Quantity, before: (&[Scatter], &Yield), after: (&[Scatter], &Yield)) -> Self {
        let mut scatter_falls_pct = [0.0; METRICS.len()];
        for ((fall, old), new) in scatter_falls_pct.iter_mut().zip(before.0).zip(after.0) {
            *fall = 100.0 * (1.0 - new.sd / old.sd);
        }
        Self { quantity, share: after.1.share, gain: after.1.share - before.1.share, scatter_falls_pct }
    }
}

/// The first to tighten first.
pub fn rank(mut rows: Vec<Tightened>) -> Vec<Tightened> {
    let mean = |row: &Tightened| row.scatter_falls_pct.iter().sum::<f64>();
    rows.sort_by(|a, b| b.gain.total_cmp(&a.gain).then(mean(b).total_cmp(&mean(a))));
    rows
}

/// Quantities of a sensor that have a tolerance.
pub fn tolerances(sensor: &Sensor) -> Vec<Quantity> {
    toleranced(sensor).into_iter().map(|(quantity, _)| quantity).collect()
}

/// The sensor with one spread halved.
pub fn halved(sensor: &Sensor, quantity: Quantity) -> Sensor {
    let mut sensor = sensor.clone();
    if let Some(measure) = quantity.of(&sensor) {
        quantity.set_spread(&mut sensor, 0.5 * measure.sd);
    }
    sensor
}
