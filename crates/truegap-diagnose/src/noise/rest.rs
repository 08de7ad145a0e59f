//! Stretches of a recording in which nothing was done to the sensor, or the same was done again.
//!
//! Limits: rest means that load and temperature stay within their own noise, and whatever else moves the reading within a hundredth of its range.

use crate::{
    noise::reml::Block,
    noise::tuning::{DRIVER_RESTS, EVEN_PACE, FEWEST_OF_A_STRETCH, SHORT_STRETCH, SHORTEST_REST},
    stats::spread,
    whitening::noise_model::InputNoise,
};
use std::ops::Range;
use truegap_core::Inputs;

/// Stretches with constant inputs, in which the answer of a model that remembers, where there is one, is `answered` and stays too.
pub fn at_rest(inputs: &Inputs, load: Option<&[f64]>, answered: Option<&[f64]>, noise: &InputNoise) -> Vec<Block> {
    let mut columns: Vec<(&[f64], f64)> = Vec::new();
    if let Some(load) = load {
        columns.push((load, (5.0 * noise.load).max(1e-3)));
    }
    if let Some(temperature) = &inputs.temperature_c {
        columns.push((temperature, (5.0 * noise.temperature).max(0.05)));
    }
    let range = |column: &[f64]| {
        let range = spread(column);
        (range > 0.0).then_some(DRIVER_RESTS * range)
    };
    for column in inputs.drivers.iter().map(|driver| driver.values.as_slice()) {
        columns.extend(range(column).map(|tolerance| (column, tolerance)));
    }
    if columns.is_empty() {
        return Vec::new();
    }
    // what is simulated moves the reading as well: by itself it tells no rest, for it may be held while what it stands for is not
    let others = [inputs.simulated.as_deref(), inputs.humidity_pct.as_deref(), answered].into_iter().flatten();
    columns.extend(others.filter_map(|column| Some((column, range(column)?))));
    let steps = inputs.steps_s();
    let even = |row: usize, first: usize| {
        inputs.time_s.is_none() || (steps[row] - steps[first + 1]).abs() <= EVEN_PACE * steps[first + 1]
    };
    inputs.runs().into_iter().flat_map(|run| still(&columns, run, &even)).map(Block::at_rest).collect()
}

/// Splits a run into stretches in which each column stays within its tolerance of its mean so far.
fn still(columns: &[(&[f64], f64)], run: Range<usize>, even: &dyn Fn(usize, usize) -> bool) -> Vec<Range<usize>> {
    let mut found = Vec::new();
    let mut first = run.start;
    let mut sums = vec![0.0; columns.len()];
    for row in run.start..=run.end {
        let count = (row - first) as f64;
        let inside = row < run.end && (row < first + 2 || even(row, first));
        let quiet = inside
            && columns.iter().zip(&sums).all(|((c, tolerance), sum)| count == 0.0 || (c[row] - sum / count).abs() <= *tolerance);
        if !quiet {
            if row - first >= SHORTEST_REST {
                found.push(first..row);
            }
            first = row;
            sums.fill(0.0);
        }
        if row < run.end {
            sums.iter_mut().zip(columns).for_each(|(s, (c, _))| *s += c[row]);
        }
    }
    found
}

/// Rows measured again at the same inputs in another run, going the same way.
pub fn replicates(inputs: &Inputs, load: Option<&[f64]>) -> Vec<Block> {
    let Some(load) = load else { return Vec::new() };
    let mut groups: std::collections::BTreeMap<(i64, i8), Vec<usize>> = std::collections::BTreeMap::new();
    for run in inputs.runs() {
        for row in run.clone() {
            let before = if row > run.start { load[row] - load[row - 1] } else { 1.0 };
            let key = ((load[row] * 1e6).round() as i64, before.total_cmp(&0.0) as i8);
            groups.entry(key).or_default().push(row);
        }
    }
    groups.into_values().filter(|rows| rows.len() > 1).map(Block::replicate).collect()
}

/// Short stretches of every run, whatever was done in them.
pub fn short_stretches(inputs: &Inputs) -> Vec<Block> {
    let stretch =
        |run: Range<usize>| run.clone().step_by(SHORT_STRETCH).map(move |first| first..(first + SHORT_STRETCH).min(run.end));
    inputs.runs().into_iter().flat_map(stretch).filter(|r| r.len() >= FEWEST_OF_A_STRETCH).map(Block::stretch).collect()
}

#[cfg(test)]
mod tests {
    use super::*;

    /// A thermometer that stands still beside a simulation that moves: what the reading did there was taken for noise.
    #[test]
    fn nothing_rests_while_what_is_simulated_moves() {
        let of = |simulated: Option<Vec<f64>>| {
            let temperature_c = Some(vec![20.0; 300]);
            let inputs = Inputs { run: vec![1; 300], temperature_c, simulated, ..Inputs::default() };
            at_rest(&inputs, None, None, &InputNoise::default()).len()
        };
        let moves = |row: usize| if row < 150 { 3.0 } else { (row as f64 / 5.0).sin() };
        assert_eq!((of(None), of(Some((0..300).map(moves).collect()))), (1, 1));
        assert_eq!(of(Some((0..300).map(|row| (f64::from(row) / 5.0).sin()).collect())), 0);
    }
    /// A bath that is heated at one power: it comes to rest as its model does, long after the heater.
    #[test]
    fn nothing_rests_while_the_answer_of_a_model_that_remembers_moves() {
        let inputs = Inputs { run: vec![1; 600], force_n: Some(vec![1.0; 600]), ..Inputs::default() };
        let relaxes = |memory: f64| (0..600).map(|row| 1.0 - (-f64::from(row) / memory).exp()).collect::<Vec<_>>();
        let rows = |answered: Option<&[f64]>| {
            let stretches = at_rest(&inputs, inputs.force_n.as_deref(), answered, &InputNoise::default());
            stretches.iter().flat_map(|block| block.rows.clone()).collect::<Vec<_>>()
        };
        assert_eq!(rows(None).len(), 600);
        assert_eq!(rows(Some(&relaxes(300.0))).len(), 0);
        // within a hundredth of its range of the end after 4.6 time constants
        assert!(rows(Some(&relaxes(50.0))).iter().all(|row| *row > 150));
    }
}
