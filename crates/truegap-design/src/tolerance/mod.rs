//! Batches of sensors within their tolerances: scatter, yield, and which tolerance to tighten first.
//!
//! Limits: independent normal tolerances with the standard deviations of the sensor file; a sensor whose plates touch counts as a loss.

mod batch;
mod count;
mod spec;
mod summary;
mod tighten;

pub use crate::sample::{BATCH, normal_quantile, uniform};
pub(crate) use batch::toleranced;
pub use batch::{Batch, BatchOptions, PROBABILITIES, Scatter, batch, part};
pub use count::{Counts, Yield};
pub use spec::{Limit, Specification};
pub use summary::{Summary, join};
pub use tighten::{Tightened, halved, rank, tighten, tolerances};
