//! Scatter and yield of batches within their tolerances, of one sensor or of two beside each other, and which tolerance to tighten first.
//!
//! Limits: a case is 65 536 sensors; quantiles are means over cases; which tolerance to tighten is decided on one case a tolerance.

use super::answer::tolerance::{BatchAnswer, ToleranceAnswer};
use super::work::{check_memory, merged, write};
use super::{Finished, SensorText, StudyError, Work, page};
use serde::{Deserialize, Serialize};
use std::path::Path;
use truegap_core::Sensor;
use truegap_design::tolerance::{
    BATCH, BatchOptions, Limit, Specification, Summary, Tightened, halved, join, part, rank, tolerances,
};
use truegap_design::{DesignError, Metric, MetricOptions, Quantity};
use truegap_sweep::Sweep;

/// Name of the study in a sweep's folder.
pub const STUDY: &str = concat!("truegap.tolerance/1 of ", env!("CARGO_PKG_VERSION"));

/// Memory of a batch, bytes: what it is, its name, and seven metrics with their quantiles.
const MEMORY_OF_A_BATCH: f64 = 4e3;

/// An end or both of what a metric may be.
#[derive(Clone, Copy, Debug, PartialEq, Serialize, Deserialize)]
pub struct Between {
    /// which metric
    pub metric: Metric,
    /// least value
    #[serde(skip_serializing_if = "Option::is_none", default)]
    pub low: Option<f64>,
    /// greatest value
    #[serde(skip_serializing_if = "Option::is_none", default)]
    pub high: Option<f64>,
}

/// What is asked.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
pub struct ToleranceRequest {
    /// the sensor, and one to set beside it
    pub sensors: Vec<SensorText>,
    /// what a good sensor is
    pub limits: Vec<Between>,
    /// sensors in each batch
    pub samples: usize,
    /// seed
    pub seed: u64,
}

/// A case: some of the sensors of a batch.
#[derive(Clone, Copy, Debug, Serialize)]
struct Case {
    sensor: usize,
    scramble: usize,
    samples: usize,
    #[serde(skip_serializing_if = "Option::is_none")]
    halved: Option<Quantity>,
}

/// A request that has been checked.
struct Checked {
    sensors: Vec<Sensor>,
    specification: Specification,
    options: BatchOptions,
    sweep: Sweep<Case>,
}

impl ToleranceRequest {
    /// Computes the work's share; writes the results where it is the whole and has a folder.
    ///
    /// # Errors
    /// [`StudyError`].
    pub fn run(&self, work: Work<'_>) -> Result<Finished<ToleranceAnswer>, StudyError> {
        let checked = self.checked()?;
        let (ran, answers) = work.answers(&checked.sweep, |case| checked.solve(case))?;
        let answer = answers.map(|answers| self.answer(&checked, answers));
        if let (Some(answer), Some(folder)) = (&answer, work.folder) {
            answer.write(folder)?;
        }
        Ok(Finished { ran, answer })
    }

    pub(super) fn merge(&self, folder: &Path, partial: bool) -> Result<ToleranceAnswer, StudyError> {
        let checked = self.checked()?;
        let answers = merged(&checked.sweep, folder, partial)?;
        Ok(self.answer(&checked, answers))
    }

    fn checked(&self) -> Result<Checked, StudyError> {
        let sensors = self.sensors.iter().map(SensorText::sensor).collect::<Result<Vec<_>, _>>()?;
        let limit = |b: &Between| Limit::new(b.metric, b.low.unwrap_or(f64::NEG_INFINITY), b.high.unwrap_or(f64::INFINITY));
        let specification = Specification::new(self.limits.iter().map(limit).collect::<Result<_, _>>()?)?;
        if self.samples < 16 {
            return Err(DesignError::TooFewSamples { samples: self.samples, least: 16 }.into());
        }
        for sensor in &sensors {
            if tolerances(sensor).is_empty() {
                return Err(DesignError::NoTolerance { sensor: sensor.name.clone() }.into());
            }
            truegap_design::metrics(sensor, MetricOptions::default())?;
        }
        let cases = self.samples.div_ceil(BATCH) as f64 * sensors.len() as f64;
        check_memory("--samples", cases, &format!("batches of {BATCH} sensors"), MEMORY_OF_A_BATCH)?;
        let options = BatchOptions { samples: self.samples, seed: self.seed, ..Default::default() };
        let sweep = Sweep::new(STUDY, self, self.cases(&sensors))?;
        Ok(Checked { sensors, specification, options, sweep })
    }

