//! What is wrong with a recording, before any physics is named: one kind of trouble a file.
//!
//! Limits: looks at one recording at a time.

pub(crate) mod clipped;
pub(crate) mod dead;
pub(crate) mod notice;
pub(crate) mod outliers;
pub(crate) mod outliers_of_inputs;
pub(crate) mod pauses;
pub(crate) mod preconditions;
pub(crate) mod range;
pub(crate) mod repeated;
pub(crate) mod rows;
pub(crate) mod screen;
pub(crate) mod tuning;
pub(crate) mod wrong_sensor;
pub(crate) mod wrong_unit;

pub use crate::data::error::FEWEST_ROWS;
pub use clipped::clipped_rows;
pub use notice::{Notice, NoticeKind};
pub use outliers::outliers;
pub use outliers_of_inputs::outliers_of_inputs;
pub use repeated::repeated;
pub use rows::Rows;
pub use screen::troubles;
