//! Recordings as they are to be diagnosed: joined, one sensor chosen, columns concealed, base model replaced.
//!
//! Limits: recordings given together must have the same columns, unit and base model; their runs follow one another.

use super::DiagnosisError;
use crate::nearest::nearest;
use truegap_core::{Inputs, Recording};

/// What the user asks for beside the recordings.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Request {
    /// sensor in place of the recording's: built-in name or path
    pub sensor: Option<String>,
    /// base model in place of the recording's
    pub base: Option<String>,
    /// leave the warp out of the base model
    pub no_warp: bool,
    /// effects to try; all where empty
    pub effects: Vec<String>,
    /// input columns to hide: role or name in the file
    pub conceal: Vec<String>,
    /// sensor column of a recording that holds several
    pub channel: Option<String>,
    /// command line, for the record
    pub command: String,
}

/// The recordings as one, changed as `request` says.
///
/// # Errors
/// [`DiagnosisError`] where they do not belong together, or `request` names what is not there.
pub fn open(recordings: Vec<Recording>, request: &Request) -> Result<Recording, DiagnosisError> {
    check_effects(&request.effects)?;
    let chosen: Vec<Recording> = recordings.into_iter().map(|r| channel(r, request)).collect::<Result<_, _>>()?;
    let mut all = chosen.into_iter();
    let first = all.next().ok_or(DiagnosisError::NoRecording)?;
    let mut recording = all.try_fold(first, join)?;
    for column in &request.conceal {
        conceal(&mut recording, column)?;
    }
    let base = &mut recording.base;
    if let Some(model) = &request.base {
        base.model.clone_from(model);
    }
    if request.sensor.is_some() {
        base.sensor.clone_from(&request.sensor);
        if request.base.is_none() {
            base.model = "stack".into();
        }
    }
    if request.no_warp {
        base.warp = Some(false);
    }
    Ok(recording)
}

fn check_effects(effects: &[String]) -> Result<(), DiagnosisError> {
    let known: Vec<&'static str> = truegap_diagnose::library().iter().map(|e| e.id().0).collect();
    match effects.iter().find(|id| !known.contains(&id.as_str())) {
        None => Ok(()),
        Some(id) => {
            let close = nearest(id, known.iter().copied());
            let hint = if close.is_empty() {
                format!("it has {}", known.join(", "))
            } else {
                format!("did you mean {}?", close.join(", "))
            };
            Err(DiagnosisError::UnknownEffect { id: id.clone(), hint })
        }
    }
}

fn channel(recording: Recording, request: &Request) -> Result<Recording, DiagnosisError> {
    let Some(sensors) = &recording.sensors else { return Ok(recording) };
    let names = || sensors.names.join(", ");
    match &request.channel {
        Some(name) if sensors.names.contains(name) => Ok(recording.of_sensor(name)),
        Some(name) => Err(DiagnosisError::NoSuchChannel { recording: named(&recording), name: name.clone(), names: names() }),
        None if sensors.names.len() > 1 => {
            let first = sensors.names[0].clone();
            Err(DiagnosisError::SeveralSensors { recording: named(&recording), names: names(), first })
        }
        None => Ok(recording),
    }
}

pub(super) fn named(recording: &Recording) -> String {
    if recording.path.as_os_str().is_empty() { "recording".into() } else { recording.path.display().to_string() }
}

/// One of the input columns, to be taken away.
type Column = fn(&mut Inputs) -> &mut Option<Vec<f64>>;

const CONCEALABLE: [(&str, Column); 5] = [
    ("temperature", |i| &mut i.temperature_c),
    ("humidity", |i| &mut i.humidity_pct),
    ("force", |i| &mut i.force_n),
    ("pressure", |i| &mut i.pressure_pa),
    ("gap", |i| &mut i.gap_m),
];

fn conceal(recording: &mut Recording, column: &str) -> Result<(), DiagnosisError> {
    let in_file = recording.columns.iter().find(|(_, name)| *name == column).map(|(role, _)| format!("{role:?}").to_lowercase());
    let wanted = in_file.as_deref().unwrap_or(column);
    let found = CONCEALABLE.iter().find(|(role, get)| *role == wanted && get(&mut recording.inputs).is_some());
    let Some((_, get)) = found else {
        let there = CONCEALABLE.iter().filter(|(_, get)| get(&mut recording.inputs).is_some());
        let names = there.map(|(role, _)| *role).collect::<Vec<_>>().join(", ");
        return Err(DiagnosisError::NothingToConceal { recording: named(recording), column: column.into(), names });
    };
    *get(&mut recording.inputs) = None;
    Ok(())
}

/// `second` behind `first`, its runs numbered on, its clock carried on where it would run back.
fn join(mut first: Recording, second: Recording) -> Result<Recording, DiagnosisError> {
    check_alike(&first, &second)?;
    let runs_before = first.inputs.run.iter().max().copied().unwrap_or(0);
    let least = second.inputs.run.iter().min().copied().unwrap_or(0);
    let (a, b) = (&mut first.inputs, second.inputs);
    a.run.extend(b.run.iter().map(|run| run - least + runs_before + 1));
    if let (Some(clock), Some(next)) = (&mut a.time_s, &b.time_s) {
        let (end, start) = (clock.last().copied().unwrap_or(0.0), next.first().copied().unwrap_or(0.0));
        let shift = if start > end { 0.0 } else { end - start };
        clock.extend(next.iter().map(|t| t + shift));
    }
    let pairs = [
        (&mut a.force_n, b.force_n),
        (&mut a.pressure_pa, b.pressure_pa),
        (&mut a.gap_m, b.gap_m),
        (&mut a.temperature_c, b.temperature_c),
        (&mut a.humidity_pct, b.humidity_pct),
        (&mut a.simulated, b.simulated),
    ];
    for (to, from) in pairs {
        if let (Some(to), Some(from)) = (to, from) {
            to.extend(from);
        }
    }
    first.response.extend(second.response);
    first.notes.extend(second.notes);
    Ok(first)
}

fn check_alike(first: &Recording, second: &Recording) -> Result<(), DiagnosisError> {
    let roles =
        |r: &Recording| r.quantities().iter().map(|(role, _)| format!("{role:?}").to_lowercase()).collect::<Vec<_>>().join(", ");
    let base = |r: &Recording| format!("{:?}", (&r.base.model, &r.base.sensor, &r.base.warp));
    let checks = [
        ("columns", roles(first), roles(second)),
        ("unit", first.response_unit.clone(), second.response_unit.clone()),
        ("base model", base(first), base(second)),
    ];
    match checks.into_iter().find(|(_, a, b)| a != b) {
        None => Ok(()),
        Some((what, first_has, second_has)) => {
            Err(DiagnosisError::Different { first: named(first), second: named(second), what, first_has, second_has })
        }
    }
}
