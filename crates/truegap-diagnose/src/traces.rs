//! Columns that a report draws: predictions row by row, maps of the residual, a recovered course.
//!
//! Limits: plain data.

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
    /// with the flexible term of [`crate::diagnosis::PredictionOnly`]; empty where there is none
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

/// A course that was recovered, a value a row.
#[derive(Clone, Debug, Default)]
pub struct CourseTrace {
    /// the course, in `course_unit`
    pub course: Vec<f64>,
    /// its standard deviation
    pub sd: Vec<f64>,
    /// the hidden column, in its own unit
    pub hidden: Vec<f64>,
    /// unit of the course; 1 for a relative gain
    pub course_unit: String,
}

/// Mean residual over noise in cells of load and temperature (or time, where one of them does not change).
#[derive(Clone, Debug)]
pub struct Map {
    /// label of the horizontal axis with unit
    pub x_label: String,
    /// label of the vertical axis with unit
    pub y_label: String,
    /// cell edges
    pub x_edges: Vec<f64>,
    /// cell edges
    pub y_edges: Vec<f64>,
    /// `values[y][x]`, mean residual times sqrt(rows) over noise; NaN where no row fell
    pub values: Vec<Vec<f64>>,
}
