//! The schemas in docs/schemas are those of the types. That real files and outputs keep to them is tested in crates/truegap-python/tests/test_schemas.py, where a
//! validator costs no build.

#![allow(clippy::unwrap_used)]

use std::path::Path;
use truegap_schemas::{Index, written};

#[test]
fn the_schemas_are_those_of_the_types() {
    let workspace = Path::new(env!("CARGO_MANIFEST_DIR")).join("../..");
    let all = written(&Index::of(&workspace).unwrap(), &workspace).unwrap();
    for (name, text) in &all {
        let on_disk = std::fs::read_to_string(workspace.join(format!("docs/schemas/{name}.json"))).unwrap_or_default();
        assert!(on_disk == *text, "docs/schemas/{name}.json is not what the types say; run `cargo run -p truegap-schemas`");
    }
    assert_eq!(std::fs::read_dir(workspace.join("docs/schemas")).unwrap().count(), all.len());
}

#[test]
fn a_type_that_is_not_there_is_told_with_its_place() {
    let folder = Path::new(env!("CARGO_MANIFEST_DIR"));
    let told = written(&Index::of(folder).unwrap(), &folder.join("../..")).unwrap_err().to_string();
    assert!(told.contains("`Audit`") && told.contains("no source"), "{told}");
}
