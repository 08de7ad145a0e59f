//! Evidence against quadrature on a grid, where the posterior is far from Gaussian.

use crate::{
    Context, Problem,
    calibration::{FitOptions, InputError, Model, Noise, Whitener, fit},
    common::{Plate, recording},
    fit::importance::sampled,
};
use truegap_core::Simulator;

/// Noise so large that the modulus is hardly known: the posterior is bent by its log-normal prior and by the curve of the response.
#[test]
fn sampling_finds_the_evidence_that_a_grid_finds() {
    let (plate, inputs) = (Plate::new(Some(true)), recording());
    let mut response = plate.respond(&[11.0, 4.0], &inputs, &[]).unwrap();
    response.iter_mut().enumerate().for_each(|(i, r)| *r += 3.0 * (1.3 * i as f64).sin());
    let problem = Problem { inputs: &inputs, response: &response, simulator: &plate };
    let context = Context::new(&inputs, &plate, 2.0, 60.0);
    let model = Model::new(&problem, &context, Vec::new());
    let noise = Noise { white_sd: 60.0, ar_sd: 0.0, ar_correlation: 0.0 };
    let whitener = Whitener::new(&noise, &InputError::white(vec![0.0; response.len()]), None, &inputs.runs(), None);
    let best = fit(&model, &whitener, &[0.0, 0.0], &FitOptions::default()).unwrap();
    let found = sampled(&model, &whitener, &best, 800, 0.0, 1).unwrap();

    // the integral of likelihood times prior, step 0.15 standard deviations
    let step = 0.15;
    let mut sum = 0.0;
    for i in -40..=40 {
        for j in -40..=40 {
            let z = [f64::from(i) * step, f64::from(j) * step];
            let Ok(residual) = model.residual(&z, &whitener) else { continue };
            let height: f64 = residual.iter().chain(&z).map(|v| v * v).sum::<f64>() - best.chi2;
            sum += (-0.5 * height).exp() * step * step / (2.0 * std::f64::consts::PI);
        }
    }
    let grid = sum.ln() - 0.5 * best.chi2;
    // 800 draws at this effective share: below 0.05
    assert!(found.effective_share > 0.4, "{}", found.effective_share);
    assert!((found.log_evidence - grid).abs() < 0.12, "{} {grid}", found.log_evidence);
    assert!((best.log_evidence - grid).abs() < 0.5, "Laplace is close here too: {} {grid}", best.log_evidence);
}
