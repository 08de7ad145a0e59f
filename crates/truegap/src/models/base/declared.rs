//! Parameters and program of a `command`, as they stand under `[base]` of a recording's TOML.
//!
//! Limits: priors are Gaussian; what a parameter means beyond its unit is for the one who declares it.

use std::path::Path;
use truegap_core::nearest::instead;
use truegap_core::units::{Dimension, parse};
use truegap_core::{Parameter, Prior};
use truegap_model::{Asked, Who};

/// Longest time that an answer may take where none is given, s.
const TIMEOUT_S: f64 = 60.0;
/// What may stand in a parameter.
pub(super) const EXAMPLE: &str =
    "k = { value = 2.0, sd = 0.3, unit = \"N/mm\", low = 0.0, high = 10.0, meaning = \"stiffness\" }";

/// Keys of a parameter.
const KEYS: [&str; 6] = ["value", "sd", "unit", "low", "high", "meaning"];
/// Other words for them.
const OTHER_WORDS: [(&str, &str); 16] = [
    ("min", "low"),
    ("minimum", "low"),
    ("lower", "low"),
    ("max", "high"),
    ("maximum", "high"),
    ("upper", "high"),
    ("std", "sd"),
    ("sigma", "sd"),
    ("stdev", "sd"),
    ("uncertainty", "sd"),
    ("mean", "value"),
    ("start", "value"),
    ("initial", "value"),
    ("guess", "value"),
    ("name", "meaning"),
    ("description", "meaning"),
];

/// Why `[base]` declares no program.
#[derive(Clone, Debug, PartialEq)]
pub(super) enum Undeclared {
    /// a word that means nothing, and what may stand there
    Word { key: &'static str, use_: String },
    /// a key that means nothing, in its table
    Key { table: String, key: String, instead: String },
    /// a parameter that cannot be
    Parameter { name: String, why: String },
}

fn word(key: &'static str, use_: &str) -> Undeclared {
    Undeclared::Word { key, use_: use_.to_owned() }
}

/// The program that `[base]` names and its parameters; `folder` is the TOML's own.
///
/// # Errors
/// [`Undeclared`] says what cannot be, and what may stand there.
pub(super) fn command(base: &toml::Table, folder: &Path) -> Result<Option<Asked>, Undeclared> {
    let Some(run) = base.get("run") else { return Ok(None) };
    let words = run.as_array().map(|list| list.iter().map(|word| word.as_str().map(str::to_owned)).collect());
    let words: Option<Vec<String>> = words.unwrap_or_default();
    let run = words.filter(|words| !words.is_empty()).ok_or_else(|| word("run", "[\"python3\", \"sim.py\"]"))?;
    let timeout_s = match base.get("timeout") {
        None => TIMEOUT_S,
        Some(text) => {
            let seconds = text.as_str().and_then(|text| parse(text, Dimension::Time).ok()).filter(|s| *s > 0.0);
            seconds.ok_or_else(|| word("timeout", "a time, as in timeout = \"60 s\""))?
        }
    };
    let inside = match base.get("inside") {
        None => false,
        Some(value) => value.as_bool().ok_or_else(|| word("inside", "true or false"))?,
    };
    let parameters = base.get("parameters").map_or(Ok(Vec::new()), parameters)?;
    Ok(Some(Asked { who: Who::Command { run, folder: folder.to_owned(), timeout_s }, parameters, inside }))
}

fn parameters(value: &toml::Value) -> Result<Vec<Parameter>, Undeclared> {
    let wrong = || word("parameters", &format!("a table with one line a parameter, as in {EXAMPLE}"));
    let table = value.as_table().ok_or_else(wrong)?;
    table.iter().map(|(name, value)| parameter(name, value)).collect()
}

fn parameter(name: &str, value: &toml::Value) -> Result<Parameter, Undeclared> {
    let wrong = |why: &str| Undeclared::Parameter { name: name.to_owned(), why: why.to_owned() };
    let table = value.as_table().ok_or_else(|| wrong("is no table"))?;
    if let Some(key) = table.keys().find(|key| !KEYS.contains(&key.as_str())) {
        let table = format!("[base.parameters], {name}");
        return Err(Undeclared::Key { table, key: key.clone(), instead: instead(key, &OTHER_WORDS, &KEYS) });
    }
    let number = |key: &str| match table.get(key) {
        None => Ok(None),
        Some(v) => v
            .as_float()
            .or_else(|| v.as_integer().map(|v| v as f64))
            .map(Some)
            .ok_or_else(|| wrong(&format!("has a {key} that is no number"))),
    };
    let text = |key: &str| match table.get(key) {
        None => Ok(""),
        Some(value) => value.as_str().ok_or_else(|| wrong(&format!("has a {key} that is no text"))),
    };
    let value = number("value")?.ok_or_else(|| wrong("has no value"))?;
    let sd = number("sd")?.ok_or_else(|| wrong("has no sd, the standard deviation of what is known of it"))?;
    let bounds = (number("low")?.unwrap_or(f64::NEG_INFINITY), number("high")?.unwrap_or(f64::INFINITY));
    declared(name, text("unit")?, value, sd, bounds, text("meaning")?).map_err(|why| wrong(&why))
}

/// A parameter with a Gaussian prior inside bounds.
///
/// # Errors
/// Why there is no such parameter, as the end of a sentence that begins with its name.
pub fn declared(name: &str, unit: &str, value: f64, sd: f64, bounds: (f64, f64), meaning: &str) -> Result<Parameter, String> {
    if name.is_empty() || name.contains(|c: char| c.is_whitespace() || c == '=') {
        return Err("has a name with a blank or `=` in it, or none".to_owned());
    }
    if !(value.is_finite() && sd.is_finite() && sd > 0.0) {
        return Err(format!("has value {value} and sd {sd}; give a finite value and an sd above 0"));
    }
    if !(bounds.0 <= value && value <= bounds.1) {
        return Err(format!("has value {value} outside of low {} and high {}", bounds.0, bounds.1));
    }
    let meaning = if meaning.is_empty() { format!("`{name}` of the simulator") } else { meaning.to_owned() };
    Ok(Parameter { name: name.into(), unit: unit.into(), prior: Prior::Normal { mean: value, sd }, bounds, meaning })
}

#[cfg(test)]
mod tests {
    use super::*;

