//! A smooth function of one number as plain data: samples, and a monotone cubic between them.
//!
//! Limits: one argument; where samples rise or fall, so does the curve between them, so it makes no bumps of its own.

use serde::{Deserialize, Serialize};

/// A sampled function with what it means and how good it is.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
pub struct Curve {
    /// name
    pub id: String,
    /// what it gives, a sentence with the formula it enters
    pub says: String,
    /// argument
    pub argument: String,
    /// its unit; `1` for a ratio
    pub argument_unit: String,
    /// value
    pub value: String,
    /// its unit
    pub value_unit: String,
    /// `[argument, value]`, at least two, arguments rising
    pub points: Vec<[f64; 2]>,
    /// largest measured error of the value: relative, against what the samples were condensed from
    pub accuracy: f64,
}

/// Why samples make no curve.
#[derive(Clone, Debug, PartialEq, thiserror::Error)]
#[non_exhaustive]
pub enum CurveError {
    /// Fewer than two.
    #[error("curve `{id}` has {count} samples; give at least two")]
    TooFew {
        /// curve
        id: String,
        /// samples
        count: usize,
    },
    /// Not a rising list of numbers.
    #[error("curve `{id}`: sample {row} is ({argument}, {value}); give finite numbers, arguments rising")]
    OutOfOrder {
        /// curve
        id: String,
        /// sample, from 0
        row: usize,
        /// its argument
        argument: f64,
        /// its value
        value: f64,
    },
}

impl Curve {
    /// Whether the samples make a curve; to be asked of one that was read from a file.
    ///
    /// # Errors
    /// [`CurveError`] with the first sample that does not fit.
    pub fn check(&self) -> Result<(), CurveError> {
        let id = self.id.clone();
        if self.points.len() < 2 {
            return Err(CurveError::TooFew { id, count: self.points.len() });
        }
        let bad = |row: &usize| {
            let [x, y] = self.points[*row];
            !(x.is_finite() && y.is_finite() && (*row == 0 || x > self.points[row - 1][0]))
        };
        match (0..self.points.len()).find(bad) {
            None => Ok(()),
            Some(row) => Err(CurveError::OutOfOrder { id, row, argument: self.points[row][0], value: self.points[row][1] }),
        }
    }

    /// Arguments of the first and the last sample.
    pub fn range(&self) -> [f64; 2] {
        [self.points[0][0], self.points[self.points.len() - 1][0]]
    }

    /// Whether `x` lies between the samples; elsewhere [`Curve::at`] goes on along the tangent and its answer is a guess.
    pub fn covers(&self, x: f64) -> bool {
        let [low, high] = self.range();
        (low..=high).contains(&x)
    }

    /// The value at `x`: Hermite's cubic with the slope of the parabola through each sample and its neighbours, limited to three times the lesser of
    /// the two secants; beyond the ends, the tangent.
    ///
    /// **Source:** Fritsch & Carlson, SIAM J. Numer. Anal. 17 (1980) 238 (the limit). **Accuracy:** third order in the distance of samples,
    /// `halving_the_distance_of_samples_takes_an_eighth_of_the_error`.
    pub fn at(&self, x: f64) -> f64 {
        between(&self.points, x, |sample| self.slope(sample))
    }

    /// The same for many arguments: the slopes at the samples computed once.
    pub fn smooth(&self) -> Smooth<'_> {
        Smooth { points: &self.points, slopes: (0..self.points.len()).map(|sample| self.slope(sample)).collect() }
    }

    /// Slope between a sample and the next.
    fn secant(&self, left: usize) -> f64 {
        let ([a, fa], [b, fb]) = (self.points[left], self.points[left + 1]);
        (fb - fa) / (b - a)
    }

    /// Slope at a sample.
    fn slope(&self, at: usize) -> f64 {
        let last = self.points.len() - 1;
        if last == 1 {
            return self.secant(0);
        }
        let width = |left: usize| self.points[left + 1][0] - self.points[left][0];
        // the parabola's slope is the secants' mean, weighted by the other one's width
        let middle = |at: usize| {
            let (h, k) = (width(at - 1), width(at));
            (k * self.secant(at - 1) + h * self.secant(at)) / (h + k)
        };
        let (parabola, secants) = match at {
            0 => (2.0 * self.secant(0) - middle(1), [self.secant(0); 2]),
            _ if at == last => (2.0 * self.secant(last - 1) - middle(last - 1), [self.secant(last - 1); 2]),
            _ => (middle(at), [self.secant(at - 1), self.secant(at)]),
        };
        let [left, right] = secants;
        if left * right <= 0.0 || parabola * left <= 0.0 {
            return 0.0;
        }
        parabola.signum() * parabola.abs().min(3.0 * left.abs().min(right.abs()))
    }
}

