//! From a CSV to a verdict, with a simulator of your own: `cargo run -p truegap-diagnose --example diagnose_csv [YOURS.csv]`.
//!
//! `force_gauge.csv` was made by other means than the library: voltage = 0.12 mV + 0.4031 mV/N · force behind a first-order lag of 4 s (solved exactly
//! between rows), with noise of 0.01 mV on the voltage and 0.002 N on the force. The simulator knows nothing of a lag.

use std::{error::Error, sync::atomic::AtomicBool};
use truegap_core::{
    Inputs, Parameter, Readout, Recording, Role, SimulationError, Simulator, Stage, StageName, named_values, walk_without_plates,
};
use truegap_diagnose::{Diagnosis, Options, Problem, RecordingFacts, diagnose};

/// A strain gauge under a force of at most 50 N: its voltage should be a straight line over the force.
struct ForceGauge {
    parameters: [Parameter; 2],
}

impl Simulator for ForceGauge {
    fn name(&self) -> &str {
        "force-gauge"
    }
    fn unit(&self) -> &str {
        "mV"
    }
    fn parameters(&self) -> &[Parameter] {
        &self.parameters
    }
    fn needs(&self) -> &[Role] {
        &[Role::Force]
    }
    fn lacks(&self, stage: StageName) -> Option<&'static str> {
        let plates = [StageName::Beads, StageName::Geometry, StageName::Dielectric, StageName::Field];
        plates.contains(&stage).then_some("a force gauge has no plates")
    }
    fn full_load(&self) -> Option<f64> {
        Some(50.0)
    }
    fn respond(&self, values: &[f64], inputs: &Inputs, stages: &[&dyn Stage]) -> Result<Vec<f64>, SimulationError> {
        let [zero, span] = named_values(self, values)?;
        walk_without_plates(self, values, inputs, stages, |drive| {
            Ok((drive.load.iter().map(|share| zero + span * share).collect(), Readout { zero, span }))
        })
    }
}

/// What is missing in the simulator of a force gauge, judged by the recording in `file`.
pub fn diagnosed(file: &str) -> Result<Diagnosis, Box<dyn Error>> {
    let recording = Recording::open(file)?;
    let zero = Parameter::normal("zero", "mV", 0.0, 1.0, "voltage without load");
    let span = Parameter::normal("span", "mV", 20.0, 0.5, "voltage at 50 N beyond it, from the data sheet");
    let gauge = ForceGauge { parameters: [zero, span] };
    let problem = Problem { inputs: &recording.inputs, response: &recording.response, simulator: &gauge };
    let facts = RecordingFacts {
        rows: recording.len(),
        runs: recording.inputs.runs().len(),
        sha256: recording.sha256.clone(),
        source: file.into(),
        ..RecordingFacts::default()
    };
    Ok(diagnose(&problem, facts, &Options::default(), &|_| (), &AtomicBool::new(false))?.diagnosis)
}

fn main() -> Result<(), Box<dyn Error>> {
    let built_in = concat!(env!("CARGO_MANIFEST_DIR"), "/examples/force_gauge.csv");
    let diagnosis = diagnosed(&std::env::args().nth(1).unwrap_or_else(|| built_in.into()))?;
    println!("{}", diagnosis.says);
    for finding in &diagnosis.findings {
        println!("{} (probability {:.2}): {}", finding.effect, finding.probability, finding.says);
    }
    println!("next: {}", diagnosis.next_experiment.says);
    Ok(())
}
