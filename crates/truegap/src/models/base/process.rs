//! A program that was started: lines to it, lines from it, and its last words.
//!
//! Limits: text; it is ended where nobody asks it any more.

use std::collections::VecDeque;
use std::io::{BufRead, BufReader, Read, Write};
use std::path::{Path, PathBuf};
use std::process::{Child, ChildStdin, Command, Stdio};
use std::sync::mpsc::{Receiver, RecvTimeoutError, Sender, channel, sync_channel};
use std::sync::{Arc, Mutex, PoisonError};
use std::time::{Duration, Instant};
use truegap_core::Inputs;

/// Lines of standard error that are kept.
const LAST_WORDS: usize = 12;
/// Longest line that a program may write, bytes: an answer is a number a line.
const LONGEST_LINE: u64 = 1 << 16;
/// Lines that may wait to be read; a program that writes more waits itself.
const UNREAD: usize = 1 << 16;
/// Time that a program has to say its last words, or to end.
const GRACE: Duration = Duration::from_millis(300);

/// A program that was started.
pub(super) struct Running {
    child: Child,
    /// what is to be written; written elsewhere, since a program that does not read would keep us waiting
    input: Option<Sender<String>>,
    lines: Receiver<String>,
    errors: Arc<Mutex<VecDeque<String>>>,
    /// what it was given last
    pub given: Option<Inputs>,
}

/// A program that is named by a path is looked for in the folder, any other where the system looks.
pub(super) fn program(name: &str, folder: &Path) -> PathBuf {
    let path = Path::new(name);
    let beside = (path.components().count() > 1).then(|| folder.join(path).canonicalize().ok()).flatten();
    beside.unwrap_or_else(|| path.to_owned())
}

/// Why nothing was heard.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(super) enum Silence {
    TooLate,
    Ended,
}

impl Running {
    /// Starts `run` in `folder`.
    pub fn start(run: &[String], folder: &Path) -> std::io::Result<Self> {
        let mut command = Command::new(program(&run[0], folder));
        command.args(&run[1..]).stdin(Stdio::piped()).stdout(Stdio::piped()).stderr(Stdio::piped());
        if !folder.as_os_str().is_empty() {
            command.current_dir(folder);
        }
        // Ctrl-C is for truegap, which ends the program when it is done with it
        #[cfg(unix)]
        std::os::unix::process::CommandExt::process_group(&mut command, 0);
        let mut child = command.spawn()?;
        let input = child.stdin.take().map(write_lines);
        let lines = read_lines(child.stdout.take());
        let errors = keep_last(child.stderr.take());
        Ok(Self { child, input, lines, errors, given: None })
    }

    pub fn say(&mut self, text: &str) -> Result<(), Silence> {
        let input = self.input.as_ref().ok_or(Silence::Ended)?;
        input.send(text.to_owned()).map_err(|_| Silence::Ended)
    }

    pub fn hear(&mut self, until: Instant) -> Result<String, Silence> {
        let left = until.saturating_duration_since(Instant::now());
        self.lines.recv_timeout(left).map_err(|error| match error {
            RecvTimeoutError::Timeout => Silence::TooLate,
            RecvTimeoutError::Disconnected => Silence::Ended,
        })
    }

    pub fn nonsense(&mut self, line: &str, wanted: &str) -> String {
        let line: String = line.chars().take(80).collect();
        format!("wrote `{line}` where `{wanted}` was due; what is not an answer belongs on standard error{}", self.told())
    }

    /// How it ended, and what it said.
    pub fn last_words(&mut self, silence: Silence, timeout: Duration) -> String {
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
    pub fn told(&mut self) -> String {
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

/// Writes what it is sent, and closes the stream when nothing more will come.
fn write_lines(mut stream: ChildStdin) -> Sender<String> {
    let (sender, texts) = channel::<String>();
    std::thread::spawn(move || {
        for text in texts {
            if stream.write_all(text.as_bytes()).and_then(|()| stream.flush()).is_err() {
                break; // it has ended, which is noticed where its answer is waited for
            }
        }
    });
    sender
}

/// Lines of a stream, as they come.
fn read_lines(stream: Option<impl Read + Send + 'static>) -> Receiver<String> {
    let (sender, lines) = sync_channel(UNREAD);
    std::thread::spawn(move || {
        let mut stream = stream.map(BufReader::new);
        while let Some(line) = stream.as_mut().and_then(short_line) {
            if sender.send(line).is_err() {
                break;
            }
        }
    });
    lines
}

/// The next line; `None` at the end, and where a line has no end within [`LONGEST_LINE`].
fn short_line(stream: &mut BufReader<impl Read>) -> Option<String> {
    let mut line = Vec::new();
    let read = stream.take(LONGEST_LINE).read_until(b'\n', &mut line).ok()? as u64;
    let is_whole = read > 0 && (line.ends_with(b"\n") || read < LONGEST_LINE);
    is_whole.then(|| String::from_utf8_lossy(&line).trim_end().to_owned())
}

/// The last lines of a stream.
fn keep_last(stream: Option<impl Read + Send + 'static>) -> Arc<Mutex<VecDeque<String>>> {
    let kept = Arc::new(Mutex::new(VecDeque::new()));
    let shared = kept.clone();
    std::thread::spawn(move || {
        let mut stream = stream.map(BufReader::new);
        while let Some(line) = stream.as_mut().and_then(short_line) {
            let mut last = shared.lock().unwrap_or_else(PoisonError::into_inner);
            last.push_back(line);
            if last.len() > LAST_WORDS {
                last.pop_front();
            }
        }
    });
    kept
}
