//! Scatter, yield and the tolerance to tighten first, as a study answers them.
//!
//! Limits: plain data.

use crate::cells::cell;
use serde::Serialize;
use std::fmt::Write;
use truegap_design::METRICS;
use truegap_design::tolerance::{PROBABILITIES, Scatter, Specification, Tightened, Yield};

/// What is answered.
#[derive(Clone, Debug, Serialize)]
pub struct ToleranceAnswer {
    pub(in crate::study) schema: &'static str,
    /// seed
    pub seed: u64,
    /// whether all cases are in it
    pub complete: bool,
    /// what a good sensor is
    pub specification: Specification,
    /// one entry a sensor
    pub sensors: Vec<BatchAnswer>,
    /// the first sensor with one tolerance halved, the one to tighten first in front
    pub tighten: Vec<Tightened>,
}

/// One batch.
#[derive(Clone, Debug, Serialize)]
pub struct BatchAnswer {
    /// sensor
    pub sensor: String,
    /// sensors drawn
    pub samples: usize,
    /// scatter of every metric
    pub scatter: Vec<Scatter>,
    /// share of good sensors
    #[serde(rename = "yield")]
    pub good: Yield,
}

impl ToleranceAnswer {
    pub(in crate::study) fn scatter_csv(&self) -> String {
        let quantiles = PROBABILITIES.map(|p| format!("q{p}")).join(",");
        let mut text = format!("sensor,metric,unit,mean,sd,{quantiles}\n");
        for batch in &self.sensors {
            for s in &batch.scatter {
                let quantiles = s.quantiles.iter().map(f64::to_string).collect::<Vec<_>>().join(",");
                // a String takes everything
                let _ =
                    writeln!(text, "{},{},{},{},{},{quantiles}", cell(&batch.sensor), s.metric, s.metric.unit(), s.mean, s.sd);
            }
        }
        text
    }

    pub(in crate::study) fn tighten_csv(&self) -> String {
        let mut text = format!("quantity,yield,yield_gained,{}\n", METRICS.map(|m| format!("{m}_sd_falls_pct")).join(","));
        for row in &self.tighten {
            let falls = row.scatter_falls_pct.map(|v| v.to_string()).join(",");
            let _ = writeln!(text, "{},{},{},{falls}", row.quantity, row.share, row.gain); // a String takes everything
        }
        text
    }
}
