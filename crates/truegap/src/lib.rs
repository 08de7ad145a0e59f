//! Predict, verify and explain what a sensor reads, capacitive tactile ones first: the crates of the workspace under one name, and the glue between them.
//!
//! Limits: nothing here computes physics; text goes in and typed answers come out, printing is left to the caller.
//!
//! # What is where
//!
//! | question | module | crate behind it |
//! |---|---|---|
//! | what does the analytic model say? | [`predict`] | [`model`] |
//! | do its assumptions hold? | `verify` | [`audit`], `fem`, [`scene`] |
//! | what does it leave out of a recording? | [`diagnosis`], with its [`report`](diagnosis::report); is that borne out elsewhere? [`confirm`](diagnosis::confirm); what would be read without it? [`compensate`](diagnosis::compensate) | [`diagnose`] |
//! | what is compared, and what comes out, as files and programs | [`models`] | [`model`], [`diagnose`] |
//! | which design drifts less? | [`study`] | [`design`], [`sweep`] |
//! | how often is a diagnosis right? | [`prove`] | a generator that shares nothing with it |
//! | folders and formats of files | [`OutputFolder`], [`schema`] | - |
//!
//! What solves finite elements (`fem`, `verify`, `study::audit`) stands behind the feature `fem`, which is on by default.
//! A diagnosis with a simulator of your own needs [`diagnose`] and [`core`] only.
//!
//! # A prediction
//!
//! ```
//! use truegap::{model::StackOptions, predict::{find_sensor, grid, simulate}};
//!
//! let sensor = find_sensor("singletact-s15-4.5n", None)?;
//! let states = simulate(&sensor, StackOptions::default(), &grid(&[0.0, 4.5], &[20.0]))?;
//! assert!(states[1].c_total_pf > states[0].c_total_pf);
//! # Ok::<(), Box<dyn std::error::Error>>(())
//! ```

mod cache_folder;
mod cells;
pub mod diagnosis;
pub mod models;
mod output;
pub mod predict;
pub mod prove;
mod schemas;
pub mod study;
#[cfg(feature = "fem")]
pub mod verify;

pub use output::{OutputError, OutputFolder};
pub use schemas::{SCHEMAS, Schema, UnknownSchema, schema};

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
