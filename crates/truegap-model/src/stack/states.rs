//! Every quantity of the model at given loads and temperatures.
//!
//! Limits: steady state, nominal dimensions.

use super::{device::Device, options::StackOptions};
use serde::Serialize;
use truegap_core::{Refusal, Sensor, SimulationError};

/// A load and a temperature.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Point {
    /// force on the sensor, N
    pub force_n: f64,
    /// temperature of the sensor, degrees Celsius
    pub temperature_c: f64,
}

/// Every quantity of the model at one point.
#[derive(Clone, Copy, Debug, PartialEq, Serialize)]
pub struct State {
    /// force, N
    pub force_n: f64,
    /// temperature, degrees Celsius
    pub temperature_c: f64,
    /// strain of the beads, negative in compression as in the paper's (12)
    pub strain: f64,
    /// curvature of the centre electrode, 1/m; positive where its rim moves away
    pub curvature_per_m: f64,
    /// bead layer, pF
    pub c_rtv_pf: f64,
    /// insulator in series with it, pF
    pub c_polyimide_pf: f64,
    /// the two in series, pF
    pub c_main_pf: f64,
    /// insulator behind the electrode, pF; 0 in a mutual layout
    pub c_backing_pf: f64,
    /// tail, pF; 0 in a mutual layout
    pub c_tail_pf: f64,
    /// what is read, pF
    pub c_total_pf: f64,
}

/// The model at each point.
///
/// # Errors
/// [`SimulationError`] with the index of the first point that has no answer, for instance because its load closes the gap.
pub fn states(sensor: &Sensor, options: StackOptions, points: &[Point]) -> Result<Vec<State>, SimulationError> {
    let device = Device::new(sensor, options);
    points.iter().enumerate().map(|(row, &point)| state(&device, row, point)).collect()
}

/// Difference of two temperatures that were written as decimals, to 1e-12 K: 20.001 - 20 is 0.001 K, not the 0.001 000 000 000 001 K that is left of
/// the binary numbers. It matters to the curvature, which is proportional to the difference.
fn decimal_difference(temperature_c: f64, reference_c: f64) -> f64 {
    ((temperature_c - reference_c) * 1e12).round() / 1e12
}

pub(super) fn state(device: &Device, row: usize, point: Point) -> Result<State, SimulationError> {
    let Point { force_n, temperature_c } = point;
    let warm = device.warmed_by(decimal_difference(temperature_c, device.reference_c));
    let refuse = |refusal: Refusal| refusal.at(row, force_n, &[]);
    let strain = device.strain(&warm, force_n, 1.0, [0.0; 2]).map_err(refuse)?;
    let parts = device.capacitances(&warm, &device.plain(&warm, force_n, strain)).map_err(refuse)?;
    Ok(State {
        force_n,
        temperature_c,
        strain: 0.0 - strain,
        curvature_per_m: parts.curvature,
        c_rtv_pf: parts.beads * 1e12,
        c_polyimide_pf: parts.insulator * 1e12,
        c_main_pf: parts.shares.main * 1e12,
        c_backing_pf: parts.shares.backing * 1e12,
        c_tail_pf: parts.shares.tail * 1e12,
        c_total_pf: device.total(parts.shares) * 1e12,
    })
}
