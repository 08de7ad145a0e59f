//! `truegap diagnose`: where simulation and recording differ, what was left out, and whether it predicts what the fit has not seen.
//!
//! Limits: reads, calls, prints; Ctrl-C ends the search with what is known ([`super::stop`]).

use super::progress::{Line, above};
use super::run::{Outcome, Run};
use super::stop::{STOP, is_stopped, stop_on_interrupt};
use super::told::TellArgs;
use super::typed::command_line;
use crate::console::Console;
use std::path::{Path, PathBuf};
use truegap::diagnose::answer::Finding;
use truegap::diagnose::{Library, Progress, Verdict};
use truegap::diagnosis::confirm::{Free, confirm_within, other};
use truegap::diagnosis::report::terminal;
use truegap::diagnosis::{Diagnosed, FILES, Pace, Request, cache_folder, diagnose, files_read, open, pace, recorded};
use truegap::models::with_effects;
use truegap::{OutputFolder, Recording};

/// Say what physics a simulation leaves out of a recording, and show it
#[derive(Debug, clap::Args)]
pub struct Diagnose {
    /// TOML or table (CSV, Parquet, Arrow) of a recording, a folder with a recording.toml, or `example` for the built-in one; several are diagnosed together: one physics, each with its own noise, clock and runs
    #[arg(required = true, value_name = "RECORDING")]
    recordings: Vec<PathBuf>,
    /// Folder for report.html, diagnosis.json, augmented.toml and prediction.csv
    #[arg(long, short, value_name = "DIR", default_value = "diagnosis")]
    output: PathBuf,
    /// Diagnose each recording by itself, into a folder of its own below --output
    #[arg(long)]
    batch: bool,
    #[command(flatten)]
    tell: TellArgs,
    /// Sensor in place of the recording's: built-in name or path of a sensor's TOML
    #[arg(long)]
    sensor: Option<String>,
    /// Base model in place of the recording's: stack, linear, parallel-plate, gap-plate, table, constant, external; a program of your own, `command`, stands under `base` of a TOML
    #[arg(long, value_name = "MODEL")]
    base: Option<String>,
    /// Leave the warp of the electrode out of the base model
    #[arg(long)]
    no_warp: bool,
    /// Try these effects only
    #[arg(long, value_delimiter = ',', value_name = "A,B,C")]
    effects: Vec<String>,
    /// Effect of your own beside the library: a mechanism's TOML, as `discovered.toml` of another recording; may be given several times
    #[arg(long = "effect", value_name = "FILE")]
    effect_files: Vec<PathBuf>,
    /// Try no mechanisms beyond the library
    #[arg(long)]
    library_only: bool,
    /// Choose what is missing again without each part of the recording: is the same named, and how well does that predict the part? Takes as many searches as there are parts
    #[arg(long)]
    select_in_folds: bool,
    /// Search N permuted histories as well: how often does the whole search find as much where there is nothing to find? Takes N times as long
    #[arg(long, value_name = "N", num_args = 0..=1, default_missing_value = "19", value_parser = clap::value_parser!(u32).range(1..=999))]
    permuted_searches: Option<u32>,
    /// Hide an input column, to see what its absence does: temperature, humidity, force, pressure, gap
    #[arg(long, value_delimiter = ',', value_name = "COLUMN")]
    conceal: Vec<String>,
    /// Give each recording after the first its own gain or offset against the first, and that of --confirm as well: gain, offset, or gain,offset; that of --confirm may have its own clock, too: gain,offset,clock
    #[arg(long, value_delimiter = ',', value_name = "WHAT", conflicts_with = "batch")]
    free: Vec<String>,
    /// Recording that takes no part: what is found is judged on it, with nothing refitted but what --free names
    #[arg(long, value_name = "OTHER", conflicts_with = "batch")]
    confirm: Option<PathBuf>,
    /// Sensor column of a recording that holds several
    #[arg(long, value_name = "NAME")]
    channel: Option<String>,
    /// Simulate recordings with known causes on this protocol, diagnose them too, and correct the probabilities by how often they were right
    #[arg(long, value_name = "N", num_args = 0..=1, default_missing_value = "150", value_parser = clap::value_parser!(u32).range(30..=5000))]
    bank: Option<u32>,
    /// Folder in which the answers of a slow program (model "command") are kept for the next diagnosis; `truegap/answers` in the user's cache folder where none is given
    #[arg(long, value_name = "DIR")]
    cache: Option<PathBuf>,
    /// Ask a program for everything afresh and keep none of its answers
    #[arg(long, conflicts_with = "cache")]
    no_cache: bool,
}

