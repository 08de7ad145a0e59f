//! What is missing: per finding the physics, its equation, the fitted sizes, and what it could be mistaken for.
//!
//! Limits: equations and sources are those of the effect library.

use super::text::{capitalised, measured, spoken, spoken_list};
use super::{subject::Subject, wording};
use truegap_diagnose::answer::{Finding, ParameterFacts, Verdict};
use truegap_diagnose::{About, Effect};
use truegap_scene::page::{Page, Table};

/// Sets larger than this are folded.
const LISTED: usize = 4;

/// One part a finding, then the sets that cannot be told apart.
pub(super) fn add(page: Page, subject: &Subject<'_>) -> Page {
    let diagnosis = subject.diagnosis;
    let page = if diagnosis.findings.is_empty() { page } else { page.section(heading(diagnosis.verdict)) };
    let has_two = diagnosis.findings.iter().flat_map(|finding| &finding.parameters).any(|p| !wording::of_fit_alone(p).is_empty());
    let page = if has_two { page.text(wording::TWO_DEVIATIONS) } else { page };
    let page = diagnosis.findings.iter().fold(page, |page, finding| one(page, subject, finding));
    let page = ambiguity(page, subject, &diagnosis.ambiguity);
    carried(page, subject)
}

/// Effects that the model carries without a claim to their names, one part each.
fn carried(page: Page, subject: &Subject<'_>) -> Page {
    let smaller = &subject.diagnosis.carried;
    if smaller.is_empty() {
        return page;
    }
    let says = format!("The model carries {}. They stay in it because it predicts better with them.", wording::CARRIED);
    let page = page.section("Smaller parts, without a claim to their names").text(&says);
    smaller.iter().fold(page, |page, finding| one(page, subject, finding))
}

fn heading(verdict: Verdict) -> &'static str {
    match verdict {
        Verdict::Explained => "What is missing",
        Verdict::Agrees | Verdict::Ambiguous => "What may be missing",
        Verdict::WrongForm | Verdict::Unexplained | Verdict::Undecided => "What comes nearest",
    }
}

/// What the library says of an effect.
pub(super) fn about(subject: &Subject<'_>, id: &str) -> Option<About> {
    subject.library.find(id).map(Effect::about)
}

fn one(page: Page, subject: &Subject<'_>, finding: &Finding) -> Page {
    let mut page = page.subsection(&spoken(&finding.effect)).text(&format!("{}.", wording::how_sure(finding)));
    if let Some(about) = about(subject, &finding.effect) {
        page = page.text(&format!("The physics: {}.", about.physics)).code(about.equation);
    }
    page = page.table(&parameters(&finding.parameters));
    let error = |value| wording::error_if_any(subject.diagnosis, value);
    let held = &finding.held_out;
    page = page.text(&format!(
        "Error on rows left out, without and with this effect: {} → {}.",
        error(held.rmse_before),
        error(held.rmse_after)
    ));
    if !finding.rivals.is_empty() {
        page = page.text(&format!("Not quite excluded in its place: {}.", wording::one_of(&finding.rivals)));
    }
    if !finding.words.is_empty() {
        page = page.text(&format!(
            "Whatever the effect is called, with the probability of each word: {}.",
            spoken(&finding.words.says())
        ));
    }
    match about(subject, &finding.effect) {
        None => page,
        Some(about) => {
            let apart = format!("Told from {} by this: {}.", spoken_list(about.impostors, "and"), about.separates);
            page.text(&apart).text(&format!("Source: {}.", about.source))
        }
    }
}

fn parameters(parameters: &[ParameterFacts]) -> Table {
    let limits = parameters.iter().any(|p| p.at_limit);
    let head = ["parameter", "what it is", "fitted", "assumed beforehand", ""];
    let cut = if limits { head.len() } else { head.len() - 1 };
    parameters.iter().fold(Table::new(&head[..cut]), |table, p| {
        let limit = if p.at_limit { "at its limit" } else { "" };
        let prior = measured(p.prior[0], p.prior[1], &p.unit);
        let fitted = wording::number(p) + &wording::of_fit_alone(p);
        let row = [spoken(&p.name), p.meaning.clone(), fitted, prior, limit.to_owned()];
        table.row(&row[..cut])
    })
}

fn ambiguity(page: Page, subject: &Subject<'_>, sets: &[Vec<String>]) -> Page {
    if sets.is_empty() {
        return page;
    }
    let page = page.section("What this recording cannot tell apart");
    sets.iter().fold(page, |page, set| {
        let lines: Vec<String> =
            set.iter().filter_map(|m| about(subject, m).map(|a| format!("{}: {}", spoken(m), a.separates))).collect();
        let page = page.text(&format!("{}.", capitalised(&spoken_list(set.iter(), "or"))));
        if lines.len() > LISTED {
            page.details("What would tell them apart").list(&lines).end_details()
        } else {
            page.text("What would tell:").list(&lines)
        }
    })
}
