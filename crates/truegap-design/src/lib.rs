//! Sensitivity, optimisation and tolerance of sensor designs.
//!
//! | question | where |
//! |---|---|
//! | What does a data sheet say of this sensor? | [`metrics`], one [`Metric`] a number |
//! | How much does each [`Quantity`] matter? | [`sensitivity`] |
//! | How do sensors of a batch scatter, and which share is good? | [`tolerance`] |
//! | Which designs have smaller temperature coefficients? | [`optimise`] |
//!
//! Limits: the analytic model only; what a maker can choose or cannot hold is in [`Quantity`].
//!
//! # Example
//!
//! Which quantity moves the baseline of a built-in sensor most, if each is 10 % off, and what its drawn tolerances make of the batch:
//!
//! ```
//! use truegap_core::sensor::builtin_sensor;
//! use truegap_design::sensitivity::{PAPER_QUANTITIES, one_at_a_time, ranked};
//! use truegap_design::tolerance::{BatchOptions, batch};
//! use truegap_design::{Metric, MetricOptions, Quantity, metrics};
//!
//! let sensor = builtin_sensor("singletact-s15-4.5n").ok_or("no such sensor")??;
//! let options = MetricOptions::default(); // 20 and 50 degrees Celsius
//! let baseline = metrics(&sensor, options)?.of(Metric::Baseline);
//!
//! let rows = one_at_a_time(&sensor, &PAPER_QUANTITIES, 0.1, options)?;
//! let (first, change) = ranked(&rows, Metric::Baseline)[0];
//! println!("{first} moves the baseline of {baseline:.1} pF by up to {change:.1} pF");
//! assert_eq!(first, Quantity::Diameter);
//!
//! let made = batch(&sensor, BatchOptions { samples: 2000, ..BatchOptions::default() })?;
//! let scatter = &made.scatter()[Metric::Baseline as usize];
//! println!("{} {} +- {} {}", scatter.metric, scatter.mean, scatter.sd, scatter.metric.unit());
//! assert!(scatter.sd > 0.0 && scatter.sd < 0.2 * baseline);
//! # Ok::<(), Box<dyn std::error::Error>>(())
//! ```

#![warn(unreachable_pub)]

mod error;
mod metric;
mod metrics;
pub mod optimise;
mod quantity;
mod sample;
pub mod sensitivity;
pub mod tolerance;

pub use error::DesignError;
pub use metric::{METRICS, Metric, Metrics};
pub use metrics::{MetricOptions, metrics};
pub use quantity::{QUANTITIES, Quantity};
