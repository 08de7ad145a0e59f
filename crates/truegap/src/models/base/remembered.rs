//! A responder that is asked nothing twice, and nothing at all once it has failed.
//!
//! Limits: one question at a time; of a slow responder none once it was told to stop; answers are kept in memory, at most 256 MB of them; then all are forgotten. On disk ([`super::kept`]) are those of a slow program.

use super::kept::Kept;
use std::collections::HashMap;
use std::hash::{DefaultHasher, Hash, Hasher};
use std::sync::atomic::{AtomicBool, AtomicU64, Ordering};
use std::sync::{Arc, Mutex, MutexGuard, OnceLock, PoisonError};
use std::time::Instant;
use truegap_core::{Inputs, SimulationError};
use truegap_model::Responder;

/// Numbers that are kept: 256 MB.
const MOST_NUMBERS: usize = 32 << 20;

/// An answer that takes no longer is not kept on disk, s: to ask again is no slower than to look for it. Who takes longer is asked no further once somebody stops.
pub(crate) const SLOW_S: f64 = 0.01;

/// A responder with a memory.
pub struct Remembered {
    inner: Mutex<Box<dyn Responder>>,
    disk: Mutex<Disk>,
    known: Mutex<Known>,
    failure: OnceLock<SimulationError>,
    stopped: AtomicBool,
    calls: AtomicU64,
    found: AtomicU64,
    microseconds: AtomicU64,
}

/// Answers by the hash of what was asked, 128 bits.
#[derive(Default)]
struct Known {
    answers: HashMap<[u64; 2], Arc<Vec<f64>>>,
    numbers: usize,
}

impl Known {
    fn keep(&mut self, key: [u64; 2], answer: &[f64]) {
        if self.numbers + answer.len() > MOST_NUMBERS {
            *self = Self::default();
        }
        self.numbers += answer.len();
        self.answers.insert(key, Arc::new(answer.to_vec()));
    }
}

/// What is kept for the next time, where anything is.
#[derive(Default)]
struct Disk {
    kept: Option<Kept>,
    /// the first answer, whose time is also that of a start: it is kept where the next one is slow as well
    first: Option<([u64; 2], Vec<f64>)>,
    asked: bool,
}

impl Disk {
    fn get(&mut self, key: [u64; 2], values: usize) -> Option<Vec<f64>> {
        self.kept.as_mut()?.get(key, values)
    }

    fn keep(&mut self, key: [u64; 2], answer: &[f64], seconds: f64) {
        let Some(kept) = &mut self.kept else { return };
        if !std::mem::replace(&mut self.asked, true) {
            self.first = Some((key, answer.to_vec()));
        } else if seconds >= SLOW_S {
            self.first.take().into_iter().for_each(|(key, answer)| kept.put(key, &answer));
            kept.put(key, answer);
        }
    }
}

/// How often somebody was asked, and how long the answers took.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct Calls {
    /// questions that were put, those that were remembered left out
    pub count: u64,
    /// answers that were known from an earlier time, on disk
    pub found: u64,
    /// time that they took together, s
    pub seconds: f64,
}

impl Remembered {
    /// A memory in front of `inner`.
    pub fn new(inner: Box<dyn Responder>) -> Self {
        Self::keeping(inner, None)
    }

    /// The same with what is kept on disk.
    pub(super) fn keeping(inner: Box<dyn Responder>, kept: Option<Kept>) -> Self {
        let [calls, found, microseconds] = [const { AtomicU64::new(0) }; 3];
        let disk = Mutex::new(Disk { kept, ..Disk::default() });
        let (stopped, failure) = (AtomicBool::new(false), OnceLock::new());
        Self { inner: Mutex::new(inner), disk, known: Mutex::default(), failure, stopped, calls, found, microseconds }
    }

    /// What went wrong first.
    pub fn failure(&self) -> Option<&SimulationError> {
        self.failure.get()
    }

    /// Puts no further question to `inner` where its answers take long: what is known by then cannot be told without hundreds of them.
    pub fn stop(&self) {
        self.stopped.store(true, Ordering::Relaxed);
    }

    fn is_slow(&self) -> bool {
        let Calls { count, seconds, .. } = self.calls();
        seconds >= SLOW_S * count as f64
    }

    /// What is told in place of an answer after [`Remembered::stop`].
    fn given_up(&self) -> SimulationError {
        let known =
            if self.disk().kept.is_some() { "; its answers are kept, and the same command goes on from there" } else { "" };
        SimulationError::Program { says: format!("the simulator is asked no further, as the diagnosis was stopped{known}") }
    }

    /// How often `inner` was asked.
    pub fn calls(&self) -> Calls {
        let seconds = self.microseconds.load(Ordering::Relaxed) as f64 * 1e-6;
        Calls { count: self.calls.load(Ordering::Relaxed), found: self.found.load(Ordering::Relaxed), seconds }
    }

