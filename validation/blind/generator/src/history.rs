//! What is done to the sensor: load, temperature and humidity against time, in runs.
//!
//! Limits: linear between samples; at the start of a run everything that recovers has recovered.

use std::ops::Range;

/// True (noise-free) inputs, one entry a row.
#[derive(Debug, Clone, PartialEq, Default)]
pub struct History {
    /// Run number, from 1.
    pub run: Vec<u32>,
    /// Clock through all runs, s.
    pub time: Vec<f64>,
    /// Load, N.
    pub force: Vec<f64>,
    /// Temperature, degC.
    pub temperature: Vec<f64>,
    /// Relative humidity, %.
    pub humidity: Vec<f64>,
}

impl History {
    /// Number of rows.
    pub fn rows(&self) -> usize {
        self.time.len()
    }

    /// The rows of each run, in order.
    pub fn runs(&self) -> Vec<Range<usize>> {
        let mut runs = Vec::new();
        let mut start = 0;
        for row in 1..=self.rows() {
            if row == self.rows() || self.run[row] != self.run[start] {
                runs.push(start..row);
                start = row;
            }
        }
        runs
    }

    /// Rate of `values` per second by one-sided differences, zero at the first row of each run.
    pub fn rate(&self, values: &[f64]) -> Vec<f64> {
        let mut rate = vec![0.0; values.len()];
        for run in self.runs() {
            for row in run.start + 1..run.end {
                rate[row] = (values[row] - values[row - 1]) / (self.time[row] - self.time[row - 1]);
            }
        }
        rate
    }
}
