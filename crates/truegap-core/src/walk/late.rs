//! The clock of the load against that of the response.
//!
//! Between two rows a column goes on as its own rows say: straight, or by a cubic.
//!
//! Limits: a shifted column keeps its first and last value beyond the ends of a run, where nothing was recorded.

use crate::{chain::Stage, column::sd_of_differences, inputs::Inputs};
use std::{borrow::Cow, ops::Range};

/// The inputs on the response's clock.
pub(super) fn on_one_clock<'a>(inputs: &'a Inputs, stages: &[&dyn Stage]) -> Cow<'a, Inputs> {
    // most stages shift nothing, and are not asked row by row
    let stages: Vec<&&dyn Stage> = stages.iter().filter(|stage| stage.shifts()).collect();
    if stages.is_empty() {
        return Cow::Borrowed(inputs);
    }
    let clock = clock(inputs);
    let first = clock.first().copied().unwrap_or(0.0);
    let late = |time: &f64| stages.iter().map(|stage| stage.late_s(time - first)).sum();
    let late: Vec<f64> = clock.iter().map(late).collect();
    if late.iter().all(|late| *late == 0.0) { Cow::Borrowed(inputs) } else { Cow::Owned(caught_up(inputs, &clock, &late)) }
}

/// The inputs with the columns of the load (force, pressure, gap, simulation) and the drivers read `late[row]` seconds further on: what stands there happened now.
fn caught_up(inputs: &Inputs, clock: &[f64], late: &[f64]) -> Inputs {
    let mut shifted = inputs.clone();
    let columns = [&mut shifted.force_n, &mut shifted.pressure_pa, &mut shifted.gap_m, &mut shifted.simulated];
    let drivers = shifted.drivers.iter_mut().map(|driver| &mut driver.values);
    let runs = inputs.runs();
    for column in columns.into_iter().flatten().chain(drivers) {
        let between = Between::of(clock, column, &runs);
        for run in runs.clone() {
            let moved = interpolated(&clock[run.clone()], &column[run.clone()], &late[run.clone()], between);
            column[run].copy_from_slice(&moved);
        }
    }
    shifted
}

/// Seconds of each row; rows count as seconds where no clock was recorded.
fn clock(inputs: &Inputs) -> Cow<'_, [f64]> {
    match &inputs.time_s {
        Some(time) => Cow::Borrowed(time),
        None => Cow::Owned((0..inputs.len()).map(|row| row as f64).collect()),
    }
}

/// How a column goes on between two rows.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
enum Between {
    /// straight: what goes in steps, and what is mostly noise
    Straight,
    /// by a cubic with the slopes of the parabolas through each row and its neighbours (Bessel's interpolation: de Boor, A Practical Guide to Splines, ch. IV): what bends. A straight line takes the tops off it
    Cubic,
}

impl Between {
    /// What foretells the rows of a column better, each from its two neighbours on either side (leaving one out: Stone, J. R. Stat. Soc. B 36 (1974) 111), beyond what the noise of the row and of its neighbours
    /// makes of both: it says nothing of how the column goes on. A straight line where neither does.
    fn of(clock: &[f64], column: &[f64], runs: &[Range<usize>]) -> Self {
        let inner = |run: &Range<usize>| run.start + 2..run.end.saturating_sub(2).max(run.start + 2);
        let rows: usize = runs.iter().map(|run| inner(run).len()).sum();
        let [straight, cubic] = runs.iter().flat_map(inner).fold([0.0; 2], |[straight, cubic], row| {
            let rows = [row - 2, row - 1, row + 1, row + 2];
            let left = both_ways(rows.map(|row| clock[row]), rows.map(|row| column[row]), clock[row])
                .map(|read| (read - column[row]).powi(2));
            [straight + left[0], cubic + left[1]]
        });
        // the cubic makes more of the noise of its four rows: squares of the weights -1, 9, 9, -1 over 16, and of 1, 1 over 2
        let more = rows as f64 * noise_variance(column, runs) * (164.0 / 256.0 - 0.5);
        if cubic - more < straight { Self::Cubic } else { Self::Straight }
    }

    /// Value between two rows: a `share` of the `width` behind the first, which is `from`; the second is higher by `rise`, and the slopes are those at both.
    fn value(self, share: f64, width: f64, (from, rise): (f64, f64), slopes: [f64; 2]) -> f64 {
        let straight = from + share * rise;
        match self {
            Self::Straight => straight,
            Self::Cubic => {
                // what the slopes at both ends have beyond the straight line
                let [leaving, arriving] = slopes.map(|slope| slope * width - rise);
                straight + share * (1.0 - share) * ((1.0 - share) * leaving - share * arriving)
            }
        }
    }
}

