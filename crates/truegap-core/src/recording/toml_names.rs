//! Names of columns as texts and keys of a TOML.
//!
//! Limits: what a name means is not looked at.

use super::{roles::ROLES, words::without_accents};

/// A text as TOML writes it.
pub(super) fn toml_text(text: &str) -> String {
    toml::Value::from(text).to_string()
}

/// A name as a key of TOML, in quotes where it needs them.
pub(super) fn toml_key(name: &str) -> String {
    let is_plain = !name.is_empty() && name.chars().all(|c| c.is_ascii_alphanumeric() || matches!(c, '_' | '-'));
    if is_plain { name.to_owned() } else { toml_text(name) }
}

/// A name that TOML takes without quotes.
pub(super) fn plain(name: &str, index: usize) -> String {
    let sign = |c: char| if c.is_ascii_alphanumeric() { c } else { '_' };
    let plain: String = without_accents(name).chars().map(sign).collect();
    let words: Vec<&str> = plain.split('_').filter(|word| !word.is_empty()).collect();
    // a role's word is no name of a driver
    match words.join("_") {
        name if name.is_empty() || ROLES.iter().any(|role| role.key() == name) => format!("column_{}", index + 1),
        name => name,
    }
}

/// `name`, or that with a number where it is taken.
pub(super) fn free(name: &str, taken: &[String]) -> String {
    let numbered = (2..).map(|number| format!("{name}_{number}"));
    let mut names = std::iter::once(name.to_owned()).chain(numbered);
    names.find(|name| !taken.contains(name)).unwrap_or_default()
}
