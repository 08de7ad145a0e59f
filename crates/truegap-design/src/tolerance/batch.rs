//! A batch of sensors and its scatter.
//!
//! Limits: all of it in memory, 56 bytes a sensor; larger ones by [`part`] and [`Summary`](super::Summary).

use super::count::{Counts, Yield};
use super::spec::Specification;
use crate::sample::{BATCH, normal_quantile, uniform};
use crate::{
    error::DesignError,
    metric::{METRICS, Metric, Metrics},
    metrics::{MetricOptions, metrics},
    quantity::{QUANTITIES, Quantity},
};
use rayon::prelude::*;
use serde::Serialize;
use std::ops::Range;
use truegap_core::{Sensor, units::Measure};

/// How many sensors, and which.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct BatchOptions {
    /// metrics
    pub metrics: MetricOptions,
    /// number of sensors
    pub samples: usize,
    /// seed; the same seed gives the same sensors for any number of threads
    pub seed: u64,
}

impl Default for BatchOptions {
    fn default() -> Self {
        Self { metrics: MetricOptions::default(), samples: 1_000_000, seed: 1 }
    }
}

/// Sensors drawn from the tolerances; `None` where the plates touch.
#[derive(Clone, Debug)]
pub struct Batch {
    sensors: Vec<Option<Metrics>>,
}

/// Scatter of one metric.
#[derive(Clone, Debug, PartialEq, Serialize)]
pub struct Scatter {
    /// which metric
    pub metric: Metric,
    /// mean
    pub mean: f64,
    /// standard deviation
    pub sd: f64,
    /// standard deviation in per cent of the size of the mean
    pub sd_pct: f64,
    /// below which [`PROBABILITIES`] of all sensors lie
    pub quantiles: Vec<f64>,
}

/// Shares of all sensors for which quantiles are given.
pub const PROBABILITIES: [f64; 21] = [
    0.001_35, 0.005, 0.01, 0.025, 0.05, 0.1, 0.15, 0.2, 0.3, 0.4, 0.5, 0.6, 0.7, 0.8, 0.85, 0.9, 0.95, 0.975, 0.99, 0.995,
    0.998_65,
];

impl Scatter {
    /// Quantile of one of [`PROBABILITIES`]; `None` for any other.
    pub fn quantile(&self, probability: f64) -> Option<f64> {
        let place = PROBABILITIES.iter().position(|&p| p == probability)?;
        self.quantiles.get(place).copied()
    }
}

/// Quantities with a spread.
pub(crate) fn toleranced(sensor: &Sensor) -> Vec<(Quantity, Measure)> {
    QUANTITIES.into_iter().filter_map(|q| Some((q, q.of(sensor)?))).filter(|(_, measure)| measure.sd > 0.0).collect()
}

/// Draws the sensors of a batch.
///
/// # Errors
/// [`DesignError::NoTolerance`], [`DesignError::TooFewSamples`].
pub fn batch(sensor: &Sensor, options: BatchOptions) -> Result<Batch, DesignError> {
    part(sensor, options, 0..options.samples)
}

/// Draws some of the sensors of a batch: those at these places in the order of drawing. Parts that begin at multiples of [`BATCH`](crate::sample::BATCH) are
/// independent of each other.
///
/// # Errors
/// As [`batch`].
pub fn part(sensor: &Sensor, options: BatchOptions, points: Range<usize>) -> Result<Batch, DesignError> {
    let spread = toleranced(sensor);
    if spread.is_empty() {
        return Err(DesignError::NoTolerance { sensor: sensor.name.clone() });
    }
    if options.samples < 16 {
        return Err(DesignError::TooFewSamples { samples: options.samples, least: 16 });
    }
    let made = |mine: &mut Sensor, point: usize| {
        for (dimension, (quantity, measure)) in spread.iter().enumerate() {
            quantity.set(mine, measure.value + measure.sd * normal_quantile(uniform(options.seed, point, dimension)));
        }
        metrics(mine, options.metrics).ok()
    };
    let sensors = points.into_par_iter().with_min_len(256).map_init(|| sensor.clone(), made).collect();
    Ok(Batch { sensors })
}

impl Batch {
    /// Metrics of every sensor in the order of drawing; `None` where the plates touch.
    pub fn sensors(&self) -> &[Option<Metrics>] {
        &self.sensors
    }

    /// Scatter of every metric over the sensors that work; empty where none does.
    pub fn scatter(&self) -> Vec<Scatter> {
        METRICS.into_par_iter().filter_map(|metric| self.scatter_of(metric)).collect()
    }

    fn scatter_of(&self, metric: Metric) -> Option<Scatter> {
        let mut values: Vec<f64> = self.sensors.iter().flatten().map(|m| m.of(metric)).collect();
        values.sort_unstable_by(f64::total_cmp);
        let last = values.len().checked_sub(1)?;
        let count = values.len() as f64;
        let mean = values.iter().sum::<f64>() / count;
        let sd = (values.iter().map(|v| (v - mean).powi(2)).sum::<f64>() / count).sqrt();
        let quantiles = PROBABILITIES.iter().map(|p| values[(p * last as f64).round() as usize]).collect();
        Some(Scatter { metric, mean, sd, sd_pct: 100.0 * sd / mean.abs(), quantiles })
    }

    /// Share of sensors that keep a specification.
    pub fn yield_of(&self, specification: &Specification) -> Yield {
        let parts: Vec<Counts> = self.sensors.chunks(BATCH).map(|part| Counts::of(part, specification)).collect();
        Yield::of(&parts)
    }
}