/// Variance of what changes from row to row without a course.
fn noise_variance(column: &[f64], runs: &[Range<usize>]) -> f64 {
    let third = |w: &[f64]| (w[3] - 3.0 * w[2] + 3.0 * w[1] - w[0]).abs();
    let differences: Vec<f64> = runs.iter().flat_map(|run| column[run.clone()].windows(4).map(third)).collect();
    sd_of_differences(&differences, 20.0).powi(2)
}

/// The value at `wanted`, between the second and the third of four rows: straight, and by a cubic.
fn both_ways(time: [f64; 4], column: [f64; 4], wanted: f64) -> [f64; 2] {
    let width = time[2] - time[1];
    if width <= 0.0 {
        return [column[1]; 2];
    }
    let slopes = [1, 2].map(|row| parabola([row - 1, row, row + 1].map(|row: usize| (time[row], column[row]))));
    let at = |between: Between| between.value((wanted - time[1]) / width, width, (column[1], column[2] - column[1]), slopes);
    [at(Between::Straight), at(Between::Cubic)]
}

/// A column at `time + late`, held beyond the ends; `time + late` must not run backwards.
fn interpolated(time: &[f64], column: &[f64], late: &[f64], between: Between) -> Vec<f64> {
    let last = time.len() - 1;
    let slopes = slopes(time, column);
    let mut after = 0;
    let at = |row: usize| {
        let wanted = time[row] + late[row];
        while after < last && time[after] < wanted {
            after += 1;
        }
        let before = after.saturating_sub(1);
        let width = time[after] - time[before];
        if wanted >= time[last] {
            column[last]
        } else if wanted <= time[0] || width <= 0.0 {
            column[after]
        } else {
            let share = (wanted - time[before]) / width;
            let rise = column[after] - column[before];
            between.value(share, width, (column[before], rise), [slopes[before], slopes[after]])
        }
    };
    (0..time.len()).map(at).collect()
}

/// Slope of a column at each row: of the parabola through the row and its neighbours, at an end of the straight line to its neighbour. Rows at one time have no slope between them.
fn slopes(time: &[f64], column: &[f64]) -> Vec<f64> {
    let last = time.len() - 1;
    let point = |row: usize| (time[row], column[row]);
    let at = |row: usize| match row {
        _ if last == 0 => 0.0,
        0 => slope(point(0), point(1)),
        _ if row == last => slope(point(last - 1), point(last)),
        _ => parabola([point(row - 1), point(row), point(row + 1)]),
    };
    (0..time.len()).map(at).collect()
}

/// Slope in the middle one of three rows, of the parabola through them.
fn parabola([before, here, after]: [(f64, f64); 3]) -> f64 {
    let (left, right) = (here.0 - before.0, after.0 - here.0);
    let both = left + right;
    if both > 0.0 { (right * slope(before, here) + left * slope(here, after)) / both } else { 0.0 }
}

fn slope(from: (f64, f64), to: (f64, f64)) -> f64 {
    let width = to.0 - from.0;
    if width > 0.0 { (to.1 - from.1) / width } else { 0.0 }
}

#[cfg(test)]
mod tests {
    use super::*;

    /// Seconds late at the first row, and seconds more in each second.
    struct Late(f64, f64);
    impl Stage for Late {
        fn late_s(&self, elapsed_s: f64) -> f64 {
            self.0 + self.1 * elapsed_s
        }
    }

    fn ramp() -> Inputs {
        let time = vec![0.0, 1.0, 3.0, 4.0, 5.0, 7.0];
        let force = vec![0.0, 2.0, 6.0, 10.0, 12.0, 16.0];
        Inputs { time_s: Some(time), run: vec![1, 1, 1, 2, 2, 2], force_n: Some(force), ..Inputs::default() }
    }

    fn force(inputs: &Inputs) -> Vec<f64> {
        inputs.force_n.clone().unwrap()
    }

    fn shifted(late: f64) -> Vec<f64> {
        shifted_by(Late(late, 0.0))
    }

    fn shifted_by(stage: Late) -> Vec<f64> {
        let inputs = ramp();
        force(&on_one_clock(&inputs, &[&stage]))
    }

    #[test]
    fn a_late_load_is_read_further_on_and_held_at_the_ends_of_its_run() {
        // slope 2 N/s in both runs, so half a second is 1 N
        assert_eq!(shifted(0.5), [1.0, 3.0, 6.0, 11.0, 13.0, 16.0]);
        assert_eq!(shifted(-0.5), [0.0, 1.0, 5.0, 10.0, 11.0, 15.0]);
        assert_eq!(shifted(100.0), [6.0, 6.0, 6.0, 16.0, 16.0, 16.0]);
    }

