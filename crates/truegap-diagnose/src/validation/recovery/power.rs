//! One number that makes stated probabilities mean what they say: the power to which those of the models are raised.
//!
//! Limits: one power for all effects and sizes. In the bank one of the models is the truth, so what is scored is the probability of an effect beside causes outside the library, and not what a base
//! model without plates states of it: that line was fitted to recordings in which none may be.

use crate::{
    stats::log_sum_exp,
    validation::recovery::case::BankCase,
    validation::tuning::{POWER_LOG_SD, POWER_RANGE},
};

/// A claim: probability stated for an effect of the model named, and whether it was concealed.
pub fn claims(cases: &[BankCase], power: f64) -> Vec<(f64, bool)> {
    cases.iter().flat_map(|case| claims_of(case, power)).collect()
}

/// The effects of the model stood behind, with their probabilities; causes outside the library have their share.
fn claims_of(case: &BankCase, power: f64) -> Vec<(f64, bool)> {
    let all = || case.models.iter().chain(&case.unmodelled);
    let probability = sharpened(&all().map(|m| m.1).collect::<Vec<_>>(), power);
    let of = |effect: &String| -> f64 { all().zip(&probability).filter(|(m, _)| m.0.contains(effect)).map(|(_, p)| p).sum() };
    case.named.iter().map(|e| (of(e).clamp(1e-6, 1.0 - 1e-6), case.truth.effects.contains(e))).collect()
}

/// Probabilities raised to a power and normalised again.
fn sharpened(log_probability: &[f64], power: f64) -> Vec<f64> {
    let raised: Vec<f64> = log_probability.iter().map(|p| p * power).collect();
    let total = log_sum_exp(&raised);
    raised.iter().map(|p| (p - total).exp()).collect()
}

/// The power under which the bank's own claims would have been likeliest, with a prior about 1.
///
/// **Source:** temperature scaling, Guo et al. (2017), with a penalty so that few claims change little.
pub fn power(cases: &[BankCase]) -> f64 {
    let score = |log: f64| {
        let likelihood: f64 =
            claims(cases, log.exp()).iter().map(|(p, right)| if *right { p.ln() } else { (1.0 - p).ln() }).sum();
        likelihood - 0.5 * (log / POWER_LOG_SD).powi(2)
    };
    let at = |i: usize| POWER_RANGE.0 + (POWER_RANGE.1 - POWER_RANGE.0) * i as f64 / (POWER_RANGE.2 - 1) as f64;
    let best = (0..POWER_RANGE.2).map(at).max_by(|a, b| score(*a).total_cmp(&score(*b)));
    best.unwrap_or(0.0).exp()
}

/// Expected calibration error of claims: count in ten bins times |mean probability - share right|.
///
/// **Source:** Guo et al., On Calibration of Modern Neural Networks (2017), eq. (3).
pub fn calibration_error(claims: &[(f64, bool)]) -> f64 {
    let mut bins = [(0.0, 0.0); 10];
    for (probability, right) in claims {
        let bin = &mut bins[((probability * 10.0) as usize).min(9)];
        bin.0 += probability;
        bin.1 += f64::from(u8::from(*right));
    }
    bins.iter().map(|(stated, right)| (stated - right).abs()).sum::<f64>() / claims.len().max(1) as f64
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::validation::recovery::Truth;

    fn case(stated: f64, right: bool) -> BankCase {
        let truth = Truth { effects: vec![if right { "a" } else { "b" }.into()], detectability: 20.0, ..Truth::default() };
        let models = vec![(vec!["a".to_owned()], stated.ln()), (vec!["b".to_owned()], (1.0 - stated).ln())];
        BankCase { truth, verdict: "explained".into(), named: vec!["a".into()], sets: Vec::new(), models, unmodelled: Vec::new() }
    }

    /// A probability of 0.7 among the models, causes outside of them with odds of 1 alone and of 0.5 beside the effect: (0.7 + 0.5) / 2.5; squares likewise.
    #[test]
    fn a_claim_leaves_room_for_causes_outside_the_library() {
        let outside = vec![(Vec::new(), 0.0), (vec!["a".to_owned()], 0.5f64.ln())];
        let cases = [BankCase { unmodelled: outside, ..case(0.7, true) }];
        approx::assert_relative_eq!(claims(&cases, 1.0)[0].0, 1.2 / 2.5, max_relative = 1e-12);
        approx::assert_relative_eq!(claims(&cases, 2.0)[0].0, 0.74 / 1.83, max_relative = 1e-12);
    }

    /// Claims stated at 0.7 and right in 9 of 10: the logit must be multiplied by ln 9 / ln (7/3) = 2.59; the prior holds it back a little.
    #[test]
    fn modest_claims_are_sharpened_and_bold_ones_blunted() {
        let modest: Vec<BankCase> = (0..400).map(|i| case(0.7, i % 10 != 0)).collect();
        let bold: Vec<BankCase> = (0..400).map(|i| case(0.97, i % 5 != 0)).collect();
        let (up, down) = (power(&modest), power(&bold));
        assert!((2.3..2.6).contains(&up), "{up}");
        let exact = 4f64.ln() / (0.97f64 / 0.03).ln();
        assert!((exact..exact + 0.08).contains(&down), "{down} {exact}");
        assert!(calibration_error(&claims(&modest, up)) < 0.03 && calibration_error(&claims(&modest, 1.0)) > 0.19);
    }
}
