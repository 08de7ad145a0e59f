//! The answer in the few lines that fit a terminal.
//!
//! Limits: no colour, no table; at most a line a finding.

use super::text::{capitalised, listed, spoken};
use super::{confirmation, next, not_tested, reference, wording};
use truegap_diagnose::Verdict;
use truegap_diagnose::answer::{Conflict, Diagnosis, Reference};

/// Verdict, findings with sizes, errors, what next.
pub fn summary(diagnosis: &Diagnosis) -> String {
    let mut lines = vec![wording::headline(diagnosis)];
    lines.extend(diagnosis.notices.iter().map(|notice| format!("  notice: {}", notice.says)));
    if diagnosis.verdict == Verdict::Unexplained && !diagnosis.notices.iter().any(|n| n.withholds) {
        lines.push(format!("  {}", diagnosis.says.replace('_', " ")));
    }
    for finding in &diagnosis.findings {
        lines.push(format!("  {}: {}", spoken(&finding.effect), finding.says));
        lines.push(format!("    {}", wording::how_sure(finding)));
        if !finding.rivals.is_empty() && !finding.words.is_empty() {
            lines.push(format!(
                "    whatever it is called, with the probability of each word: {}",
                finding.words.says().replace('_', " ")
            ));
        }
    }
    if !diagnosis.carried.is_empty() {
        lines.push(format!("Beside it the model carries {}:", wording::CARRIED));
        lines.extend(diagnosis.carried.iter().map(|smaller| format!("  {}: {}", spoken(&smaller.effect), smaller.says)));
    }
    // where the name is sure, the report alone says it in other words
    let sure = diagnosis.verdict == Verdict::Explained;
    for mechanism in diagnosis.discovered.iter().filter(|mechanism| !(sure && mechanism.in_other_words)) {
        if mechanism.in_other_words {
            lines.push(format!("  In words, as if no effect had a name: {}", mechanism.says));
        } else if mechanism.carried {
            lines.push(format!("  Of what it carries: {}", mechanism.clause));
        } else if !mechanism.named {
            lines.push(format!("  Of mechanisms composed of words, nearest is: {}", mechanism.says));
        }
        lines.push(format!("    words: {}", mechanism.probability.says().replace('_', " ")));
        lines.extend(mechanism.could_be.first().map(|hint| format!("    could be: {hint}")));
    }
    lines.extend(conflicts(diagnosis));
    if !diagnosis.mismatch.is_empty() {
        lines.push("Where it is wrong:".into());
        lines.extend(diagnosis.mismatch.iter().take(4).map(|m| format!("  {}", m.says)));
    }
    lines.extend(errors(diagnosis));
    lines.extend(
        diagnosis.fit.held_out.selected_again.iter().map(|again| format!("  {}", wording::chosen_again(diagnosis, again))),
    );
    lines.extend(diagnosis.permuted_searches.iter().map(|permuted| format!("  {}", permuted.says)));
    lines.extend(beside(diagnosis));
    lines.extend(diagnosis.confirmation.iter().map(confirmation::line));
    lines.extend(diagnosis.prediction_only.iter().map(|term| capitalised(&term.says)));
    if let Some(column) = &diagnosis.concealed_column {
        lines.push(format!("Hidden column: {}", column.says));
    }
    if !diagnosis.recording_issues.is_empty() {
        lines.push("Doubts:".into());
        lines.extend(diagnosis.recording_issues.iter().map(|issue| format!("  {issue}")));
    }
    lines.extend(not_tested::line(diagnosis));
    if !diagnosis.next_experiment.says.is_empty() {
        lines.push(format!("Next: {}", diagnosis.next_experiment.says));
    }
    lines.extend(next::another_recording(diagnosis).map(|says| format!("Or: {says}")));
    lines.join("\n")
}

/// What calibration did to the parameters, each kind under its heading; where it concealed what is missing, all of it is how.
fn conflicts(diagnosis: &Diagnosis) -> Vec<String> {
    let of = |heading: &str, is: &dyn Fn(&Conflict) -> bool| {
        let told: Vec<String> = diagnosis.conflicts.iter().filter(|c| is(c)).map(|c| format!("  {}", c.says)).collect();
        let heading = (diagnosis.concealed || !told.is_empty()).then(|| format!("{heading}:"));
        heading.into_iter().chain(told).collect::<Vec<_>>()
    };
    if diagnosis.concealed {
        return of("Calibration had concealed it", &|_| true);
    }
    let of_which = if diagnosis.findings.is_empty() { "" } else { " (the base model alone)" };
    let (at_odds, between) =
        (format!("At odds with what was known beforehand{of_which}"), format!("{}{of_which}", wording::BETWEEN_PARTS));
    [of(&at_odds, &|c| !c.between_parts), of(&between, &|c| c.between_parts)].concat()
}

/// A straight line and a smooth curve through the inputs, and what is said where the line is the better model.
fn beside(diagnosis: &Diagnosis) -> Vec<String> {
    let Some(first) = diagnosis.reference.first() else { return Vec::new() };
    let error = |value| wording::error_if_any(diagnosis, value);
    let one = |r: &Reference| format!("{} {} ({} held out)", reference::name(r), error(Some(r.rmse)), error(r.held_out));
    let both: Vec<String> = diagnosis.reference.iter().map(one).collect();
    let line = format!("For comparison, in {}: {}", listed(&first.inputs, "and"), both.join(", "));
    std::iter::once(line).chain(diagnosis.reference_says.iter().map(|says| format!("  {}", capitalised(says)))).collect()
}

fn errors(diagnosis: &Diagnosis) -> Vec<String> {
    let fit = &diagnosis.fit;
    let error = |value: f64| wording::error(diagnosis, value);
    let if_any = |value| wording::error_if_any(diagnosis, value);
    let held = &fit.held_out;
    if diagnosis.findings.is_empty() {
        let inside = error(fit.in_sample.rmse_before);
        return vec![format!("RMSE {inside} in sample, {} held out; noise {}", if_any(held.rmse_before), error(fit.noise_floor))];
    }
    let pair = |before, after| format!("{} -> {}", if_any(before), if_any(after));
    let removed =
        wording::misfit_removed(diagnosis).map_or(String::new(), |share| format!("; reproducible misfit removed: {share}"));
    vec![
        format!(
            "RMSE in sample {}; noise {}",
            pair(Some(fit.in_sample.rmse_before), Some(fit.in_sample.rmse_after)),
            error(fit.noise_floor)
        ),
        format!("RMSE held out  {} ({}){removed}", pair(held.rmse_before, held.rmse_after), held.how),
    ]
}
