//! Control: sparse regression on the residual of the calibrated model, as SINDy does it, and the physics that its terms would be read as.
//!
//! Limits: the dictionary is of the inputs and their simplest memories; nothing is calibrated again beside the terms, which is what is usually done.

use nalgebra::{DMatrix, DVector};
use serde_json::{Value, json};
use truegap_core::Inputs;

/// Thresholds tried, in standard deviations of one reading.
const THRESHOLDS: [f64; 6] = [0.05, 0.1, 0.2, 0.5, 1.0, 2.0];
/// Rounds of thresholding.
const ROUNDS: usize = 10;

/// A term of the dictionary: the effect that a reader would take it for, and its column.
struct Term {
    effect: &'static str,
    column: Vec<f64>,
}

/// Claims of the sparse model: `residual` and `noise` in the response's unit.
///
/// **Source:** Brunton, Proctor & Kutz, PNAS 113 (2016) 3932 (sequentially thresholded least squares); threshold by Schwarz's criterion.
pub(super) fn claims(inputs: &Inputs, residual: &[f64], noise: f64) -> Value {
    let terms = dictionary(inputs);
    let rows = residual.len();
    let scaled: Vec<DVector<f64>> = terms.iter().filter_map(|t| standard(&t.column)).collect();
    if scaled.len() < terms.len() || terms.is_empty() || noise <= 0.0 {
        return json!({"verdict": "agrees"});
    }
    let design = DMatrix::from_columns(&scaled);
    let mean = residual.iter().sum::<f64>() / rows as f64;
    let target = DVector::from_iterator(rows, residual.iter().map(|r| (r - mean) / noise));
    let (gram, right) = (design.tr_mul(&design), design.tr_mul(&target));
    let criterion = |kept: &[usize]| {
        let fitted = solve(&gram, &right, kept).map_or(0.0, |c| kept.iter().zip(c.iter()).map(|(k, c)| right[*k] * c).sum());
        target.norm_squared() - fitted + kept.len() as f64 * (rows as f64).ln()
    };
    let models = THRESHOLDS.iter().map(|threshold| sparse(&gram, &right, *threshold));
    let best = models.chain(std::iter::once(Vec::new())).min_by(|a, b| criterion(a).total_cmp(&criterion(b))).unwrap_or_default();
    let mut names: Vec<&str> = best.iter().map(|k| terms[*k].effect).collect();
    names.sort_unstable();
    names.dedup();
    if names.is_empty() {
        return json!({"verdict": "agrees"});
    }
    let findings: Vec<Value> = names.iter().map(|name| json!({"effect": name})).collect();
    json!({"verdict": "explained", "findings": findings})
}

/// Indices of the terms that survive a threshold.
fn sparse(gram: &DMatrix<f64>, right: &DVector<f64>, threshold: f64) -> Vec<usize> {
    let mut kept: Vec<usize> = (0..right.len()).collect();
    for _ in 0..ROUNDS {
        let Some(coefficients) = solve(gram, right, &kept) else { return Vec::new() };
        let next: Vec<usize> =
            kept.iter().zip(coefficients.iter()).filter(|(_, c)| c.abs() >= threshold).map(|(k, _)| *k).collect();
        if next.len() == kept.len() {
            break;
        }
        kept = next;
    }
    kept
}

fn solve(gram: &DMatrix<f64>, right: &DVector<f64>, kept: &[usize]) -> Option<DVector<f64>> {
    let ridge = 1e-6 * gram[(0, 0)];
    let part = DMatrix::from_fn(kept.len(), kept.len(), |i, j| gram[(kept[i], kept[j])] + if i == j { ridge } else { 0.0 });
    part.cholesky().map(|f| f.solve(&DVector::from_iterator(kept.len(), kept.iter().map(|k| right[*k]))))
}

/// Mean 0, root mean square 1; `None` where the column does not change.
fn standard(column: &[f64]) -> Option<DVector<f64>> {
    let n = column.len() as f64;
    let mean = column.iter().sum::<f64>() / n;
    let spread = (column.iter().map(|v| (v - mean).powi(2)).sum::<f64>() / n).sqrt();
    (spread > 1e-12).then(|| DVector::from_iterator(column.len(), column.iter().map(|v| (v - mean) / spread)))
}

