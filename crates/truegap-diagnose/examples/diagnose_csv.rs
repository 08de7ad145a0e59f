//! From a CSV to a verdict, with a simulator of your own: `cargo run -p truegap-diagnose --example diagnose_csv [YOURS.csv]`.
//!
//! `force_gauge.csv` was made by other means than the library: voltage = 0.12 mV + 0.4031 mV/N · force behind a first-order lag of 4 s (solved exactly
//! between rows), with noise of 0.01 mV on the voltage and 0.002 N on the force. The simulator, a strain gauge whose voltage is a straight line over the
//! force, knows nothing of a lag. An `Instrument` is a `Simulator` that is an equation of the load; the front page of `truegap_diagnose` writes one out.

use std::error::Error;
use truegap_core::{Instrument, Parameter, Recording, Role};
use truegap_diagnose::{Diagnosis, Options, diagnose_recording};

/// What is missing in the simulator of a force gauge, judged by the recording in `file`.
pub fn diagnosed(file: &str) -> Result<Diagnosis, Box<dyn Error>> {
    let gauge = Instrument {
        name: "force-gauge",
        unit: "mV",
        load: Role::Force,
        full_load: 50.0,
        parameters: [
            Parameter::normal("zero", "mV", 0.0, 1.0, "voltage without load"),
            Parameter::normal("span", "mV", 20.0, 0.5, "voltage at 50 N beyond it, from the data sheet"),
        ],
        reading: |[zero, span], share| zero + span * share,
    };
    Ok(diagnose_recording(&Recording::open(file)?, &gauge, &Options::default())?.diagnosis)
}

fn main() -> Result<(), Box<dyn Error>> {
    let built_in = concat!(env!("CARGO_MANIFEST_DIR"), "/examples/force_gauge.csv");
    let diagnosis = diagnosed(&std::env::args().nth(1).unwrap_or_else(|| built_in.into()))?;
    println!("{}", diagnosis.says);
    diagnosis.findings.iter().for_each(|f| println!("{} (probability {:.2}): {}", f.effect, f.probability, f.says));
    println!("next: {}", diagnosis.next_experiment.says);
    Ok(())
}
