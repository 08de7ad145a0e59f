//! `viscoelastic_creep`: the beads go on yielding under load by a power law of time, `J(t) = J0 (1 + c (t / 1 s)^n)`.
//!
//! Limits: linear in the elastic compression; what creeps within the first microsecond counts as elastic, since the spectrum of
//! rates that carries the power law (see `kernel`) ends there.

use super::{Mechanism, Numbers, numbers};
use crate::draws::Draws;
use crate::physics::memory::relax;
use crate::state::{Scene, State};

/// Power-law creep; the size is c.
#[derive(Debug, Clone)]
pub struct ViscoelasticCreep {
    power: f64,
}

/// Draws the power.
pub fn draw(draws: &mut Draws) -> Box<dyn Mechanism> {
    Box::new(ViscoelasticCreep { power: draws.between(0.12, 0.32) })
}

/// Weights and rates (1/s) such that `sum w (1 - exp(-s t))` is `t^n`:
/// t^n = n / Gamma(1 - n) * integral of (1 - e^(-s t)) s^(-n-1) ds, by the trapezium in ln s, eight points to the decade.
fn kernel(power: f64) -> Vec<(f64, f64)> {
    const PER_DECADE: f64 = 8.0;
    let step = std::f64::consts::LN_10 / PER_DECADE;
    let lead = power / gamma_above_half(1.0 - power) * step;
    (-72..=48)
        .map(|k| {
            let rate = (f64::from(k) * step).exp();
            (lead * rate.powf(-power), rate)
        })
        .collect()
}

/// Gamma function for 0.5 < x < 1, by recurrence to x + 8 and Stirling's series (relative error below 1e-12).
fn gamma_above_half(x: f64) -> f64 {
    let z = x + 8.0;
    let series = 1.0 / (12.0 * z) - 1.0 / (360.0 * z.powi(3)) + 1.0 / (1260.0 * z.powi(5)) - 1.0 / (1680.0 * z.powi(7));
    let log = (z - 0.5) * z.ln() - z + 0.5 * (2.0 * std::f64::consts::PI).ln() + series;
    log.exp() / (0..8).map(|k| x + f64::from(k)).product::<f64>()
}

impl Mechanism for ViscoelasticCreep {
    fn id(&self) -> &'static str {
        "viscoelastic_creep"
    }
    fn size_start(&self) -> f64 {
        1e-4
    }
    fn size_limit(&self) -> f64 {
        0.1
    }
    fn numbers(&self, size: f64) -> Numbers {
        numbers([("share_at_1_s", size), ("power", self.power)])
    }
    fn strain(&self, size: f64, scene: Scene, state: &mut State) {
        let kernel = kernel(self.power);
        let elastic = state.compression.clone();
        for run in scene.history.runs() {
            let mut crept = vec![0.0; kernel.len()];
            for row in run.start + 1..run.end {
                let dt = scene.history.time[row] - scene.history.time[row - 1];
                let mut sum = 0.0;
                for (q, (weight, rate)) in crept.iter_mut().zip(&kernel) {
                    *q = relax(*q, elastic[row - 1], elastic[row], dt, 1.0 / rate);
                    sum += weight * *q;
                }
                state.compression[row] += size * sum;
            }
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    /// The ends of the spectrum that are cut off bound the error: below 1 % between 10 ms and an hour.
    #[test]
    fn the_spectrum_adds_up_to_the_power_law() {
        for power in [0.12, 0.32] {
            for t in [0.05, 1.0, 60.0, 3600.0_f64] {
                let sum: f64 = kernel(power).iter().map(|(w, s)| w * -(-s * t).exp_m1()).sum();
                let cut = 1e-6_f64.powf(power);
                let exact = t.powf(power);
                assert!((sum - exact).abs() < 1.1 * cut + 0.003 * exact, "t = {t}: {sum} against {exact}");
            }
        }
    }
}
