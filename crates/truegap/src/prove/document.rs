//! The score as text and as `score.md`.
//!
//! Limits: says what was counted; what a figure means for a sensor is told in the manual.

use super::result::{Control, Score};
use std::fmt::Write;

impl Score {
    /// Everything that is measured, as a person reads it: targets, outcomes by cause, wrong claims, controls, refusals.
    pub fn text(&self) -> String {
        text(self)
    }
}

fn text(score: &Score) -> String {
    let mut text = score.table.clone();
    score.controls.iter().for_each(|control| text += &rule(control));
    if let Some((share, cases)) = score.process_misfit_removed {
        // writing to a String cannot fail
        let _ = writeln!(
            text,
            "\ncontrol, Gaussian process on the residual, no physics: removes {share:.3} of the held-out misfit at d >= 16 (median of {cases}), names nothing"
        );
    }
    text += &listed("refused (in no share above)", &score.refused);
    text += &listed("not tried on a fresh history", &score.not_tried_afresh);
    text
}

/// `score.md`: how it was made, then the text.
pub(super) fn markdown(score: &Score, command: &str) -> String {
    let plan = &score.plan;
    let sort = serde_json::to_value(plan.only).ok().and_then(|v| v.as_str().map(str::to_owned)).unwrap_or_default();
    format!(
        "# Blind study, {} cases\n\n- command: `{command}`\n- truegap {}, seed {}, concealed: {sort}\n- SHA-256 of commitments.txt: {}\n- SHA-256 of answers.txt: {}\n\n\
         Nothing was tuned on these cases. Times are wall-clock on the machine as it was, with what else ran on it.\n\n```text\n{}\n```\n",
        plan.cases,
        score.version,
        plan.seed,
        score.commitments_sha256,
        score.answers_sha256,
        text(score).trim_end()
    )
}

fn rule(control: &Control) -> String {
    let mut text = format!("\ncontrol, {}\n", control.says);
    for row in control.targets.iter().filter(|row| row.of > 0) {
        let hits = row.hits.unwrap_or(0);
        let value = row.value.unwrap_or(f64::NAN);
        let [low, high] = row.interval;
        // writing to a String cannot fail
        let _ = writeln!(
            text,
            "{:<52} {:>8} {:>9} {value:>8.3}  {low:.3} to {high:.3}",
            row.says,
            row.target,
            format!("{hits}/{}", row.of)
        );
    }
    text
}

fn listed(head: &str, list: &[(String, String)]) -> String {
    if list.is_empty() {
        return String::new();
    }
    list.iter().fold(format!("\n{head}\n"), |text, (case, reason)| text + &format!("{case}: {reason}\n"))
}
