//! The analytic model asked at points, along a recorded history, and for its coefficients.
//!
//! Limits: steady state at every point; memory comes with the effects of an augmented model.

use serde::Serialize;
use truegap_core::units::{readable, twelve_digits};
use truegap_core::{Recording, Sensor, SimulationError};
use truegap_limits::{Need, TooLarge, check};
use truegap_model::{CoefficientOptions, Coefficients, Point, StackOptions, State};

/// Why there is no prediction.
#[derive(Debug, thiserror::Error)]
#[non_exhaustive]
#[allow(missing_docs)] // the fields are named by the messages
pub enum PredictError {
    /// The plates touch.
    #[error(
        "{place}{} N at {} degC closes the gap of `{sensor}` (strain {strain:.3}); stay below that load, or describe a thicker or stiffer dielectric",
        readable(*force_n), readable(*temperature_c)
    )]
    GapCloses { place: String, sensor: String, force_n: f64, temperature_c: f64, strain: f64 },
    /// The model has no finite answer.
    #[error("{place}`{sensor}` has no answer at {} N and {} degC: {source}", readable(*force_n), readable(*temperature_c))]
    NoAnswer { place: String, sensor: String, force_n: f64, temperature_c: f64, source: SimulationError },
    /// The coefficients have no answer.
    #[error("the coefficients of `{sensor}` between 20 and 50 degC, up to {} N: {source}", readable(*full_scale_n))]
    NoCoefficients { sensor: String, full_scale_n: f64, source: SimulationError },
    /// A span or a baseline that is lost in rounding.
    #[error(
        "the coefficients of `{sensor}` between 20 and 50 degC, up to {} N, are not finite: its span is {} pF; check full_scale and the dimensions",
        readable(*full_scale_n), readable(*span_pf)
    )]
    NoSpan { sensor: String, full_scale_n: f64, span_pf: f64 },
    /// More than can be held.
    #[error(transparent)]
    TooLarge(#[from] TooLarge),
    /// A history without load.
    #[error("{recording}: there is no column with a force, which `{sensor}` needs; name it under [columns] as force = \"...\"")]
    NoForce { recording: String, sensor: String },
}

/// A point of a history.
#[derive(Clone, Debug, PartialEq, Serialize)]
pub struct Driven {
    /// run of the row
    pub run: u32,
    /// clock, s; absent where none was recorded
    #[serde(skip_serializing_if = "Option::is_none")]
    pub time_s: Option<f64>,
    /// the model at the row's load and temperature
    #[serde(flatten)]
    pub state: State,
}

/// Memory of an answered point, bytes: ten numbers, and what a table of them takes while it is laid out (measured: 307 MB for 100 000 points).
const MEMORY_OF_A_POINT: f64 = 3e3;

/// Whether so many points can be asked at once.
///
/// # Errors
/// [`TooLarge`].
pub fn check_points(loads: usize, temperatures: usize) -> Result<(), TooLarge> {
    let bytes = loads as f64 * temperatures as f64 * MEMORY_OF_A_POINT;
    let asked = format!("{loads} loads x {temperatures} temperatures");
    check(Need { place: "--load, --temperature", asked: &asked, bytes, remedy: "ask for fewer points" })
}

/// Every load at the first temperature, then at the next; N and degrees Celsius.
pub fn grid(forces_n: &[f64], temperatures_c: &[f64]) -> Vec<Point> {
    let at = |&temperature_c: &f64| forces_n.iter().map(move |&force_n| Point { force_n, temperature_c });
    temperatures_c.iter().flat_map(at).collect()
}

/// The model at each point.
///
/// # Errors
/// [`PredictError`] for the first point that has no answer.
pub fn simulate(sensor: &Sensor, options: StackOptions, points: &[Point]) -> Result<Vec<State>, PredictError> {
    truegap_model::states(sensor, options, points).map_err(|error| refused(sensor, points, error, |_| String::new()))
}

/// The model along the rows of a recording; without a thermometer the sensor stays at its reference temperature.
///
/// # Errors
/// [`PredictError`] for a recording without force, or the first row that has no answer.
pub fn drive(sensor: &Sensor, options: StackOptions, recording: &Recording) -> Result<Vec<Driven>, PredictError> {
    let inputs = &recording.inputs;
    let name = recording.path.display().to_string();
    let force = inputs.force_n.as_ref();
    let force = force.ok_or_else(|| PredictError::NoForce { recording: name.clone(), sensor: sensor.name.clone() })?;
    let temperature = |row: usize| inputs.temperature_c.as_ref().map_or(sensor.reference_c, |t| t[row]);
    let points: Vec<Point> =
        force.iter().enumerate().map(|(row, &force_n)| Point { force_n, temperature_c: temperature(row) }).collect();
    let states = truegap_model::states(sensor, options, &points)
        .map_err(|error| refused(sensor, &points, error, |row| format!("{name}, row {}: ", row + 1)))?;
    let time = |row: usize| inputs.time_s.as_ref().map(|t| t[row]);
    let rows = states.into_iter().enumerate();
    Ok(rows.map(|(row, state)| Driven { run: inputs.run[row], time_s: time(row), state }).collect())
}

/// Temperature coefficients and linearity of a sensor.
///
/// # Errors
/// [`PredictError`] where the full load closes the gap.
pub fn coefficients(sensor: &Sensor, options: CoefficientOptions) -> Result<Coefficients, PredictError> {
    let (name, full_scale_n) = (|| sensor.name.clone(), sensor.full_scale);
    let found = truegap_model::coefficients(sensor, options).map_err(|source| PredictError::NoCoefficients {
        sensor: name(),
        full_scale_n,
        source,
    })?;
    let c = &found;
    let all = [
        c.baseline_pf,
        c.k_baseline_pf_per_k,
        c.k_baseline_pct_fsr_per_k,
        c.k_sensitivity_pct_per_k,
        c.linearity_pct,
        c.k_linearity_pct_per_k,
    ];
    let is_finite = all.iter().all(|v| v.is_finite());
    is_finite.then_some(found).ok_or_else(|| PredictError::NoSpan { sensor: name(), full_scale_n, span_pf: found.span_pf })
}

fn refused(sensor: &Sensor, points: &[Point], error: SimulationError, place: impl Fn(usize) -> String) -> PredictError {
    let row = match &error {
        SimulationError::GapCloses { row, .. } | SimulationError::NotFinite { row, .. } => *row,
        _ => 0,
    };
    let at = points.get(row).copied().unwrap_or(Point { force_n: f64::NAN, temperature_c: f64::NAN });
    let (sensor, place) = (sensor.name.clone(), place(row));
    let (force_n, temperature_c) = (twelve_digits(at.force_n), twelve_digits(at.temperature_c));
    match error {
        SimulationError::GapCloses { strain, .. } => PredictError::GapCloses { place, sensor, force_n, temperature_c, strain },
        source => PredictError::NoAnswer { place, sensor, force_n, temperature_c, source },
    }
}
