//! `truegap merge`: joins what shards have computed.
//!
//! Limits: reads, calls, prints.

#[cfg(feature = "fem")]
use super::audit;
use super::run::{Outcome, Run};
use super::{optimise, tolerance};
use crate::console::Console;
use std::path::PathBuf;
use truegap::study::{Study, merge};

/// Join the shards of a study in a folder: the same files as from one process
#[derive(Debug, clap::Args)]
pub struct Merge {
    /// Folder that the shards were given with -o
    #[arg(value_name = "DIR")]
    folder: PathBuf,
    /// Take what is there, though cases are missing
    #[arg(long)]
    partial: bool,
}

impl Run for Merge {
    fn run(&self, console: &Console) -> anyhow::Result<Outcome> {
        match merge(&self.folder, self.partial)? {
            Study::Tolerance(answer) => tolerance::tell(console, &answer),
            Study::Optimise(answer) => optimise::tell(console, &answer),
            #[cfg(feature = "fem")]
            Study::Audit(answer) => audit::tell(console, &answer),
        }
    }
}
