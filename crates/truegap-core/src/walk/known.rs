//! Columns read on another clock, with what of it was read before on the same thread.
//!
//! A fit asks for the same recorded columns thousands of times. How a column goes on between its rows does not depend on how late it is, and most derivatives move no clock at all.
//!
//! Limits: the columns asked last, each with the clocks asked last; longer ones than [`LONGEST`] are read anew every time. Answers are those without memory to the last bit.

use super::between::{Between, interpolated, slopes};
use crate::asked_last;
use std::{cell::RefCell, collections::VecDeque, ops::Range};

/// Columns that a thread remembers: those of a recording, and of its rows without those left out.
const COLUMNS: usize = 12;

/// Clocks on which each of them is remembered: that of the point where a derivative is taken, and those a step away.
const CLOCKS: usize = 3;

/// Rows of a column beyond which memory is not worth its room.
const LONGEST: usize = 100_000;

thread_local! {
    static KNOWN: RefCell<VecDeque<Course>> = const { RefCell::new(VecDeque::new()) };
}

/// A column with its course between rows.
struct Course {
    clock: Vec<f64>,
    column: Vec<f64>,
    runs: Vec<Range<usize>>,
    between: Between,
    slopes: Vec<f64>,
    /// how late it was read, and what was read
    read: VecDeque<[Vec<f64>; 2]>,
}

/// A column read `late[row]` seconds further on in its run; seconds of each row in `clock`.
pub(super) fn shifted(clock: &[f64], column: &[f64], runs: &[Range<usize>], late: &[f64]) -> Vec<f64> {
    if column.len() > LONGEST {
        return Course::of(clock, column, runs).at(late);
    }
    KNOWN.with_borrow_mut(|known| {
        let is_asked =
            |course: &Course| same_bits(&course.column, column) && same_bits(&course.clock, clock) && course.runs == runs;
        asked_last(known, COLUMNS, is_asked, || Course::of(clock, column, runs)).remembered(late)
    })
}

impl Course {
    fn of(clock: &[f64], column: &[f64], runs: &[Range<usize>]) -> Self {
        Self {
            clock: clock.to_vec(),
            column: column.to_vec(),
            runs: runs.to_vec(),
            between: Between::of(clock, column, runs),
            slopes: runs.iter().flat_map(|run| slopes(&clock[run.clone()], &column[run.clone()])).collect(),
            read: VecDeque::new(),
        }
    }

    fn at(&self, late: &[f64]) -> Vec<f64> {
        let read = |run: &Range<usize>| {
            let [clock, column, slopes] = [&self.clock, &self.column, &self.slopes].map(|all| &all[run.clone()]);
            interpolated(clock, column, slopes, &late[run.clone()], self.between)
        };
        self.runs.iter().flat_map(read).collect()
    }

    fn remembered(&mut self, late: &[f64]) -> Vec<f64> {
        let mut read = std::mem::take(&mut self.read);
        let [_, answer] = asked_last(&mut read, CLOCKS, |[asked, _]| same_bits(asked, late), || [late.to_vec(), self.at(late)]);
        let answer = answer.clone();
        self.read = read;
        answer
    }
}

/// Whether two columns are the same to the last bit, in blocks as [`crate::column::same_column`] looks at them: here zeros have a sign, and what is not a number is itself.
fn same_bits(a: &[f64], b: &[f64]) -> bool {
    let differ = |a: &[f64], b: &[f64]| a.iter().zip(b).fold(0, |any, (a, b)| any | (a.to_bits() ^ b.to_bits())) != 0;
    a.len() == b.len() && a.chunks(64).zip(b.chunks(64)).all(|(a, b)| !differ(a, b))
}

#[cfg(test)]
#[allow(clippy::single_range_in_vec_init)] // one run
mod tests {
    use super::*;

    fn wave(rows: usize, phase: f64) -> Vec<f64> {
        (0..rows).map(|row| (0.4 * row as f64 + phase).sin()).collect()
    }

    fn bits(column: &[f64]) -> Vec<u64> {
        column.iter().map(|value| value.to_bits()).collect()
    }

    /// More columns, clocks and ways to cut them than are remembered, asked over and over: what is read is what is read without memory.
    #[test]
    fn what_is_remembered_is_what_is_read_anew_to_the_last_bit() {
        let rows = 60;
        let clocks = [1.0, 1.5].map(|step| (0..rows).map(|row| step * row as f64).collect::<Vec<f64>>());
        let cuts = [vec![0..rows], vec![0..20, 20..rows]];
        let mut columns: Vec<Vec<f64>> = (0..COLUMNS + 2).map(|k| wave(rows, k as f64)).collect();
        // zeros of either sign, and a row that is not a number
        for (row, value) in [(7, 0.0), (7, -0.0), (9, f64::NAN)] {
            let mut column = wave(rows, 0.0);
            column[row] = value;
            columns.push(column);
        }
        for _ in 0..2 {
            for (clock, runs) in clocks.iter().flat_map(|clock| cuts.iter().map(move |runs| (clock, runs))) {
                for column in &columns {
                    for late in [0.0, -0.0, 0.3, 0.5, -0.2, 0.3, 0.0].map(|late| vec![late; rows]) {
                        let found = shifted(clock, column, runs, &late);
                        assert_eq!(bits(&found), bits(&Course::of(clock, column, runs).at(&late)));
                    }
                }
            }
        }
        KNOWN.with_borrow(|known| assert!(known.len() <= COLUMNS && known.iter().all(|course| course.read.len() <= CLOCKS)));
    }
}
