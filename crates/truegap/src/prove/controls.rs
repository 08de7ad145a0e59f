//! What a simpler rule would have said of the same fits.
//!
//! Limits: rules over the single candidates in `diagnosis.json`, which hold evidences and no likelihoods: none of them is a BIC, and none refits.

use serde_json::{Value, json};

/// A rule that makes claims from the candidates of a diagnosis.
pub(super) struct Rule {
    pub(super) says: &'static str,
    pub(super) claims: fn(&Value) -> Value,
}

/// The rules scored beside the diagnosis.
pub(super) const RULES: [Rule; 2] = [
    Rule {
        says: "best single evidence: names the effect of the highest log evidence where that beats none; no prior for how many were tried, no gate",
        claims: best_evidence,
    },
    Rule { says: "always a name: names the effect of the highest log evidence, whatever it is", claims: always },
];

fn best_evidence(diagnosis: &Value) -> Value {
    match best(diagnosis) {
        Some((effect, score)) if score > 0.0 => named(effect),
        _ => json!({"verdict": "agrees"}),
    }
}

fn always(diagnosis: &Value) -> Value {
    best(diagnosis).map_or_else(|| json!({"verdict": "agrees"}), |(effect, _)| named(effect))
}

fn named(effect: &str) -> Value {
    json!({"verdict": "explained", "findings": [{"effect": effect}]})
}

fn best(diagnosis: &Value) -> Option<(&str, f64)> {
    let candidates = diagnosis["candidates"].as_array()?.iter();
    candidates.filter_map(|c| Some((c["effect"].as_str()?, c["score"].as_f64()?))).max_by(|a, b| a.1.total_cmp(&b.1))
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn the_rules_follow_the_evidence() {
        let diagnosis =
            |first: f64, second: f64| json!({"candidates": [{"effect": "a", "score": first}, {"effect": "b", "score": second}]});
        assert_eq!(best_evidence(&diagnosis(1.0, 2.0))["findings"][0]["effect"], "b");
        assert_eq!(best_evidence(&diagnosis(-2.0, -1.0))["verdict"], "agrees");
        assert_eq!(always(&diagnosis(-1.0, -2.0))["findings"][0]["effect"], "a");
        assert_eq!(always(&json!({"candidates": []}))["verdict"], "agrees");
    }
}
