//! Rows of a reading that are louder than the rest: heavy tails, spikes, noise that grows.
//!
//! None of it is physics of a sensor, and none of it hides any: a row weighs less the further it stands from its neighbours on both sides. A jump that stays is no spike,
//! nor is a row at which an input jumps too, unless it stands out among those; where loud rows come together they are bursts, which are not taken for noise.
//!
//! Limits: judged beside the calibrated base model; up to two loud rows in four.
//!
//! **Source:** weights of Student's t by iterated least squares, Lange, Little and Taylor, J. Am. Stat. Assoc. 84, 881 (1989), section 3.

use crate::{
    noise::{
        apart::apart,
        grows::{Beside, grows},
        tuning::{FAR_OFF, FEWEST_FAR_OFF, SHARE_FAR_OFF, TAIL_FREEDOM, WEIGHS_LESS, WILD},
    },
    stats::{MEDIAN_NORMAL, median, spread},
};
use std::ops::Range;

/// How loud each row is beside its neighbours.
pub struct Louder {
    /// variance above that of the quiet rows
    pub variance: Vec<f64>,
    /// what was given, with the middle of the neighbours in place of what stands out
    pub clean: Vec<f64>,
    /// rows that no chance makes
    pub wild: Vec<usize>,
    /// whether nothing but these rows is louder
    pub only_wild: bool,
    /// what it is, for a reader
    pub says: String,
}

impl Louder {
    /// The wild rows alone: the others weigh as they did.
    pub fn wild_only(mut self) -> Self {
        let wild = |row: usize| self.wild.contains(&row);
        self.variance.iter_mut().enumerate().filter(|(row, _)| !wild(*row)).for_each(|(_, variance)| *variance = 0.0);
        Self { only_wild: true, says: WILD_ONLY.into(), ..self }
    }
}

const WILD_ONLY: &str = "single wild rows: they weigh less";

/// Rows that are louder than others beside a calibrated model; `jumping` are the columns that may jump. `None` where noise is the same in all rows.
pub(crate) fn louder(beside: &Beside<'_>, jumping: &[&[f64]]) -> Option<Louder> {
    let (misfit, runs) = (beside.misfit, beside.runs);
    let apart = apart(misfit, runs);
    let mut jump = vec![false; misfit.len()];
    for column in jumping {
        jump.iter_mut().zip(jumps(column, runs)).for_each(|(any, here)| *any |= here);
    }
    let scale = |jumps: bool| {
        let of: Vec<f64> = apart.iter().zip(&jump).filter(|(_, j)| **j == jumps).map(|(d, _)| d.about.abs()).collect();
        median(&of) / MEDIAN_NORMAL
    };
    let quiet = scale(false);
    if quiet <= 0.0 {
        return None;
    }
    let loud = quiet.max(scale(true));
    let grows = grows(beside, &apart, quiet);
    // of a row, beside others of its kind
    let sd = |row: usize| match &grows {
        Some(grows) => grows.times[row] * grows.least * if jump[row] { loud / quiet } else { 1.0 },
        None if jump[row] => loud,
        None => quiet,
    };
    let distance = |row: usize| apart[row].least.abs() / sd(row);
    let far: Vec<usize> = (0..misfit.len()).filter(|row| !jump[*row] && distance(*row) > FAR_OFF).collect();
    let apart_from_each_other = !together(&far, misfit.len());
    let heavy = far.len() >= FEWEST_FAR_OFF.max((SHARE_FAR_OFF * misfit.len() as f64) as usize) && apart_from_each_other;
    // one row is enough where chance makes none like it; a run may begin or end on its way to somewhere
    let inside = |row: usize| runs.iter().any(|run| row >= run.start + 2 && row + 2 < run.end);
    let wild = far.iter().copied().filter(|row| apart_from_each_other && distance(*row) > WILD && inside(*row));
    let wild: Vec<usize> = wild.collect();
    let any_wild = !wild.is_empty();
    if !heavy && !any_wild && grows.is_none() {
        return None;
    }
    let weighs_less = if heavy { WEIGHS_LESS } else { WILD };
    let (mut variance, mut clean) = (vec![0.0; misfit.len()], misfit.to_vec());
    for row in 0..misfit.len() {
        if let Some(grows) = &grows {
            let times = grows.times[row];
            variance[row] = grows.least.powi(2) * (times * times - 1.0);
            clean[row] -= apart[row].about * (1.0 - 1.0 / times);
        }
        let u = distance(row);
        if (heavy || (any_wild && !jump[row])) && u > weighs_less {
            variance[row] += sd(row).powi(2) * ((TAIL_FREEDOM + u * u) / (TAIL_FREEDOM + 1.0) - 1.0).max(0.0);
            clean[row] = misfit[row] - apart[row].about;
        }
    }
    let says = match (heavy, &grows) {
        (true, Some(grows)) => format!("heavy tails or spikes, and {}: such rows weigh less", grows.with),
        (false, Some(grows)) if any_wild => format!("single wild rows, and {}: such rows weigh less", grows.with),
        (false, Some(grows)) => format!("{}: louder rows weigh less", grows.with),
        (false, None) => WILD_ONLY.into(),
        _ => "heavy tails or spikes: such rows weigh less".into(),
    };
    Some(Louder { variance, clean, wild, only_wild: !heavy && grows.is_none(), says })
}

