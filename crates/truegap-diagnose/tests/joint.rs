//! Several recordings in one model: nothing crosses from one to another but parameters and physics.

#![allow(clippy::unwrap_used)]

mod common;

use common::{Plate, recording};
use truegap_core::{Inputs, Joined, Simulator, Stage};
use truegap_diagnose::joint::{Free, Member, Together};
use truegap_diagnose::{
    Context, Effect, FittedParameter, Problem,
    calibration::{InputError, Model, Noise, Whitener},
    library,
};

fn member<'a>(simulator: &'a Plate, specimen: usize, inputs: &'a Inputs, response: &'a [f64]) -> Member<'a> {
    Member { name: "r".into(), simulator, specimen, inputs, response }
}

/// The recording of all effects in two parts, parted between runs 4 and 5, each with a clock that starts at 0.
fn halves() -> [Inputs; 2] {
    let whole = recording();
    let border = whole.runs()[4].start;
    [0..border, border..whole.len()].map(|rows| {
        let mut part = whole.select(&rows.collect::<Vec<_>>());
        let start = part.time_s.as_ref().unwrap()[0];
        part.time_s.iter_mut().flatten().for_each(|t| *t -= start);
        part
    })
}

fn sizes(effect: &dyn Effect, context: &Context<'_>) -> Vec<f64> {
    let parameters = effect.parameters(context);
    parameters.iter().map(|p| p.prior.at(0.4).clamp(p.bounds.0, p.bounds.1)).collect()
}

#[test]
fn each_recording_is_simulated_as_if_it_were_alone_with_every_effect() {
    let plate = Plate::new(Some(false));
    let parts = halves();
    let none = parts.each_ref().map(|p| vec![0.0; p.len()]);
    let members = [member(&plate, 0, &parts[0], &none[0]), member(&plate, 0, &parts[1], &none[1])];
    let joint = Together::new(&members, &[], Free::default()).unwrap();
    let context = Context::new(&joint.inputs, &joint.model, 3.0, 0.01);
    let mut moved = 0;
    for effect in library().iter().filter(|e| e.testable(&context).is_ok() && e.id().0 != "offset_steps") {
        let stage = effect.with(&sizes(effect.as_ref(), &context), &context);
        let stages: [&dyn Stage; 1] = [stage.as_ref()];
        let together = joint.model.respond(&plate.centre(), &joint.inputs, &stages).unwrap();
        let alone = |(k, part): (usize, &Inputs)| {
            // what belongs to a recording has numbers of its own for each: the second part begins after four runs
            let own = stage.after_runs(4 * k);
            plate.respond(&plate.centre(), part, &[own.as_deref().unwrap_or(stage.as_ref())]).unwrap()
        };
        let alone: Vec<f64> = parts.iter().enumerate().flat_map(alone).collect();
        assert_eq!(together, alone, "{}", effect.id());
        moved += usize::from(together != joint.model.respond(&plate.centre(), &joint.inputs, &[]).unwrap());
    }
    assert!(moved > 12, "{moved} effects changed anything");
}

#[test]
fn derivatives_of_two_recordings_of_one_protocol_on_different_clocks_are_difference_quotients() {
    let plate = Plate::new(Some(false));
    let [first, _] = halves();
    let mut slower = first.clone();
    slower.time_s.iter_mut().flatten().for_each(|t| *t *= 20.0);
    let none = vec![0.0; first.len()];
    let members = [member(&plate, 0, &first, &none), member(&plate, 0, &slower, &none)];
    let joint = Together::new(&members, &[], Free::default()).unwrap();
    let context = Context::new(&joint.inputs, &joint.model, 3.0, 0.01);
    let response = vec![0.0; joint.inputs.len()];
    let problem = Problem { inputs: &joint.inputs, response: &response, simulator: &joint.model };
    let effects = library();
    let creep = effects.iter().find(|e| e.id().0 == "viscoelastic_creep").unwrap();
    let model = Model::new(&problem, &context, vec![creep.as_ref()]);
    let noise = Noise { white_sd: 1.0, ar_sd: 0.0, ar_correlation: 0.0 };
    let whitener = Whitener::new(&noise, &InputError::white(vec![0.0; response.len()]), None, &joint.inputs.runs(), None);
    let z: Vec<f64> = model.bounds().iter().map(|bound| 0.4_f64.clamp(bound.0, bound.1)).collect();
    let here = model.residual(&z, &whitener).unwrap();
    let jacobian = model.jacobian(&z, &here, &whitener).unwrap();
    for index in 0..z.len() {
        let at = |step: f64| {
            let moved: Vec<f64> = z.iter().enumerate().map(|(i, z)| if i == index { z + step } else { *z }).collect();
            model.residual(&moved, &whitener).unwrap()
        };
        let expected: Vec<f64> = at(-1e-4).iter().zip(at(1e-4)).map(|(less, more)| (less - more) / 2e-4).collect();
        let largest = expected.iter().fold(0.0, |m: f64, d| m.max(d.abs()));
        for (row, expected) in expected.iter().enumerate() {
            let found = jacobian[(row, index)];
            assert!((found - expected).abs() < 0.01 * largest, "{}, row {row}: {found} {expected}", model.parameters[index].name);
        }
    }
}

