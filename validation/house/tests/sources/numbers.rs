//! The numbers of the table.

use super::files;
use truegap_house::{Dot, House, Numbers};

fn two_packages() -> House {
    let lib = "pub mod open; mod shut; pub use shut::Shown;";
    let open = "pub struct Named; pub struct Unnamed; pub(crate) struct Inner; struct Own; pub fn tested() {}";
    let shut = "pub struct Shown; pub struct Hidden;";
    let mut files = files(&[("lib.rs", lib), ("open.rs", open), ("shut.rs", shut)], "may-depend-on = []");
    files.insert("a/tests/t.rs".into(), "use a::open::tested;".into());
    files.insert("b/Cargo.toml".into(), "[package]\nname = \"b\"".into());
    files.insert("b/src/lib.rs".into(), "pub use a as facade; pub fn f() {}".into());
    files.insert("c-d/Cargo.toml".into(), "[package]\nname = \"c-d\"".into());
    files.insert(
        "c-d/src/main.rs".into(),
        "mod deep; use b::facade::{self, Shown}; fn main() { facade::open::Named::new() }".into(),
    );
    files.insert("c-d/src/deep.rs".into(), "use super::main;".into());
    House::of(&files).expect("made-up sources can be read")
}

#[test]
fn public_items_are_those_that_can_be_named_from_outside() {
    let table = Numbers(&two_packages()).to_string();
    let row = table.lines().find(|line| line.starts_with("| `a` |")).unwrap();
    let cells: Vec<&str> = row.trim_matches('|').split('|').map(str::trim).collect();
    // rooms, files: lib.rs, open, shut; root modules: open; items: Named, Unnamed, tested, Shown; not named: Unnamed, tested; nor by tests: Unnamed
    assert_eq!(cells, ["`a`", "3", "3", "0", "0", "0", "0", "0", "-", "1", "4", "2", "1"]);
}

#[test]
fn the_drawing_has_every_room_and_every_arrow() {
    let dot = Dot(&two_packages()).to_string();
    for part in ["\"a/open\" [label = \"open\\n1 file\"];", "\"c-d/deep\" -> \"c-d/main.rs\";", "label = \"b\""] {
        assert!(dot.contains(part), "{part} is not in:\n{dot}");
    }
    assert_eq!(dot.matches('{').count(), dot.matches('}').count());
}

#[test]
fn the_review_counts_what_the_sources_hold() {
    let sources = [
        ("lib.rs", "//! A page.\nmod a; mod b;"),
        ("a.rs", "use crate::b::B; pub struct A;"),
        ("b.rs", "use crate::a::A; pub struct B;"),
    ];
    let value = |house: &House, what: &str| house.review().into_iter().find(|row| row.what.starts_with(what)).unwrap().value;
    let mut files = files(&sources, "");
    files.insert("README.md".into(), "# A\n\nBetter by 3 %.\n".into());
    let house = House::of(&files).expect("made-up sources can be read");
    assert_eq!(value(&house, "circles of files"), "1");
    assert_eq!(value(&house, "files in the largest circle"), "2");
    assert_eq!(value(&house, "lines of README"), "3; 1");
    assert_eq!(value(&house, "arrows upwards"), "-", "there is no such crate");
}
