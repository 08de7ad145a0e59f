//! The name under which a finished bank is kept: a hash of everything that its answers depend on.
//!
//! Limits: a base model is known by its answers at the centre of the priors and one standard deviation along each number. A change that shows at none of these points is not seen.

use crate::{selection::candidates::Search, whitening::noise_model::NoiseModel};
use sha2::{Digest, Sha256};
use truegap_core::{Inputs, Simulator};

/// Version of the rules by which a diagnosis answers; part of the key, raised where an answer may change.
const RULES: u32 = 3;

/// Hash of protocol, priors, base model, noise, library and rules.
pub(crate) fn key(search: &Search<'_>, inputs: &Inputs, noise: &NoiseModel, likely: &[usize]) -> String {
    let simulator = search.problem.simulator;
    let mut hash = Sha256::new();
    protocol(&mut hash, inputs);
    noises(&mut hash, noise);
    base(&mut hash, simulator, inputs);
    for effect in &search.library {
        hash.update(effect.id().to_string());
        hash.update(format!("{:?}", effect.parameters(search.context)));
    }
    hash.update(format!("{:?}", search.context.held));
    hash.update(format!("{} {RULES} {likely:?} {}", env!("CARGO_PKG_VERSION"), simulator.name()));
    hash.finalize().iter().map(|byte| format!("{byte:02x}")).collect()
}

fn column(hash: &mut Sha256, name: &str, values: &[f64]) {
    hash.update(name.as_bytes());
    values.iter().for_each(|v| hash.update(v.to_le_bytes()));
}

fn protocol(hash: &mut Sha256, inputs: &Inputs) {
    let columns = [
        ("time", &inputs.time_s),
        ("force", &inputs.force_n),
        ("pressure", &inputs.pressure_pa),
        ("gap", &inputs.gap_m),
        ("temperature", &inputs.temperature_c),
        ("humidity", &inputs.humidity_pct),
        ("simulated", &inputs.simulated),
    ];
    columns.iter().for_each(|(name, values)| column(hash, name, values.as_deref().unwrap_or_default()));
    inputs.drivers.iter().for_each(|driver| column(hash, &driver.name, &driver.values));
    inputs.run.iter().for_each(|run| hash.update(run.to_le_bytes()));
}

fn noises(hash: &mut Sha256, noise: &NoiseModel) {
    column(hash, "noise", &[noise.response.white_sd, noise.response.ar_sd, noise.response.ar_correlation]);
    for each in &noise.recordings {
        column(hash, "its noise", &[each.response.white_sd, each.response.ar_sd, each.response.ar_correlation]);
    }
    column(hash, "step", &[noise.step]);
    column(hash, "weights", noise.weights.as_deref().unwrap_or_default());
    column(hash, "input", &noise.input_error.variance);
    column(hash, "level", &noise.input_error.level);
    noise.input_error.shapes.iter().for_each(|shape| column(hash, "shape", shape));
    for lasting in &noise.input_error.lasting {
        column(hash, "lasting", &lasting.variance);
        column(hash, "memory", &lasting.memory);
    }
    column(hash, "louder", &noise.input_error.louder);
}

/// What is known of the base model, and its answers: two programs or tables have the same name and may have the same numbers.
fn base(hash: &mut Sha256, simulator: &dyn Simulator, inputs: &Inputs) {
    let parameters = simulator.parameters();
    hash.update(format!("{parameters:?} {:?} {:?}", simulator.corrections(), simulator.full_load()));
    column(hash, "reference", &[simulator.reference_c()]);
    let centre = simulator.centre();
    let beside = |k: usize| {
        let mut values = centre.clone();
        values[k] = parameters[k].prior.at(1.0).max(parameters[k].bounds.0).min(parameters[k].bounds.1);
        values
    };
    for values in std::iter::once(centre.clone()).chain((0..parameters.len()).map(beside)) {
        match simulator.respond(&values, inputs, &[]) {
            Ok(response) => column(hash, "answer", &response),
            Err(error) => hash.update(error.to_string()),
        }
    }
}