fn dictionary(inputs: &Inputs) -> Vec<Term> {
    let rows = inputs.len();
    let mut terms: Vec<Term> = Vec::new();
    let mut add = |effect, column: Vec<f64>| {
        if standard(&column).is_some() {
            terms.push(Term { effect, column });
        }
    };
    let time: Vec<f64> = inputs.time_s.clone().unwrap_or_else(|| (0..rows).map(|r| r as f64).collect());
    let still = vec![0.0; rows];
    let force = inputs.force_n.as_ref().or(inputs.pressure_pa.as_ref()).unwrap_or(&still);
    let warm = inputs.temperature_c.as_ref().unwrap_or(&still);
    let product = |a: &[f64], b: &[f64]| a.iter().zip(b).map(|(a, b)| a * b).collect::<Vec<f64>>();
    add("load_cell_error", force.clone());
    add("strain_stiffening", product(force, force));
    add("saturation", product(force, &product(force, force)));
    add("permittivity_temperature", warm.clone());
    add("gain_drift", product(force, warm));
    add("offset_drift", time.clone());
    add("humidity_uptake", inputs.humidity_pct.clone().unwrap_or_else(|| still.clone()));
    add("readout_lag", rate(inputs, force, &time));
    add("rate_independent_hysteresis", rate(inputs, force, &time).iter().map(|r| r.signum()).collect());
    add("thermal_hysteresis", rate(inputs, warm, &time).iter().map(|r| r.signum()).collect());
    add("thermal_lag", lag(inputs, warm, &time, 60.0));
    add("viscoelastic_creep", lag(inputs, force, &time, 30.0));
    let mut greatest = f64::NEG_INFINITY;
    add(
        "mullins_softening",
        force
            .iter()
            .map(|f| {
                greatest = greatest.max(*f);
                greatest
            })
            .collect(),
    );
    terms
}

/// Change per second from row to row.
fn rate(inputs: &Inputs, column: &[f64], time: &[f64]) -> Vec<f64> {
    let mut out = vec![0.0; column.len()];
    for run in inputs.runs() {
        for row in run.start + 1..run.end {
            let step = time[row] - time[row - 1];
            out[row] = if step > 0.0 { (column[row] - column[row - 1]) / step } else { 0.0 };
        }
    }
    out
}

/// First-order lag less the column itself.
fn lag(inputs: &Inputs, column: &[f64], time: &[f64], tau_s: f64) -> Vec<f64> {
    let mut out = vec![0.0; column.len()];
    for run in inputs.runs() {
        let mut state = column[run.start];
        for row in run.start + 1..run.end {
            state = column[row] + (state - column[row]) * (-(time[row] - time[row - 1]).max(0.0) / tau_s).exp();
            out[row] = state - column[row];
        }
    }
    out
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_lag_in_the_residual_is_read_as_creep_and_noise_as_nothing() {
        let time: Vec<f64> = (0..2000).map(|i| 0.5 * f64::from(i)).collect();
        let force: Vec<f64> = time.iter().map(|t| if (t / 100.0) as i32 % 2 == 0 { 0.0 } else { 4.0 }).collect();
        let inputs = Inputs { time_s: Some(time.clone()), run: vec![1; 2000], force_n: Some(force.clone()), ..Inputs::default() };
        let noise: Vec<f64> = (0..2000).map(|i| 1.4 * (f64::from(i) * 2.3).sin()).collect();
        assert_eq!(claims(&inputs, &noise, 1.0)["verdict"], "agrees");
        let crept: Vec<f64> = lag(&inputs, &force, &time, 30.0).iter().zip(&noise).map(|(l, n)| 3.0 * l + n).collect();
        assert_eq!(claims(&inputs, &crept, 1.0)["findings"], json!([{"effect": "viscoelastic_creep"}]));
    }
}
