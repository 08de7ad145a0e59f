//! `[base] model = "command"`: a program that stays up and answers over its standard streams ([docs/command-base.md](../../../../docs/command-base.md)).
//!
//! Limits: one program, one question at a time; it is started with the first question and ended with the model.

use super::columns::columns;
use std::collections::VecDeque;
use std::fmt::Write as _;
use std::io::{BufRead, BufReader, Read, Write};
use std::path::{Path, PathBuf};
use std::process::{Child, ChildStdin, Command, Stdio};
use std::sync::mpsc::{Receiver, RecvTimeoutError, channel};
use std::sync::{Arc, Mutex, PoisonError};
use std::time::{Duration, Instant};
use truegap_core::{Inputs, SimulationError};
use truegap_model::Responder;

/// First line of either side.
const HELLO: &str = "truegap 1";
/// Lines of standard error that are kept.
const LAST_WORDS: usize = 12;
/// Time that a program has to say its last words, or to end.
const GRACE: Duration = Duration::from_millis(300);

/// A program that answers.
pub(super) struct Program {
    run: Vec<String>,
    folder: PathBuf,
    timeout: Duration,
    /// names of the parameters
    names: Vec<String>,
    running: Mutex<Option<Running>>,
}

/// A program that was started.
struct Running {
    child: Child,
    input: Option<ChildStdin>,
    lines: Receiver<String>,
    errors: Arc<Mutex<VecDeque<String>>>,
    /// what it was given last
    given: Option<Inputs>,
}

impl Program {
    pub(super) fn new(run: Vec<String>, folder: PathBuf, timeout_s: f64, names: Vec<String>) -> Self {
        Self { run, folder, timeout: Duration::from_secs_f64(timeout_s), names, running: Mutex::new(None) }
    }

    fn failed(&self, why: &str) -> SimulationError {
        SimulationError::Program { says: format!("the program `{}` {why}", self.run.join(" ")) }
    }

    fn start(&self) -> Result<Running, SimulationError> {
        let mut command = Command::new(program(&self.run[0], &self.folder));
        command.args(&self.run[1..]).stdin(Stdio::piped()).stdout(Stdio::piped()).stderr(Stdio::piped());
        if !self.folder.as_os_str().is_empty() {
            command.current_dir(&self.folder);
        }
        // Ctrl-C is for truegap, which ends the program when it is done with it
        #[cfg(unix)]
        std::os::unix::process::CommandExt::process_group(&mut command, 0);
        let mut child = command.spawn().map_err(|error| {
            self.failed(&format!("cannot be started in `{}`: {error}; correct run = [...] under [base]", self.folder.display()))
        })?;
        let input = child.stdin.take();
        let lines = read_lines(child.stdout.take());
        let errors = keep_last(child.stderr.take());
        let mut running = Running { child, input, lines, errors, given: None };
        let hello = running.say(&format!("{HELLO}\n")).and_then(|()| running.hear(Instant::now() + self.timeout));
        match hello {
            Ok(line) if line == HELLO => Ok(running),
            Ok(line) => Err(self.failed(&running.nonsense(&line, HELLO))),
            Err(silence) => Err(self.failed(&running.last_words(silence, self.timeout))),
        }
    }

