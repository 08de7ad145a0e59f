//! What is stated of a name: how often names were right that stood as high among the models, alone or beside others, and how often this name was.
//!
//! The probability of an effect is one among the models that were fitted, and takes it for granted that one of them is the truth. Recordings with known answers say how often that is so.
//! A name that an answer has alone is right more often than one of several, and the first of several, without which rows left out are predicted worst, more often than those after it: an equation that is
//! slightly off leaves a rest, and a second name follows that rest whether or not it is a cause. And some names follow whatever there is (a clock that runs fast, a gain that changes at some time), while others, which
//! follow a column that was recorded, seldom do.
//!
//! Limits: a sensor with plates keeps the probability among the models, which is right as often as it says where recordings are as planned; the line for all else knows the name, how high it stands and
//! its place in the answer, and nothing else of the recording.
//!
//! **Source:** Platt, Probabilistic outputs for support vector machines (1999): a logistic line in the log odds. Its numbers: `validation/stated`.

use crate::answer::tuning::{BESIDE_OTHERS, CARRIED, LARGEST_LOG_ODDS, LATER, LEVEL, SLOPE};

/// What the name of each effect adds to the log odds, and how often it was right: `validation/stated/fit.py`.
const RECORD: &str = include_str!("../../tables/track_record.csv");

/// Place of a name in its answer.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) enum Place {
    /// the only name
    Alone,
    /// the first of several: without it rows left out are predicted worst
    First,
    /// after the first
    Later,
    /// not claimed: the model keeps it, since it predicts better with it
    Carried,
}

impl Place {
    /// Place of the name with `index`, from 0, of `count`.
    pub fn of(index: usize, count: usize) -> Self {
        match index {
            0 if count < 2 => Self::Alone,
            0 => Self::First,
            _ => Self::Later,
        }
    }

    /// What the place adds to the log odds.
    fn log_odds(self) -> f64 {
        match self {
            Self::Alone => 0.0,
            Self::First => BESIDE_OTHERS,
            Self::Later => BESIDE_OTHERS + LATER,
            Self::Carried => BESIDE_OTHERS + LATER + CARRIED,
        }
    }
}

/// The probability to state of an `effect`, from that among the models; `plates` says whether the base model is a sensor with plates.
pub(crate) fn stated(effect: &str, among_models: f64, place: Place, plates: bool) -> f64 {
    if plates {
        return among_models;
    }
    1.0 / (1.0 + (-LEVEL - place.log_odds() - SLOPE * log_odds(among_models) - record(effect)).exp())
}

/// What the name of an effect adds to the log odds; nothing where it was never stated.
fn record(effect: &str) -> f64 {
    let rows = RECORD.lines().skip(1).map(|row| row.split(','));
    let step = |mut row: std::str::Split<'_, char>| (row.next() == Some(effect)).then(|| row.next()?.parse().ok()).flatten();
    rows.filter_map(step).next().unwrap_or(0.0)
}

/// Log odds, as far as they count.
fn log_odds(probability: f64) -> f64 {
    (probability / (1.0 - probability)).ln().clamp(-LARGEST_LOG_ODDS, LARGEST_LOG_ODDS)
}

#[cfg(test)]
mod tests {
    use super::*;

    /// A name with what the models gave it, its place, and whether it is right: a row of `validation/stated/claims.csv`.
    struct Claim {
        effect: String,
        among_models: f64,
        place: Place,
        right: bool,
    }

    fn claims() -> Vec<Claim> {
        let path = concat!(env!("CARGO_MANIFEST_DIR"), "/../../validation/stated/claims.csv");
        let text = std::fs::read_to_string(path).unwrap();
        let rows = text.lines().skip(1).map(|line| line.split(',').collect::<Vec<_>>());
        let claim = |row: Vec<&str>| Claim {
            effect: row[2].to_owned(),
            among_models: row[3].parse().unwrap(),
            place: match row[7] {
                "1" => Place::Carried,
                _ => Place::of(row[5].parse::<usize>().unwrap() - 1, row[6].parse().unwrap()),
            },
            right: row[8] == "1",
        };
        rows.map(claim).collect()
    }

    /// At its best a logistic line leaves neither a mean of the errors nor one that follows a term; a penalty of half the square of a number moves that by the number.
    #[test]
    fn the_line_is_that_of_the_claims() {
        let claims = claims();
        let mut left = [0.0, SLOPE, BESIDE_OTHERS, LATER, CARRIED];
        let mut by_name = std::collections::BTreeMap::new();
        for Claim { effect, among_models, place, right } in &claims {
            let error = stated(effect, *among_models, *place, false) - f64::from(u8::from(*right));
            left[0] += error;
            left[1] += error * log_odds(*among_models);
            left[2] += error * f64::from(u8::from(*place != Place::Alone));
            left[3] += error * f64::from(u8::from(matches!(place, Place::Later | Place::Carried)));
            left[4] += error * f64::from(u8::from(*place == Place::Carried));
            *by_name.entry(effect).or_insert_with(|| record(effect)) += error;
        }
        // three digits of the numbers: half of the last one moves these sums by less than a thousandth of the claims and of their log odds
        let most = 1e-3 * claims.len() as f64;
        for (sum, most) in left.into_iter().zip([most, LARGEST_LOG_ODDS * most, most, most, most]) {
            assert!(sum.abs() < most, "{left:?}");
        }
        assert_eq!(by_name.len(), RECORD.lines().count() - 1);
        assert!(by_name.values().all(|sum| sum.abs() < 0.02), "{by_name:?}");
    }

    #[test]
    fn a_name_that_stands_higher_is_stated_higher_and_none_is_certain() {
        let at = |p| stated("slow_response", p, Place::Alone, false);
        assert!(at(0.0) < at(0.3) && at(0.3) < at(0.7) && at(0.7) < at(1.0));
        assert!(at(1.0) < 0.95 && at(0.0) > 0.2);
        assert_eq!(stated("slow_response", 0.7, Place::Later, true), 0.7);
    }

    #[test]
    fn a_name_beside_others_is_stated_lower_and_those_after_the_first_lowest() {
        let of = |index, count| stated("slow_response", 0.99, Place::of(index, count), false);
        assert!(of(0, 1) > of(0, 2) && of(0, 2) > of(1, 2));
        assert!(of(1, 2) > stated("slow_response", 0.99, Place::Carried, false));
        assert_eq!(Place::of(2, 3), Place::Later);
    }

    /// None of six clocks that were named was right, and all of twenty coefficients of temperature. A name that was never stated is in between.
    #[test]
    fn a_name_that_was_seldom_right_is_stated_lower() {
        let [clock, new, coefficient] =
            ["clock_rate", "of_mine", "temperature_coefficient"].map(|name| stated(name, 0.99, Place::Alone, false));
        assert!(clock < new && new < coefficient, "{clock} {new} {coefficient}");
    }
}
