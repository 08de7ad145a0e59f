//! `truegap export`: what it refuses, before anything is solved.

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
