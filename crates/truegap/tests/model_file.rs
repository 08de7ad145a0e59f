//! A model file says the same as the parts it was made of, and what is wrong with it is named.

#![allow(clippy::unwrap_used)]

use std::path::Path;
use truegap::core::{Driver, Inputs, Parameter, Simulator, sensor::builtin_sensors};
use truegap::diagnose::answer::{AddedEffect, NamedValue, Scales};
use truegap::diagnose::{Context, Effect, library};
use truegap::model::{BaseModel, SeriesOrder, Stack, StackOptions};
use truegap::models::{MODEL_SCHEMA, ModelFile, ModelFileError};

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
            carried: false,
        }
    };
    ModelFile {
        schema: MODEL_SCHEMA.into(),
        made_by: "truegap".into(),
        recording: "a.csv".into(),
        sha256: "ab".repeat(32),
        readings_sha256: None,
        verdict: "explained".into(),
        unit: base.unit().into(),
        sensor: Some(builtin_sensors()[0].toml.into()),
        drivers: [("supply".into(), "mV".into())].into(),
        base: BaseModel::Stack { sensor: builtin_sensors()[0].name.into(), warp: true, series: SeriesOrder::default() },
        scales: Scales {
            runs: None,
            moved: None,
            longest_run_s: context.longest_run_s,
            shortest_step_s: 2.0,
            duration_s: context.duration_s,
            response_span: 1.0,
            noise_sd: 0.001,
        },
        parameters: base.parameters().iter().zip(values()).map(|(p, v)| named(&p.name, &p.unit, v)).collect(),
        base_alone: Vec::new(),
        effects: EFFECTS.iter().map(added).collect(),
        rivals: Vec::new(),
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
    let number = |of: usize, place: usize| file().effects[of].parameters[place].clone();
    let (tau, first) = (number(0, 1), number(1, 0));
    let lost = changed(&|f| drop(f.effects[0].parameters.remove(1)));
    assert!(lost.contains("`thermal_lag` gives no value for `") && lost.contains(&format!("name = \"{}\"", tau.name)), "{lost}");
    let renamed = changed(&|f| f.effects[0].parameters[1].name += "s");
    let parts = [format!("`{}s`, which is {}", tau.name, tau.value), format!("did you mean `{}`", tau.name)];
    assert!(renamed.contains("`thermal_lag` has no number") && parts.iter().all(|part| renamed.contains(part)), "{renamed}");
    let twice = changed(&|f| f.effects[1].parameters[1].name.clone_from(&first.name));
    assert!(twice.contains(&format!("viscoelastic_creep gives `{}` twice", first.name)), "{twice}");
    let more = changed(&|f| f.effects[1].parameters.push(named("mass", "kg", 1.0)));
    assert!(more.contains("no number `mass`, which is 1 there") && more.contains("known there: "), "{more}");
    assert!(changed(&|f| f.sensor = None).contains("sensor"));
    assert!(read("schema = 1").is_err() && read("").is_err());
}

/// A time constant of a minute was one of a second, and a mass was one as well.
#[test]
fn numbers_in_another_unit_are_converted_or_refused() {
    let (written, inputs) = (file(), inputs(600));
    let expected = written.build().unwrap().respond(&inputs).unwrap();
    let (tau, share) = (&written.effects[0].parameters[0], &written.parameters[0]);
    assert_eq!(tau.unit, "s");
    let mut minutes = written.clone();
    minutes.effects[0].parameters[0] =
        NamedValue { unit: "min".into(), value: tau.value / 60.0, sd: tau.sd / 60.0, ..tau.clone() };
    let by_file = minutes.build().unwrap().respond(&inputs).unwrap();
    by_file.iter().zip(&expected).for_each(|(a, b)| approx::assert_relative_eq!(a, b, max_relative = 1e-12));
    let refused = |change: &dyn Fn(&mut ModelFile)| {
        let mut file = written.clone();
        change(&mut file);
        file.build().err().expect("must be refused").to_string()
    };
    let mass = refused(&|file| file.effects[0].parameters[0].unit = "kg".into());
    let parts = ["`tau` of thermal_lag", &format!("{} in `kg`", tau.value), "its unit is `s`", "write unit = \"s\""];
    assert!(parts.iter().all(|part| mass.contains(part)), "{mass}");
    let base = refused(&|file| file.parameters[0].unit = "kg".into());
    assert!(base.contains(&format!("`{}` of the base model", share.name)) && base.contains("in `kg`"), "{base}");
}

/// Two numbers that stood in another order were taken one for the other, and the answer was wrong without a word.
#[test]
fn numbers_of_an_effect_are_known_by_their_names_in_whatever_order() {
    let (written, inputs) = (file(), inputs(600));
    let mut turned = written.clone();
    turned.effects.iter_mut().for_each(|effect| effect.parameters.reverse());
    assert!(turned.effects.iter().all(|effect| effect.parameters.len() > 1) && turned != written);
    assert_eq!(turned.build().unwrap().respond(&inputs).unwrap(), written.build().unwrap().respond(&inputs).unwrap());
}

