//! `truegap schema`: the JSON Schema of a file or an output.

use super::run::{Outcome, Run};
use crate::console::Console;
use serde::Serialize;
use truegap::{SCHEMAS, schema};

/// Print the JSON Schema of a file or an output; all names where none is given
#[derive(Debug, clap::Args)]
pub struct SchemaOf {
    /// Name: recording, sensor, diagnosis, ...
    name: Option<String>,
}

#[derive(Serialize)]
struct Line {
    name: &'static str,
    says: String,
}

impl Run for SchemaOf {
    fn run(&self, console: &Console) -> anyhow::Result<Outcome> {
        if let Some(name) = &self.name {
            console.print(schema(name)?.text.trim_end())?;
            return Ok(Outcome::Fine);
        }
        let lines: Vec<Line> = SCHEMAS.iter().map(|schema| Line { name: schema.name, says: schema.says() }).collect();
        if console.json {
            console.print_json(&lines)?;
        } else {
            lines.iter().try_for_each(|line| console.print(format!("{:15}{}", line.name, line.says)))?;
        }
        Ok(Outcome::Fine)
    }
}
