//! The noise of a recording: of the response, and of the inputs carried through the model, row by row.
//!
//! Limits: says what the noise is, not where it comes from (`crate::noise`).

use crate::whitening::whitener::{InputError, Lasting, Noise, Whitener};
use std::ops::Range;

/// Standard deviations of the recorded inputs.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct InputNoise {
    /// load, in units of the full load
    pub load: f64,
    /// temperature, K
    pub temperature: f64,
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

/// Whether a row tells something of a model: it is in none of these ranges.
pub(crate) fn tells(untold: &[Range<usize>], row: usize) -> bool {
    !untold.iter().any(|rows| rows.contains(&row))
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
    /// step that the reading is written in, where its noise does not hide it; else 0
    pub step: f64,
    /// relative standard deviation of the noise's weight in the mean of many rows
    pub uncertainty: f64,
    /// rows of the recording that each row is the mean of; absent where each is one
    pub weights: Option<Vec<f64>>,
    /// rows that tell nothing of a model, see [`crate::noise::beyond_the_ends`]: no error is taken over them
    pub untold: Vec<Range<usize>>,
    /// measured apart from the mismatch
    pub measured: bool,
    /// rows that it rests on
    pub rows: usize,
    /// where it comes from, for a reader
    pub says: String,
}

impl NoiseModel {
    /// One that nobody measured, of as many rows as the input error has.
    #[cfg(test)]
    pub(crate) fn unmeasured(response: Noise, input_error: InputError) -> Self {
        Self {
            response,
            inputs: InputNoise::default(),
            recordings: Vec::new(),
            rows: input_error.variance.len(),
            input_error,
            step: 0.0,
            uncertainty: 0.25,
            weights: None,
            untold: Vec::new(),
            measured: false,
            says: String::new(),
        }
    }

    /// Filter with the rows that `keep` names.
    pub fn whitener(&self, runs: &[Range<usize>], keep: Option<&[bool]>) -> Whitener {
        let of_run = |run: &Range<usize>| self.response_at(run.start);
        Whitener::by_run(&of_run, &self.input_error, self.weights.as_deref(), runs, keep)
    }

    /// Root mean square, in noise of a row, that rows may have by the steps of the reading alone: half a step in each.
    pub(crate) fn burst_of_steps(&self) -> f64 {
        if self.step > 0.0 { 0.5 * self.step / self.response.white_sd } else { 0.0 }
    }

    /// Amplitude, in noise of a row of the filter, that a line may have by the steps of the reading alone: a reading that moves evenly errs as a sawtooth does, whose first harmonic has the
    /// amplitude of a step over pi (Widrow and Kollar, Quantization Noise (2008), section 4.1).
    pub(crate) fn line_of_steps(&self) -> f64 {
        if self.step <= 0.0 {
            return 0.0;
        }
        let mean = |weights: &Vec<f64>| weights.iter().sum::<f64>() / weights.len().max(1) as f64;
        self.step / (std::f64::consts::PI * self.response.white_sd) * self.weights.as_ref().map_or(1.0, mean).sqrt()
    }

    /// Why errors that are smaller by next to nothing prove nothing.
    pub(crate) fn does_as_much(&self) -> &'static str {
        match self.measured && self.step > 0.0 {
            true => "the steps of the reading do as much",
            false => "the noise was not measured, and one that lasts does as much",
        }
    }

    /// Whether the load wanders, so that its error is known by its shape only.
    pub fn load_wanders(&self) -> bool {
        self.input_error.wanders
    }

    /// Whether part of the reading's own noise lasts: slow noise, or steps of its converter.
    pub fn lasts(&self) -> bool {
        self.input_error.lasting.iter().any(|lasting| lasting.of_reading)
    }

    /// Standard deviation of the part of the reading's own noise that lasts: root of its mean variance over the rows; 0 where none does.
    pub fn lasting_sd(&self) -> f64 {
        let own = self.input_error.lasting.iter().filter(|lasting| lasting.of_reading);
        // the sum of nothing would be minus zero
        own.map(|l| l.variance.iter().sum::<f64>() / l.variance.len().max(1) as f64).fold(0.0, |all, one| all + one).sqrt()
    }

    /// A misfit whose louder rows are lowered to what they would be without what makes them louder.
    pub(crate) fn with_rows_alike(&self, misfit: &[f64]) -> Vec<f64> {
        let of = |(row, misfit): (usize, &f64)| {
            let (noise, louder) = (self.response_at(row), self.input_error.louder.get(row).copied().unwrap_or(0.0));
            let usual = noise.white_sd.powi(2) + noise.ar_sd.powi(2);
            if louder > 0.0 { misfit * (usual / (usual + louder)).sqrt() } else { *misfit }
        };
        misfit.iter().enumerate().map(of).collect()
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
        let lasting = |lasting: &Lasting| {
            let factor = if lasting.of_reading { response } else { inputs };
            Lasting { variance: lasting.variance.iter().map(|v| v * factor * factor).collect(), ..lasting.clone() }
        };
        let input_error = InputError {
            variance: scale(&self.input_error.variance),
            level: scale(&self.input_error.level),
            shapes: self.input_error.shapes.iter().map(shape).collect(),
            wanders: self.input_error.wanders,
            lasting: self.input_error.lasting.iter().map(lasting).collect(),
            louder: self.input_error.louder.iter().map(|v| v * response * response).collect(),
        };
        Self { response: scaled(self.response), recordings, input_error, ..self.clone() }
    }

    /// Variance of one row.
    fn row_variance(&self, row: usize) -> f64 {
        let noise = self.response_at(row);
        noise.white_sd.powi(2) + noise.ar_sd.powi(2) + self.input_error.row_variance(row)
    }

    /// Standard deviation of one row; of one that tells nothing, that of the reading.
    pub fn row_sd(&self, row: usize) -> f64 {
        let noise = self.response_at(row);
        if tells(&self.untold, row) { self.row_variance(row).sqrt() } else { noise.white_sd.hypot(noise.ar_sd) }
    }

    /// Root mean square of one row's noise over some rows, those that tell something.
    pub fn floor_of(&self, rows: Range<usize>) -> f64 {
        let told: Vec<f64> = rows.filter(|row| tells(&self.untold, *row)).map(|row| self.row_variance(row)).collect();
        (told.iter().sum::<f64>() / told.len().max(1) as f64).sqrt()
    }

    /// Root mean square of one row's noise over all rows.
    pub fn floor(&self) -> f64 {
        self.floor_of(0..self.input_error.variance.len())
    }
}
