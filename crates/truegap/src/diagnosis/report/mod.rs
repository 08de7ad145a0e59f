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

pub(super) use discovered::DISCOVERED;
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

/// The top of the page, for a notebook: verdict, what is missing and how sure that is, errors, and the residuals before and after.
pub fn first_screen(subject: &Subject<'_>) -> String {
    let page = Page::new("").raw_html(FIRST_SCREEN).raw_html("<div class=\"truegap-first\">\n");
    summary::add(page, subject, &Axis::new(subject.inputs)).raw_html("</div>\n").fragment()
}

/// Rules of the first screen where it stands in a page of somebody else, light or dark.
const FIRST_SCREEN: &str = "<style>
.truegap-first { max-width: 54rem; --soft: currentColor; --line: #8888; --shade: #8881; }
.truegap-first p { margin: .5rem 0; }
.truegap-first .callout { padding: .6rem 1rem; border-left: .3rem solid #8888; background: #8881; }
.truegap-first .callout.good { border-color: #009e73; }
.truegap-first .callout.watch { border-color: #e69f00; }
.truegap-first .callout.bad { border-color: #d55e00; }
.truegap-first .verdict .callout { font-size: 1.2rem; font-weight: 600; line-height: 1.35; }
.truegap-first .tiles { display: flex; flex-wrap: wrap; gap: .8rem; margin: 1rem 0; }
.truegap-first .tiles div { flex: 1 1 7.5rem; padding: .5rem .8rem; background: #8881; border-radius: .3rem; }
.truegap-first .tiles strong { display: block; font-size: 1.05rem; white-space: nowrap; }
.truegap-first .tiles span { opacity: .75; font-size: .85rem; }
.truegap-first figure { margin: 1rem 0; }
.truegap-first figure svg.tg-figure { display: block; max-width: 100%; height: auto; color: inherit; }
.truegap-first .tg-paper { fill: var(--jp-layout-color0, var(--vscode-editor-background, Canvas)); }
.truegap-first .tg-halo { stroke: var(--jp-layout-color0, var(--vscode-editor-background, Canvas)); }
.truegap-first figcaption { opacity: .75; font-size: .9rem; }
</style>
";

/// File names without their folders; the folder too, where all recordings of a study are called the same.
fn short(source: &str) -> String {
    let one = |path: &str| {
        let mut parts = path.rsplit(['/', '\\']);
        let (file, folder) = (parts.next().unwrap_or(path), parts.next());
        folder.filter(|_| file.starts_with("recording.")).map_or(file.to_owned(), |folder| format!("{folder}/{file}"))
    };
    source.split(", ").map(one).collect::<Vec<_>>().join(", ")
}
