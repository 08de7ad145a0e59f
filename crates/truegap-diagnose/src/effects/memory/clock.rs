//! The steps of a clock as lags ask for them: a few that come again, or one of its own in most rows.
//!
//! Limits: steps that differ by less than a billionth are one step.

use std::{cell::RefCell, collections::VecDeque, rc::Rc};
use truegap_core::{Inputs, asked_last, same_column};

/// Steps that differ by less than this share are one step: a clock in tenths of a second has steps that differ in their last digits.
const SAME_STEP: f64 = 1e-9;

/// Most steps that are known at a time.
pub(super) const KEPT: usize = 8;

/// Clocks that a thread remembers: that of a recording, and those of its rows without the ones left out.
const CLOCKS: usize = 8;

/// Seconds from the first row of the recording to `row`, on the clock that runs through all runs; rows where there is none.
pub fn elapsed_s(inputs: &Inputs, row: usize) -> f64 {
    inputs.time_s.as_deref().map_or(row as f64, |time| time[row] - time[0])
}

/// What is made of steps, kept for steps that come again: an even clock and means of few rows have a handful.
#[derive(Clone, Debug, Default)]
pub(super) struct Steps<W> {
    /// a step, and what is made of it
    known: Vec<(f64, W)>,
    last: usize,
    oldest: usize,
}

impl<W: Default> Steps<W> {
    /// What is made of a step; `learn` makes it of one that is not known.
    #[inline]
    pub fn known(&mut self, step_s: f64, learn: impl FnOnce(&mut W)) -> &W {
        let is_it = |known: &(f64, W)| (known.0 - step_s).abs() <= SAME_STEP * step_s;
        if !self.known.get(self.last).is_some_and(is_it) {
            self.last = self.known.iter().position(is_it).unwrap_or_else(|| {
                let place = self.place();
                let (known, of) = &mut self.known[place];
                *known = step_s;
                learn(of);
                place
            });
        }
        &self.known[self.last].1
    }

    /// Place of a step that is not known, in place of the one that has been known longest.
    fn place(&mut self) -> usize {
        let mut place = self.known.len();
        if place < KEPT {
            self.known.push((0.0, W::default()));
        } else {
            place = self.oldest;
            self.oldest = (place + 1) % KEPT;
        }
        place
    }
}

/// A clock, its steps as far as they differ, and which of them leads to each row.
pub(super) struct Clock {
    time_s: Option<Vec<f64>>,
    run: Vec<u32>,
    through: bool,
    /// steps in the order in which they come; one that was forgotten comes again
    pub steps_s: Vec<f64>,
    /// place of the step to each row; `None` where a run begins, or the recording
    pub of_row: Vec<Option<u32>>,
}

thread_local! {
    static KNOWN: RefCell<VecDeque<Rc<Clock>>> = const { RefCell::new(VecDeque::new()) };
}

impl Clock {
    /// The clock of these inputs, `through` all runs or inside each, with those that were asked before on the same thread.
    pub fn remembered(inputs: &Inputs, through: bool) -> Rc<Self> {
        let same_time = |time: &Option<Vec<f64>>| match (time, &inputs.time_s) {
            (Some(a), Some(b)) => same_column(a, b),
            (a, b) => a.is_none() && b.is_none(),
        };
        let is_asked = |clock: &Rc<Self>| clock.through == through && clock.run == inputs.run && same_time(&clock.time_s);
        KNOWN.with_borrow_mut(|known| asked_last(known, CLOCKS, is_asked, || Rc::new(Self::of(inputs, through))).clone())
    }

    fn of(inputs: &Inputs, through: bool) -> Self {
        let (mut steps, mut steps_s) = (Steps::<u32>::default(), Vec::new());
        let mut place = |step: f64| {
            let learn = |place: &mut u32| {
                *place = steps_s.len() as u32;
                steps_s.push(step);
            };
            *steps.known(step, learn)
        };
        let of_row = (0..inputs.len()).map(|row| Self::step(inputs, through, row).map(&mut place)).collect();
        Self { time_s: inputs.time_s.clone(), run: inputs.run.clone(), through, steps_s, of_row }
    }

    /// Seconds to `row` from the row before; `None` at the first row of a run, or of the recording where the clock goes `through` all runs. Rows count as seconds where no clock was recorded.
    pub fn step(inputs: &Inputs, through: bool, row: usize) -> Option<f64> {
        if through {
            return (row > 0).then(|| elapsed_s(inputs, row) - elapsed_s(inputs, row - 1));
        }
        let inside = row > 0 && inputs.run[row] == inputs.run[row - 1];
        inside.then(|| inputs.time_s.as_deref().map_or(1.0, |time| time[row] - time[row - 1]))
    }
}
