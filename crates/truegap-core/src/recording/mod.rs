//! A recording: what was done to a sensor and what was read, from a CSV with a TOML beside it, a bare CSV, or the SingleTact tool's own CSV.
//!
//! Limits: units are converted here, once; whether the numbers make sense as a measurement is for the diagnosis to say.

mod assumed_base;
mod clock;
mod columnar;
mod columns;
mod data;
mod date_order;
mod date_text;
mod default_names;
mod degrees;
mod driver_columns;
mod driver_roles;
mod error;
mod frame;
mod guess;
mod heading;
mod hint;
mod keys;
mod layout;
mod made;
mod manifest;
mod map;
mod notation;
mod note;
mod number;
mod open;
mod packed;
mod refuse;
mod roles;
mod rows;
mod separators;
mod singletact;
mod sketch;
mod small_letters;
mod source;
mod spare;
mod stamp;
mod table;
mod text;
mod told;
mod toml_names;
mod whole;
mod words;
mod write;

pub use columnar::read_columns;
pub use data::{Recording, Sensors};
pub use date_text::dates_of_text;
pub use error::RecordingError;
pub use frame::{Cells, FrameColumn};
pub use manifest::BaseSpec;
pub use map::{MapError, Mapped};
pub use note::Note;
pub use packed::is_standard_input;
pub use sketch::{Sketch, sketch};
pub use told::Told;
