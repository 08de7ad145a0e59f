//! Finite-element cases and design studies, asked from Python.
//!
//! Limits: names, texts and numbers in, JSON out; results are written where a folder is given, as the command line writes them.

use crate::desk::serve;
use crate::source::failed;
use pyo3::prelude::*;
use serde::Serialize;
use std::path::{Path, PathBuf};
use std::sync::atomic::{AtomicBool, Ordering};
use truegap::design::Metric;
use truegap::design::optimise::{SearchOptions, Useful};
use truegap::diagnose::Progress;
use truegap::fem::case::solve_case;
use truegap::study::optimise::OptimiseRequest;
use truegap::study::sensitivity::SensitivityRequest;
use truegap::study::tolerance::{Between, ToleranceRequest};
use truegap::study::vary::axes;
use truegap::study::{Finished, SensorText, StudyError, Work, check_place};
use truegap::sweep::{Control, Progress as Cases, Shard};
use truegap::verify::case_file::{open_case, told};

fn json(answer: &impl Serialize) -> PyResult<String> {
    serde_json::to_string(answer).map_err(failed)
}

fn texts(sensors: &[String]) -> PyResult<Vec<SensorText>> {
    sensors.iter().map(|name| SensorText::find(name).map_err(failed)).collect()
}

/// A finite-element case, solved: what `truegap --json solve` prints.
#[pyfunction]
pub(crate) fn solve(py: Python<'_>, file: PathBuf) -> PyResult<String> {
    let case = open_case(&file).map_err(failed)?;
    let stop = AtomicBool::new(false);
    let solved = serve(py, None, None, &stop, |_| solve_case(&case))?;
    json(&solved.map_err(|source| failed(told(&case.file, &source)))?)
}

/// Which quantity moves which number of the data sheet, as `sensitivity.json`.
#[pyfunction]
#[pyo3(signature = (sensors, change_pct, rows, seed, folder, progress))]
pub(crate) fn sensitivity(
    py: Python<'_>,
    sensors: Vec<String>,
    change_pct: f64,
    rows: usize,
    seed: u64,
    folder: Option<PathBuf>,
    progress: Option<Py<PyAny>>,
) -> PyResult<String> {
    folder.as_deref().map_or(Ok(()), check_place).map_err(failed)?;
    let request = SensitivityRequest { sensors: texts(&sensors)?, change_pct, rows, seed };
    let stop = AtomicBool::new(false);
    let answer = serve(py, None, progress.as_ref(), &stop, |tell| {
        request.run(|done, of| {
            tell(step(done, of, "sensitivity"));
            !stop.load(Ordering::Relaxed)
        })
    })?;
    let answer = answer.map_err(failed)?;
    folder.map_or(Ok(()), |folder| answer.write(&folder)).map_err(failed)?;
    json(&answer)
}

/// Scatter and yield of a batch, as `tolerance.json`; `limits` are a metric with its least and greatest value.
#[pyfunction]
#[pyo3(signature = (sensors, limits, samples, seed, folder, progress))]
pub(crate) fn tolerance(
    py: Python<'_>,
    sensors: Vec<String>,
    limits: Vec<(String, Option<f64>, Option<f64>)>,
    samples: usize,
    seed: u64,
    folder: Option<PathBuf>,
    progress: Option<Py<PyAny>>,
) -> PyResult<String> {
    let between = |(name, low, high): (String, Option<f64>, Option<f64>)| {
        let known = || truegap::design::METRICS.map(Metric::name).join(", ");
        let metric =
            Metric::named(&name).ok_or_else(|| failed(format!("there is no metric `{name}`; take one of {}", known())))?;
        Ok(Between { metric, low, high })
    };
    let limits = limits.into_iter().map(between).collect::<PyResult<_>>()?;
    let request = ToleranceRequest { sensors: texts(&sensors)?, limits, samples, seed };
    study(py, folder.as_deref(), progress.as_ref(), "tolerance", |work| request.run(work))
}

/// Designs with smaller temperature coefficients, as `optimise.json`; `useful` are least baseline and span, greatest linearity error and coverage.
#[pyfunction]
#[pyo3(signature = (sensor, vary, hold, useful, searches, seed, folder, progress))]
#[allow(clippy::too_many_arguments)] // Python's half names each of them
pub(crate) fn optimise(
    py: Python<'_>,
    sensor: &str,
    vary: Vec<String>,
    hold: Vec<String>,
    useful: [Option<f64>; 4],
    searches: u64,
    seed: u64,
    folder: Option<PathBuf>,
    progress: Option<Py<PyAny>>,
) -> PyResult<String> {
    let sensor = SensorText::find(sensor).map_err(failed)?;
    let usual = Useful::default();
    let request = OptimiseRequest {
        axes: axes(&sensor, &hold, &vary).map_err(failed)?,
        sensor,
        useful: Useful {
            baseline: useful[0].unwrap_or(usual.baseline),
            span: useful[1].unwrap_or(usual.span),
            linearity: useful[2].unwrap_or(usual.linearity),
            covered: useful[3].unwrap_or(usual.covered),
        },
        search: SearchOptions { seed, ..Default::default() },
        searches,
    };
    study(py, folder.as_deref(), progress.as_ref(), "optimise", |work| request.run(work))
}

/// Runs a study whole, and gives its answer.
fn study<A: Serialize + Send>(
    py: Python<'_>,
    folder: Option<&Path>,
    progress: Option<&Py<PyAny>>,
    what: &'static str,
    run: impl FnOnce(Work<'_>) -> Result<Finished<A>, StudyError> + Send,
) -> PyResult<String> {
    let stop = AtomicBool::new(false);
    let finished = serve(py, None, progress, &stop, |tell| {
        let told = |cases: Cases| tell(step(cases.done, cases.of, what));
        run(Work { folder, shard: Shard::WHOLE, control: Control { progress: Some(&told), cancel: Some(&stop) } })
    })?;
    let answer = finished.map_err(failed)?.answer;
    json(&answer.ok_or_else(|| failed("the study gave no answer, although it was asked for as a whole"))?)
}

fn step(done: usize, of: usize, step: &'static str) -> Progress {
    Progress { done: done as f64 / of.max(1) as f64, step, what: format!("{done} of {of}") }
}
