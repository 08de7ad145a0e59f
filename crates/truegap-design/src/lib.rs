//! Sensitivity, optimisation and tolerance of sensor designs.
//!
//! Limits: the analytic model only; what a maker can choose or cannot hold is in [`Quantity`], what a data sheet says is in [`Metric`].

pub mod error;
pub mod metric;
pub mod optimise;
pub mod quantity;
pub mod sample;
pub mod sensitivity;
pub mod tolerance;

pub use error::DesignError;
pub use metric::{METRICS, Metric, MetricOptions, Metrics, metrics};
pub use quantity::{QUANTITIES, Quantity};
