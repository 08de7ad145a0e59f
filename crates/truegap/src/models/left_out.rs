//! An added effect that another recording does without, and why.
//!
//! Limits: words alone; which effects these are is decided beside the model.

use serde::Serialize;

/// Why an effect is left out that belongs to what recorded.
pub const OF_RECORDER: &str = "it belongs to what recorded and not to what was recorded";
/// Why an effect is left out that goes with a date.
pub const OF_A_DATE: &str = "it goes with the date, and one of the recordings does not tell its date (give its clock as dates)";

/// An added effect that is left out.
#[derive(Clone, Debug, PartialEq, Eq, Serialize)]
pub struct LeftOut {
    /// its id
    pub effect: String,
    /// why
    pub why: &'static str,
}
