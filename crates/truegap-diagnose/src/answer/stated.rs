//! What is stated of a name: how often names were right that stood as high among the models.
//!
//! The probability of an effect is one among the models that were fitted, and takes it for granted that one of them is the truth. Recordings with known answers say how often that is so.
//! Limits: a sensor with plates keeps the probability among the models, which is right as often as it says where recordings are as planned; the line for all else knows how high a name stands and
//! nothing else of the recording.
//!
//! **Source:** Platt, Probabilistic outputs for support vector machines (1999): a logistic line in the log odds. Its numbers: `validation/stated`.

use crate::answer::tuning::{LARGEST_LOG_ODDS, LEVEL, SLOPE};

/// The probability to state, from that among the models; `plates` says whether the base model is a sensor with plates.
pub(crate) fn stated(among_models: f64, plates: bool) -> f64 {
    if plates {
        return among_models;
    }
    1.0 / (1.0 + (-LEVEL - SLOPE * log_odds(among_models)).exp())
}

/// Log odds, as far as they count.
fn log_odds(probability: f64) -> f64 {
    (probability / (1.0 - probability)).ln().clamp(-LARGEST_LOG_ODDS, LARGEST_LOG_ODDS)
}

#[cfg(test)]
mod tests {
    use super::*;

    /// Names with what the models gave them, and whether they are right: `validation/stated/claims.csv`.
    fn claims() -> Vec<(f64, bool)> {
        let path = concat!(env!("CARGO_MANIFEST_DIR"), "/../../validation/stated/claims.csv");
        let text = std::fs::read_to_string(path).unwrap();
        let rows = text.lines().skip(1).map(|line| line.split(',').collect::<Vec<_>>());
        rows.map(|row| (row[3].parse().unwrap(), row[6] == "1")).collect()
    }

    /// At its best a logistic line leaves neither a mean of the errors nor one that follows the log odds; a penalty of half the square of the slope moves the second by the slope.
    #[test]
    fn the_line_is_that_of_the_claims() {
        let claims = claims();
        let (mut level_error, mut slope_error) = (0.0, SLOPE);
        for (among_models, right) in &claims {
            let error = stated(*among_models, false) - f64::from(u8::from(*right));
            level_error += error;
            slope_error += error * log_odds(*among_models);
        }
        // three digits of the numbers: half of the last one moves these sums by less than a thousandth of the claims and of their log odds
        let most = 1e-3 * claims.len() as f64;
        assert!(level_error.abs() < most, "{level_error}");
        assert!(slope_error.abs() < LARGEST_LOG_ODDS * most, "{slope_error}");
    }

    #[test]
    fn a_name_that_stands_higher_is_stated_higher_and_none_is_certain() {
        let at = |p| stated(p, false);
        assert!(at(0.0) < at(0.3) && at(0.3) < at(0.7) && at(0.7) < at(1.0));
        assert!(at(1.0) < 0.8 && at(0.0) > 0.2);
        assert_eq!(stated(0.7, true), 0.7);
    }
}