/// Rows next to a change of a column that is much larger than the usual ones about it.
fn jumps(column: &[f64], runs: &[Range<usize>]) -> Vec<bool> {
    let least = 1e-3 * spread(column);
    let mut found = vec![false; column.len()];
    for run in runs {
        let step = |row: usize| if row > run.start { (column[row] - column[row - 1]).abs() } else { 0.0 };
        for row in run.start + 1..run.end {
            let about: Vec<f64> = (row.saturating_sub(6).max(run.start + 1)..(row + 7).min(run.end)).map(step).collect();
            if step(row) > least.max(4.0 * median(&about)) {
                let near = row.saturating_sub(1).max(run.start)..(row + 2).min(run.end);
                found[near].fill(true);
            }
        }
    }
    found
}

/// Whether rows come together more often than by chance.
fn together(rows: &[usize], of: usize) -> bool {
    const NEAR: usize = 6;
    let pairs = rows.windows(2).filter(|w| w[1] - w[0] <= NEAR).count() as f64;
    let expected = rows.len() as f64 * (1.0 - (-(NEAR as f64) * rows.len() as f64 / of as f64).exp());
    pairs > 2.0 * expected + 3.0
}

#[cfg(test)]
mod tests {
    use super::*;
    use rand::SeedableRng;
    use rand_chacha::ChaCha8Rng;
    use rand_distr::{Distribution, StandardNormal, StudentT};
    use truegap_core::Inputs;

    fn found(misfit: &[f64], reading: &[f64], jumping: Option<&[f64]>) -> Option<Louder> {
        let inputs = Inputs { run: vec![1; misfit.len()], ..Inputs::default() };
        let runs = inputs.runs();
        louder(&Beside { inputs: &inputs, runs: &runs, value: reading, misfit, reading }, jumping.as_slice())
    }

    fn drawn(random: &mut ChaCha8Rng) -> f64 {
        StandardNormal.sample(random)
    }

    #[test]
    fn noise_of_one_size_has_no_louder_rows() {
        let reading: Vec<f64> = (0..3000).map(|i| f64::from(i % 100)).collect();
        for seed in 0..20 {
            let random = &mut ChaCha8Rng::seed_from_u64(seed);
            let noise: Vec<f64> = (0..3000).map(|_| drawn(random)).collect();
            assert!(found(&noise, &reading, None).is_none_or(|found| panic!("{seed}: {}", found.says)));
        }
    }

    /// The weights of a t distribution make the squares of its draws those of unit noise.
    #[test]
    fn heavy_tails_weigh_as_much_as_their_scatter_says() {
        let random = &mut ChaCha8Rng::seed_from_u64(3);
        let t = StudentT::new(3.0).unwrap();
        let noise: Vec<f64> = (0..4000).map(|_| t.sample(random)).collect();
        let found = found(&noise, &[0.0; 4000], None).unwrap();
        // quiet rows: the middle of the distribution has the scatter 1.134
        let squares: f64 = noise.iter().zip(&found.variance).map(|(n, v)| n * n / (1.134f64.powi(2) + v)).sum();
        assert!((0.7..1.2).contains(&(squares / 4000.0)), "{}", squares / 4000.0);
    }

    #[test]
    fn a_single_wild_row_weighs_less_and_the_others_as_before() {
        let random = &mut ChaCha8Rng::seed_from_u64(8);
        let mut noise: Vec<f64> = (0..600).map(|_| drawn(random)).collect();
        noise[211] += 25.0;
        let found = found(&noise, &[0.0; 600], None).unwrap();
        assert_eq!(found.wild, [211]);
        assert_eq!(found.variance.iter().filter(|v| **v > 0.0).count(), 1);
        // as Student's t has it, it then stands out by twice the scatter
        assert!((noise[211] / (1.0 + found.variance[211]).sqrt() - 2.0).abs() < 0.3, "{}", found.variance[211]);
        assert!(found.clean[211].abs() < 3.0);
    }

    #[test]
    fn bursts_and_jumps_that_stay_are_not_taken_for_spikes() {
        let random = &mut ChaCha8Rng::seed_from_u64(4);
        let mut noise: Vec<f64> = (0..3000).map(|i| drawn(random) + if i / 300 % 2 == 1 { 30.0 } else { 0.0 }).collect();
        assert!(found(&noise, &[0.0; 3000], None).is_none());
        for row in (500..530).chain(1700..1730) {
            noise[row] += 30.0 * drawn(random);
        }
        assert!(found(&noise, &[0.0; 3000], None).is_none());
    }

    #[test]
    fn a_late_reading_of_a_staircase_is_not_taken_for_spikes() {
        let random = &mut ChaCha8Rng::seed_from_u64(5);
        let load: Vec<f64> = (0..3000).map(|i| f64::from(i / 50 % 5)).collect();
        // one row in fifty, at the jump, is off by 40 standard deviations
        let noise: Vec<f64> = (0..3000).map(|i| drawn(random) + if i % 50 == 0 { 40.0 } else { 0.0 }).collect();
        assert!(found(&noise, &[0.0; 3000], Some(&load)).is_none());
    }

    #[test]
    fn noise_that_grows_with_the_reading_is_seen_to() {
        let random = &mut ChaCha8Rng::seed_from_u64(6);
        let reading: Vec<f64> = (0..4000).map(|i| f64::from(i % 100) / 99.0).collect();
        let noise: Vec<f64> = reading.iter().map(|r| drawn(random) * (1.0 + 8.0 * r * r).sqrt()).collect();
        let found = found(&noise, &reading, None).unwrap();
        // at the highest reading: nine times the variance of the lowest
        let top = (0..4000).filter(|i| i % 100 > 95).map(|i| found.variance[i]).sum::<f64>() / 160.0;
        assert!((4.0..14.0).contains(&top), "{top}");
    }
}
