//! Slow noise beside white, told from noise with one memory at rest.
//!
//! Limits: a spectrum like 1/f; stretches at rest are often too short to tell it from noise with one memory.

use crate::{
    noise::{
        reml::{self, Block, WHITE, likelihood, mixed},
        slow_parts::slow_parts,
        tuning::{CLEARLY_COLOURED, MEMORIES_OF_A_STRETCH, SLOW_SHARES, STILL_ALLOWED},
    },
    whitening::whitener::{InputError, Noise},
};

/// White noise with slow noise beside it.
#[derive(Clone, Copy, Debug)]
pub struct Slow {
    /// standard deviation of the white part
    pub white_sd: f64,
    /// standard deviation of each slow part
    pub part_sd: f64,
    /// log likelihood in the stretches
    log_likelihood: f64,
}

/// Slow noise where it is clearly likelier than `chosen`, the best noise with one memory.
pub fn slow(response: &[f64], blocks: &[Block], chosen: &Noise) -> Option<Slow> {
    let one = of_one_memory(response, blocks, chosen)?;
    let best = likeliest(&tried(response, blocks))?;
    (best.log_likelihood > one + CLEARLY_COLOURED).then_some(best)
}

/// The slow noises that the stretches allow beside `chosen`, where they do not tell them apart.
pub fn allowed(response: &[f64], blocks: &[Block], chosen: &Noise) -> Vec<Slow> {
    let Some((tried, least)) = still_allowed(response, blocks, chosen) else { return Vec::new() };
    tried.into_iter().filter(|slow| slow.log_likelihood > least).collect()
}

/// The noises of one memory that the stretches allow beside `chosen`, each of a memory of which the longest stretch holds many: a longer one goes with the slow course that is taken out, and with whatever is
/// missing.
pub fn allowed_memories(response: &[f64], blocks: &[Block], chosen: &Noise) -> Vec<Noise> {
    let Some((_, least)) = still_allowed(response, blocks, chosen) else { return Vec::new() };
    let longest = blocks.iter().map(|block| block.rows.len()).max().unwrap_or(0) as f64;
    let seen = |noise: &Noise| MEMORIES_OF_A_STRETCH * -noise.ar_correlation.ln().recip() <= longest;
    let likely = reml::of_one_memory(response, blocks).into_iter().filter(|one| one.log_likelihood > least);
    likely.map(|one| one.noise()).filter(seen).collect()
}

/// The slow noises that are tried, and the log likelihood above which stretches allow a noise beside `chosen`.
fn still_allowed(response: &[f64], blocks: &[Block], chosen: &Noise) -> Option<(Vec<Slow>, f64)> {
    let one = of_one_memory(response, blocks, chosen)?;
    let tried = tried(response, blocks);
    let most = likeliest(&tried).map_or(one, |best| best.log_likelihood.max(one));
    Some((tried, most - STILL_ALLOWED))
}

/// Adds the parts of slow noise to the errors that last.
pub fn beside(error: &mut InputError, rows: usize, slow: Slow) {
    error.lasting.extend(slow_parts(rows, slow.part_sd * slow.part_sd));
}

/// Log likelihood of the best noise with one memory.
fn of_one_memory(response: &[f64], blocks: &[Block], chosen: &Noise) -> Option<f64> {
    let total = chosen.white_sd.hypot(chosen.ar_sd);
    let share = (total > 0.0).then(|| (chosen.ar_sd / total).powi(2))?;
    Some(likelihood(response, blocks, &mixed(chosen.ar_correlation, share), 0.0).0)
}

/// White noise with slow parts of every size tried.
fn tried(response: &[f64], blocks: &[Block]) -> Vec<Slow> {
    let one = |part: f64| {
        let (log_likelihood, variance) = likelihood(response, blocks, &WHITE, part);
        Slow { white_sd: variance.sqrt(), part_sd: (variance * part).sqrt(), log_likelihood }
    };
    SLOW_SHARES.map(one).into_iter().filter(|slow| slow.log_likelihood.is_finite()).collect()
}

fn likeliest(tried: &[Slow]) -> Option<Slow> {
    tried.iter().copied().max_by(|a, b| a.log_likelihood.total_cmp(&b.log_likelihood))
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::noise::reml::estimate;
    use rand::SeedableRng;
    use rand_distr::Distribution;

    /// White noise beside autoregressive parts with these memories, rows, all of one size, each drawn for itself.
    fn drawn(white: f64, memories: &[f64], rows: usize, seed: u64) -> Vec<f64> {
        let mut rng = rand_chacha::ChaCha8Rng::seed_from_u64(seed);
        let unit = rand_distr::Normal::new(0.0, 1.0).unwrap();
        let memory: Vec<f64> = memories.iter().map(|m| (-1.0 / m).exp()).collect();
        let mut state: Vec<f64> = memory.iter().map(|_| unit.sample(&mut rng)).collect();
        (0..rows)
            .map(|_| {
                state.iter_mut().zip(&memory).for_each(|(s, m)| *s = m * *s + (1.0 - m * m).sqrt() * unit.sample(&mut rng));
                state.iter().sum::<f64>() + white * unit.sample(&mut rng)
            })
            .collect()
    }

    /// Parts a factor of four apart: not the model's own.
    #[test]
    fn slow_noise_is_told_from_noise_of_one_memory() {
        let blocks = [Block::at_rest(0..1500), Block::at_rest(1500..3000)];
        let found = |y: &[f64]| slow(y, &blocks, &estimate(y, &blocks).0).is_some();
        let flicker: Vec<f64> = (0..7).map(|k| 4f64.powi(k)).collect();
        assert!(found(&drawn(2.0, &flicker, 3000, 11)));
        assert!(!found(&drawn(1.0, &[2.8], 3000, 7)));
    }

    /// Four stretches of fifty rows each: too few to tell a memory of two rows from none, or from slow noise.
    #[test]
    fn short_stretches_allow_the_memory_that_is_there_whatever_they_are_taken_for() {
        let blocks: Vec<Block> = (0..4).map(|k| Block::at_rest(50 * k..50 * (k + 1))).collect();
        for seed in 1..6 {
            let y = drawn(1.2, &[1.5], 200, seed);
            let right = |noise: &Noise| noise.ar_correlation == 0.5 && (noise.ar_sd / noise.white_sd).powi(2) < 1.0;
            let found = allowed_memories(&y, &blocks, &estimate(&y, &blocks).0);
            assert!(found.iter().any(right), "{seed}");
            // a tenth of a stretch: five rows
            let memory = |noise: &Noise| -noise.ar_correlation.ln().recip();
            assert!(found.iter().all(|noise| memory(noise) <= 5.0), "{seed}");
        }
    }
}
