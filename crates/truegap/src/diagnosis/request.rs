//! Recordings as they are to be diagnosed: one sensor chosen, columns concealed, base model replaced, several put behind one another.
//!
//! Limits: recordings given together must be read in the same unit.

use super::DiagnosisError;
use super::rows::rows_of_each;
use crate::models::{Programs, has_key};
use std::path::PathBuf;
use truegap_core::nearest::nearest;
use truegap_core::{INPUT_ROLES, Note, Recording, Role, given_again};
use truegap_diagnose::Library;
use truegap_diagnose::answer::Hidden;
use truegap_diagnose::joint::{Free, behind_one_another};
use truegap_limits::Need;

/// Memory of a diagnosis without its rows, bytes.
const MEMORY: f64 = 7e7;
/// Memory of a diagnosed row, bytes; both cover what `tests::MEASURED` says.
const MEMORY_OF_A_ROW: f64 = 1300.0;

/// What the user asks for beside the recordings.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Request {
    /// sensor in place of the recording's: built-in name or path
    pub sensor: Option<String>,
    /// base model in place of the recording's
    pub base: Option<String>,
    /// leave the warp out of the base model
    pub no_warp: bool,
    /// the effects that are known, the built-in ones unless somebody gives others
    pub library: Library,
    /// try no mechanisms beyond the library
    pub library_only: bool,
    /// choose again without each part of the recording, to see whether the same is named and how well it predicts the part
    pub select_in_folds: bool,
    /// permuted recordings on which the whole search is made again; none where 0
    pub permuted_searches: usize,
    /// effects to try; all where empty
    pub effects: Vec<String>,
    /// input columns to hide: role or name in the file
    pub conceal: Vec<String>,
    /// sensor column of a recording that holds several
    pub channel: Option<String>,
    /// what each of several recordings has of its own: gain, offset
    pub free: Vec<String>,
    /// recordings of the recovery bank; none where absent
    pub bank: Option<usize>,
    /// folder in which answers of a program are kept for the next diagnosis; nowhere where absent
    pub answers: Option<PathBuf>,
    /// command line, for the record
    pub command: String,
}

/// Recordings, changed as a [`Request`] says.
pub struct Opened {
    /// all rows: runs numbered on, the clock carried on; for figures and tables
    pub recording: Recording,
    /// each by itself, where there are several
    pub parts: Vec<Recording>,
    /// what each has of its own
    pub free: Free,
    /// columns hidden on purpose, a value a row of `recording`
    pub hidden: Vec<Hidden>,
    /// who is asked where a base model is a program or a function
    pub programs: Programs,
}

/// The recordings, changed as `request` says.
///
/// # Errors
/// [`DiagnosisError`] where they do not belong together, or `request` names what is not there.
pub fn open(recordings: Vec<Recording>, request: &Request) -> Result<Opened, DiagnosisError> {
    open_with(recordings, request, Programs::keeping(request.answers.clone()))
}

/// As [`open`], with a function that answers for the base model `function`.
///
/// # Errors
/// As [`open`].
pub fn open_with(recordings: Vec<Recording>, request: &Request, programs: Programs) -> Result<Opened, DiagnosisError> {
    check_effects(&request.effects, &request.library)?;
    let rows: usize = recordings.iter().map(Recording::len).sum();
    let (asked, bytes) = (format!("a diagnosis of {rows} rows"), memory(rows));
    let remedy = "average the rows, or split the recording";
    truegap_limits::check(Need { place: "recording", asked: &asked, bytes, remedy })?;
    let free = free(request, recordings.len())?;
    if let (Some(name), Some(first), false) =
        (&request.channel, recordings.first(), recordings.iter().any(|r| r.sensors.is_some()))
    {
        return Err(DiagnosisError::NoChannels { recording: named(first), name: name.clone() });
    }
    let mut parts: Vec<Recording> = recordings.into_iter().map(|r| channel(r, request)).collect::<Result<_, _>>()?;
    let mut hidden = Vec::new();
    for column in &request.conceal {
        hidden.push(conceal(&mut parts, column)?);
    }
    parts.iter_mut().for_each(|part| replace_base(part, request));
    each_once(&parts)?;
    if parts.len() == 1 {
        let recording = parts.remove(0);
        return Ok(Opened { recording, parts, free, hidden, programs });
    }
    same_drivers(&parts)?;
    let mut recording = together(&parts)?;
    recording.notes.extend(columns_of_some(&parts));
    Ok(Opened { recording, parts, free, hidden, programs })
}

