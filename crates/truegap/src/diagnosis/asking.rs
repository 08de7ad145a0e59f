//! How often a simulator of the user's own has been asked, how often it will be and about how long that takes, beside what is being tried; and that a slow one is asked no further once somebody stops.
//!
//! Limits: what is left follows from the share of the stages that is over, which is not known before it is a twentieth.

use super::pace::duration;
use crate::models::{Calls, Programs};
use std::sync::atomic::{AtomicBool, Ordering};
use std::sync::{Condvar, Mutex, PoisonError};
use std::time::{Duration, Instant};
use truegap_diagnose::Progress;

/// Time between two looks at whether somebody stopped.
const LOOK: Duration = Duration::from_millis(50);
/// Looks between two at how often it was asked.
const LOOKS: usize = 10;
/// Share that must be over before it is told what is left.
const TOLD_FROM: f64 = 0.05;

/// Does `work`, whose progress is told with what was asked of `programs` by then; that goes on while one stage asks for long.
pub(super) fn counted<T>(
    programs: &Programs,
    progress: &(dyn Fn(Progress) + Sync),
    stop: &AtomicBool,
    work: impl FnOnce(&(dyn Fn(Progress) + Sync)) -> T,
) -> T {
    let (began, last) = (Instant::now(), Mutex::new(None::<Progress>));
    let tell = |stage: Progress| {
        let says = with(&stage.what, programs.calls(), stage.done, began.elapsed());
        progress(Progress { what: says, ..stage });
    };
    let over = (Mutex::new(false), Condvar::new());
    std::thread::scope(|scope| {
        scope.spawn(|| look(programs, &last, &over, stop, &tell));
        let _end = End(&over);
        work(&|stage: Progress| {
            *last.lock().unwrap_or_else(PoisonError::into_inner) = Some(stage.clone());
            tell(stage);
        })
    })
}

/// Tells the last stage again whenever something more was asked, until it is over.
fn look(
    programs: &Programs,
    last: &Mutex<Option<Progress>>,
    over: &(Mutex<bool>, Condvar),
    stop: &AtomicBool,
    tell: &dyn Fn(Progress),
) {
    let (mut counted, mut looks) = (0, 0);
    while !wait(over) {
        looks += 1;
        if stop.load(Ordering::Relaxed) {
            programs.stop();
        }
        if looks % LOOKS != 0 {
            continue;
        }
        let (count, stage) = (programs.calls().count, last.lock().unwrap_or_else(PoisonError::into_inner).clone());
        if let Some(stage) = stage.filter(|_| count != counted) {
            tell(stage);
        }
        counted = count;
    }
}

/// Says that it is over when it goes, whatever ended the work.
struct End<'a>(&'a (Mutex<bool>, Condvar));

impl Drop for End<'_> {
    fn drop(&mut self) {
        *self.0.0.lock().unwrap_or_else(PoisonError::into_inner) = true;
        self.0.1.notify_all();
    }
}

/// Waits for the next look; true where it is over.
fn wait(over: &(Mutex<bool>, Condvar)) -> bool {
    let guard = over.0.lock().unwrap_or_else(PoisonError::into_inner);
    let waited = over.1.wait_timeout_while(guard, LOOK, |over| !*over);
    *waited.unwrap_or_else(PoisonError::into_inner).0
}

/// What is tried, with what was asked by then.
fn with(what: &str, calls: Calls, done: f64, elapsed: Duration) -> String {
    let Calls { count, found, .. } = calls;
    if count + found == 0 {
        return what.to_owned();
    }
    let found = if found > 0 { format!(" and {found} known") } else { String::new() };
    let left = if done > TOLD_FROM { left(count, elapsed, (1.0 - done) / done) } else { String::new() };
    // first what a narrow terminal must show
    format!("{count} asked{found}{left}; {what}")
}

/// What is left, `more` times what is over: questions and their time. Where all were known from before nobody knows how many of the next will be.
fn left(count: u64, elapsed: Duration, more: f64) -> String {
    let time = duration(more * elapsed.as_secs_f64());
    match two_digits(more * count as f64) {
        0 => format!(", about {time} left"),
        questions => format!(", about {questions} more in {time}"),
    }
}

/// A count with two digits: more would be invented.
fn two_digits(count: f64) -> u64 {
    let unit = 10f64.powf((count.max(1.0).log10().floor() - 1.0).max(0.0));
    ((count / unit).round() * unit) as u64
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn what_was_asked_and_what_is_left_stand_behind_what_is_tried() {
        let told = |count, found, done| with("ageing", Calls { count, found, seconds: 1.0 }, done, Duration::from_secs(60));
        assert_eq!(told(0, 0, 0.5), "ageing");
        assert_eq!(told(12, 0, 0.01), "12 asked; ageing");
        assert_eq!(told(12, 7, 0.25), "12 asked and 7 known, about 36 more in 3.0 min; ageing");
        assert_eq!(told(453, 0, 0.1), "453 asked, about 4100 more in 9.0 min; ageing");
        assert_eq!(told(0, 7, 0.25), "0 asked and 7 known, about 3.0 min left; ageing");
    }
}
