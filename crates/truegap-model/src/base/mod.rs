//! The simulations that a recording is compared with, one file each, and what they share.
//!
//! Limits: one response a row; what is calibrated beyond the stack's tolerances has weak priors scaled from the recording.

mod constant;
mod external;
mod gap_plate;
mod parallel_plate;
mod shape;
mod spec;
mod start;

pub use constant::Constant;
pub use external::{External, ExternalOptions};
pub use gap_plate::GapPlate;
pub use parallel_plate::{Load, ParallelPlate};
pub use spec::{BASE_MODELS, BaseError, BaseModel, Recorded, ResponseScale, base_model};

pub(crate) use start::{Start, check_finite, stiffening};
