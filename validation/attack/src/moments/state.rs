//! The files of a folder as an answer, and what may lie between two answers.
//!
//! Limits: times, which no two runs share, are left out by their lines; what is kept between runs (`.cache`) is no part of an answer.

use super::jobs::Job;
use std::collections::BTreeMap;
use std::fs;
use std::io;
use std::path::Path;

/// Bytes of a page of a tmpfs.
const PAGE: u64 = 4096;

/// What a folder holds.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct State {
    /// text of each file by its path
    files: BTreeMap<String, String>,
    /// paths of what is being written
    pub parts: Vec<String>,
    pages: u64,
}

impl State {
    /// What `folder` holds.
    ///
    /// # Errors
    /// [`io::Error`] where it cannot be read.
    pub fn of(folder: &Path) -> io::Result<Self> {
        let mut state = Self::default();
        state.add(folder, "")?;
        Ok(state)
    }

    fn add(&mut self, folder: &Path, below: &str) -> io::Result<()> {
        for entry in fs::read_dir(folder)? {
            let entry = entry?;
            let name = format!("{below}{}", entry.file_name().to_string_lossy());
            self.pages += 1;
            if name == ".cache" {
                continue;
            }
            if name.ends_with(".part") {
                self.parts.push(name);
            } else if entry.path().is_dir() {
                self.add(&entry.path(), &format!("{name}/"))?;
            } else {
                self.pages += entry.metadata()?.len().div_ceil(PAGE);
                self.files.insert(name, timeless(&fs::read(entry.path())?));
            }
        }
        Ok(())
    }

    /// Pages of a tmpfs that hold it, each entry counted as one more.
    pub fn pages(&self) -> u64 {
        self.pages
    }

    /// What is lost, half written, or a part that looks whole.
    pub fn between(&self, before: &Self, after: &Self, job: &Job) -> Vec<String> {
        let mut wrong = Vec::new();
        for (name, text) in &self.files {
            let known = [before, after].iter().any(|state| state.files.get(name) == Some(text));
            if !known && !job.grows.iter().any(|grows| name.contains(grows)) {
                wrong.push(format!("{name} is neither what it was nor what it becomes"));
            }
        }
        let lost = before.files.keys().filter(|name| after.files.contains_key(*name) && !self.files.contains_key(*name));
        wrong.extend(lost.map(|name| format!("{name} is lost")));
        let is_new =
            |name: &str| self.files.get(name) == after.files.get(name) && before.files.get(name) != after.files.get(name);
        if job.document.is_some_and(is_new) {
            let missing = after.files.iter().find(|(name, text)| self.files.get(*name) != Some(*text));
            wrong.extend(missing.map(|(name, _)| {
                format!("{} says that the answer is there, and {name} is not", job.document.unwrap_or_default())
            }));
        }
        if job.is_one && self.files != before.files && self.files != after.files {
            wrong.push("a part of an answer stands in its place".into());
        }
        wrong
    }

    /// How it differs from another.
    pub fn differs(&self, other: &Self) -> Option<String> {
        let mut names = self.files.keys().chain(other.files.keys());
        names.find(|name| self.files.get(*name) != other.files.get(*name)).map(|name| format!("{name} differs"))
    }
}

/// A text without the lines that say when it was made and how long that took.
fn timeless(bytes: &[u8]) -> String {
    let text = String::from_utf8_lossy(bytes);
    let is_timeless = |line: &&str| !["seconds", "<td>took</td>", "<td>made</td>"].iter().any(|word| line.contains(word));
    text.lines().filter(is_timeless).collect::<Vec<_>>().join("\n")
}
