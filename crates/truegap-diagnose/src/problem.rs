//! A recording set against a simulator: what all later steps share.
//!
//! Limits: immutable; the same rows throughout (rows are left out by weight, so that memory sees the whole history).

use crate::{
    context::Context,
    directions::spread,
    whiten::{InputError, Noise, Whitener},
};
use std::ops::Range;
use truegap_core::{Inputs, Joined, SimulationError, Simulator, Stage};

/// What was done, what was read, and what should have been read.
pub struct Problem<'a> {
    /// inputs, SI
    pub inputs: &'a Inputs,
    /// recorded values, in the simulator's unit
    pub response: &'a [f64],
    /// the base model
    pub simulator: &'a dyn Simulator,
}

/// Standard deviations of the recorded inputs.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct InputNoise {
    /// load, in units of the full load
    pub load: f64,
    /// temperature, K
    pub temperature: f64,
}

impl Problem<'_> {
    /// Runs, as row ranges.
    pub fn runs(&self) -> Vec<Range<usize>> {
        self.inputs.runs()
    }

    /// Range of the response; the widest of one recording where there are several.
    pub fn span(&self) -> f64 {
        let rows = |j: &dyn Joined, k: usize| spread(&self.response[j.rows(k, self.inputs)]);
        self.simulator.joined().map_or_else(|| spread(self.response), |j| (0..j.count()).map(|k| rows(j, k)).fold(0.0, f64::max))
    }

    /// Error that noise of the inputs adds to each row, at parameter values `base`; `left` are the shares of it that quietening left in a row,
    /// `shapes` courses of the error of the load, in full loads, whose weights are not known.
    ///
    /// # Errors
    /// Those of the simulator.
    pub fn input_variance(
        &self,
        base: &[f64],
        noise: &InputNoise,
        left: (&[f64], &[f64]),
        shapes: &[Vec<f64>],
    ) -> Result<InputError, SimulationError> {
        let mut error = InputError::white(vec![0.0; self.inputs.len()]);
        let here = self.simulator.respond(base, self.inputs, &[])?;
        let add = |error: &mut InputError, there: Vec<f64>, ratio: f64, left: &[f64]| {
            for (row, (a, b)) in there.iter().zip(&here).enumerate() {
                let recorded = ((a - b) * ratio).powi(2);
                error.variance[row] += recorded * left[row];
                error.level[row] += recorded;
            }
        };
        if noise.load > 0.0 && self.simulator.full_load().is_some() {
            let step = 1e-3;
            let there = self.simulator.respond(base, self.inputs, &[&Nudge { load: step, kelvin: 0.0 }])?;
            let slope: Vec<f64> = there.iter().zip(&here).map(|(a, b)| (a - b) / step).collect();
            let carried = |shape: &Vec<f64>| shape.iter().zip(&slope).map(|(s, slope)| s * slope).collect();
            error.shapes = shapes.iter().map(carried).collect();
            add(&mut error, there, noise.load / step, left.0);
        }
        if noise.temperature > 0.0 && self.inputs.temperature_c.is_some() {
            let step = 0.1;
            add(
                &mut error,
                self.simulator.respond(base, self.inputs, &[&Nudge { load: 0.0, kelvin: step }])?,
                noise.temperature / step,
                left.1,
            );
        }
        Ok(error)
    }

    /// Facts that effects scale their priors by.
    pub fn context(&self, span: f64, noise_sd: f64) -> Context<'_> {
        let rows = self.response.len().max(1) as f64;
        let response_level = self.response.iter().map(|r| r.abs()).sum::<f64>() / rows;
        Context { response_level, ..Context::new(self.inputs, self.simulator, span, noise_sd) }
    }
}

/// Adds a constant to an input; for derivatives.
struct Nudge {
    load: f64,
    kelvin: f64,
}

impl Stage for Nudge {
    fn load(&self, _: &Inputs, load: &mut [f64]) {
        if self.load != 0.0 {
            load.iter_mut().for_each(|l| *l += self.load);
        }
    }
    fn thermal(&self, _: &Inputs, temperature_c: &mut [f64]) {
        if self.kelvin != 0.0 {
            temperature_c.iter_mut().for_each(|t| *t += self.kelvin);
        }
    }
}

