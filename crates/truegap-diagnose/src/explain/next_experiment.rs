//! What to measure next: profiles and instrument changes, ranked by how well they separate what the recording has not excluded.
//!
//! Limits: separation is judged at the fitted numbers, with the rival's parameters free again within what is known by then.

use crate::{
    effects::effect::{Effect, Separation},
    explain::{
        play::{load_role, separation},
        tuning::{CERTAIN, REBUILD_H},
    },
    selection::candidates::{Search, Tried},
    text::{deviations, listed, significant, spoken},
};
use serde::Serialize;
use std::collections::BTreeSet;
use truegap_core::{Driver, Inputs, Role};

/// What to measure next.
#[derive(Clone, Debug, Default, Serialize)]
pub struct NextExperiment {
    /// sentence
    pub says: String,
    /// survivors that it tells apart
    pub separates: Vec<String>,
    /// ranked options
    pub options: Vec<ExperimentOption>,
}

/// One run or instrument change.
#[derive(Clone, Debug, Serialize)]
pub struct ExperimentOption {
    /// what to do
    pub says: String,
    /// standard deviations between the survivors after it; 0 where there is one survivor
    pub separation: f64,
    /// share of the error of the least sure number that it leaves, where there is one survivor
    #[serde(skip_serializing_if = "Option::is_none")]
    pub error_left: Option<f64>,
    /// hours that it takes
    pub hours: f64,
    /// built-in profile that `truegap simulate --profile` plays, where there is one
    pub profile: Option<String>,
}

/// Rows of a profile: (time s, load over full load, temperature degC, run).
pub type Points = Vec<(f64, f64, f64, u32)>;

/// A profile of load and temperature that a rig could play.
pub struct Profile {
    /// name, as `truegap simulate --profile` takes it
    pub name: &'static str,
    /// what to do
    pub says: &'static str,
    /// whether it moves the temperature
    heats: bool,
    /// whether it moves the load
    loads: bool,
    points: fn(f64) -> Points,
}

/// Profiles that are weighed.
pub const PROFILES: [Profile; 6] = [
    Profile {
        name: "long-hold",
        says: "hold half load for two hours, unload, watch the recovery for half an hour",
        heats: false,
        loads: true,
        points: long_hold,
    },
    Profile {
        name: "rates",
        says: "load and unload at rates a hundred apart (0.05 s to 5 min a ramp), five times each",
        heats: false,
        loads: true,
        points: rates,
    },
    Profile {
        name: "staircase",
        says: "staircase up and down with two-minute steps, then the same once more",
        heats: false,
        loads: true,
        points: staircase,
    },
    Profile {
        name: "thermal-sweep-unloaded",
        says: "heat from 20 to 50 °C and cool again without load, once in 10 min and once in 2 h",
        heats: true,
        loads: false,
        points: thermal_unloaded,
    },
    Profile {
        name: "thermal-sweep-loaded",
        says: "heat from 20 to 50 °C and cool again at full load, once in 10 min and once in 2 h",
        heats: true,
        loads: true,
        points: thermal_loaded,
    },
    Profile {
        name: "overnight",
        says: "leave the sensor alone for twelve hours, with one load cycle every hour",
        heats: false,
        loads: true,
        points: overnight,
    },
];

/// The inputs of a profile, for a load of `full` in SI that goes to the `role` column.
pub fn inputs(profile: &Profile, full: f64, role: Role, start_c: f64) -> Inputs {
    let points = (profile.points)(start_c);
    let load: Vec<f64> = points.iter().map(|p| p.1 * full).collect();
    let mut inputs = Inputs {
        time_s: Some(points.iter().map(|p| p.0).collect()),
        run: points.iter().map(|p| p.3).collect(),
        temperature_c: Some(points.iter().map(|p| p.2).collect()),
        ..Inputs::default()
    };
    if let Some(column) = inputs.column_mut(role) {
        *column = Some(load);
    }
    inputs
}

