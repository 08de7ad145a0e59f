//! What was measured to judge the answer, its limit, and whether it passed.
//!
//! Limits: the limits are those of the diagnosis and of this report; a check without a number is not listed.

use super::parameters::{PUSHED, z};
use super::subject::Subject;
use super::text::{p_value, significant, spoken};
use super::wording::SURE;
use truegap_diagnose::answer::{Adequacy, Diagnosis, ParameterFacts};
use truegap_scene::page::{Page, Table};

/// One check.
struct Check {
    what: String,
    value: String,
    limit: String,
    unit: String,
    passed: bool,
}

/// The table of checks.
pub(super) fn add(page: Page, subject: &Subject<'_>) -> Page {
    let diagnosis = subject.diagnosis;
    let mut checks = recording(diagnosis);
    checks.extend(lack_of_fit(diagnosis));
    checks.extend(errors(subject));
    checks.extend(findings(diagnosis));
    checks.extend(parameters(diagnosis));
    let failed = checks.iter().filter(|c| !c.passed).count();
    let of = format!("{} of {} checks passed.", checks.len() - failed, checks.len());
    let mut table = Table::new(&["check", "measured", "limit", "unit", "passed"]);
    // what failed is read first
    for wanted in [false, true] {
        for c in checks.iter().filter(|c| c.passed == wanted) {
            let passed = if c.passed { "yes" } else { "no" };
            table = table.row(&[c.what.as_str(), &c.value, &c.limit, &c.unit, passed]);
        }
    }
    page.section("Checks").text(&of).table(&table)
}

fn at_most(what: &str, value: f64, limit: f64, unit: &str) -> Check {
    Check {
        what: what.to_owned(),
        value: significant(value, 3),
        limit: format!("≤ {}", significant(limit, 3)),
        unit: unit.to_owned(),
        passed: value <= limit,
    }
}

fn recording(diagnosis: &Diagnosis) -> Vec<Check> {
    let notices = diagnosis.notices.len();
    vec![Check {
        what: "what is wrong with the recording itself".into(),
        value: notices.to_string(),
        limit: "0".into(),
        unit: "notices".into(),
        passed: notices == 0,
    }]
}

/// The three tests of the model that the answer stands behind.
fn lack_of_fit(diagnosis: &Diagnosis) -> Vec<Check> {
    let adequacy = &diagnosis.adequacy;
    let tested = if diagnosis.findings.is_empty() { &adequacy.before } else { &adequacy.after };
    let Some(tested) = tested else { return Vec::new() };
    // three are made, so each has a third of the level
    let limit = Adequacy::LEVEL / 3.0;
    let tests = [
        ("lack of fit, smooth directions", tested.smooth.p_value),
        ("lack of fit, means of short stretches", tested.stretches.p_value),
        ("lack of fit, a line in the spectrum", tested.line_p_value),
    ];
    let check = |(what, p): (&str, f64)| Check {
        what: what.to_owned(),
        value: p_value(p),
        limit: format!("≥ {}", p_value(limit)),
        unit: "probability".into(),
        passed: p >= limit,
    };
    tests.into_iter().map(check).collect()
}

fn errors(subject: &Subject<'_>) -> Vec<Check> {
    let (held, scale) = (&subject.diagnosis.fit.held_out, subject.error_scale());
    let mut checks = Vec::new();
    if let (true, Some(before), Some(after)) = (subject.is_augmented(), held.rmse_before, held.rmse_after) {
        let [after, before] = [after, before].map(|error| scale.factor * error);
        checks.push(at_most("error on rows left out, not above that of the base model", after, before, &scale.unit));
    }
    if let (Some(control), Some(removed)) = (held.permutation_control, held.misfit_removed) {
        // an error below the noise would be "more than all of it"
        let [control, removed] = [control, removed].map(|share| 100.0 * share.min(1.0));
        checks.push(at_most("removed by a permuted history, not above what the findings remove", control, removed, "%"));
    }
    checks
}

fn findings(diagnosis: &Diagnosis) -> Vec<Check> {
    let check = |finding: &truegap_diagnose::answer::Finding| {
        let d = finding.detectability?;
        Some(Check {
            what: format!("detectability of {}", spoken(&finding.effect)),
            value: significant(d, 3),
            limit: format!("≥ {}", significant(SURE, 3)),
            unit: "noise".into(),
            passed: d >= SURE,
        })
    };
    diagnosis.findings.iter().filter_map(check).collect()
}

fn parameters(diagnosis: &Diagnosis) -> Vec<Check> {
    let base = &diagnosis.base.parameters_after;
    let furthest = base.iter().filter_map(|p| Some((z(p)?.abs(), p))).max_by(|a, b| a.0.total_cmp(&b.0));
    let pushed = furthest.map(|(distance, parameter)| {
        let what = format!("furthest parameter from what was known of it: {}", spoken(&parameter.name));
        at_most(&what, distance, PUSHED, "sd")
    });
    let all: Vec<&ParameterFacts> = diagnosis.findings.iter().flat_map(|f| &f.parameters).chain(base).collect();
    let at_limit = all.iter().filter(|p| p.at_limit).count();
    let bounds = Check {
        what: "parameters on a bound".into(),
        value: at_limit.to_string(),
        limit: "0".into(),
        unit: format!("of {}", all.len()),
        passed: at_limit == 0,
    };
    pushed.into_iter().chain((!all.is_empty()).then_some(bounds)).collect()
}
