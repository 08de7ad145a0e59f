//! Rows of a reading that are louder than the rest: heavy tails, spikes, noise that grows with the reading.
//!
//! None of it is physics of a sensor, and none of it hides any: a row weighs less the further it stands from its neighbours on both sides. A jump that stays is no spike,
//! nor is a row at which an input jumps too, unless it stands out among those; where loud rows come together they are bursts, which are not taken for noise.
//!
//! Limits: judged beside the calibrated base model; up to two loud rows in four.
//!
//! **Source:** weights of Student's t by iterated least squares, Lange, Little and Taylor, J. Am. Stat. Assoc. 84, 881 (1989), section 3.

use crate::{
    noise::tuning::{
        BESIDE, FAR_OFF, FEWEST_FAR_OFF, GROWS_EVENLY, NOISE_GROWS, READING_GROUPS, ROWS_OF_A_GROUP, SHARE_FAR_OFF, TAIL_FREEDOM,
        WEIGHS_LESS,
    },
    stats::{median, spread},
};
use std::ops::Range;

/// Median absolute value of a unit normal.
const MEDIAN_NORMAL: f64 = 0.674_489_750_196_081_7;

/// How loud each row is beside its neighbours.
pub struct Louder {
    /// variance above that of the quiet rows
    pub variance: Vec<f64>,
    /// what was given, with the middle of the neighbours in place of what stands out
    pub clean: Vec<f64>,
    /// what it is, for a reader
    pub says: &'static str,
}

/// Rows of `misfit` that are louder than others; `load` is what jumps, `reading` what noise may grow with. `None` where noise is the same in all rows.
pub fn louder(misfit: &[f64], runs: &[Range<usize>], load: Option<&[f64]>, reading: &[f64]) -> Option<Louder> {
    let apart = apart(misfit, runs);
    let jump: Vec<bool> = (0..misfit.len()).map(|_| false).collect();
    let jump = load.map_or(jump, |load| jumps(load, runs));
    let scale = |jumps: bool| {
        let of: Vec<f64> = apart.iter().zip(&jump).filter(|(_, j)| **j == jumps).map(|(d, _)| d.about.abs()).collect();
        median(&of) / MEDIAN_NORMAL
    };
    let quiet = scale(false);
    if quiet <= 0.0 {
        return None;
    }
    let loud = quiet.max(scale(true));
    let distance = |row: usize| apart[row].least.abs() / if jump[row] { loud } else { quiet };
    let far: Vec<usize> = (0..misfit.len()).filter(|row| !jump[*row] && distance(*row) > FAR_OFF).collect();
    let heavy = far.len() >= FEWEST_FAR_OFF.max((SHARE_FAR_OFF * misfit.len() as f64) as usize) && !together(&far, misfit.len());
    let (grows, quiet) = growth(&apart, reading, quiet).map_or((None, quiet), |(grows, least)| (Some(grows), least));
    if !heavy && grows.is_none() {
        return None;
    }
    let (mut variance, mut clean) = (vec![0.0; misfit.len()], misfit.to_vec());
    for row in 0..misfit.len() {
        let more = grows.as_ref().map_or(1.0, |grows| grows[row]);
        variance[row] = quiet * quiet * (more * more - 1.0);
        let u = distance(row) / more;
        if heavy && u > WEIGHS_LESS {
            let sd = if jump[row] { loud } else { quiet } * more;
            variance[row] += sd * sd * ((TAIL_FREEDOM + u * u) / (TAIL_FREEDOM + 1.0) - 1.0).max(0.0);
            clean[row] -= apart[row].about;
        }
        if grows.is_some() {
            clean[row] -= apart[row].about * (1.0 - 1.0 / more);
        }
    }
    let says = match (heavy, grows.is_some()) {
        (true, true) => "heavy tails or spikes, and noise that grows with the reading: such rows weigh less",
        (true, false) => "heavy tails or spikes: such rows weigh less",
        _ => "noise that grows with the reading: louder rows weigh less",
    };
    Some(Louder { variance, clean, says })
}

