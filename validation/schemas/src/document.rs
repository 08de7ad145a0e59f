//! The documents: which type is the root of which file or output.
//!
//! Limits: CSV, SVG and pages have no schema; the file of a sensor is read by hand, and so is its schema written.

use crate::error::SchemaError;
use crate::index::Index;
use crate::schema::{Schemas, Side};
use serde_json::{Map, Value, json};
use std::path::Path;

/// A file or an output with a schema.
#[derive(Clone, Copy, Debug)]
pub struct Document {
    /// name of the schema
    pub name: &'static str,
    /// what it describes
    pub says: &'static str,
    /// module and name of the type at its root
    root: (&'static str, &'static str),
    side: Side,
    /// what its key `schema` holds, where it has one
    id: Option<&'static str>,
    /// whether it is a list of these
    list: bool,
}

const fn written_as(name: &'static str, says: &'static str, root: (&'static str, &'static str)) -> Document {
    Document { name, says, root, side: Side::Written, id: None, list: false }
}

const fn read_as(name: &'static str, says: &'static str, root: (&'static str, &'static str), id: &'static str) -> Document {
    Document { name, says, root, side: Side::Read, id: Some(id), list: false }
}

impl Document {
    const fn id(self, id: &'static str) -> Self {
        Self { id: Some(id), ..self }
    }

    const fn list(self) -> Self {
        Self { list: true, ..self }
    }
}

/// All documents but the file of a sensor, in alphabetical order.
pub const DOCUMENTS: &[Document] = &[
    written_as("audit", "audit.json, and `truegap --json audit --sensor S`", ("truegap_audit::audit", "Audit"))
        .id("truegap.audit/1"),
    written_as(
        "audit-space",
        "audit-space.json, and `truegap --json audit --space FILE`",
        ("truegap::study::answer::audit", "SpaceAuditAnswer"),
    )
    .id("truegap.audit-space/1"),
    read_as(
        "case",
        "TOML of a case, which `truegap solve` and `truegap mesh` read",
        ("truegap_fem::case::raw", "RawCase"),
        "truegap.case/1",
    ),
    written_as("coefficients", "`truegap --json coefficients`", ("truegap_cli::command::coefficients", "Answer")),
    written_as("compensation", "`truegap --json compensate`", ("truegap::diagnosis::compensate::document", "Compensation"))
        .id("truegap.compensation/1"),
    written_as(
        "confirmation",
        "confirmation.json, and `truegap --json confirm`",
        ("truegap_diagnose::answer::confirmation", "Confirmation"),
    )
    .id("truegap.confirmation/1"),
    written_as(
        "diagnosis",
        "diagnosis.json, and `truegap --json diagnose`",
        ("truegap_diagnose::answer::diagnosis", "Diagnosis"),
    )
    .id("truegap.diagnosis/1"),
    written_as("explain", "`truegap --json explain EFFECT`", ("truegap::diagnosis::explain", "Explained")),
    written_as("export", "`truegap --json export`", ("truegap_cli::command::export", "Answer")),
    written_as("firmware", "`truegap --json firmware`", ("truegap::diagnosis::compensate::firmware::document", "FirmwareFacts"))
        .id("truegap.firmware/1"),
    read_as(
        "mechanism",
        "TOML of an effect of one's own (`--effect FILE`), and discovered.toml",
        ("truegap_diagnose::effects::composed::file", "MechanismFile"),
        "truegap.mechanism/1",
    ),
    written_as("mesh", "`truegap --json mesh`", ("truegap_cli::command::mesh", "Answer")),
    read_as(
        "model",
        "augmented.toml, which `truegap simulate --model`, `truegap confirm` and `truegap compensate` read",
        ("truegap::models::model_file", "ModelFile"),
        "truegap.model/1",
    ),
    written_as(
        "optimise",
        "optimise.json, and `truegap --json optimise`",
        ("truegap::study::answer::optimise", "OptimiseAnswer"),
    )
    .id("truegap.optimise/1"),
    written_as("prove", "score.json, and `truegap --json prove`", ("truegap::prove::result", "Score")),
    read_as(
        "recording",
        "TOML beside the CSV of a recording",
        ("truegap_core::recording::manifest", "Raw"),
        "truegap.recording/1",
    ),
    written_as(
        "sensitivity",
        "sensitivity.json, and `truegap --json sensitivity`",
        ("truegap::study::answer::sensitivity", "SensitivityAnswer"),
    )
    .id("truegap.sensitivity/1"),
    written_as("sensors", "`truegap --json sensors`", ("truegap_cli::command::sensors", "Listed")).list(),
    written_as(
        "simulate",
        "each line of `truegap --json simulate --sensor S --load L`",
        ("truegap_model::stack::states", "State"),
    ),
    written_as(
        "simulate-drive",
        "each line of `truegap --json simulate --sensor S --drive RECORDING`",
        ("truegap::predict::states", "Driven"),
    ),
    written_as("simulate-model", "each line of `truegap --json simulate --model FILE`", ("truegap::models::answer", "Answer")),
    written_as("solve", "`truegap --json solve CASE.toml`", ("truegap_fem::case::result", "CaseResult")),
    read_as(
        "space",
        "TOML of a space of designs, which `truegap audit --space` reads",
        ("truegap::study::audit", "SpaceFile"),
        "truegap.space/1",
    ),
    written_as(
        "tolerance",
        "tolerance.json, and `truegap --json tolerance`",
        ("truegap::study::answer::tolerance", "ToleranceAnswer"),
    )
    .id("truegap.tolerance/1"),
];

