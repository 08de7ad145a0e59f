//! A recording made in the program, with the names and the hash that it has once it is written.
//!
//! Limits: what the columns mean is for the caller to know; only their lengths are checked.

use super::{data::Recording, error::RecordingError, manifest::BaseSpec, write};
use crate::inputs::{Inputs, Role};
use std::collections::BTreeMap;
use std::path::PathBuf;

impl Recording {
    /// A recording made in the program.
    ///
    /// # Errors
    /// [`RecordingError::Lengths`] where a column has not one value a row, [`RecordingError::NotToml`] where `base` cannot be written.
    pub fn new(inputs: Inputs, response: Vec<f64>, response_unit: &str, base: BaseSpec) -> Result<Self, RecordingError> {
        let (found, expected) = (response.len(), inputs.len());
        if found != expected {
            return Err(RecordingError::Lengths { column: Role::Response.key().to_owned(), found, expected });
        }
        Self::made(inputs, response, response_unit, base)
    }

    /// As [`Recording::new`], where no response may be given.
    pub(super) fn made(inputs: Inputs, response: Vec<f64>, response_unit: &str, base: BaseSpec) -> Result<Self, RecordingError> {
        let mut recording = Self {
            inputs,
            response,
            response_unit: response_unit.to_owned(),
            simulated_unit: None,
            base,
            sensors: None,
            columns: BTreeMap::new(),
            sha256: String::new(),
            path: PathBuf::new(),
            notes: Vec::new(),
        };
        recording.check_lengths()?;
        recording.columns = write::names(&recording);
        recording.sha256 = write::sha256(&recording)?;
        Ok(recording)
    }

    fn check_lengths(&self) -> Result<(), RecordingError> {
        let expected = self.inputs.len();
        if let Some(driver) = self.inputs.drivers.iter().find(|driver| driver.values.len() != expected) {
            return Err(RecordingError::Lengths { column: driver.name.clone(), found: driver.values.len(), expected });
        }
        match self.quantities().into_iter().find(|(_, column)| column.len() != expected) {
            Some((role, column)) => Err(RecordingError::Lengths { column: role.key().to_owned(), found: column.len(), expected }),
            None => Ok(()),
        }
    }
}
