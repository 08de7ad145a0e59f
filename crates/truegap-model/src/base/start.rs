//! The head of the chain, the same in every base model: clocks, load path, thermal path.
//!
//! Limits: a shifted column keeps its first and last value beyond the ends of a run, where nothing was recorded.

use std::borrow::Cow;
use truegap_core::{Drive, Inputs, SimulationError, Stage};

/// Columns that drive a model, before anything is computed from them.
pub(crate) struct Start<'a> {
    inputs: Cow<'a, Inputs>,
    load: Vec<f64>,
    temperature_c: Vec<f64>,
    reference_c: f64,
    full_load: f64,
}

impl<'a> Start<'a> {
    /// Walks clocks, load path and thermal path; `load` reads the recorded load in units of `full_load`.
    pub(crate) fn new(
        inputs: &'a Inputs,
        stages: &[&dyn Stage],
        reference_c: f64,
        full_load: f64,
        load: impl Fn(&Inputs) -> Result<Vec<f64>, SimulationError>,
    ) -> Result<Self, SimulationError> {
        let inputs = on_one_clock(inputs, stages);
        let mut load = load(&inputs)?;
        stages.iter().for_each(|stage| stage.load(&inputs, &mut load));
        let mut temperature_c = inputs.temperature_c.clone().unwrap_or_else(|| vec![reference_c; inputs.len()]);
        stages.iter().for_each(|stage| stage.thermal(&inputs, &mut temperature_c));
        Ok(Self { inputs, load, temperature_c, reference_c, full_load })
    }

    /// What the stages see.
    pub(crate) fn drive(&self) -> Drive<'_> {
        Drive {
            inputs: &self.inputs,
            load: &self.load,
            temperature_c: &self.temperature_c,
            reference_c: self.reference_c,
            full_load: self.full_load,
        }
    }

    /// The inputs on the response's clock.
    pub(crate) fn inputs(&self) -> &Inputs {
        &self.inputs
    }
}

/// The inputs on the response's clock.
fn on_one_clock<'a>(inputs: &'a Inputs, stages: &[&dyn Stage]) -> Cow<'a, Inputs> {
    let clock = clock(inputs);
    let first = clock.first().copied().unwrap_or(0.0);
    let late = |time: &f64| stages.iter().map(|stage| stage.late_s(time - first)).sum();
    let late: Vec<f64> = clock.iter().map(late).collect();
    if late.iter().all(|late| *late == 0.0) { Cow::Borrowed(inputs) } else { Cow::Owned(caught_up(inputs, &clock, &late)) }
}

/// The inputs with the columns of the load (force, pressure, gap, simulation) read `late[row]` seconds further on: what stands there happened now.
fn caught_up(inputs: &Inputs, clock: &[f64], late: &[f64]) -> Inputs {
    let mut shifted = inputs.clone();
    let columns = [&mut shifted.force_n, &mut shifted.pressure_pa, &mut shifted.gap_m, &mut shifted.simulated];
    for column in columns.into_iter().flatten() {
        for run in inputs.runs() {
            let moved = interpolated(&clock[run.clone()], &column[run.clone()], &late[run.clone()]);
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

/// A column at `time + late`, linear between rows, held beyond the ends; `time + late` must not run backwards.
fn interpolated(time: &[f64], column: &[f64], late: &[f64]) -> Vec<f64> {
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
            column[before] + share * (column[after] - column[before])
        }
    };
    (0..time.len()).map(at).collect()
}

/// Polynomial stiffening of all stages together.
pub(crate) fn stiffening(stages: &[&dyn Stage]) -> [f64; 2] {
    let add = |sum: [f64; 2], next: [f64; 2]| [sum[0] + next[0], sum[1] + next[1]];
    stages.iter().map(|stage| stage.stiffening()).fold([0.0; 2], add)
}

/// The response, if every row of it is finite.
pub(crate) fn check_finite(response: Vec<f64>, values: &[f64]) -> Result<Vec<f64>, SimulationError> {
    match response.iter().position(|value| !value.is_finite()) {
        None => Ok(response),
        Some(row) => Err(SimulationError::NotFinite { row, value: response[row], parameters: values.to_vec() }),
    }
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

    fn shifted(late: f64) -> Vec<f64> {
        shifted_by(Late(late, 0.0))
    }

    fn shifted_by(stage: Late) -> Vec<f64> {
        let inputs = ramp();
        let start = Start::new(&inputs, &[&stage], 20.0, 2.0, |i| Ok(i.force_n.clone().unwrap())).unwrap();
        start.load
    }

    #[test]
    fn a_late_load_is_read_further_on_and_held_at_the_ends_of_its_run() {
        // slope 2 N/s in both runs, so half a second is 1 N
        assert_eq!(shifted(0.5), [1.0, 3.0, 6.0, 11.0, 13.0, 16.0]);
        assert_eq!(shifted(-0.5), [0.0, 1.0, 5.0, 10.0, 11.0, 15.0]);
        assert_eq!(shifted(100.0), [6.0, 6.0, 6.0, 16.0, 16.0, 16.0]);
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
        let start = Start::new(&inputs, &[&a, &b], 20.0, 2.0, |i| Ok(i.force_n.clone().unwrap())).unwrap();
        assert_eq!(start.load, shifted(0.5));
        assert_eq!(start.drive().temperature_c, [20.0; 6]);
    }
}