/// Notes of columns that some of several recordings have, and others not.
fn columns_of_some(parts: &[Recording]) -> Vec<Note> {
    let has = |part: &Recording, role: Role| part.inputs.column(role).is_some();
    let of_role = |role: Role| {
        let with = parts.iter().find(|part| has(part, role)).map(named)?;
        let lacking = parts.iter().filter(move |part| !has(part, role));
        Some(lacking.map(move |part| Note::ColumnOfSome { role, without: named(part), with: with.clone() }))
    };
    INPUT_ROLES.into_iter().filter_map(of_role).flatten().collect()
}

/// Refuses recordings of which one has a driver that another lacks, or has in another unit.
fn same_drivers(parts: &[Recording]) -> Result<(), DiagnosisError> {
    let pairs = parts.iter().flat_map(|one| parts.iter().map(move |other| (one, other)));
    for (one, other) in pairs {
        for driver in &one.inputs.drivers {
            let name = driver.name.clone();
            match other.inputs.drivers.iter().find(|own| own.name == name) {
                None => return Err(DiagnosisError::DriverMissing { without: named(other), with: named(one), name }),
                Some(own) if own.unit != driver.unit => {
                    let (first_has, second_has) = (driver.unit.clone(), own.unit.clone());
                    return Err(DiagnosisError::DriverUnit {
                        first: named(one),
                        second: named(other),
                        name,
                        first_has,
                        second_has,
                    });
                }
                Some(_) => {}
            }
        }
    }
    Ok(())
}

/// What a diagnosis of so many rows may take, bytes.
fn memory(rows: usize) -> f64 {
    MEMORY + rows as f64 * MEMORY_OF_A_ROW
}

/// Refuses recordings of which two hold the same rows.
fn each_once(parts: &[Recording]) -> Result<(), DiagnosisError> {
    match given_again(parts, |one, other| one.response == other.response && one.inputs == other.inputs) {
        Some((first, second)) => Err(DiagnosisError::SameRecording { first: named(first), second: named(second) }),
        None => Ok(()),
    }
}

fn free(request: &Request, recordings: usize) -> Result<Free, DiagnosisError> {
    if let Some(word) = request.free.iter().find(|word| !matches!(word.as_str(), "gain" | "offset")) {
        return Err(DiagnosisError::UnknownFree { word: word.clone() });
    }
    if recordings < 2 && !request.free.is_empty() {
        return Err(DiagnosisError::NothingToFree);
    }
    let has = |word: &str| request.free.iter().any(|w| w == word);
    Ok(Free { gain: has("gain"), offset: has("offset") })
}

fn replace_base(recording: &mut Recording, request: &Request) {
    if request.base.is_some() || request.sensor.is_some() {
        // what was taken for want of a word no longer is
        recording.notes.retain(|note| !matches!(note, Note::BaseAssumed { .. }));
    }
    let base = &mut recording.base;
    let stated = base.model.clone();
    if let Some(model) = &request.base {
        base.model.clone_from(model);
    }
    if request.sensor.is_some() {
        base.sensor.clone_from(&request.sensor);
        if request.base.is_none() {
            base.model = "stack".into();
        }
    }
    if base.model != stated {
        // what stood there for another model says nothing of this one
        base.further.retain(|key, _| has_key(&base.model, key));
        base.warp = base.warp.filter(|_| has_key(&base.model, "warp"));
    }
    if request.no_warp && has_key(&base.model, "warp") {
        base.warp = Some(false);
    }
}

