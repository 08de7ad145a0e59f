//! The workspace keeps its declared order: no new circle of files, no arrow upwards, no dependency that is not allowed.

use std::path::Path;
use truegap_house::{House, ORDER};

#[test]
fn the_house_is_as_declared() {
    let root = Path::new(env!("CARGO_MANIFEST_DIR")).join("../..");
    let house = House::open(&root).unwrap();
    let findings: Vec<String> = house.findings().iter().map(ToString::to_string).collect();
    assert!(
        findings.is_empty(),
        "the sources break the order of {ORDER} in {} places (how to read this: validation/house/README.md)\n\n{}\n",
        findings.len(),
        findings.join("\n\n")
    );
}

#[test]
fn the_graph_of_the_workspace_is_not_empty() {
    let root = Path::new(env!("CARGO_MANIFEST_DIR")).join("../..");
    let house = House::open(&root).unwrap();
    // a reader that lost its files would find nothing wrong
    assert!(house.arrows("truegap-diagnose").len() > 100);
    assert!(house.arrows("truegap-fem").len() > 100);
}
