//! A recording set against a simulator: what all later steps share.
//!
//! Limits: immutable; the same rows throughout (rows are left out by weight, so that memory sees the whole history).

use crate::{
    data::{context::Context, moved::Moved},
    stats::spread,
};
use std::ops::Range;
use truegap_core::{Inputs, Joined, Simulator};

/// What was done, what was read, and what should have been read.
pub struct Problem<'a> {
    /// inputs, SI
    pub inputs: &'a Inputs,
    /// recorded values, in the simulator's unit
    pub response: &'a [f64],
    /// the base model
    pub simulator: &'a dyn Simulator,
}

impl Problem<'_> {
    /// Runs, as row ranges.
    pub fn runs(&self) -> Vec<Range<usize>> {
        self.inputs.runs()
    }

    /// Whether it is of one recording, with a clock.
    pub(crate) fn is_one_with_a_clock(&self) -> bool {
        self.simulator.joined().is_none() && self.inputs.time_s.is_some()
    }

    /// The runs of each recording.
    pub fn runs_of_recordings(&self) -> Vec<Vec<Range<usize>>> {
        let runs = self.runs();
        let inside = |rows: Range<usize>| runs.iter().filter(|run| rows.contains(&run.start)).cloned().collect();
        match self.simulator.joined() {
            Some(joined) => (0..joined.count()).map(|k| inside(joined.rows(k, self.inputs))).collect(),
            None => vec![runs],
        }
    }

    /// The runs in which rows that follow one another belong together: all of them, or none where no clock says so and inputs that move were written in any order.
    pub fn runs_in_order(&self) -> Vec<Range<usize>> {
        let follow = self.inputs.time_s.is_some() || !Moved::of(self.inputs, self.simulator).anything();
        if follow { self.runs() } else { Vec::new() }
    }

    /// Range of the response; the widest of one recording where there are several.
    pub fn span(&self) -> f64 {
        let rows = |j: &dyn Joined, k: usize| spread(&self.response[j.rows(k, self.inputs)]);
        self.simulator.joined().map_or_else(|| spread(self.response), |j| (0..j.count()).map(|k| rows(j, k)).fold(0.0, f64::max))
    }

    /// Facts that effects scale their priors by.
    pub fn context(&self, span: f64, noise_sd: f64) -> Context<'_> {
        let rows = self.response.len().max(1) as f64;
        let response_level = self.response.iter().map(|r| r.abs()).sum::<f64>() / rows;
        Context { response_level, ..Context::new(self.inputs, self.simulator, span, noise_sd) }
    }
}
