//! `truegap export`: what it refuses, before anything is solved, and how its page opens.

#![allow(clippy::unwrap_used)]

mod common;

use common::Bench;

#[test]
fn an_unknown_ending_is_refused_with_those_that_there_are() {
    Bench::new().refuses(&["export", "--load", "4.5 N", "-o", "stack.stl"], &["`stl`", ".glb", ".vtu"]);
}

#[test]
fn several_loads_are_refused_since_a_file_shows_one_state() {
    Bench::new().refuses(&["export", "--load", "0:4.5 N:3", "-o", "stack.glb"], &["--load", "one value"]);
}

/// A page of the whole disc opened on a lid of one colour.
#[test]
fn a_page_is_cut_unless_it_is_asked_not_to_be() {
    let bench = Bench::new();
    let size = |file: &str, more: &[&str]| {
        let said = bench.run(&[&["export", "--load", "1 N", "--beads", "free", "-o", file], more].concat());
        assert_eq!(said.code, 0, "{}", said.err);
        std::fs::metadata(bench.path(file)).unwrap().len()
    };
    let (page, whole) = (size("page.html", &[]), size("whole.html", &["--whole"]));
    assert!(page < 9 * whole / 10, "a quarter is gone: {page} of {whole}");
    assert_eq!(bench.run(&["export", "--load", "1 N", "--wedge", "--whole", "-o", "page.html"]).code, 2);
}
