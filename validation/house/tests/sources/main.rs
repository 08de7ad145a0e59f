//! The checker on sources of a few lines.

mod declared;
mod numbers;
mod reading;

use std::collections::BTreeMap;
use truegap_house::{Files, Finding, House, ORDER};

/// A workspace of one package `a`: its sources by path from `a/src`, and the order.
fn files(sources: &[(&str, &str)], order: &str) -> Files {
    let mut files = BTreeMap::from([("a/Cargo.toml".to_owned(), "[package]\nname = \"a\"".to_owned())]);
    files.insert(ORDER.to_owned(), format!("[crates.a]\n{order}"));
    files.extend(sources.iter().map(|(path, text)| (format!("a/src/{path}"), (*text).to_owned())));
    files
}

fn house(sources: &[(&str, &str)], order: &str) -> House {
    House::of(&files(sources, order)).expect("made-up sources can be read")
}

fn findings(sources: &[(&str, &str)], order: &str) -> Vec<Finding> {
    house(sources, order).findings()
}

/// Arrows as `from -> to: names`, without the folder.
fn arrows(sources: &[(&str, &str)]) -> Vec<String> {
    let house = house(sources, "");
    let short = |path: &str| path.trim_start_matches("a/src/").to_owned();
    let line = |a: &truegap_house::Arrow| {
        format!("{} -> {}: {}", short(&a.from), short(&a.to), a.names.keys().cloned().collect::<Vec<_>>().join(" "))
    };
    house.arrows("a").iter().map(line).collect()
}
