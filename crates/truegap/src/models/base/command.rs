//! `[base] model = "command"`: a program that stays up and answers over its standard streams ([docs/command-base.md](../../../../docs/command-base.md)).
//!
//! Limits: one program, one question at a time; it is started with the first question and ended with the model.

use super::columns::columns;
use super::process::{Running, Silence};
use std::fmt::Write as _;
use std::path::PathBuf;
use std::sync::{Mutex, PoisonError};
use std::time::{Duration, Instant};
use truegap_core::{Inputs, SimulationError};
use truegap_model::Responder;

/// First line of either side.
const HELLO: &str = "truegap 1";

/// A program that answers.
pub(super) struct Program {
    run: Vec<String>,
    folder: PathBuf,
    timeout: Duration,
    /// names of the parameters
    names: Vec<String>,
    running: Mutex<Option<Running>>,
}

impl Program {
    pub(super) fn new(run: Vec<String>, folder: PathBuf, timeout_s: f64, names: Vec<String>) -> Self {
        Self { run, folder, timeout: Duration::from_secs_f64(timeout_s), names, running: Mutex::new(None) }
    }

    fn failed(&self, why: &str) -> SimulationError {
        SimulationError::Program { says: format!("the program `{}` {why}", self.run.join(" ")) }
    }

    /// The program, once both sides have said which version they speak.
    fn start(&self) -> Result<Running, SimulationError> {
        let started = Running::start(&self.run, &self.folder);
        let mut running = started.map_err(|error| {
            self.failed(&format!("cannot be started in `{}`: {error}; correct run = [...] under [base]", self.folder.display()))
        })?;
        let hello = running.say(&format!("{HELLO}\n")).and_then(|()| running.hear(Instant::now() + self.timeout));
        match hello {
            Ok(line) if line == HELLO => Ok(running),
            Ok(line) => Err(self.failed(&running.nonsense(&line, HELLO))),
            Err(silence) => Err(self.failed(&running.last_words(silence, self.timeout))),
        }
    }

    /// Why there was no answer, with the names that the program was given: of these alone it may ask.
    fn gave_none(&self, running: &mut Running, silence: Silence, inputs: &Inputs) -> SimulationError {
        let columns = columns(inputs);
        let columns: Vec<&str> = columns.iter().map(|(name, _)| name.as_ref()).collect();
        let given = format!("it was given the columns {} and the parameters {}", columns.join(", "), self.names.join(", "));
        let words = running.last_words(silence, self.timeout);
        self.failed(&match silence {
            Silence::Ended => format!("{words}\n{given}"),
            Silence::TooLate => words,
        })
    }

    /// Inputs where they have changed, then the parameters.
    fn question(&self, running: &mut Running, values: &[f64], inputs: &Inputs) -> Result<String, SimulationError> {
        let mut question = String::new();
        if running.given.as_ref() != Some(inputs) {
            question = given(inputs).map_err(|why| self.failed(&why))?;
            running.given = Some(inputs.clone());
        }
        question.push_str("ask");
        self.names.iter().zip(values).for_each(|(name, value)| {
            let _ = write!(question, " {name}={value}"); // writing to a String cannot fail
        });
        question.push('\n');
        Ok(question)
    }

    fn ask(&self, running: &mut Running, values: &[f64], inputs: &Inputs) -> Result<Vec<f64>, SimulationError> {
        let question = self.question(running, values, inputs)?;
        let (until, rows) = (Instant::now() + self.timeout, inputs.len());
        let head = running.say(&question).and_then(|()| running.hear(until));
        let head = head.map_err(|silence| self.gave_none(running, silence, inputs))?;
        let (word, rest) = head.split_once(' ').unwrap_or((&head, ""));
        match word {
            "answer" if rest.trim().parse() == Ok(rows) => (0..rows).map(|row| self.number(running, until, row, rows)).collect(),
            // no answer at these values, as a number that is none
            "refuse" => Ok(vec![f64::NAN; rows]),
            "fail" => Err(self.failed(&format!("failed: {rest}{}", running.told()))),
            _ => Err(self.failed(&running.nonsense(&head, &format!("answer {rows}")))),
        }
    }

    fn number(&self, running: &mut Running, until: Instant, row: usize, rows: usize) -> Result<f64, SimulationError> {
        let line = running.hear(until).map_err(|silence| self.failed(&running.last_words(silence, self.timeout)))?;
        let wanted = || format!("number {} of {rows}", row + 1);
        line.trim().parse().map_err(|_| self.failed(&running.nonsense(&line, &wanted())))
    }
}

impl Responder for Program {
    fn respond(&self, values: &[f64], inputs: &Inputs) -> Result<Vec<f64>, SimulationError> {
        // a question that panicked has left no half of a line behind that a new program would read
        let mut running = self.running.lock().unwrap_or_else(PoisonError::into_inner);
        let mut program = match running.take() {
            Some(program) => program,
            None => self.start()?,
        };
        let answer = self.ask(&mut program, values, inputs)?;
        *running = Some(program);
        Ok(answer)
    }
}

/// The inputs as text: a line of names, then a line a row.
fn given(inputs: &Inputs) -> Result<String, String> {
    let columns = columns(inputs);
    let mut text = format!("inputs {}", inputs.len());
    for (name, _) in &columns {
        if name.contains(char::is_whitespace) {
            return Err(format!("cannot be given the column `{name}`: its name has a blank in it; rename it under [drivers]"));
        }
        let _ = write!(text, " {name}"); // writing to a String cannot fail
    }
    text.push('\n');
    for row in 0..inputs.len() {
        for (index, (_, column)) in columns.iter().enumerate() {
            let _ = write!(text, "{}{}", if index == 0 { "" } else { " " }, column[row]);
        }
        text.push('\n');
    }
    Ok(text)
}
