//! `truegap audit`: every assumption of the analytic model measured by finite elements.
//!
//! Limits: reads, calls, prints; Ctrl-C stops between two solves, and what was finished is remembered.

use super::diagnose::{STOP, stop_on_interrupt};
use super::{Outcome, Run};
use crate::console::Console;
use crate::table::table;
use indicatif::{ProgressBar, ProgressStyle};
use std::path::PathBuf;
use truegap::audit::{Cache, Options, Progress, Verdict, Watch};
use truegap::audit_report::{count, summary_lines};
use truegap::audit_run::{AuditRequest, Audited, audit, default_cache};
use truegap::sensors::{DEFAULT_SENSOR, find_sensor};

/// Say which assumptions of the analytic model hold for a sensor, by how much the others are off, and what that does
#[derive(Debug, clap::Args)]
pub struct Audit {
    /// Built-in sensor or path of a sensor's TOML
    #[arg(long, default_value = DEFAULT_SENSOR)]
    sensor: String,
    /// Folder for report.html and audit.json
    #[arg(long, short, value_name = "DIR", default_value = "audit")]
    output: PathBuf,
    /// Examine these assumptions only
    #[arg(long, value_delimiter = ',', value_name = "ID,ID")]
    only: Vec<String>,
    /// Folder in which findings are remembered; `truegap/audit` in the user's cache folder where none is given
    #[arg(long, value_name = "DIR")]
    cache: Option<PathBuf>,
    /// Compute everything afresh and remember nothing
    #[arg(long, conflicts_with = "cache")]
    no_cache: bool,
}

impl Run for Audit {
    fn run(&self, console: &Console) -> anyhow::Result<Outcome> {
        stop_on_interrupt()?;
        let bar = bar(console);
        let tell = |p: &Progress| {
            bar.set_length(p.total as u64);
            bar.set_position(p.done as u64);
            bar.set_message(format!("{}: {}", p.id, p.says));
        };
        let audited = audit(self.request()?, &Watch { progress: Some(&tell), cancel: Some(&STOP) });
        bar.finish_and_clear();
        let audited = audited?;
        let folder = audited.write(&self.output, &[])?;
        if console.json {
            console.print_json(&audited.audit)?;
        } else {
            print(console, &audited)?;
            console.print(format!("Report: {}", folder.join("report.html").display()))?;
        }
        let fine = audited.audit.assumptions.iter().all(|f| f.verdict == Verdict::Holds);
        Ok(if fine { Outcome::Fine } else { Outcome::LookAt })
    }
}

impl Audit {
    fn request(&self) -> anyhow::Result<AuditRequest> {
        let quoted = |word: String| if word.contains(char::is_whitespace) { format!("\"{word}\"") } else { word };
        let words = std::env::args().skip(1).map(quoted);
        let cache = match &self.cache {
            Some(folder) => Cache::in_folder(folder),
            None if self.no_cache => Cache::none(),
            None => default_cache(),
        };
        Ok(AuditRequest {
            sensor: find_sensor(&self.sensor, None)?,
            only: self.only.clone(),
            options: Options::default(),
            cache,
            command: std::iter::once("truegap".to_owned()).chain(words).collect::<Vec<_>>().join(" "),
        })
    }
}

fn print(console: &Console, audited: &Audited) -> anyhow::Result<()> {
    let audit = &audited.audit;
    let rows = summary_lines(audit).into_iter().map(Vec::from);
    let header = ["assumption", "verdict", "analytic", "finite elements", "off by\n%", "largest effect\n%"];
    console.print(table(&header, rows))?;
    for not in &audit.not_applicable {
        console.print(format!("{} not examined: {}", not.id, not.says))?;
    }
    let [broken, strained, holds] = [Verdict::Broken, Verdict::Strained, Verdict::Holds].map(|v| count(audit, v));
    console.print(format!("{}: {broken} broken, {strained} strained, {holds} hold", audit.sensor))
}

fn bar(console: &Console) -> ProgressBar {
    if console.quiet {
        return ProgressBar::hidden();
    }
    let bar = ProgressBar::new(1);
    if let Ok(style) = ProgressStyle::with_template("{bar:24} {pos:>2}/{len}  {wide_msg}  {elapsed}") {
        bar.set_style(style);
    }
    bar
}
