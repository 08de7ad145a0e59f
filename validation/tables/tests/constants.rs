//! The constants that decide stand in the sources as the list and the tables of the study have them.
#![allow(clippy::unwrap_used)]

use std::path::{Path, PathBuf};

fn root() -> PathBuf {
    Path::new(env!("CARGO_MANIFEST_DIR")).join("../..")
}

fn read(path: &str) -> String {
    std::fs::read_to_string(root().join(path)).unwrap()
}

/// File, name, value and, where it has no name in the sources, the text about it.
fn listed() -> Vec<(String, String, String, Option<String>)> {
    let list: toml::Table = read("validation/constants/constants.toml").parse().unwrap();
    let text = |table: &toml::Table, key: &str| table.get(key).map(|value| value.as_str().unwrap().to_owned());
    let of = |file: &toml::Value| {
        let file = file.as_table().unwrap().clone();
        let constants = file["constants"].as_array().unwrap().clone();
        constants.into_iter().map(move |constant| {
            let constant = constant.as_table().unwrap();
            let [path, name, value] = [text(&file, "path"), text(constant, "name"), text(constant, "value")].map(Option::unwrap);
            (path, name, value, text(constant, "at"))
        })
    };
    list["file"].as_array().unwrap().iter().flat_map(of).collect()
}

/// One space where there are several, or a new line.
fn plain(text: &str) -> String {
    text.split_whitespace().collect::<Vec<_>>().join(" ")
}

#[test]
fn the_sources_have_every_constant_as_it_is_listed() {
    for (path, name, value, at) in listed() {
        let source = plain(&read(&format!("crates/truegap-diagnose/src/{path}")));
        let found = match &at {
            Some(text) => source.matches(&text.replace(['«', '»'], "")).count(),
            None => source.split(&format!("const {name}: ")).skip(1).filter(|rest| stands(rest, &value)).count(),
        };
        assert_eq!(found, 1, "{path}: {name} is not {value} there; put the list right and study it again (validation/constants)");
        let marked = at.as_deref().and_then(|text| text.split_once('«')?.1.split_once('»'));
        assert!(marked.is_none_or(|(inside, _)| inside == value), "{path}: {name}");
    }
}

/// Whether a declaration that goes on like this has this value.
fn stands(rest: &str, value: &str) -> bool {
    rest.split_once(" = ").and_then(|(_, rest)| rest.split_once(';')).is_some_and(|(found, _)| found == value)
}

#[test]
fn the_tables_are_those_of_the_listed_values() {
    let table = read("validation/constants/constants.csv");
    let rows: Vec<&str> = table.lines().skip(1).collect();
    let listed = listed();
    assert_eq!(rows.len(), listed.len());
    for (row, (_, name, value, _)) in rows.iter().zip(&listed) {
        let quoted = if value.contains(',') { format!("\"{value}\"") } else { value.clone() };
        assert!(row.split(',').next().unwrap().ends_with(name.as_str()) && row.contains(&format!(",{quoted},")), "{name}: {row}");
    }
}
