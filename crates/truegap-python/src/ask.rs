//! The analytic model and its audit, asked from Python.
//!
//! Limits: SI in (degrees Celsius for temperatures), JSON out.

use crate::desk::serve;
use crate::source::failed;
use pyo3::prelude::*;
use std::path::PathBuf;
use std::sync::atomic::AtomicBool;
use truegap::OutputFolder;
use truegap::audit::{Cache, Options, Watch};
use truegap::core::sensor::builtin_sensors;
use truegap::diagnose::Library;
use truegap::diagnosis::{effects, explained};
use truegap::model::{CoefficientOptions, StackOptions};
use truegap::predict::find_sensor;
use truegap::verify::{AuditRequest, FILES, default_cache};

/// The analytic model at every force and temperature, as JSON.
#[pyfunction]
#[pyo3(signature = (sensor, forces_n, temperatures_c, warp))]
pub(crate) fn simulate(sensor: &str, forces_n: Vec<f64>, temperatures_c: Option<Vec<f64>>, warp: bool) -> PyResult<String> {
    let sensor = find_sensor(sensor, None).map_err(failed)?;
    let temperatures_c = temperatures_c.unwrap_or_else(|| vec![sensor.reference_c]);
    let options = StackOptions { warp, ..StackOptions::default() };
    let states =
        truegap::predict::simulate(&sensor, options, &truegap::predict::grid(&forces_n, &temperatures_c)).map_err(failed)?;
    serde_json::to_string(&states).map_err(failed)
}

/// Temperature coefficients and linearity, as JSON.
#[pyfunction]
#[pyo3(signature = (sensor, warp))]
pub(crate) fn coefficients(sensor: &str, warp: bool) -> PyResult<String> {
    let sensor = find_sensor(sensor, None).map_err(failed)?;
    let stack = StackOptions { warp, ..StackOptions::default() };
    let coefficients =
        truegap::predict::coefficients(&sensor, CoefficientOptions { stack, ..Default::default() }).map_err(failed)?;
    serde_json::to_string(&coefficients).map_err(failed)
}

/// Every assumption of the analytic model against finite elements, as `audit.json`; written to `folder` where one is given.
#[pyfunction]
#[pyo3(signature = (sensor, only, remember, folder))]
pub(crate) fn audit(
    py: Python<'_>,
    sensor: &str,
    only: Vec<String>,
    remember: bool,
    folder: Option<PathBuf>,
) -> PyResult<String> {
    folder.as_ref().map_or(Ok(()), |folder| OutputFolder::check(folder, &FILES)).map_err(failed)?;
    let request = AuditRequest {
        sensor: find_sensor(sensor, None).map_err(failed)?,
        only,
        options: Options::default(),
        cache: if remember { default_cache() } else { Cache::none() },
        command: format!("truegap audit --sensor {sensor}"),
    };
    let stop = AtomicBool::new(false);
    let work = |_: &(dyn Fn(truegap::diagnose::Progress) + Sync)| {
        truegap::verify::audit(request, &Watch { progress: None, cancel: Some(&stop) })
    };
    let audited = serve(py, None, None, &stop, work)?.map_err(failed)?;
    if let Some(folder) = folder {
        audited.write(&folder, &[]).map_err(failed)?;
    }
    serde_json::to_string(&audited.audit).map_err(failed)
}

/// Names of the built-in sensors.
#[pyfunction]
pub(crate) fn sensors() -> Vec<&'static str> {
    builtin_sensors().iter().map(|sensor| sensor.name).collect()
}

/// What an effect is, as JSON; ids and physics of all where none is named.
#[pyfunction]
#[pyo3(signature = (effect))]
pub(crate) fn explain(effect: Option<&str>) -> PyResult<String> {
    let library = Library::default();
    match effect {
        Some(name) => serde_json::to_string(&explained(name, &library).map_err(failed)?),
        None => serde_json::to_string(&effects(&library)),
    }
    .map_err(failed)
}
