//! Fewer rows with the same information: means over neighbouring rows in which nothing happens.
//!
//! Limits: rows next to a change of load, temperature or pace are kept one by one; the share of information kept is measured, not assumed.

use crate::context::load_column;
use crate::{
    problem::{NoiseModel, Problem, RecordingNoise},
    whiten::InputError,
};
use truegap_core::Inputs;

/// A recording with neighbouring rows merged.
pub struct Thinned {
    /// means of the inputs
    pub inputs: Inputs,
    /// means of the response
    pub response: Vec<f64>,
    /// rows that each row is the mean of
    pub weights: Vec<f64>,
    /// first row of each mean
    pub first: Vec<usize>,
}

impl Thinned {
    /// The noise of the means.
    pub fn noise(&self, noise: &NoiseModel) -> NoiseModel {
        let mean = |column: &[f64], i: usize| {
            let rows = &column[self.first[i]..self.first.get(i + 1).copied().unwrap_or(column.len())];
            rows.iter().sum::<f64>() / rows.len() as f64
        };
        let means = |column: &[f64]| (0..self.first.len()).map(|i| mean(column, i)).collect();
        let moved = |row: usize| self.first.partition_point(|first| *first < row);
        let of = |r: &RecordingNoise| RecordingNoise { rows: moved(r.rows.start)..moved(r.rows.end), ..r.clone() };
        NoiseModel {
            recordings: noise.recordings.iter().map(of).collect(),
            input_error: InputError { variance: means(&noise.input_error.variance), level: means(&noise.input_error.level) },
            weights: Some(self.weights.clone()),
            ..noise.clone()
        }
    }
}

/// Merges rows until about `target` are left; `None` where the recording is no longer than that.
pub fn thin(problem: &Problem<'_>, noise: &NoiseModel, target: usize) -> Option<Thinned> {
    let n = problem.response.len();
    if n <= target || problem.inputs.time_s.is_none() {
        return None;
    }
    let most = n.div_ceil(target);
    let groups = groups(problem, noise, most);
    let mean =
        |column: &[f64]| groups.iter().map(|g| column[g.clone()].iter().sum::<f64>() / g.len() as f64).collect::<Vec<f64>>();
    let option = |column: &Option<Vec<f64>>| column.as_deref().map(mean);
    let from = problem.inputs;
    let inputs = Inputs {
        time_s: option(&from.time_s),
        run: groups.iter().map(|g| from.run[g.start]).collect(),
        force_n: option(&from.force_n),
        pressure_pa: option(&from.pressure_pa),
        gap_m: option(&from.gap_m),
        temperature_c: option(&from.temperature_c),
        humidity_pct: option(&from.humidity_pct),
        simulated: option(&from.simulated),
    };
    Some(Thinned {
        inputs,
        response: mean(problem.response),
        weights: groups.iter().map(|g| g.len() as f64).collect(),
        first: groups.iter().map(|g| g.start).collect(),
    })
}

/// Row ranges to be merged: at most `most` rows, within which no input leaves its noise and the pace is even.
fn groups(problem: &Problem<'_>, noise: &NoiseModel, most: usize) -> Vec<std::ops::Range<usize>> {
    let inputs = problem.inputs;
    let steps = inputs.steps_s();
    let load = load_column(inputs, problem.simulator);
    let mut groups = Vec::new();
    for run in inputs.runs() {
        let here = noise.inputs_at(run.start);
        let mut columns: Vec<(&[f64], f64)> = Vec::new();
        columns.extend(load.as_deref().map(|load| (load, (4.0 * here.load).max(2e-3))));
        columns.extend(inputs.temperature_c.as_deref().map(|t| (t, (5.0 * here.temperature).max(0.3))));
        let mut first = run.start;
        for row in run.start + 1..=run.end {
            let settled = row > run.start + 2 && row < run.end;
            let even = settled && (steps[row] - steps[row - 1]).abs() <= 0.5 * steps[row];
            let still = settled && columns.iter().all(|(c, tolerance)| (c[row] - c[first]).abs() <= *tolerance);
            if !(even && still && row - first < most) {
                groups.push(first..row);
                first = row;
            }
        }
    }
    groups
}

#[cfg(test)]
mod tests {
    use crate::whiten::{InputError, Noise, Whitener};

    /// A constant under white + AR noise: the information in means is that in the rows.
    #[test]
    fn means_carry_the_information_of_their_rows() {
        let noise = Noise { white_sd: 0.7, ar_sd: 1.3, ar_correlation: 0.8 };
        let information = |filter: &Whitener, n: usize| {
            let mut one = vec![1.0; n];
            filter.apply(&mut one);
            one.iter().map(|v| v * v).sum::<f64>()
        };
        let full = Whitener::new(&noise, &InputError::white(vec![0.0; 600]), None, std::slice::from_ref(&(0..600)), None);
        let merged =
            Whitener::new(&noise, &InputError::white(vec![0.0; 60]), Some(&[10.0; 60]), std::slice::from_ref(&(0..60)), None);
        // means of an AR(1) process are ARMA(1, 1), taken as AR(1) here: that costs 9 % for this strong correlation, and never adds
        let kept = information(&merged, 60) / information(&full, 600);
        assert!((0.9..=1.0).contains(&kept), "{kept}");
    }
}
