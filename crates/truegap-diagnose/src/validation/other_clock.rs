//! A clock of its own, fitted to a recording that took no part.
//!
//! Load and reading of another recording were started anew, so that what one clock is late there says nothing of the recording before, and the other way round. Where both are recorded by the same two
//! devices, what a model foretells is hidden behind it: base and augmented model each get the clock that suits them best.
//!
//! **Source:** Golub & Pereyra, The differentiation of pseudo-inverses and nonlinear least squares problems whose variables separate, SIAM J. Numer. Anal. 10 (1973) 413 (gain and offset are eliminated);
//! Marquardt, J. Soc. Ind. Appl. Math. 11 (1963) 431.
//!
//! Limits: one clock for all runs; a shift of up to a fifth of the longest run, a rate of up to a twentieth.

use crate::{
    data::joint::Free,
    effects::{clock_rate::MOST, time_offset::LARGEST_SHARE},
    validation::confirmation::Reading,
};
use nalgebra::{Matrix2, Vector2};
use serde::Serialize;
use std::iter;
use truegap_core::{Inputs, Stage};

/// How the clock of the load differs from that of the reading.
#[derive(Clone, Copy, Debug, Default, PartialEq, Serialize)]
pub struct OtherClock {
    /// seconds by which the load is late at the first row
    pub late_s: f64,
    /// seconds by which its rows fall behind in a second, as where its clock runs fast
    pub rate: f64,
}

impl Stage for OtherClock {
    fn late_s(&self, elapsed_s: f64) -> f64 {
        self.late_s + self.rate * elapsed_s
    }
}

/// The clock with which a model predicts a response best beside what is `free` in the reading, and that prediction; `predict` gives the model's response of each row for a clock, `response` is in the
/// same unit.
///
/// # Errors
/// Those of `predict`, without any clock. A clock with which the model has no answer is not taken.
pub fn with_clock<E>(
    inputs: &Inputs,
    response: &[f64],
    free: Free,
    mut predict: impl FnMut(&OtherClock) -> Result<Vec<f64>, E>,
) -> Result<(OtherClock, Vec<f64>), E> {
    let still = predict(&OtherClock::default())?;
    let Some(limits) = Limits::of(inputs) else { return Ok((OtherClock::default(), still)) };
    let errors = |prediction: &[f64]| {
        let read = Reading::fitted(prediction, response, free).of(prediction);
        read.iter().zip(response).map(|(p, r)| p - r).collect::<Vec<f64>>()
    };
    let there = |clock: OtherClock, prediction: Vec<f64>| {
        let left = errors(&prediction);
        let squares = left.iter().map(|e| e * e).sum();
        At { clock, prediction, left, squares }
    };
    let still = there(OtherClock::default(), still);
    let mut at = |clock: OtherClock| Some(there(clock, predict(&clock).ok()?)).filter(|there| there.squares.is_finite());
    let mut shifted: Vec<At> = limits.shifts().filter_map(|late_s| at(OtherClock { late_s, rate: 0.0 })).collect();
    shifted.sort_by(|a, b| a.squares.total_cmp(&b.squares));
    shifted.truncate(STARTS);
    let mut best = limits.descent(still, &mut at);
    for start in shifted {
        let end = limits.descent(start, &mut at);
        if end.squares < best.squares {
            best = end;
        }
    }
    Ok((best.clock, best.prediction))
}

/// A clock and what is left with it.
struct At {
    clock: OtherClock,
    prediction: Vec<f64>,
    left: Vec<f64>,
    squares: f64,
}

/// How far a clock may be off.
struct Limits {
    /// usual time between two rows, s
    step_s: f64,
    /// greatest shift, s
    shift_s: f64,
    /// time from the first row to the last, s
    length_s: f64,
}

impl Limits {
    /// `None` where no clock was recorded, or it stands.
    fn of(inputs: &Inputs) -> Option<Self> {
        let time = inputs.time_s.as_ref()?;
        let lengths = inputs.runs().into_iter().map(|run| time[run.end - 1] - time[run.start]);
        let longest = lengths.fold(0.0, f64::max);
        let length_s = time.last()? - time.first()?;
        let step_s = longest / (time.len() as f64 / inputs.runs().len() as f64).max(1.0);
        (step_s > 0.0).then_some(Self { step_s, shift_s: LARGEST_SHARE * longest, length_s })
    }

    /// Shifts at which a search begins: one row, two, four, ... to either side.
    fn shifts(&self) -> impl Iterator<Item = f64> + use<> {
        let most = self.shift_s;
        iter::successors(Some(self.step_s), |shift| Some(2.0 * shift)).take_while(move |s| *s <= most).flat_map(|s| [s, -s])
    }

    fn clamped(&self, clock: OtherClock) -> OtherClock {
        OtherClock { late_s: clock.late_s.clamp(-self.shift_s, self.shift_s), rate: clock.rate.clamp(-MOST, MOST) }
    }

