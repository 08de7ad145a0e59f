//! One text for one value: JSON with sorted keys and no spaces, and its SHA-256.
//!
//! Limits: numbers as the shortest decimal that reads back to the same bits; not a number and infinity are refused, not written as null.

use crate::error::SweepError;
use serde::Serialize;
use serde_json::Value;
use sha2::{Digest, Sha256};
use std::fmt::Write;

/// The value as JSON, every object's keys sorted.
///
/// # Errors
/// [`SweepError::Unwritable`] for what JSON cannot hold: keys that are no strings, `null` where a number is not finite.
pub(crate) fn canonical(value: &impl Serialize) -> Result<String, SweepError> {
    let mut value = serde_json::to_value(value).map_err(|source| SweepError::Unwritable { reason: source.to_string() })?;
    if let Some(path) = null(&value, "") {
        return Err(SweepError::Unwritable { reason: format!("`{path}` is null: a number that is not finite, or no value") });
    }
    value.sort_all_objects();
    Ok(value.to_string())
}

/// SHA-256 in hexadecimal.
pub(crate) fn sha256(text: &str) -> String {
    Sha256::digest(text.as_bytes()).iter().fold(String::with_capacity(64), |mut out, byte| {
        let _ = write!(out, "{byte:02x}"); // a String takes everything
        out
    })
}

/// Path of the first null.
fn null(value: &Value, path: &str) -> Option<String> {
    match value {
        Value::Null => Some(path.trim_start_matches('.').to_owned()),
        Value::Array(items) => items.iter().enumerate().find_map(|(i, item)| null(item, &format!("{path}.{i}"))),
        Value::Object(fields) => fields.iter().find_map(|(key, field)| null(field, &format!("{path}.{key}"))),
        _ => None,
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use serde_json::json;

    #[test]
    fn the_order_of_keys_changes_nothing() {
        let (a, b) = (json!({"b": [1, {"y": 2.5, "x": "t"}], "a": true}), json!({"a": true, "b": [1, {"x": "t", "y": 2.5}]}));
        assert_eq!(canonical(&a).unwrap(), r#"{"a":true,"b":[1,{"x":"t","y":2.5}]}"#);
        assert_eq!(canonical(&a).unwrap(), canonical(&b).unwrap());
    }

    #[test]
    fn a_number_that_json_cannot_hold_is_refused_by_its_path() {
        let told = canonical(&[[1.0, f64::NAN]]).unwrap_err().to_string();
        assert!(told.contains("`0.1`"), "{told}");
    }

    #[test]
    fn the_hash_is_that_of_the_standard() {
        // FIPS 180-2, appendix B.1
        assert_eq!(sha256("abc"), "ba7816bf8f01cfea414140de5dae2223b00361a396177a9cb410ff61f20015ad");
    }
}
