//! The horizontal axis of a report's courses: recorded time, with the pauses between runs closed up.
//!
//! Limits: pauses inside a run stay as they are.

use super::text::Scale;
use std::ops::Range;
use truegap_core::Inputs;
use truegap_scene::figure::Figure;

/// Above this number of runs their borders are no longer drawn.
const DRAWN: usize = 80;
/// Share of the axis that a run must take for its name to have room.
const ROOM: f64 = 0.075;

/// Horizontal positions of all rows, with one empty row between runs that lifts the pen.
pub(super) struct Axis {
    x: Vec<f64>,
    label: &'static str,
    unit: String,
    runs: Vec<Range<usize>>,
    borders: Vec<(f64, u32)>,
}

impl Axis {
    /// Elapsed time of the rows of each run, one run after the other; rows are counted where there is no clock.
    pub fn new(inputs: &Inputs) -> Self {
        let runs = inputs.runs();
        let span = |r: &Range<usize>| inputs.time_s.as_ref().map_or(r.len() as f64, |t| t[r.end - 1] - t[r.start]);
        let total: f64 = runs.iter().map(span).sum();
        let scale = if inputs.time_s.is_some() { Scale::of("s", total.max(1.0)) } else { Scale::of("", 1.0) };
        let mut axis = Self { x: Vec::new(), label: label(inputs, runs.len()), unit: scale.unit, runs, borders: Vec::new() };
        let mut start = 0.0;
        for (number, run) in axis.runs.iter().enumerate() {
            if number > 0 {
                axis.x.push(start);
            }
            axis.borders.push((start, inputs.run[run.start]));
            let at = |row: usize| inputs.time_s.as_ref().map_or((row - run.start) as f64, |t| t[row] - t[run.start]);
            axis.x.extend(run.clone().map(|row| start + scale.factor * at(row)));
            start += scale.factor * span(run);
        }
        axis
    }

    /// Positions, for [`Axis::lift`]ed columns.
    pub fn x(&self) -> &[f64] {
        &self.x
    }

    /// A column of the recording with an empty row between runs; a column of another length has no value at all.
    pub fn lift(&self, column: &[f64]) -> Vec<f64> {
        let mut lifted = Vec::with_capacity(self.x.len());
        for (number, run) in self.runs.iter().enumerate() {
            if number > 0 {
                lifted.push(f64::NAN);
            }
            match column.get(run.clone()) {
                Some(rows) => lifted.extend_from_slice(rows),
                None => lifted.extend(run.clone().map(|_| f64::NAN)),
            }
        }
        lifted
    }

    /// `figure` with this axis and the borders of the runs, named where `named` asks for it.
    pub fn on(&self, figure: Figure, named: bool) -> Figure {
        let figure = figure.x(self.label, &self.unit);
        if self.borders.len() < 2 || self.borders.len() > DRAWN {
            return figure;
        }
        let end = self.x.last().copied().unwrap_or(0.0);
        let width = |number: usize| self.borders.get(number + 1).map_or(end, |next| next.0) - self.borders[number].0;
        self.borders.iter().enumerate().fold(figure, |figure, (number, (x, run))| {
            let has_room = width(number) > ROOM * (end - self.borders[0].0);
            let name = if named && has_room { format!("run {run}") } else { String::new() };
            figure.mark_x(*x, &name)
        })
    }
}

fn label(inputs: &Inputs, runs: usize) -> &'static str {
    match (inputs.time_s.is_some(), runs > 1) {
        (true, true) => "recorded time, pauses between runs left out",
        (true, false) => "time",
        (false, _) => "row",
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_pause_between_runs_takes_no_room_and_lifts_the_pen() {
        let inputs =
            Inputs { time_s: Some(vec![0.0, 10.0, 20.0, 1000.0, 1010.0]), run: vec![1, 1, 1, 2, 2], ..Inputs::default() };
        let axis = Axis::new(&inputs);
        assert_eq!(axis.x(), [0.0, 10.0, 20.0, 20.0, 20.0, 30.0]);
        let lifted = axis.lift(&[1.0, 2.0, 3.0, 4.0, 5.0]);
        assert!(lifted[3].is_nan());
        assert_eq!([lifted[2], lifted[4]], [3.0, 4.0]);
    }

    #[test]
    fn without_a_clock_rows_are_counted() {
        let inputs = Inputs { run: vec![1, 1, 2], ..Inputs::default() };
        assert_eq!(Axis::new(&inputs).x(), [0.0, 1.0, 2.0, 2.0]);
    }
}