    /// Marquardt's way down from a clock, in seconds at the first row and at the last.
    fn descent(&self, start: At, at: &mut impl FnMut(OtherClock) -> Option<At>) -> At {
        let (mut here, mut damping) = (start, 1e-3);
        // differences over half a row: shorter ones see the corners between rows
        let moved = |clock: OtherClock, step: Vector2<f64>| OtherClock {
            late_s: clock.late_s + step[0],
            rate: clock.rate + step[1] / self.length_s.max(self.step_s),
        };
        for _ in 0..STEPS {
            let width = 0.5 * self.step_s;
            let column = |axis: usize, at: &mut dyn FnMut(OtherClock) -> Option<At>| {
                let mut step = Vector2::zeros();
                step[axis] = width;
                let there = at(moved(here.clock, step))?;
                Some(there.left.iter().zip(&here.left).map(|(t, h)| (t - h) / width).collect::<Vec<f64>>())
            };
            let (Some(first), Some(second)) = (column(0, at), column(1, at)) else { break };
            let dot = |a: &[f64], b: &[f64]| a.iter().zip(b).map(|(a, b)| a * b).sum::<f64>();
            let gram = Matrix2::new(dot(&first, &first), dot(&first, &second), dot(&first, &second), dot(&second, &second));
            let slope = Vector2::new(dot(&first, &here.left), dot(&second, &here.left));
            let step = |damping: f64| (gram + Matrix2::from_diagonal(&(gram.diagonal() * damping))).lu().solve(&-slope);
            let mut next = None;
            while next.is_none() && damping < 1e3 {
                let tried = step(damping).and_then(|step| at(self.clamped(moved(here.clock, step))));
                next = tried.filter(|there| there.squares < here.squares);
                damping *= if next.is_some() { 0.1 } else { 10.0 };
            }
            let Some(next) = next else { break };
            let done = here.squares - next.squares < CLOSE * here.squares;
            here = next;
            if done {
                break;
            }
        }
        here
    }
}

/// Shifts that are followed to their ends, the best of those looked at, beside the way down from no shift.
const STARTS: usize = 2;
/// Most steps of a search.
const STEPS: usize = 12;
/// A step that takes off less than this share of the squares ends a search.
const CLOSE: f64 = 1e-4;

#[cfg(test)]
mod tests {
    use super::*;

    /// Waves of 40 and 95 s, read ten times a second.
    fn wave(t: f64) -> f64 {
        (t / 6.4).sin() + 0.5 * (t / 15.1).cos()
    }

    fn inputs(rows: usize) -> Inputs {
        Inputs { run: vec![1; rows], time_s: Some((0..rows).map(|row| 0.1 * row as f64).collect()), ..Inputs::default() }
    }

    fn late(inputs: &Inputs, clock: &OtherClock) -> Vec<f64> {
        inputs.time_s.iter().flatten().map(|t| wave(t + clock.late_s(*t))).collect()
    }

    #[test]
    fn a_clock_that_was_planted_is_found_beside_a_gain_and_an_offset() {
        let inputs = inputs(2000);
        // the last is late by more than half of the shorter wave: the way down from no shift ends elsewhere
        let truths = [(1.3, -0.011), (-2.2, 0.004), (29.0, 0.0)].map(|(late_s, rate)| OtherClock { late_s, rate });
        for truth in truths {
            let response: Vec<f64> = late(&inputs, &truth).iter().map(|v| 3.0 - 0.7 * v).collect();
            let free = Free { gain: true, offset: true };
            let (found, prediction) =
                with_clock(&inputs, &response, free, |clock| Ok::<_, ()>(late(&inputs, clock))).unwrap_or_default();
            // no noise: the way down ends where a step takes off a ten thousandth of the squares
            assert!((found.late_s - truth.late_s).abs() < 1e-3, "{found:?}");
            assert!((found.rate - truth.rate).abs() < 1e-5, "{found:?}");
            assert_eq!(prediction, late(&inputs, &found));
        }
    }

    #[test]
    fn without_a_clock_in_the_recording_nothing_is_shifted() {
        let inputs = Inputs { time_s: None, ..inputs(50) };
        let free = Free::default();
        let mut asked = 0;
        let found = with_clock(&inputs, &[1.0; 50], free, |_| {
            asked += 1;
            Ok::<_, ()>(vec![1.0; 50])
        });
        assert_eq!((found, asked), (Ok((OtherClock::default(), vec![1.0; 50])), 1));
    }

    #[test]
    fn a_model_without_an_answer_says_why_and_one_that_fails_elsewhere_is_kept_where_it_answers() {
        let inputs = inputs(400);
        let free = Free { gain: true, offset: false };
        assert_eq!(with_clock(&inputs, &[0.0; 400], free, |_| Err::<Vec<f64>, _>("no answer")).err(), Some("no answer"));
        let response = late(&inputs, &OtherClock::default());
        let found = with_clock(&inputs, &response, free, |clock| {
            if clock.late_s == 0.0 && clock.rate == 0.0 { Ok(response.clone()) } else { Err(()) }
        });
        assert_eq!(found, Ok((OtherClock::default(), response.clone())));
    }
}