impl Run for Diagnose {
    fn run(&self, console: &Console) -> anyhow::Result<Outcome> {
        stop_on_interrupt(console)?;
        if self.batch {
            return self.each(console);
        }
        let read: Vec<PathBuf> = self.recordings.iter().chain(&self.confirm).flat_map(|path| files_read(path)).collect();
        OutputFolder::check_spares(&self.output, &FILES, &read)?;
        OutputFolder::check(&self.output, &FILES)?;
        let diagnosed = self.all(&Line::begin(console, "reading"), console)?;
        let folder = diagnosed.write(&self.output)?;
        if console.json {
            console.print_json(&diagnosed.outcome.diagnosis)?;
        } else {
            console.print(terminal::summary(&diagnosed.outcome.diagnosis))?;
            console.print(format!("Report: {}", folder.join("report.html").display()))?;
        }
        Ok(outcome(&diagnosed))
    }
}

impl Diagnose {
    /// The recording of --confirm, where it is one that may judge these, and what is free in it.
    fn other(&self, took_part: &[Recording]) -> anyhow::Result<Option<(Recording, Free)>> {
        let Some(path) = &self.confirm else { return Ok(None) };
        let free = Free::of(&self.free)?;
        let recording = recorded(path, &self.tell.told())?;
        let channel = self.channel.as_deref().filter(|_| recording.sensors.is_some());
        Ok(Some((other(recording, channel, took_part)?, free)))
    }

    /// All recordings as one physics, judged on that of --confirm.
    fn all(&self, line: &Line, console: &Console) -> anyhow::Result<Diagnosed> {
        let recordings = self.read(&self.recordings)?;
        let other = self.other(&recordings)?;
        let mut diagnosed = self.one(&self.recordings, recordings, line, console)?;
        if let Some((other, free)) = other {
            confirm_within(&mut diagnosed, other, free);
        }
        Ok(diagnosed)
    }

    /// What each recording after the first has of its own: with one recording it is that of --confirm alone that has anything; the clock is its own always.
    fn free_beside_the_first(&self) -> Vec<String> {
        match (&self.confirm, self.recordings.len()) {
            (Some(_), 1) => Vec::new(),
            (Some(_), _) => self.free.iter().filter(|word| *word != "clock").cloned().collect(),
            (None, _) => self.free.clone(),
        }
    }

    fn read(&self, paths: &[PathBuf]) -> anyhow::Result<Vec<Recording>> {
        paths.iter().map(|path| Ok(recorded(path, &self.tell.told())?)).collect()
    }

    fn one(&self, paths: &[PathBuf], recordings: Vec<Recording>, line: &Line, console: &Console) -> anyhow::Result<Diagnosed> {
        let files = paths.iter().zip(&recordings).map(|(path, r)| (path.display().to_string(), r.sha256.clone())).collect();
        let request = self.request(recordings.first())?;
        let opened = open(recordings, &request)?;
        above(|| opened.recording.notes.iter().for_each(|note| console.note(note)));
        if let Some(pace) = pace(&opened).filter(Pace::is_slow) {
            above(|| console.note(pace));
        }
        Ok(diagnose(opened, files, &request, &|p: Progress| line.tell(&p), &STOP)?)
    }

    /// Every recording by itself; one that cannot be diagnosed is named and does not keep the others waiting.
    fn each(&self, console: &Console) -> anyhow::Result<Outcome> {
        let (mut found, mut failed) = (false, 0);
        let names = case_names(&self.recordings);
        names.iter().try_for_each(|name| OutputFolder::check(self.output.join(name), &FILES))?;
        for (path, name) in self.recordings.iter().zip(names) {
            if is_stopped() {
                break;
            }
            let paths = std::slice::from_ref(path);
            let line_drawn = Line::begin(console, &format!("reading {name}"));
            let done = self.read(paths).and_then(|read| self.one(paths, read, &line_drawn, console)).and_then(|diagnosed| {
                diagnosed.write(&self.output.join(&name))?;
                Ok(diagnosed)
            });
            drop(line_drawn);
            match done {
                Ok(diagnosed) => {
                    found |= outcome(&diagnosed) == Outcome::LookAt;
                    match console.json {
                        true => console.print_json(&diagnosed.outcome.diagnosis)?,
                        false => console.print(line(&name, &diagnosed))?,
                    }
                }
                Err(error) => {
                    failed += 1;
                    console.fail(&error);
                }
            }
        }
        anyhow::ensure!(
            failed == 0,
            "{failed} of {} recordings could not be diagnosed; their reasons are above",
            self.recordings.len()
        );
        Ok(if found { Outcome::LookAt } else { Outcome::Fine })
    }

