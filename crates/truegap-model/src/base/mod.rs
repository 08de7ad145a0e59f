//! The simulations that a recording is compared with, one file each, and what they share.
//!
//! Limits: one response a row; what is calibrated beyond the stack's tolerances has weak priors scaled from the recording.

mod black_box;
mod constant;
mod driver;
mod external;
mod fed_back;
mod gap_plate;
mod grid;
mod linear;
mod options;
mod parallel_plate;
mod plate_beside;
mod plate_columns;
mod possible;
mod scale;
mod spec;
mod surface;
mod table;

pub use black_box::{BlackBox, BlackBoxFacts, Responder};
pub use driver::{DRIVERS, Driver, Followed, NamedDriver};
pub use external::{External, ExternalOptions, GAIN_SD};
pub use grid::{Axis, Grid, GridError};
pub use linear::HIGHEST_ORDER;
pub use options::{Asked, BaseOptions, Who};
pub use parallel_plate::Load;
pub use scale::{Recorded, ResponseScale};
pub use spec::{BASE_MODELS, BaseError, BaseModel, base_model};
pub use surface::Surface;
