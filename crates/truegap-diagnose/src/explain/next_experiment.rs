//! What to measure next: profiles and instrument changes, ranked by how well they separate what survived.
//!
//! Limits: separation is judged at the fitted numbers, with the rival's parameters free again within what is known by then.

use crate::{
    effects::effect::{Effect, Separation},
    explain::tuning::{CERTAIN, REBUILD_H},
    selection::candidates::{Search, Tried},
};
use serde::Serialize;
use std::collections::BTreeSet;
use truegap_core::{Inputs, Role, Stage};

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
    /// standard deviations between the survivors after it
    pub separation: f64,
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
    points: fn(f64) -> Points,
}

/// Profiles that are weighed.
pub const PROFILES: [Profile; 6] = [
    Profile {
        name: "long-hold",
        says: "hold half load for two hours, unload, watch the recovery for half an hour",
        points: long_hold,
    },
    Profile {
        name: "rates",
        says: "load and unload at rates a hundred apart (0.05 s to 5 min a ramp), five times each",
        points: rates,
    },
    Profile {
        name: "staircase",
        says: "staircase up and down with two-minute steps, then the same once more",
        points: staircase,
    },
    Profile {
        name: "thermal-sweep-unloaded",
        says: "heat from 20 to 50 degC and cool again without load, once in 10 min and once in 2 h",
        points: thermal_unloaded,
    },
    Profile { name: "thermal-sweep-loaded", says: "the same thermal sweep at full load", points: thermal_loaded },
    Profile {
        name: "overnight",
        says: "leave the sensor alone for twelve hours, with one load cycle every hour",
        points: overnight,
    },
];

/// The inputs of a profile, for a load of `full` in SI that goes to the `role` column.
pub fn inputs(profile: &Profile, full: f64, role: Role, start_c: f64) -> Inputs {
    let points = (profile.points)(start_c);
    let load: Vec<f64> = points.iter().map(|p| p.1 * full).collect();
    let column = |wanted: Role| (role == wanted).then(|| load.clone());
    Inputs {
        time_s: Some(points.iter().map(|p| p.0).collect()),
        run: points.iter().map(|p| p.3).collect(),
        force_n: column(Role::Force),
        pressure_pa: column(Role::Pressure),
        temperature_c: Some(points.iter().map(|p| p.2).collect()),
        ..Inputs::default()
    }
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

/// Ranks what would tell `best` from `rivals`.
pub fn next_experiment(search: &Search<'_>, best: &Tried, rivals: &[&Tried]) -> NextExperiment {
    let name = |t: &Tried| t.effects.iter().map(|e| search.library[*e].id().0).collect::<Vec<_>>().join(" + ");
    let label = |t: &Tried| if t.effects.is_empty() { "nothing missing".to_owned() } else { name(t) };
    let mut options = Vec::new();
    for profile in &PROFILES {
        let separations: Vec<f64> = rivals.iter().filter_map(|rival| separation(search, profile, best, rival)).collect();
        let least = separations.iter().copied().fold(f64::INFINITY, f64::min);
        if least.is_finite() {
            let (first, last) = ends(profile);
            options.push(ExperimentOption {
                says: profile.says.into(),
                separation: least,
                hours: (last - first) / 3600.0,
                profile: Some(profile.name.into()),
            });
        }
    }
    let survivors = std::iter::once(best).chain(rivals.iter().copied());
    let survivors: BTreeSet<usize> = survivors.flat_map(|t| t.effects.iter().copied()).collect();
    options.extend(instrument(&survivors.into_iter().map(|e| search.library[e]).collect::<Vec<_>>()));
    let worth = |o: &ExperimentOption| o.separation.min(30.0) / o.hours.max(0.5).sqrt();
    options.sort_by(|a, b| worth(b).total_cmp(&worth(a)));
    let separates = std::iter::once(best).chain(rivals.iter().copied()).map(label).collect::<Vec<_>>();
    let says = match options.first() {
        Some(o) if o.separation.is_finite() && o.separation > 0.0 => format!(
            "{} ({:.1} h): it would separate {} by {:.0} standard deviations",
            o.says,
            o.hours,
            separates.join(" from "),
            o.separation
        ),
        Some(o) => format!("{}: no profile of load and temperature separates {}", o.says, separates.join(" from ")),
        None => "repeat the recording with a rest record, holds, ramps at several rates and a thermal sweep".into(),
    };
    NextExperiment { says, separates, options }
}

/// Instrument changes by which one of `effects` says that it is told from another of them, in the order of the library.
fn instrument(effects: &[&dyn Effect]) -> Vec<ExperimentOption> {
    let mut listed: Vec<Separation> = Vec::new();
    for separation in effects.iter().flat_map(|e| e.separations()) {
        if effects.iter().any(|e| e.id().0 == separation.rival) && !listed.contains(separation) {
            listed.push(*separation);
        }
    }
    let option = |s: Separation| ExperimentOption { says: s.says.into(), separation: CERTAIN, hours: REBUILD_H, profile: None };
    listed.into_iter().map(option).collect()
}

fn ends(profile: &Profile) -> (f64, f64) {
    let points = (profile.points)(20.0);
    (points.first().map_or(0.0, |p| p.0), points.last().map_or(0.0, |p| p.0))
}

/// Standard deviations between two fitted models on a profile, the rival's parameters free again within their posterior.
fn separation(search: &Search<'_>, profile: &Profile, best: &Tried, rival: &Tried) -> Option<f64> {
    let simulator = search.problem.simulator;
    let role = if search.problem.inputs.pressure_pa.is_some() && search.problem.inputs.force_n.is_none() {
        Role::Pressure
    } else {
        Role::Force
    };
    let mut inputs = inputs(profile, simulator.full_load()?, role, search.context.reference_c);
    if simulator.joined().is_some() {
        // runs that no recording holds are played on the first recording's sensor
        let last = search.problem.inputs.run.iter().copied().max().unwrap_or(0);
        inputs.run.iter_mut().for_each(|run| *run += last);
    }
    let play = |tried: &Tried, z: &[f64]| -> Option<Vec<f64>> {
        let model = search.model(&tried.effects);
        let stages = model.stages(z);
        let borrowed: Vec<&dyn Stage> = stages.iter().map(AsRef::as_ref).collect();
        simulator.respond(&model.values(z)[..model.base_count()], &inputs, &borrowed).ok()
    };
    let noise = search.context.noise_sd;
    let here = play(rival, &rival.fit.z)?;
    let difference: Vec<f64> = play(best, &best.fit.z)?.iter().zip(&here).map(|(a, b)| (a - b) / noise).collect();
    let factor = rival.fit.factor()?;
    let n = rival.fit.z.len();
    let mut jacobian = nalgebra::DMatrix::zeros(difference.len(), n);
    for index in 0..n {
        let mut z = rival.fit.z.clone();
        let step = 0.02 * rival.fit.sd[index];
        z[index] += step;
        let there = play(rival, &z)?;
        jacobian.column_mut(index).iter_mut().zip(there.iter().zip(&here)).for_each(|(j, (a, b))| *j = (a - b) / (step * noise));
    }
    let precision = factor.l() * factor.l().transpose();
    let hessian = jacobian.tr_mul(&jacobian) + precision;
    let difference = nalgebra::DVector::from_vec(difference);
    let cross = jacobian.tr_mul(&difference);
    let absorbed = nalgebra::Cholesky::new(hessian).map_or(0.0, |f| cross.dot(&f.solve(&cross)));
    Some((difference.norm_squared() - absorbed).max(0.0).sqrt())
}
