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

/// Whether `folder` holds a document of this program, or one that was about to take its name when the process was killed.
pub(super) fn holds_a_result(folder: &Path) -> bool {
    let mut names = std::fs::read_dir(folder).into_iter().flatten().filter_map(|entry| entry.ok().map(|entry| entry.file_name()));
    names.any(|name| {
        let name = name.to_string_lossy();
        let part =
            |document: &str| name.strip_prefix(document).is_some_and(|rest| rest.starts_with('.') && rest.ends_with(".part"));
        DOCUMENTS.iter().any(|document| name == *document || part(document)) && is_document(&folder.join(name.as_ref()))
    })
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
        // killed before it took its name
        std::fs::rename(&file, folder.path().join("diagnosis.json.17.part")).unwrap();
        assert!(holds());
        std::fs::rename(folder.path().join("diagnosis.json.17.part"), folder.path().join("diagnosis.json.mine")).unwrap();
        assert!(!holds());
        std::fs::rename(folder.path().join("diagnosis.json.mine"), &file).unwrap();
        std::fs::remove_file(&file).unwrap();
        std::fs::create_dir(&file).unwrap();
        assert!(!holds());
    }
}
