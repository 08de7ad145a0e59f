//! Rows that are louder than others, where no clock says which rows follow one another: beside rows at neighbouring inputs.
//!
//! Of each group of neighbours the course that its noise was measured beside is taken out, and groups follow one another as their inputs do. What stands far from its neighbours, or where the reading is large, weighs less
//! then, as along a clock. Without that the groups at small readings alone say how loud all are, and a noise that grows with the reading looks like a zero that wanders.
//!
//! Limits: as [`crate::noise::louder`] and [`crate::noise::neighbours`]; nothing grows with the speed of a reading that has no clock.

use crate::noise::{
    grows::Beside,
    louder::{Louder, louder},
    reml::Block,
};
use truegap_core::Inputs;

/// Rows of `misfit` that are louder than their neighbours in these groups; those of no group are as loud as they are taken for. `None` where noise is the same in all rows.
pub(crate) fn louder_neighbours(groups: &[Block], inputs: &Inputs, misfit: &[f64], reading: &[f64]) -> Option<Louder> {
    let order: Vec<usize> = groups.iter().flat_map(|group| group.rows.iter().copied()).collect();
    let left: Vec<f64> = groups.iter().flat_map(|group| group.left(misfit)).collect();
    let of = |column: &[f64]| order.iter().map(|row| column[*row]).collect::<Vec<f64>>();
    let (reading_of, value) = (of(reading), vec![0.0; order.len()]);
    let runs = std::slice::from_ref(&(0..order.len())).to_vec();
    let beside = Beside { inputs, runs: &runs, value: &value, misfit: &left, reading: &reading_of };
    let found = if order.is_empty() { None } else { louder(&beside, &[]) }?;
    let (mut variance, mut clean) = (vec![0.0; misfit.len()], misfit.to_vec());
    for (place, row) in order.iter().enumerate() {
        variance[*row] = found.variance[place];
        clean[*row] += found.clean[place] - left[place];
    }
    let wild = found.wild.iter().map(|place| order[*place]).collect();
    Some(Louder { variance, clean, wild, ..found })
}

impl Block {
    /// What the course of the rows leaves of a column there, as loud as it is in all.
    fn left(&self, column: &[f64]) -> Vec<f64> {
        let mut left: Vec<f64> = self.rows.iter().map(|row| column[*row]).collect();
        for course in self.course() {
            let along: f64 = left.iter().zip(course).map(|(a, b)| a * b).sum::<f64>();
            left.iter_mut().zip(course).for_each(|(left, course)| *left -= along * course);
        }
        let all = self.rows.len() as f64;
        let freedom = (all / (all - self.course().len() as f64)).sqrt();
        left.iter_mut().for_each(|left| *left *= freedom);
        left
    }
}

#[cfg(test)]
#[allow(clippy::unwrap_used)]
mod tests {
    use super::*;
    use crate::noise::neighbours::neighbours;
    use rand::{SeedableRng, seq::SliceRandom};
    use rand_chacha::ChaCha8Rng;
    use rand_distr::{Distribution, StandardNormal};

    const ROWS: usize = 900;

    fn permuted(seed: u64, size: impl Fn(f64) -> f64) -> (Inputs, Vec<f64>, Vec<f64>) {
        let random = &mut ChaCha8Rng::seed_from_u64(seed);
        let mut force: Vec<f64> = (0..ROWS).map(|row| row as f64 / ROWS as f64).collect();
        force.shuffle(random);
        let mut drawn = || -> f64 { StandardNormal.sample(random) };
        let misfit: Vec<f64> = force.iter().map(|f| f * f + size(*f) * drawn()).collect();
        let reading = force.iter().zip(&misfit).map(|(f, m)| 20.0 * f + m).collect();
        (Inputs { run: vec![1; ROWS], force_n: Some(force), ..Inputs::default() }, misfit, reading)
    }

    /// Variance of a row by closed form: `0.1^2 + f^2` of the full load.
    #[test]
    fn noise_that_grows_with_the_reading_is_told_without_a_clock() {
        let (inputs, misfit, reading) = permuted(3, |f| 0.1f64.hypot(f));
        let force = inputs.force_n.as_deref().unwrap();
        let found = louder_neighbours(&neighbours(&inputs, Some(force)), &inputs, &misfit, &reading).unwrap();
        let of = |low: f64, high: f64| {
            let rows: Vec<usize> = (0..ROWS).filter(|row| (low..high).contains(&force[*row])).collect();
            let told = rows.iter().map(|row| found.variance[*row]).sum::<f64>();
            let true_one = rows.iter().map(|row| force[*row].powi(2)).sum::<f64>();
            told / true_one
        };
        // 450 rows know a variance to 7 %, six groups and a course taken out to some 25 %
        assert!((0.6..1.5).contains(&of(0.5, 1.0)), "{}", of(0.5, 1.0));
    }

    #[test]
    fn noise_of_one_size_has_no_louder_neighbours() {
        for seed in 0..10 {
            let (inputs, misfit, reading) = permuted(seed, |_| 0.3);
            let groups = neighbours(&inputs, inputs.force_n.as_deref());
            assert!(louder_neighbours(&groups, &inputs, &misfit, &reading).is_none(), "{seed}");
        }
    }
}
