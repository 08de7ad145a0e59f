//! What the priors of a base model are scaled with: range, level and slope of a recording.
//!
//! Limits: a straight line of response on load; what is not finite is left out of ranges.

use serde::{Deserialize, Serialize};
use truegap_core::Inputs;

/// A recording, as far as a base model is scaled by it.
#[derive(Clone, Copy, Debug)]
pub struct Recorded<'a> {
    /// what was done to the sensor
    pub inputs: &'a Inputs,
    /// what was read
    pub response: &'a [f64],
    /// unit of the response
    pub unit: &'a str,
}

/// What priors are scaled with.
#[derive(Clone, Debug, Default, PartialEq, Serialize, Deserialize)]
pub struct ResponseScale {
    /// unit of the response
    pub unit: String,
    /// middle of the recorded range
    pub centre: f64,
    /// width of the recorded range; 1 where the response does not move at all
    pub range: f64,
    /// response at rest, by the straight line of response on load
    pub at_rest: f64,
    /// response at full load less that at rest, by the same line; its sign says whether the reading rises with load
    pub span: f64,
    /// narrowest and widest recorded gap, m
    pub gaps_m: (f64, f64),
    /// median of response times gap
    pub response_times_gap: f64,
}

impl ResponseScale {
    /// Scale of a recording; `load` is a column and its full value.
    pub fn of(recorded: Recorded<'_>, load: Option<(&[f64], f64)>) -> Self {
        let (low, high) = (least(recorded.response), greatest(recorded.response));
        let range = if high > low { high - low } else { 1.0 };
        let (at_rest, span) = load.map_or((low, range), |(column, full)| line(column, full, recorded.response));
        let gaps = recorded.inputs.gap_m.as_deref().unwrap_or(&[]);
        Self {
            unit: recorded.unit.to_owned(),
            centre: 0.5 * (low + high),
            range,
            at_rest,
            span,
            gaps_m: if gaps.is_empty() { (0.0, 0.0) } else { (least(gaps), greatest(gaps)) },
            response_times_gap: median(gaps.iter().zip(recorded.response).map(|(gap, response)| gap * response)),
        }
    }
}

/// Least-squares line of response on load: value at rest and change to full load.
fn line(load: &[f64], full: f64, response: &[f64]) -> (f64, f64) {
    let rows = response.len().max(1) as f64;
    let mean_load = load.iter().sum::<f64>() / rows / full;
    let mean = response.iter().sum::<f64>() / rows;
    let (mut both, mut square) = (0.0, 0.0);
    for (load, response) in load.iter().zip(response) {
        let off = load / full - mean_load;
        both += off * (response - mean);
        square += off * off;
    }
    let span = if square > 0.0 { both / square } else { 0.0 };
    (mean - span * mean_load, span)
}

/// Median of the positive values; 1 where there is none.
fn median(values: impl Iterator<Item = f64>) -> f64 {
    let mut sorted: Vec<f64> = values.filter(|v| v.is_finite() && *v > 0.0).collect();
    sorted.sort_by(f64::total_cmp);
    sorted.get(sorted.len() / 2).copied().unwrap_or(1.0)
}

pub(super) fn greatest(column: &[f64]) -> f64 {
    column.iter().copied().filter(|v| v.is_finite()).fold(f64::NEG_INFINITY, f64::max)
}

fn least(column: &[f64]) -> f64 {
    column.iter().copied().filter(|v| v.is_finite()).fold(f64::INFINITY, f64::min)
}
