//! One parameter, as `diagnosis.json` has it.
//!
//! Limits: plain data.

use serde::Serialize;

/// One parameter after calibration.
#[derive(Clone, Debug, Serialize)]
pub struct ParameterFacts {
    /// name
    pub name: String,
    /// unit
    pub unit: String,
    /// prior: centre and standard deviation
    pub prior: [f64; 2],
    /// most probable value
    pub value: f64,
    /// standard deviation: noise, prior, and what effects too weak to be named or the equations of those that are named may have done to it
    pub sd: f64,
    /// the part of it that noise and prior make where the model is right in every respect; of numbers that are told by least squares, the difference of the two calibrations as well
    pub sd_of_fit: f64,
    /// on a bound
    pub at_limit: bool,
    /// what it is, for a reader
    pub meaning: String,
}
