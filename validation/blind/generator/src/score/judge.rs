//! Right, right within its set, wrong or missed: one case at a time.
//!
//! Limits: two classes are added to the README's four, because it leaves them open: `Partial` (some of several causes and nothing
//! else) and `Unnamed` (a mismatch is stated and nothing named). Neither counts as right.

use super::claim::Claim;
use super::truth::Truth;
use std::collections::BTreeSet;

/// How good a claim is.
#[derive(Debug, Clone, Copy, PartialEq, Eq, PartialOrd, Ord, Hash)]
pub enum Outcome {
    /// Exactly the causes; for none, `agrees`; for a stranger, `unexplained` or `undecided`.
    Right,
    /// Verdict `ambiguous`, and the sets hold the causes.
    WithinSet,
    /// Some of the causes and nothing else.
    Partial,
    /// A mismatch without a name.
    Unnamed,
    /// Names something else.
    Wrong,
    /// `agrees`, and something is there.
    Missed,
}

/// Judges `claim` against `truth`.
pub fn judge(truth: &Truth, claim: &Claim) -> Outcome {
    // the bath is there as well: naming it is neither asked for nor wrong
    let named: BTreeSet<&str> = claim.named().into_iter().filter(|name| !truth.bath.contains(*name)).collect();
    let agrees = claim.verdict == "agrees";
    match (&truth.stranger, truth.is_null()) {
        (_, true) => nothing(agrees, &named, !claim.findings.is_empty()),
        (Some(stranger), _) => unmodelled(stranger, claim, &named),
        _ if agrees && named.is_empty() => Outcome::Missed,
        _ => library(truth, claim, &named),
    }
}

fn nothing(agrees: bool, named: &BTreeSet<&str>, named_only_bath: bool) -> Outcome {
    match (named.is_empty(), agrees) {
        (false, _) => Outcome::Wrong,
        (true, true) => Outcome::Right,
        (true, false) if named_only_bath => Outcome::Right,
        (true, false) => Outcome::Unnamed,
    }
}

fn unmodelled(stranger: &str, claim: &Claim, named: &BTreeSet<&str>) -> Outcome {
    // Jumps inside a run: the shared recordings count them as outside the library, the table of effects as `offset_steps` (a slipping contact): both are right.
    if ["steps", "slips"].contains(&stranger) && named.iter().eq(["offset_steps"].iter()) {
        return Outcome::Right;
    }
    match claim.verdict.as_str() {
        // words for what no library lists are no name of one
        _ if !named.is_empty() && named.iter().all(|name| name.starts_with("discovered")) => Outcome::Right,
        _ if !named.is_empty() => Outcome::Wrong,
        "unexplained" | "undecided" => Outcome::Right,
        "agrees" => Outcome::Missed,
        _ => Outcome::Unnamed,
    }
}

fn library(truth: &Truth, claim: &Claim, named: &BTreeSet<&str>) -> Outcome {
    let causes: BTreeSet<&str> = truth.causes.iter().map(String::as_str).collect();
    if *named == causes {
        return Outcome::Right;
    }
    if claim.verdict == "ambiguous" && within_sets(&causes, claim, named) {
        return Outcome::WithinSet;
    }
    if named.is_empty() {
        return Outcome::Unnamed;
    }
    if named.is_subset(&causes) { Outcome::Partial } else { Outcome::Wrong }
}

/// Every cause is named or stands in a set, and every finding that is no cause shares a set with one.
fn within_sets(causes: &BTreeSet<&str>, claim: &Claim, named: &BTreeSet<&str>) -> bool {
    let held = |cause: &&str| named.contains(*cause) || claim.ambiguity.iter().any(|set| set.contains(*cause));
    let excused = |finding: &&str| {
        let shares = |set: &&BTreeSet<String>| set.contains(*finding) && causes.iter().any(|cause| set.contains(*cause));
        causes.contains(*finding) || claim.ambiguity.iter().any(|set| shares(&set))
    };
    causes.iter().all(held) && named.iter().all(excused)
}

#[cfg(test)]
mod tests {
    use super::*;
    use serde_json::json;

    fn outcome(effects: &[&str], diagnosis: serde_json::Value) -> Outcome {
        let truth = json!({"effects": effects, "detectability": 20.0, "protocol": "full"});
        let truth = Truth::of_shared("case", &truth).expect("truth");
        judge(&truth, &Claim::read(&diagnosis).expect("claim"))
    }

    #[test]
    fn a_member_of_the_bath_is_neither_wrong_nor_asked_for() {
        let truth = json!({"effects": [], "detectability": 0.0, "protocol": "hand", "bath": {"ageing": 2.0}, "mechanism": {}});
        let truth = Truth::of_shared("case", &truth).expect("truth");
        let said = |verdict: &str, names: &[&str]| {
            let findings: Vec<_> = names.iter().map(|n| json!({"effect": n, "probability": 0.9})).collect();
            judge(&truth, &Claim::read(&json!({"verdict": verdict, "findings": findings})).expect("claim"))
        };
        assert_eq!(said("explained", &["ageing"]), Outcome::Right);
        assert_eq!(said("explained", &["ageing", "dead_gap"]), Outcome::Wrong);
        assert_eq!(said("explained", &["discovered"]), Outcome::Wrong);
        assert_eq!(said("unexplained", &[]), Outcome::Unnamed);
    }

    #[test]
    fn the_readme_s_rules_hold() {
        let says = |verdict: &str, names: &[&str]| {
            let findings: Vec<_> = names.iter().map(|n| json!({"effect": n, "probability": 0.9})).collect();
            json!({"verdict": verdict, "findings": findings, "ambiguity": [["thermal_lag", "readout_lag"]]})
        };
        assert_eq!(outcome(&[], says("agrees", &[])), Outcome::Right);
        assert_eq!(outcome(&[], says("explained", &["ageing"])), Outcome::Wrong);
        assert_eq!(outcome(&["ageing"], says("agrees", &[])), Outcome::Missed);
        assert_eq!(outcome(&["ageing"], says("explained", &["ageing"])), Outcome::Right);
        assert_eq!(outcome(&["ageing"], says("explained", &["dead_gap"])), Outcome::Wrong);
        assert_eq!(outcome(&["ageing", "dead_gap"], says("explained", &["dead_gap"])), Outcome::Partial);
        assert_eq!(outcome(&["thermal_lag"], says("ambiguous", &["readout_lag"])), Outcome::WithinSet);
        assert_eq!(outcome(&["thermal_lag"], says("explained", &["readout_lag"])), Outcome::Wrong);
        assert_eq!(outcome(&["ageing"], says("ambiguous", &["readout_lag"])), Outcome::Wrong);
        assert_eq!(outcome(&["unlisted:hum"], says("unexplained", &[])), Outcome::Right);
        assert_eq!(outcome(&["unlisted:hum"], says("explained", &["ageing"])), Outcome::Wrong);
        assert_eq!(outcome(&["unlisted:hum"], says("explained", &["discovered"])), Outcome::Right);
        assert_eq!(outcome(&["ageing"], says("explained", &["discovered"])), Outcome::Wrong);
        assert_eq!(outcome(&["unlisted:steps"], says("explained", &["offset_steps"])), Outcome::Right);
    }
}