fn long_hold(t: f64) -> Points {
    let hold = (0..1440).map(move |i| (5.0 * f64::from(i), if i < 4 { 0.0 } else { 0.5 }, t, 1));
    hold.chain((0..360).map(move |i| (7200.0 + 5.0 * f64::from(i), 0.0, t, 1))).collect()
}

fn rates(t: f64) -> Points {
    let mut points = Vec::new();
    let mut clock = 0.0;
    for (run, half) in [0.05, 0.5, 5.0, 60.0, 300.0].into_iter().enumerate() {
        for cycle in 0..5 {
            for i in 0..40 {
                let phase = f64::from(i) / 20.0;
                let load = if phase < 1.0 { phase } else { 2.0 - phase };
                points.push((clock + half * (2.0 * f64::from(cycle) + phase), load, t, run as u32 + 1));
            }
        }
        clock += 10.0 * half + 600.0;
    }
    points
}

fn staircase(t: f64) -> Points {
    let level = |step: i32| f64::from(if step <= 8 { step } else { 16 - step }) / 8.0;
    let run = move |number: u32| {
        (0..17 * 60).map(move |i| (2.0 * f64::from(i) + 3600.0 * f64::from(number - 1), level(i / 60), t, number))
    };
    run(1).chain(run(2)).collect()
}

fn thermal(load: f64) -> Points {
    let sweep = |start: f64, half: f64, run: u32| {
        (0..400).map(move |i| {
            let phase = f64::from(i) / 200.0;
            let warm = if phase < 1.0 { phase } else { 2.0 - phase };
            (start + half * phase, load, 20.0 + 30.0 * warm, run)
        })
    };
    sweep(0.0, 600.0, 1).chain(sweep(3000.0, 7200.0, 2)).collect()
}

fn thermal_unloaded(_: f64) -> Points {
    thermal(0.0)
}

fn thermal_loaded(_: f64) -> Points {
    thermal(1.0)
}

fn overnight(t: f64) -> Points {
    (0..12 * 120).map(|i| (30.0 * f64::from(i), if i % 120 < 4 { 1.0 } else { 0.0 }, t, 1)).collect()
}

/// Standard deviations beyond which more of them are worth no more.
const ENOUGH: f64 = 30.0;
/// Standard deviations below which two models are not told apart.
const TOLD: f64 = 3.0;

/// The built-in profiles that this base model could answer to, each with what it would do.
pub(crate) fn playable(search: &Search<'_>) -> Vec<(ExperimentOption, Inputs)> {
    let simulator = search.problem.simulator;
    let thermometer = search.context.temperature_range.is_some();
    let possible = |p: &&Profile| (thermometer || !p.heats) && (simulator.full_load().is_some() || !p.loads);
    PROFILES.iter().filter(possible).map(|profile| (option(search, profile), played(search, profile))).collect()
}

/// Ends of the sweeps of temperature as they are listed, degrees Celsius.
const SWEPT: (f64, f64) = (20.0, 50.0);

/// Ends of a sweep of temperature that this rig can play: those that it played, in whole degrees; as listed where a sensor is described that such a sweep is made for.
fn swept(search: &Search<'_>) -> (f64, f64) {
    let recorded = search.context.temperature_range.filter(|_| !search.problem.simulator.knows_its_level());
    recorded.map_or(SWEPT, |(low, high)| (low.floor(), high.ceil()))
}

fn option(search: &Search<'_>, profile: &Profile) -> ExperimentOption {
    let (first, last) = ends(profile);
    let (low, high) = swept(search);
    let says = profile.says.replace("20 to 50 °C", &format!("{low} to {high} °C"));
    let loaded = search.problem.simulator.full_load().is_some();
    ExperimentOption {
        says: if loaded { says } else { says.replace(" without load", "") },
        separation: 0.0,
        error_left: None,
        hours: (last - first) / 3600.0,
        profile: Some(profile.name.into()),
    }
}

