//! Every row of a recording beside the rows that are fitted, and those over which errors are taken.
//!
//! Limits: rows that tell nothing are those of the noise under which they were found.

use crate::{data::problem::Problem, whitening::noise_model::tells};
use std::ops::Range;

/// All rows of a recording, and where the rows that are fitted come from.
#[derive(Clone, Copy)]
pub struct AllRows<'a> {
    /// every row
    pub problem: &'a Problem<'a>,
    /// first row that each fitted row is a mean of; absent where every row is fitted
    pub first: Option<&'a [usize]>,
    /// rows over which no error is taken, see [`crate::whitening::noise_model::NoiseModel::untold`]
    pub untold: &'a [Range<usize>],
}

impl AllRows<'_> {
    /// The responses over which errors are taken; NaN elsewhere.
    pub(crate) fn told(&self) -> Vec<f64> {
        let told = |(row, value): (usize, &f64)| if tells(self.untold, row) { *value } else { f64::NAN };
        self.problem.response.iter().enumerate().map(told).collect()
    }
}
