//! Predict, verify and explain a capacitive tactile sensor: the crates of the workspace under one name, and the glue between them.
//!
//! Limits: nothing here computes physics; text goes in and typed answers come out, printing is left to the caller.

pub mod answer;
pub mod audit_report;
pub mod audit_run;
pub mod audited;
pub mod axis;
pub mod base;
pub mod case_file;
pub mod confirm;
pub mod diagnosis;
pub mod example;
pub mod export;
pub mod model_file;
pub mod nearest;
pub mod output;
pub mod predict;
pub mod printed;
pub mod prove;
pub mod report;
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
pub use truegap_fem as fem;
pub use truegap_model as model;
pub use truegap_scene as scene;
pub use truegap_sweep as sweep;

pub use truegap_core::{Recording, RecordingError, Sensor};
