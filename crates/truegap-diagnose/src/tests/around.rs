//! What several fits share is what each would have computed by itself.

use crate::{
    Context, Problem,
    calibration::{FitOptions, InputError, Model, Noise, Whitener, fit},
    common::{Plate, recording},
    fit::{maximum_a_posteriori::fit_around, optimum::gram},
};
use truegap_core::Simulator;

#[test]
fn a_fit_from_shared_derivatives_is_the_fit_from_its_own_to_the_last_bit() {
    let (plate, inputs) = (Plate::new(Some(true)), recording());
    let mut response = plate.respond(&[11.0, 4.0], &inputs, &[]).unwrap();
    response.iter_mut().enumerate().for_each(|(i, r)| *r += 0.3 * (1.3 * i as f64).sin());
    let problem = Problem { inputs: &inputs, response: &response, simulator: &plate };
    let context = Context::new(&inputs, &plate, 2.0, 60.0);
    let model = Model::new(&problem, &context, Vec::new());
    let start = [0.4, -0.3];
    let around = model.around(&start).unwrap();
    let rows = response.len();
    for left_out in [0..0, 0..rows / 3, rows / 2..rows] {
        let keep: Vec<bool> = (0..rows).map(|row| !left_out.contains(&row)).collect();
        let noise = Noise { white_sd: 0.3, ar_sd: 0.1, ar_correlation: 0.5 };
        let whitener = Whitener::new(&noise, &InputError::white(vec![0.0; rows]), None, &inputs.runs(), Some(&keep));
        let (residual, jacobian) = around.whitened(&whitener);
        assert_eq!(residual, model.residual(&start, &whitener).unwrap());
        assert_eq!(jacobian, model.jacobian(&start, &residual, &whitener).unwrap());
        assert_eq!(gram(&jacobian), jacobian.tr_mul(&jacobian));
        let shared = fit_around(&model, &whitener, &around, &FitOptions::default()).unwrap();
        let alone = fit(&model, &whitener, &start, &FitOptions::default()).unwrap();
        assert_eq!((shared.z, shared.log_evidence), (alone.z, alone.log_evidence));
    }
}
