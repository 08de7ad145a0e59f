//! What a user may say of a base model beside its name.
//!
//! Limits: each model takes what concerns it and ignores the rest.

use super::{ExternalOptions, Grid};
use crate::stack::StackOptions;
use truegap_core::Role;

/// Options of all base models.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct BaseOptions {
    /// of the paper's sensor
    pub stack: StackOptions,
    /// what may be adjusted of a simulation or a table that is given
    pub adjusted: ExternalOptions,
    /// what drives a line; the first moving column of [`super::DRIVERS`] where absent, one under `[drivers]` before the clock
    pub driver: Option<Role>,
    /// the column under `[drivers]` that drives it, in place of one with a role
    pub named_driver: Option<String>,
    /// order of a line's polynomial; 1 where absent
    pub order: Option<usize>,
    /// the table of a `table`
    pub table: Option<Grid>,
}

impl From<StackOptions> for BaseOptions {
    fn from(stack: StackOptions) -> Self {
        Self { stack, ..Self::default() }
    }
}
