//! A recording in memory: columns in SI, and where they come from.
//!
//! Limits: rows are kept in the order of the file.

use super::{manifest::BaseSpec, note::Note};
use crate::inputs::{INPUT_ROLES, Inputs, Role};
use std::collections::BTreeMap;
use std::path::PathBuf;

/// What was done to a sensor and what was read.
#[derive(Clone, Debug, PartialEq)]
pub struct Recording {
    /// what was done, SI
    pub inputs: Inputs,
    /// what was read, one value a row, in `response_unit`; empty where the inputs alone were asked for and no column holds it
    pub response: Vec<f64>,
    /// `pF` for every capacitance, else the unit as it was named; empty where there is no response
    pub response_unit: String,
    /// unit of the simulated column, where it is another than the response's: the gain, which is free there, holds the ratio
    pub simulated_unit: Option<String>,
    /// the base model that the recording is to be compared with
    pub base: BaseSpec,
    /// sensor of each row, where the recording holds several
    pub sensors: Option<Sensors>,
    /// name in the file of each role's column
    pub columns: BTreeMap<Role, String>,
    /// SHA-256 of the CSV, hexadecimal
    pub sha256: String,
    /// TOML or CSV that was opened; empty for a recording made in the program
    pub path: PathBuf,
    /// what reading changed, left out or assumed
    pub notes: Vec<Note>,
}

/// Which sensor each row is from.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Sensors {
    /// index of `names`, one a row
    pub of_row: Vec<u32>,
    /// names as in the file
    pub names: Vec<String>,
}

impl Recording {
    /// Number of rows.
    pub fn len(&self) -> usize {
        self.inputs.len()
    }

    /// Whether there is no row.
    pub fn is_empty(&self) -> bool {
        self.inputs.is_empty()
    }

    /// What was read; `None` where the inputs alone were asked for and no column holds it.
    pub(super) fn recorded_response(&self) -> Option<&[f64]> {
        Some(self.response.as_slice()).filter(|response| self.is_empty() || !response.is_empty())
    }

    /// Rows `keep` in that order; names, base and notes stay.
    #[must_use]
    pub fn select(&self, keep: &[usize]) -> Self {
        let of_row = |sensors: &Sensors| keep.iter().map(|&row| sensors.of_row[row]).collect();
        Self {
            inputs: self.inputs.select(keep),
            response: self.recorded_response().map_or_else(Vec::new, |all| keep.iter().map(|&row| all[row]).collect()),
            sensors: self.sensors.as_ref().map(|s| Sensors { of_row: of_row(s), names: s.names.clone() }),
            ..self.clone()
        }
    }

    /// The rows of one sensor; all rows where the recording does not tell sensors apart.
    #[must_use]
    pub fn of_sensor(&self, name: &str) -> Self {
        let Some(sensors) = &self.sensors else { return self.clone() };
        let is_it = |row: &usize| sensors.names.get(sensors.of_row[*row] as usize).is_some_and(|n| n == name);
        self.select(&(0..self.len()).filter(is_it).collect::<Vec<_>>())
    }

    /// The columns of numbers that were recorded, SI, with their roles.
    pub fn quantities(&self) -> Vec<(Role, &[f64])> {
        let inputs = &self.inputs;
        let given = INPUT_ROLES.into_iter().filter_map(|role| Some((role, inputs.column(role)?)));
        given.chain(self.recorded_response().map(|read| (Role::Response, read))).collect()
    }

    /// Notes on columns that never change.
    pub(super) fn constants(&self) -> Vec<Note> {
        let constant = |column: &[f64]| column.len() > 1 && column.iter().all(|v| *v == column[0]);
        let found = self.quantities().into_iter().filter(|(_, column)| constant(column));
        found.map(|(role, column)| Note::Constant { role, value: column[0] }).collect()
    }
}
