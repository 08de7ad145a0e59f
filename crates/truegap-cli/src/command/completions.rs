//! `truegap completions`: what a shell needs to complete commands and flags, from the command line's own definition.

use super::run::{Outcome, RunDefined};
use crate::console::Console;
use clap_complete::Shell;
use std::io::Write;

/// Write completions for a shell to standard output
#[derive(Debug, clap::Args)]
pub struct Completions {
    /// For bash: truegap completions bash > ~/.local/share/bash-completion/completions/truegap
    shell: Shell,
}

impl RunDefined for Completions {
    fn run(&self, _: &Console, mut definition: clap::Command) -> anyhow::Result<Outcome> {
        let mut text = Vec::new();
        clap_complete::generate(self.shell, &mut definition, "truegap", &mut text);
        crate::console::unless_gone(std::io::stdout().lock().write_all(&text))?;
        Ok(Outcome::Fine)
    }
}