    fn cases(&self, sensors: &[Sensor]) -> Vec<Case> {
        let samples = |scramble: usize| BATCH.min(self.samples - scramble * BATCH);
        let batch = |sensor: usize| {
            (0..self.samples.div_ceil(BATCH)).map(move |scramble| Case {
                sensor,
                scramble,
                samples: samples(scramble),
                halved: None,
            })
        };
        let whole = (0..sensors.len()).flat_map(batch);
        let tightened = sensors.iter().take(1).flat_map(tolerances);
        whole.chain(tightened.map(|q| Case { sensor: 0, scramble: 0, samples: samples(0), halved: Some(q) })).collect()
    }

    fn answer(&self, checked: &Checked, answers: Vec<Option<Summary>>) -> ToleranceAnswer {
        let complete = answers.iter().all(Option::is_some);
        let there: Vec<(&Case, Summary)> = checked.sweep.cases().iter().zip(answers).filter_map(|(c, a)| Some((c, a?))).collect();
        let of = |sensor: usize| -> Vec<Summary> {
            there.iter().filter(|(c, _)| c.sensor == sensor && c.halved.is_none()).map(|(_, a)| a.clone()).collect()
        };
        let batch = |(i, sensor): (usize, &Sensor)| {
            let parts = of(i);
            let (scatter, good) = join(&parts);
            let samples = parts.iter().map(|p| p.counts.sensors).sum();
            (samples > 0).then(|| BatchAnswer { sensor: sensor.name.clone(), samples, scatter, good })
        };
        let before = there.iter().find(|(c, _)| c.sensor == 0 && c.scramble == 0 && c.halved.is_none());
        let before = before.map(|(_, a)| join(std::slice::from_ref(a)));
        let tightened = there.iter().filter_map(|(c, a)| {
            let (scatter, good) = before.as_ref()?;
            let after = join(std::slice::from_ref(a));
            Some(Tightened::new(c.halved?, (scatter, good), (&after.0, &after.1)))
        });
        ToleranceAnswer {
            schema: "truegap.tolerance/1",
            seed: self.seed,
            complete,
            specification: checked.specification.clone(),
            sensors: checked.sensors.iter().enumerate().filter_map(batch).collect(),
            tighten: rank(tightened.collect()),
        }
    }
}

impl Checked {
    fn solve(&self, case: &Case) -> Result<Summary, DesignError> {
        let mut sensor = self.sensors[case.sensor].clone();
        if let Some(quantity) = case.halved {
            sensor = halved(&sensor, quantity);
        }
        let begin = case.scramble * BATCH;
        Ok(Summary::of(&part(&sensor, self.options, begin..begin + case.samples)?, &self.specification))
    }
}

impl ToleranceAnswer {
    /// Writes `tolerance.json`, `scatter.csv`, `tighten.csv`, figures and `report.html`.
    ///
    /// # Errors
    /// [`StudyError::Sweep`] where the disk refuses.
    pub fn write(&self, folder: &Path) -> Result<(), StudyError> {
        let mut files = vec![
            ("tolerance.json".to_owned(), serde_json::to_string_pretty(self)? + "\n"),
            ("scatter.csv".to_owned(), self.scatter_csv()),
            ("tighten.csv".to_owned(), self.tighten_csv()),
        ];
        files.extend(page::tolerance::figures(self)?);
        files.push(("report.html".to_owned(), page::tolerance::html(self)?));
        write(folder, &files)
    }
}
