//! A paragraph of methods and a table for LaTeX, to paste.
//!
//! Limits: says what was done and found; what it means is for the one who pastes it.

use super::subject::Subject;
use super::text::{listed, measured, percent, spoken};
use super::wording;
use truegap_diagnose::answer::Diagnosis;
use truegap_scene::page::Page;

/// Both, folded away.
pub(super) fn add(page: Page, subject: &Subject<'_>) -> Page {
    page.section("To paste")
        .details("Methods, as a paragraph")
        .text(&methods(subject))
        .end_details()
        .details("Results, as a table for LaTeX")
        .code(&latex(subject.diagnosis))
        .end_details()
}

/// What was done, in the order in which it was done.
fn methods(subject: &Subject<'_>) -> String {
    let diagnosis = subject.diagnosis;
    let (recording, base, fit) = (&diagnosis.recording, &diagnosis.base, &diagnosis.fit);
    let runs = if recording.runs == 1 { "one run".to_owned() } else { format!("{} runs", recording.runs) };
    let sensor = base.sensor.as_ref().map_or(String::new(), |name| format!(" (sensor {name})"));
    let tried = subject.library.ids().len() - diagnosis.not_testable.len().min(subject.library.ids().len());
    let hash: String = recording.sha256.chars().take(12).collect();
    let mut text = format!(
        "A recording of {} rows in {runs} (SHA-256 {hash}...) was compared with the base model {}{sensor} by truegap {}. ",
        recording.rows, base.model, diagnosis.version
    );
    text += &format!(
        "The {} parameters of the base model were calibrated by maximum a posteriori, with the noise of the recording ({} a reading) estimated from the recording \
         itself. {tried} effects that the model leaves out were weighed alone and together by their evidence, and the likeliest model was tested for lack of fit. ",
        base.parameters.len(),
        wording::error(diagnosis, fit.noise_floor)
    );
    text += &format!("Errors are of rows that no fit had seen ({}). ", fit.held_out.how);
    text + &found(diagnosis)
}

fn found(diagnosis: &Diagnosis) -> String {
    let verdict = spoken(diagnosis.verdict.word());
    let error = |value| wording::error_if_any(diagnosis, value);
    let held = &diagnosis.fit.held_out;
    if diagnosis.findings.is_empty() {
        return format!("Verdict: {verdict}; error {}.", error(held.rmse_before));
    }
    let named = diagnosis.findings.iter().map(|f| format!("{} (probability {})", spoken(&f.effect), percent(f.probability)));
    let named = listed(&named.collect::<Vec<_>>(), "and");
    format!("Verdict: {verdict}, {named}; error {} before and {} after.", error(held.rmse_before), error(held.rmse_after))
}

/// Numbers of the findings and errors.
fn latex(diagnosis: &Diagnosis) -> String {
    let mut rows = String::new();
    let mut row = |name: &str, value: &str| rows += &format!("{} & {} \\\\\n", tex(name), tex(value));
    for finding in &diagnosis.findings {
        for p in &finding.parameters {
            row(&format!("{}, {}", spoken(&finding.effect), spoken(&p.name)), &measured(p.value, p.sd, &p.unit));
        }
    }
    let held = &diagnosis.fit.held_out;
    row("error on rows left out, base model", &wording::error_if_any(diagnosis, held.rmse_before));
    if !diagnosis.findings.is_empty() {
        row("error on rows left out, with what was missing", &wording::error_if_any(diagnosis, held.rmse_after));
    }
    row("noise of one reading", &wording::error(diagnosis, diagnosis.fit.noise_floor));
    format!("\\begin{{tabular}}{{lr}}\n\\hline\nquantity & value \\\\\n\\hline\n{rows}\\hline\n\\end{{tabular}}")
}

/// Text with the marks of LaTeX as letters.
fn tex(text: &str) -> String {
    let mut out = String::new();
    for c in text.chars() {
        match c {
            '\\' => out += "\\textbackslash{}",
            '~' => out += "\\textasciitilde{}",
            '^' => out += "\\textasciicircum{}",
            '&' | '%' | '$' | '#' | '_' | '{' | '}' => out.extend(['\\', c]),
            'µ' | 'μ' => out += "$\\mu$",
            '±' => out += "$\\pm$",
            '–' => out += "--",
            '°' => out += "$^\\circ$",
            '²' => out += "$^2$",
            '³' => out += "$^3$",
            _ => out.push(c),
        }
    }
    out
}

#[cfg(test)]
mod tests {
    #[test]
    fn names_and_units_are_text_in_latex() {
        assert_eq!(super::tex("slow_share 5 % µm/°C"), "slow\\_share 5 \\% $\\mu$m/$^\\circ$C");
        assert_eq!(super::tex("\\x{1}"), "\\textbackslash{}x\\{1\\}");
    }
}
