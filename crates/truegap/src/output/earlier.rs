//! Whether a folder holds what this program wrote: one of its documents, known by the schema that it carries.
//!
//! Limits: a file that somebody put beside such a document under the name of another result counts as one.

use serde::Deserialize;
use std::path::Path;

/// Documents, one of which every folder of results holds.
const DOCUMENTS: [&str; 8] = [
    "diagnosis.json",
    "confirmation.json",
    "audit.json",
    "audit-space.json",
    "sensitivity.json",
    "tolerance.json",
    "optimise.json",
    "sweep.json",
];

/// What every document begins with.
#[derive(Deserialize)]
struct Document {
    schema: String,
}

/// Whether `folder` holds a document of this program.
pub(super) fn holds_a_result(folder: &Path) -> bool {
    DOCUMENTS.iter().any(|name| is_document(&folder.join(name)))
}

fn is_document(file: &Path) -> bool {
    let text = truegap_limits::read_text(file).ok();
    let document = text.and_then(|text| serde_json::from_str::<Document>(&text).ok());
    document.is_some_and(|document| document.schema.starts_with("truegap."))
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_document_is_known_by_its_schema_and_not_by_its_name() {
        let folder = tempfile::tempdir().unwrap();
        let holds = || holds_a_result(folder.path());
        let file = folder.path().join("diagnosis.json");
        assert!(!holds());
        for foreign in ["", "{", "[]", "{\"schema\": \"somebody.else/1\"}", "{\"schema\": 1}", "{\"verdict\": \"agrees\"}"] {
            std::fs::write(&file, foreign).unwrap();
            assert!(!holds(), "{foreign}");
        }
        std::fs::write(&file, "{\"schema\": \"truegap.diagnosis/1\", \"verdict\": \"agrees\"}").unwrap();
        assert!(holds());
        std::fs::remove_file(&file).unwrap();
        std::fs::create_dir(&file).unwrap();
        assert!(!holds());
    }
}
