//! Models by name, as programs and as files: what a recording is compared with, the fuller model that a diagnosis writes, effects of one's own.
//!
//! ```
//! use truegap::models::base_model;
//!
//! let recording = truegap::diagnosis::example_recording()?;
//! let base = base_model(&recording)?; // the one that the recording names in `[base]`
//! assert_eq!((base.simulator.name(), base.simulator.unit()), ("stack", "pF"));
//! # Ok::<(), Box<dyn std::error::Error>>(())
//! ```
//!
//! [`ModelFile::open`] reads the `augmented.toml` of a diagnosis; its [`RunningModel`] answers [`at_points`], [`along`] a recording or [`on_profile`].

mod answer;
mod base;
mod by_name;
mod checked;
mod deployed;
mod known_keys;
mod left_out;
mod mechanism_file;
mod model_file;
mod model_file_error;
mod written_units;

pub use answer::{Answer, AnswerError, along, at_points, load_dimension, on_profile};
pub(crate) use answer::{of_recording, refused};
pub use base::{
    Base, BaseModelError, Calls, Function, Programs, Remembered, base_model, base_model_with, base_options, columns, declared,
};
pub(crate) use base::{SLOW_S, has_key};
pub use deployed::{Parted, Wanted, corrected_for, only_carried};
pub use left_out::{LeftOut, OF_RECORDER};
pub use mechanism_file::{EffectFileError, with_effects};
pub use model_file::{ModelFile, RunningModel, SCHEMA as MODEL_SCHEMA};
pub use model_file_error::ModelFileError;
