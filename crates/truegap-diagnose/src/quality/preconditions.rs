//! Doubts about a recording itself, found before any physics is named.
//!
//! Limits: looks at one column at a time; what is certainly wrong is told by [`crate::quality::rows`].

use crate::{
    data::{
        context::load_column,
        error::{DiagnoseError, FEWEST_ROWS},
        problem::Problem,
    },
    quality::rows,
    quality::tuning::{LOAD_CHANGES, LONG_STANDSTILL, STANDSTILL_SHARE, WARMS},
    stats::spread,
    text::Scale,
};
use truegap_core::{Inputs, Role};

/// Checks what makes a diagnosis impossible.
///
/// # Errors
/// [`DiagnoseError`] for a recording that cannot tell anything.
pub fn check(problem: &Problem<'_>) -> Result<(), DiagnoseError> {
    let rows = problem.response.len();
    if rows < FEWEST_ROWS {
        return Err(DiagnoseError::TooFewRows { rows, needed: FEWEST_ROWS });
    }
    if spread(problem.response) == 0.0 {
        return Err(DiagnoseError::DeadChannel { value: problem.response[0], unit: problem.simulator.unit().into() });
    }
    match constant(problem) {
        Some((column, value)) => Err(DiagnoseError::ConstantInput { column, value, rows }),
        None => Ok(()),
    }
}

/// The column that drives the model and its value, where neither it nor temperature changes.
fn constant(problem: &Problem<'_>) -> Option<(&'static str, String)> {
    let inputs = problem.inputs;
    let stands = |column: &[f64], least: f64| rows::stands(column, least, problem);
    if inputs.temperature_c.as_ref().is_some_and(|t| !stands(t, WARMS)) {
        return None;
    }
    if inputs.drivers.iter().any(|driver| !stands(&driver.values, 0.0)) {
        return None;
    }
    let drives = |role: &Role| matches!(role, Role::Force | Role::Pressure | Role::Gap);
    let driving = problem.simulator.needs().iter().copied().filter(drives);
    let all: Vec<_> = driving.filter_map(|role| Some((role.key(), role.unit(), inputs.column(role)?))).collect();
    let full = problem.simulator.full_load();
    let still = |(_, _, column): &(&str, &str, &[f64])| {
        let greatest = column.iter().fold(0.0f64, |m, v| m.max(v.abs()));
        stands(column, 1e-3 * full.unwrap_or(greatest))
    };
    let (name, unit, column) = *all.first()?;
    let value = column.iter().sum::<f64>() / column.len() as f64;
    all.iter().all(still).then(|| (name, Scale::of(unit, value.abs()).text(value)))
}

/// Doubts that a reader should know of, worst first.
pub fn doubts(problem: &Problem<'_>) -> Vec<String> {
    let mut list = Vec::new();
    list.extend(stuck(problem.response));
    list.extend(constant_inputs(problem.inputs, problem));
    list
}

/// A long stretch of one value while the inputs moved elsewhere.
fn stuck(response: &[f64]) -> Option<String> {
    let (mut longest, mut at, mut first) = (0, 0, 0);
    for row in 1..=response.len() {
        if row == response.len() || response[row] != response[first] {
            if row - first > longest {
                (longest, at) = (row - first, first);
            }
            first = row;
        }
    }
    let distinct = response.windows(2).filter(|w| w[0] != w[1]).count();
    (longest > LONG_STANDSTILL && longest * STANDSTILL_SHARE > distinct).then(|| {
        format!(
            "the response stays at {} for {longest} rows from row {}: a channel that hangs, or a coarse resolution",
            response[at],
            at + 1
        )
    })
}

fn constant_inputs(inputs: &Inputs, problem: &Problem<'_>) -> Option<String> {
    let load = load_column(inputs, problem.simulator).is_some_and(|l| spread(&l) > LOAD_CHANGES);
    let temperature = inputs.temperature_c.as_ref().is_some_and(|t| spread(t) > WARMS);
    let driver = inputs.drivers.iter().any(|driver| spread(&driver.values) > 0.0);
    // a simulation or a gap that moves is what the reading follows
    let followed = [&inputs.simulated, &inputs.gap_m].into_iter().flatten().any(|column| spread(column) > 0.0);
    (!load && !temperature && !driver && !followed).then(|| "no input changes: only noise, drift and steps can show".to_owned())
}
