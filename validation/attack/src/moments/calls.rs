//! The calls by which a command changes files, and the command broken at one of them.
//!
//! Limits: `strace` counts the calls of a name in each thread for itself.

use super::jobs::Job;
use crate::bench::lay;
use std::collections::HashMap;
use std::fmt;
use std::fs;
use std::io;
use std::path::{Path, PathBuf};
use std::process::{Command, Stdio};

/// Calls that change what a folder holds, on the machines that Linux runs on.
const CHANGES: [&str; 14] = [
    "openat",
    "write",
    "pwrite64",
    "mkdir",
    "mkdirat",
    "rename",
    "renameat",
    "renameat2",
    "unlink",
    "unlinkat",
    "rmdir",
    "fsync",
    "ftruncate",
    "copy_file_range",
];
/// Those of them that a full disk does not refuse.
const FREES: [&str; 3] = ["unlink", "unlinkat", "rmdir"];

/// One call.
#[derive(Clone, Debug)]
pub struct Call {
    name: String,
    /// number among the calls of this name in its thread, from 1
    number: usize,
    /// as `strace` shows it
    shown: String,
}

impl Call {
    /// Whether a full disk can refuse it.
    pub fn takes_space(&self) -> bool {
        !FREES.contains(&self.name.as_str())
    }
}

impl fmt::Display for Call {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        write!(f, "{}", self.shown.chars().take(140).collect::<String>())
    }
}

/// What happens at a call.
#[derive(Clone, Copy, Debug)]
pub enum Fault {
    /// `kill -9`, before it is carried out
    Kill,
    /// a full disk
    NoSpace,
}

/// A folder in which a command runs, and the one around it.
pub struct Place {
    around: tempfile::TempDir,
    /// the folder
    pub work: PathBuf,
}

impl Place {
    /// A folder as a command finds it.
    ///
    /// # Errors
    /// [`io::Error`] where it cannot be made, or what runs before is refused.
    pub fn laid(truegap: &Path, job: &Job) -> io::Result<Self> {
        let around = tempfile::tempdir()?;
        let place = Self { work: around.path().join("work"), around };
        fs::create_dir(&place.work)?;
        job.put.iter().try_for_each(|put| lay(&place.work, put))?;
        for typed in job.earlier {
            let ran = undisturbed(truegap, typed, &place)?;
            if !matches!(ran.code, Some(0 | 1)) {
                return Err(io::Error::other(format!("{typed:?}: {ran:?}")));
            }
        }
        Ok(place)
    }
}

/// What a command said.
#[derive(Clone, Debug)]
pub struct Ran {
    /// `None` where it was killed
    pub code: Option<i32>,
    /// errors and notes
    pub err: String,
}

impl Ran {
    /// What is wrong with a refusal: it is one paragraph that names a file of the folder.
    pub fn unlike_a_refusal(&self, job: &Job) -> Option<String> {
        // the fault hit the writing of the message as well, in another thread
        if !self.err.ends_with('\n') {
            return None;
        }
        let paragraphs = self.err.lines().filter(|line| line.starts_with("error: ")).count();
        let named = job.names.iter().any(|name| self.err.contains(name));
        (paragraphs != 1 || !named || self.err.contains("panicked"))
            .then(|| format!("it does not name the file: {}", self.err.trim()))
    }
}

fn ran(mut command: Command, place: &Path) -> io::Result<Ran> {
    let output = command.current_dir(place).stdin(Stdio::null()).envs([("RAYON_NUM_THREADS", "1"), ("RUST_BACKTRACE", "0")]);
    let output = output.env("XDG_CACHE_HOME", place.join(".cache")).env_remove("TRUEGAP_CACHE").output()?;
    Ok(Ran { code: output.status.code(), err: String::from_utf8_lossy(&output.stderr).into_owned() })
}

/// A command as it is typed.
///
/// # Errors
/// [`io::Error`] where it cannot be started.
pub fn undisturbed(truegap: &Path, typed: &[&str], place: &Place) -> io::Result<Ran> {
    let mut command = Command::new(truegap);
    command.args(typed);
    ran(command, &place.work)
}