/// Draft that the schemas are written in.
const DRAFT: &str = "https://json-schema.org/draft/2020-12/schema";

/// Names and texts of all schemas.
///
/// # Errors
/// [`SchemaError`] where a type cannot be found or holds what this reader does not know.
pub fn written(index: &Index, workspace: &Path) -> Result<Vec<(String, String)>, SchemaError> {
    let folder = workspace.join("validation/schemas/by-hand");
    let by_hand = read(&folder.join("types.json"))?;
    let mut all =
        DOCUMENTS.iter().map(|d| Ok((d.name.to_owned(), of(d, index, &by_hand)?))).collect::<Result<Vec<_>, SchemaError>>()?;
    all.push(("sensor".into(), Value::Object(read(&folder.join("sensor.json"))?)));
    all.sort_by(|a, b| a.0.cmp(&b.0));
    Ok(all.into_iter().map(|(name, schema)| (name, format!("{schema:#}\n"))).collect())
}

fn read(file: &Path) -> Result<Map<String, Value>, SchemaError> {
    let text = std::fs::read_to_string(file).map_err(|source| SchemaError::File { file: file.to_owned(), source })?;
    serde_json::from_str(&text).map_err(|source| SchemaError::Json { file: file.to_owned(), source })
}

fn of(document: &Document, index: &Index, by_hand: &Map<String, Value>) -> Result<Value, SchemaError> {
    let mut schemas = Schemas::new(index, document.side, by_hand);
    let (module, name) = document.root;
    let root = schemas.of_name(name, module)?;
    let mut defs = schemas.defs;
    let mut schema = Map::new();
    schema.insert("$schema".into(), DRAFT.into());
    schema.insert("title".into(), document.id.unwrap_or(document.name).into());
    schema.insert("description".into(), document.says.into());
    if document.list {
        schema.insert("type".into(), "array".into());
        schema.insert("items".into(), root);
    } else if let Some(Value::Object(root)) = defs.remove(name) {
        schema.extend(root.into_iter().filter(|(key, _)| key != "description"));
    }
    if let (Some(id), Some(Value::Object(properties))) = (document.id, schema.get_mut("properties")) {
        properties.insert("schema".into(), json!({"const": id}));
    }
    if !defs.is_empty() {
        schema.insert("$defs".into(), Value::Object(defs));
    }
    Ok(Value::Object(schema))
}
