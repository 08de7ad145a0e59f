//! Noise that grows: with the reading, or with how fast the reading changes.
//!
//! Two instruments that look at one quantity a little apart, in time or in place, differ by as much as the quantity changes in between: where it changes fast their
//! difference is loud, of either sign.
//!
//! Limits: independent parts, whose squares add; what follows the reading and the drivers by a smooth law, or late by one or two time constants, is physics and no noise.

use crate::{
    effects::memory::rates,
    noise::{
        apart::{Apart, apart},
        follows_drivers::{laws, without},
        tuning::{EVEN_SPEEDS, GROWS_EVENLY, NOISE_GROWS, READING_GROUPS, ROWS_OF_A_GROUP},
    },
    stats::{MEDIAN_NORMAL, median, spread},
};
use std::ops::Range;
use truegap_core::Inputs;

/// How the noise of a recording grows.
pub(crate) struct Grows {
    /// scatter of each row over that of the quietest
    pub times: Vec<f64>,
    /// scatter of the quietest
    pub least: f64,
    /// with what, for a reader
    pub with: &'static str,
}

/// A calibrated model beside its recording.
pub(crate) struct Beside<'a> {
    pub inputs: &'a Inputs,
    pub runs: &'a [Range<usize>],
    /// what the model says
    pub value: &'a [f64],
    /// recording less model
    pub misfit: &'a [f64],
    /// what was read
    pub reading: &'a [f64],
}

/// The law under which the scatter of the rows is likelier, where noise grows at all; `quiet` is the scatter of all rows.
pub(crate) fn grows(beside: &Beside<'_>, apart: &[Apart], quiet: f64) -> Option<Grows> {
    let laws = [with_reading(apart, beside.reading, quiet), with_speed(beside)];
    let unlikely = |law: &Grows| {
        // the scatter of normal noise by its absolute value, which spikes move little
        let of = |(row, a): (usize, &Apart)| {
            let sd = law.least * law.times[row];
            sd.ln() + a.about.abs() / sd / MEAN_NORMAL
        };
        apart.iter().enumerate().map(of).sum::<f64>()
    };
    laws.into_iter().flatten().min_by(|a, b| unlikely(a).total_cmp(&unlikely(b)))
}

/// Mean absolute value of a unit normal.
const MEAN_NORMAL: f64 = 0.797_884_560_802_865_4;

/// Typical place and scatter of groups of rows of equal number, in order of `along`.
fn groups(along: &[f64], apart: &[Apart]) -> Option<Vec<(f64, f64)>> {
    if along.len() < ROWS_OF_A_GROUP * READING_GROUPS {
        return None;
    }
    let mut order: Vec<usize> = (0..along.len()).collect();
    order.sort_by(|a, b| along[*a].total_cmp(&along[*b]));
    let of = |rows: &[usize]| {
        let column = |value: &dyn Fn(usize) -> f64| rows.iter().map(|row| value(*row)).collect::<Vec<_>>();
        (median(&column(&|row| along[row])), median(&column(&|row| apart[row].about.abs())) / MEDIAN_NORMAL)
    };
    Some(order.chunks(along.len().div_ceil(READING_GROUPS)).map(of).collect())
}

/// Noise that grows with the reading above its least value.
fn with_reading(apart: &[Apart], reading: &[f64], quiet: f64) -> Option<Grows> {
    let (least, range) = (reading.iter().copied().fold(f64::INFINITY, f64::min), spread(reading));
    if range <= 0.0 {
        return None;
    }
    let above: Vec<f64> = reading.iter().map(|r| (r - least) / range).collect();
    let groups: Vec<(f64, f64)> = groups(&above, apart)?.into_iter().map(|(at, sd)| (at, sd / quiet)).collect();
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
    let times = |at: f64| (1.0 + slope / start * at * at).sqrt();
    let found = Grows {
        times: above.into_iter().map(times).collect(),
        least: quiet * start.sqrt(),
        with: "noise that grows with the reading",
    };
    (times(1.0) > NOISE_GROWS).then_some(found)
}

/// Noise that grows with the speed of what the model says.
///
/// A late or bent reading is off where it changes fast, too, but by a law: that is taken out first.
fn with_speed(beside: &Beside<'_>) -> Option<Grows> {
    let Beside { inputs, runs, value, misfit, .. } = *beside;
    let speed: Vec<f64> = rates(inputs.time_s.as_deref(), value, runs).into_iter().map(f64::abs).collect();
    if value.len() < ROWS_OF_A_GROUP * READING_GROUPS || spread(&speed) <= 0.0 {
        return None;
    }
    let apart = apart(&without(&followed(beside), misfit, runs), runs);
    let groups = groups(&speed, &apart)?;
    let (slowest, fastest) = (groups.first()?, groups.last()?);
    let [start, slope] = two_parts(&groups)?;
    let times = |speed: f64| (1.0 + slope / start * speed * speed).sqrt();
    let even = |(at, sd): &(f64, f64)| {
        let off = sd / (start.sqrt() * times(*at));
        (1.0 / EVEN_SPEEDS..EVEN_SPEEDS).contains(&off)
    };
    if fastest.1 <= NOISE_GROWS * slowest.1 || !groups.iter().all(even) {
        return None;
    }
    let times = speed.into_iter().map(times).collect();
    Some(Grows { times, least: start.sqrt(), with: "noise that grows with the speed of the reading" })
}