fn check_effects(effects: &[String], library: &Library) -> Result<(), DiagnosisError> {
    let known = library.ids();
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

/// The input columns that may be taken away.
const CONCEALABLE: [Role; 5] = [Role::Temperature, Role::Humidity, Role::Force, Role::Pressure, Role::Gap];

/// Takes a column away from all recordings that have it.
fn conceal(parts: &mut [Recording], column: &str) -> Result<Hidden, DiagnosisError> {
    let Some(first) = parts.first() else { return Err(DiagnosisError::NoRecording) };
    let in_file = first.columns.iter().find(|(_, name)| *name == column).map(|(role, _)| role.key());
    let wanted = in_file.unwrap_or(column);
    let recorded = |role: &Role| first.inputs.column(*role).is_some();
    let found = CONCEALABLE.into_iter().find(|role| role.key() == wanted && recorded(role));
    let driver = |part: &Recording| part.inputs.drivers.iter().position(|driver| driver.name == column);
    if let (None, Some(index)) = (found, driver(first)) {
        let unit = first.inputs.drivers[index].unit.clone();
        let take = |part: &mut Recording| match driver(part) {
            Some(index) => part.inputs.drivers.remove(index).values,
            None => vec![f64::NAN; part.len()],
        };
        return Ok(Hidden { column: column.into(), unit, values: parts.iter_mut().flat_map(take).collect() });
    }
    let Some(role) = found else {
        let mut names: Vec<String> = CONCEALABLE.into_iter().filter(recorded).map(|role| role.key().to_owned()).collect();
        names.extend(first.inputs.drivers.iter().map(|driver| driver.name.clone()));
        let names = names.join(", ");
        return Err(DiagnosisError::NothingToConceal { recording: named(first), column: column.into(), names });
    };
    let take = |part: &mut Recording| {
        let taken = part.inputs.column_mut(role).and_then(Option::take);
        taken.unwrap_or_else(|| vec![f64::NAN; part.len()])
    };
    let unit = role.unit().replace("degC", "°C");
    Ok(Hidden { column: role.key().into(), unit, values: parts.iter_mut().flat_map(take).collect() })
}

/// Temperature that stands for one that was not recorded, degrees Celsius; drawn, never simulated.
const ROOM_C: f64 = 20.0;

/// All rows behind one another, as far as they are drawn and listed: runs numbered on, the clock carried on where it would run back.
pub(super) fn together(parts: &[Recording]) -> Result<Recording, DiagnosisError> {
    let first = parts.first().ok_or(DiagnosisError::NoRecording)?;
    for part in parts {
        let units =
            |of: &Recording| [of.response_unit.clone(), of.simulated_unit.clone().unwrap_or_else(|| of.response_unit.clone())];
        for ((what, first_has), second_has) in ["unit", "unit of the simulation"].into_iter().zip(units(first)).zip(units(part)) {
            if first_has != second_has {
                return Err(DiagnosisError::Different { first: named(first), second: named(part), what, first_has, second_has });
            }
        }
    }
    let (mut inputs, _) = behind_one_another(&parts.iter().map(|p| (&p.inputs, ROOM_C)).collect::<Vec<_>>());
    if let Some(clock) = &mut inputs.time_s {
        for rows in rows_of_each(parts).iter().skip(1) {
            let row = rows.start;
            let (end, start) = (clock[row - 1], clock[row]);
            let shift = if start > end { 0.0 } else { end - start };
            clock[row..].iter_mut().for_each(|t| *t += shift);
        }
    }
    Ok(Recording {
        inputs,
        response: parts.iter().flat_map(|p| p.response.iter().copied()).collect(),
        notes: parts.iter().flat_map(|p| p.notes.clone()).collect(),
        sensors: None,
        ..first.clone()
    })
}

#[cfg(test)]
#[allow(clippy::unwrap_used)]
mod tests {
    use super::*;
    use truegap_core::Inputs;
    use truegap_core::recording::BaseSpec;

    /// Rows of time, force, temperature and capacitance with a thermal lag, and the most memory that a diagnosis of them held, bytes (two cores).
    const MEASURED: [(usize, f64); 4] = [(10_000, 46.9e6), (60_000, 138.5e6), (200_000, 261.3e6), (1_000_000, 1270.0e6)];

    /// One thermometer among two recordings: the other was diagnosed as if nothing were missing there.
    #[test]
    fn a_column_that_one_of_several_lacks_is_noted() {
        let recording = |warm: bool, level: f64| {
            let inputs = Inputs {
                run: vec![1; 30],
                time_s: Some((0..30).map(f64::from).collect()),
                force_n: Some((0..30).map(f64::from).collect()),
                temperature_c: warm.then(|| vec![20.0; 30]),
                ..Inputs::default()
            };
            let mut recording = Recording::new(inputs, vec![level; 30], "mV", BaseSpec::default()).unwrap();
            recording.path = if warm { "a.csv".into() } else { "b.csv".into() };
            recording
        };
        let notes = |parts| open(parts, &Request::default()).unwrap().recording.notes;
        let told: Vec<String> =
            notes(vec![recording(true, 1.0), recording(false, 2.0)]).iter().map(ToString::to_string).collect();
        assert!(told.iter().any(|note| note.starts_with("b.csv has no column for temperature, which a.csv has")), "{told:?}");
        let both = notes(vec![recording(true, 1.0), recording(true, 2.0)]);
        assert!(both.iter().all(|note| !matches!(note, Note::ColumnOfSome { .. })), "{both:?}");
    }

    /// 600 bytes a row were counted, half of what a million rows take.
    #[test]
    fn what_a_diagnosis_takes_is_counted_beforehand() {
        for (rows, bytes) in MEASURED {
            let counted = memory(rows);
            assert!(bytes <= counted && counted < 2.0 * bytes, "{rows} rows: {counted} counted, {bytes} measured");
        }
    }
}
