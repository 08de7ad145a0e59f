//! Predict, verify and explain a capacitive tactile sensor: the crates of the workspace under one name, and the glue between them.
//!
//! Limits: nothing here computes physics; text goes in and typed answers come out, printing is left to the caller.
//!
//! # What is where
//!
//! | question | glue | crate behind it |
//! |---|---|---|
//! | what does the analytic model say? | [`find_sensor`], [`predict`] | [`model`] |
//! | do its assumptions hold? | [`audit_run`], [`audit_report`], [`case_file`], [`export`] | [`audit`], [`fem`], [`scene`] |
//! | what does it leave out of a recording? | [`diagnosis`], [`report`], [`confirm`], [`model_file`], [`prove`] | [`diagnose`] |
//! | which design drifts less? | [`study`] | [`design`], [`sweep`] |
//!
//! What solves finite elements ([`fem`], all of the second row but [`scene`], [`study::audit`]) stands behind the feature `fem`, which is on by default.
//! A diagnosis with a simulator of your own needs [`diagnose`] and [`core`] only.
//!
//! # A prediction
//!
//! ```
//! use truegap::{find_sensor, grid, model::StackOptions, simulate};
//!
//! let sensor = find_sensor("singletact-s15-4.5n", None)?;
//! let states = simulate(&sensor, StackOptions::default(), &grid(&[0.0, 4.5], &[20.0]))?;
//! assert!(states[1].c_total_pf > states[0].c_total_pf);
//! # Ok::<(), Box<dyn std::error::Error>>(())
//! ```
//!
//! # A diagnosis, as `truegap diagnose example` makes it
//!
//! ```
//! use std::sync::atomic::AtomicBool;
//! use truegap::{diagnosis::{Request, diagnose, open}, example_recording};
//!
//! // `Recording::open("recording.toml")` reads one of your own
//! let recording = example_recording()?;
//! let files = vec![("example".to_owned(), recording.sha256.clone())];
//! let request = Request { effects: vec!["thermal_lag".into(), "offset_drift".into()], ..Request::default() }; // all where none is named
//! let diagnosed = diagnose(open(vec![recording], &request)?, files, &request, &|_| (), &AtomicBool::new(false))?;
//! assert_eq!(diagnosed.outcome.diagnosis.findings[0].effect, "thermal_lag");
//! // `diagnosed.write(folder)` writes report.html, diagnosis.json, augmented.toml and prediction.csv
//! # Ok::<(), Box<dyn std::error::Error>>(())
//! ```

pub mod answer;
#[cfg(feature = "fem")]
pub mod audit_report;
#[cfg(feature = "fem")]
pub mod audit_run;
#[cfg(feature = "fem")]
pub mod audited;
pub mod axis;
pub mod base;
#[cfg(feature = "fem")]
pub mod case_file;
mod cells;
pub mod confirm;
pub mod diagnosis;
pub mod example;
pub mod explain;
#[cfg(feature = "fem")]
pub mod export;
pub mod mechanism_file;
pub mod model_file;
pub mod output;
pub mod predict;
pub mod printed;
pub mod prove;
pub mod report;
pub mod schemas;
pub mod sensors;
pub mod study;

pub use base::{BaseModelError, base_model, base_options};
pub use example::{EXAMPLE, example_recording};
pub use output::{OutputError, OutputFolder};
pub use predict::{PredictError, coefficients, drive, grid, simulate};
pub use sensors::{FindSensorError, find_sensor};

pub use truegap_audit as audit;
pub use truegap_core as core;
pub use truegap_design as design;
pub use truegap_diagnose as diagnose;
#[cfg(feature = "fem")]
pub use truegap_fem as fem;
pub use truegap_model as model;
pub use truegap_scene as scene;
pub use truegap_sweep as sweep;

pub use truegap_core::{Recording, RecordingError, Sensor};
