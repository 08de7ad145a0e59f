//! Causes that no library of sensor physics holds: what a diagnosis should call unexplained.
//!
//! Limits: all act on the reading; sizes are in pF and set by detectability like those of the library.

pub mod beat;
pub mod bursts;
pub mod converter_ripple;
pub mod force_rate_squared;
pub mod hum;
pub mod random_walk;
pub mod slips;
pub mod telegraph;
pub mod thermal_rate;

/// The largest believable amplitude of a stranger, pF.
const LIMIT_PF: f64 = 1.0;
/// Where the search for the size starts, pF.
const START_PF: f64 = 2e-4;
