//! What a good sensor is: limits on metrics.
//!
//! Limits: one interval a metric; several limits on one metric must all hold.

use crate::{
    error::DesignError,
    metric::{Metric, Metrics},
};
use serde::Serialize;

/// An interval that a metric must lie in, ends included.
#[derive(Clone, Copy, Debug, PartialEq, Serialize)]
pub struct Limit {
    /// which metric
    pub metric: Metric,
    /// least value, minus infinity where there is none
    pub low: f64,
    /// greatest value, infinity where there is none
    pub high: f64,
}

impl Limit {
    /// A limit that something can meet.
    ///
    /// # Errors
    /// [`DesignError::EmptyLimit`] where the ends are in the wrong order or not numbers.
    pub fn new(metric: Metric, low: f64, high: f64) -> Result<Self, DesignError> {
        if low <= high {
            Ok(Self { metric, low, high })
        } else {
            Err(DesignError::EmptyLimit { metric, low, high, unit: metric.unit() })
        }
    }

    /// Whether a sensor keeps it.
    pub fn holds(&self, metrics: &Metrics) -> bool {
        (self.low..=self.high).contains(&metrics.of(self.metric))
    }
}

/// All limits of a data sheet; an empty one is met by every sensor that works.
#[derive(Clone, Debug, Default, PartialEq, Serialize)]
pub struct Specification {
    /// the limits
    pub limits: Vec<Limit>,
}

impl Specification {
    /// Limits that do not exclude each other.
    ///
    /// # Errors
    /// [`DesignError::EmptyLimit`] where two limits on one metric have nothing in common.
    pub fn new(limits: Vec<Limit>) -> Result<Self, DesignError> {
        for a in &limits {
            for b in limits.iter().filter(|b| b.metric == a.metric) {
                Limit::new(a.metric, a.low.max(b.low), a.high.min(b.high))?;
            }
        }
        Ok(Self { limits })
    }

    /// Whether a sensor keeps all limits.
    pub fn holds(&self, metrics: &Metrics) -> bool {
        self.limits.iter().all(|limit| limit.holds(metrics))
    }
}
