//! The design studies from the command line: shards against the whole, restarts, and what they refuse.

#![allow(clippy::unwrap_used)]

mod common;

use common::Bench;
use std::fs;

const BATCH: &[&str] = &["tolerance", "--samples", "140000", "--limit", "span=2.3:2.6", "--seed", "5", "-q"];
const SEARCH: &[&str] = &["optimise", "--searches", "2", "--seed", "3", "-q"];

fn with<'a>(command: &[&'a str], more: &[&'a str]) -> Vec<&'a str> {
    command.iter().chain(more).copied().collect()
}

/// The study as a whole in folder `one`, and in three shards, the last one first, in folder `three`; files that must be the same.
fn same_bytes(command: &[&str], files: &[&str]) {
    let bench = Bench::new();
    assert_eq!(bench.run(&with(command, &["-o", "one"])).code, 0);
    for shard in ["3/3", "1/3"] {
        let said = bench.run(&with(command, &["-o", "three", "--shard", shard]));
        assert!(said.code == 0 && said.out.contains("truegap merge three"), "{}{}", said.out, said.err);
    }
    let said = bench.run(&["merge", "three"]);
    assert!(said.code == 2 && said.err.contains("are missing") && said.err.contains("cases"), "{}", said.err);
    // what kill -9 leaves in the middle of a case
    let case = fs::read_dir(bench.path("three/cases")).unwrap().next().unwrap().unwrap().path();
    fs::write(case.with_extension("json.99-0.part"), "{\"hash\":").unwrap();
    assert_eq!(bench.run(&with(command, &["-o", "three", "--shard", "2/3"])).code, 0);
    let merged = bench.run(&["merge", "three"]);
    let again = bench.run(&with(command, &["-o", "one"]));
    assert_eq!((merged.code, merged.out), (0, again.out), "the same table, from cases that were done already");
    for file in files {
        let read = |folder: &str| fs::read(bench.path(folder).join(file)).unwrap();
        assert!(read("one") == read("three") && !read("one").is_empty(), "{file} differs");
    }
}

#[test]
fn batches_in_shards_are_the_batch() {
    same_bytes(BATCH, &["tolerance.json", "scatter.csv", "tighten.csv", "span.svg", "tighten.svg", "report.html", "sweep.json"]);
}

#[test]
fn searches_in_shards_are_the_searches() {
    same_bytes(SEARCH, &["optimise.json", "fronts.csv", "k_baseline_k_linearity.svg", "report.html", "sweep.json"]);
}

#[test]
fn a_folder_of_another_study_is_left_alone() {
    let bench = Bench::new();
    assert_eq!(bench.run(&with(BATCH, &["-o", "d"])).code, 0);
    bench.refuses(&["tolerance", "--samples", "1000", "-o", "d"], &["another sweep", "a folder of its own"]);
    bench.refuses(&["merge", "nowhere"], &["nowhere", "holds no sweep", "-o"]);
}

#[test]
fn a_sensitivity_study_writes_its_folder() {
    let bench = Bench::new();
    let said = bench.run(&["sensitivity", "--compare", "singletact-s8-optimised", "--rows", "256", "-o", "s", "--json", "-q"]);
    let answer: serde_json::Value = serde_json::from_str(&said.out).unwrap();
    assert_eq!((said.code, answer["sensors"].as_array().unwrap().len()), (0, 2));
    let page = fs::read_to_string(bench.path("s/report.html")).unwrap();
    assert!(page.contains("<svg") && page.contains("singletact-s8-optimised") && !page.contains("<script src"));
    let csv = fs::read_to_string(bench.path("s/sensitivity.csv")).unwrap();
    // two sensors, eight quantities, seven numbers, and the header
    assert_eq!(csv.lines().count(), 2 * 8 * 7 + 1);
}

#[test]
fn spaces_and_specifications_that_mean_nothing_are_refused() {
    let bench = Bench::new();
    let refuses = |arguments: &[&str], parts: &[&str]| bench.refuses(arguments, parts);
    refuses(&["optimise", "--vary", "height=200 um:150 um"], &["height", "empty", "below the upper"]);
    refuses(&["optimise", "--vary", "height=200:150 um"], &["height", "200", "unit"]);
    refuses(&["optimise", "--vary", "width=1 um:2 um"], &["`width`", "height", "conductor"]);
    refuses(&["optimise", "--vary", "height"], &["--vary height", "range"]);
    let twice = ["optimise", "--vary", "height=150 um:200 um", "--vary", "height=160 um:210 um"];
    refuses(&twice, &["--vary", "`height` twice", "leave one of them out"]);
    refuses(&["optimise", "--least-span", "0"], &["span", "above 0"]);
    let held = ["young", "height", "conductor", "plating", "insulator", "bead_diameter", "bead_count", "diameter"];
    let all: Vec<&str> = held.iter().flat_map(|name| ["--hold", *name]).collect();
    refuses(&with(&["optimise"], &all), &["nothing may vary"]);
    refuses(&["tolerance", "--limit", "span=3:2"], &["span", "from 3 to 2", "swap"]);
    refuses(&["tolerance", "--limit", "span=1:2", "--limit", "span=3:4"], &["span", "from 3 to 2"]);
    refuses(&["tolerance", "--limit", "mass=1:2"], &["mass", "k_sensitivity"]);
    refuses(&["tolerance", "--samples", "3"], &["3 samples", "16"]);
    refuses(&["sensitivity", "--change", "0"], &["--change 0", "above 0"]);
}

#[test]
fn a_space_without_a_design_says_which_constraint_excludes_how_much() {
    let bench = Bench::new();
    let arguments = ["optimise", "--vary", "diameter=6 mm:7 mm", "--least-baseline", "0.9", "--searches", "1", "-q"];
    bench.refuses(&arguments, &["none of 2000 designs", "99.8 % break \"the baseline stays useful\"", "relax"]);
}

#[test]
fn a_specification_that_nothing_meets_says_what_each_limit_excludes() {
    let bench = Bench::new();
    let said = bench.run(&["tolerance", "--samples", "1000", "--limit", "span=100:", "--limit", "baseline=:300"]);
    assert_eq!(said.code, 1);
    assert!(said.out.contains("span from 100 to inf pF excludes 100.000 %, 100.000 % alone"), "{}", said.out);
    assert!(said.err.contains("no sensor of singletact-s15-4.5n meets"), "{}", said.err);
}
