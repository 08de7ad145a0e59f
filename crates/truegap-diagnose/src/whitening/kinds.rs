//! Kinds of noise: stationary noise of a reading, errors of inputs row by row, errors that last over many rows.
//!
//! Limits: correlation runs from row to row, whatever the time between them.

use std::ops::Range;

/// Standard deviations and correlation of the noise on one response, in its unit.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Noise {
    /// white part
    pub white_sd: f64,
    /// stationary standard deviation of the autoregressive part
    pub ar_sd: f64,
    /// correlation of the autoregressive part from row to row
    pub ar_correlation: f64,
}

impl Noise {
    /// Variance of the autoregressive part in the mean of `rows` rows.
    pub(super) fn ar_variance_of_mean(&self, rows: f64) -> f64 {
        let phi = self.ar_correlation;
        let variance = self.ar_sd * self.ar_sd;
        if rows <= 1.0 || variance == 0.0 {
            return variance;
        }
        let decay = 1.0 - phi;
        variance / rows * ((1.0 + phi) / decay - 2.0 * phi * (1.0 - phi.powf(rows)) / (rows * decay * decay))
    }
}

impl Noise {
    /// Correlation of the autoregressive parts of two neighbouring means.
    pub(super) fn ar_correlation_of_means(&self, rows: f64, next: f64) -> f64 {
        let phi = self.ar_correlation;
        let decay = 1.0 - phi;
        let covariance =
            self.ar_sd * self.ar_sd * phi * (1.0 - phi.powf(rows)) * (1.0 - phi.powf(next)) / (decay * decay * rows * next);
        let variances = self.ar_variance_of_mean(rows) * self.ar_variance_of_mean(next);
        if variances > 0.0 { covariance / variances.sqrt() } else { 0.0 }
    }
}

/// Error of the response that errors of the inputs make, row by row.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct InputError {
    /// variance in one row
    pub variance: Vec<f64>,
    /// variance that white noise would have that weighs as much in the mean of many rows; not below `variance`
    pub level: Vec<f64>,
    /// courses that the error follows with a weight not known beforehand, each as large as one standard deviation of that weight makes it
    pub shapes: Vec<Vec<f64>>,
    /// whether the load wanders, so that its error is known by such courses only
    pub wanders: bool,
    /// errors that last over many rows, each a state of the filter
    pub lasting: Vec<Lasting>,
    /// variance of the reading's own noise above its usual one, in rows that are louder; empty where none is
    pub louder: Vec<f64>,
}

impl InputError {
    /// Independent from row to row.
    pub fn white(variance: Vec<f64>) -> Self {
        Self { level: variance.clone(), variance, ..Self::default() }
    }

    /// Variance of one row, all parts but those that a stationary noise of the reading has.
    pub fn row_variance(&self, row: usize) -> f64 {
        let lasting = self.lasting.iter().map(|l| l.variance[row]).sum::<f64>();
        self.variance[row] + lasting + self.louder.get(row).copied().unwrap_or(0.0)
    }

    /// Error in the mean of `rows` rows: its variance, and its correlation with the next mean as memory and length have it.
    pub(super) fn of_mean(&self, row: usize, rows: f64) -> Noise {
        let (variance, level) = (self.variance[row], self.level[row].max(self.variance[row]));
        let correlation = if variance > 0.0 { (level - variance) / (level + variance) } else { 0.0 };
        Noise {
            white_sd: 0.0,
            ar_sd: Noise { white_sd: 0.0, ar_sd: variance.sqrt(), ar_correlation: correlation }.ar_variance_of_mean(rows).sqrt(),
            ar_correlation: correlation.powf(rows),
        }
    }
}

/// An error that lasts: that of a column written down in steps as long as it stays on one value, or a part of slow noise.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Lasting {
    /// variance in one row
    pub variance: Vec<f64>,
    /// correlation with the row before; 0 where a column has jumped
    pub memory: Vec<f64>,
    /// whether it is the reading's own, not that of an input
    pub of_reading: bool,
}

impl Lasting {
    /// The error in means of rows: `first` are the first rows of each.
    #[must_use]
    pub fn of_means(&self, first: &[usize]) -> Self {
        let end = |i: usize| first.get(i + 1).copied().unwrap_or(self.variance.len());
        let mean = |i: usize| {
            let (rows, memory) = (first[i]..end(i), self.within(first[i] + 1..end(i)));
            let variance = self.variance[rows.clone()].iter().sum::<f64>() / rows.len() as f64;
            let one = Noise { white_sd: 0.0, ar_sd: variance.sqrt(), ar_correlation: memory.min(0.999_999) };
            one.ar_variance_of_mean(rows.len() as f64)
        };
        // from middle to middle
        let memory = |i: usize| match i {
            0 => 0.0,
            _ => {
                let (here, before) = ((end(i) - first[i]) as f64, (first[i] - first[i - 1]) as f64);
                let within = self.within(first[i - 1] + 1..first[i]).powf(0.5 * (before - 1.0));
                self.memory[first[i]] * within * self.within(first[i] + 1..end(i)).powf(0.5 * (here - 1.0))
            }
        };
        let (variance, memory) = ((0..first.len()).map(mean).collect(), (0..first.len()).map(memory).collect());
        Self { variance, memory, of_reading: self.of_reading }
    }

    /// Geometric mean of the memory over some rows; 1 of none.
    fn within(&self, rows: Range<usize>) -> f64 {
        let n = rows.len().max(1) as f64;
        self.memory[rows].iter().map(|m| m.max(1e-12).ln() / n).sum::<f64>().exp()
    }
}
