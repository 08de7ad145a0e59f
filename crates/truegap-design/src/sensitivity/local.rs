//! Derivatives of the metrics at a design.
//!
//! Limits: central differences with one Richardson step, not dual numbers: the model's equations are written for `f64`. Each derivative carries its own error estimate.

use crate::{
    error::DesignError,
    metric::METRICS,
    metrics::{MetricOptions, metrics},
    quantity::Quantity,
};
use serde::Serialize;
use truegap_core::Sensor;

/// Largest step, share of the value.
const STEP: f64 = 4e-3;

/// Derivatives with respect to one quantity.
#[derive(Clone, Debug, PartialEq, Serialize)]
pub struct LocalSensitivity {
    /// the quantity
    pub quantity: Quantity,
    /// change of each metric for a change of the quantity by 1 % of its value, to first order, in the metric's unit
    pub per_percent: [f64; METRICS.len()],
    /// estimate of the error of each
    pub error: [f64; METRICS.len()],
}

/// Derivatives of all metrics; quantities whose value is 0 are left out.
///
/// **Accuracy:** the step of 0.4 % and its half are combined, which leaves an error of fourth order; 1e-5 of the largest derivative of a metric against
/// closed forms and other steps, `derivatives_do_not_depend_on_the_step`.
///
/// # Errors
/// As [`metrics`], also for a design so close to touching that a step of 0.4 % closes the gap.
pub fn local(sensor: &Sensor, quantities: &[Quantity], options: MetricOptions) -> Result<Vec<LocalSensitivity>, DesignError> {
    let nominal = quantities.iter().filter_map(|&q| Some((q, q.of(sensor)?.value))).filter(|(_, value)| *value != 0.0);
    nominal.map(|(quantity, value)| derivative(sensor, quantity, value, STEP, options)).collect()
}

fn derivative(
    sensor: &Sensor,
    quantity: Quantity,
    value: f64,
    step: f64,
    options: MetricOptions,
) -> Result<LocalSensitivity, DesignError> {
    let at = |factor: f64| {
        let mut sensor = sensor.clone();
        quantity.set(&mut sensor, value * factor);
        metrics(&sensor, options)
    };
    let central = |step: f64| -> Result<[f64; METRICS.len()], DesignError> {
        let (up, down) = (at(1.0 + step)?, at(1.0 - step)?);
        Ok(std::array::from_fn(|i| 0.01 * (up.0[i] - down.0[i]) / (2.0 * step)))
    };
    let (coarse, fine) = (central(step)?, central(0.5 * step)?);
    let per_percent = std::array::from_fn(|i| (4.0 * fine[i] - coarse[i]) / 3.0);
    let error = std::array::from_fn(|i| (fine[i] - coarse[i]).abs() / 3.0);
    Ok(LocalSensitivity { quantity, per_percent, error })
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::{metric::Metric, sensitivity::PAPER_QUANTITIES};
    use truegap_core::sensor::builtin_sensors;

    #[test]
    fn derivatives_do_not_depend_on_the_step() {
        let sensor = builtin_sensors()[0].sensor().unwrap();
        let options = MetricOptions::default();
        let rows = local(&sensor, &PAPER_QUANTITIES, options).unwrap();
        for (i, metric) in METRICS.into_iter().enumerate() {
            let largest = rows.iter().map(|r| r.per_percent[i].abs()).fold(0.0, f64::max);
            assert!(largest > 0.0);
            for row in &rows {
                let value = row.quantity.of(&sensor).unwrap().value;
                let other = derivative(&sensor, row.quantity, value, 1.3e-3, options).unwrap();
                let off = (other.per_percent[i] - row.per_percent[i]).abs();
                assert!(off < 1e-5 * largest, "{metric} {:?}: {off:e} of {largest:e}", row.quantity);
            }
        }
    }

    #[test]
    fn the_thickness_behind_the_electrode_has_the_derivative_of_its_formula() {
        // flat, without load: C = 1/(1/C_beads + 1/C_PA) + C_PA + C_tail, every C_PA and C_tail ~ 1/h
        let sensor = builtin_sensors()[0].sensor().unwrap();
        let state = truegap_model::states(
            &sensor,
            truegap_model::StackOptions::default(),
            &[truegap_model::Point { force_n: 0.0, temperature_c: 20.0 }],
        )
        .unwrap()[0];
        let main = state.c_main_pf * state.c_main_pf / state.c_polyimide_pf;
        let known = -0.01 * (main + state.c_backing_pf + state.c_tail_pf);
        let found = &local(&sensor, &[Quantity::Insulator], MetricOptions::default()).unwrap()[0];
        approx::assert_relative_eq!(found.per_percent[Metric::Baseline as usize], known, max_relative = 1e-9);
    }
}
