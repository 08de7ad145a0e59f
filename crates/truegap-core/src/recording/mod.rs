//! A recording: what was done to a sensor and what was read, from a CSV with a TOML beside it, a bare CSV, or the SingleTact tool's own CSV.
//!
//! Limits: units are converted here, once; whether the numbers make sense as a measurement is for the diagnosis to say.

mod clock;
mod columns;
mod data;
mod error;
mod frame;
mod made;
mod manifest;
mod note;
mod number;
mod open;
mod roles;
mod rows;
mod singletact;
mod sketch;
mod table;
mod write;

pub use data::{Recording, Sensors};
pub use error::RecordingError;
pub use manifest::BaseSpec;
pub use note::Note;
pub use sketch::{Sketch, sketch};
