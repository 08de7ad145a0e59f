//! Slow noise as the filter knows it: autoregressive parts of one size whose memories lie a factor of eight apart have a spectrum like 1/f.
//!
//! Limits: memories count rows, whatever the time between them.

use crate::{
    noise::tuning::{FEWEST_MEMORIES, LONGER_MEMORY, SHORTEST_MEMORY},
    whitening::whitener::Lasting,
};

/// Memories of the parts, rows: up to the length of the recording, for 1/f noise has no longest one.
fn memories(rows: usize) -> impl Iterator<Item = f64> {
    let memory = |k: usize| SHORTEST_MEMORY * LONGER_MEMORY.powi(k as i32);
    (0..).take_while(move |k| *k < FEWEST_MEMORIES || memory(*k) <= rows as f64).map(memory)
}

/// Slow noise with this variance in each part, of `rows` rows.
pub(crate) fn slow_parts(rows: usize, variance: f64) -> Vec<Lasting> {
    let part =
        |memory: f64| Lasting { variance: vec![variance; rows], memory: vec![(-1.0 / memory).exp(); rows], of_reading: true };
    memories(rows).map(part).collect()
}

#[cfg(test)]
mod tests {
    use super::*;

    /// The spectrum of the parts of a long recording falls like 1/f: by closed form, the sum of Lorentzians.
    #[test]
    fn the_parts_of_a_long_recording_have_a_spectrum_like_one_over_f() {
        let parts = slow_parts(60_000, 1.0);
        let spectrum = |f: f64| {
            let omega = std::f64::consts::TAU * f;
            parts
                .iter()
                .map(|p| (1.0 - p.memory[0].powi(2)) / (1.0 + p.memory[0].powi(2) - 2.0 * p.memory[0] * omega.cos()))
                .sum::<f64>()
        };
        for f in [3e-5, 1e-4, 1e-3, 1e-2] {
            // a factor of eight between the parts leaves a ripple of a fifth about the line
            approx::assert_relative_eq!(spectrum(f) / spectrum(8.0 * f), 8.0, max_relative = 0.25);
        }
    }

    #[test]
    fn a_short_recording_has_the_fewest_parts() {
        assert_eq!((slow_parts(100, 1.0).len(), slow_parts(6_668, 1.0).len()), (FEWEST_MEMORIES, 5));
    }
}
