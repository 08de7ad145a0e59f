//! The answer: what the firmware corrects, how exactly, and what it takes of a microcontroller.
//!
//! Limits: decides nothing.

use super::FirmwareError;
use crate::diagnosis::compensate::document::spares;
use crate::models::LeftOut;
use serde::Serialize;
use std::path::Path;
use truegap_diagnose::answer::ModelFacts;
use truegap_diagnose::text::{significant, spoken_list};

/// Identifier of the document.
pub const SCHEMA: &str = "truegap.firmware/1";
/// How a file of this kind begins.
pub(super) const FIRST_LINE: &str = "/* Written by `truegap firmware`";

/// An argument of the function that corrects, besides the time and the reading.
#[derive(Clone, Debug, PartialEq, Serialize)]
pub struct Argument {
    /// its name in C
    pub name: String,
    /// the column of the recording
    pub column: String,
    /// its unit; empty where it is not known
    pub unit: String,
    /// where the tables begin, in that unit
    pub low: f64,
    /// where they end
    pub high: f64,
    /// nodes along it; 1 where only what comes late of it is followed
    pub nodes: usize,
    /// nodes along what comes late of it; absent where nothing does
    #[serde(skip_serializing_if = "Option::is_none")]
    pub late_nodes: Option<usize>,
}

/// A lag of the reading that is undone.
#[derive(Clone, Debug, PartialEq, Serialize)]
pub struct Undone {
    /// id of the effect
    pub effect: String,
    /// time constant of the sensor, s
    pub tau_s: f64,
    /// most that is left of it, s
    pub left_s: f64,
    /// most that the noise grows by it, at any step
    pub most_growth: f64,
    /// how much it grows at the step from row to row of the diagnosis; absent where that had no clock
    #[serde(skip_serializing_if = "Option::is_none")]
    pub growth: Option<f64>,
}

/// The answer.
#[derive(Clone, Debug, Serialize)]
pub struct FirmwareFacts {
    /// always `truegap.firmware/1`
    pub schema: &'static str,
    /// program and version
    pub made_by: String,
    /// the model
    pub model: ModelFacts,
    /// unit of the reading
    pub unit: String,
    /// effects for which a reading is corrected
    pub corrected_for: Vec<String>,
    /// the other added effects
    pub left_out: Vec<LeftOut>,
    /// least and greatest reading of the table; absent where the correction does not follow the reading
    #[serde(skip_serializing_if = "Option::is_none")]
    pub readings: Option<[f64; 2]>,
    /// nodes along the reading
    pub reading_nodes: usize,
    /// what else the correction follows
    pub arguments: Vec<Argument>,
    /// bytes of the table
    pub table_bytes: usize,
    /// bytes of the state, in memory that is written
    pub state_bytes: usize,
    /// largest error of the table between its nodes, response unit
    pub error: f64,
    /// what a `float` rounds of the largest reading, response unit
    pub rounding: f64,
    /// error of the table that was wanted: a tenth of the noise, or a ten thousandth of the range of the readings where that is not known
    pub wanted: f64,
    /// noise of a reading that the model file states, response unit
    pub noise: f64,
    /// most that the table makes the noise grow
    pub table_growth: f64,
    /// the lag of the reading that is undone; absent where there is none
    #[serde(skip_serializing_if = "Option::is_none")]
    pub undone: Option<Undone>,
    /// the answer in a sentence
    pub says: String,
    /// what a reader should know beside it
    pub notes: Vec<String>,
}

impl FirmwareFacts {
    /// Whether table and numbers are as exact as was wanted.
    pub fn is_exact(&self) -> bool {
        self.error <= self.wanted && self.rounding <= self.wanted
    }

    /// Why table and numbers are less exact than was wanted.
    pub(super) fn doubts(&self) -> Vec<String> {
        let unit = &self.unit;
        let [error, rounding, wanted] = [self.error, self.rounding, self.wanted].map(|value| significant(value, 2));
        let table = format!(
            "between nodes the table is wrong by {error} {unit}, more than the {wanted} {unit} that were wanted; allow more --bytes, or give a narrower --range"
        );
        let float = format!(
            "a float rounds the largest reading by {rounding} {unit}, more than the {wanted} {unit} that were wanted; diagnose and correct readings less a fixed number"
        );
        let all = [(self.error > self.wanted, table), (self.rounding > self.wanted, float)];
        all.into_iter().filter(|(is_so, _)| *is_so).map(|(_, told)| told).collect()
    }

    /// That the table makes the noise grow, where it does by more than a twentieth.
    fn louder(&self) -> String {
        let by = significant(self.table_growth, 3);
        match self.table_growth > 1.05 {
            true => format!(" Where the table is steepest, the noise of a reading grows by a factor of {by}."),
            false => String::new(),
        }
    }

    pub(super) fn sentence(&self) -> String {
        let names = spoken_list(&self.corrected_for, "and");
        let (unit, error) = (&self.unit, significant(self.error, 2));
        let (table, state) = (self.table_bytes, self.state_bytes);
        let of_noise = match self.noise > 0.0 {
            true => format!(", {} of the noise ({} {unit})", significant(self.error / self.noise, 2), significant(self.noise, 3)),
            false => String::new(),
        };
        let lag = self.undone.as_ref().map_or_else(String::new, |undone| {
            let [tau, left] = [undone.tau_s, undone.left_s].map(|time| significant(time, 3));
            let most = significant(undone.most_growth, 3);
            let growth = undone.growth.map(|by| significant(by, 3));
            let at_step = growth.map_or_else(String::new, |by| format!(", and by {by} at the steps of the diagnosis"));
            format!(" The lag of {tau} s is undone up to {left} s at the most; the noise grows by a factor of {most} at the most{at_step}.")
        });
        format!(
            "Corrects for {names}: {table} bytes of table and {state} bytes of state; between its nodes the table is wrong by {error} {unit} at the most{of_noise}.{lag}{}",
            self.louder()
        )
    }
}

/// The answer and the file in C.
pub struct Firmware {
    /// the answer
    pub document: FirmwareFacts,
    /// the file, C99
    pub source: String,
}

impl Firmware {
    /// Writes the file, all or none; an earlier result is replaced.
    ///
    /// # Errors
    /// [`FirmwareError`] where something else has the name, or the disk refuses.
    pub fn write(&self, file: &Path) -> Result<(), FirmwareError> {
        check(file)?;
        Ok(truegap_sweep::write_atomically(file, self.source.as_bytes())?)
    }
}

/// Whether `file` may be written: it is not there, or an earlier result. Asked before the work begins.
///
/// # Errors
/// [`FirmwareError::WouldBeLost`].
pub fn check(file: &Path) -> Result<(), FirmwareError> {
    let is_ours = |line: &str| line.starts_with(FIRST_LINE);
    if spares(file, is_ours) { Ok(()) } else { Err(FirmwareError::WouldBeLost { file: file.to_owned() }) }
}
