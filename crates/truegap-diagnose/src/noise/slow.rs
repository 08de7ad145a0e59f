//! Slow noise beside white, told from noise with one memory at rest.
//!
//! Limits: a spectrum like 1/f; stretches at rest are often too short to tell it from noise with one memory.

use crate::{
    noise::{
        reml::{Block, WHITE, likelihood, mixed},
        slow_parts::slow_parts,
        tuning::{CLEARLY_COLOURED, SLOW_SHARES, STILL_ALLOWED},
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
    let Some(one) = of_one_memory(response, blocks, chosen) else { return Vec::new() };
    let tried = tried(response, blocks);
    let most = likeliest(&tried).map_or(one, |best| best.log_likelihood.max(one));
    tried.into_iter().filter(|slow| slow.log_likelihood > most - STILL_ALLOWED).collect()
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
}
