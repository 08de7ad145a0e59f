//! What a recording that took no part says of the findings.
//!
//! Limits: judged elsewhere; nothing is drawn.

use super::subject::Subject;
use super::text::significant;
use truegap_diagnose::answer::{Confirmation, Confirmed, Errors};
use truegap_diagnose::confirmation::Judgement;
use truegap_diagnose::text::listed;
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
        let free: Vec<String> = confirmation.free.iter().map(|word| free_in_words(word)).collect();
        format!("nothing was refitted to it but {}", listed(&free, "and"))
    };
    let page = page
        .text(&format!("{}, {} rows; {free}.", confirmation.recording.source, confirmation.recording.rows))
        .callout(tone, &headline(confirmation))
        .text(&confirmation.says)
        .table(&table(confirmation))
        .text(&format!("Noise: {}.", confirmation.noise.says));
    let page = match &confirmation.rivals {
        Some(rivals) => page.text(&rivals.says),
        None => page,
    };
    if confirmation.notes.is_empty() { page } else { page.list(&confirmation.notes) }
}

/// What is free, for a reader.
fn free_in_words(word: &str) -> String {
    if word == "clock" {
        "a clock of the load against that of the reading".to_owned()
    } else {
        format!("the {word} of the reading")
    }
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
        let clock = model.clock.map(|clock| [significant(clock.late_s, 3), significant(1e3 * clock.rate, 3)]);
        [name.to_owned(), significant(model.rmse, 3), gain, offset]
            .into_iter()
            .chain(clock.into_iter().flatten())
            .collect::<Vec<_>>()
    };
    let (error, offset) = (format!("error, {unit}"), format!("offset, {unit}"));
    let clocks = ["load late at first row, s", "falls behind, ms/s"].into_iter().filter(|_| is_free("clock"));
    let header: Vec<&str> = ["model", error.as_str(), "gain", offset.as_str()].into_iter().chain(clocks).collect();
    let nothing = std::iter::repeat_n("–".to_owned(), header.len() - 2);
    let noise: Vec<String> =
        ["noise of one reading".to_owned(), significant(confirmation.noise.rmse, 3)].into_iter().chain(nothing).collect();
    let table = Table::new(&header)
        .row(&row("calibrated model", &confirmation.base))
        .row(&row("with what was missing", &confirmation.augmented));
    let rivals = confirmation.rivals.iter().flat_map(|rivals| &rivals.judged);
    rivals.fold(table, |table, rival| table.row(&row(&format!("with {}", rival.row()), &rival.errors))).row(&noise)
}

/// The same in a line of the terminal.
pub(super) fn line(confirmed: &Confirmed) -> String {
    match confirmed {
        Confirmed::Judged(c) => {
            let rivals = c.rivals.as_ref().map_or_else(String::new, |rivals| format!(" {}", rivals.says));
            format!("On {}, which took no part: {}. {}{rivals}", c.recording.source, c.verdict.words(), c.says)
        }
        Confirmed::Refused { source, refused } => format!("On {source}, which took no part: not judged: {refused}"),
    }
}
