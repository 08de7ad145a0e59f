//! The commands that solve finite elements, in a program that was built without them: they say how to build it with them.
//!
//! Limits: whatever stands behind the command is not looked at.

use super::run::{Outcome, Run};
use crate::console::Console;

/// Not in this program, which was built with --no-default-features
#[derive(Debug, clap::Args)]
#[command(disable_help_flag = true)]
pub struct LeftOut {
    /// Whatever was asked
    #[arg(trailing_var_arg = true, allow_hyphen_values = true, hide = true)]
    arguments: Vec<std::ffi::OsString>,
}

impl Run for LeftOut {
    fn run(&self, _: &Console) -> anyhow::Result<Outcome> {
        anyhow::bail!(
            "this program was built without finite elements, which audit, export, mesh and solve need; build it without --no-default-features"
        )
    }
}

pub mod audit {
    pub use super::LeftOut as Audit;
}
pub mod export {
    pub use super::LeftOut as Export;
}
pub mod mesh {
    pub use super::LeftOut as Mesh;
}
pub mod solve {
    pub use super::LeftOut as Solve;
}
