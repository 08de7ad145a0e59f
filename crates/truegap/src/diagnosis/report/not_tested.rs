//! What a recording could not show, by what it lacks.
//!
//! Limits: reasons are those of the effects, word for word.

use super::subject::Subject;
use super::text::{capitalised, listed, spoken};
use truegap_diagnose::answer::{Diagnosis, NotTestable};
use truegap_scene::page::{Page, Table};

/// Effects that are named in a line of the terminal for one reason.
const NAMED: usize = 3;

/// Effects that were not tried for one reason.
struct Group<'a> {
    why: &'a str,
    effects: Vec<String>,
}

/// What could not be tested and why: first what another recording could show, then what the base model has no place for.
pub(super) fn add(page: Page, subject: &Subject<'_>) -> Page {
    let diagnosis = subject.diagnosis;
    let page = section(
        page,
        "What this recording could not show",
        "Nothing is said of these: they may be there or not. A recording that has what is missing would tell.",
        &groups(diagnosis, |not| of_recording(&not.says)),
    );
    section(
        page,
        "What this base model has no place for",
        "Left out whatever the recording holds.",
        &groups(diagnosis, |not| !of_recording(&not.says)),
    )
}

fn section(page: Page, heading: &str, says: &str, groups: &[Group<'_>]) -> Page {
    if groups.is_empty() {
        return page;
    }
    let row = |table: Table, group: &Group<'_>| table.row(&[capitalised(group.why), group.effects.join(", ")]);
    page.section(heading).text(says).table(&groups.iter().fold(Table::new(&["why", "not tried"]), row))
}

/// The same in a line: what the recording lacks, and how many effects that leaves untried.
pub(super) fn line(diagnosis: &Diagnosis) -> Option<String> {
    let groups = groups(diagnosis, |not| of_recording(&not.says) && not.would_be_missed());
    // what to do about it stands on the page
    let why = |group: &Group<'_>| group.why.split(';').next().unwrap_or(group.why).to_owned();
    let says: Vec<String> = groups.iter().map(|group| format!("{} ({})", why(group), first(&group.effects))).collect();
    (!says.is_empty()).then(|| format!("Could not be tested: {}", says.join("; ")))
}

/// The first few effects and how many more.
fn first(effects: &[String]) -> String {
    if effects.len() <= NAMED + 1 {
        return listed(effects, "and");
    }
    format!("{} and {} more", effects[..NAMED].join(", "), effects.len() - NAMED)
}

/// Effects by reason, the reason of most effects first.
fn groups(diagnosis: &Diagnosis, wanted: impl Fn(&NotTestable) -> bool) -> Vec<Group<'_>> {
    let mut groups: Vec<Group<'_>> = Vec::new();
    for NotTestable { effect, says } in diagnosis.not_testable.iter().filter(|n| wanted(n)) {
        match groups.iter_mut().find(|group| group.why == says) {
            Some(group) => group.effects.push(spoken(effect)),
            None => groups.push(Group { why: says, effects: vec![spoken(effect)] }),
        }
    }
    merge_drivers(&mut groups);
    groups.sort_by_key(|group| std::cmp::Reverse(group.effects.len()));
    groups
}

/// Where no driver moves there is no second one either: one reason for both.
fn merge_drivers(groups: &mut Vec<Group<'_>>) {
    let at = |groups: &[Group<'_>], start: &str| groups.iter().position(|group| group.why.starts_with(start));
    let Some(second) = at(groups, "no second driver that moves") else { return };
    if at(groups, "no driver that moves").is_some() {
        let effects = groups.remove(second).effects;
        if let Some(first) = at(groups, "no driver that moves") {
            groups[first].effects.extend(effects);
        }
    }
}

/// Whether a reason is about the recording: a column that is missing or stands still, rows or runs that are too few.
fn of_recording(why: &str) -> bool {
    const LACKS: [&str; 6] = ["does not change", "changes by", "stands still", "is one row", "one run only", "rows only"];
    why.starts_with("no ") || why.starts_with("nothing that drives") || LACKS.iter().any(|word| why.contains(word))
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn without_a_driver_a_second_one_is_not_asked_for() {
        let group = |why: &'static str, effect: &str| Group { why, effects: vec![effect.to_owned()] };
        let second = || group("no second driver that moves was recorded", "second driver gain");
        let mut groups = vec![second(), group("no driver that moves was recorded", "driver gain")];
        merge_drivers(&mut groups);
        assert_eq!(groups.len(), 1);
        assert_eq!(groups[0].effects, ["driver gain", "second driver gain"]);
        let mut alone = vec![second()];
        merge_drivers(&mut alone);
        assert_eq!(alone.len(), 1, "a first driver that moves leaves the second one to ask for");
    }
}
