//! The simulations that a recording is compared with, one file each, and what they share.
//!
//! Limits: one response a row; what is calibrated beyond the stack's tolerances has weak priors scaled from the recording.

mod constant;
mod external;
mod gap_plate;
mod parallel_plate;
mod scale;
mod spec;

pub use external::{External, ExternalOptions};
pub use parallel_plate::Load;
pub use scale::{Recorded, ResponseScale};
pub use spec::{BASE_MODELS, BaseError, BaseModel, base_model};
