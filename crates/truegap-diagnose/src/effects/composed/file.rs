//! A mechanism as TOML: an effect of one's own in fifteen lines, and what a diagnosis has discovered.
//!
//! ```toml
//! schema = "truegap.mechanism/1"
//! id = "gap_follows_heating"
//! says = "the stack bends while it heats"
//! quantity = "gap"
//! action = "adds"
//! driver = "temperature_rate"
//! kinetics = "first_order"
//! form = "linear"
//! size = { value = 0.0, sd = 0.5, unit = "unloaded gap/(K/s)" }
//! tau = { value = 30.0, sd = 20.0, unit = "s" }
//! ```
//!
//! Limits: priors of positive numbers (tau, width, scale, period, turn) are Gaussian in the logarithm, all others plain.

use crate::effects::composed::{
    effect::Composed,
    mechanism::{Numbers, Sentence},
};
use serde::{Deserialize, Serialize};
use truegap_core::{EffectId, Parameter};

/// Identifier of the file format.
pub const SCHEMA: &str = "truegap.mechanism/1";

/// A number with what is known of it.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
#[serde(deny_unknown_fields)]
pub struct Known {
    /// most probable value
    #[serde(default)]
    pub value: f64,
    /// standard deviation; a number without one is not free
    #[serde(default)]
    pub sd: f64,
    /// unit, for a reader
    #[serde(default)]
    pub unit: String,
}

/// The file.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
pub struct MechanismFile {
    /// always [`SCHEMA`]
    pub schema: String,
    /// stable name: small letters, digits and underlines
    pub id: String,
    /// what a reader is told of it
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub says: Option<String>,
    /// the words
    #[serde(flatten)]
    pub sentence: Sentence,
    /// change of the quantity per unit of what it follows
    pub size: Known,
    /// time constant, s
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub tau: Option<Known>,
    /// half width of a loop, driver's unit
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub width: Option<Known>,
    /// threshold, driver's unit; moment of an event, s
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub threshold: Option<Known>,
    /// exponent
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub exponent: Option<Known>,
    /// where it levels off, driver's unit
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub scale: Option<Known>,
    /// period, driver's unit
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub period: Option<Known>,
    /// phase, rad
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub phase: Option<Known>,
    /// a whole turn of a driver that is an angle, driver's unit
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub turn: Option<Known>,
}

/// Why a mechanism's file says nothing that can be fitted.
#[derive(Clone, Debug, PartialEq, thiserror::Error)]
#[non_exhaustive]
#[allow(missing_docs)] // the fields are named by the messages
pub enum MechanismError {
    /// Another kind of file.
    #[error("schema is `{found}`; a mechanism's is `{SCHEMA}`")]
    Schema { found: String },
    /// An id that cannot stand in files.
    #[error("id is `{id}`; use small letters, digits and underlines, beginning with a letter")]
    Id { id: String },
    /// A number that cannot be.
    #[error("{name} has value {value} and sd {sd}; {wanted}")]
    Number { name: &'static str, value: f64, sd: f64, wanted: &'static str },
    /// A number in another unit.
    #[error("{name} {found}, and these words have it in `{wanted}`; {remedy}")]
    Unit { name: &'static str, found: String, wanted: String, remedy: String },
    /// A number that the words need.
    #[error("the words `{words}` need {name}; add {name} = {{ value = ..., sd = ..., unit = \"...\" }}")]
    Missing { name: &'static str, words: &'static str },
}

/// Numbers that are positive.
const POSITIVE: [&str; 5] = ["tau", "width", "scale", "period", "turn"];

impl MechanismFile {
    pub(crate) fn numbers(&self) -> [(&'static str, &Option<Known>, &'static str); 8] {
        [
            ("tau", &self.tau, "time constant"),
            ("width", &self.width, "half width of the loop"),
            ("threshold", &self.threshold, "where it begins"),
            ("exponent", &self.exponent, "exponent of the law"),
            ("scale", &self.scale, "where it levels off"),
            ("period", &self.period, "period"),
            ("phase", &self.phase, "phase at 0"),
            ("turn", &self.turn, "a whole turn"),
        ]
    }

    /// The effect that it describes.
    ///
    /// # Errors
    /// [`MechanismError`] where a word lacks its number, or a number cannot be.
    pub fn effect(&self) -> Result<Composed, MechanismError> {
        self.check()?;
        let mut parameters = vec![Parameter::normal(
            "size",
            &self.size.unit,
            0.0,
            self.size.sd,
            "change of the quantity per unit of what it follows",
        )];
        let mut start = Numbers::default();
        for (name, known, meaning) in self.numbers() {
            let Some(known) = known else { continue };
            start = start.with(std::iter::once((name, known.value))).0;
            if known.sd > 0.0 {
                parameters.push(parameter(name, known, meaning));
            }
        }
        // ids live as long as the program: a file is read once
        let id = EffectId(Box::leak(self.id.clone().into_boxed_str()));
        Ok(Composed { id, sentence: self.sentence.clone(), start, parameters, says: self.says.clone() })
    }