    fn disk(&self) -> MutexGuard<'_, Disk> {
        // a thread that panicked has left whole answers
        self.disk.lock().unwrap_or_else(PoisonError::into_inner)
    }

    fn ask(&self, key: [u64; 2], values: &[f64], inputs: &Inputs) -> Result<Vec<f64>, SimulationError> {
        let inner = self.inner.lock().unwrap_or_else(PoisonError::into_inner);
        if let Some(failure) = self.failure.get() {
            return Err(failure.clone());
        }
        if self.stopped.load(Ordering::Relaxed) && self.is_slow() {
            return Err(self.failure.get_or_init(|| self.given_up()).clone());
        }
        let start = Instant::now();
        let answer = inner.respond(values, inputs).and_then(|answer| of_length(answer, inputs.len()));
        self.calls.fetch_add(1, Ordering::Relaxed);
        self.microseconds.fetch_add(start.elapsed().as_micros() as u64, Ordering::Relaxed);
        if let Ok(answer) = &answer {
            self.disk().keep(key, answer, start.elapsed().as_secs_f64());
        }
        if let Err(error @ SimulationError::Program { .. }) = &answer {
            let _ = self.failure.set(error.clone()); // the first failure is the one to be told
        }
        answer
    }
}

impl Responder for Remembered {
    fn respond(&self, values: &[f64], inputs: &Inputs) -> Result<Vec<f64>, SimulationError> {
        let key = key(values, inputs);
        // a thread that panicked has left whole answers
        let known = || self.known.lock().unwrap_or_else(PoisonError::into_inner);
        let found = known().answers.get(&key).cloned();
        if let Some(answer) = found {
            return Ok(answer.to_vec());
        }
        let on_disk = self.disk().get(key, inputs.len());
        self.found.fetch_add(u64::from(on_disk.is_some()), Ordering::Relaxed);
        let answer = on_disk.map_or_else(|| self.ask(key, values, inputs), Ok)?;
        // two threads that asked the same were answered one after the other, and alike
        known().keep(key, &answer);
        Ok(answer)
    }
}

fn of_length(answer: Vec<f64>, rows: usize) -> Result<Vec<f64>, SimulationError> {
    let found = answer.len();
    match found == rows {
        true => Ok(answer),
        false => Err(SimulationError::Program {
            says: format!("the simulator answered with {found} numbers for {rows} rows; give one for each row"),
        }),
    }
}

/// Every bit of what is asked, hashed twice with different beginnings.
fn key(values: &[f64], inputs: &Inputs) -> [u64; 2] {
    [1u8, 2].map(|beginning| {
        let mut hasher = DefaultHasher::new();
        beginning.hash(&mut hasher);
        values.iter().for_each(|value| value.to_bits().hash(&mut hasher));
        for (name, column) in super::columns::columns(inputs) {
            name.hash(&mut hasher);
            column.iter().for_each(|value| value.to_bits().hash(&mut hasher));
        }
        hasher.finish()
    })
}

#[cfg(test)]
mod tests {
    use super::*;

    /// Answers with the first value, as often as it is asked; fails at negative ones.
    struct Echo;

    impl Responder for Echo {
        fn respond(&self, values: &[f64], inputs: &Inputs) -> Result<Vec<f64>, SimulationError> {
            match values[0] < 0.0 {
                true => Err(SimulationError::Program { says: "negative".into() }),
                false => Ok(vec![values[0]; inputs.len() + (values[0] == 7.0) as usize]),
            }
        }
    }

    fn inputs(force: f64) -> Inputs {
        Inputs { run: vec![1, 1], force_n: Some(vec![force, 1.0]), ..Inputs::default() }
    }

    #[test]
    fn nothing_is_asked_twice_and_everything_that_differs_is() {
        let echo = Remembered::new(Box::new(Echo));
        for _ in 0..3 {
            assert_eq!(echo.respond(&[2.0], &inputs(0.0)).unwrap(), [2.0; 2]);
        }
        assert_eq!(echo.calls().count, 1);
        echo.respond(&[2.0], &inputs(0.5)).unwrap();
        echo.respond(&[2.5], &inputs(0.5)).unwrap();
        assert_eq!(echo.calls().count, 3);
    }

    /// The first answer takes the start of a program as well, so that the second one says whether it is slow.
    #[test]
    fn only_a_slow_program_leaves_something_on_disk() {
        let folder = tempfile::tempdir().unwrap();
        let keeps = |program: &str, seconds: [f64; 3]| {
            let mut disk = Disk { kept: Some(Kept::open(folder.path(), program)), ..Disk::default() };
            (1..).zip(seconds).for_each(|(key, seconds)| disk.keep([key, 0], &[0.5], seconds));
            let mut kept = Kept::open(folder.path(), program);
            [1, 2, 3].map(|key| kept.get([key, 0], 1).is_some())
        };
        assert_eq!(keeps("quick", [3.0, 0.001, 0.001]), [false; 3]);
        assert_eq!(keeps("slow", [3.0, 0.2, 0.2]), [true; 3]);
        assert_eq!(keeps("mixed", [3.0, 0.001, 0.2]), [true, false, true]);
        let mut nowhere = Disk::default();
        nowhere.keep([1, 0], &[0.5], 1.0);
        assert!(nowhere.get([1, 0], 1).is_none());
    }

    #[test]
    fn what_failed_once_is_not_asked_again() {
        let echo = Remembered::new(Box::new(Echo));
        assert!(echo.respond(&[-1.0], &inputs(0.0)).is_err() && echo.respond(&[1.0], &inputs(0.0)).is_err());
        assert_eq!((echo.calls().count, echo.failure().map(ToString::to_string)), (1, Some("negative".into())));
        let short = Remembered::new(Box::new(Echo));
        assert!(short.respond(&[7.0], &inputs(0.0)).unwrap_err().to_string().contains("3 numbers for 2 rows"));
    }
}
