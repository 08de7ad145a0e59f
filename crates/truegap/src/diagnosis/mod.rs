//! From recordings on disk to a diagnosis and the folder of files that tells it.
//!
//! Limits: one kind of reading for all recordings given together; decides nothing that `truegap_diagnose` does not decide.
//!
//! What `truegap diagnose example` does:
//!
//! ```
//! use std::sync::atomic::AtomicBool;
//! use truegap::diagnosis::{Request, diagnose, example_recording, open};
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

mod asking;
mod bank_store;
mod bases;
mod beside_model;
mod ceilings;
mod clock;
pub mod compensate;
pub mod confirm;
mod course;
mod diagnosed;
mod error;
mod example;
mod explain;
mod files_read;
mod followed;
mod pace;
mod prediction;
pub mod report;
mod request;
mod rows;
mod run;
mod screen;

pub use crate::cache_folder::cache_folder;
pub use beside_model::SaysOtherwise;
pub use diagnosed::{Diagnosed, FILES};
pub use error::DiagnosisError;
pub use example::{example_recording, recorded};
pub use explain::{ExplainError, Explained, Number, ToldBy, effects, explained};
pub use files_read::files_read;
pub use pace::{Pace, pace};
pub use request::{Opened, Request, open, open_with};
pub use run::diagnose;
