//! Columns of several recordings behind one another, and the columns of one of them again.
//!
//! Limits: a column that a recording lacks stands as a constant among the joint columns and is taken out again before that recording is simulated.

use std::ops::Range;
use truegap_core::{Driver, INPUT_ROLES, Inputs, Role};

/// Columns that were recorded.
pub(crate) fn recorded(inputs: &Inputs) -> Vec<Role> {
    INPUT_ROLES.into_iter().filter(|role| inputs.column(*role).is_some()).collect()
}

/// All inputs, runs numbered on from 1; and the number of the first run of each recording.
///
/// `members` are the inputs of each recording, with the temperature that stands for one that was not recorded.
pub fn behind_one_another(members: &[(&Inputs, f64)]) -> (Inputs, Vec<u32>) {
    let mut all = Inputs::default();
    let (mut first_runs, mut runs) = (Vec::new(), 0);
    for (inputs, _) in members {
        first_runs.push(runs + 1);
        for run in inputs.runs() {
            runs += 1;
            all.run.extend(run.map(|_| runs));
        }
    }
    for role in INPUT_ROLES {
        let own = |m: &(&Inputs, f64)| m.0.column(role).map_or_else(|| stand_in(role, m.0.len(), m.1), <[f64]>::to_vec);
        let recorded = members.iter().any(|(inputs, _)| inputs.column(role).is_some());
        if let (true, Some(column)) = (recorded, all.column_mut(role)) {
            *column = Some(members.iter().flat_map(own).collect());
        }
    }
    all.drivers = drivers(members);
    (all, first_runs)
}

/// The drivers of all recordings, by name and unit. Recordings of which one lacks a driver are refused before they are joined; one that comes here all the same has zeros there.
fn drivers(members: &[(&Inputs, f64)]) -> Vec<Driver> {
    let mut all: Vec<Driver> = Vec::new();
    for driver in members.iter().flat_map(|(inputs, _)| &inputs.drivers) {
        if all.iter().any(|d| same(d, driver)) {
            continue;
        }
        let own = |inputs: &Inputs| inputs.drivers.iter().find(|d| same(d, driver)).map(|d| d.values.clone());
        let values = members.iter().flat_map(|(inputs, _)| own(inputs).unwrap_or_else(|| vec![0.0; inputs.len()])).collect();
        all.push(Driver { values, ..driver.clone() });
    }
    all
}

fn same(a: &Driver, b: &Driver) -> bool {
    a.name == b.name && a.unit == b.unit
}

/// What stands for a column that was not recorded.
fn stand_in(role: Role, rows: usize, temperature_c: f64) -> Vec<f64> {
    match role {
        Role::Time => (0..rows).map(|row| row as f64).collect(),
        Role::Temperature => vec![temperature_c; rows],
        _ => vec![0.0; rows],
    }
}

/// Some rows, with the columns of `has` only.
pub(crate) fn block(inputs: &Inputs, rows: Range<usize>, has: &[Role]) -> Inputs {
    let own = |column: &[f64]| column[rows.clone()].to_vec();
    let mut block = Inputs { run: inputs.run[rows.clone()].to_vec(), drivers: inputs.drivers_as(own), ..Inputs::default() };
    for role in INPUT_ROLES.into_iter().filter(|role| has.contains(role)) {
        if let Some(column) = block.column_mut(role) {
            *column = inputs.column(role).map(own);
        }
    }
    block
}
