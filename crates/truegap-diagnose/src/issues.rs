//! Doubts about a recording itself, found before any physics is named.
//!
//! Limits: looks at one column at a time.

use crate::context::load_column;
use crate::problem::Problem;
use truegap_core::Inputs;

/// Why nothing can be concluded from a recording.
#[derive(Debug, thiserror::Error)]
#[non_exhaustive]
pub enum DiagnoseError {
    /// Too short.
    #[error("{rows} rows are too few to tell anything; record at least {needed}")]
    TooFewRows {
        /// rows found
        rows: usize,
        /// rows needed
        needed: usize,
    },
    /// The response never moves.
    #[error("the response is {value} {unit} in every row: a dead channel; check the wiring and the column that [columns] names")]
    DeadChannel {
        /// the value
        value: f64,
        /// its unit
        unit: String,
    },
    /// The model has no answer at the recording's inputs.
    #[error(transparent)]
    Simulation(#[from] truegap_core::SimulationError),
    /// Somebody asked to stop before anything was known.
    #[error("stopped before the base model was calibrated; nothing is known yet")]
    Stopped,
}

/// Fewest rows that can tell anything.
pub const FEWEST_ROWS: usize = 20;

/// Checks what makes a diagnosis impossible.
///
/// # Errors
/// [`DiagnoseError`] for a recording that cannot tell anything.
pub fn check(problem: &Problem<'_>) -> Result<(), DiagnoseError> {
    let rows = problem.response.len();
    if rows < FEWEST_ROWS {
        return Err(DiagnoseError::TooFewRows { rows, needed: FEWEST_ROWS });
    }
    if crate::directions::spread(problem.response) == 0.0 {
        return Err(DiagnoseError::DeadChannel { value: problem.response[0], unit: problem.simulator.unit().into() });
    }
    Ok(())
}

/// Doubts that a reader should know of, worst first.
pub fn doubts(problem: &Problem<'_>) -> Vec<String> {
    let mut list = Vec::new();
    list.extend(stuck(problem.response));
    list.extend(clipped(problem.response));
    list.extend(constant_inputs(problem.inputs, problem));
    list.extend(pauses(problem.inputs));
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
    (longest > 50 && longest * 10 > distinct).then(|| {
        format!(
            "the response stays at {} for {longest} rows from row {}: a channel that hangs, or a coarse resolution",
            response[at],
            at + 1
        )
    })
}

/// Many rows at exactly the greatest or the least value.
fn clipped(response: &[f64]) -> Option<String> {
    let greatest = response.iter().copied().fold(f64::NEG_INFINITY, f64::max);
    let least = response.iter().copied().fold(f64::INFINITY, f64::min);
    let at = |v: f64| response.iter().filter(|r| **r == v).count();
    let share = 0.02 * response.len() as f64;
    [(greatest, "greatest"), (least, "least")]
        .into_iter()
        .find(|(v, _)| at(*v) as f64 > share.max(20.0))
        .map(|(v, name)| format!("{} rows lie exactly at the {name} value {v}: the reading may be clipped", at(v)))
}

fn constant_inputs(inputs: &Inputs, problem: &Problem<'_>) -> Option<String> {
    let load = load_column(inputs, problem.simulator).is_some_and(|l| crate::directions::spread(&l) > 1e-3);
    let temperature = inputs.temperature_c.as_ref().is_some_and(|t| crate::directions::spread(t) > 0.3);
    (!load && !temperature).then(|| "no input changes: only noise, drift and steps can show".to_owned())
}

/// Pauses inside runs much longer than the usual step.
fn pauses(inputs: &Inputs) -> Option<String> {
    inputs.time_s.as_ref()?;
    let steps = inputs.steps_s();
    let mut sorted: Vec<f64> = steps.iter().copied().filter(|s| *s > 0.0).collect();
    sorted.sort_by(f64::total_cmp);
    let usual = *sorted.get(sorted.len() / 2)?;
    let (row, longest) = steps.iter().enumerate().max_by(|a, b| a.1.total_cmp(b.1))?;
    (*longest > 30.0 * usual).then(|| format!("time jumps by {longest:.1} s at row {} inside a run (usual step {usual:.3} s): what happened in between is unknown to effects with a memory", row + 1))
}
