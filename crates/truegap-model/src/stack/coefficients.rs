//! Temperature coefficients and linearity of a sensor.
//!
//! Limits: two temperatures and the nominal dimensions; linearity against the end-point line.

use super::{
    device::Device,
    options::StackOptions,
    states::{Point, state},
};
use crate::equations::coefficients::{
    Pair, Range, baseline_coefficient, baseline_drift, linearity, linearity_coefficient, sensitivity, sensitivity_coefficient,
};
use serde::Serialize;
use truegap_core::{Sensor, SimulationError};

/// Where the coefficients are taken.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct CoefficientOptions {
    /// model
    pub stack: StackOptions,
    /// T0, degrees Celsius
    pub cold_c: f64,
    /// T1, degrees Celsius
    pub hot_c: f64,
    /// load at full scale, N; the sensor's where none is given
    pub full_load_n: Option<f64>,
    /// number of equal load steps on which the greatest deviation from a line is sought
    pub steps: u32,
}

impl Default for CoefficientOptions {
    fn default() -> Self {
        Self { stack: StackOptions::default(), cold_c: 20.0, hot_c: 50.0, full_load_n: None, steps: 100 }
    }
}

/// What a data sheet would say about a sensor.
#[derive(Clone, Copy, Debug, PartialEq, Serialize)]
pub struct Coefficients {
    /// capacitance without load at T0, pF
    pub baseline_pf: f64,
    /// capacitance span from no load to full load at T0, pF
    pub span_pf: f64,
    /// drift of the baseline, pF/K: (24) as printed
    pub k_baseline_pf_per_k: f64,
    /// drift of the baseline, % of the span per kelvin
    pub k_baseline_pct_fsr_per_k: f64,
    /// drift of the sensitivity, %/K: (26)
    pub k_sensitivity_pct_per_k: f64,
    /// greatest deviation from the end-point line at T0, % of the span: (27)
    pub linearity_pct: f64,
    /// drift of the linearity, %/K: (28)
    pub k_linearity_pct_per_k: f64,
}

/// Coefficients of a sensor.
///
/// **Source:** \[hampson2023\] (24)-(28) between 20 and 50 degrees Celsius unless the options say otherwise.
/// **Accuracy:** the greatest deviation is found to 1e-9 of itself (load steps, then golden section), `the_greatest_deviation_is_that_of_a_fine_scan`.
///
/// # Errors
/// [`SimulationError`] where a load closes the gap.
pub fn coefficients(sensor: &Sensor, options: CoefficientOptions) -> Result<Coefficients, SimulationError> {
    let cold = Curve::new(sensor, options, options.cold_c)?;
    let hot = Curve::new(sensor, options, options.hot_c)?;
    let kelvin = options.hot_c - options.cold_c;
    let baseline = Pair { cold: cold.range.unloaded, hot: hot.range.unloaded };
    let sensitivities = Pair { cold: sensitivity(cold.range, cold.full), hot: sensitivity(hot.range, hot.full) };
    let linearities = Pair { cold: cold.linearity(options.steps)?, hot: hot.linearity(options.steps)? };
    Ok(Coefficients {
        baseline_pf: baseline.cold,
        span_pf: cold.range.span(),
        k_baseline_pf_per_k: baseline_drift(baseline, kelvin),
        k_baseline_pct_fsr_per_k: baseline_coefficient(baseline, kelvin, cold.range.span()),
        k_sensitivity_pct_per_k: sensitivity_coefficient(sensitivities, kelvin),
        linearity_pct: linearities.cold,
        k_linearity_pct_per_k: linearity_coefficient(linearities, kelvin),
    })
}

/// Response against load at one temperature.
struct Curve {
    device: Device,
    temperature_c: f64,
    full: f64,
    range: Range,
}

impl Curve {
    fn new(sensor: &Sensor, options: CoefficientOptions, temperature_c: f64) -> Result<Self, SimulationError> {
        let full = options.full_load_n.unwrap_or(sensor.full_scale);
        let range = Range { unloaded: 0.0, loaded: 0.0 };
        let mut curve = Self { device: Device::new(sensor, options.stack), temperature_c, full, range };
        curve.range = Range { unloaded: curve.response(0.0)?, loaded: curve.response(1.0)? };
        Ok(curve)
    }

    /// Response at a share of the full load, pF.
    fn response(&self, share: f64) -> Result<f64, SimulationError> {
        let point = Point { force_n: share * self.full, temperature_c: self.temperature_c };
        Ok(state(&self.device, 0, point)?.c_total_pf)
    }

    /// Per cent of the span by which the response at a share of the load lies off the line.
    fn deviation(&self, share: f64) -> Result<f64, SimulationError> {
        Ok(linearity(self.range, [(share, self.response(share)?)]))
    }

    /// Greatest deviation from the end-point line: the best of equal steps, refined by golden section.
    fn linearity(&self, steps: u32) -> Result<f64, SimulationError> {
        let step = 1.0 / f64::from(steps.max(2));
        let (mut best, mut at) = (0.0, 0.0);
        for i in 1..steps.max(2) {
            let share = f64::from(i) * step;
            let deviation = self.deviation(share)?;
            if deviation > best {
                (best, at) = (deviation, share);
            }
        }
        Ok(self.refined(at - step, at + step)?.max(best))
    }

    /// Greatest deviation between two shares of the load, by golden section.
    fn refined(&self, low: f64, high: f64) -> Result<f64, SimulationError> {
        let golden = 0.5 * (5f64.sqrt() - 1.0);
        let (mut low, mut high) = (low.max(0.0), high.min(1.0));
        while high - low > 1e-5 {
            let (left, right) = (high - golden * (high - low), low + golden * (high - low));
            if self.deviation(left)? >= self.deviation(right)? { high = right } else { low = left }
        }
        self.deviation(0.5 * (low + high))
    }
}
