//! Several recordings of one physics in one model: which rows and which parameters belong to which recording.
//!
//! Limits: a run belongs to one recording; nothing but parameters and added physics is common to all.

use crate::{inputs::Inputs, simulator::Simulator};
use std::ops::Range;

/// What a [`Simulator`] that joins recordings tells of them.
pub trait Joined: Send + Sync {
    /// Number of recordings.
    fn count(&self) -> usize;
    /// Rows of recording `index`, in order and without a gap.
    fn rows(&self, index: usize, inputs: &Inputs) -> Range<usize>;
    /// What was done in recording `index`: its rows, with the columns that were recorded there, on its own clock.
    fn inputs(&self, index: usize, inputs: &Inputs) -> Inputs;
    /// Model of recording `index` by itself.
    fn model(&self, index: usize) -> &dyn Simulator;
    /// For each parameter of that model, its index among the parameters of the joint model.
    fn places(&self, index: usize) -> &[usize];
    /// Whether recording `index` has parameters that no other recording has.
    fn has_own(&self, index: usize) -> bool {
        let others = |place: &usize| (0..self.count()).any(|k| k != index && self.places(k).contains(place));
        !self.places(index).iter().all(others)
    }
}
