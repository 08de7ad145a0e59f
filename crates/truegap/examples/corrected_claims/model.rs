//! Two models of one sensor under one face: the paper's, and the one with finite elements' answers in it.
//!
//! Limits: the numbers of the data sheet between 20 and 50 degrees Celsius and up to full load.

use truegap::audit::corrections::Corrected;
use truegap::audit::{Corners, coefficients_of};
use truegap::core::Sensor;
use truegap::design::{MetricOptions, Metrics, Quantity, metrics};

/// Which model.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Model {
    /// the paper's equations
    Analytic,
    /// beads bonded, electrode held flat, fields by finite elements; the modulus times a factor
    Corrected {
        /// on the modulus of the silicone and on its change with temperature
        stiffness: f64,
    },
}

impl Model {
    /// The numbers of the data sheet; `None` where the model has none.
    pub fn metrics(self, sensor: &Sensor) -> Option<Metrics> {
        match self {
            Self::Analytic => metrics(sensor, MetricOptions::default()).ok(),
            Self::Corrected { stiffness } => corrected(sensor, stiffness),
        }
    }
}

fn corrected(sensor: &Sensor, stiffness: f64) -> Option<Metrics> {
    let mut sensor = sensor.clone();
    for quantity in [Quantity::Young, Quantity::Softening] {
        let value = quantity.of(&sensor)?.value;
        quantity.set(&mut sensor, value * stiffness);
    }
    let model = Corrected::new(&sensor).ok()?;
    let corners = Corners { cold_c: 20.0, hot_c: 50.0, full_n: sensor.full_scale };
    let c = coefficients_of(&|force_n, temperature_c| model.capacitance_pf(force_n, temperature_c), corners).ok()?;
    let numbers = [
        c.baseline_pf,
        c.span_pf,
        c.linearity_pct,
        c.k_baseline_pf_per_k,
        c.k_baseline_pct_fsr_per_k,
        c.k_sensitivity_pct_per_k,
        c.k_linearity_pct_per_k,
    ];
    numbers.iter().all(|v| v.is_finite()).then_some(Metrics(numbers))
}

/// The factor on the modulus with which the corrected span is the analytic one, as the paper's fit of E_RTV to its measurements would have it.
pub fn refitted(sensor: &Sensor) -> Option<f64> {
    let wanted = Model::Analytic.metrics(sensor)?.0[1];
    let span = |stiffness: f64| Model::Corrected { stiffness }.metrics(sensor).map(|m| m.0[1]);
    // the span falls with the modulus; no answer means beads squeezed beyond the tables: too soft
    let (mut low, mut high) = (0.05, 2.0);
    for _ in 0..60 {
        let middle = 0.5 * (low + high);
        if span(middle).is_none_or(|s| s > wanted) { low = middle } else { high = middle }
    }
    span(high).filter(|s| (s / wanted - 1.0).abs() < 1e-6).map(|_| high)
}
