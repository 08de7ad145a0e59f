//! Fewer rows with the same information: means over neighbouring rows in which little happens.
//!
//! Limits: rows next to a change of load, temperature or pace are kept one by one, as long as that leaves few enough; in longer recordings, rows on a slow course
//! are merged as well, never across a turn.

use crate::{
    data::{context::load_column, problem::Problem},
    noise::tuning::{DRIVER_STILL, GROUP_MOVES, TOO_MANY_GROUPS},
    stats::spread,
    whitening::{
        noise_model::{NoiseModel, RecordingNoise},
        whitener::InputError,
    },
};
use std::ops::Range;
use truegap_core::{Inputs, SimulationError};

/// A recording with neighbouring rows merged.
pub struct BlockAverages {
    /// means of the inputs
    pub inputs: Inputs,
    /// means of the response
    pub response: Vec<f64>,
    /// rows that each row is the mean of
    pub weights: Vec<f64>,
    /// first row of each mean
    pub first: Vec<usize>,
    /// means of the response as it was read
    read: Vec<f64>,
    /// whether inputs move within a mean
    pub moved: bool,
}

impl BlockAverages {
    /// The means of the response, less the difference between the mean of what a model responds and its response to the mean inputs; `responds` is the model, of these inputs.
    ///
    /// # Errors
    /// Those of the model.
    pub fn response_by(
        &self,
        every_row: &Inputs,
        responds: impl Fn(&Inputs) -> Result<Vec<f64>, SimulationError>,
    ) -> Result<Vec<f64>, SimulationError> {
        if !self.moved {
            return Ok(self.read.clone());
        }
        let of_means = responds(&self.inputs)?;
        let of_rows = self.means(&responds(every_row)?);
        Ok(self.read.iter().zip(of_means.iter().zip(&of_rows)).map(|(read, (m, rows))| read + m - rows).collect())
    }

    /// Means of a column of every row.
    fn means(&self, column: &[f64]) -> Vec<f64> {
        let end = |i: usize| self.first.get(i + 1).copied().unwrap_or(column.len());
        let mean = |rows: &[f64]| rows.iter().sum::<f64>() / rows.len() as f64;
        (0..self.first.len()).map(|i| mean(&column[self.first[i]..end(i)])).collect()
    }

    /// The noise of the means.
    pub fn noise(&self, noise: &NoiseModel) -> NoiseModel {
        let means = |column: &[f64]| self.means(column);
        let moved = |row: usize| self.first.partition_point(|first| *first < row);
        let of = |r: &RecordingNoise| RecordingNoise { rows: moved(r.rows.start)..moved(r.rows.end), ..r.clone() };
        NoiseModel {
            recordings: noise.recordings.iter().map(of).collect(),
            input_error: InputError {
                variance: means(&noise.input_error.variance),
                level: means(&noise.input_error.level),
                shapes: noise.input_error.shapes.iter().map(|shape| means(shape)).collect(),
                wanders: noise.input_error.wanders,
                lasting: noise.input_error.lasting.iter().map(|lasting| lasting.of_means(&self.first)).collect(),
                louder: if noise.input_error.louder.is_empty() { Vec::new() } else { means(&noise.input_error.louder) },
            },
            weights: Some(self.weights.clone()),
            ..noise.clone()
        }
    }
}

/// Merges rows until about `target` are left; `None` where the recording is no longer than that.
///
/// Where load or temperature move, a mean of the response is not the response to the mean input; the difference is taken out as the base model at the centre of
/// its prior has it.
///
/// # Errors
/// Those of the simulator.
pub fn block_averages(
    problem: &Problem<'_>,
    noise: &NoiseModel,
    target: usize,
) -> Result<Option<BlockAverages>, SimulationError> {
    let n = problem.response.len();
    if n <= target || problem.inputs.time_s.is_none() {
        return Ok(None);
    }
    let (groups, moved) = bounded(problem, noise, target);
    let mean =
        |column: &[f64]| groups.iter().map(|g| column[g.clone()].iter().sum::<f64>() / g.len() as f64).collect::<Vec<f64>>();
    let from = problem.inputs;
    let inputs = from.columns_as(groups.iter().map(|g| from.run[g.start]).collect(), mean);
    let read = mean(problem.response);
    let mut averages = BlockAverages {
        inputs,
        response: Vec::new(),
        weights: groups.iter().map(|g| g.len() as f64).collect(),
        first: groups.iter().map(|g| g.start).collect(),
        read,
        moved,
    };
    averages.response =
        averages.response_by(from, |inputs| problem.simulator.respond(&problem.simulator.centre(), inputs, &[]))?;
    Ok(Some(averages))
}

