//! `truegap audit`: every assumption of the analytic model measured by finite elements.
//!
//! Limits: reads, calls, prints; Ctrl-C stops between two solves, and what was finished is remembered.

use super::run::{Outcome, Run};
use super::stop::{STOP, stop_on_interrupt};
use super::study::Where;
use super::typed::command_line;
use crate::console::Console;
use crate::table::{digits, table};
use anyhow::anyhow;
use indicatif::{ProgressBar, ProgressStyle};
use std::path::{Path, PathBuf};
use truegap::OutputFolder;
use truegap::audit::{Cache, Options, Progress, Verdict, Watch};
use truegap::design::optimise::Space;
use truegap::predict::{DEFAULT_SENSOR, find_sensor};
use truegap::study::SensorText;
use truegap::study::answer::audit::SpaceAuditAnswer;
use truegap::study::audit::{SpaceAuditRequest, SpaceFile};
use truegap::study::vary::axis;
use truegap::sweep::Shard;
use truegap::verify::{AuditRequest, Audited, Body, FILES, audit, count, default_cache, loaded_stack, summary_lines};

/// Say which assumptions of the analytic model hold for a sensor, by how much the others are off, and what that does
#[derive(Debug, clap::Args)]
pub struct Audit {
    /// Built-in sensor or path of a sensor's TOML
    #[arg(long, default_value = DEFAULT_SENSOR)]
    sensor: String,
    /// Folder for report.html, audit.json, stack.glb and stack.vtu
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
    /// Leave out the deformed stack (stack.glb, stack.vtu and the viewer in the report)
    #[arg(long)]
    no_scene: bool,
    /// Audit the designs of a space instead: a TOML with sensor, designs, seed and axes (docs/audit.md)
    #[arg(long, value_name = "FILE", conflicts_with_all = ["sensor", "cache", "no_cache"])]
    space: Option<PathBuf>,
    /// Compute this share of the designs only, as 3/16; `truegap merge DIR` joins the shares
    #[arg(long, value_name = "INDEX/COUNT", requires = "space")]
    shard: Option<Shard>,
}

impl Run for Audit {
    fn run(&self, console: &Console) -> anyhow::Result<Outcome> {
        if let Some(file) = &self.space {
            return self.audit_space(file, console);
        }
        OutputFolder::check(&self.output, &FILES)?;
        stop_on_interrupt(console)?;
        let bar = bar(console);
        let tell = |p: &Progress| {
            bar.set_length(p.total as u64);
            bar.set_position(p.done as u64);
            bar.set_message(format!("{}: {}", p.id, p.says));
        };
        let audited = audit(self.request()?, &Watch { progress: Some(&tell), cancel: Some(&STOP) });
        bar.finish_and_clear();
        let audited = audited?;
        let folder = audited.write(&self.output, &self.bodies(&audited, console)?)?;
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
    /// The deformed stack, where all assumptions were asked for and the sensor has one.
    fn bodies(&self, audited: &Audited, console: &Console) -> anyhow::Result<Vec<Body>> {
        if self.no_scene || !self.only.is_empty() {
            return Ok(Vec::new());
        }
        let sensor = find_sensor(&self.sensor, None)?;
        match loaded_stack(&sensor, audited.options, &audited.command) {
            Ok(body) => Ok(vec![body]),
            Err(reason) => {
                console.note(format!("no deformed stack: {reason}"));
                Ok(Vec::new())
            }
        }
    }

    fn audit_space(&self, file: &Path, console: &Console) -> anyhow::Result<Outcome> {
        let space = SpaceFile::open(file).map_err(|source| anyhow!("{}: {source}", file.display()))?;
        let axes = space.axes.iter().map(|(name, range)| axis(&format!("{name}={range}"))).collect::<Result<Vec<_>, _>>()?;
        let sensor = SensorText::find(&space.sensor)?;
        let request = SpaceAuditRequest {
            axes: if axes.is_empty() { Space::paper(sensor.sensor()?)?.axes().to_vec() } else { axes },
            sensor,
            designs: space.designs,
            seed: space.seed,
            only: if self.only.is_empty() { space.only } else { self.only.clone() },
        };
        let place = Where { output: Some(self.output.clone()), shard: self.shard };
        let Some(answer) = place.run(console, |work| request.run(work))? else { return Ok(Outcome::Fine) };
        tell(console, &answer)
    }

    fn request(&self) -> anyhow::Result<AuditRequest> {
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
            command: command_line(),
        })
    }
}

/// Prints the audit of a space.
pub(super) fn tell(console: &Console, answer: &SpaceAuditAnswer) -> anyhow::Result<Outcome> {
    if console.json {
        console.print_json(answer)?;
    } else {
        let rows = answer.shares.iter().map(|s| {
            let pct = |share: f64| format!("{:.1}", 100.0 * share);
            let median = s.median_relative_error.map_or_else(|| "-".to_owned(), |e| digits(100.0 * e, 3));
            vec![s.id.clone(), s.designs.to_string(), pct(s.holds), pct(s.strained), pct(s.broken), median]
        });
        console.print(table(&["assumption", "designs", "holds\n%", "strained\n%", "broken\n%", "median off by\n%"], rows))?;
        console.print(format!(
            "{} designs audited, {} without an answer of the analytic model or of the finite elements",
            answer.audited, answer.refused
        ))?;
    }
    let fine = answer.complete && answer.refused == 0 && answer.shares.iter().all(|s| s.holds == 1.0);
    Ok(if fine { Outcome::Fine } else { Outcome::LookAt })
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