/// The noise of one of several recordings.
#[derive(Clone, Debug)]
pub struct RecordingNoise {
    /// its rows
    pub rows: Range<usize>,
    /// of the response
    pub response: Noise,
    /// of the inputs
    pub inputs: InputNoise,
    /// where it comes from, for a reader
    pub says: String,
}

/// The noise of a problem: of the response, and of the inputs carried through the model.
#[derive(Clone, Debug)]
pub struct NoiseModel {
    /// of the response; of the first recording where there are several
    pub response: Noise,
    /// of the inputs; of the first recording where there are several
    pub inputs: InputNoise,
    /// one a recording, in the order of rows, where there are several; empty for one
    pub recordings: Vec<RecordingNoise>,
    /// error from the inputs, row by row
    pub input_error: InputError,
    /// relative standard deviation of the noise's weight in the mean of many rows
    pub uncertainty: f64,
    /// rows of the recording that each row is the mean of; absent where each is one
    pub weights: Option<Vec<f64>>,
    /// measured apart from the mismatch
    pub measured: bool,
    /// rows that it rests on
    pub rows: usize,
    /// where it comes from, for a reader
    pub says: String,
}

impl NoiseModel {
    /// Filter with the rows that `keep` names.
    pub fn whitener(&self, runs: &[Range<usize>], keep: Option<&[bool]>) -> Whitener {
        let of_run = |run: &Range<usize>| self.response_at(run.start);
        Whitener::by_run(&of_run, &self.input_error, self.weights.as_deref(), runs, keep)
    }

    /// Whether the load bends all the time, so that its error is known by its shape only.
    pub fn bends(&self) -> bool {
        !self.input_error.shapes.is_empty()
    }

    /// The recording that a row belongs to, where there are several.
    fn recording_at(&self, row: usize) -> Option<&RecordingNoise> {
        self.recordings.iter().find(|r| r.rows.contains(&row))
    }

    /// Noise of the response at a row.
    pub fn response_at(&self, row: usize) -> Noise {
        self.recording_at(row).map_or(self.response, |r| r.response)
    }

    /// Noise of the inputs at a row.
    pub fn inputs_at(&self, row: usize) -> InputNoise {
        self.recording_at(row).map_or(self.inputs, |r| r.inputs)
    }

    /// The same noise, `factor` times larger.
    #[must_use]
    pub fn scaled(&self, factor: f64) -> Self {
        self.with_parts_scaled(factor, factor)
    }

    /// The same noise, that of the response `response` times larger and what comes from the inputs `inputs` times.
    #[must_use]
    pub fn with_parts_scaled(&self, response: f64, inputs: f64) -> Self {
        let scaled = |n: Noise| Noise { white_sd: n.white_sd * response, ar_sd: n.ar_sd * response, ..n };
        let recordings = self.recordings.iter().map(|r| RecordingNoise { response: scaled(r.response), ..r.clone() }).collect();
        let scale = |column: &[f64]| column.iter().map(|v| v * inputs * inputs).collect();
        let shape = |shape: &Vec<f64>| shape.iter().map(|v| v * inputs).collect();
        let input_error = InputError {
            variance: scale(&self.input_error.variance),
            level: scale(&self.input_error.level),
            shapes: self.input_error.shapes.iter().map(shape).collect(),
        };
        Self { response: scaled(self.response), recordings, input_error, ..self.clone() }
    }

    /// Variance of one row.
    fn row_variance(&self, row: usize) -> f64 {
        let noise = self.response_at(row);
        noise.white_sd.powi(2) + noise.ar_sd.powi(2) + self.input_error.variance[row]
    }

    /// Standard deviation of one row.
    pub fn row_sd(&self, row: usize) -> f64 {
        self.row_variance(row).sqrt()
    }

    /// Root mean square of one row's noise over some rows.
    pub fn floor_of(&self, rows: Range<usize>) -> f64 {
        let n = rows.len().max(1) as f64;
        (rows.map(|row| self.row_variance(row)).sum::<f64>() / n).sqrt()
    }

    /// Root mean square of one row's noise over all rows.
    pub fn floor(&self) -> f64 {
        self.floor_of(0..self.input_error.variance.len())
    }
}
