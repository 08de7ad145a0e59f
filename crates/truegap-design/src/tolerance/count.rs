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

#[cfg(test)]
mod tests {
    use super::*;
    use crate::{Metric, tolerance::Limit};

    /// 1, 2 and 6 have a variance of 7; their mean is known to the root of 7 / 3.
    #[test]
    fn the_standard_error_is_that_of_the_mean() {
        approx::assert_relative_eq!(standard_error(&[1.0, 2.0, 6.0]).unwrap(), (7.0f64 / 3.0).sqrt(), max_relative = 1e-14);
        assert!(standard_error(&[1.0]).is_none());
    }

    #[test]
    fn a_sensor_whose_plates_touch_is_not_good() {
        let specification = Specification::new(vec![
            Limit::new(Metric::Baseline, 0.0, 1.0).unwrap(),
            Limit::new(Metric::Span, 0.0, 1.0).unwrap(),
        ])
        .unwrap();
        let sensor = |baseline: f64, span: f64| Some(Metrics([baseline, span, 0.0, 0.0, 0.0, 0.0, 0.0]));
        let found = Counts::of(&[None, sensor(0.5, 0.5), sensor(2.0, 0.5), sensor(2.0, 2.0)], &specification);
        let known = Counts { sensors: 4, touching: 1, good: 1, excluded: vec![2, 1], excluded_alone: vec![1, 0] };
        assert_eq!(found, known);
    }
}
