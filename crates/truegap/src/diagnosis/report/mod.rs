//! The report that a person reads: one page, no network, the answer first and everything behind it below.
//!
//! Limits: tells what a [`Diagnosis`](truegap_diagnose::answer::Diagnosis) says; decides nothing.

mod axis;
mod candidates;
mod checks;
mod concealed;
mod confirmation;
mod courses;
mod discovered;
mod draw;
mod findings;
mod flexible;
mod held_out;
mod map;
mod next;
mod not_tested;
mod origin;
mod parameters;
mod paste;
mod recordings;
mod reference;
mod subject;
mod summary;
pub mod terminal;
pub mod wording;

pub use subject::{Provenance, Subject};
pub use truegap_diagnose::text;

use axis::Axis;
use truegap_scene::page::Page;

/// The page as HTML.
///
/// Columns of `subject` that are shorter than the recording are left out of the figures, with a sentence in their place.
pub fn html(subject: &Subject<'_>) -> String {
    let axis = Axis::new(subject.inputs);
    let page = Page::new(&format!("Diagnosis of {}", short(&subject.diagnosis.recording.source))).raw_html(draw::STYLE);
    let page = summary::add(page, subject, &axis);
    let page = origin::issues(page, subject);
    let page = recordings::add(page, subject);
    let page = concealed::add(page, subject, &axis);
    let page = findings::add(page, subject);
    let page = discovered::add(page, subject);
    let page = map::add(page, subject, &axis);
    let page = courses::add(page, subject, &axis);
    let page = held_out::add(page, subject, &axis);
    let page = checks::add(page, subject);
    let page = reference::add(page, subject);
    let page = confirmation::add(page, subject);
    let page = flexible::add(page, subject, &axis);
    let page = parameters::add(page, subject);
    let page = next::add(page, subject);
    let page = not_tested::add(page, subject);
    let page = candidates::add(page, subject);
    let page = origin::bank(page, subject);
    let page = origin::noise(page, subject);
    let page = paste::add(page, subject);
    origin::provenance(page, subject).to_html()
}

/// File names without their folders; the folder too, where all recordings of a study are called the same.
fn short(source: &str) -> String {
    let one = |path: &str| {
        let mut parts = path.rsplit(['/', '\\']);
        let (file, folder) = (parts.next().unwrap_or(path), parts.next());
        folder.filter(|_| file.starts_with("recording.")).map_or(file.to_owned(), |folder| format!("{folder}/{file}"))
    };
    source.split(", ").map(one).collect::<Vec<_>>().join(", ")
}