    /// A cubic with the slopes of parabolas has no error on a parabola, however the rows are spaced, but beside the ends.
    #[test]
    fn a_parabola_is_read_between_rows_without_an_error() {
        let time = vec![0.0, 1.0, 3.0, 4.0, 4.5, 7.0, 8.0];
        let curve = |t: f64| 2.0 - 3.0 * t + 0.5 * t * t;
        let force = Some(time.iter().copied().map(curve).collect());
        let inputs = Inputs { time_s: Some(time.clone()), run: vec![1; 7], force_n: force, ..Inputs::default() };
        let shifted = self::force(&on_one_clock(&inputs, &[&Late(0.4, 0.0)]));
        for row in 1..5 {
            approx::assert_abs_diff_eq!(shifted[row], curve(time[row] + 0.4), epsilon = 1e-12);
        }
    }

    /// Steps from row to row are straight between rows: a cubic would run beyond them on both sides.
    #[test]
    fn steps_are_read_straight() {
        let time: Vec<f64> = (0..41).map(f64::from).collect();
        let force: Vec<f64> = time.iter().map(|t| (t / 10.0).floor()).collect();
        let inputs = Inputs { time_s: Some(time), run: vec![1; 41], force_n: Some(force.clone()), ..Inputs::default() };
        let shifted = self::force(&on_one_clock(&inputs, &[&Late(0.3, 0.0)]));
        for row in 0..40 {
            approx::assert_abs_diff_eq!(shifted[row], 0.7 * force[row] + 0.3 * force[row + 1], epsilon = 1e-12);
        }
    }

    /// A wave is read by a cubic, also under noise that a straight line makes less of; steps are read straight under the same noise.
    #[test]
    fn the_noise_of_rows_has_no_say() {
        let time: Vec<f64> = (0..4000).map(f64::from).collect();
        let noise = |t: &f64| 0.05 * ((t * t * 0.734).sin() + (t * t * 0.331).sin() + (t * t * 0.117).sin());
        let wave: Vec<f64> = time.iter().map(|t| (0.4 * t).sin()).collect();
        let noisy: Vec<f64> = time.iter().zip(&wave).map(|(t, w)| w + noise(t)).collect();
        let steps: Vec<f64> = time.iter().map(|t| (t / 20.0).floor() % 3.0 + noise(t)).collect();
        assert_eq!(Between::of(&time, &wave, &[0..1500, 1500..4000]), Between::Cubic);
        assert_eq!(Between::of(&time, &noisy, &[0..4000]), Between::Cubic);
        assert_eq!(Between::of(&time, &steps, &[0..4000]), Between::Straight);
        // sines of squares have 1/2 of their square each
        let alone: Vec<f64> = time.iter().map(noise).collect();
        let sd = noise_variance(&alone, &[0..4000]).sqrt();
        assert!((0.8..1.25).contains(&(sd / (0.05 * 1.5f64.sqrt()))), "{sd}");
        // so loud that a straight line foretells the rows of a wave better: of noise of 0.092 it makes 0.0042 in the square where a cubic makes 0.0080, more than the 0.0031 by which it is off the wave
        let loud: Vec<f64> = time.iter().zip(&wave).map(|(t, w)| w + 1.5 * noise(t)).collect();
        assert_eq!(Between::of(&time, &loud, &[0..4000]), Between::Cubic);
        // a course is no noise
        let rising: Vec<f64> = time.iter().zip(&alone).map(|(t, e)| 3.0 * t + e).collect();
        assert!((noise_variance(&rising, &[0..4000]).sqrt() / sd - 1.0).abs() < 1e-9);
        // too few rows to tell
        assert_eq!(Between::of(&time[..4], &wave[..4], &[0..4]), Between::Straight);
    }

    /// Rows at one time, as loggers of whole seconds write them, have finite values between them.
    #[test]
    fn repeated_times_are_read_without_a_slope() {
        let inputs = Inputs {
            time_s: Some(vec![0.0, 1.0, 1.0, 1.0, 2.0]),
            run: vec![1; 5],
            force_n: Some(vec![0.0, 1.0, 5.0, 2.0, 3.0]),
            ..Inputs::default()
        };
        assert!(force(&on_one_clock(&inputs, &[&Late(0.5, 0.0)])).iter().all(|value| value.is_finite()));
    }

    #[test]
    fn a_slow_clock_is_later_and_later_through_all_runs() {
        // a quarter of a second a second from half a second early; slope 2 N/s
        assert_eq!(shifted_by(Late(-0.5, 0.25)), [0.0, 1.5, 6.0, 11.0, 13.5, 16.0]);
    }

    #[test]
    fn two_stages_shift_by_the_sum() {
        let inputs = ramp();
        let (a, b) = (Late(0.75, 0.0), Late(-0.25, 0.0));
        assert_eq!(force(&on_one_clock(&inputs, &[&a, &b])), shifted(0.5));
    }
}