/// A mechanism took any unknown name for its size, and did nothing where it had none.
#[test]
fn numbers_of_a_mechanism_are_known_by_their_names() {
    let words = "[[effect]]\nid = \"composed\"\nparameters = [{ name = \"tau\", unit = \"s\", value = 9.0, sd = 1.0 }, \
         { name = \"size\", unit = \"ppm/K\", value = 0.5, sd = 0.1 }]\n[effect.mechanism]\nquantity = \"reading\"\naction = \"adds\"\n\
         driver = \"temperature\"\nkinetics = \"first_order\"\nform = \"linear\"\n";
    let text = head(CONSTANT, "ppm", "level").to_toml().unwrap();
    let build = |from: &str, to: &str| read(&format!("{text}\n{}", words.replacen(from, to, 1))).unwrap().build();
    let plain = read(&text).unwrap().build().unwrap().respond(&room(60)).unwrap();
    assert_ne!(build("", "").unwrap().respond(&room(60)).unwrap(), plain);
    let refused = |from: &str, to: &str| build(from, to).err().unwrap().to_string();
    assert!(refused("\"tau\"", "\"tauu\"").contains("`composed` has no number `tauu`, which is 9 there"));
    assert!(refused("{ name = \"size\", unit = \"ppm/K\", value = 0.5, sd = 0.1 }", "").contains("gives no value for `size`"));
}

/// Heads of model files whose base models are no sensor stack.
const CONSTANT: &str = r#"model = "constant"
reference_c = 20.0
scale = { unit = "ppm", centre = 0.0, range = 7.0, at_rest = 0.0, span = 7.0, gaps_m = [0.0, 0.0], response_times_gap = 1.0 }"#;
const EXTERNAL: &str = r#"model = "external"
reference_c = 20.0
scale = { unit = "degC", centre = 25.0, range = 20.0, at_rest = 15.0, span = 20.0, gaps_m = [0.0, 0.0], response_times_gap = 1.0 }
options = { offset = true }"#;

/// A model file of this base, without effects.
fn head(base: &str, unit: &str, parameter: &str) -> ModelFile {
    let scales =
        "longest_run_s = 1198.0\nshortest_step_s = 2.0\nduration_s = 1198.0\nresponse_span = 7.0\nnoise_sd = 0.01\nruns = 1";
    let parameter = format!("name = \"{parameter}\"\nunit = \"{unit}\"\nvalue = 0.3\nsd = 0.1");
    read(&format!(
        "schema = \"{MODEL_SCHEMA}\"\nmade_by = \"test\"\nrecording = \"a\"\nsha256 = \"b\"\nverdict = \"explained\"\nunit = \"{unit}\"\neffect = []\n\
         [base]\n{base}\n[scales]\n{scales}\n[[parameter]]\n{parameter}\n[[base_alone]]\n{parameter}\n"
    ))
    .unwrap()
}

fn room(rows: usize) -> Inputs {
    Inputs { force_n: None, ..inputs(rows) }
}

fn with_driver(rows: usize) -> Inputs {
    let wave = |step: f64| (0..rows).map(|row| 5.0 * (row as f64 / step).sin()).collect();
    let driver = |name: &str, step| Driver { name: name.into(), unit: "mm".into(), values: wave(step) };
    // the first does not move, so the second is the one that is followed
    let still = Driver { name: "supply".into(), unit: "V".into(), values: vec![5.0; rows] };
    Inputs { temperature_c: None, drivers: vec![still, driver("position", 25.0)], ..room(rows) }
}

fn simulated(rows: usize) -> Inputs {
    let values = (0..rows).map(|row| 22.0 + 8.0 * (row as f64 / 60.0).sin()).collect();
    Inputs { simulated: Some(values), ..room(rows) }
}

/// Every effect that a recording can show is written, read again and means the same: on these inputs, and on others where other columns move.
#[test]
fn every_effect_is_read_again_as_it_was_written() {
    let cases: [(&str, &str, &str, Inputs); 3] = [
        (CONSTANT, "ppm", "level", room(600)),
        (CONSTANT, "ppm", "level", with_driver(600)),
        (EXTERNAL, "degC", "offset", simulated(600)),
    ];
    let mut seen = Vec::new();
    for (base, unit, parameter, inputs) in cases {
        let plain = head(base, unit, parameter);
        let empty = plain.build().unwrap();
        let context = Context::new(&inputs, empty.simulator(), 7.0, 0.01);
        for effect in library().iter().filter(|e| e.testable(&context).is_ok()) {
            let values = effect_values(effect.as_ref(), &context);
            let named = |(p, v): (&Parameter, &f64)| named(&p.name, &p.unit, *v);
            let added = AddedEffect {
                id: effect.id().to_string(),
                parameters: effect.parameters(&context).iter().zip(&values).map(named).collect(),
                mechanism: None,
                carried: false,
            };
            let scales = Scales { moved: Some(context.moved.clone()), ..plain.scales.clone() };
            let text = ModelFile { effects: vec![added], scales, ..plain.clone() }.to_toml().unwrap();
            let model = read(&text).unwrap().build().unwrap_or_else(|error| panic!("{error}"));
            let by_file = model.respond(&inputs).unwrap();
            let by_hand = empty.simulator().respond(&[0.3], &inputs, &[effect.with(&values, &context).as_ref()]).unwrap();
            assert_eq!(by_file, by_hand, "{} beside {base}", effect.id());
            seen.push(effect.id().to_string());
        }
    }
    for id in ["thermal_lag", "regime_change", "friction", "driver_coefficient"] {
        assert!(seen.iter().any(|s| s == id), "{id} was not among {seen:?}");
    }
}