    fn answers(&self) -> Option<PathBuf> {
        if self.no_cache { None } else { self.cache.clone().or_else(|| cache_folder("answers")) }
    }

    fn request(&self, recording: Option<&Recording>) -> anyhow::Result<Request> {
        let library = with_effects(Library::default(), &self.effect_files, recording)?;
        Ok(Request {
            sensor: self.sensor.clone(),
            base: self.base.clone(),
            library,
            library_only: self.library_only,
            select_in_folds: self.select_in_folds,
            permuted_searches: self.permuted_searches.map_or(0, |n| n as usize),
            no_warp: self.no_warp,
            effects: self.effects.clone(),
            conceal: self.conceal.clone(),
            channel: self.channel.clone(),
            free: self.free_beside_the_first(),
            bank: self.bank.map(|n| n as usize),
            answers: self.answers(),
            command: command_line(),
        })
    }
}

fn outcome(diagnosed: &Diagnosed) -> Outcome {
    let diagnosis = &diagnosed.outcome.diagnosis;
    if diagnosis.verdict == Verdict::Agrees && diagnosis.notices.is_empty() { Outcome::Fine } else { Outcome::LookAt }
}

/// One line of a batch: name, verdict, findings with their probability, seconds.
fn line(name: &str, diagnosed: &Diagnosed) -> String {
    let diagnosis = &diagnosed.outcome.diagnosis;
    let seen = |d: Option<f64>| d.map_or(String::new(), |d| format!(" (d {d:.1})"));
    let told = |f: &Finding| format!("{} {:.3}{}", f.effect, f.probability, seen(f.detectability));
    let found: Vec<String> = diagnosis.findings.iter().map(told).collect();
    let sets: Vec<String> = diagnosis.ambiguity.iter().map(|set| set.join("|")).collect();
    let verdict = diagnosis.verdict.word();
    format!("{name}  {verdict:11}  {}  {}  {:.1} s", found.join(" + "), sets.join("; "), diagnosis.seconds)
}

/// Name of a recording's own folder: its file's, or its folder's where all files are called the same.
fn case_name(path: &Path) -> String {
    let stem = path.file_stem().map(|s| s.to_string_lossy().into_owned()).unwrap_or_default();
    let parent = path.parent().and_then(Path::file_name).map(|p| p.to_string_lossy().into_owned());
    match parent {
        Some(parent) if stem == "recording" => parent,
        _ if stem.is_empty() => "recording".into(),
        _ => stem,
    }
}

/// A folder's name for each recording, no two alike: `run.csv` of folders `a` and `b` are `a-run` and `b-run`, the same file twice `run` and `run-2`.
fn case_names(paths: &[PathBuf]) -> Vec<String> {
    let short: Vec<String> = paths.iter().map(|path| case_name(path)).collect();
    let alone = |name: &String| short.iter().filter(|other| *other == name).count() == 1;
    let mut names: Vec<String> = Vec::new();
    for (path, name) in paths.iter().zip(&short) {
        let parent = path.parent().and_then(Path::file_name).map(|p| p.to_string_lossy().into_owned());
        let longer = match parent {
            Some(parent) if !alone(name) && parent != *name => format!("{parent}-{name}"),
            _ => name.clone(),
        };
        let numbered = (2..).map(|number| format!("{longer}-{number}"));
        let free = std::iter::once(longer.clone()).chain(numbered).find(|name| !names.contains(name));
        names.extend(free);
    }
    names
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_case_is_named_after_what_tells_it_apart() {
        assert_eq!(case_name(Path::new("open/case-01/recording.toml")), "case-01");
        assert_eq!(case_name(Path::new("open/case-01")), "case-01");
        assert_eq!(case_name(Path::new("insole/hold.toml")), "hold");
    }

    #[test]
    fn no_recording_of_a_batch_takes_the_folder_of_another() {
        let names = |paths: &[&str]| case_names(&paths.iter().map(PathBuf::from).collect::<Vec<_>>());
        assert_eq!(names(&["a/run.csv", "b/run.csv", "b/hold.csv"]), ["a-run", "b-run", "hold"]);
        assert_eq!(names(&["run.csv", "run.toml", "run-2.csv"]), ["run", "run-2", "run-2-2"]);
        assert_eq!(names(&["x/a/run.csv", "y/a/run.csv"]), ["a-run", "a-run-2"]);
        assert_eq!(names(&["s/case-1", "t/case-1/recording.toml"]), ["s-case-1", "case-1"]);
    }
}
