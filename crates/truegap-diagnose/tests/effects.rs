//! What every effect of the library must keep, whatever its equation.

#![allow(clippy::unwrap_used)]

mod common;

use common::{Plate, flat, recording};
use truegap_core::{Dielectric, Drive, FieldView, Inputs, Readout, Simulator, Stage, simulator::StageName};
use truegap_diagnose::{Context, Effect, Library, Problem, library};

/// Recording and base model that an effect can be tried on: minutes on the whole plate; without warp for what is the warp, without a dielectric for what
/// stands in for one; the same rows over days or years for what follows the sun.
fn tried_on(effect: &dyn Effect) -> (Inputs, Plate) {
    let plate = || Plate::new(Some(true));
    let without = || plate().without_dielectric();
    let (still, unwarped) = (without().that_stays(), Plate::new(Some(false)));
    let plates = [plate(), unwarped, without(), plate().without_beads(), plate().with_feedback(), still];
    let recordings = [recording(), over(4.0 * DAY_S), over(4.0 * 365.2425 * DAY_S), beside_a_simulation()];
    for inputs in recordings {
        let testable = |plate: &&Plate| effect.testable(&Context::new(&inputs, *plate, 2.0, 0.004)).is_ok();
        if let Some(at) = plates.iter().position(|plate| testable(&plate)) {
            return (inputs, plates.into_iter().nth(at).unwrap());
        }
    }
    panic!("{} is testable on no plate", effect.id())
}

const DAY_S: f64 = 86_400.0;

/// The recording with a simulation of its response, for what is wrong with a simulation.
fn beside_a_simulation() -> Inputs {
    Inputs { simulated: Some(respond(&Plate::new(Some(true)), &recording(), None)), ..recording() }
}

/// The recording with its clock stretched to this length, s.
fn over(duration_s: f64) -> Inputs {
    let inputs = recording();
    let clock = inputs.time_s.as_deref().unwrap();
    let last = clock.iter().copied().fold(f64::MIN, f64::max);
    let stretched = clock.iter().map(|t| (t - clock[0]) / (last - clock[0]) * duration_s).collect();
    Inputs { time_s: Some(stretched), ..inputs }
}

/// Parameters with the size at `deviations` of its prior, one list per starting point.
fn points(effect: &dyn Effect, context: &Context<'_>, deviations: f64) -> Vec<Vec<f64>> {
    let size = effect.parameters(context)[0].sd() * deviations;
    effect.starts(context).iter().map(|rest| std::iter::once(size).chain(rest.iter().copied()).collect()).collect()
}

fn respond(plate: &Plate, inputs: &Inputs, stage: Option<&dyn Stage>) -> Vec<f64> {
    let stages: Vec<&dyn Stage> = stage.into_iter().collect();
    plate.respond(&plate.centre(), inputs, &stages).unwrap()
}

