//! Calibration of stated probabilities: does 0.95 mean right in 95 of 100?
//!
//! Limits: ten bins of equal width; the interval is a bootstrap over findings with a fixed seed.

use crate::draws::Draws;

const BINS: usize = 10;
const RESAMPLES: usize = 400;

/// Expected calibration error of `stated` (probability, right): bin counts times |mean probability - share right|.
///
/// **Source:** Guo et al., On Calibration of Modern Neural Networks (2017), eq. (3).
pub fn expected_calibration_error(stated: &[(f64, bool)]) -> f64 {
    let mut bins = [(0.0, 0.0); BINS];
    for (probability, right) in stated {
        let bin = ((probability * BINS as f64) as usize).min(BINS - 1);
        bins[bin].0 += probability;
        bins[bin].1 += f64::from(u8::from(*right));
    }
    bins.iter().map(|(stated, right)| (stated - right).abs()).sum::<f64>() / stated.len().max(1) as f64
}

/// 95 % bootstrap interval of the error; wide upwards by construction, for few findings.
pub fn interval(stated: &[(f64, bool)]) -> [f64; 2] {
    if stated.is_empty() {
        return [0.0, 1.0];
    }
    let mut draws = Draws::of(0, "bootstrap");
    middle_95((0..RESAMPLES).map(|_| {
        let again: Vec<(f64, bool)> = (0..stated.len()).map(|_| stated[draws.index(stated.len())]).collect();
        expected_calibration_error(&again)
    }))
}

/// Error that chance alone makes of so few findings where every stated probability is true: mean and 95 % interval.
///
/// **Source:** Bröcker & Smith, Increasing the Reliability of Reliability Diagrams (2007): consistency resampling.
pub fn by_chance(stated: &[(f64, bool)]) -> (f64, [f64; 2]) {
    let mut draws = Draws::of(1, "honest");
    let errors: Vec<f64> = (0..RESAMPLES)
        .map(|_| {
            let honest: Vec<(f64, bool)> = stated.iter().map(|(p, _)| (*p, draws.between(0.0, 1.0) < *p)).collect();
            expected_calibration_error(&honest)
        })
        .collect();
    (errors.iter().sum::<f64>() / RESAMPLES as f64, middle_95(errors.into_iter()))
}

/// The middle 95 % of [`RESAMPLES`] errors.
fn middle_95(errors: impl Iterator<Item = f64>) -> [f64; 2] {
    let mut errors: Vec<f64> = errors.collect();
    errors.sort_by(f64::total_cmp);
    [errors[RESAMPLES / 40], errors[RESAMPLES - 1 - RESAMPLES / 40]]
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn honest_probabilities_have_no_error_and_boasts_have_theirs() {
        let honest: Vec<(f64, bool)> = (0..100).map(|i| (0.85, i < 85)).collect();
        let boast: Vec<(f64, bool)> = (0..100).map(|i| (0.95, i < 65)).collect();
        assert!(expected_calibration_error(&honest) < 1e-12);
        assert!((expected_calibration_error(&boast) - 0.3).abs() < 1e-12);
        // binomial scatter of 85 in 100: mean deviation sqrt(2 / pi) * 0.0357
        assert!((by_chance(&honest).0 - 0.0285).abs() < 0.005, "{:?}", by_chance(&honest));
        let [low, high] = interval(&boast);
        assert!(low < 0.3 && high > 0.3 && high < 0.45);
    }
}
