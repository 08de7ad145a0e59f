//! What the analytic model says: sensors by name, points and histories, coefficients, and the paper's formulas as printed.
//!
//! ```
//! use truegap::predict::{DEFAULT_SENSOR, axis, coefficients, find_sensor, grid, simulate};
//!
//! let sensor = find_sensor(DEFAULT_SENSOR, None)?; // or the path of a sensor file
//! let forces_n = axis::values("0:4.5 N:4", truegap::core::Dimension::Force)?;
//! let states = simulate(&sensor, Default::default(), &grid(&forces_n, &[20.0, 40.0]))?;
//! assert_eq!(states.len(), 8);
//! assert!(states.iter().all(|state| state.c_total_pf > 0.0));
//! println!("{:?}", coefficients(&sensor, Default::default())?);
//! # Ok::<(), Box<dyn std::error::Error>>(())
//! ```

pub mod axis;
mod printed;
mod sensors;
mod states;

pub use printed::{Planes, Strains, planes, strains};
pub use sensors::{DEFAULT_SENSOR, FindSensorError, find_sensor, sensor_names};
pub use states::{Driven, PredictError, check_points, coefficients, drive, grid, simulate};
