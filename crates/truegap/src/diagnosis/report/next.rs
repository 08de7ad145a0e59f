//! What to measure next, and what that would settle.
//!
//! Limits: the ranking is the diagnosis's.

use super::subject::Subject;
use super::text::{capitalised, significant, spoken_list};
use truegap_diagnose::{Diagnosis, Verdict};
use truegap_scene::page::{Page, Table};

/// Sentence, ranked options, command that plays the profile.
pub(super) fn add(page: Page, subject: &Subject<'_>) -> Page {
    let next = &subject.diagnosis.next_experiment;
    if next.says.is_empty() && next.options.is_empty() {
        return page;
    }
    let mut page = page.section("What to measure next").text(&format!("{}.", capitalised(next.says.trim_end_matches('.'))));
    if let Some(says) = another_recording(subject.diagnosis) {
        page = page.text(&format!("{}.", capitalised(&says)));
    }
    if !next.separates.is_empty() {
        page = page.text(&format!(
            "To be told apart: {}. What this recording leaves less than a twentieth of the likeliest model's probability is excluded and not among them.",
            spoken_list(&next.separates, "and")
        ));
    }
    if next.options.is_empty() {
        return page;
    }
    let narrows = next.options.iter().any(|o| o.error_left.is_some());
    let brings = if narrows { "error of the least sure number left, %" } else { "separation of the survivors, sd" };
    let head = Table::new(&["what to do", brings, "hours", "profile"]);
    let table = next.options.iter().fold(head, |table, option| {
        let profile = option.profile.clone().unwrap_or_default();
        let brings = option.error_left.map_or_else(|| significant(option.separation, 2), |left| format!("{:.0}", 100.0 * left));
        table.row(&[option.says.clone(), brings, significant(option.hours, 2), profile])
    });
    let page = page.table(&table);
    match next.options.iter().find_map(|o| o.profile.as_ref()) {
        Some(profile) => page
            .text("Play the profile with the model found here:")
            .code(&format!("truegap simulate --model augmented.toml --profile {profile}")),
        None => page,
    }
}

/// What a recording that is there already may do for names that this one leaves open; `None` where it leaves none.
pub(super) fn another_recording(diagnosis: &Diagnosis) -> Option<String> {
    let open = diagnosis.findings.iter().any(|finding| !finding.rivals.is_empty());
    (open && diagnosis.verdict == Verdict::Ambiguous).then(|| {
        "another recording, if there is one, may tell apart what this one cannot: `truegap confirm augmented.toml OTHER.toml` judges each of the rivals on it"
            .into()
    })
}
