//! Whether the numbers of a mechanism's file stand in the units that its words give them.
//!
//! Limits: nothing is converted; what follows a column that was not recorded is not looked at, since it is not tried.

use crate::effects::composed::{
    file::{Known, MechanismError, MechanismFile},
    signal::recorded,
    units::{Surroundings, number_unit},
    words::Driver,
};
use truegap_core::{Dimension, Inputs};

impl MechanismFile {
    /// Refuses a number in another unit than the recording gives it, `reading` being that of the response.
    ///
    /// # Errors
    /// [`MechanismError::Unit`] names the number, what was found, and what is expected.
    pub fn check_units(&self, inputs: &Inputs, reading: &str) -> Result<(), MechanismError> {
        if let Driver::Recorded(name) | Driver::RateOf(name) = &self.sentence.driver
            && !recorded(inputs).iter().any(|(known, ..)| known == name)
        {
            return Ok(());
        }
        let used = self.sentence.needs();
        let is_used = |name: &str| matches!(name, "phase" | "turn") || used.iter().any(|(used, _)| *used == name);
        let inner = self.numbers().into_iter().filter_map(|(name, known, _)| Some((name, known.as_ref()?)));
        let numbers = std::iter::once(("size", &self.size)).chain(inner.filter(|(name, _)| is_used(name)));
        for (name, known) in numbers {
            let wanted = number_unit(name, &self.sentence, Surroundings { inputs, reading });
            if plain(&known.unit) != plain(&wanted) {
                let found = if known.unit.is_empty() { "has no unit".to_owned() } else { format!("is in `{}`", known.unit) };
                let remedy = remedy(name, known, &wanted);
                return Err(MechanismError::Unit { name, found, wanted, remedy });
            }
        }
        Ok(())
    }
}

/// A unit as it is compared: without blanks, without brackets that change nothing, a kelvin for a degree; nothing where it is a pure number.
fn plain(unit: &str) -> String {
    let mut unit: String = unit.split_whitespace().collect::<String>().replace("^exponent", "").replace(['·', '*'], "");
    for (other, name) in [("°C", "K"), ("degC", "K"), ("µ", "u"), ("μ", "u"), ("loads", "load"), ("gaps", "gap"), ("²", "^2")]
    {
        unit = unit.replace(other, name);
    }
    while let Some((at, end)) = brackets(&unit) {
        unit = format!("{}{}{}", &unit[..at], &unit[at + 1..end], &unit[end + 1..]);
    }
    if matches!(unit.as_str(), "1" | "-") { String::new() } else { unit }
}

/// The first brackets with no fraction in them.
fn brackets(unit: &str) -> Option<(usize, usize)> {
    unit.match_indices('(').find_map(|(at, _)| {
        let length = unit[at + 1..].find(['(', ')', '/'])?;
        unit[at + 1 + length..].starts_with(')').then_some((at, at + 1 + length))
    })
}

/// What to write.
fn remedy(name: &str, known: &Known, wanted: &str) -> String {
    let seconds = Dimension::Time.to_si(known.value, &known.unit).ok().filter(|_| wanted == "s" && known.value != 0.0);
    match seconds {
        Some(seconds) => {
            format!("{} {} are {seconds} s: write {name} = {{ value = {seconds}, ..., unit = \"s\" }}", known.value, known.unit)
        }
        None => format!("give its value and sd in that unit and write unit = \"{wanted}\""),
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn units_are_compared_as_a_reader_would() {
        for (a, b) in [
            ("unloaded gap/(K/s)", "unloaded gap / (°C/s)"),
            ("pF/(V)", "pF/V"),
            ("", "1"),
            ("1/(full load)", "1/full load"),
            ("pF/(V)^exponent", "pF/V"),
        ] {
            assert_eq!(plain(a), plain(b));
        }
        for (a, b) in [("unloaded gap/(K/s)", "unloaded gap/K/s"), ("s", "min"), ("pF/V", "fF/V"), ("", "s")] {
            assert_ne!(plain(a), plain(b));
        }
    }

    #[test]
    fn a_number_in_another_unit_is_refused_with_the_right_one() {
        let text = r#"
            schema = "truegap.mechanism/1"
            id = "gap_follows_heating"
            quantity = "gap"
            action = "adds"
            driver = "temperature_rate"
            kinetics = "first_order"
            form = "linear"
            size = { sd = 0.5, unit = "unloaded gap/(K/s)" }
            tau = { value = 30.0, sd = 20.0, unit = "s" }
        "#;
        let inputs = Inputs::default();
        let told = |from: &str, to: &str| {
            let file: MechanismFile = toml::from_str(&text.replace(from, to)).unwrap();
            file.check_units(&inputs, "pF").err().map(|error| error.to_string()).unwrap_or_default()
        };
        assert_eq!(told("", ""), "");
        let minutes = told("unit = \"s\"", "unit = \"min\"");
        assert!(minutes.contains("tau is in `min`") && minutes.contains("30 min are 1800 s"), "{minutes}");
        let none = told(", unit = \"s\"", "");
        assert!(none.contains("tau has no unit") && none.contains("`s`"), "{none}");
        let other = told("unloaded gap/(K/s)", "um/K");
        assert!(other.contains("size is in `um/K`") && other.contains("`unloaded gap/(K/s)`"), "{other}");
        let turn = told("tau =", "turn = { value = 360.0, unit = \"deg\" }\n            tau =");
        assert!(turn.contains("turn is in `deg`") && turn.contains("`K/s`"), "{turn}");
        // a column that was not recorded has no unit, and what follows it is not tried
        assert_eq!(told("\"temperature_rate\"", "{ recorded = \"supply\" }"), "");
    }
}