    fn check(&self) -> Result<(), MechanismError> {
        if self.schema != SCHEMA {
            return Err(MechanismError::Schema { found: self.schema.clone() });
        }
        let plain = |c: char| c.is_ascii_lowercase() || c.is_ascii_digit() || c == '_';
        if !self.id.starts_with(|c: char| c.is_ascii_lowercase()) || !self.id.chars().all(plain) {
            return Err(MechanismError::Id { id: self.id.clone() });
        }
        sound("size", &self.size, self.size.sd > 0.0, "its sd must be above 0: it says how large the effect may be")?;
        for (name, known, _) in self.numbers() {
            let Some(known) = known else { continue };
            let positive = !POSITIVE.contains(&name) || known.value > 0.0;
            sound(
                name,
                known,
                positive && known.sd >= 0.0,
                "give a finite value, above 0 for tau, width, scale, period and turn, and an sd of 0 or more",
            )?;
        }
        match self
            .sentence
            .needs()
            .iter()
            .find(|(name, _)| self.numbers().iter().any(|(n, known, _)| n == name && known.is_none()))
        {
            Some((name, words)) => Err(MechanismError::Missing { name, words }),
            None => Ok(()),
        }
    }

    /// A discovered mechanism as a file: the numbers found with their deviations, the size free again about 0.
    /// `unit` is that of a number by its name.
    pub fn of(composed: &Composed, values: &[(String, f64, f64, String)], unit: impl Fn(&str) -> String) -> Self {
        let known = |name: &str| {
            let (_, value, sd, unit) = values.iter().find(|(n, ..)| n == name)?;
            Some(Known { value: *value, sd: *sd, unit: unit.clone() })
        };
        let mut fixed = composed.start;
        let mut or_fixed = |name: &str| {
            let free = known(name);
            let at = *fixed.by_name(name)?;
            free.or_else(|| (at != 0.0).then(|| Known { value: at, sd: 0.0, unit: unit(name) }))
        };
        let size = known("size").unwrap_or(Known { value: 0.0, sd: 1.0, unit: String::new() });
        let sd = composed.parameters.first().map_or(size.sd, Parameter::sd);
        Self {
            schema: SCHEMA.into(),
            id: composed.sentence.name(),
            says: None,
            tau: or_fixed("tau"),
            width: or_fixed("width"),
            threshold: or_fixed("threshold"),
            exponent: or_fixed("exponent"),
            scale: or_fixed("scale"),
            period: or_fixed("period"),
            phase: or_fixed("phase"),
            turn: or_fixed("turn"),
            size: Known { sd, ..size },
            sentence: composed.sentence.clone(),
        }
    }
}

fn sound(name: &'static str, known: &Known, holds: bool, wanted: &'static str) -> Result<(), MechanismError> {
    let fine = known.value.is_finite() && known.sd.is_finite() && holds;
    if fine { Ok(()) } else { Err(MechanismError::Number { name, value: known.value, sd: known.sd, wanted }) }
}

fn parameter(name: &str, known: &Known, meaning: &str) -> Parameter {
    if POSITIVE.contains(&name) {
        // the log deviation of a log-normal with this mean and standard deviation
        let log_sd = (known.sd / known.value).powi(2).ln_1p().sqrt();
        return Parameter::log_normal(name, &known.unit, known.value, log_sd, meaning)
            .within(known.value * 1e-4, known.value * 1e4);
    }
    Parameter::normal(name, &known.unit, known.value, known.sd, meaning)
}

#[cfg(test)]
mod tests {
    use super::*;

    fn heating() -> MechanismFile {
        toml::from_str(
            r#"
            schema = "truegap.mechanism/1"
            id = "gap_follows_heating"
            quantity = "gap"
            action = "adds"
            driver = "temperature_rate"
            kinetics = "first_order"
            form = "linear"
            size = { sd = 0.5, unit = "unloaded gap/(K/s)" }
            tau = { value = 30.0, sd = 20.0, unit = "s" }
            "#,
        )
        .unwrap()
    }

    #[test]
    fn ten_lines_are_an_effect_with_priors() {
        let effect = heating().effect().unwrap();
        assert_eq!((effect.id.0, effect.parameters.len()), ("gap_follows_heating", 2));
        approx::assert_relative_eq!(effect.parameters[1].centre(), 30.0);
        // a log-normal of median 30 s whose deviation over its mean is 2/3
        approx::assert_relative_eq!(effect.parameters[1].sd(), 30.0 * f64::ln(1.0 + 4.0 / 9.0).sqrt(), max_relative = 1e-12);
    }

    #[test]
    fn a_word_without_its_number_is_named() {
        let file = MechanismFile { tau: None, ..heating() };
        assert!(matches!(file.effect(), Err(MechanismError::Missing { name: "tau", .. })));
        let file = MechanismFile { tau: Some(Known { value: -1.0, sd: 1.0, unit: "s".into() }), ..heating() };
        assert!(file.effect().unwrap_err().to_string().contains("tau has value -1"));
        assert!(matches!(MechanismFile { id: "Gap <b>".into(), ..heating() }.effect(), Err(MechanismError::Id { .. })));
    }

    #[test]
    fn what_is_written_is_read_again() {
        let found = vec![("size".to_owned(), 0.02, 0.001, "u".to_owned()), ("tau".to_owned(), 31.0, 4.0, "s".to_owned())];
        let file = MechanismFile::of(&heating().effect().unwrap(), &found, |_| "K/s".to_owned());
        let again: MechanismFile = toml::from_str(&toml::to_string(&file).unwrap()).unwrap();
        assert_eq!(again, file);
        assert_eq!(again.id, "gap_follows_temperature_rate");
        assert_eq!(again.effect().unwrap().sentence, heating().sentence);
    }
}
