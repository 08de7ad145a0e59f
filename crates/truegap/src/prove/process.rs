//! Control: a Gaussian process on the residual of the calibrated model, which names nothing and may predict all the same.
//!
//! Limits: load, temperature and time as they are, no memory; a few hundred rows are learned from; whole runs are left out.

use nalgebra::{Cholesky, DMatrix, DVector};
use truegap_core::{Inputs, ends};
use truegap_diagnose::parts;

/// Rows learned from.
const LEARNED: usize = 300;
/// Lengths of correlation tried, as shares of each input's range.
const LENGTHS: [f64; 4] = [0.05, 0.15, 0.5, 1.5];

/// Share of the misfit above the noise that the process removes on parts it has not seen; `None` where there is none to remove.
///
/// `residual` and `noise` in the response's unit. **Source:** Rasmussen & Williams, Gaussian Processes for Machine Learning (2006), algorithm 2.1; squared
/// exponential kernel, length by marginal likelihood.
pub(super) fn misfit_removed(inputs: &Inputs, residual: &[f64], noise: f64) -> Option<f64> {
    let features = features(inputs);
    let (_, parts) = parts(&inputs.runs(), &inputs.run);
    let (mut before, mut after, mut count) = (0.0, 0.0, 0.0);
    for part in &parts {
        let out: Vec<usize> = part.rows.iter().cloned().flatten().collect();
        let seen: Vec<usize> = (0..residual.len()).filter(|r| !part.rows.iter().any(|p| p.contains(r))).collect();
        let learned: Vec<usize> = seen.iter().copied().step_by(seen.len().div_ceil(LEARNED).max(1)).collect();
        let process = Process::learn(&features, residual, &learned, noise)?;
        for row in out.iter().step_by(out.len().div_ceil(LEARNED).max(1)) {
            before += residual[*row].powi(2);
            after += (residual[*row] - process.at(&features[*row])).powi(2);
            count += 1.0;
        }
    }
    let there = before / count - noise * noise;
    (there > 4.0 * noise * noise * (2.0f64 / count).sqrt()).then(|| 1.0 - (after / count - noise * noise) / there)
}

/// Load, temperature and time of each row, each over its range.
fn features(inputs: &Inputs) -> Vec<[f64; 3]> {
    let scaled = |column: Option<&Vec<f64>>| -> Vec<f64> {
        let Some(column) = column else { return vec![0.0; inputs.len()] };
        let (low, high) = ends(column.iter().copied());
        let range = if high > low { high - low } else { 1.0 };
        column.iter().map(|v| (v - low) / range).collect()
    };
    let force = scaled(inputs.force_n.as_ref().or(inputs.pressure_pa.as_ref()).or(inputs.gap_m.as_ref()));
    let (warm, time) = (scaled(inputs.temperature_c.as_ref()), scaled(inputs.time_s.as_ref()));
    (0..inputs.len()).map(|r| [force[r], warm[r], time[r]]).collect()
}

struct Process {
    places: Vec<[f64; 3]>,
    weights: DVector<f64>,
    length: f64,
    variance: f64,
}

fn kernel(a: &[f64; 3], b: &[f64; 3], length: f64) -> f64 {
    let distance: f64 = a.iter().zip(b).map(|(a, b)| (a - b).powi(2)).sum();
    (-0.5 * distance / (length * length)).exp()
}

impl Process {
    /// The length of the greatest marginal likelihood.
    fn learn(features: &[[f64; 3]], residual: &[f64], rows: &[usize], noise: f64) -> Option<Self> {
        let places: Vec<[f64; 3]> = rows.iter().map(|r| features[*r]).collect();
        let target = DVector::from_iterator(rows.len(), rows.iter().map(|r| residual[*r]));
        let total = target.norm_squared() / rows.len() as f64;
        let variance = (total - noise * noise).max(0.01 * noise * noise);
        let one = |length: f64| {
            let n = places.len();
            let covariance = DMatrix::from_fn(n, n, |i, j| {
                variance * kernel(&places[i], &places[j], length) + if i == j { noise * noise } else { 0.0 }
            });
            let factor = Cholesky::new(covariance)?;
            let weights = factor.solve(&target);
            let log_det: f64 = factor.l_dirty().diagonal().iter().map(|d| d.ln()).sum();
            Some((-0.5 * target.dot(&weights) - log_det, weights, length))
        };
        let best = LENGTHS.iter().filter_map(|l| one(*l)).max_by(|a, b| a.0.total_cmp(&b.0))?;
        Some(Self { places, weights: best.1, length: best.2, variance })
    }

    fn at(&self, place: &[f64; 3]) -> f64 {
        self.places.iter().zip(self.weights.iter()).map(|(p, w)| w * self.variance * kernel(p, place, self.length)).sum()
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_smooth_function_of_the_load_is_learned_from_other_runs_and_noise_is_not() {
        let rows = 900;
        let force: Vec<f64> = (0..rows).map(|i| 4.0 * (f64::from(i) * 0.05).sin().abs()).collect();
        let run: Vec<u32> = (0..rows).map(|i| i as u32 / 300).collect();
        let inputs = Inputs { run, force_n: Some(force.clone()), ..Inputs::default() };
        let noise: Vec<f64> = (0..rows).map(|i| std::f64::consts::SQRT_2 * (f64::from(i) * 2.3).sin()).collect();
        assert!(misfit_removed(&inputs, &noise, 1.0).is_none());
        let misfit: Vec<f64> = force.iter().zip(&noise).map(|(f, n)| 3.0 * (f - 2.0) + n).collect();
        let share = misfit_removed(&inputs, &misfit, 1.0).unwrap();
        assert!(share > 0.95, "{share}");
    }
}
