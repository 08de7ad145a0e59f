//! Which columns base model and effects need: those without which a trial history is answered otherwise.
//!
//! Limits: a trial of one run within the ranges of the recording that the model was made of; where it has no answer nothing is said.

use super::input::{Column, Sought};
use crate::models::RunningModel;
use std::f64::consts::TAU;
use truegap_core::{INPUT_ROLES, Inputs};
use truegap_diagnose::answer::AddedEffect;

/// Rows of the trial.
const ROWS: usize = 96;
/// Part of the greatest answer by which one differs.
const DIFFERS: f64 = 1e-6;
/// Seconds from row to row where the model has no longest run; not 1, which stands for rows without a clock.
const STEP_S: f64 = 1.3;

/// Who needs a column that is not there.
pub(super) struct Missing {
    pub column: Column,
    /// id of the effect; `None` of the base model
    pub effect: Option<String>,
}

/// The first column that is needed and that `inputs` do not have; the one that is sought is not needed.
pub(super) fn missing(
    model: &RunningModel,
    effects: &[AddedEffect],
    sought: Option<&Sought>,
    inputs: &Inputs,
) -> Option<Missing> {
    let trial = trial(model, sought);
    let is_sought = |column: &Column| sought.is_some_and(|sought| sought.column == *column);
    let absent = columns(&trial).into_iter().filter(|column| column.values(inputs).is_none() && !is_sought(column));
    absent.into_iter().find_map(|column| {
        let mut without = trial.clone();
        column.put(&mut without, None);
        if differs(&model.respond_with(&[], &trial).ok()?, model.respond_with(&[], &without).ok().as_deref()) {
            return Some(Missing { column, effect: None });
        }
        let needs = |added: &&AddedEffect| {
            let one = std::slice::from_ref(*added);
            let whole = model.respond_with(one, &trial);
            whole.is_ok_and(|whole| differs(&whole, model.respond_with(one, &without).ok().as_deref()))
        };
        let effect = effects.iter().find(needs)?.id.clone();
        Some(Missing { column, effect: Some(effect) })
    })
}

fn differs(whole: &[f64], without: Option<&[f64]>) -> bool {
    let greatest = whole.iter().fold(0.0f64, |most, value| most.max(value.abs()));
    let apart = |other: &[f64]| whole.iter().zip(other).any(|(a, b)| (a - b).abs() > DIFFERS * greatest || b.is_nan());
    without.is_none_or(apart)
}

/// The columns of a history.
pub(super) fn columns(trial: &Inputs) -> Vec<Column> {
    let there = INPUT_ROLES.into_iter().filter(|role| trial.column(*role).is_some()).map(Column::Of);
    there.chain(trial.drivers.iter().map(|driver| Column::Driver(driver.name.clone()))).collect()
}

/// Every column that the model was made with, each on its own way up and down.
pub(super) fn trial(model: &RunningModel, sought: Option<&Sought>) -> Inputs {
    let (scales, simulator) = (model.scales(), model.simulator());
    let moved = scales.moved.clone().unwrap_or_default();
    let course = |turns: f64, low: f64, width: f64| -> Vec<f64> {
        (0..ROWS).map(|row| low + width * 0.5 * (1.0 - (TAU * turns * row as f64 / ROWS as f64).cos())).collect()
    };
    let step = if scales.longest_run_s > 0.0 { scales.longest_run_s / ROWS as f64 } else { STEP_S };
    let step = if step == 1.0 { STEP_S } else { step };
    let full = simulator.full_load().filter(|_| moved.load > 0.0 || scales.moved.is_none());
    let warmth = if scales.moved.is_none() { 10.0 } else { moved.temperature_k };
    let mut trial = Inputs {
        time_s: (scales.shortest_step_s > 0.0).then(|| (0..ROWS).map(|row| step * row as f64).collect()),
        run: vec![1; ROWS],
        force_n: full.map(|full| course(1.0, 0.0, full)),
        pressure_pa: full.map(|full| course(1.0, 0.0, full)),
        temperature_c: (warmth > 0.0).then(|| course(1.7, simulator.reference_c(), warmth)),
        humidity_pct: Some(course(2.3, 30.0, 40.0)),
        ..Inputs::default()
    };
    for (k, name) in moved.drivers.iter().chain(&moved.round).enumerate() {
        let [low, high] = moved.ranges.get(name).copied().unwrap_or([0.0, 1.0]);
        Column::Driver(name.clone()).put(&mut trial, Some(course(2.9 + 0.6 * k as f64, low, high - low)));
    }
    if let Some(Sought { column, span, .. }) = sought {
        column.put(&mut trial, Some(course(1.0, span.zero, span.width)));
    }
    trial
}
