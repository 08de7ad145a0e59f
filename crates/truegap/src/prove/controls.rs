//! What a simpler rule would have said of the same fits.
//!
//! Limits: rules over the single candidates in `diagnosis.json`; none refits.

use serde_json::{Value, json};

/// A rule that makes claims from the candidates of a diagnosis.
pub(super) struct Rule {
    pub(super) says: &'static str,
    pub(super) claims: fn(&Value) -> Value,
}

/// The rules scored beside the diagnosis.
pub(super) const RULES: [Rule; 3] = [
    Rule {
        says: "BIC: names the single effect of the lowest chi2 + k ln(rows), where that is below none's; no prior, no lack-of-fit tests, no pairs",
        claims: lowest_bic,
    },
    Rule {
        says: "best single evidence: names the effect of the highest log evidence where that beats none; no prior for how many were tried, no lack-of-fit tests",
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

/// Schwarz's criterion over the single effects.
fn lowest_bic(diagnosis: &Value) -> Value {
    let rows = diagnosis["recording"]["rows"].as_f64().unwrap_or(1.0);
    let gain = |c: &Value| Some(c["chi2_drop"].as_f64()? - c["freedom"].as_f64()? * rows.ln());
    let candidates = diagnosis["candidates"].as_array().into_iter().flatten();
    let best = candidates.filter_map(|c| Some((c["effect"].as_str()?, gain(c)?))).max_by(|a, b| a.1.total_cmp(&b.1));
    match best {
        Some((effect, gain)) if gain > 0.0 => named(effect),
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
        // 1000 rows: a parameter must gain 6.9
        let fitted = |drop: f64| {
            json!({"recording": {"rows": 1000}, "candidates": [
            {"effect": "a", "chi2_drop": drop, "freedom": 1}, {"effect": "b", "chi2_drop": drop + 5.0, "freedom": 2}]})
        };
        assert_eq!(lowest_bic(&fitted(6.0))["verdict"], "agrees");
        assert_eq!(lowest_bic(&fitted(8.0))["findings"][0]["effect"], "a");
    }
}
