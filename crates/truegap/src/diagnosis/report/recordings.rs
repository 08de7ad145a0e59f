//! The recordings of a joint diagnosis: what each is, what they have in common, and how well each is predicted.
//!
//! Limits: nothing where there is one recording.

use super::text::capitalised;
use super::{subject::Subject, wording};
use truegap_diagnose::answer::{OneRecording, RecordingError};
use truegap_scene::page::{Page, Table};

/// Sentence and table.
pub(super) fn add(page: Page, subject: &Subject<'_>) -> Page {
    let recording = &subject.diagnosis.recording;
    if recording.recordings.is_empty() {
        return page;
    }
    let page = page.section("The recordings");
    let page = match &recording.sharing {
        Some(sharing) => page.text(&format!("{}.", capitalised(&sharing.says))),
        None => page,
    };
    page.text("Noise, clock and history of each are its own.").table(&table(subject))
}

fn table(subject: &Subject<'_>) -> Table {
    let head = ["", "file", "sensor", "rows", "runs", "noise", "left out: calibrated", "with what was missing"];
    let columns = if subject.diagnosis.findings.is_empty() { 7 } else { 8 };
    let held = &subject.diagnosis.fit.held_out.recordings;
    let row = |table: Table, one: &OneRecording| {
        let error = held.iter().find(|e| e.recording == one.number);
        table.row(&cells(subject, one, error)[..columns])
    };
    subject.diagnosis.recording.recordings.iter().fold(Table::new(&head[..columns]), row)
}

fn cells(subject: &Subject<'_>, one: &OneRecording, error: Option<&RecordingError>) -> [String; 8] {
    let last = one.first_run as usize + one.runs.max(1) - 1;
    let runs = if one.runs > 1 { format!("{} to {last}", one.first_run) } else { one.first_run.to_string() };
    let told = |value: Option<f64>| value.map_or("–".to_owned(), |v| wording::error(subject.diagnosis, v));
    [
        one.number.to_string(),
        one.source.clone(),
        one.sensor.clone().unwrap_or_else(|| "–".into()),
        one.rows.to_string(),
        runs,
        told(error.map(|e| e.noise_floor)),
        told(error.and_then(|e| e.rmse_before)),
        told(error.and_then(|e| e.rmse_after)),
    ]
}