/// How far a row stands from its neighbours.
#[derive(Clone, Copy, Default)]
struct Apart {
    /// from the middle of those on both sides
    about: f64,
    /// from the nearer side, 0 where it lies between the two
    least: f64,
}

fn apart(misfit: &[f64], runs: &[Range<usize>]) -> Vec<Apart> {
    let mut all = vec![Apart::default(); misfit.len()];
    for run in runs.iter().filter(|r| r.len() > 2 * BESIDE) {
        for row in run.clone() {
            let before = &misfit[row.saturating_sub(BESIDE).max(run.start)..row];
            let after = &misfit[row + 1..(row + 1 + BESIDE).min(run.end)];
            let both: Vec<f64> = before.iter().chain(after).copied().collect();
            let about = misfit[row] - median(&both);
            let sides = [before, after].map(|side| if side.len() > 1 { misfit[row] - middle(side) } else { about });
            let least = if sides[0] * sides[1] > 0.0 { sides[0].abs().min(sides[1].abs()) * sides[0].signum() } else { 0.0 };
            all[row] = Apart { about, least };
        }
    }
    all
}

/// Median of a few values, between the middle two of an even number.
fn middle(values: &[f64]) -> f64 {
    let mut sorted = values.to_vec();
    sorted.sort_by(f64::total_cmp);
    0.5 * (sorted[(sorted.len() - 1) / 2] + sorted[sorted.len() / 2])
}