/// The inputs of a profile for this base model.
fn played(search: &Search<'_>, profile: &Profile) -> Inputs {
    let simulator = search.problem.simulator;
    let full = simulator.full_load().unwrap_or(0.0);
    let mut inputs = inputs(profile, full, load_role(search), search.context.reference_c);
    if profile.heats {
        let (low, high) = swept(search);
        let share = |t: f64| (t - SWEPT.0) / (SWEPT.1 - SWEPT.0);
        inputs.temperature_c.iter_mut().flatten().for_each(|t| *t = low + share(*t) * (high - low));
    }
    // what else was recorded stays as it was on average: a simulator may need it
    inputs.drivers = search.problem.inputs.drivers.iter().map(|driver| held(driver, inputs.len())).collect();
    if simulator.joined().is_some() {
        // runs that no recording holds are played on the first recording's sensor
        let last = search.problem.inputs.run.iter().copied().max().unwrap_or(0);
        inputs.run.iter_mut().for_each(|run| *run += last);
    }
    inputs
}

/// A driver at its mean, for so many rows.
fn held(driver: &Driver, rows: usize) -> Driver {
    let mean = driver.values.iter().sum::<f64>() / driver.values.len().max(1) as f64;
    Driver { values: vec![mean; rows], ..driver.clone() }
}

/// Options by what they bring for the square root of their hours, the best first.
pub(crate) fn by_worth(mut options: Vec<ExperimentOption>, brings: impl Fn(&ExperimentOption) -> f64) -> Vec<ExperimentOption> {
    let worth = |o: &ExperimentOption| brings(o) / o.hours.max(0.5).sqrt();
    options.sort_by(|a, b| worth(b).total_cmp(&worth(a)));
    options
}

/// Ranks what would tell `best` from `rivals`, of which there is at least one.
pub fn next_experiment(search: &Search<'_>, best: &Tried, rivals: &[&Tried]) -> NextExperiment {
    let options = options(search, best, rivals);
    let models: Vec<Vec<String>> = std::iter::once(best)
        .chain(rivals.iter().copied())
        .map(|t| t.effects.iter().map(|e| spoken(search.library[*e].id().0)).collect())
        .collect();
    let separates = models.iter().map(|names| model(names, "nothing missing")).collect();
    NextExperiment { says: advice(search, options.first(), &told_apart(&models)), separates, options }
}

/// A model in the names of its effects: `friction with creep and drift`; `none` where it has no effect.
fn model(names: &[String], none: &str) -> String {
    match names {
        [] => none.to_owned(),
        [one] => one.clone(),
        [first, others @ ..] => format!("{first} with {}", listed(others, "and")),
    }
}

/// Models that are to be told apart: each with what it has alone, and then what all of them have.
fn told_apart(models: &[Vec<String>]) -> String {
    let shared: Vec<String> =
        models.first().into_iter().flatten().filter(|name| models.iter().all(|m| m.contains(name))).cloned().collect();
    let none = if shared.is_empty() { "nothing missing" } else { "nothing else" };
    let own =
        models.iter().map(|names| model(&names.iter().filter(|name| !shared.contains(name)).cloned().collect::<Vec<_>>(), none));
    let own: Vec<String> = own.collect();
    let list = if own.iter().any(|one| one.contains(" and ")) { own.join("; ") } else { listed(&own, "and") };
    if shared.is_empty() { list } else { format!("{list}, beside {}", listed(&shared, "and")) }
}

/// What would best settle a word of a mechanism: `values` are those of `best` and of its `rival`.
pub fn settling(search: &Search<'_>, best: &Tried, rival: &Tried, word: &str, values: &[String; 2]) -> NextExperiment {
    let options = options(search, best, &[rival]);
    let survivors = format!("{} as its {word}", listed(values, "and"));
    NextExperiment { says: advice(search, options.first(), &survivors), separates: values.to_vec(), options }
}

