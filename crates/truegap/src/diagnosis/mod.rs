//! From recordings on disk to a diagnosis and the folder of files that tells it.
//!
//! Limits: one kind of reading for all recordings given together; decides nothing that `truegap_diagnose` does not decide.

mod asking;
mod bank_store;
mod bases;
mod cache_folder;
mod clock;
mod course;
mod diagnosed;
mod error;
mod pace;
mod prediction;
mod request;
mod run;
mod screen;

pub use cache_folder::cache_folder;
pub use diagnosed::{Diagnosed, FILES};
pub use error::DiagnosisError;
pub use pace::{Pace, pace};
pub use request::{Opened, Request, open, open_with};
pub use run::diagnose;