/// A curve of before its richer law had numbers means what it meant.
#[test]
fn a_law_that_has_got_further_numbers_since_is_the_simple_one() {
    let (plain, inputs) = (head(EXTERNAL, "degC", "offset"), simulated(600));
    let empty = plain.build().unwrap();
    let context = Context::new(&inputs, empty.simulator(), 7.0, 0.01);
    let library = library();
    let curve = library.iter().find(|e| e.id().0 == "nonlinearity").unwrap();
    let values = [0.1, 0.4, 0.8, 0.6, -0.3, 0.2];
    let parameters = curve.parameters(&context);
    let added = AddedEffect {
        id: "nonlinearity".into(),
        parameters: parameters.iter().zip(values).map(|(p, v)| named(&p.name, &p.unit, v)).collect(),
        mechanism: None,
        carried: false,
    };
    let scales = Scales { moved: Some(context.moved.clone()), ..plain.scales.clone() };
    let model = ModelFile { effects: vec![added], scales, ..plain.clone() }.build().unwrap();
    let simple = curve.with(&[&values[..], &[0.0; 2]].concat(), &context);
    let by_hand = empty.simulator().respond(&[0.3], &inputs, &[simple.as_ref()]).unwrap();
    assert_eq!(model.respond(&inputs).unwrap(), by_hand);
}

/// So does a gain of before it was known where it is right: the file was refused for the number that it lacks.
#[test]
fn a_gain_that_has_got_a_neutral_temperature_since_is_right_at_the_reference() {
    let (plain, inputs) = (head(EXTERNAL, "degC", "offset"), simulated(600));
    let empty = plain.build().unwrap();
    let context = Context::new(&inputs, empty.simulator(), 7.0, 0.01);
    let library = library();
    let gain = library.iter().find(|e| e.id().0 == "gain_drift").unwrap();
    let own: Vec<String> = gain.parameters(&context).into_iter().map(|p| p.name).collect();
    assert_eq!(own, ["per_kelvin", "neutral"]);
    let added = AddedEffect {
        id: "gain_drift".into(),
        parameters: vec![named("per_kelvin", "1/K", 0.002)],
        mechanism: None,
        carried: false,
    };
    let scales = Scales { moved: Some(context.moved.clone()), ..plain.scales.clone() };
    let model = ModelFile { effects: vec![added], scales, ..plain.clone() }.build().unwrap();
    let by_hand = empty.simulator().respond(&[0.3], &inputs, &[gain.with(&[0.002, 0.0], &context).as_ref()]).unwrap();
    assert_eq!(model.respond(&inputs).unwrap(), by_hand);
}

/// A temperature that hardly moves in another recording does not turn a coefficient of temperature into one of something else.
#[test]
fn what_an_effect_follows_is_that_of_the_recording_it_was_fitted_to() {
    let plain = head(CONSTANT, "ppm", "level");
    let empty = plain.build().unwrap();
    let fitted_on = with_driver(600);
    let context = Context::new(&fitted_on, empty.simulator(), 7.0, 0.01);
    let library = library();
    let friction = library.iter().find(|e| e.id().0 == "friction").unwrap();
    let named = |(p, v): (&Parameter, f64)| named(&p.name, &p.unit, v);
    let values = effect_values(friction.as_ref(), &context);
    let added = AddedEffect {
        id: "friction".into(),
        parameters: friction.parameters(&context).iter().zip(values).map(named).collect(),
        mechanism: None,
        carried: false,
    };
    let scales = Scales { moved: Some(context.moved.clone()), ..plain.scales.clone() };
    let model = ModelFile { effects: vec![added], scales, ..plain.clone() }.build().unwrap();
    let here = model.respond(&fitted_on).unwrap();
    // elsewhere the supply moves as well, and the columns stand in another order
    let mut other = with_driver(600);
    other.drivers[0].values.iter_mut().enumerate().for_each(|(row, v)| *v += row as f64);
    assert_eq!(model.respond(&other).unwrap(), here);
    other.drivers.reverse();
    assert_eq!(model.respond(&other).unwrap(), here);
    other.drivers.retain(|driver| driver.name != "position");
    let error = model.respond(&other).unwrap_err().to_string();
    assert!(error.contains("friction") && error.contains("position") && error.contains("[drivers]"), "{error}");
}
