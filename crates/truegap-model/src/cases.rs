//! Problems that tests and benches share, so that what is timed is what is checked.
//!
//! Limits: deterministic; no random numbers.

use crate::equations::{integral::BentPlates, warp::Dome};
use truegap_core::{
    Inputs, Sensor,
    sensor::{SensorError, builtin_sensors},
};

/// Bent plates by name: flat, as the default sensor bends at 50 and at -10 degrees Celsius, as the optimised one does, nearly touching either way.
pub fn bent_plates() -> [(&'static str, BentPlates); 6] {
    let settled = |curvature: f64, radius: f64, gap: f64| BentPlates::settled(gap, Dome { curvature, radius });
    [
        ("flat", settled(0.0, 7.5e-3, 162e-6)),
        ("default hot", settled(1.436, 7.5e-3, 162e-6)),
        ("default cold", settled(-1.437, 7.5e-3, 162e-6)),
        ("optimised hot", settled(11.25, 4e-3, 198e-6)),
        ("centre nearly touches", settled(11.5, 7.5e-3, 162e-6)),
        ("rim nearly touches", settled(-11.45, 7.5e-3, 162e-6)),
    ]
}

/// The default built-in sensor.
///
/// # Errors
/// As [`Sensor::from_toml`].
pub fn default_sensor() -> Result<Sensor, SensorError> {
    builtin_sensors()[0].sensor()
}

/// Staircases of load between 0 and `full_load_n` while the temperature sweeps 20-50 degrees Celsius: one row a tenth of a second.
pub fn staircase(rows: usize, full_load_n: f64) -> Inputs {
    let clock = |row: usize| row as f64 * 0.1;
    let step = |row: usize| {
        let phase = (row / 50) % 20;
        let level = if phase <= 10 { phase } else { 20 - phase };
        full_load_n * level as f64 / 10.0
    };
    let warm = |row: usize| 35.0 - 15.0 * (std::f64::consts::TAU * row as f64 / rows.max(1) as f64).cos();
    Inputs {
        time_s: Some((0..rows).map(clock).collect()),
        run: vec![1; rows],
        force_n: Some((0..rows).map(step).collect()),
        temperature_c: Some((0..rows).map(warm).collect()),
        ..Inputs::default()
    }
}
