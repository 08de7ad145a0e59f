//! What is wrong with the recordings: outliers are left out, everything else is noted.
//!
//! Limits: each recording by itself; rows in notices are counted as in the file, without its header.

use super::DiagnosisError;
use super::bases::{Bases, bases};
use super::request::{Opened, together};
use super::rows::rows_of_each;
use truegap_core::{LOADS, Recording, Role, Simulator, StageName};
use truegap_diagnose::quality::FEWEST_ROWS;
use truegap_diagnose::quality::{Notice, NoticeKind};
use truegap_diagnose::quality::{Rows, clipped_rows, outliers, outliers_of_inputs, repeated, troubles};
use truegap_diagnose::{Options, Problem, Restriction};

/// Recordings without their outliers, with their base models and what is wrong with them.
pub(super) struct Screened {
    pub opened: Opened,
    pub bases: Bases,
    pub notices: Vec<Notice>,
    /// the only recording with the rows that were left out because they lie at an end of the converter's range
    pub clipped: Option<Clipped>,
}

/// A recording as it was opened, and its rows at the ends of the range.
pub(super) struct Clipped {
    pub whole: Recording,
    pub rows: Vec<usize>,
}

/// Screens what was opened.
pub(super) fn screen(mut opened: Opened) -> Result<Screened, DiagnosisError> {
    let first = bases(&opened)?;
    idle_loads_as_drivers(&mut opened, &first);
    let several = opened.parts.len();
    let mut notices = Vec::new();
    let mut kept: Vec<Vec<usize>> = Vec::new();
    let mut clipped = None;
    for (index, part) in parts(&opened).iter().enumerate() {
        let (keep, found) = kept_rows(part, first.simulator(index));
        let mut at_an_end = found.iter().filter(|(notice, _)| several == 0 && notice.kind == NoticeKind::ClippedRows);
        clipped = at_an_end.next().map(|(_, rows)| Clipped { whole: part.clone(), rows: rows.clone() });
        notices.extend(found.into_iter().map(|(notice, _)| of(notice, index, several)));
        kept.push(keep);
    }
    if kept.iter().zip(parts(&opened)).any(|(keep, part)| keep.len() < part.len()) {
        opened = without(opened, &kept)?;
    }
    let bases = bases(&opened)?;
    for (index, part) in parts(&opened).iter().enumerate() {
        let found = with(part, bases.simulator(index), Some(&kept[index]), troubles).unwrap_or_default();
        notices.extend(found.into_iter().map(|notice| of(notice, index, several)));
    }
    Ok(Screened { opened, bases, notices, clipped })
}

/// A force or pressure that no base model follows is a driver as any other: it moves the reading, if it does, beside what is simulated.
fn idle_loads_as_drivers(opened: &mut Opened, bases: &Bases) {
    let is_idle = |role: &Role, part: &Recording, simulator: &dyn Simulator| {
        let has_plates = simulator.lacks(StageName::Geometry).is_none();
        !has_plates && !simulator.needs().contains(role) && simulator.load(&part.inputs).is_none()
    };
    let mut idle = LOADS.to_vec();
    for (index, part) in parts(opened).iter().enumerate() {
        idle.retain(|role| is_idle(role, part, bases.simulator(index)));
    }
    for role in idle {
        opened.recording.inputs.load_as_driver(role);
        opened.parts.iter_mut().for_each(|part| part.inputs.load_as_driver(role));
    }
}

/// Rows that a diagnosis would keep, and the others with what it would say of them.
fn kept_rows(part: &Recording, simulator: &dyn Simulator) -> (Vec<usize>, Vec<(Notice, Vec<usize>)>) {
    let looks = [clipped_rows, repeated, outliers, outliers_of_inputs];
    let found: Vec<_> = looks.into_iter().filter_map(|look| with(part, simulator, None, look).flatten()).collect();
    let is_out = |row: &usize| found.iter().any(|(_, out)| out.binary_search(row).is_ok());
    let keep = (0..part.len()).filter(|row| !is_out(row)).collect();
    (keep, found)
}

/// A recording beside a model, without the rows that its diagnosis would leave out, and what is said of them.
pub(super) fn without_outliers(recording: Recording, simulator: &dyn Simulator) -> (Recording, Vec<Notice>) {
    let (keep, found) = kept_rows(&recording, simulator);
    let notices = found.into_iter().map(|(notice, _)| notice).collect();
    let all = keep.len() == recording.len();
    (if all { recording } else { recording.select(&keep) }, notices)
}

fn parts(opened: &Opened) -> &[Recording] {
    if opened.parts.is_empty() { std::slice::from_ref(&opened.recording) } else { &opened.parts }
}

/// What `look` finds in a recording; `None` where it is too short to be looked at.
fn with<T>(
    part: &Recording,
    simulator: &dyn Simulator,
    given: Option<&[usize]>,
    look: impl Fn(&Problem<'_>, &Rows<'_>) -> T,
) -> Option<T> {
    let problem = Problem { inputs: &part.inputs, response: &part.response, simulator };
    (part.len() >= FEWEST_ROWS).then(|| look(&problem, &Rows { inputs: &part.inputs, given, unit: &part.response_unit }))
}

/// A notice, with the recording's number where there are several.
fn of(notice: Notice, index: usize, several: usize) -> Notice {
    if several == 0 { notice } else { Notice { says: format!("recording {}: {}", index + 1, notice.says), ..notice } }
}

/// The rows that `kept` names, recording by recording.
fn without(opened: Opened, kept: &[Vec<usize>]) -> Result<Opened, DiagnosisError> {
    let each = rows_of_each(parts(&opened));
    let rows: Vec<usize> = kept.iter().zip(&each).flat_map(|(keep, rows)| keep.iter().map(|row| rows.start + row)).collect();
    let mut hidden = opened.hidden;
    hidden.iter_mut().for_each(|h| h.values = rows.iter().map(|row| h.values[*row]).collect());
    let parts: Vec<Recording> = opened.parts.iter().zip(kept).map(|(part, keep)| part.select(keep)).collect();
    let recording = if parts.is_empty() { opened.recording.select(&rows) } else { together(&parts)? };
    Ok(Opened { recording, parts, hidden, free: opened.free, programs: opened.programs })
}

/// Options as the notices allow.
pub(super) fn reserve(notices: &[Notice], options: Options) -> Options {
    let withheld = notices.iter().find(|n| n.withholds).map(|n| format!("no physics is named: {}", n.says));
    let clipped = notices.iter().any(|n| n.kind == NoticeKind::Clipped);
    let restricted = clipped.then_some(Restriction {
        only: |effect| effect.clips(),
        why: "readings are clipped, so nothing but saturation is looked for",
    });
    Options { withheld, restricted, ..options }
}
