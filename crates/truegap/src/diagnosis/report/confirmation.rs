//! What a recording that took no part says of the findings.
//!
//! Limits: judged elsewhere; nothing is drawn.

use super::subject::Subject;
use super::text::significant;
use truegap_diagnose::answer::{Confirmation, Confirmed, Errors};
use truegap_diagnose::confirmation::Judgement;
use truegap_scene::page::{Page, Table, Tone};

/// Verdict, sentence, errors, what a reader should know beside them.
pub(super) fn add(page: Page, subject: &Subject<'_>) -> Page {
    match &subject.diagnosis.confirmation {
        None => page,
        Some(Confirmed::Judged(confirmation)) => judged(heading(page), confirmation),
        Some(Confirmed::Refused { refused, .. }) => {
            heading(page).callout(Tone::Watch, &format!("It could not be judged: {refused}."))
        }
    }
}

fn heading(page: Page) -> Page {
    page.section("On a recording that took no part")
}

fn judged(page: Page, confirmation: &Confirmation) -> Page {
    let tone = match confirmation.verdict {
        Judgement::Confirmed => Tone::Good,
        Judgement::CannotTell => Tone::Watch,
        Judgement::Refuted => Tone::Bad,
    };
    let free = if confirmation.free.is_empty() {
        "nothing was refitted to it".to_owned()
    } else {
        format!("nothing was refitted to it but {} of the reading", confirmation.free.join(" and "))
    };
    let page = page
        .text(&format!("{}, {} rows; {free}.", confirmation.recording.source, confirmation.recording.rows))
        .callout(tone, &headline(confirmation))
        .text(&confirmation.says)
        .table(&table(confirmation))
        .text(&format!("Noise: {}.", confirmation.noise.says));
    if confirmation.notes.is_empty() { page } else { page.list(&confirmation.notes) }
}

fn headline(confirmation: &Confirmation) -> String {
    match confirmation.verdict {
        Judgement::Confirmed => "Confirmed: what was found holds on this recording, too.",
        Judgement::Refuted => "Refuted: what was found makes the prediction of this recording worse.",
        Judgement::CannotTell => "Cannot tell: this recording speaks neither for nor against what was found.",
    }
    .to_owned()
}

fn table(confirmation: &Confirmation) -> Table {
    let unit = &confirmation.unit;
    let is_free = |word: &str| confirmation.free.contains(&word);
    let cell = |word: &str, value: f64| if is_free(word) { significant(value, 3) } else { "–".to_owned() };
    let row = |name: &str, model: &Errors| {
        let (gain, offset) = (cell("gain", model.reading.gain), cell("offset", model.reading.offset));
        [name.to_owned(), significant(model.rmse, 3), gain, offset]
    };
    let (error, offset) = (format!("error, {unit}"), format!("offset, {unit}"));
    let noise = ["noise of one reading".to_owned(), significant(confirmation.noise.rmse, 3), "–".to_owned(), "–".to_owned()];
    Table::new(&["model", &error, "gain", &offset])
        .row(&row("calibrated model", &confirmation.base))
        .row(&row("with what was missing", &confirmation.augmented))
        .row(&noise)
}

/// The same in a line of the terminal.
pub(super) fn line(confirmed: &Confirmed) -> String {
    match confirmed {
        Confirmed::Judged(c) => format!("On {}, which took no part: {}. {}", c.recording.source, c.verdict.words(), c.says),
        Confirmed::Refused { source, refused } => format!("On {source}, which took no part: not judged: {refused}"),
    }
}
