//! Recordings with nothing missing, written down by a chain that rounds: nothing is invented where a step hides what was read.
//!
//! Each named something before its cause was mended; the studies are those of `truegap prove --only loggers --cases 500`.

#![allow(clippy::unwrap_used)]

use std::sync::atomic::AtomicBool;
use truegap::core::Recording;
use truegap::diagnose::answer::{Diagnosis, Verdict};
use truegap::diagnosis::{Request, diagnose, open};
use truegap::prove::{Plan, Sort};

fn nothing_missing(seed: u64, case: usize) -> Diagnosis {
    let plan = Plan { seed, cases: 500, only: Sort::Loggers, protocols: Vec::new() };
    let case = plan.study().unwrap().case(case - 1).unwrap();
    let folder = tempfile::tempdir().unwrap();
    std::fs::write(folder.path().join("recording.csv"), case.recording.csv()).unwrap();
    std::fs::write(folder.path().join("recording.toml"), case.recording.toml()).unwrap();
    let recording = Recording::open(folder.path()).unwrap();
    let request = Request::default();
    let opened = open(vec![recording], &request).unwrap();
    diagnose(opened, Vec::new(), &request, &|_| (), &AtomicBool::new(false)).unwrap().outcome.diagnosis
}

#[track_caller]
fn agrees(seed: u64, case: usize) {
    let diagnosis = nothing_missing(seed, case);
    assert_eq!((diagnosis.verdict, diagnosis.findings.len()), (Verdict::Agrees, 0), "{}", diagnosis.says);
}

/// Six levels of a load cell in steps of 50 mN, one of them on the edge of a step: the arriving load was said to go up and down with the load.
#[test]
fn a_load_in_steps_of_50_mn() {
    agrees(88231, 18);
}

/// A thermometer in steps of half a kelvin: a lag was named.
#[test]
fn a_thermometer_in_steps_of_half_a_kelvin() {
    agrees(88231, 161);
}

/// Stamps of 0.04 s and 0.05 s in turn beside rows of 0.045 s: a line in the spectrum of a ramp.
#[test]
fn stamps_of_two_decimals() {
    agrees(88231, 150);
}

/// A converter in steps of six standard deviations of the noise: a sawtooth's line, and rows within half a step.
#[test]
fn a_coarse_converter_has_lines_and_bursts_of_its_own() {
    agrees(88231, 5);
    agrees(88231, 26);
}

/// The same: waves of the reading that make no error smaller.
#[test]
fn a_mechanism_that_makes_no_error_smaller_beside_a_coarse_converter() {
    agrees(88231, 110);
    agrees(90417, 110);
}
