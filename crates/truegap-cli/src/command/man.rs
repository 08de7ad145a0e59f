//! `truegap man`: manual pages, from the command line's own definition.

use super::run::{Outcome, RunDefined};
use crate::console::Console;
use clap_mangen::Man as Page;
use std::io::Write;
use std::path::PathBuf;
use truegap::sweep::write_atomically;

/// Write the manual: one page to standard output, or all of them into a folder
#[derive(Debug, clap::Args)]
pub struct Man {
    /// Subcommand; the page of truegap itself where none is named
    command: Option<String>,
    /// Folder for truegap.1 and one page a subcommand; man reads them from ~/.local/share/man/man1
    #[arg(long, short, value_name = "DIR", conflicts_with = "command")]
    output: Option<PathBuf>,
}

impl RunDefined for Man {
    fn run(&self, console: &Console, definition: clap::Command) -> anyhow::Result<Outcome> {
        let mut definition = definition.disable_help_subcommand(true);
        definition.build();
        if let Some(folder) = &self.output {
            let is_new = !folder.exists();
            let mut commands = std::iter::once(&definition).chain(definition.get_subcommands());
            let written: anyhow::Result<()> =
                commands.try_for_each(|c| Ok(write_atomically(&folder.join(format!("{}.1", file_name(c))), &page(c)?)?));
            written.inspect_err(|_| {
                if is_new {
                    drop(std::fs::remove_dir_all(folder)); // nothing more can be done where even removing fails
                }
            })?;
            console.print(format!("Written: {}", folder.join("truegap.1").display()))?;
            return Ok(Outcome::Fine);
        }
        let named = self.command.as_ref().map(|name| definition.find_subcommand(name).ok_or_else(|| unknown(name, &definition)));
        let page = page(named.transpose()?.unwrap_or(&definition))?;
        crate::console::unless_gone(std::io::stdout().lock().write_all(&page))?;
        Ok(Outcome::Fine)
    }
}

fn unknown(name: &str, definition: &clap::Command) -> anyhow::Error {
    let known: Vec<&str> = definition.get_subcommands().map(clap::Command::get_name).collect();
    anyhow::anyhow!("truegap has no subcommand `{name}`; it has {}", known.join(", "))
}

fn file_name(command: &clap::Command) -> String {
    command.get_display_name().unwrap_or(command.get_name()).replace(' ', "-")
}

fn page(command: &clap::Command) -> std::io::Result<Vec<u8>> {
    let mut text = Vec::new();
    Page::new(command.clone()).render(&mut text)?;
    Ok(text)
}
