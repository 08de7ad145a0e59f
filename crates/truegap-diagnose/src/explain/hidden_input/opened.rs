//! A hidden column opened: how well the course that was recovered without it follows it.
//!
//! Limits: a straight line between the two; its interval by leaving out stretches, since neighbouring rows are no independent witnesses.

use crate::explain::tuning::JACKKNIFE_STRETCHES;
use statrs::distribution::{ContinuousCDF, StudentsT};
use std::ops::Range;

/// A straight line of the course on the hidden column.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Line {
    /// correlation
    pub correlation: f64,
    /// change of the course per unit of the column
    pub slope: f64,
    /// 95 % interval of the slope
    pub interval: (f64, f64),
}

/// The line of `course` on `hidden` over the rows of these runs; `None` where the column does not move or there are too few rows.
pub fn line(hidden: &[f64], course: &[f64], runs: &[Range<usize>]) -> Option<Line> {
    let blocks = blocks(hidden, runs);
    let all = blocks.iter().fold(Sums::default(), |sums, block| sums.plus(&Sums::of(hidden, course, block)));
    let slope = all.slope()?;
    let without: Vec<f64> = blocks.iter().filter_map(|block| all.minus(&Sums::of(hidden, course, block)).slope()).collect();
    let n = without.len() as f64;
    if n < 3.0 {
        return None;
    }
    let mean = without.iter().sum::<f64>() / n;
    let sd = ((n - 1.0) / n * without.iter().map(|s| (s - mean).powi(2)).sum::<f64>()).sqrt();
    let reach = StudentsT::new(0.0, 1.0, n - 1.0).ok()?.inverse_cdf(0.975) * sd;
    Some(Line { correlation: all.correlation(), slope, interval: (slope - reach, slope + reach) })
}

/// Correlation over some rows; `None` where one of the two does not move.
pub fn correlation(hidden: &[f64], course: &[f64], rows: &Range<usize>) -> Option<f64> {
    let sums = Sums::of(hidden, course, rows);
    sums.slope().map(|_| sums.correlation()).filter(|c| c.is_finite())
}

/// Contiguous stretches inside runs, about [`JACKKNIFE_STRETCHES`] of equal length.
fn blocks(hidden: &[f64], runs: &[Range<usize>]) -> Vec<Range<usize>> {
    let rows: usize = runs.iter().map(ExactSizeIterator::len).sum();
    let length = rows.div_ceil(JACKKNIFE_STRETCHES).max(4);
    let part = |run: &Range<usize>| {
        let run = run.clone();
        let count = run.len().div_ceil(length).max(1);
        (0..count).map(move |k| run.start + k * run.len() / count..run.start + (k + 1) * run.len() / count)
    };
    runs.iter().flat_map(part).filter(|b| hidden[b.clone()].iter().any(|h| h.is_finite())).collect()
}

/// Sums of two columns over rows in which both are numbers.
#[derive(Clone, Copy, Debug, Default)]
struct Sums {
    n: f64,
    x: f64,
    y: f64,
    xx: f64,
    xy: f64,
    yy: f64,
}

impl Sums {
    fn of(hidden: &[f64], course: &[f64], rows: &Range<usize>) -> Self {
        let pairs = rows.clone().map(|row| (hidden[row], course[row])).filter(|(x, y)| x.is_finite() && y.is_finite());
        pairs.fold(Self::default(), |s, (x, y)| Self {
            n: s.n + 1.0,
            x: s.x + x,
            y: s.y + y,
            xx: s.xx + x * x,
            xy: s.xy + x * y,
            yy: s.yy + y * y,
        })
    }

    fn plus(&self, o: &Self) -> Self {
        self.with(o, 1.0)
    }

    fn minus(&self, o: &Self) -> Self {
        self.with(o, -1.0)
    }

    fn with(&self, o: &Self, sign: f64) -> Self {
        Self {
            n: self.n + sign * o.n,
            x: self.x + sign * o.x,
            y: self.y + sign * o.y,
            xx: self.xx + sign * o.xx,
            xy: self.xy + sign * o.xy,
            yy: self.yy + sign * o.yy,
        }
    }

    /// Squared deviations of the column, of the course, and their product.
    fn deviations(&self) -> (f64, f64, f64) {
        (self.xx - self.x * self.x / self.n, self.yy - self.y * self.y / self.n, self.xy - self.x * self.y / self.n)
    }

    fn slope(&self) -> Option<f64> {
        let (xx, _, xy) = self.deviations();
        (self.n > 3.0 && xx > 1e-9 * self.xx.abs().max(f64::MIN_POSITIVE)).then(|| xy / xx)
    }

    fn correlation(&self) -> f64 {
        let (xx, yy, xy) = self.deviations();
        xy / (xx * yy).sqrt()
    }
}

#[cfg(test)]
#[allow(clippy::single_range_in_vec_init)]
mod tests {
    use super::*;

    #[test]
    fn a_course_that_follows_has_its_slope_inside_the_interval() {
        let hidden: Vec<f64> = (0..400).map(|i| 20.0 + 10.0 * (f64::from(i) / 60.0).sin()).collect();
        // a slow error beside the line: rows are no independent witnesses
        let course: Vec<f64> = hidden.iter().enumerate().map(|(i, h)| 0.02 * h + 0.01 * (i as f64 / 17.0).cos()).collect();
        let found = line(&hidden, &course, &[0..200, 200..400]).unwrap();
        assert!(found.correlation > 0.99 && found.interval.0 < 0.02 && 0.02 < found.interval.1, "{found:?}");
        assert!(found.interval.1 - found.interval.0 < 0.004, "{found:?}");
    }

    #[test]
    fn a_course_that_does_not_follow_has_zero_inside_the_interval() {
        let hidden: Vec<f64> = (0..400).map(|i| (f64::from(i) / 23.0).sin()).collect();
        let course: Vec<f64> = (0..400).map(|i| (f64::from(i) / 9.0).cos()).collect();
        let found = line(&hidden, &course, &[0..400]).unwrap();
        assert!(found.correlation.abs() < 0.3 && found.interval.0 < 0.0 && found.interval.1 > 0.0, "{found:?}");
    }

    #[test]
    fn a_column_that_stands_still_has_no_line() {
        assert!(line(&[20.0; 100], &[1.0; 100], &[0..100]).is_none());
    }
}