/// What follows the reading and the drivers by a law: curves and ways of both, gains, and what is late, by the reading and the misfit of rows close by.
fn followed(beside: &Beside<'_>) -> Vec<Vec<f64>> {
    let Beside { inputs, runs, value, misfit, .. } = *beside;
    let shifted = |column: &[f64], shift: isize| {
        let mut moved = column.to_vec();
        for run in runs {
            let (first, last) = (run.start as isize, run.end as isize - 1);
            run.clone().for_each(|row| moved[row] = column[(row as isize + shift).clamp(first, last) as usize]);
        }
        moved
    };
    let mut columns = laws(inputs, value);
    for driver in &inputs.drivers {
        columns.extend(laws(inputs, &driver.values));
        columns.push(value.iter().zip(&driver.values).map(|(v, d)| v * d).collect());
    }
    columns.extend([-2, -1, 1, 2].map(|shift| shifted(value, shift)));
    columns.extend([-2, -1].map(|shift| shifted(misfit, shift)));
    columns
}

/// `[a, b]` of variance = a + b x^2 through groups of place and scatter, each by its relative error; `None` where either is not above 0.
fn two_parts(groups: &[(f64, f64)]) -> Option<[f64; 2]> {
    let mut sums = [1.0, 0.0];
    for _ in 0..20 {
        let (mut m, mut r) = ([[0.0; 2]; 2], [0.0; 2]);
        for (at, sd) in groups {
            let (x, y) = (at * at, sd * sd);
            // the first round weighs by what is seen, the others by the law
            let expected = if sums[1] == 0.0 { y } else { sums[0] + sums[1] * x };
            if expected <= 0.0 {
                return None;
            }
            let weight = expected.powi(-2);
            m[0][0] += weight;
            m[0][1] += weight * x;
            m[1][1] += weight * x * x;
            r[0] += weight * y;
            r[1] += weight * x * y;
        }
        let all = m[0][0] * m[1][1] - m[0][1] * m[0][1];
        sums = [(r[0] * m[1][1] - r[1] * m[0][1]) / all, (r[1] * m[0][0] - r[0] * m[0][1]) / all];
    }
    sums.iter().all(|v| v.is_finite() && *v > 0.0).then_some(sums)
}

#[cfg(test)]
mod tests {
    use super::*;
    use rand::SeedableRng;
    use rand_chacha::ChaCha8Rng;
    use rand_distr::{Distribution, StandardNormal};

    const ROWS: usize = 2000;

    /// A rough signal that is quick at times, with its clock.
    fn rough(random: &mut ChaCha8Rng) -> (Inputs, Vec<f64>) {
        let mut value = 0.0;
        let signal = (0..ROWS).map(|row| {
            let step: f64 = StandardNormal.sample(random);
            let quick = if row / 150 % 4 == 0 { 1.0 } else { 0.05 };
            value = 0.98 * value + quick * step;
            value
        });
        let signal = signal.collect();
        (Inputs { time_s: Some((0..ROWS).map(|row| row as f64).collect()), run: vec![1; ROWS], ..Inputs::default() }, signal)
    }

    fn noise(random: &mut ChaCha8Rng, sd: f64) -> Vec<f64> {
        (0..ROWS)
            .map(|_| {
                let n: f64 = StandardNormal.sample(random);
                sd * n
            })
            .collect()
    }

    fn found(inputs: &Inputs, value: &[f64], misfit: &[f64]) -> Option<Grows> {
        with_speed(&Beside { inputs, runs: &inputs.runs(), value, misfit, reading: value })
    }

    /// A clock that errs by 0.1 s from row to row makes noise of a tenth of the speed.
    #[test]
    fn an_unsteady_clock_is_noise_that_grows_with_the_speed() {
        let random = &mut ChaCha8Rng::seed_from_u64(1);
        let (inputs, value) = rough(random);
        let speed = rates(inputs.time_s.as_deref(), &value, &inputs.runs());
        let (of_clock, steady) = (noise(random, 0.1), noise(random, 0.005));
        let misfit: Vec<f64> = (0..ROWS).map(|row| of_clock[row] * speed[row] + steady[row]).collect();
        let grows = found(&inputs, &value, &misfit).expect("it grows");
        let fast = (0..ROWS).max_by(|a, b| speed[*a].abs().total_cmp(&speed[*b].abs())).unwrap();
        // scatter by the median of some 330 rows a group is good to 7 %, and the slope takes the error of both ends
        let ratio = grows.least * grows.times[fast] / (0.1 * speed[fast]).hypot(0.005);
        assert!((0.7..1.4).contains(&ratio), "{ratio}");
    }

    /// What is late or bent is off where it changes fast, too, by a law.
    #[test]
    fn a_late_or_bent_reading_is_no_noise() {
        let random = &mut ChaCha8Rng::seed_from_u64(2);
        let (inputs, value) = rough(random);
        let steady = noise(random, 0.005);
        let mut late = 0.0;
        let lag: Vec<f64> = value
            .iter()
            .map(|v| {
                late += 0.7 * (v - late);
                late - v
            })
            .collect();
        let bent: Vec<f64> = value.iter().map(|v| 0.02 * v * v).collect();
        for law in [lag, bent] {
            let misfit: Vec<f64> = law.iter().zip(&steady).map(|(a, b)| a + b).collect();
            assert!(found(&inputs, &value, &misfit).is_none());
        }
    }
}
