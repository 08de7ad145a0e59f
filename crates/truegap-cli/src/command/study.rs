//! What the design studies share: folder, shard, progress, stopping.
//!
//! Limits: the first Ctrl-C keeps the cases that are done, a second one ends the program.

use super::run::Outcome;
use super::stop::{STOP, stop_on_interrupt};
use crate::console::Console;
use indicatif::{ProgressBar, ProgressStyle};
use std::path::PathBuf;
use std::time::Duration;
use truegap::study::{Finished, StudyError, Work};
use truegap::sweep::{Control, Progress, Shard};

/// Where a study is computed.
#[derive(Debug, clap::Args)]
pub struct Where {
    /// Folder for cases, numbers, figures and report.html; a study that was stopped goes on in it
    #[arg(long, short, value_name = "DIR")]
    pub output: Option<PathBuf>,
    /// Compute this share of the cases only, as 3/16; `truegap merge DIR` joins the shares
    #[arg(long, value_name = "INDEX/COUNT", requires = "output")]
    pub shard: Option<Shard>,
}

impl Where {
    /// Runs a study under a progress bar; `None` where only a share was computed, which is told.
    pub fn run<A>(
        &self,
        console: &Console,
        study: impl FnOnce(Work<'_>) -> Result<Finished<A>, StudyError>,
    ) -> anyhow::Result<Option<A>> {
        stop_on_interrupt(console)?;
        let bar = bar(console);
        let progress = |p: Progress| {
            bar.set_length(p.of as u64);
            bar.set_position(p.done as u64);
        };
        let shard = self.shard.unwrap_or(Shard::WHOLE);
        let control = Control { progress: Some(&progress), cancel: Some(&STOP) };
        let finished = study(Work { folder: self.output.as_deref(), shard, control });
        bar.finish_and_clear();
        let Finished { ran, answer } = finished?;
        if ran.found > 0 {
            console.note(format!("{} of {} cases were done already", ran.found, ran.of));
        }
        if ran.cancelled {
            let go_on = if self.output.is_some() { "; the same command goes on from here" } else { "" };
            console.note(format!("stopped with {} of {} cases done{go_on}", ran.found + ran.computed, ran.of));
        }
        if let (None, Some(folder)) = (&answer, &self.output) {
            let done = format!("shard {shard}: {} of {} cases done", ran.found + ran.computed, ran.of);
            console.print(format!("{done}; when all shards are: truegap merge {}", folder.display()))?;
        }
        Ok(answer)
    }
}

/// What a study with its answer comes to.
pub fn outcome(complete: bool) -> Outcome {
    if complete { Outcome::Fine } else { Outcome::LookAt }
}

/// A bar with an estimate of the time left.
pub fn bar(console: &Console) -> ProgressBar {
    if console.quiet {
        return ProgressBar::hidden();
    }
    let bar = ProgressBar::new(1);
    if let Ok(style) = ProgressStyle::with_template("{bar:24} {pos}/{len}  {elapsed} done, {eta} left") {
        bar.set_style(style);
    }
    bar.enable_steady_tick(Duration::from_millis(500));
    bar
}
