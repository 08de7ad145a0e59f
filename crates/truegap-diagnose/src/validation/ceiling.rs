//! Does a reading end at one value because the model goes on there? Then amplifier, converter or software has a ceiling that the model lacks.
//!
//! Limits: a hard end of one side. Rows at it took no part in any fit, so they are rows left out. A floor is not told: `saturation` has no law for it.

use crate::{
    effects::saturation::KNEES,
    stats::{rms, spread},
    validation::tuning::{CEILING_CLEARLY, CEILING_HARMS, CEILING_MOSTLY},
};

/// Knees, in spans above the zero, that tell how the reading at a ceiling goes with its knee: both low, so that the farthest row is stopped by either.
const PROBES: [f64; 2] = [0.1, 0.2];

/// The end of a reading, and what the model makes of the rows that lie on it.
#[derive(Clone, Debug, PartialEq)]
pub struct Ceiling {
    /// the reading at which it ends, response unit
    pub at: f64,
    /// rows that lie on it
    pub rows: usize,
    /// of these, rows in which the model without a ceiling goes beyond it
    pub beyond: usize,
    /// how far above the zero it lies, and the standard deviation of that: spans, as `saturation` counts
    pub knee: [f64; 2],
    /// standard deviation of the share of the slope that is lost there, which is 1
    pub lost_sd: f64,
    /// root mean square of the error in these rows, without the ceiling and with it, response unit
    pub rmse: [f64; 2],
    /// root mean square of the error in all other rows, response unit
    pub elsewhere: f64,
}

impl Ceiling {
    /// How often a row lies on the ceiling because the model goes beyond it, by the rule of succession.
    ///
    /// **Source:** Laplace, Essai philosophique sur les probabilités (1814): (k + 1) / (n + 2) after k of n.
    pub fn probability(&self) -> f64 {
        (self.beyond + 1) as f64 / (self.rows + 2) as f64
    }
}

/// The ceiling on which `rows` of `response` lie, ascending and all of one reading. `respond` answers every row, with a hard knee of `saturation` so many spans above the zero or without one.
///
/// # Errors
/// Those of `respond`.
pub fn ceiling<E>(
    response: &[f64],
    rows: &[usize],
    respond: impl Fn(Option<f64>) -> Result<Vec<f64>, E>,
) -> Result<Option<Ceiling>, E> {
    let Some(&first) = rows.first() else { return Ok(None) };
    let others: Vec<usize> = (0..response.len()).filter(|row| rows.binary_search(row).is_err()).collect();
    let left = |predicted: &[f64], rows: &[usize]| rows.iter().map(|row| predicted[*row] - response[*row]).collect::<Vec<f64>>();
    let size = |left: &[f64]| rms(left.iter().copied());
    let without = respond(None)?;
    let (over, elsewhere) = (left(&without, rows), size(&left(&without, &others)));
    // most rows tell on which side the model goes on
    let side = over.iter().sum::<f64>().signum();
    let beyond = over.iter().filter(|over| side * **over > 0.0).count();
    if size(&over) < CEILING_CLEARLY * elsewhere || (beyond as f64) < CEILING_MOSTLY * rows.len() as f64 {
        return Ok(None);
    }
    let farthest = rows.iter().copied().max_by(|a, b| (side * without[*a]).total_cmp(&(side * without[*b]))).unwrap_or(first);
    // what is stopped by a hard knee moves with it along a straight line
    let stopped = [respond(Some(PROBES[0]))?[farthest], respond(Some(PROBES[1]))?[farthest]];
    let (at, span) = (response[first], (stopped[1] - stopped[0]) / (PROBES[1] - PROBES[0]));
    let knee = PROBES[0] + (at - stopped[0]) / span;
    if !(KNEES[0]..=KNEES[1]).contains(&knee) {
        return Ok(None);
    }
    let with = respond(Some(knee))?;
    let rmse = [size(&over), size(&left(&with, rows))];
    let ends_there = rmse[1] * CEILING_CLEARLY <= rmse[0] && size(&left(&with, &others)) <= CEILING_HARMS * elsewhere;
    let of_mean = elsewhere / (rows.len() as f64).sqrt();
    Ok(ends_there.then(|| Ceiling {
        at,
        rows: rows.len(),
        beyond,
        knee: [knee, of_mean / span.abs()],
        lost_sd: of_mean / spread(&over),
        rmse,
        elsewhere,
    }))
}

#[cfg(test)]
mod tests {
    use super::*;
    use std::convert::Infallible;

    /// A reading that goes from 0 to 10 and is asked with a knee, in spans of `span` above 0.
    fn line(span: f64) -> impl Fn(Option<f64>) -> Result<Vec<f64>, Infallible> {
        move |knee| {
            Ok((0..100).map(|row| f64::from(row) / 10.0).map(|value| knee.map_or(value, |k| stop(value, k * span))).collect())
        }
    }

    fn stop(value: f64, at: f64) -> f64 {
        value.min(at)
    }

    /// The same with noise of 0.01, stopped at `at`.
    fn recorded(at: f64) -> (Vec<f64>, Vec<usize>) {
        let noise = |row: i32| if row % 2 == 0 { 0.01 } else { -0.01 };
        let response: Vec<f64> = (0..100).map(|row| stop(f64::from(row) / 10.0 + noise(row), at)).collect();
        let rows = (0..100).filter(|row| response[*row] == at).collect();
        (response, rows)
    }

    #[test]
    fn a_reading_that_ends_below_what_the_model_says_has_a_ceiling() {
        let (response, rows) = recorded(7.0);
        let found = ceiling(&response, &rows, line(10.0)).unwrap().unwrap();
        // 7 of a span of 10
        assert!((found.knee[0] - 0.7).abs() < 1e-12, "{found:?}");
        assert_eq!((found.at, found.rows), (7.0, rows.len()));
        assert!(found.rmse[0] > 1.0 && found.rmse[1] < 0.02, "{found:?}");
        assert!(found.probability() > 0.9 && found.probability() < 1.0);
    }

    #[test]
    fn where_the_model_ends_as_well_nothing_is_missing() {
        let (response, rows) = recorded(7.0);
        let ends_itself = |knee: Option<f64>| line(10.0)(knee).map(|all| all.into_iter().map(|value| stop(value, 7.0)).collect());
        assert_eq!(ceiling(&response, &rows, ends_itself).unwrap(), None);
    }

    #[test]
    fn a_floor_is_no_ceiling() {
        let response: Vec<f64> = (0..100).map(|row| (f64::from(row) / 10.0).max(3.0)).collect();
        let rows: Vec<usize> = (0..=30).collect();
        assert_eq!(ceiling(&response, &rows, line(10.0)).unwrap(), None);
    }

    #[test]
    fn a_model_that_is_as_far_off_elsewhere_tells_no_ceiling() {
        let (response, rows) = recorded(7.0);
        let off = |knee: Option<f64>| line(10.0)(knee).map(|all| all.into_iter().map(|value| value + 1.0).collect());
        assert_eq!(ceiling(&response, &rows, off).unwrap(), None);
    }
}
