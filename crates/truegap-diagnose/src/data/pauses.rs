//! Pauses inside runs, of which nothing was recorded.
//!
//! Limits: only with a clock.

use truegap_core::Inputs;

/// Usual steps beyond which a step is a pause.
const STEPS: f64 = 30.0;

/// The usual step, s, and the rows before which time jumps inside a run; `None` without a clock.
pub fn after_pauses(inputs: &Inputs) -> Option<(f64, Vec<usize>)> {
    inputs.time_s.as_ref()?;
    let steps = inputs.steps_s();
    let mut sorted: Vec<f64> = steps.iter().copied().filter(|s| *s > 0.0).collect();
    let middle = sorted.len() / 2;
    let usual = *sorted.get_mut(..).filter(|s| !s.is_empty())?.select_nth_unstable_by(middle, f64::total_cmp).1;
    Some((usual, (0..steps.len()).filter(|row| steps[*row] > STEPS * usual).collect()))
}
