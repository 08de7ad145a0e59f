//! What a user may say of a base model beside its name.
//!
//! Limits: each model takes what concerns it and ignores the rest.

use super::{ExternalOptions, Grid};
use crate::stack::StackOptions;
use std::path::PathBuf;
use truegap_core::{Parameter, Role};

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
    /// who is asked for a response, of a `command` or a `function`
    pub asked: Option<Asked>,
}

/// Somebody else's simulator and the numbers that calibration may adjust in it.
#[derive(Clone, Debug, PartialEq)]
pub struct Asked {
    /// who answers
    pub who: Who,
    /// its parameters, with what is known of them
    pub parameters: Vec<Parameter>,
    /// whether it may be asked so often that physics inside of it is looked for
    pub inside: bool,
}

/// Who answers.
#[derive(Clone, Debug, PartialEq)]
pub enum Who {
    /// a program that stays up
    Command {
        /// program and arguments
        run: Vec<String>,
        /// folder in which it is started
        folder: PathBuf,
        /// longest time that an answer may take, s
        timeout_s: f64,
    },
    /// a function of the program that called
    Function {
        /// its name, for files and messages
        name: String,
    },
}

impl From<StackOptions> for BaseOptions {
    fn from(stack: StackOptions) -> Self {
        Self { stack, ..Self::default() }
    }
}
