//! What is left of an answer where the program is killed, or the disk refuses, at any moment at which it changes a file.
//!
//! `strace` lists the calls by which a command changes files, and breaks the command at each: `kill -9` before the call, or no space for it. A disk of a few
//! pages is a tmpfs in a namespace of its own. After each the folder is compared with what it was and with what it becomes undisturbed, and the command runs again.
//!
//! Limits: Linux with `strace` and, for small disks, `unshare`; a call is found again by its number in its thread, so one thread computes.

pub mod calls;
pub mod jobs;
pub mod state;

use calls::{Fault, Place, Ran};
use jobs::Job;
use state::State;
use std::io;
use std::path::Path;

/// How a command came through.
#[derive(Clone, Debug, Default)]
pub struct Came {
    /// kills, and whether the call was reached at all
    pub kills: usize,
    /// refused calls
    pub refusals: usize,
    /// disks that were too small
    pub disks: usize,
    /// what went through
    pub through: Vec<String>,
}

/// A command, what it found and what it makes of it.
struct Known<'a> {
    job: &'a Job,
    truegap: &'a Path,
    before: State,
    after: State,
}

/// Breaks a command at `most` of its moments at most, evenly spread, in each of the three ways.
///
/// # Errors
/// [`io::Error`] where a folder cannot be made, or `strace` or the undisturbed command does not run.
pub fn moments(truegap: &Path, job: &Job, most: usize) -> io::Result<Came> {
    let place = Place::laid(truegap, job)?;
    let before = State::of(&place.work)?;
    let (ran, calls) = calls::listed(truegap, job, &place)?;
    if ran.code != Some(job.exit) {
        return Err(io::Error::other(format!("{} undisturbed: {ran:?}", job.name)));
    }
    let known = Known { job, truegap, before, after: State::of(&place.work)? };
    let mut came = Came::default();
    for call in spread(&calls, most) {
        came.kills += 1;
        known.broken(&mut came.through, &format!("killed before {call}"), |place| {
            calls::broken(truegap, job, place, call, Fault::Kill)
        })?;
        if call.takes_space() {
            came.refusals += 1;
            known.broken(&mut came.through, &format!("no space for {call}"), |place| {
                calls::broken(truegap, job, place, call, Fault::NoSpace)
            })?;
        }
    }
    let need = known.after.pages().max(known.before.pages());
    let pages: Vec<u64> = (0..=need).collect();
    for &page in spread(&pages, most.min(10)) {
        came.disks += 1;
        known.broken(&mut came.through, &format!("a disk with {page} pages left"), |place| {
            calls::small_disk(truegap, job, place, page)
        })?;
    }
    Ok(came)
}

impl Known<'_> {
    /// Breaks the command once, in a folder of its own, and lets it run again.
    fn broken(&self, through: &mut Vec<String>, how: &str, run: impl FnOnce(&Place) -> io::Result<Ran>) -> io::Result<()> {
        let place = Place::laid(self.truegap, self.job)?;
        let ran = run(&place)?;
        let left = State::of(&place.work)?;
        let mut wrong = self.wrong(&ran, &left);
        wrong.extend(self.again(&place, &left)?);
        through.extend(wrong.into_iter().map(|what| format!("{how}: {what}")));
        Ok(())
    }

    /// What is wrong with what a broken command has said and left.
    fn wrong(&self, ran: &Ran, left: &State) -> Vec<String> {
        let Self { job, before, after, .. } = self;
        let mut wrong = left.between(before, after, job);
        match ran.code {
            None => {}
            // what could not be written was no part of the answer
            Some(code) if code == job.exit => {
                wrong.extend(left.differs(after).map(|what| format!("exit code {code}, and {what}")))
            }
            Some(2) => {
                wrong.extend(ran.unlike_a_refusal(job));
                if !left.parts.is_empty() {
                    wrong.push(format!("left behind: {:?}", left.parts));
                }
            }
            Some(code) => wrong.push(format!("exit code {code}; it said: {}", ran.err)),
        }
        wrong
    }

    /// The next run must give the whole answer, whatever the broken one has left.
    fn again(&self, place: &Place, left: &State) -> io::Result<Vec<String>> {
        let Self { job, after, .. } = self;
        let mut said = Vec::new();
        for typed in job.again {
            let ran = calls::undisturbed(self.truegap, typed, place)?;
            if ran.code != Some(2) {
                let now = State::of(&place.work)?;
                let mut wrong: Vec<String> = now.differs(after).map(|what| format!("the next run: {what}")).into_iter().collect();
                wrong.extend(
                    now.parts.iter().filter(|part| !left.parts.contains(part)).map(|part| format!("the next run leaves {part}")),
                );
                return Ok(wrong);
            }
            said.push(ran.err);
        }
        // one that never writes over a file has nothing left to do
        let done = left.differs(after).is_none();
        Ok(if done && job.writes_once { Vec::new() } else { vec![format!("the next run is refused: {said:?}")] })
    }
}

/// At most `most` of these, the first and the last among them.
fn spread<T>(all: &[T], most: usize) -> impl Iterator<Item = &T> {
    let take = most.min(all.len());
    (0..take).map(move |k| &all[k * (all.len() - 1) / (take - 1).max(1)])
}
