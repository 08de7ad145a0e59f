//! How often a simulator of the user's own has been asked, and about how long it will be, beside what is being tried; and that a slow one is asked no further once somebody stops.
//!
//! Limits: the time that is left follows from the share of the stages that is over, which is not known before it is a twentieth.

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
/// Share that must be over before a time is told.
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
    let left = elapsed.as_secs_f64() * (1.0 - done) / done;
    let left = if done > TOLD_FROM { format!(", about {} left", duration(left)) } else { String::new() };
    // first what a narrow terminal must show
    format!("{count} asked{found}{left}; {what}")
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn what_was_asked_and_what_is_left_stand_behind_what_is_tried() {
        let told = |count, found, done| with("ageing", Calls { count, found, seconds: 1.0 }, done, Duration::from_secs(60));
        assert_eq!(told(0, 0, 0.5), "ageing");
        assert_eq!(told(12, 0, 0.01), "12 asked; ageing");
        assert_eq!(told(12, 7, 0.25), "12 asked and 7 known, about 3.0 min left; ageing");
    }
}
