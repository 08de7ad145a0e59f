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
const STAGES: [(&str, f64); 9] = [
    ("rows", 4.0),
    ("noise", 4.0),
    ("one effect", 20.0),
    ("two effects", 20.0),
    ("pairs of the best", 8.0),
    ("three effects", 10.0),
    ("closer look", 10.0),
    ("composing", 16.0),
    ("rows left out", 60.0),
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
    /// share of all stages that was told last
    told: f64,
    /// between which numbers a stage that has begun again goes
    again: Option<(f64, f64)>,
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
        Self { stages, place: Mutex::new(Place { stage: 0, told: 0.0, again: None, laid_out: (0.0, LAID_OUT), reached: 0.0 }) }
    }

    /// The same with `done` as the share of the whole.
    pub fn over_all(&self, progress: Progress) -> Progress {
        let mut place = self.place.lock().unwrap_or_else(PoisonError::into_inner);
        let there = self.share(progress.step, progress.done).map_or(0.0, |(stage, share, ends)| place.at(stage, share, ends));
        let little = place.reached + A_LITTLE * (1.0 - place.reached);
        place.reached = if there > place.reached { there } else { little };
        Progress { done: place.reached, ..progress }
    }

    /// Index of a stage, the share of all stages that is over when `done` of it is, and those at its begin and its end.
    fn share(&self, step: &str, done: f64) -> Option<(usize, f64, (f64, f64))> {
        let whole: f64 = self.stages.iter().map(|(_, share)| share).sum();
        // `three effects, swapped` is a part of `three effects`, and `rows left out` none of `rows`
        let stages = self.stages.iter().enumerate().filter(|(_, (stage, _))| step.starts_with(stage));
        let index = stages.max_by_key(|(_, (stage, _))| stage.len())?.0;
        let before: f64 = self.stages[..index].iter().map(|(_, share)| share).sum();
        let own = self.stages[index].1;
        let over = |done: f64| (before + done * own) / whole;
        Some((index, over(done.clamp(0.0, 1.0)), (over(0.0), over(1.0))))
    }
}

impl Place {
    /// The number for a share of all stages; where an earlier stage begins again they are laid out over what is left. A stage that begins again itself, as each effect more does on rows left out, goes through half
    /// of what is left of it.
    fn at(&mut self, stage: usize, share: f64, (begins, ends): (f64, f64)) -> f64 {
        if stage < self.stage {
            self.laid_out = (self.reached, self.reached + LAID_OUT * (1.0 - self.reached));
            self.again = None;
        }
        if stage != self.stage {
            self.again = None;
        } else if share < self.told {
            let end = self.number(ends).max(self.reached);
            self.again = Some((self.reached, self.reached + 0.5 * (end - self.reached)));
        }
        (self.stage, self.told) = (stage, share);
        match self.again {
            Some((from, to)) => from + (to - from) * (share - begins) / (ends - begins),
            None => self.number(share),
        }
    }

    fn number(&self, share: f64) -> f64 {
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
        assert!(last > 0.75);
    }

    /// It stood at 91 % for half of a diagnosis, since rows left out were no stage.
    #[test]
    fn each_effect_more_on_rows_left_out_moves_the_number() {
        let course = Course::of(&Request::default());
        let end = told(&course, "composing", 1.0);
        let passes: Vec<f64> = (0..4)
            .map(|_| {
                told(&course, "rows left out", 0.0);
                told(&course, "rows left out", 1.0)
            })
            .collect();
        assert!(passes[0] > end + 0.2 && passes.windows(2).all(|pair| pair[1] > pair[0]) && passes[3] < 1.0, "{end} {passes:?}");
    }

    #[test]
    fn a_bank_is_most_of_a_diagnosis_that_has_one() {
        let course = Course::of(&Request { bank: Some(150), ..Request::default() });
        assert!(told(&course, "composing", 1.0) < 0.1 && told(&course, BANK.0, 1.0) > 0.6);
    }
}
