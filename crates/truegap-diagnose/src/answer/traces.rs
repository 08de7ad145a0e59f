//! Columns that a report draws: predictions row by row, maps of the residual, a recovered course.
//!
//! Limits: plain data.

use crate::explain::{hidden_input::slow_input::CourseTrace, locate::Map};
/// Columns that a report draws, one entry a row of the recording.
#[derive(Clone, Debug, Default)]
pub struct Traces {
    /// calibrated base model
    pub before: Vec<f64>,
    /// with the findings
    pub after: Vec<f64>,
    /// standard deviation of one row's noise, input errors included
    pub noise_sd: Vec<f64>,
    /// free-run prediction of rows left out, base model
    pub held_out_before: Vec<f64>,
    /// free-run prediction of rows left out, with the findings
    pub held_out_after: Vec<f64>,
    /// with the flexible term of [`crate::answer::fit_facts::PredictionOnly`]; empty where there is none
    pub flexible: Vec<f64>,
    /// the same of rows left out
    pub held_out_flexible: Vec<f64>,
    /// map of the mean whitened residual before: rows of cells
    pub map_before: Option<Map>,
    /// the same with the findings
    pub map_after: Option<Map>,
    /// course of an input that was hidden on purpose, beside the input itself
    pub course: Option<CourseTrace>,
}
