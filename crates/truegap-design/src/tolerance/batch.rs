//! A batch of sensors, its scatter and its yield.
//!
//! Limits: standard errors come from independent scrambles, so there is none below two of them (131 072 sensors).

use super::Specification;
use crate::sample::{BATCH, normal_quantile, uniform};
use crate::{DesignError, METRICS, Metric, MetricOptions, Metrics, QUANTITIES, Quantity, metrics};
use rayon::prelude::*;
use serde::Serialize;
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
#[derive(Clone, Copy, Debug, PartialEq, Serialize)]
pub struct Scatter {
    /// which metric
    pub metric: Metric,
    /// mean
    pub mean: f64,
    /// standard deviation
    pub sd: f64,
    /// standard deviation in per cent of the size of the mean
    pub sd_pct: f64,
    /// 0.135, 2.5, 50, 97.5 and 99.865 % of all sensors lie below
    pub quantiles: [f64; 5],
}

/// Share of good sensors.
#[derive(Clone, Debug, PartialEq, Serialize)]
pub struct Yield {
    /// share of all sensors that keeps every limit
    pub share: f64,
    /// standard error of the share from independent scrambles; `None` for fewer than two
    pub standard_error: Option<f64>,
    /// share of sensors whose plates touch
    pub touching: f64,
    /// share of all sensors that each limit excludes, in the order of the specification
    pub excluded: Vec<f64>,
    /// share of all sensors that each limit excludes and no other does
    pub excluded_alone: Vec<f64>,
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
    let sensors = (0..options.samples).into_par_iter().with_min_len(256).map_init(|| sensor.clone(), made).collect();
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
        let quantiles = [0.001_35, 0.025, 0.5, 0.975, 0.998_65].map(|p| values[(p * last as f64).round() as usize]);
        Some(Scatter { metric, mean, sd, sd_pct: 100.0 * sd / mean.abs(), quantiles })
    }

    /// Share of sensors that keep a specification.
    pub fn yield_of(&self, specification: &Specification) -> Yield {
        let limits = &specification.limits;
        let (mut excluded, mut alone) = (vec![0usize; limits.len()], vec![0usize; limits.len()]);
        for metrics in self.sensors.iter().flatten() {
            let broken: Vec<usize> = (0..limits.len()).filter(|&i| !limits[i].holds(metrics)).collect();
            broken.iter().for_each(|&i| excluded[i] += 1);
            if let [only] = broken[..] {
                alone[only] += 1;
            }
        }
        let share = |count: usize| count as f64 / self.sensors.len() as f64;
        let good = |part: &[Option<Metrics>]| part.iter().flatten().filter(|m| specification.holds(m)).count();
        let parts: Vec<f64> = self.sensors.chunks_exact(BATCH).map(|part| good(part) as f64 / BATCH as f64).collect();
        Yield {
            share: share(good(&self.sensors)),
            standard_error: standard_error(&parts),
            touching: share(self.sensors.iter().filter(|s| s.is_none()).count()),
            excluded: excluded.into_iter().map(share).collect(),
            excluded_alone: alone.into_iter().map(share).collect(),
        }
    }
}

/// Standard error of the mean of independent estimates.
fn standard_error(parts: &[f64]) -> Option<f64> {
    let count = parts.len() as f64;
    let mean = parts.iter().sum::<f64>() / count;
    let square = parts.iter().map(|p| (p - mean).powi(2)).sum::<f64>();
    (parts.len() > 1).then(|| (square / (count - 1.0) / count).sqrt())
}
