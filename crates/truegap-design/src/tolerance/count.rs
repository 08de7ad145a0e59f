//! Counting good sensors.
//!
//! Limits: standard errors come from independent scrambles, so there is none below two of them (131 072 sensors).

use super::spec::Specification;
use crate::metric::Metrics;
use crate::sample::BATCH;
use serde::{Deserialize, Serialize};

/// How many sensors of a part keep what.
#[derive(Clone, Debug, Default, PartialEq, Eq, Serialize, Deserialize)]
pub struct Counts {
    /// sensors
    pub sensors: usize,
    /// sensors whose plates touch
    pub touching: usize,
    /// sensors that keep every limit
    pub good: usize,
    /// sensors that each limit excludes, in the order of the specification
    pub excluded: Vec<usize>,
    /// sensors that each limit excludes and no other does
    pub excluded_alone: Vec<usize>,
}

impl Counts {
    /// Counts of some sensors.
    pub fn of(sensors: &[Option<Metrics>], specification: &Specification) -> Self {
        let limits = &specification.limits;
        let none = || vec![0; limits.len()];
        let mut counts = Self { sensors: sensors.len(), excluded: none(), excluded_alone: none(), ..Self::default() };
        for sensor in sensors {
            let Some(metrics) = sensor else {
                counts.touching += 1;
                continue;
            };
            let broken: Vec<usize> = (0..limits.len()).filter(|&i| !limits[i].holds(metrics)).collect();
            broken.iter().for_each(|&i| counts.excluded[i] += 1);
            match broken[..] {
                [] => counts.good += 1,
                [only] => counts.excluded_alone[only] += 1,
                _ => {}
            }
        }
        counts
    }
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

impl Yield {
    /// Yield over parts; the standard error comes from those of them that are whole scrambles.
    pub fn of(parts: &[Counts]) -> Self {
        let all: usize = parts.iter().map(|p| p.sensors).sum();
        let share = |count: &dyn Fn(&Counts) -> usize| parts.iter().map(count).sum::<usize>() as f64 / all as f64;
        let limits = parts.first().map_or(0, |p| p.excluded.len());
        let whole = parts.iter().filter(|p| p.sensors == BATCH);
        let shares: Vec<f64> = whole.map(|p| p.good as f64 / BATCH as f64).collect();
        Self {
            share: share(&|p| p.good),
            standard_error: standard_error(&shares),
            touching: share(&|p| p.touching),
            excluded: (0..limits).map(|i| share(&|p| p.excluded[i])).collect(),
            excluded_alone: (0..limits).map(|i| share(&|p| p.excluded_alone[i])).collect(),
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
