//! Inputs that switch from row to row: by themselves they look like noise, but the reading follows them.
//!
//! Limits: a reading that comes later than [`LATEST_ROW`] rows, or is buried in noise of its own, does not show that it follows.

use crate::{
    data::problem::Problem,
    noise::input::scatter,
    noise::tuning::{BY_CHANCE, LATEST_ROW, ONLY_NOISE},
    stats::spread,
};
use std::ops::Range;
use truegap_core::Inputs;

/// Whether a column is no wider than the noise that its changes from row to row would have.
pub fn looks_like_noise(column: &[f64], inputs: &Inputs, runs: &[Range<usize>]) -> bool {
    spread(column) <= ONLY_NOISE * scatter(column, inputs.time_s.as_deref(), runs)
}

/// Whether the load switches from row to row, and the reading with it: its changes are no noise.
pub fn load_switches(problem: &Problem<'_>) -> bool {
    let runs = problem.runs();
    let load = problem.simulator.load(problem.inputs);
    load.is_some_and(|load| looks_like_noise(&load, problem.inputs, &runs) && followed(&load, problem.response, &runs))
}

/// Whether the reading's changes follow the changes of a column: what switches from row to row looks like noise by itself, but noise moves nothing.
pub fn followed(column: &[f64], response: &[f64], runs: &[Range<usize>]) -> bool {
    let changes =
        |x: &[f64]| -> Vec<Vec<f64>> { runs.iter().map(|r| x[r.clone()].windows(2).map(|w| w[1] - w[0]).collect()).collect() };
    let (causes, effects) = (changes(column), changes(response));
    (0..=LATEST_ROW).any(|late| {
        let pairs = || causes.iter().zip(&effects).flat_map(|(c, e)| c.iter().zip(e.iter().skip(late)));
        let sum = |f: fn(f64, f64) -> f64| pairs().map(|(c, e)| f(*c, *e)).sum::<f64>();
        let scale = (sum(|c, _| c * c) * sum(|_, e| e * e)).sqrt();
        scale > 0.0 && sum(|c, e| c * e).abs() / scale > BY_CHANCE / (pairs().count() as f64).sqrt()
    })
}

#[cfg(test)]
#[allow(clippy::single_range_in_vec_init)]
mod tests {
    use super::*;
    use rand::SeedableRng;
    use rand_distr::{Distribution, StandardNormal, Uniform};

    /// 0 to 0.6 N at random in each row, and a reading that follows by a lag of two rows under noise of a tenth of its range.
    #[test]
    fn a_load_that_jumps_in_every_row_is_followed_and_noise_is_not() {
        let random = &mut rand_chacha::ChaCha8Rng::seed_from_u64(3);
        let jumps = Uniform::new(0.0, 0.6).unwrap();
        let load: Vec<f64> = (0..4000).map(|_| jumps.sample(random)).collect();
        let mut state = 0.3;
        let draw = |random: &mut rand_chacha::ChaCha8Rng| -> f64 { StandardNormal.sample(random) };
        let mut reading = Vec::new();
        for value in &load {
            state += 0.4 * (value - state);
            reading.push(state + 0.06 * draw(random));
        }
        let inputs = Inputs { run: vec![1; 4000], ..Inputs::default() };
        assert!(looks_like_noise(&load, &inputs, &[0..4000]) && followed(&load, &reading, &[0..4000]));
        let noise: Vec<f64> = load.iter().map(|_| 0.2 + 0.003 * draw(random)).collect();
        assert!(looks_like_noise(&noise, &inputs, &[0..4000]) && !followed(&noise, &reading, &[0..4000]));
    }
}