#[test]
fn steps_of_the_zero_are_counted_through_all_recordings() {
    let plate = Plate::new(Some(false));
    let (whole, parts) = (recording(), halves());
    let none = parts.each_ref().map(|p| vec![0.0; p.len()]);
    let members = [member(&plate, 0, &parts[0], &none[0]), member(&plate, 0, &parts[1], &none[1])];
    let joint = Together::new(&members, &[], Free::default()).unwrap();
    let effects = library();
    let steps = effects.iter().find(|e| e.id().0 == "offset_steps").unwrap();
    let context = Context::new(&joint.inputs, &joint.model, 3.0, 0.01);
    let values: Vec<f64> = (0..steps.parameters(&context).len()).map(|i| 0.1 + 0.3 * i as f64).collect();
    let stage = steps.with(&values, &context);
    let together = joint.model.respond(&plate.centre(), &joint.inputs, &[stage.as_ref()]).unwrap();
    // steps look at runs only, so one recording of all runs is a second way to the same numbers
    let as_one = plate.respond(&plate.centre(), &whole, &[stage.as_ref()]).unwrap();
    for (a, b) in together.iter().zip(&as_one) {
        approx::assert_abs_diff_eq!(a, b, epsilon = 1e-12);
    }
    assert!((together[0] - together[together.len() - 1]).abs() > 0.01);
}

#[test]
fn runs_are_numbered_on_and_a_recording_gets_back_the_columns_it_had() {
    let plate = Plate::new(Some(false));
    let [first, mut second] = halves();
    second.humidity_pct = None;
    let response = [vec![0.0; first.len()], vec![0.0; second.len()]];
    let members = [member(&plate, 0, &first, &response[0]), member(&plate, 0, &second, &response[1])];
    let joint = Together::new(&members, &[], Free::default()).unwrap();
    assert_eq!(joint.inputs.runs().len(), first.runs().len() + second.runs().len());
    let model: &dyn Joined = &joint.model;
    assert_eq!(model.rows(1, &joint.inputs), first.len()..first.len() + second.len());
    let back = model.inputs(1, &joint.inputs);
    assert_eq!((&back.time_s, &back.force_n, &back.humidity_pct), (&second.time_s, &second.force_n, &None));
    assert!(!model.has_own(0) && !model.has_own(1));
}

#[test]
fn another_specimen_has_its_own_geometry_and_the_same_material() {
    let plate = Plate::new(Some(false));
    let [first, second] = halves();
    let response = [vec![0.0; first.len()], vec![1.0; second.len()]];
    let members = [member(&plate, 0, &first, &response[0]), member(&plate, 1, &second, &response[1])];
    let free = Free { gain: true, offset: true };
    let joint = Together::new(&members, &["modulus"], free).unwrap();
    let names: Vec<&str> = joint.model.parameters().iter().map(|p| p.name.as_str()).collect();
    // this plate calls its own parameter gain, so that of the second recording has another name
    assert_eq!(names, ["gain", "modulus", "gain_2", "own_gain_2", "offset_2"]);
    assert_eq!(joint.sharing.shared, ["modulus"]);
    let values = [10.0, 6.0, 12.0, 1.1, 0.25];
    let together = joint.model.respond(&values, &joint.inputs, &[]).unwrap();
    let base = plate.respond(&[12.0, 6.0], &second, &[]).unwrap();
    let zero = 12.0 + 200.0; // what this plate tells its readout
    for (read, base) in together[first.len()..].iter().zip(&base) {
        approx::assert_relative_eq!(*read, zero + 1.1 * (base - zero) + 0.25, max_relative = 1e-12);
    }
    assert_eq!(together[..first.len()], plate.respond(&[10.0, 6.0], &first, &[]).unwrap());
}

