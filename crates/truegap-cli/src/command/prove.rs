//! `truegap prove`: a blind study that anyone can run.
//!
//! Limits: reads, calls, prints; a first Ctrl-C keeps what is done for `--resume`, a second one ends the program.

use super::run::{Outcome, Run};
use super::stop::{STOP, stop_on_interrupt};
use crate::console::Console;
use indicatif::{ProgressBar, ProgressStyle};
use std::path::PathBuf;
use std::time::Duration;
use truegap::prove::{self, Kind, Plan, Score, Sort, Told};

/// Conceal causes in recordings, diagnose them blindly, open the key and count
#[derive(Debug, clap::Args)]
pub struct Prove {
    /// How many recordings [default: 480]
    #[arg(long, value_name = "N", value_parser = clap::value_parser!(u32).range(1..=100_000))]
    cases: Option<u32>,
    /// Seed of everything that is drawn; drawn itself where it is not given
    #[arg(long, value_name = "S")]
    seed: Option<u64>,
    /// Folder for the study, the diagnoses, score.json and score.md
    #[arg(long, short, value_name = "DIR", default_value = "study")]
    output: PathBuf,
    /// Conceal one sort of thing only, to count it well: nulls, singles, pairs, strangers, loggers (nothing concealed, the troubles of measuring chains in turn), wild (protocols nobody planned, loggers as they are, a bath of weak imperfections, causes outside the library)
    #[arg(long, value_name = "SORT", value_parser = named::<Sort>, conflicts_with = "resume")]
    only: Option<Sort>,
    /// Protocols to draw from: full, thermal, mechanical, short, bench, uneven, worn; hand, grasps, shelf, oven, shaker, table; the first seven where not given, the others where the study is wild
    #[arg(long, value_name = "A,B,C", value_delimiter = ',', value_parser = named::<Kind>, conflicts_with = "resume")]
    protocols: Vec<Kind>,
    /// Leave each effect out of the library in turn and diagnose a recording that conceals just this one: what do the words say of it?
    #[arg(long, conflicts_with_all = ["resume", "only", "cases", "protocols"])]
    without_each: bool,
    /// Recordings for each effect that is left out
    #[arg(long, value_name = "N", default_value_t = 1, requires = "without_each", value_parser = clap::value_parser!(u16).range(1..=1000))]
    each: u16,
    /// Go on with the study in the folder
    #[arg(long)]
    resume: bool,
    /// Diagnoses at a time; each uses all cores where it can
    #[arg(long, value_name = "J", default_value_t = 1, value_parser = clap::value_parser!(u16).range(1..=256))]
    jobs: u16,
}

impl Run for Prove {
    fn run(&self, console: &Console) -> anyhow::Result<Outcome> {
        stop_on_interrupt(console)?;
        let plan = self.study(console)?;
        self.commit(&plan, console)?;
        let bar = bar(console, plan.cases as u64);
        bar.enable_steady_tick(Duration::from_secs(1));
        let told = |told: Told| {
            bar.set_length(told.of as u64);
            bar.set_position(told.done as u64);
            bar.set_message(told.case);
        };
        let answered = prove::answer(&self.output, usize::from(self.jobs), &told, &STOP);
        bar.finish_and_clear();
        let answered = answered?;
        anyhow::ensure!(
            answered.is_complete(),
            "stopped with {} of {} cases diagnosed, and the key closed; go on with: truegap prove --resume -o {}",
            answered.answered,
            answered.cases,
            self.output.display()
        );
        let score = prove::score(&self.output, &self.command(&plan))?;
        self.tell(&score, console)
    }
}

impl Prove {
    fn study(&self, console: &Console) -> anyhow::Result<Plan> {
        let bar = bar(console, u64::from(self.cases.unwrap_or(480)));
        let made = |index: usize| bar.set_position(index as u64 + 1);
        let plan = if self.resume {
            prove::resume(&self.output, self.seed, self.cases.map(|n| n as usize))
        } else {
            let seed = self.seed.unwrap_or_else(prove::entropy);
            let plan = self.plan(seed);
            prove::begin(&plan, &self.output, made).map(|()| plan)
        };
        bar.finish_and_clear();
        Ok(plan?)
    }

    fn plan(&self, seed: u64) -> Plan {
        if self.without_each {
            return Plan::without_each(seed, usize::from(self.each));
        }
        let only = self.only.unwrap_or_default();
        Plan { seed, cases: self.cases.unwrap_or(480) as usize, only, protocols: self.protocols.clone() }
    }

    /// What binds the study to its answers, before anything is diagnosed.
    fn commit(&self, plan: &Plan, console: &Console) -> anyhow::Result<()> {
        let file = self.output.join("commitments.txt");
        let Plan { cases, seed, .. } = plan;
        console.note(format!("{cases} cases from seed {seed}, answers committed to in {}", file.display()));
        if !console.json {
            console.print(std::fs::read_to_string(file)?)?;
        }
        Ok(())
    }

    fn tell(&self, score: &Score, console: &Console) -> anyhow::Result<Outcome> {
        if console.json {
            console.print_json(score)?;
        } else {
            console.print(score.text())?;
            console.print(format!("Seed {}. Scores: {}", score.plan.seed, self.output.join("score.md").display()))?;
        }
        Ok(if score.is_met() { Outcome::Fine } else { Outcome::LookAt })
    }

    /// The command that makes the same study again.
    fn command(&self, plan: &Plan) -> String {
        let word = |value: serde_json::Value| value.as_str().unwrap_or_default().to_owned();
        if plan.only == Sort::WithoutEach {
            let each = Plan::without_each(plan.seed, 1).cases;
            let each = plan.cases / each.max(1);
            return format!("truegap prove --without-each --each {each} --seed {} -o {}", plan.seed, self.output.display());
        }
        let mut command = format!("truegap prove --cases {} --seed {} -o {}", plan.cases, plan.seed, self.output.display());
        if plan.only != Sort::Everything {
            command += &format!(" --only {}", word(serde_json::json!(plan.only)));
        }
        if !plan.protocols.is_empty() {
            let kinds: Vec<String> = plan.protocols.iter().map(|kind| word(serde_json::json!(kind))).collect();
            command += &format!(" --protocols {}", kinds.join(","));
        }
        command
    }
}

/// A value by its name in files.
fn named<T: serde::de::DeserializeOwned>(text: &str) -> Result<T, String> {
    serde_json::from_value(serde_json::Value::String(text.to_owned())).map_err(|error| error.to_string())
}

fn bar(console: &Console, length: u64) -> ProgressBar {
    if console.quiet {
        return ProgressBar::hidden();
    }
    let bar = ProgressBar::new(length);
    if let Ok(style) = ProgressStyle::with_template("{bar:24} {pos} of {len}  {wide_msg}  {elapsed}, {eta} to go") {
        bar.set_style(style);
    }
    bar
}