    fn read(text: &str) -> Result<Option<Asked>, Undeclared> {
        command(&text.parse().unwrap(), Path::new("bench"))
    }

    #[test]
    fn a_program_is_read_with_its_parameters() {
        let asked = read(
            "run = ['./sim', '-q']\ntimeout = '2 min'\ninside = true\n[parameters]\nk = { value = 2, sd = 0.3, unit = 'N/mm', low = 0 }\n",
        );
        let asked = asked.unwrap().unwrap();
        let run = vec!["./sim".to_owned(), "-q".to_owned()];
        assert!(asked.inside);
        assert_eq!(asked.who, Who::Command { run, folder: "bench".into(), timeout_s: 120.0 });
        let k = &asked.parameters[0];
        assert_eq!(
            (k.name.as_str(), k.unit.as_str(), k.centre(), k.sd(), k.bounds),
            ("k", "N/mm", 2.0, 0.3, (0.0, f64::INFINITY))
        );
        assert_eq!(read("order = 2\n"), Ok(None));
    }

    #[test]
    fn what_means_nothing_is_told_by_name() {
        let fails = |text: &str| read(text).unwrap_err();
        let key = |text: &str| match fails(text) {
            Undeclared::Word { key, .. } => key,
            other => panic!("{other:?}"),
        };
        assert_eq!(key("run = 'sim'"), "run");
        assert_eq!(key("run = ['sim']\ntimeout = 5"), "timeout");
        assert_eq!(key("run = ['sim']\ninside = 1"), "inside");
        let why = |inner: &str| match fails(&format!("run = ['sim']\nparameters = {{ k = {inner} }}")) {
            Undeclared::Parameter { name, why } => format!("`{name}` {why}"),
            Undeclared::Key { table, key, instead } => format!("{table} {key}: {instead}"),
            other => panic!("{other:?}"),
        };
        assert!(why("2.0").contains("`k` is no table"));
        assert!(why("{ value = 1.0 }").contains("no sd"));
        assert!(why("{ value = 1.0, sd = 0.0 }").contains("above 0"));
        assert!(why("{ value = 1.0, sd = 1.0, low = 2.0 }").contains("outside of low 2"));
        for (key, meant) in
            [("std", "sd"), ("vaule", "value"), ("units", "unit"), ("min", "low"), ("hihg", "high"), ("meanign", "meaning")]
        {
            let told = why(&format!("{{ value = 1.0, sd = 1.0, {key} = 3.0 }}"));
            let wanted =
                format!("[base.parameters], k {key}: did you mean `{meant}`? known there: value, sd, unit, low, high, meaning");
            assert_eq!(told, wanted);
        }
    }
}
