//! How long a simulator of the user's own will take, from how fast it answers before the search begins.
//!
//! Limits: a range, from diagnoses whose questions were counted; what a search asks depends on what it finds.

use super::bases::bases;
use super::request::Opened;
use crate::models::SLOW_S;
use std::fmt;

/// Questions of a diagnosis that finds nothing: so many, and so many more for each parameter. Counted for a spring of 200 rows: 1 427 with two parameters, 2 258
/// with four.
const FEWEST: (f64, f64) = (600.0, 415.0);
/// What much that is missing makes of that. Counted for springs: 11 724 to 20 661 with two parameters, 16 068 to 28 969 with four; for a flow meter with one parameter 51 118, for a load cell with two 104 683,
/// which have a second cause and hundreds of rows left out of each law.
const MOST: f64 = 75.0;
/// Questions about physics inside of the simulator, where that is looked for.
const INSIDE: f64 = 10_000.0;
/// Answers that are timed, the fastest of which counts, as long as they take no longer together than [`TIMED_S`].
const ANSWERS: usize = 5;
const TIMED_S: f64 = 0.5;
/// A search that takes no longer is not spoken of, s.
const SHORT_S: f64 = 60.0;

/// How fast a simulator answers, and how long a search among its answers takes.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Pace {
    /// time of one answer, s
    pub seconds: f64,
    /// fewest and most questions
    pub questions: (f64, f64),
}

impl Pace {
    fn of(seconds: f64, parameters: usize, recordings: usize, inside: bool) -> Self {
        let fewest = (FEWEST.0 + FEWEST.1 * parameters as f64) * recordings as f64;
        Self { seconds, questions: (fewest, MOST * fewest + if inside { INSIDE } else { 0.0 }) }
    }

    /// Whether somebody should be told before it begins.
    pub fn is_slow(&self) -> bool {
        self.seconds * self.questions.1 > SHORT_S
    }
}

impl fmt::Display for Pace {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        let (fewest, most) = self.questions;
        let stopped = match self.seconds < SLOW_S {
            true => "ends the search and writes what is known by then",
            // what is known by then would take hundreds of questions more
            false => "ends the search at once and writes nothing",
        };
        let hundreds = |questions: f64| 100.0 * (questions / 100.0).round();
        write!(
            f,
            "the simulator answers in {}; a diagnosis asks it some {} to {} times, which takes {} to {}; Ctrl-C {stopped}",
            duration(self.seconds),
            hundreds(fewest),
            hundreds(most),
            duration(self.seconds * fewest),
            duration(self.seconds * most)
        )
    }
}

/// A time with one or two digits.
pub(super) fn duration(seconds: f64) -> String {
    let (value, unit) = match seconds {
        s if s < 0.95 => (1e3 * s, "ms"),
        s if s < 90.0 => (s, "s"),
        s if s < 5400.0 => (s / 60.0, "min"),
        s => (s / 3600.0, "h"),
    };
    if value < 9.5 { format!("{value:.1} {unit}") } else { format!("{value:.0} {unit}") }
}

/// The pace of a recording's simulator; `None` where its base model asks nobody, or gives no answer: whoever diagnoses then says why.
pub fn pace(opened: &Opened) -> Option<Pace> {
    let recording = opened.parts.first().unwrap_or(&opened.recording);
    let asks = matches!(recording.base.model.as_str(), "command" | "function");
    let bases = asks.then(|| bases(opened).ok()).flatten()?;
    let simulator = bases.simulator(0);
    let mut values = simulator.centre();
    // the first answer includes the start of a program and what it is given
    simulator.respond(&values, &recording.inputs, &[]).ok()?;
    let started = opened.programs.calls();
    let mut seconds = started.seconds / started.count.max(1) as f64;
    // one answer may have had to wait for the machine
    for _ in 0..ANSWERS {
        let before = opened.programs.calls();
        if let (Some(value), Some(parameter)) = (values.first_mut(), simulator.parameters().first()) {
            *value = (*value + 1e-3 * parameter.sd()).clamp(parameter.bounds.0, parameter.bounds.1);
        }
        simulator.respond(&values, &recording.inputs, &[]).ok()?;
        let answered = opened.programs.calls();
        match answered.count - before.count {
            0 => break,
            count => seconds = seconds.min((answered.seconds - before.seconds) / count as f64),
        }
        if answered.seconds - started.seconds > TIMED_S {
            break;
        }
    }
    let inside = recording.base.further.get("inside").and_then(toml::Value::as_bool).unwrap_or(false);
    Some(Pace::of(seconds, values.len(), opened.parts.len().max(1), inside))
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn ten_answers_a_second_are_told_of_and_a_thousand_are_not() {
        let slow = Pace::of(0.1, 2, 1, false);
        assert!(slow.is_slow() && !Pace::of(0.0005, 2, 1, false).is_slow());
        let told = slow.to_string();
        assert!(
            told.contains("answers in 100 ms") && told.contains("1400 to 107300 times") && told.contains("2.4 min to 3.0 h"),
            "{told}"
        );
    }

    /// A slow program is asked no further once somebody stops, so there is nothing to write.
    #[test]
    fn what_ctrl_c_does_is_what_is_told_of_it() {
        assert!(Pace::of(0.1, 2, 1, false).to_string().ends_with("Ctrl-C ends the search at once and writes nothing"));
        assert!(Pace::of(0.009, 2, 1, false).to_string().ends_with("Ctrl-C ends the search and writes what is known by then"));
    }

    /// What was counted lies in the range.
    #[test]
    fn the_range_holds_what_was_counted() {
        for (parameters, questions) in [
            (1, [51_118.0, 51_118.0, 51_118.0, 51_118.0]),
            (2, [1_427.0, 11_724.0, 20_661.0, 104_683.0]),
            (4, [2_258.0, 16_068.0, 28_969.0, 28_969.0]),
        ] {
            let (fewest, most) = Pace::of(1.0, parameters, 1, false).questions;
            assert!(questions.iter().all(|q| (0.99 * fewest..=most).contains(q)), "{fewest} to {most}");
        }
    }
}
