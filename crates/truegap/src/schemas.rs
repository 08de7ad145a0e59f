//! JSON Schemas of every file and output, as `docs/schemas` holds them.
//!
//! Limits: texts; they are written from the types by `cargo run -p truegap-schemas`, whose tests hold real files and outputs against them.

use truegap_core::nearest::nearest;

/// A schema, and what it describes.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Schema {
    /// name
    pub name: &'static str,
    /// JSON, draft 2020-12
    pub text: &'static str,
}

macro_rules! schemas {
    ($($name:literal)*) => {
        /// All schemas, in alphabetical order.
        pub const SCHEMAS: &[Schema] = &[$(Schema { name: $name, text: include_str!(concat!("../../../docs/schemas/", $name, ".json")) }),*];
    };
}

schemas! {
    "audit" "audit-space" "case" "coefficients" "compensation" "confirmation" "diagnosis" "explain" "export" "firmware" "mechanism" "mesh" "model" "optimise" "prove" "recording" "sensitivity"
    "sensor" "sensors" "simulate" "simulate-drive" "simulate-model" "solve" "space" "tolerance"
}

/// No schema has that name.
#[derive(Debug, thiserror::Error)]
#[error("there is no schema `{name}`; {hint}`truegap schema` lists them")]
pub struct UnknownSchema {
    /// the name
    pub name: String,
    /// what may have been meant
    pub hint: String,
}

/// The schema of this name.
///
/// # Errors
/// [`UnknownSchema`] names the closest.
pub fn schema(name: &str) -> Result<Schema, UnknownSchema> {
    let found = SCHEMAS.iter().find(|schema| schema.name == name.trim_end_matches(".json"));
    found.copied().ok_or_else(|| {
        let close: Vec<String> = nearest(name, SCHEMAS.iter().map(|s| s.name)).iter().map(|near| format!("`{near}`")).collect();
        let hint = if close.is_empty() { String::new() } else { format!("did you mean {}? ", close.join(" or ")) };
        UnknownSchema { name: name.to_owned(), hint }
    })
}

impl Schema {
    /// What it describes: its own `description`.
    pub fn says(&self) -> String {
        let parsed: Option<serde_json::Value> = serde_json::from_str(self.text).ok();
        parsed.and_then(|schema| schema["description"].as_str().map(str::to_owned)).unwrap_or_default()
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn every_schema_of_the_folder_is_built_in() {
        let folder = concat!(env!("CARGO_MANIFEST_DIR"), "/../../docs/schemas");
        let files = std::fs::read_dir(folder).unwrap().map(|entry| entry.unwrap().file_name().into_string().unwrap());
        let mut names: Vec<String> = files.filter_map(|file| file.strip_suffix(".json").map(str::to_owned)).collect();
        names.sort();
        assert_eq!(names, SCHEMAS.iter().map(|schema| schema.name).collect::<Vec<_>>());
        assert!(SCHEMAS.iter().all(|schema| schema.says().len() > 10));
    }

    #[test]
    fn a_misspelt_schema_is_answered_with_the_nearest() {
        assert!(schema("diagnosys").unwrap_err().to_string().contains("`diagnosis`"));
    }
}
