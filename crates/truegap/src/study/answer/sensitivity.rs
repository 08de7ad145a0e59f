//! Which quantity moves which number of the data sheet, as a study answers it.
//!
//! Limits: plain data.

use crate::cells::cell;
use serde::Serialize;
use std::fmt::Write;
use truegap_design::sensitivity::{LocalSensitivity, OneAtATime, ToleranceIndices};
use truegap_design::{METRICS, Metric};

/// What is answered.
#[derive(Clone, Debug, Serialize)]
pub struct SensitivityAnswer {
    pub(in crate::study) schema: &'static str,
    /// by how many per cent each quantity went down and up
    pub change_pct: f64,
    /// order of the numbers in every row
    pub metrics: [Metric; METRICS.len()],
    /// one entry a sensor
    pub sensors: Vec<SensorSensitivity>,
}

/// One sensor.
#[derive(Clone, Debug, Serialize)]
pub struct SensorSensitivity {
    /// name
    pub sensor: String,
    /// changes, others at their values
    pub one_at_a_time: Vec<OneAtATime>,
    /// derivatives
    pub local: Vec<LocalSensitivity>,
    /// Sobol indices; `None` for a sensor without tolerances
    pub sobol: Option<ToleranceIndices>,
}

impl SensitivityAnswer {
    pub(in crate::study) fn csv(&self) -> String {
        let mut text = String::from("sensor,quantity,metric,unit,down,up,per_percent,sobol_first,sobol_total\n");
        for of in &self.sensors {
            for (row, slope) in of.one_at_a_time.iter().zip(&of.local) {
                let index = of.sobol.iter().flat_map(|s| &s.quantities).find(|q| q.quantity == row.quantity);
                for (i, metric) in METRICS.into_iter().enumerate() {
                    let sobol = index.map_or_else(|| ",".to_owned(), |q| format!("{},{}", q.first[i].value, q.total[i].value));
                    let numbers = format!("{},{},{}", row.down[i], row.up[i], slope.per_percent[i]);
                    // a String takes everything
                    let _ = writeln!(text, "{},{},{metric},{},{numbers},{sobol}", cell(&of.sensor), row.quantity, metric.unit());
                }
            }
        }
        text
    }
}
