//! Which quantity moves which number of the data sheet: one at a time, derivatives, Sobol indices over the tolerances; of one design or of two beside each other.
//!
//! Limits: a study of seconds, computed in one process; stopped, it keeps the rows it has.

use super::answer::sensitivity::{SensitivityAnswer, SensorSensitivity};
use super::work::{check_place, write};
use super::{SensorText, StudyError, page};
use std::path::Path;
use truegap_design::sensitivity::{PAPER_QUANTITIES, SobolOptions, local, one_at_a_time, tolerance_indices};
use truegap_design::{DesignError, METRICS, MetricOptions};

/// What is asked.
#[derive(Clone, Debug, PartialEq)]
pub struct SensitivityRequest {
    /// the sensor, and one to set beside it
    pub sensors: Vec<SensorText>,
    /// by how many per cent each quantity goes down and up
    pub change_pct: f64,
    /// rows of the Sobol study
    pub rows: usize,
    /// its seed
    pub seed: u64,
}

impl SensitivityRequest {
    /// Computes the study; `watch` is told rows done and rows in all, and may stop the Sobol study by `false`.
    ///
    /// # Errors
    /// [`StudyError`].
    pub fn run(&self, watch: impl Fn(usize, usize) -> bool) -> Result<SensitivityAnswer, StudyError> {
        let options = MetricOptions::default();
        let all = self.rows.saturating_mul(self.sensors.len());
        let mut sensors = Vec::new();
        for (i, text) in self.sensors.iter().enumerate() {
            let sensor = text.sensor()?;
            let present: Vec<_> = PAPER_QUANTITIES.into_iter().filter(|q| q.of(&sensor).is_some()).collect();
            let rows = SobolOptions { rows: self.rows, seed: self.seed, ..Default::default() };
            let sobol = match tolerance_indices(&sensor, options, rows, |done| {
                watch(i.saturating_mul(self.rows).saturating_add(done), all)
            }) {
                Ok(indices) => Some(indices),
                Err(DesignError::NoTolerance { .. }) => None,
                Err(error) => return Err(error.into()),
            };
            sensors.push(SensorSensitivity {
                one_at_a_time: one_at_a_time(&sensor, &present, 0.01 * self.change_pct, options)?,
                local: local(&sensor, &present, options)?,
                sensor: sensor.name,
                sobol,
            });
        }
        Ok(SensitivityAnswer { schema: "truegap.sensitivity/1", change_pct: self.change_pct, metrics: METRICS, sensors })
    }
}

impl SensitivityAnswer {
    /// Writes `sensitivity.json`, `sensitivity.csv`, figures and `report.html`.
    ///
    /// # Errors
    /// [`StudyError::Sweep`] where the disk refuses.
    pub fn write(&self, folder: &Path) -> Result<(), StudyError> {
        let mut files = vec![
            ("sensitivity.json".to_owned(), serde_json::to_string_pretty(self)? + "\n"),
            ("sensitivity.csv".to_owned(), self.csv()),
        ];
        files.extend(page::sensitivity::figures(self)?);
        files.push(("report.html".to_owned(), page::sensitivity::html(self)?));
        check_place(folder)?;
        write(folder, &files)
    }
}
