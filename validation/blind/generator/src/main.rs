//! Command line of the blind generator: write a study, score diagnoses.
//!
//! Limits: `truegap prove` runs the same in one process; this binary is for studies that are kept or handed on.

use anyhow::Result;
use clap::{Parser, Subcommand, ValueEnum};
use std::path::PathBuf;
use truegap_generator::score::{folder::score_folder, table, targets};
use truegap_generator::settings::Only;
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
        /// Conceal one sort of cause only, to count it well.
        #[arg(long, value_enum, default_value = "everything")]
        only: Sort,
        /// Least detectability asked of a cause.
        #[arg(long, default_value_t = 4.0)]
        from: f64,
        /// Largest.
        #[arg(long, default_value_t = 120.0)]
        to: f64,
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

#[derive(Clone, Copy, ValueEnum)]
enum Sort {
    Everything,
    Nulls,
    Singles,
    Pairs,
    Strangers,
    Loggers,
    WithoutEach,
    Wild,
}

impl From<Sort> for Only {
    fn from(sort: Sort) -> Self {
        match sort {
            Sort::Everything => Self::Everything,
            Sort::Nulls => Self::Nulls,
            Sort::Singles => Self::Singles,
            Sort::Pairs => Self::Pairs,
            Sort::Strangers => Self::Strangers,
            Sort::Loggers => Self::Loggers,
            Sort::WithoutEach => Self::WithoutEach,
            Sort::Wild => Self::Wild,
        }
    }
}

fn main() -> Result<()> {
    match Arguments::parse().command {
        Command::Study { cases, seed, out, only, from, to } => {
            let options = Options { only: only.into(), detectability_from: from, detectability_to: to, ..Options::default() };
            let plan = serde_json::json!({"seed": seed, "cases": cases, "options": options});
            Study::new(seed, cases, options)?.write(&out, &format!("{plan:#}\n"), |_| ())?;
            println!("{cases} cases in {}; publish the folder without `key`", out.display());
        }
        Command::Score { study, diagnoses, json } => {
            let scores = score_folder(&study, &diagnoses)?;
            if json {
                println!("{}", serde_json::to_string_pretty(&targets::rows(&scores.scored))?);
            } else {
                print!("{}", table::table(&scores.scored));
            }
            if !scores.absent.is_empty() {
                eprintln!("not scored, no diagnosis: {}", scores.absent.join(", "));
            }
        }
    }
    Ok(())
}