/// Calls `check` with each effect, the recording's facts and its base model.
fn for_each(check: impl Fn(&dyn Effect, &Context<'_>, &Plate)) {
    for effect in library() {
        let (inputs, plate) = tried_on(effect.as_ref());
        check(effect.as_ref(), &Context::new(&inputs, &plate, 2.0, 0.004), &plate);
    }
}

#[test]
fn the_library_holds_every_id_of_the_contract_once() {
    let mut ids: Vec<&str> = library().iter().map(|effect| effect.id().0).collect();
    // 24 of the contract, three that finite elements have computed, the others from recordings of instruments that are no stack of plates
    assert_eq!(ids.len(), 51);
    ids.sort_unstable();
    ids.dedup();
    assert_eq!(ids.len(), 51);
    let foreseen: Vec<&str> = library().iter().filter(|e| e.foreseen()).map(|e| e.id().0).collect();
    assert_eq!(foreseen, ["bonded_layers", "held_warp", "rim_field"]);
    assert!(ids.contains(&"temperature_coefficient"));
    for effect in library() {
        for impostor in effect.about().impostors {
            assert!(ids.contains(impostor) && *impostor != effect.id().0, "{} names {impostor}", effect.id());
        }
        for rival in effect.separations().iter().map(|s| s.rival) {
            assert!(ids.contains(&rival) && rival != effect.id().0, "{} is told from {rival}", effect.id());
        }
    }
}

#[test]
fn every_effect_is_testable_where_everything_moves_and_none_where_nothing_was_recorded() {
    for_each(|effect, context, _| assert_eq!(effect.testable(context), Ok(()), "{}", effect.id()));
    let still = Inputs { run: vec![1; 5], force_n: Some(vec![0.0; 5]), ..Inputs::default() };
    for effect in library() {
        let (_, plate) = tried_on(effect.as_ref());
        let facts = Context::new(&still, &plate, 2.0, 0.004);
        // a constant beside the sensor needs no excitation, only a base model that does not hold it
        let expected = effect.id().0 == "parasitic_capacitance";
        assert_eq!(effect.testable(&facts).is_ok(), expected, "{}", effect.id());
    }
}

#[test]
fn a_bare_temperature_coefficient_is_only_tried_where_temperature_has_no_other_place() {
    let inputs = recording();
    let plate = Plate::new(Some(true));
    let facts = Context::new(&inputs, &plate, 2.0, 0.004);
    let effect = library().into_iter().find(|e| e.id().0 == "temperature_coefficient").unwrap();
    assert!(effect.testable(&facts).is_err());
}

#[test]
fn a_size_of_zero_is_the_identity_to_the_last_bit() {
    for_each(|effect, context, plate| {
        let without = respond(plate, context.inputs, None);
        for values in points(effect, context, 0.0) {
            let with = respond(plate, context.inputs, Some(effect.with(&values, context).as_ref()));
            assert_eq!(with, without, "{} at {values:?}", effect.id());
        }
    });
}

#[test]
fn any_other_size_changes_the_response_by_more_than_noise() {
    for_each(|effect, context, plate| {
        let without = respond(plate, context.inputs, None);
        for values in points(effect, context, 1.0) {
            let with = respond(plate, context.inputs, Some(effect.with(&values, context).as_ref()));
            let moved = with.iter().zip(&without).map(|(a, b)| (a - b).abs()).fold(0.0, f64::max);
            // one prior deviation has to be visible: the noise of a good instrument is 4 fF
            assert!(moved > 1e-3, "{} at {values:?} moves the reading by {moved} pF", effect.id());
        }
    });
}

#[test]
fn the_response_is_smooth_in_the_size_near_zero() {
    for_each(|effect, context, plate| {
        let without = respond(plate, context.inputs, None);
        let slope = |deviations: f64| {
            let values = &points(effect, context, deviations)[0];
            let with = respond(plate, context.inputs, Some(effect.with(values, context).as_ref()));
            with.iter().zip(&without).map(|(a, b)| (a - b) / deviations).collect::<Vec<f64>>()
        };
        let (near, nearer) = (slope(2e-3), slope(1e-3));
        let far = near.iter().zip(&nearer).map(|(a, b)| (a - b).powi(2)).sum::<f64>().sqrt();
        let size = nearer.iter().map(|a| a * a).sum::<f64>().sqrt();
        // a response of second order in the size would give 0.5 here, a kink 1
        let from_far = size == 0.0
            && !effect.far_sizes(context, &Problem { inputs: context.inputs, response: &without, simulator: plate }).is_empty();
        assert!(from_far || size > 0.0 && far < 0.02 * size, "{}: slopes differ by {far} of {size}", effect.id());
    });
}

/// Columns that the hooks of a stage are tried on.
struct Columns {
    inputs: Inputs,
    load: Vec<f64>,
    strain: Vec<f64>,
    value: Vec<f64>,
}

impl Columns {
    fn new(inputs: Inputs) -> Self {
        let load: Vec<f64> = inputs.force_n.iter().flatten().map(|f| f / 4.5).collect();
        let strain: Vec<f64> = load.iter().map(|l| l / 6.0).collect();
        let value = strain.iter().map(|e| 210.0 + 10.0 * e).collect();
        Self { inputs, load, strain, value }
    }

    /// The columns after each hook of `stage`, by stage of the chain.
    fn after(&self, stage: &dyn Stage) -> Vec<(StageName, Vec<f64>)> {
        let rows = self.load.len();
        let mut load = self.load.clone();
        stage.load(&self.inputs, &mut load);
        let temperature = self.inputs.temperature_c.clone().unwrap();
        let mut sensor = temperature.clone();
        stage.thermal(&self.inputs, &mut sensor);
        let drive =
            Drive { inputs: &self.inputs, load: &self.load, temperature_c: &temperature, reference_c: 20.0, full_load: 4.5 };
        let (mut modulus, mut strain) = (vec![1.0; rows], self.strain.clone());
        stage.modulus(&drive, &mut modulus);
        stage.strain(&drive, &mut strain);
        let mut geometry = flat(&self.strain, &temperature, 1.0);
        stage.geometry(&drive, &mut geometry);
        let mut factors = Dielectric { beads: vec![1.0; rows], insulator: vec![1.0; rows] };
        stage.dielectric(&drive, &mut factors);
        let (aspect, mut extra) = (vec![0.02; rows], vec![0.0; rows]);
        stage.field(&drive, &FieldView { aspect: &aspect, strain: &self.strain, plates: &self.value }, &mut extra);
        let mut fed_back = self.load.clone();
        stage.feedback(&drive, &self.value, &mut fed_back);
        let mut value = self.value.clone();
        stage.readout(&drive, &Readout { zero: 210.0, span: 5.0 / 3.0 }, &mut value);
        vec![
            (StageName::Inputs, vec![stage.late_s(0.0), stage.late_s(100.0)]),
            (StageName::LoadPath, load),
            (StageName::LoadPath, fed_back),
            (StageName::ThermalPath, sensor),
            (StageName::Beads, modulus),
            (StageName::Beads, strain),
            (StageName::Beads, stage.stiffening().to_vec()),
            (StageName::Geometry, geometry.gap),
            (StageName::Geometry, geometry.warp_kelvin),
            (StageName::Geometry, vec![geometry.warp_factor]),
            (StageName::Geometry, geometry.tilt),
            (StageName::Geometry, geometry.sag),
            (StageName::Dielectric, factors.beads),
            (StageName::Dielectric, factors.insulator),
            (StageName::Field, extra),
            (StageName::Readout, value),
        ]
    }
}

struct Nothing;
impl Stage for Nothing {}

#[test]
fn an_effect_acts_where_it_says_and_nowhere_else() {
    for_each(|effect, context, _| {
        let columns = Columns::new(context.inputs.clone());
        let untouched = columns.after(&Nothing);
        for values in points(effect, context, 1.0) {
            let after = columns.after(effect.with(&values, context).as_ref());
            let touched: Vec<StageName> = after.iter().zip(&untouched).filter(|(a, u)| a.1 != u.1).map(|(a, _)| a.0).collect();
            let place = effect.touches();
            assert!(!touched.is_empty() && touched.iter().all(|t| place.contains(t)), "{} touches {touched:?}", effect.id());
        }
    });
}

/// The recording with a row put in between any two of a run, at a third of the way, on straight lines.
fn divided(inputs: &Inputs) -> (Inputs, Vec<usize>) {
    let (mut rows, mut kept) = (vec![], vec![]);
    for row in 0..inputs.len() {
        kept.push(rows.len());
        rows.push((row, row));
        if row + 1 < inputs.len() && inputs.run[row + 1] == inputs.run[row] {
            rows.push((row, row + 1));
        }
    }
    let mix = |column: &Option<Vec<f64>>| {
        column.as_ref().map(|c| rows.iter().map(|&(a, b)| if a == b { c[a] } else { c[a] + (c[b] - c[a]) / 3.0 }).collect())
    };
    let finer = Inputs {
        time_s: mix(&inputs.time_s),
        run: rows.iter().map(|&(a, _)| inputs.run[a]).collect(),
        force_n: mix(&inputs.force_n),
        temperature_c: mix(&inputs.temperature_c),
        humidity_pct: mix(&inputs.humidity_pct),
        drivers: inputs.drivers_as(|c| mix(&Some(c.to_vec())).unwrap_or_default()),
        ..Inputs::default()
    };
    (finer, kept)
}

#[test]
fn memory_does_not_depend_on_how_finely_time_is_divided() {
    for_each(|effect, context, _| {
        let coarse = Columns::new(context.inputs.clone());
        let (finer, kept) = divided(&coarse.inputs);
        let fine = Columns::new(finer);
        // what counts rows belongs to the steps of a simulator, which takes one a row
        let rows: Vec<usize> =
            effect.parameters(context).iter().enumerate().filter(|(_, p)| p.unit == "rows").map(|(k, _)| k).collect();
        // a speed where the driver turns is what two rows say of it
        let by_speed = effect.parameters(context).iter().position(|p| p.name == "by_speed");
        for mut values in points(effect, context, 1.0) {
            rows.iter().chain(&by_speed).for_each(|k| values[*k] = 0.0);
            let stage = effect.with(&values, context);
            for ((_, a), (_, b)) in coarse.after(stage.as_ref()).iter().zip(fine.after(stage.as_ref())) {
                if a.len() < kept.len() {
                    continue;
                }
                let worst = kept.iter().zip(a).map(|(&row, a)| (b[row] - a).abs()).fold(0.0, f64::max);
                // recursions that are exact for straight lines: rounding of 2000 steps on readings of 200
                assert!(worst < 1e-10, "{} at {values:?} differs by {worst}", effect.id());
            }
        }
    });
}

/// Cosine of the angle between two changes of the reading.
fn cosine(a: &[f64], b: &[f64]) -> f64 {
    let dot = |x: &[f64], y: &[f64]| x.iter().zip(y).map(|(x, y)| x * y).sum::<f64>();
    dot(a, b) / (dot(a, a) * dot(b, b)).sqrt()
}

/// The same physics by another equation, which every effect of the library has.
fn sibling(effect: &dyn Effect, values: &[f64], context: &Context<'_>) -> Box<dyn Stage> {
    effect.sibling(values, context).unwrap_or_else(|| panic!("{} has no sibling: write one in its file", effect.id()))
}

/// Cosine between what the sibling changes and the nearest of a coarse search over the effect's numbers behind the size.
fn likeness(effect: &dyn Effect, context: &Context<'_>, values: &[f64], change: &dyn Fn(&dyn Stage) -> Vec<f64>) -> f64 {
    let sibling = change(sibling(effect, values, context).as_ref());
    [0.4, 0.6, 0.8, 1.0, 1.25, 1.6, 2.5]
        .iter()
        .map(|scale| values.iter().enumerate().map(|(k, v)| if k == 0 { *v } else { v * scale }).collect::<Vec<f64>>())
        .map(|values| cosine(&change(effect.with(&values, context).as_ref()), &sibling))
        .fold(f64::NEG_INFINITY, f64::max)
}

#[test]
fn a_sibling_differs_from_its_effect_and_yet_resembles_it() {
    let strange = std::cell::RefCell::new(Vec::new());
    for_each(|effect, context, plate| {
        let without = respond(plate, context.inputs, None);
        let change = |stage: &dyn Stage| -> Vec<f64> {
            respond(plate, context.inputs, Some(stage)).iter().zip(&without).map(|(a, b)| a - b).collect()
        };
        let largest = |column: &[f64]| column.iter().fold(0.0_f64, |most, c| most.max(c.abs()));
        for values in points(effect, context, 1.0) {
            let alike = likeness(effect, context, &values, &change);
            let same = change(effect.with(&values, context).as_ref());
            let other = change(sibling(effect, &values, context).as_ref());
            let apart: Vec<f64> = same.iter().zip(&other).map(|(a, b)| a - b).collect();
            // below 0.9 it would be another effect; within a thousandth it would be no other equation
            if alike < 0.9 || largest(&apart) < 1e-3 * largest(&same) {
                strange.borrow_mut().push((effect.id(), values, alike, largest(&apart) / largest(&same)));
            }
        }
        let none = points(effect, context, 0.0).swap_remove(0);
        let moved = largest(&change(sibling(effect, &none, context).as_ref()));
        assert!(moved < 1e-12, "the sibling of {} without size moves the reading by {moved}", effect.id());
    });
    assert!(strange.borrow().is_empty(), "{:#?}", strange.borrow());
}

#[test]
fn a_reader_is_told_the_numbers() {
    for_each(|effect, context, _| {
        let values = &points(effect, context, 1.0)[0];
        let fitted: Vec<_> = effect
            .parameters(context)
            .into_iter()
            .zip(values)
            .map(|(parameter, &value)| truegap_diagnose::FittedParameter {
                sd: parameter.sd(),
                sd_of_fit: parameter.sd(),
                parameter,
                value,
                at_limit: false,
            })
            .collect();
        let says = effect.says(&fitted);
        assert!(says.contains("sd") && says.chars().any(|c| c.is_ascii_digit()) && !says.contains("NaN"), "{says}");
    });
}

#[test]
fn starting_points_fit_the_parameters_and_their_bounds() {
    for_each(|effect, context, _| {
        let parameters = effect.parameters(context);
        let centre = if effect.foreseen() { 1.0 } else { 0.0 };
        assert!(parameters[0].centre() == centre && parameters[0].sd() > 0.0, "{}", effect.id());
        let starts = effect.starts(context);
        // each costs one simulation; a time at which something happened needs many
        assert!(!starts.is_empty() && starts.len() <= 32);
        for start in starts {
            assert_eq!(start.len() + 1, parameters.len(), "{}", effect.id());
            for (p, v) in parameters[1..].iter().zip(&start) {
                assert!(p.bounds.0 <= *v && *v <= p.bounds.1, "{}: {} = {v}", effect.id(), p.name);
            }
        }
    });
}

#[test]
fn the_page_of_effects_is_up_to_date() {
    let path = concat!(env!("CARGO_MANIFEST_DIR"), "/../../docs/effects.md");
    let page = std::fs::read_to_string(path).unwrap_or_default();
    assert!(
        page == common::page::page(&Library::default()),
        "write it again: cargo run -p truegap-diagnose --example effects > docs/effects.md"
    );
}

/// A number that is fitted on some rows must mean the same on others: what an effect makes of a run does not depend on runs that come after it.
#[test]
fn runs_that_come_later_change_nothing_of_those_before() {
    for_each(|effect, context, plate| {
        let runs = context.inputs.runs();
        for values in points(effect, context, 1.0) {
            let stage = effect.with(&values, context);
            // a clock that is shifted looks at rows that are recorded later
            if stage.late_s(context.duration_s) != 0.0 || stage.late_s(0.0) != 0.0 {
                continue;
            }
            let whole = respond(plate, context.inputs, Some(stage.as_ref()));
            for run in &runs[..runs.len() - 1] {
                let rows: Vec<usize> = (0..run.end).collect();
                let part = respond(plate, &context.inputs.select(&rows), Some(stage.as_ref()));
                for (row, (a, b)) in part.iter().zip(&whole).enumerate() {
                    // the same sums in the same order: rounding of one addition
                    assert!(
                        (a - b).abs() <= 1e-12 * b.abs(),
                        "{}: row {row} of {}: {a} alone, {b} before others",
                        effect.id(),
                        run.end
                    );
                }
            }
        }
    });
}