/// The finest grouping that is short enough, and whether inputs move within its groups.
fn bounded(problem: &Problem<'_>, noise: &NoiseModel, target: usize) -> (Vec<Range<usize>>, bool) {
    let most = problem.response.len().div_ceil(target);
    let mut tried = GROUP_MOVES.iter().map(|moves| (groups(problem, noise, most, *moves), *moves > 0.0));
    let mut found = tried.next().unwrap_or_default();
    for next in tried {
        if found.0.len() <= TOO_MANY_GROUPS * target {
            break;
        }
        found = next;
    }
    found
}

/// An input within a group: how far it may move, and how far back without that being a turn.
struct Course<'a> {
    column: &'a [f64],
    moves: f64,
    turns: f64,
    low: f64,
    high: f64,
}

impl Course<'_> {
    fn start(&mut self, row: usize) {
        (self.low, self.high) = (self.column[row], self.column[row]);
    }

    /// Whether the group may go on over `row`: it has not gone too far, and not turned.
    fn goes_on(&mut self, first: usize, row: usize) -> bool {
        let value = self.column[row];
        (self.low, self.high) = (self.low.min(value), self.high.max(value));
        let start = self.column[first];
        let turned = (self.high - value > self.turns && self.high - start > self.turns)
            || (value - self.low > self.turns && start - self.low > self.turns);
        (value - start).abs() <= self.moves && !turned
    }
}

/// Row ranges to be merged: at most `most` rows, within which no input moves by more than its noise or `moves` times its range, none turns, and the pace is even.
fn groups(problem: &Problem<'_>, noise: &NoiseModel, most: usize, moves: f64) -> Vec<Range<usize>> {
    let inputs = problem.inputs;
    let steps = inputs.steps_s();
    let load = load_column(inputs, problem.simulator);
    let [load, warm] = [load.as_deref(), inputs.temperature_c.as_deref()].map(|column| column.map(|c| (c, spread(c))));
    let mut groups = Vec::new();
    for run in inputs.runs() {
        let here = noise.inputs_at(run.start);
        let course = |(column, range): (_, f64), still: f64| Course {
            column,
            moves: still.max(moves * range),
            turns: still,
            low: 0.0,
            high: 0.0,
        };
        let mut courses: Vec<Course<'_>> = Vec::new();
        courses.extend(load.map(|load| course(load, (4.0 * here.load).max(2e-3))));
        for driver in &inputs.drivers {
            courses.push(course((&driver.values, spread(&driver.values)), DRIVER_STILL * spread(&driver.values)));
        }
        courses.extend(warm.map(|warm| course(warm, (5.0 * here.temperature).max(0.3))));
        courses.iter_mut().for_each(|c| c.start(run.start));
        let mut first = run.start;
        for row in run.start + 1..=run.end {
            let inside = row > run.start + 2 && row < run.end;
            let even = inside && (steps[row] - steps[row - 1]).abs() <= 0.5 * steps[row];
            let still = inside && courses.iter_mut().all(|c| c.goes_on(first, row));
            if !(even && still && row - first < most) {
                groups.push(first..row);
                first = row;
                if row < run.end {
                    courses.iter_mut().for_each(|c| c.start(row));
                }
            }
        }
    }
    groups
}

#[cfg(test)]
mod tests {
    use crate::whitening::whitener::InputError;
    use crate::whitening::whitener::Noise;
    use crate::whitening::whitener::Whitener;

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
