//! What whole searches on permuted histories found, as `diagnosis.json` has it.
//!
//! Limits: plain data.

use serde::Serialize;

/// The search of this recording beside searches where there is nothing to find.
#[derive(Clone, Debug, Serialize)]
pub struct PermutedSearches {
    /// sentence with the numbers
    pub says: String,
    /// log odds of the likeliest model that names something over the base model, evidence without tempering
    pub gain: f64,
    /// the same in each permuted recording, in order of size, the largest first
    pub gains: Vec<f64>,
    /// share of searches, this one among them, that gain as much
    pub p_value: f64,
}

impl PermutedSearches {
    /// The p-value of `gain` among those of permuted recordings.
    pub(crate) fn new(gain: f64, mut gains: Vec<f64>) -> Self {
        gains.sort_by(|a, b| b.total_cmp(a));
        let as_much = gains.iter().filter(|permuted| **permuted >= gain).count();
        let p_value = (1 + as_much) as f64 / (1 + gains.len()) as f64;
        let says = format!(
            "the whole search on {} permuted histories gains as much in {as_much} of them (p = {p_value:.2}); log odds of the likeliest cause {gain:.1}, at most {:.1} there",
            gains.len(),
            gains[0]
        );
        Self { says, gain, gains, p_value }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn the_recording_itself_counts_among_the_searches() {
        let of = |gain| PermutedSearches::new(gain, vec![1.0, -2.0, 5.0, 3.0]);
        assert_eq!((of(9.0).p_value, of(4.0).p_value, of(-3.0).p_value), (0.2, 0.4, 1.0));
        assert_eq!(of(9.0).gains, [5.0, 3.0, 1.0, -2.0]);
        assert!(of(4.0).says.contains("in 1 of them (p = 0.40)"), "{}", of(4.0).says);
    }
}
