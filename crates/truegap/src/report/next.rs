//! What to measure next, and what that would settle.
//!
//! Limits: the ranking is the diagnosis's.

use super::subject::Subject;
use super::text::{listed, significant, spoken};
use truegap_scene::page::{Page, Table};

/// Sentence, ranked options, command that plays the profile.
pub(super) fn add(page: Page, subject: &Subject<'_>) -> Page {
    let next = &subject.diagnosis.next_experiment;
    if next.says.is_empty() && next.options.is_empty() {
        return page;
    }
    let mut page = page.section("What to measure next").text(&next.says);
    if !next.separates.is_empty() {
        let names: Vec<String> = next.separates.iter().map(|s| spoken(s)).collect();
        page = page.text(&format!("It tells apart: {}.", listed(&names, "and")));
    }
    if next.options.is_empty() {
        return page;
    }
    let head = Table::new(&["what to do", "separation of the survivors, sd", "hours", "profile"]);
    let table = next.options.iter().fold(head, |table, option| {
        let profile = option.profile.clone().unwrap_or_default();
        table.row(&[option.says.clone(), significant(option.separation, 2), significant(option.hours, 2), profile])
    });
    let page = page.table(&table);
    match next.options.iter().find_map(|o| o.profile.as_ref()) {
        Some(profile) => page
            .text("Play the profile with the model found here:")
            .code(&format!("truegap simulate --model augmented.toml --profile {profile}")),
        None => page,
    }
}
