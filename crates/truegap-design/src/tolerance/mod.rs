//! Batches of sensors within their tolerances: scatter, yield, and which tolerance to tighten first.
//!
//! Limits: independent normal tolerances with the standard deviations of the sensor file; a sensor whose plates touch counts as a loss.

mod batch;
mod spec;
mod tighten;

pub(crate) use batch::toleranced;
pub use batch::{Batch, BatchOptions, Scatter, Yield, batch};
pub use spec::{Limit, Specification};
pub use tighten::{Tightened, tighten};
