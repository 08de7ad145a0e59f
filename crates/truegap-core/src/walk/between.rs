//! How a column goes on between two rows: straight, or by a cubic, as its own rows say.
//!
//! Limits: beyond the ends of a run, where nothing was recorded, it keeps its first and last value. What noise makes of both ways is told for an even clock.

use crate::column::sd_of_differences;
use std::ops::Range;

/// How a column goes on between two rows.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) enum Between {
    /// straight: what goes in steps, and what is mostly noise
    Straight,
    /// by a cubic with the slopes of the parabolas through each row and its neighbours (Bessel's interpolation: de Boor, A Practical Guide to Splines, ch. IV): what bends. A straight line takes the tops off it
    Cubic,
}

/// How much nearer to a column of noise alone the cubic comes by chance, once in forty: two standard deviations of the difference of both squares less what noise makes of it, in variances of the noise and for the square root
/// of the rows. One is 1.35, of a thousand columns of 300 and of 4000 rows each, with the variance that [`noise_variance`] finds.
const CHANCE: f64 = 2.7;

impl Between {
    /// What foretells the rows of a column better, each from its two neighbours on either side (leaving one out: Stone, J. R. Stat. Soc. B 36 (1974) 111), beyond what the noise of the row and of its neighbours
    /// makes of both: it says nothing of how the column goes on. A straight line where neither does.
    pub(super) fn of(clock: &[f64], column: &[f64], runs: &[Range<usize>]) -> Self {
        let inner = |run: &Range<usize>| run.start + 2..run.end.saturating_sub(2).max(run.start + 2);
        let rows: usize = runs.iter().map(|run| inner(run).len()).sum();
        let [straight, cubic] = runs.iter().flat_map(inner).fold([0.0; 2], |[straight, cubic], row| {
            let rows = [row - 2, row - 1, row + 1, row + 2];
            let left = both_ways(rows.map(|row| clock[row]), rows.map(|row| column[row]), clock[row])
                .map(|read| (read - column[row]).powi(2));
            [straight + left[0], cubic + left[1]]
        });
        // of a row between two others on an even clock the cubic makes squares of the weights -1, 4, 4, -1 over 6 of their noise, a straight line of 1, 1 over 2
        let more = 34.0 / 36.0 - 0.5;
        let (rows, noise) = (rows as f64, noise_variance(column, runs));
        let beyond_noise = cubic - noise * (rows * more - CHANCE * rows.sqrt()).max(0.0);
        if beyond_noise < straight { Self::Cubic } else { Self::Straight }
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

/// A column at `time + late`, held beyond the ends; `slopes` are those of [`slopes`], and `time + late` must not run backwards.
pub(super) fn interpolated(time: &[f64], column: &[f64], slopes: &[f64], late: &[f64], between: Between) -> Vec<f64> {
    let last = time.len() - 1;
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
pub(super) fn slopes(time: &[f64], column: &[f64]) -> Vec<f64> {
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
#[allow(clippy::single_range_in_vec_init)] // one run
mod tests {
    use super::*;

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
        // half as loud as the wave, of 0.35: a straight line makes 0.061 in the square of it, a cubic 0.116
        let louder: Vec<f64> = time.iter().zip(&wave).map(|(t, w)| 2.0 * w + 4.0 * noise(t)).collect();
        assert_eq!(Between::of(&time, &louder, &[0..4000]), Between::Cubic);
        // a course is no noise
        let rising: Vec<f64> = time.iter().zip(&alone).map(|(t, e)| 3.0 * t + e).collect();
        assert!((noise_variance(&rising, &[0..4000]).sqrt() / sd - 1.0).abs() < 1e-9);
        // noise alone does not go on by a cubic, whichever row it begins with
        let nothing =
            (0..40).filter(|first| Between::of(&time[..2000], &alone[50 * first..][..2000], &[0..2000]) == Between::Cubic);
        assert!(nothing.count() <= 2);
        // too few rows to tell
        assert_eq!(Between::of(&time[..4], &wave[..4], &[0..4]), Between::Straight);
    }
}