    fn ask(&self, running: &mut Running, values: &[f64], inputs: &Inputs) -> Result<Vec<f64>, SimulationError> {
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
        let silent = |running: &mut Running, silence| Err(self.failed(&running.last_words(silence, self.timeout)));
        if let Err(silence) = running.say(&question) {
            return silent(running, silence);
        }
        let until = Instant::now() + self.timeout;
        let head = match running.hear(until) {
            Ok(line) => line,
            Err(silence) => return silent(running, silence),
        };
        let rows = inputs.len();
        let mut words = head.splitn(2, ' ');
        match (words.next().unwrap_or(""), words.next().unwrap_or("").trim()) {
            ("answer", count) if count.parse() == Ok(rows) => {}
            // no answer at these values, as a number that is none
            ("refuse", _) => return Ok(vec![f64::NAN; rows]),
            ("fail", why) => return Err(self.failed(&format!("failed: {why}{}", running.told()))),
            _ => return Err(self.failed(&running.nonsense(&head, &format!("answer {rows}")))),
        }
        let mut answer = Vec::with_capacity(rows);
        while answer.len() < rows {
            match running.hear(until) {
                Err(silence) => return silent(running, silence),
                Ok(line) => match line.trim().parse() {
                    Ok(value) => answer.push(value),
                    Err(_) => {
                        return Err(self.failed(&running.nonsense(&line, &format!("number {} of {rows}", answer.len() + 1))));
                    }
                },
            }
        }
        Ok(answer)
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

/// A program that is named by a path is looked for in the folder, any other where the system looks.
fn program(name: &str, folder: &Path) -> PathBuf {
    let path = Path::new(name);
    let beside = (path.components().count() > 1).then(|| folder.join(path).canonicalize().ok()).flatten();
    beside.unwrap_or_else(|| path.to_owned())
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

/// Why nothing was heard.
#[derive(Clone, Copy, Debug, PartialEq)]
enum Silence {
    TooLate,
    Ended,
}

impl Running {
    fn say(&mut self, text: &str) -> Result<(), Silence> {
        let input = self.input.as_mut().ok_or(Silence::Ended)?;
        input.write_all(text.as_bytes()).and_then(|()| input.flush()).map_err(|_| Silence::Ended)
    }

    fn hear(&mut self, until: Instant) -> Result<String, Silence> {
        let left = until.saturating_duration_since(Instant::now());
        self.lines.recv_timeout(left).map_err(|error| match error {
            RecvTimeoutError::Timeout => Silence::TooLate,
            RecvTimeoutError::Disconnected => Silence::Ended,
        })
    }

    fn nonsense(&mut self, line: &str, wanted: &str) -> String {
        let line: String = line.chars().take(80).collect();
        format!("wrote `{line}` where `{wanted}` was due; what is not an answer belongs on standard error{}", self.told())
    }

    /// How it ended, and what it said.
    fn last_words(&mut self, silence: Silence, timeout: Duration) -> String {
        let how = match silence {
            Silence::TooLate => {
                let seconds = timeout.as_secs_f64();
                format!("gave no answer in {seconds} s; give it longer as timeout = \"{} s\" under [base]", 10.0 * seconds)
            }
            Silence::Ended => match self.ended(GRACE) {
                Some(status) => format!("ended before it answered ({status})"),
                None => "closed its output before it answered".to_owned(),
            },
        };
        how + &self.told()
    }

    /// What stands on its standard error, as the end of a sentence.
    fn told(&mut self) -> String {
        std::thread::sleep(GRACE / 3); // what was written last may still be on its way
        let errors = self.errors.lock().unwrap_or_else(PoisonError::into_inner);
        match errors.is_empty() {
            true => "; it wrote nothing to standard error".to_owned(),
            false => {
                format!("; its last words:\n{}", errors.iter().map(|line| format!("  | {line}")).collect::<Vec<_>>().join("\n"))
            }
        }
    }

    fn ended(&mut self, within: Duration) -> Option<std::process::ExitStatus> {
        let until = Instant::now() + within;
        loop {
            match self.child.try_wait() {
                Ok(Some(status)) => return Some(status),
                Ok(None) if Instant::now() < until => std::thread::sleep(Duration::from_millis(5)),
                _ => return None,
            }
        }
    }
}

impl Drop for Running {
    /// The end of its input is the sign to end; a program that does not is ended.
    fn drop(&mut self) {
        self.input = None;
        if self.ended(GRACE).is_none() {
            let _ = self.child.kill(); // it may have ended by itself meanwhile
            let _ = self.child.wait();
        }
    }
}

/// Lines of a stream, as they come.
fn read_lines(stream: Option<impl Read + Send + 'static>) -> Receiver<String> {
    let (sender, lines) = channel();
    std::thread::spawn(move || {
        for line in stream.into_iter().flat_map(|stream| BufReader::new(stream).lines()) {
            let Ok(line) = line else { break };
            if sender.send(line.trim_end().to_owned()).is_err() {
                break;
            }
        }
    });
    lines
}

/// The last lines of a stream.
fn keep_last(stream: Option<impl Read + Send + 'static>) -> Arc<Mutex<VecDeque<String>>> {
    let kept = Arc::new(Mutex::new(VecDeque::new()));
    let shared = kept.clone();
    std::thread::spawn(move || {
        for line in stream.into_iter().flat_map(|stream| BufReader::new(stream).split(b'\n')) {
            let Ok(line) = line else { break };
            let mut last = shared.lock().unwrap_or_else(PoisonError::into_inner);
            last.push_back(String::from_utf8_lossy(&line).trim_end().to_owned());
            if last.len() > LAST_WORDS {
                last.pop_front();
            }
        }
    });
    kept
}