/// The calls by which a command changes files, in their order.
///
/// # Errors
/// [`io::Error`] where `strace` cannot be started.
pub fn listed(truegap: &Path, job: &Job, place: &Place) -> io::Result<(Ran, Vec<Call>)> {
    let log = place.around.path().join("calls");
    let mut command = Command::new("strace");
    command
        .args(["-f", "-qq", "-y", "-s", "60", "-e", "signal=none", "-e"])
        .arg(format!("trace={}", known_here()?))
        .arg("-o")
        .arg(&log);
    command.arg("--").arg(truegap).args(job.typed);
    let said = ran(command, &place.work)?;
    let (text, work) = (fs::read_to_string(&log)?, place.work.to_string_lossy().into_owned());
    let mut numbers: HashMap<(&str, &str), usize> = HashMap::new();
    let mut calls = Vec::new();
    for line in text.lines() {
        let Some((thread, call)) = line.split_once(' ') else { continue };
        let Some((name, arguments)) = call.trim_start().split_once('(') else { continue };
        if !CHANGES.contains(&name) {
            continue;
        }
        let number = numbers.entry((thread, name)).and_modify(|n| *n += 1).or_insert(1);
        let changes = match name {
            "openat" => arguments.contains("O_CREAT"),
            // of a file below the folder, and not of the terminal or a pipe
            "write" | "pwrite64" | "fsync" | "ftruncate" => arguments.contains(&format!("<{work}")),
            _ => true,
        };
        if changes {
            calls.push(Call { name: name.into(), number: *number, shown: format!("{name}({}", arguments.replace(&work, ".")) });
        }
    }
    Ok((said, calls))
}

/// Those calls that this machine has.
fn known_here() -> io::Result<String> {
    let mut known = Vec::new();
    for name in CHANGES {
        let mut tried = Command::new("strace");
        tried.args(["-qq", "-e", &format!("trace={name}"), "-o", "/dev/null", "true"]).stderr(Stdio::null());
        if tried.status().map_err(|error| io::Error::new(error.kind(), format!("strace: {error}")))?.success() {
            known.push(name);
        }
    }
    Ok(known.join(","))
}

/// A command that is broken at one of its calls.
///
/// # Errors
/// [`io::Error`] where `strace` cannot be started.
pub fn broken(truegap: &Path, job: &Job, place: &Place, call: &Call, fault: Fault) -> io::Result<Ran> {
    let what = match fault {
        Fault::Kill => "signal=KILL",
        Fault::NoSpace => "error=ENOSPC",
    };
    let mut command = Command::new("strace");
    command.args(["-f", "-qq", "-o", "/dev/null", "-e"]).arg(format!("trace={}", call.name)).arg("-e");
    command.arg(format!("inject={}:{what}:when={}", call.name, call.number)).arg("--").arg(truegap).args(job.typed);
    ran(command, &place.work)
}

/// A command on a disk that has so many pages left; what it leaves is copied back.
///
/// # Errors
/// [`io::Error`] where `unshare` cannot be started, or no disk be made.
pub fn small_disk(truegap: &Path, job: &Job, place: &Place, pages: u64) -> io::Result<Ran> {
    // the file `full` takes what is more than the pages
    let script = format!(
        "mount -t tmpfs -o size=64m tmpfs \"$0\" && cp -a \"$1/.\" \"$0\" && cd \"$0\" || exit 99
         used=$(df -k --output=used . | tail -1); mount -o remount,size=$((used + 4 * {pages}))k \"$0\" || exit 98
         XDG_CACHE_HOME=$PWD/.cache; export XDG_CACHE_HOME; shift; \"$@\"; code=$?
         mount -o remount,size=64m \"$0\"; find \"$WORK\" -mindepth 1 -delete; cp -a . \"$WORK\" || exit 97; exit $code"
    );
    let disk = place.around.path().join("disk");
    fs::create_dir(&disk)?;
    let mut command = Command::new("unshare");
    command.args(["--user", "--map-root-user", "--mount", "sh", "-c", &script]).arg(&disk).arg(&place.work);
    command.arg(truegap).args(job.typed).env("WORK", &place.work);
    let ran = ran(command, &place.work)?;
    if matches!(ran.code, Some(97..=99)) {
        Err(io::Error::other(format!("no small disk can be made: {}", ran.err)))
    } else {
        Ok(ran)
    }
}
