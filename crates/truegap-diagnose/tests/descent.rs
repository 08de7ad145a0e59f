//! Fits reach the end of a sloppy direction that is curved.

#![allow(clippy::unwrap_used)]

use truegap_core::{Inputs, Parameter, Role, SimulationError, Simulator, Stage, simulator::StageName};
use truegap_diagnose::{
    Context, Problem,
    calibration::{FitOptions, InputError, Model, Noise, Whitener, fit},
};

/// Rows that all say `a - b^2 / 3`, with noise a thousandth of what they say per unit: the sloppy direction is a parabola, and only what is known of
/// `a` and `b` beforehand says where on it.
struct Parabola(Vec<Parameter>);

impl Parabola {
    fn new() -> Self {
        let parameter = |name: &str| Parameter::normal(name, "1", 0.0, 1.0, "a coordinate");
        Self(vec![parameter("a"), parameter("b")])
    }
}

impl Simulator for Parabola {
    fn name(&self) -> &str {
        "parabola"
    }
    fn unit(&self) -> &str {
        "1"
    }
    fn parameters(&self) -> &[Parameter] {
        &self.0
    }
    fn needs(&self) -> &[Role] {
        &[]
    }
    fn lacks(&self, _: StageName) -> Option<&'static str> {
        Some("a parabola has no stages")
    }
    fn full_load(&self) -> Option<f64> {
        None
    }
    fn load(&self, _: &Inputs) -> Option<Vec<f64>> {
        None
    }
    fn respond(&self, values: &[f64], inputs: &Inputs, _: &[&dyn Stage]) -> Result<Vec<f64>, SimulationError> {
        Ok(vec![values[0] - values[1] * values[1] / 3.0; inputs.len()])
    }
}

#[test]
fn a_fit_follows_a_curved_sloppy_direction_to_its_end() {
    let (parabola, rows) = (Parabola::new(), 100);
    let inputs = Inputs { run: vec![1; rows], ..Inputs::default() };
    let response = vec![0.0; rows];
    let problem = Problem { inputs: &inputs, response: &response, simulator: &parabola };
    let context = Context::new(&inputs, &parabola, 1.0, 1e-3);
    let model = Model::new(&problem, &context, Vec::new());
    let noise = Noise { white_sd: 1e-3, ar_sd: 0.0, ar_correlation: 0.0 };
    let whitener = Whitener::new(&noise, &InputError::white(vec![0.0; rows]), None, &inputs.runs(), None);
    // on the parabola, four standard deviations along it: 1e8 units of curvature across it, 1 along it
    for b in [4.0, -2.0, 0.7] {
        let found = fit(&model, &whitener, &[b * b / 3.0, b], &FitOptions::default()).unwrap();
        // the lowest point is 0, 0 by the symmetry of the problem
        assert!(
            found.converged && found.objective() < 0.05,
            "from b = {b}: {} after {} steps",
            found.objective(),
            found.iterations
        );
    }
}
