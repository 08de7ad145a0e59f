//! The parts of the noise, each a state of the filter: how large it is in a row, and how it goes on into the next.
//!
//! Limits: correlation runs from row to row.

use crate::whitening::kinds::{InputError, Lasting, Noise};

/// How one part of the noise goes on into the next row.
#[derive(Clone, Copy)]
pub(super) struct Part {
    /// factor from here to there
    pub(super) carry: f64,
    /// variance that is new there
    pub(super) fresh: f64,
}

/// The parts of the noise: of the response, of denoised inputs, and those that last.
pub(super) struct Parts<'a> {
    pub(super) input: &'a InputError,
    pub(super) weights: Option<&'a [f64]>,
}

impl Parts<'_> {
    pub(super) fn count(&self) -> usize {
        2 + self.input.lasting.len()
    }

    pub(super) fn weight(&self, row: usize) -> f64 {
        self.weights.map_or(1.0, |w| w[row])
    }

    /// Part `k` in a row that is followed by another.
    pub(super) fn part(&self, noise: &Noise, k: usize, row: usize) -> Part {
        let (weight, next) = (self.weight(row), self.weight(row + 1));
        match k {
            0 => self.of_response(noise, weight, next),
            1 => self.of_inputs(row, weight, next),
            _ => {
                let Lasting { variance, memory, .. } = &self.input.lasting[k - 2];
                let (here, there, memory) = (variance[row], variance[row + 1], memory[row + 1]);
                let carried = if here > 0.0 { memory } else { 0.0 };
                let ratio = if here > 0.0 { there / here } else { 0.0 };
                Part { carry: carried * ratio.sqrt(), fresh: (1.0 - carried * carried) * there }
            }
        }
    }

    /// Variance of part `k` in the first row of a run.
    pub(super) fn first(&self, noise: &Noise, k: usize, row: usize) -> f64 {
        match k {
            0 => noise.ar_variance_of_mean(self.weight(row)),
            1 => self.input.of_mean(row, self.weight(row)).ar_sd.powi(2),
            _ => self.input.lasting[k - 2].variance[row],
        }
    }

    fn of_response(&self, noise: &Noise, weight: f64, next: f64) -> Part {
        let (here, there) = (noise.ar_variance_of_mean(weight), noise.ar_variance_of_mean(next));
        let phi = noise.ar_correlation_of_means(weight, next);
        let ratio = if here > 0.0 { there / here } else { 0.0 };
        Part { carry: phi * ratio.sqrt(), fresh: (1.0 - phi * phi) * there }
    }

    fn of_inputs(&self, row: usize, weight: f64, next: f64) -> Part {
        let (now, then) = (self.input.of_mean(row, weight), self.input.of_mean(row + 1, next));
        // a line ends where the next row has less memory
        let memory = now.ar_correlation.min(then.ar_correlation);
        let ratio = if now.ar_sd > 0.0 { then.ar_sd / now.ar_sd } else { 0.0 };
        let fresh = if now.ar_sd > 0.0 { (1.0 - memory * memory) * then.ar_sd.powi(2) } else { then.ar_sd.powi(2) };
        Part { carry: memory * ratio, fresh }
    }
}
