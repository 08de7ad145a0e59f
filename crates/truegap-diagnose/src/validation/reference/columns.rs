//! The recorded inputs that move, each as numbers of the order of 1, and the constants beside them.
//!
//! Limits: a column with a gap in it is left out; the clock counts only where the base model is driven by it.

use crate::{data::problem::Problem, stats::spread};
use truegap_core::{Inputs, Role};

/// What may be recorded beside the response, in the order in which a reader is told.
const ROLES: [Role; 7] = [Role::Force, Role::Pressure, Role::Gap, Role::Simulated, Role::Temperature, Role::Humidity, Role::Time];
/// Share of its size below which a column counts as still.
const STILL: f64 = 1e-9;

/// One input.
pub(super) struct Column {
    /// what a reader would call it
    pub name: String,
    /// one value a row, about its mean in units of its range
    pub values: Vec<f64>,
}

/// The inputs that move.
pub(super) fn moving(problem: &Problem<'_>) -> Vec<Column> {
    let inputs = problem.inputs;
    let driven_by_clock = problem.simulator.needs().contains(&Role::Time);
    let roles = ROLES.into_iter().filter(|role| *role != Role::Time || driven_by_clock);
    let recorded = roles.filter_map(|role| Some((role.key(), inputs.column(role)?)));
    let drivers = inputs.drivers.iter().map(|driver| (driver.name.as_str(), driver.values.as_slice()));
    recorded.chain(drivers).filter_map(|(name, values)| column(name, values)).collect()
}

fn column(name: &str, values: &[f64]) -> Option<Column> {
    let (range, rows) = (spread(values), values.len() as f64);
    let greatest = values.iter().fold(0.0f64, |m, v| m.max(v.abs()));
    let mean = values.iter().sum::<f64>() / rows;
    let moves = mean.is_finite() && range.is_finite() && range > STILL * greatest;
    let name = if name == "simulated" { "simulated value" } else { name };
    moves.then(|| Column { name: name.to_owned(), values: values.iter().map(|v| (v - mean) / range).collect() })
}

/// The constant of each row, as the number of its column and how many there are: one for all, or one a recording where each has a level of its own.
pub(super) fn intercepts(problem: &Problem<'_>) -> (Vec<usize>, usize) {
    let inputs: &Inputs = problem.inputs;
    let mut of_row = vec![0; inputs.len()];
    let Some(joined) = problem.simulator.joined() else { return (of_row, 1) };
    if !(0..joined.count()).any(|index| joined.has_own(index)) {
        return (of_row, 1);
    }
    (0..joined.count()).for_each(|index| of_row[joined.rows(index, inputs)].fill(index));
    (of_row, joined.count())
}
