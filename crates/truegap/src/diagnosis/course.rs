//! How far a diagnosis is as one number over all of its stages, which never falls.
//!
//! Each stage has a share of the whole, and what it reports moves the number through that share. Where an earlier stage begins again, as the search does where the noise was another, the whole
//! is laid out once more over most of what is left. A report that would move nothing moves it a little towards the end, so that it stays in motion.
//!
//! Limits: how often stages are gone through is not known before; a diagnosis may end at any number.

use super::request::Request;
use std::sync::{Mutex, PoisonError};
use truegap_diagnose::Progress;

/// Stages in their order, with what they take of a diagnosis that goes through each of them once.
const STAGES: [(&str, f64); 8] = [
    ("rows", 4.0),
    ("noise", 4.0),
    ("one effect", 20.0),
    ("two effects", 20.0),
    ("pairs of the best", 8.0),
    ("three effects", 10.0),
    ("closer look", 10.0),
    ("composing", 16.0),
];
/// The one behind the recovery bank.
const LAST: (&str, f64) = ("by name", 8.0);
/// Names of the stages that come where they are asked for, with what one step of them takes beside those above.
const BANK: (&str, f64) = ("recovery bank", 8.0);
const CHOSEN_AGAIN: (&str, f64) = ("chosen again", 400.0);
const PERMUTED: (&str, f64) = ("permuted histories", 70.0);
/// Part of what is left over which all stages are laid out.
const LAID_OUT: f64 = 0.7;
/// Part of what is left by which a report moves the number that would move nothing.
const A_LITTLE: f64 = 0.002;

/// One diagnosis.
pub(super) struct Course {
    stages: Vec<(&'static str, f64)>,
    place: Mutex<Place>,
}

/// Where it is.
struct Place {
    /// index of the last stage
    stage: usize,
    /// between which numbers the stages are laid out
    laid_out: (f64, f64),
    reached: f64,
}

impl Course {
    pub fn of(request: &Request) -> Self {
        let mut stages = STAGES.to_vec();
        stages.extend(request.bank.map(|cases| (BANK.0, BANK.1 * cases as f64)));
        stages.push(LAST);
        stages.extend(request.select_in_folds.then_some(CHOSEN_AGAIN));
        stages.push((PERMUTED.0, PERMUTED.1 * request.permuted_searches as f64));
        Self { stages, place: Mutex::new(Place { stage: 0, laid_out: (0.0, LAID_OUT), reached: 0.0 }) }
    }

    /// The same with `done` as the share of the whole.
    pub fn over_all(&self, progress: Progress) -> Progress {
        let mut place = self.place.lock().unwrap_or_else(PoisonError::into_inner);
        let there = self.share(progress.step, progress.done).map_or(0.0, |(stage, share)| place.at(stage, share));
        let little = place.reached + A_LITTLE * (1.0 - place.reached);
        place.reached = if there > place.reached { there } else { little };
        Progress { done: place.reached, ..progress }
    }

    /// Index of a stage, and the share of all stages that is over when `done` of it is.
    fn share(&self, step: &str, done: f64) -> Option<(usize, f64)> {
        let whole: f64 = self.stages.iter().map(|(_, share)| share).sum();
        // `three effects, swapped` is a part of `three effects`
        let index = self.stages.iter().position(|(stage, _)| step.starts_with(stage))?;
        let before: f64 = self.stages[..index].iter().map(|(_, share)| share).sum();
        Some((index, (before + done.clamp(0.0, 1.0) * self.stages[index].1) / whole))
    }
}

impl Place {
    /// The number for a share of all stages; where an earlier stage begins again they are laid out over what is left.
    fn at(&mut self, stage: usize, share: f64) -> f64 {
        if stage < self.stage {
            self.laid_out = (self.reached, self.reached + LAID_OUT * (1.0 - self.reached));
        }
        self.stage = stage;
        let (from, to) = self.laid_out;
        from + (to - from) * share
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn told(course: &Course, step: &'static str, done: f64) -> f64 {
        course.over_all(Progress { step, what: String::new(), done }).done
    }

    /// A bar that filled once for each stage said nothing of the whole.
    #[test]
    fn the_number_rises_whatever_stages_come_and_come_again() {
        let course = Course::of(&Request::default());
        let steps =
            ["rows", "noise", "one effect", "two effects", "one effect", "closer look", "a new one", "one effect", "by name"];
        let mut last = 0.0;
        for step in steps {
            for done in [0.0, 0.5, 1.0, 0.3] {
                let now = told(&course, step, done);
                assert!((last..=1.0).contains(&now), "{step} {done}: {now} after {last}");
                last = now;
            }
        }
        assert!(last > 0.9);
    }

    #[test]
    fn a_bank_is_most_of_a_diagnosis_that_has_one() {
        let course = Course::of(&Request { bank: Some(150), ..Request::default() });
        assert!(told(&course, "composing", 1.0) < 0.1 && told(&course, BANK.0, 1.0) > 0.6);
    }
}
