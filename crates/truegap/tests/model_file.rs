//! A model file says the same as the parts it was made of, and what is wrong with it is named.

#![allow(clippy::unwrap_used)]

use std::path::Path;
use truegap::core::{Inputs, Simulator, sensor::builtin_sensors};
use truegap::diagnose::answer::{AddedEffect, NamedValue, Scales};
use truegap::diagnose::{Context, Effect, library};
use truegap::model::{BaseModel, SeriesOrder, Stack, StackOptions};
use truegap::model_file::{ModelFile, ModelFileError, SCHEMA};

const EFFECTS: [&str; 2] = ["thermal_lag", "viscoelastic_creep"];

/// Half a prior standard deviation off the centre, so that nothing is zero.
fn effect_values(effect: &dyn Effect, context: &Context<'_>) -> Vec<f64> {
    effect.parameters(context).iter().map(|p| p.prior.at(0.5)).collect()
}

fn inputs(rows: usize) -> Inputs {
    let at = |row: usize| row as f64 / 30.0;
    Inputs {
        time_s: Some((0..rows).map(|row| row as f64 * 2.0).collect()),
        run: vec![1; rows],
        force_n: Some((0..rows).map(|row| 2.0 * (1.0 - at(row).cos())).collect()),
        temperature_c: Some((0..rows).map(|row| 25.0 + 10.0 * (0.5 * at(row)).sin()).collect()),
        ..Inputs::default()
    }
}

fn named(name: &str, unit: &str, value: f64) -> NamedValue {
    NamedValue { name: name.into(), unit: unit.into(), value, sd: 0.01 * value.abs() }
}

fn stack() -> Stack {
    let sensor = builtin_sensors()[0].sensor().unwrap();
    Stack::new(&sensor, StackOptions { warp: true, series: SeriesOrder::default() })
}

/// Half a prior standard deviation off its centre, so that a file which loses the calibration is found out.
fn values() -> Vec<f64> {
    stack().parameters().iter().map(|p| p.prior.at(0.5)).collect()
}

fn file() -> ModelFile {
    let base = stack();
    let whole = inputs(600);
    let context = Context::new(&whole, &base, 1.0, 0.001);
    let effects = library();
    let added = |id: &&str| {
        let effect = effects.iter().find(|e| e.id().0 == *id).unwrap();
        let (parameters, values) = (effect.parameters(&context), effect_values(effect.as_ref(), &context));
        AddedEffect {
            id: (*id).into(),
            parameters: parameters.iter().zip(values).map(|(p, v)| named(&p.name, &p.unit, v)).collect(),
            mechanism: None,
        }
    };
    ModelFile {
        schema: SCHEMA.into(),
        made_by: "truegap".into(),
        recording: "a.csv".into(),
        sha256: "ab".repeat(32),
        verdict: "explained".into(),
        unit: base.unit().into(),
        sensor: Some(builtin_sensors()[0].toml.into()),
        base: BaseModel::Stack { sensor: builtin_sensors()[0].name.into(), warp: true, series: SeriesOrder::default() },
        scales: Scales {
            runs: None,
            longest_run_s: context.longest_run_s,
            shortest_step_s: 2.0,
            duration_s: context.duration_s,
            response_span: 1.0,
            noise_sd: 0.001,
        },
        parameters: base.parameters().iter().zip(values()).map(|(p, v)| named(&p.name, &p.unit, v)).collect(),
        base_alone: Vec::new(),
        effects: EFFECTS.iter().map(added).collect(),
    }
}

fn read(text: &str) -> Result<ModelFile, ModelFileError> {
    ModelFile::parse(text, Path::new("augmented.toml"))
}

#[test]
fn a_file_that_is_written_and_read_simulates_what_its_parts_do() {
    let written = file();
    let again = read(&written.to_toml().unwrap()).unwrap();
    assert_eq!(again, written);
    // the other route: base model and stages put together by hand, without file or RunningModel
    let (base, inputs) = (stack(), inputs(600));
    let context = Context::new(&inputs, &base, 1.0, 0.001);
    let stages: Vec<_> = library()
        .iter()
        .filter(|e| EFFECTS.contains(&e.id().0))
        .map(|e| e.with(&effect_values(e.as_ref(), &context), &context))
        .collect();
    let by_hand = base.respond(&values(), &inputs, &stages.iter().map(AsRef::as_ref).collect::<Vec<_>>()).unwrap();
    let by_file = again.build().unwrap().respond(&inputs).unwrap();
    let plain = base.respond(&values(), &inputs, &[]).unwrap();
    // numbers in TOML are read back bit by bit, so nothing but the order of the two stages may differ
    by_file.iter().zip(&by_hand).for_each(|(a, b)| approx::assert_relative_eq!(a, b, max_relative = 1e-13));
    let moved = by_file.iter().zip(&plain).fold(0.0, |m: f64, (a, b)| m.max((a - b).abs()));
    assert!(moved > 1e-3, "the added physics moves the reading by {moved} pF only");
}

#[test]
fn a_model_means_the_same_on_a_shorter_history() {
    let model = file().build().unwrap();
    let whole = model.respond(&inputs(600)).unwrap();
    let part = model.respond(&inputs(150)).unwrap();
    part.iter().zip(&whole).for_each(|(a, b)| approx::assert_relative_eq!(a, b, max_relative = 1e-13));
}

#[test]
fn what_does_not_fit_together_is_named() {
    let changed = |change: &dyn Fn(&mut ModelFile)| {
        let mut file = file();
        change(&mut file);
        match read(&file.to_toml().unwrap()).and_then(|f| f.build()) {
            Ok(_) => panic!("was taken"),
            Err(error) => error.to_string(),
        }
    };
    assert!(changed(&|f| f.schema = "truegap.model/9".into()).contains("truegap.model/9"));
    assert!(changed(&|f| f.effects[0].id = "phlogiston".into()).contains("phlogiston"));
    assert!(changed(&|f| f.effects[1].parameters.clear()).contains("viscoelastic_creep"));
    let name = file().parameters[0].name.clone();
    assert!(changed(&|f| drop(f.parameters.remove(0))).contains(&name));
    assert!(changed(&|f| f.parameters.push(named("mass", "kg", 1.0))).contains("mass"));
    assert!(changed(&|f| f.sensor = None).contains("sensor"));
    assert!(read("schema = 1").is_err() && read("").is_err());
}