/// Two recordings of which only the second has a late clock: the size that is fitted is of that recording alone.
#[test]
fn a_late_clock_belongs_to_its_recording() {
    let plate = Plate::new(Some(false));
    let parts = halves();
    let none = parts.each_ref().map(|p| vec![0.0; p.len()]);
    let members = [member(&plate, 0, &parts[0], &none[0]), member(&plate, 0, &parts[1], &none[1])];
    let joint = Together::new(&members, &[], Free::default()).unwrap();
    let context = Context::new(&joint.inputs, &joint.model, 3.0, 0.01);
    let effects = library();
    let of = |id: &str| effects.iter().find(|e| e.id().0 == id).unwrap();
    let names: Vec<String> = of("time_offset").parameters(&context).into_iter().map(|p| p.name).collect();
    assert_eq!(names, ["late", "late_1", "late_2"]);
    assert_eq!(of("clock_rate").parameters(&context).len(), 5);
    let stage = of("time_offset").with(&[0.4, 0.0, 1.5], &context);
    let together = joint.model.respond(&plate.centre(), &joint.inputs, &[stage.as_ref()]).unwrap();
    let alone = Context::new(&parts[1], &plate, 3.0, 0.01);
    let late = of("time_offset").with(&[0.6], &alone);
    let first = plate.respond(&plate.centre(), &parts[0], &[]).unwrap();
    let second = plate.respond(&plate.centre(), &parts[1], &[late.as_ref()]).unwrap();
    assert_eq!(together, [first, second].concat());
}

/// What a model file of several recordings holds of a clock: the numbers of the first one, under the names that it has alone, so that it simulates as that one did.
#[test]
fn the_first_recording_alone_has_its_own_clock() {
    let plate = Plate::new(Some(false));
    let parts = halves();
    let none = parts.each_ref().map(|p| vec![0.0; p.len()]);
    let members = [member(&plate, 0, &parts[0], &none[0]), member(&plate, 0, &parts[1], &none[1])];
    let joint = Together::new(&members, &[], Free::default()).unwrap();
    let context = Context::new(&joint.inputs, &joint.model, 3.0, 0.01);
    let alone = Context::new(&parts[0], &plate, 3.0, 0.01);
    let effects = library();
    let rate = effects.iter().find(|e| e.id().0 == "clock_rate").unwrap();
    assert!(rate.of_recorder() && !effects.iter().any(|e| e.id().0 == "thermal_lag" && e.of_recorder()));
    let values = [2e-3, 1.5, 40.0, -0.5, 70.0];
    let fitted = |(parameter, value): (truegap_core::Parameter, &f64)| FittedParameter {
        parameter,
        value: *value,
        sd: 0.0,
        sd_of_fit: 0.0,
        at_limit: false,
    };
    let all: Vec<FittedParameter> = rate.parameters(&context).into_iter().zip(&values).map(fitted).collect();
    let first = rate.of_first(all, &context);
    let names = |list: Vec<truegap_core::Parameter>| list.into_iter().map(|p| p.name).collect::<Vec<_>>();
    assert_eq!(names(first.iter().map(|f| f.parameter.clone()).collect()), names(rate.parameters(&alone)));
    let numbers: Vec<f64> = first.iter().map(|f| f.value).collect();
    let stage = rate.with(&numbers, &alone);
    let by_itself = plate.respond(&plate.centre(), &parts[0], &[stage.as_ref()]).unwrap();
    let stage = rate.with(&values, &context);
    let together = joint.model.respond(&plate.centre(), &joint.inputs, &[stage.as_ref()]).unwrap();
    assert_eq!(together[..parts[0].len()], by_itself);
}
