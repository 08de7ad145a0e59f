//! `truegap explain`: what an effect of the library is, and what tells it from its rivals.

use super::run::{Outcome, Run};
use crate::console::Console;
use serde::Serialize;
use truegap::diagnose::Library;
use truegap::diagnosis::{effects, explained};

/// Say what an effect is: physics, equation, what shows it, its rivals and what tells it from them; all effects where none is named
#[derive(Debug, clap::Args)]
pub struct Explain {
    /// Name of an effect, as a report has it: thermal_lag, "thermal lag"
    effect: Option<String>,
}

#[derive(Serialize)]
struct Line {
    effect: &'static str,
    physics: &'static str,
}

impl Run for Explain {
    fn run(&self, console: &Console) -> anyhow::Result<Outcome> {
        let library = Library::default();
        match &self.effect {
            Some(name) => {
                let explained = explained(name, &library)?;
                if console.json { console.print_json(&explained) } else { console.print(explained) }?;
            }
            None => {
                let lines = effects(&library);
                let width = lines.iter().map(|(id, _)| id.len()).max().unwrap_or(0);
                let json: Vec<Line> = lines.iter().map(|&(effect, physics)| Line { effect, physics }).collect();
                if console.json {
                    console.print_json(&json)?;
                } else {
                    lines.iter().try_for_each(|(id, physics)| console.print(format!("{id:width$}  {physics}")))?;
                }
            }
        }
        Ok(Outcome::Fine)
    }
}