/// Rows next to a change of the load that is much larger than the usual ones about it.
fn jumps(load: &[f64], runs: &[Range<usize>]) -> Vec<bool> {
    let least = 1e-3 * spread(load);
    let mut found = vec![false; load.len()];
    for run in runs {
        let step = |row: usize| if row > run.start { (load[row] - load[row - 1]).abs() } else { 0.0 };
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

/// Scatter of each row over that of the quietest, and the latter, where it grows along the reading; `quiet` is the scatter of all.
fn growth(apart: &[Apart], reading: &[f64], quiet: f64) -> Option<(Vec<f64>, f64)> {
    let (least, range) = (reading.iter().copied().fold(f64::INFINITY, f64::min), spread(reading));
    if range <= 0.0 || reading.len() < ROWS_OF_A_GROUP * READING_GROUPS {
        return None;
    }
    let mut order: Vec<usize> = (0..reading.len()).collect();
    order.sort_by(|a, b| reading[*a].total_cmp(&reading[*b]));
    let groups: Vec<(f64, f64)> = order
        .chunks(reading.len().div_ceil(READING_GROUPS))
        .map(|rows| {
            let at = rows.iter().map(|r| (reading[*r] - least) / range).sum::<f64>() / rows.len() as f64;
            (at, median(&rows.iter().map(|r| apart[*r].about.abs()).collect::<Vec<_>>()) / MEDIAN_NORMAL / quiet)
        })
        .collect();
    // squares of two independent parts add: variance = a + b x^2
    let n = groups.len() as f64;
    let (mx, my) = groups.iter().fold((0.0, 0.0), |(x, y), (at, sd)| (x + at * at / n, y + sd * sd / n));
    let (sxx, sxy, syy) = groups.iter().fold((0.0, 0.0, 0.0), |(a, b, c), (at, sd)| {
        let (x, y) = (at * at - mx, sd * sd - my);
        (a + x * x, b + x * y, c + y * y)
    });
    // the fit weighs the louder groups, the quieter ones must agree
    let clear = groups.first().zip(groups.last()).is_some_and(|(low, high)| high.1 > NOISE_GROWS * low.1);
    if !clear || sxx <= 0.0 || sxy <= 0.0 || sxy * sxy < GROWS_EVENLY * sxx * syy {
        return None;
    }
    let slope = sxy / sxx;
    let start = (my - slope * mx).max(0.05 * my);
    let of = |r: &f64| (1.0 + slope / start * ((r - least) / range).powi(2)).sqrt();
    (of(&(least + range)) > NOISE_GROWS).then(|| (reading.iter().map(of).collect(), quiet * start.sqrt()))
}

#[cfg(test)]
#[allow(clippy::single_range_in_vec_init)]
mod tests {
    use super::*;
    use rand::SeedableRng;
    use rand_chacha::ChaCha8Rng;
    use rand_distr::{Distribution, StandardNormal, StudentT};

    fn drawn(random: &mut ChaCha8Rng) -> f64 {
        StandardNormal.sample(random)
    }

    #[test]
    fn noise_of_one_size_has_no_louder_rows() {
        let reading: Vec<f64> = (0..3000).map(|i| f64::from(i % 100)).collect();
        for seed in 0..20 {
            let random = &mut ChaCha8Rng::seed_from_u64(seed);
            let noise: Vec<f64> = (0..3000).map(|_| drawn(random)).collect();
            assert!(louder(&noise, &[0..3000], None, &reading).is_none_or(|found| panic!("{seed}: {}", found.says)));
        }
    }

    /// The weights of a t distribution make the squares of its draws those of unit noise.
    #[test]
    fn heavy_tails_weigh_as_much_as_their_scatter_says() {
        let random = &mut ChaCha8Rng::seed_from_u64(3);
        let t = StudentT::new(3.0).unwrap();
        let noise: Vec<f64> = (0..4000).map(|_| t.sample(random)).collect();
        let found = louder(&noise, &[0..4000], None, &vec![0.0; 4000]).unwrap();
        // quiet rows: the middle of the distribution has the scatter 1.134
        let squares: f64 = noise.iter().zip(&found.variance).map(|(n, v)| n * n / (1.134f64.powi(2) + v)).sum();
        assert!((0.7..1.2).contains(&(squares / 4000.0)), "{}", squares / 4000.0);
    }

    #[test]
    fn bursts_and_jumps_that_stay_are_not_taken_for_spikes() {
        let random = &mut ChaCha8Rng::seed_from_u64(4);
        let mut noise: Vec<f64> = (0..3000).map(|i| drawn(random) + if i / 300 % 2 == 1 { 30.0 } else { 0.0 }).collect();
        assert!(louder(&noise, &[0..3000], None, &vec![0.0; 3000]).is_none());
        for row in (500..530).chain(1700..1730) {
            noise[row] += 30.0 * drawn(random);
        }
        assert!(louder(&noise, &[0..3000], None, &vec![0.0; 3000]).is_none());
    }

    #[test]
    fn a_late_reading_of_a_staircase_is_not_taken_for_spikes() {
        let random = &mut ChaCha8Rng::seed_from_u64(5);
        let load: Vec<f64> = (0..3000).map(|i| f64::from(i / 50 % 5)).collect();
        // one row in fifty, at the jump, is off by 40 standard deviations
        let noise: Vec<f64> = (0..3000).map(|i| drawn(random) + if i % 50 == 0 { 40.0 } else { 0.0 }).collect();
        assert!(louder(&noise, &[0..3000], Some(&load), &vec![0.0; 3000]).is_none());
    }

    #[test]
    fn noise_that_grows_with_the_reading_is_seen_to() {
        let random = &mut ChaCha8Rng::seed_from_u64(6);
        let reading: Vec<f64> = (0..4000).map(|i| f64::from(i % 100) / 99.0).collect();
        let noise: Vec<f64> = reading.iter().map(|r| drawn(random) * (1.0 + 8.0 * r * r).sqrt()).collect();
        let found = louder(&noise, &[0..4000], None, &reading).unwrap();
        // at the highest reading: nine times the variance of the lowest
        let top = (0..4000).filter(|i| i % 100 > 95).map(|i| found.variance[i]).sum::<f64>() / 160.0;
        assert!((4.0..14.0).contains(&top), "{top}");
    }
}