/// A curve with the slopes at its samples.
#[derive(Clone, Debug)]
pub struct Smooth<'a> {
    points: &'a [[f64; 2]],
    slopes: Vec<f64>,
}

impl Smooth<'_> {
    /// As [`Curve::at`], to the last bit.
    pub fn at(&self, x: f64) -> f64 {
        between(self.points, x, |sample| self.slopes[sample])
    }
}

/// The value at `x` between samples with these slopes.
#[inline]
fn between(points: &[[f64; 2]], x: f64, slope: impl Fn(usize) -> f64) -> f64 {
    let last = points.len() - 1;
    if x <= points[0][0] {
        return points[0][1] + slope(0) * (x - points[0][0]);
    }
    if x >= points[last][0] {
        return points[last][1] + slope(last) * (x - points[last][0]);
    }
    let right = points.partition_point(|p| p[0] <= x).clamp(1, last);
    let ([a, fa], [b, fb]) = (points[right - 1], points[right]);
    let (h, t) = (b - a, (x - a) / (b - a));
    let (u, s) = (1.0 - t, t * t * (3.0 - 2.0 * t));
    fa + s * (fb - fa) + h * t * u * (u * slope(right - 1) - t * slope(right))
}

#[cfg(test)]
mod tests {
    use super::*;

    fn sampled(f: impl Fn(f64) -> f64, low: f64, high: f64, count: usize) -> Curve {
        let x = |i: usize| low + (high - low) * i as f64 / (count - 1) as f64;
        let points = (0..count).map(|i| [x(i), f(x(i))]).collect();
        let text = String::new;
        let (argument, argument_unit, value, value_unit) = (text(), text(), text(), text());
        Curve { id: "c".into(), says: text(), argument, argument_unit, value, value_unit, points, accuracy: 0.0 }
    }

    fn worst(curve: &Curve, f: impl Fn(f64) -> f64, low: f64, high: f64) -> f64 {
        (0..=1000).map(|i| low + (high - low) * f64::from(i) / 1000.0).map(|x| (curve.at(x) - f(x)).abs()).fold(0.0, f64::max)
    }

    #[test]
    fn halving_the_distance_of_samples_takes_an_eighth_of_the_error() {
        let f = |x: f64| 2.0 + x + (1.3 * x).exp();
        let error = |count| worst(&sampled(f, 0.0, 1.0, count), f, 0.0, 1.0);
        let (coarse, fine) = (error(17), error(33));
        // third order; the cubic's own error is of the fourth
        assert!((6.0..20.0).contains(&(coarse / fine)), "{coarse} {fine}");
        // ends: slope off by h^2 f'''/3, of which 4/27 h is left in the curve
        assert!(fine < 2e-5, "{fine}");
    }

    #[test]
    fn a_step_makes_no_bumps_and_the_ends_go_on_along_their_tangents() {
        let step = sampled(|x| if x < 0.5 { 0.0 } else { 1.0 }, 0.0, 1.0, 11);
        assert!((0..=500).map(|i| step.at(f64::from(i) / 500.0)).all(|y| (0.0..=1.0).contains(&y)));
        let line = sampled(|x| 3.0 - 2.0 * x, 0.0, 1.0, 5);
        for x in [-0.5, 0.0, 0.31, 1.0, 1.7] {
            assert!((line.at(x) - (3.0 - 2.0 * x)).abs() < 1e-14);
        }
        assert!(line.covers(1.0) && !line.covers(1.01) && !line.covers(-1e-9));
        let square = sampled(|x| x * x, 0.0, 1.0, 21);
        assert!((square.at(1.05) - 1.1).abs() < 1e-12, "{}", square.at(1.05));
    }

    #[test]
    fn slopes_computed_once_change_no_bit() {
        for count in [2, 3, 17] {
            let curve = sampled(|x| (3.0 * x).sin() + x, 0.0, 1.0, count);
            let smooth = curve.smooth();
            for x in (-100..=1100).map(|i| f64::from(i) / 1000.0) {
                assert_eq!(smooth.at(x).to_bits(), curve.at(x).to_bits(), "{count} samples at {x}");
            }
        }
    }

    #[test]
    fn what_makes_no_curve_is_refused() {
        assert!(sampled(|x| x, 0.0, 1.0, 3).check().is_ok());
        let mut curve = sampled(|x| x, 0.0, 1.0, 3);
        curve.points[2][0] = 0.5;
        assert!(matches!(curve.check(), Err(CurveError::OutOfOrder { row: 2, .. })));
        curve.points.truncate(1);
        assert!(matches!(curve.check(), Err(CurveError::TooFew { count: 1, .. })));
    }
}
