//! Command line of the blind generator: write a study, score diagnoses.
//!
//! Limits: `truegap prove` runs the same in one process; this binary is for studies that are kept or handed on.

use anyhow::{Context, Result, ensure};
use clap::{Parser, Subcommand};
use serde_json::Value;
use std::path::{Path, PathBuf};
use truegap_generator::score::{Scored, score, table, truth::Truth};
use truegap_generator::study::open;
use truegap_generator::{Options, Study};

#[derive(Parser)]
#[command(about = "Recordings with a concealed cause: write a study, score diagnoses")]
struct Arguments {
    #[command(subcommand)]
    command: Command,
}

#[derive(Subcommand)]
enum Command {
    /// Write recordings, commitments and the key of a study.
    Study {
        /// Number of cases.
        #[arg(long, default_value_t = 480)]
        cases: usize,
        /// Seed; keep it secret as long as the key is sealed.
        #[arg(long)]
        seed: u64,
        /// Folder to write to.
        #[arg(long)]
        out: PathBuf,
    },
    /// Open the key of a study (or the truth.json files of shared recordings) and score diagnoses.
    Score {
        /// Folder of the study.
        #[arg(long)]
        study: PathBuf,
        /// Folder with CASE/diagnosis.json or CASE.json.
        #[arg(long)]
        diagnoses: PathBuf,
        /// Print the rows as JSON.
        #[arg(long)]
        json: bool,
    },
}

fn main() -> Result<()> {
    match Arguments::parse().command {
        Command::Study { cases, seed, out } => {
            Study::new(seed, cases, Options::default())?.write(&out, |_| ())?;
            println!("{cases} cases in {}; publish the folder without `key`", out.display());
        }
        Command::Score { study, diagnoses, json } => {
            let scored = scored(&study, &diagnoses)?;
            if json {
                println!("{}", serde_json::to_string_pretty(&truegap_generator::score::targets::rows(&scored))?);
            } else {
                print!("{}", table::table(&scored));
            }
        }
    }
    Ok(())
}

/// Every case that has a diagnosis; says how many have none.
fn scored(study: &Path, diagnoses: &Path) -> Result<Vec<Scored>> {
    let truths = truths(study)?;
    let mut scored = Vec::new();
    let mut absent = 0;
    for truth in truths {
        let places = [diagnoses.join(&truth.case).join("diagnosis.json"), diagnoses.join(format!("{}.json", truth.case))];
        let Some(path) = places.iter().find(|path| path.exists()) else {
            absent += 1;
            continue;
        };
        scored.push(score(truth, &json(path)?).with_context(|| path.display().to_string())?);
    }
    ensure!(!scored.is_empty(), "no diagnosis found in {}; expected CASE/diagnosis.json", diagnoses.display());
    if absent > 0 {
        eprintln!("{absent} cases have no diagnosis and are not scored");
    }
    Ok(scored)
}

/// Answers of a study, or the open truths of shared recordings.
fn truths(study: &Path) -> Result<Vec<Truth>> {
    if study.join("commitments.txt").exists() {
        return Ok(open(study)?.iter().map(Truth::from).collect());
    }
    let mut truths = Vec::new();
    for entry in std::fs::read_dir(study).with_context(|| study.display().to_string())? {
        let folder = entry?.path();
        let (file, case) = (folder.join("truth.json"), folder.file_name().unwrap_or_default().to_string_lossy().into_owned());
        if file.exists() {
            let truth = Truth::of_shared(&case, &json(&file)?);
            truths.push(truth.with_context(|| format!("{}: not a truth.json of a blind recording", file.display()))?);
        }
    }
    truths.sort_by(|a, b| a.case.cmp(&b.case));
    Ok(truths)
}

fn json(path: &Path) -> Result<Value> {
    let text = std::fs::read_to_string(path).with_context(|| path.display().to_string())?;
    serde_json::from_str(&text).with_context(|| path.display().to_string())
}
