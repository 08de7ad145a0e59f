//! Runs and time, row by row: forwards inside a run, one clock through all of them.
//!
//! Limits: where a run's clock begins below the end of the run before, the pause between them is not known and taken as one step.

use super::{error::RecordingError, note::Note};
use std::collections::HashSet;
use std::path::PathBuf;

/// What the clock says of a row.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(super) enum Tick {
    /// a row of `run`, at this time on the common clock
    Row { run: u32, time_s: f64 },
    /// has the time of the row before
    Repeat,
}

/// A disorder; the line is still to be found.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(super) enum Disorder {
    RunReturns { run: u32 },
    RunsBack { run: u32, before: f64, after: f64 },
    NoClock { time: f64 },
}

impl Disorder {
    pub fn at(self, file: PathBuf, line: usize) -> RecordingError {
        match self {
            Self::RunReturns { run } => RecordingError::RunReturns { file, line, run },
            Self::RunsBack { run, before, after } => RecordingError::TimeRunsBack { file, line, run, before, after },
            Self::NoClock { time } => RecordingError::NoClock { file, line, time },
        }
    }
}

/// Seconds beyond which a number is no time of a clock: nanoseconds since 1970, taken for seconds, are 1.8e18. Sums of times that large would lose every step, or be infinite.
const FARTHEST: f64 = 1e20;

/// The last row seen.
#[derive(Clone, Copy, Debug)]
struct Last {
    sensor: u32,
    run: u32,
    /// as recorded
    time: f64,
}

/// Follows the rows of a recording.
#[derive(Debug, Default)]
pub(super) struct Clock {
    last: Option<Last>,
    left: HashSet<(u32, u32)>,
    step: f64,
    shift: f64,
    /// falling time starts a new run
    pub lenient: bool,
    /// number runs afresh, as several sensors share them
    pub renumber: bool,
    count: u32,
    /// notes whose line is the byte of the row, until [`Clock::notes`] is read
    pub notes: Vec<Note>,
}

impl Clock {
    /// Takes the next row; `time` is absent where no clock was recorded; `byte` stands for the line.
    pub fn tick(&mut self, sensor: u32, run: Option<u32>, time: Option<f64>, byte: usize) -> Result<Tick, Disorder> {
        let time_now = time.unwrap_or(0.0);
        if time_now.abs() > FARTHEST {
            return Err(Disorder::NoClock { time: time_now });
        }
        let Some(last) = self.last else {
            let first = if self.lenient || self.renumber { self.count + 1 } else { run.unwrap_or(1) };
            return Ok(self.begin(sensor, run, first, time_now));
        };
        let recorded = run.unwrap_or(last.run);
        if sensor != last.sensor || recorded != last.run {
            return self.change(last, sensor, recorded, time_now, byte);
        }
        match time {
            Some(now) if now < last.time && self.lenient => Ok(self.tare(last, now, byte)),
            Some(after) if after < last.time => Err(Disorder::RunsBack { run: last.run, before: last.time, after }),
            Some(now) if now == last.time => Ok(Tick::Repeat),
            _ => {
                self.step = time_now - last.time;
                self.last = Some(Last { time: time_now, ..last });
                Ok(Tick::Row { run: self.count, time_s: time_now + self.shift })
            }
        }
    }

    fn begin(&mut self, sensor: u32, run: Option<u32>, count: u32, time: f64) -> Tick {
        self.last = Some(Last { sensor, run: run.unwrap_or(count), time });
        self.count = count;
        Tick::Row { run: count, time_s: time + self.shift }
    }

    /// Another run, or another sensor.
    fn change(&mut self, last: Last, sensor: u32, run: u32, time: f64, byte: usize) -> Result<Tick, Disorder> {
        self.left.insert((last.sensor, last.run));
        if self.left.contains(&(sensor, run)) {
            return Err(Disorder::RunReturns { run });
        }
        let count = if self.renumber { self.count + 1 } else { run };
        if sensor != last.sensor {
            self.shift = 0.0;
        } else if time < last.time {
            let shift_s = self.carry_on(last, time);
            self.notes.push(Note::ClockCarriedOn { line: byte, run: count, shift_s });
        }
        Ok(self.begin(sensor, Some(run), count, time))
    }

    fn tare(&mut self, last: Last, time: f64, byte: usize) -> Tick {
        self.carry_on(last, time);
        let count = self.count + 1;
        self.notes.push(Note::TareReset { line: byte, run: count });
        self.begin(last.sensor, Some(last.run), count, time)
    }

    /// Shifts the clock so that `time` comes one step after the last row.
    fn carry_on(&mut self, last: Last, time: f64) -> f64 {
        let step = if self.step > 0.0 { self.step } else { 1.0 };
        self.shift += last.time + step - time;
        self.shift
    }
}
