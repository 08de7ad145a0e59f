//! Numbers that a diagnosis states, beside what was drawn: of the sensor and of effects.
//!
//! Limits: a number counts where the recording says more of it than was known beforehand; of an effect's, those that generator and tool define alike (`ALIKE`).

use serde::Serialize;
use serde_json::Value;
use std::collections::BTreeMap;

/// Share of what was known beforehand from which on a recording says nothing of a number.
const LEARNED: f64 = 0.8;

/// Names of one number of the sensor: as stated, as in an answer of this generator, as in a shared truth.
const SENSOR: [[&str; 3]; 9] = [
    ["young_rtv", "young_rtv", "e_rtv"],
    ["softening_rtv", "softening", "kse"],
    ["height_rtv", "height_rtv", "h_rtv"],
    ["thickness_copper", "height_cu", "h_cu"],
    ["thickness_tin", "height_sn", "h_sn"],
    ["thickness_polyimide", "height_pa", "h_pa"],
    ["bead_diameter", "bead_diameter", "bead_d"],
    ["electrode_diameter", "plate_diameter", "d_el"],
    ["stray_capacitance", "stray", "c_stray"],
];

/// Effect, number as stated, its power, and as concealed, here or in a shared truth, each with its factor to what is stated.
type Alike = (&'static str, &'static str, i32, &'static [(&'static str, f64)]);

/// Numbers of effects that mean the same on both sides, for all that the laws differ. Truths count how late the reading is, the tool how late the load.
const ALIKE: [Alike; 6] = [
    ("readout_lag", "tau", 1, &[("delay_s", 1.0), ("tau", 1.0)]),
    ("time_offset", "late", 1, &[("response_late_s", -1.0), ("s", -1.0)]),
    ("trapped_air_stiffness", "tau", 1, &[("leak_time_s", 1.0), ("tau", 1.0)]),
    ("eccentric_load", "arm_squared", 2, &[("offset_over_radius", 1.0)]),
    ("parasitic_capacitance", "stray", 1, &[("capacitance_pf", 1.0)]),
    ("electrode_warp", "factor", 1, &[("share_of_free_curvature", 1.0)]),
];

/// Numbers by name: of the sensor, and `effect.number` of effects, in the units and under the names that a diagnosis states.
pub type Drawn = BTreeMap<String, f64>;

/// What was drawn: `sensor` and `parameters` of an answer or of a shared truth.
pub fn drawn(sensor: &Value, parameters: &Value) -> Drawn {
    let pf = |name: &str, value: f64| if name == "stray_capacitance" { value * 1e12 } else { value };
    let own = SENSOR.iter().filter_map(|[stated, here, shared]| {
        let value = sensor[here].as_f64().or_else(|| sensor[shared].as_f64())?;
        Some(((*stated).to_owned(), pf(stated, value)))
    });
    let of_effects = ALIKE.iter().filter_map(|(effect, stated, power, concealed)| {
        let value = concealed.iter().find_map(|(name, factor)| Some(factor * parameters[effect][name].as_f64()?))?;
        Some((format!("{effect}.{stated}"), value.powi(*power)))
    });
    own.chain(of_effects).collect()
}

/// One number that a diagnosis states, beside what was drawn.
#[derive(Debug, Clone, PartialEq, Serialize)]
pub struct Number {
    /// Its name; that of an effect's with the effect before it.
    pub name: String,
    /// Whether it is an effect's.
    pub of_effect: bool,
    /// Stated less drawn, in stated standard deviations.
    pub off: f64,
}

/// Every number that is stated, was drawn and was learned of.
pub fn numbers(drawn: &Drawn, diagnosis: &Value) -> Vec<Number> {
    let list = |value: &Value| value.as_array().cloned().unwrap_or_default();
    let mut found = Vec::new();
    let mut add = |name: String, stated: &Value, of_effect: bool| {
        let number = |key: &str| stated[key].as_f64();
        let (Some(value), Some(sd), Some(truth)) = (number("value"), number("sd"), drawn.get(&name)) else { return };
        let before = stated["prior"][1].as_f64().unwrap_or(f64::INFINITY);
        let told = number("sd_of_fit").unwrap_or(sd) < LEARNED * before && stated["at_limit"] != Value::Bool(true);
        if told && sd > 0.0 {
            found.push(Number { name, of_effect, off: (value - truth) / sd });
        }
    };
    for stated in list(&diagnosis["base"]["parameters_after"]) {
        add(stated["name"].as_str().unwrap_or_default().to_owned(), &stated, false);
    }
    for finding in list(&diagnosis["findings"]) {
        let effect = finding["effect"].as_str().unwrap_or_default();
        for stated in list(&finding["parameters"]) {
            add(format!("{effect}.{}", stated["name"].as_str().unwrap_or_default()), &stated, true);
        }
    }
    found
}

#[cfg(test)]
mod tests {
    use super::*;
    use serde_json::json;

    #[test]
    fn a_number_counts_where_it_was_learned_of_and_in_its_stated_unit() {
        let drawn = drawn(
            &json!({"young_rtv": 1.1e6, "h_rtv": 160e-6, "stray": 1e-13}),
            &json!({"eccentric_load": {"offset_over_radius": 0.5}, "ageing": {"onset_s": 3.0}}),
        );
        assert_eq!(
            drawn.keys().collect::<Vec<_>>(),
            ["eccentric_load.arm_squared", "height_rtv", "stray_capacitance", "young_rtv"]
        );
        let stated = |name: &str, value: f64, sd: f64, fit: f64, prior: f64| json!({"name": name, "value": value, "sd": sd, "sd_of_fit": fit, "prior": [0.0, prior], "at_limit": false});
        let diagnosis = json!({
            "base": {"parameters_after": [stated("young_rtv", 1.05e6, 2e4, 1e4, 5e4), stated("stray_capacitance", 0.3, 0.29, 0.29, 0.3)]},
            "findings": [{"effect": "eccentric_load", "parameters": [stated("arm_squared", 0.26, 0.02, 0.02, 0.1)]}],
        });
        let found = numbers(&drawn, &diagnosis);
        let told: Vec<(&str, f64)> = found.iter().map(|n| (n.name.as_str(), (n.off * 1e9).round() / 1e9)).collect();
        assert_eq!(told, [("young_rtv", -2.5), ("eccentric_load.arm_squared", 0.5)]);
    }
}