/// Runs and instrument changes that tell `best` from each of `rivals`, the best first.
fn options(search: &Search<'_>, best: &Tried, rivals: &[&Tried]) -> Vec<ExperimentOption> {
    let apart = |(mut option, inputs): (ExperimentOption, Inputs)| {
        let separations: Vec<f64> = rivals.iter().filter_map(|rival| separation(search, &inputs, best, rival)).collect();
        option.separation = separations.iter().copied().fold(f64::INFINITY, f64::min);
        option.separation.is_finite().then_some(option)
    };
    let mut options: Vec<ExperimentOption> = playable(search).into_iter().filter_map(apart).collect();
    let survivors = std::iter::once(best).chain(rivals.iter().copied());
    let survivors: BTreeSet<usize> = survivors.flat_map(|t| t.effects.iter().copied()).collect();
    options.extend(instrument(&survivors.into_iter().map(|e| search.library[e]).collect::<Vec<_>>()));
    by_worth(options, |o| o.separation.min(ENOUGH))
}

fn advice(search: &Search<'_>, first: Option<&ExperimentOption>, survivors: &str) -> String {
    match first {
        Some(o) if o.profile.is_none() => {
            format!("{} ({} h): it would tell some of these apart: {survivors}", o.says, significant(o.hours, 2))
        }
        Some(o) if o.separation >= TOLD => {
            let (hours, sd) = (significant(o.hours, 2), deviations(o.separation));
            format!("{} ({hours} h): it would tell apart {survivors}, by {sd} standard deviations or more", o.says)
        }
        Some(_) => format!("no built-in profile of load and temperature tells apart {survivors}"),
        None => again(search, survivors),
    }
}

/// What to do where no built-in profile can be played: the columns that were recorded, moved in more ways.
fn again(search: &Search<'_>, survivors: &str) -> String {
    let inputs = search.problem.inputs;
    let drivers = inputs.drivers.iter().map(|driver| driver.name.as_str());
    let recorded = [("load", search.context.load_span() > 0.0), ("temperature", inputs.temperature_c.is_some())];
    let moved: Vec<&str> = recorded.into_iter().filter_map(|(name, is)| is.then_some(name)).chain(drivers).collect();
    let what = if moved.is_empty() { "all that can be moved" } else { &format!("{} moved", listed(&moved, "and")) };
    format!("record again with {what} at several speeds, with holds and with rests between, to tell apart {survivors}")
}

/// Instrument changes by which one of `effects` says that it is told from another of them, in the order of the library.
fn instrument(effects: &[&dyn Effect]) -> Vec<ExperimentOption> {
    let mut list: Vec<Separation> = Vec::new();
    for separation in effects.iter().flat_map(|e| e.separations()) {
        if effects.iter().any(|e| e.id().0 == separation.rival) && !list.contains(separation) {
            list.push(*separation);
        }
    }
    let option = |s: Separation| ExperimentOption {
        says: s.says.into(),
        separation: CERTAIN,
        error_left: None,
        hours: REBUILD_H,
        profile: None,
    };
    list.into_iter().map(option).collect()
}

fn ends(profile: &Profile) -> (f64, f64) {
    let points = (profile.points)(20.0);
    (points.first().map_or(0.0, |p| p.0), points.last().map_or(0.0, |p| p.0))
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn what_all_models_have_is_told_once() {
        let models =
            |all: &[&[&str]]| all.iter().map(|m| m.iter().map(|n| (*n).to_owned()).collect()).collect::<Vec<Vec<String>>>();
        let told = |all: &[&[&str]]| told_apart(&models(all));
        assert_eq!(told(&[&["lag"], &["drift", "creep"], &[]]), "lag, drift with creep and nothing missing");
        assert_eq!(
            told(&[&["bend", "lag", "drift"], &["lag", "bend"], &["creep", "bend", "lag"]]),
            "drift, nothing else and creep, beside bend and lag"
        );
        assert_eq!(told(&[&["lag", "drift", "creep"], &["bend"]]), "lag with drift and creep; bend");
    }
}
