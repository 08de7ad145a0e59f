//! How long a change may take, and at how many times it is looked for.

use crate::data::context::Context;

/// Longest that a change may take, as a share of the recording: what takes longer is a drift, and nothing was switched. With a seventh, noise like 1/f was followed by it.
const LONGEST: f64 = 0.05;
/// The same of a zero that jumps while what moves goes one way: what takes longer is a bend of that way.
const LONGEST_JUMP: f64 = 0.02;
/// Times at which a change is looked for to begin with, and a jump, which takes less.
const LOOKED_AT: usize = 16;
const LOOKED_AT_FOR_JUMPS: usize = 48;
/// Share of the longest time from which on a change has run to that limit.
const AS_LONG_AS_IT_MAY: f64 = 0.99;

/// Length over which a change can be looked for: seconds, or rows without a clock.
pub(super) fn length(context: &Context<'_>) -> f64 {
    if context.shortest_step_s.is_some() { context.length_s() } else { context.inputs.len() as f64 }
}

/// How long a change may take, in the unit of [`length`].
pub(super) struct Extent {
    /// a row
    pub(super) shortest: f64,
    /// times at which it is looked for
    pub(super) times: usize,
    /// longest that a change may take, as a share of the recording
    share: f64,
    length: f64,
}

impl Extent {
    /// Of a zero that `jumps`, else of any change.
    pub(super) fn of(jumps: bool, context: &Context<'_>) -> Self {
        let length = length(context);
        let (share, times) = if jumps { (LONGEST_JUMP, LOOKED_AT_FOR_JUMPS) } else { (LONGEST, LOOKED_AT) };
        Self { shortest: context.step_s().min(0.01 * length), times, share, length }
    }

    /// Time that a change usually takes.
    pub(super) fn usual(&self) -> f64 {
        (0.4 * self.share * self.length).max(self.shortest)
    }

    /// Limit of the time that it takes: where rows are few, two of them.
    pub(super) fn limit(&self) -> f64 {
        (self.share * self.length).max(2.0 * self.shortest)
    }

    /// Whether a change that takes so long is a moment: what takes as long as it may is none, and other rows foretell how it goes on.
    pub(super) fn is_a_moment(&self, takes: f64) -> bool {
        takes < AS_LONG_AS_IT_MAY * self.limit()
    }

    /// Time that a change takes where it is looked for: as long as from one of the times to the next, so that it is found from afar, or the longest.
    pub(super) fn looked_for(&self) -> f64 {
        (self.length / self.times as f64).min(self.share * self.length)
    }
}
