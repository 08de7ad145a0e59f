//! The correction at any reading, temperature and driver, each point by itself: the passes of [`truegap_diagnose::compensation`] with the running model.
//!
//! Limits: no noise, so that the passes go on until nothing is left.

use super::FirmwareError;
use crate::diagnosis::compensate::input::{Column, Sought, Way};
use crate::diagnosis::compensate::{CompensateError, leave_in};
use crate::models::{ModelFileError, RunningModel, only_carried};
use truegap_core::{Driver, Inputs, Role, ends};
use truegap_diagnose::answer::AddedEffect;
use truegap_diagnose::compensation::{Inverse, Limits, Models, Span, compensated};

/// Part of the span of an input below its beginning and above its end that readings come from.
const BEYOND: [f64; 2] = [0.1, 0.2];
/// Part of the span by which a curve is followed to either side, so that no edge of it lies inside of a table.
const FURTHER: f64 = 0.5;
/// Inputs of the base model that are looked at for the range of its readings.
const INPUTS: usize = 31;
/// Time between the rows of a point, over the least time constant: too short for any lag to move.
const AT_ONCE: f64 = 1e-9;

/// A column that the correction follows besides the reading.
#[derive(Clone, Debug, PartialEq)]
pub(super) struct Axis {
    pub column: Column,
    /// whether it is what comes late of the column, and not the column
    pub late: bool,
    pub low: f64,
    pub high: f64,
}

/// Both models at points of a reading and the axes.
pub(super) struct Points<'a> {
    pub model: &'a RunningModel,
    pub way: &'a Way,
    /// effects of the tables, with those that lag an input; those that are marked as carried stay in the reading
    pub effects: &'a [AddedEffect],
    pub axes: &'a [Axis],
    /// least time constant of a late input, s
    pub least_s: Option<f64>,
    /// name of the model file
    pub file: &'a str,
}

/// Corrections of readings.
pub(super) struct Corrections {
    /// corrected reading less reading
    pub added: Vec<f64>,
    /// what the passes leave of each reading
    pub left: Vec<f64>,
    /// whether the reading is one that the model gives
    pub given: Vec<bool>,
}

impl Points<'_> {
    fn refused(&self, source: ModelFileError) -> FirmwareError {
        FirmwareError::NoAnswer { model: self.file.to_owned(), source }
    }

    /// Corrections at points: the reading, then a number for each axis.
    pub fn corrections(&self, points: &[Vec<f64>]) -> Result<Corrections, FirmwareError> {
        let (base, augmented) = (
            |input: &[f64]| self.respond(&[], points, Some(input)),
            |input: &[f64]| self.respond(self.effects, points, Some(input)),
        );
        let models = Models { base: &base, augmented: &augmented };
        let inverse = self.inverse(&models, points.len())?;
        let readings: Vec<f64> = points.iter().map(|point| point[0]).collect();
        let limits = Limits { noise_sd: 0.0, noise_growth: f64::INFINITY, ..Limits::of(0.0) };
        let failed = |error| self.refused(error);
        let mut found = compensated(&readings, &models, &inverse, &limits).map_err(failed)?;
        let [bare, with] = [base(&found.input).map_err(failed)?, augmented(&found.input).map_err(failed)?];
        let left = (0..points.len()).map(|p| (readings[p] - (with[p] - bare[p]) - found.corrected[p]).abs()).collect();
        let carried = only_carried(self.effects);
        if !carried.is_empty() {
            let carrying = self.respond(&carried, points, Some(&found.input)).map_err(failed)?;
            leave_in(&mut found.corrected, &carrying, &bare);
        }
        let given = found.input.iter().map(|input| self.gives(*input)).collect();
        Ok(Corrections { added: found.corrected.iter().zip(&readings).map(|(c, y)| c - y).collect(), left, given })
    }

    fn gives(&self, input: f64) -> bool {
        let Way::Estimated(Sought { span, .. }) = self.way else { return true };
        let [low, high] = beyond(span);
        let near = 1e-9 * span.width.abs();
        (low.min(high) - near..=low.max(high) + near).contains(&input)
    }

    fn inverse(&self, models: &Models<'_, ModelFileError>, points: usize) -> Result<Inverse, FirmwareError> {
        let Way::Estimated(Sought { column, span, straight }) = self.way else { return Ok(Inverse::Known) };
        let inverse = if *straight {
            Inverse::straight(models, points, span.width)
        } else {
            let further = if span.ends { 0.0 } else { FURTHER * span.width };
            let wide = Span { zero: span.zero - further, width: span.width + 2.0 * further, ..*span };
            Inverse::curve(models, points, wide)
        };
        let inverse = inverse.map_err(|error| self.refused(error))?;
        if !inverse.moves() {
            let (model, base) = (self.file.to_owned(), self.model.simulator().name().to_owned());
            return Err(CompensateError::StandsStill { model, base, column: column.name() }.into());
        }
        Ok(inverse)
    }

    /// Least and greatest reading that the augmented model gives over the range of its input and these numbers of the axes.
    pub fn range(&self, corners: &[Vec<f64>]) -> Result<[f64; 2], FirmwareError> {
        let points: Vec<Vec<f64>> = corners.iter().map(|corner| [&[0.0][..], corner].concat()).collect();
        let Way::Estimated(Sought { span, .. }) = self.way else {
            let readings = self.respond(self.effects, &points, None).map_err(|error| self.refused(error))?;
            return Ok(ends(readings).into());
        };
        let [low, high] = beyond(span);
        let inputs = (0..INPUTS).map(|k| low + (high - low) * k as f64 / (INPUTS - 1) as f64);
        // where a model ends, as plates that touch, there are no readings
        let answers = inputs.map(|input| self.respond(self.effects, &points, Some(&vec![input; points.len()])));
        let (mut readings, mut failed) = (Vec::new(), None);
        for answer in answers {
            match answer {
                Ok(found) => readings.extend(found),
                Err(error) => failed = Some(error),
            }
        }
        match (readings.is_empty(), failed) {
            (true, Some(error)) => Err(self.refused(error)),
            _ => Ok(ends(readings).into()),
        }
    }

    /// Answers with these effects, `input` the sought one of each point.
    pub fn respond(
        &self,
        effects: &[AddedEffect],
        points: &[Vec<f64>],
        input: Option<&[f64]>,
    ) -> Result<Vec<f64>, ModelFileError> {
        let rows = self.rows();
        let answers = self.model.respond_with(effects, &self.inputs(points, input))?;
        Ok(answers.into_iter().skip(rows - 1).step_by(rows).collect())
    }

    /// Rows of a point: a run of one, or of two where something comes late, which is at rest in the first and as it is now at once behind it.
    fn rows(&self) -> usize {
        if self.least_s.is_some() { 2 } else { 1 }
    }

    fn inputs(&self, points: &[Vec<f64>], input: Option<&[f64]>) -> Inputs {
        let rows = self.rows();
        let each = |value: &dyn Fn(usize, usize) -> f64| -> Vec<f64> {
            (0..points.len()).flat_map(|point| (0..rows).map(move |row| (point, row))).map(|(p, row)| value(p, row)).collect()
        };
        let time = each(&|point, row| self.least_s.map_or(point as f64, |tau| AT_ONCE * tau * row as f64));
        let run = (1..).take(points.len()).flat_map(|run| std::iter::repeat_n(run, rows)).collect();
        let mut inputs = Inputs { time_s: Some(time), run, ..Inputs::default() };
        for (k, axis) in self.axes.iter().enumerate().filter(|(_, axis)| !axis.late) {
            let late = self.axes.iter().position(|other| other.late && other.column == axis.column);
            let place = |row: usize| 1 + late.filter(|_| row + 1 < rows).unwrap_or(k);
            axis.column.put(&mut inputs, Some(each(&|point, row| points[point][place(row)])));
        }
        if let (Way::Estimated(Sought { column, .. }), Some(input)) = (self.way, input) {
            column.put(&mut inputs, Some(each(&|point, _| input[point])));
        }
        inputs.drivers.sort_by(|a: &Driver, b: &Driver| a.name.cmp(&b.name));
        inputs
    }

    /// Whether the model goes along a history as its answers at points say, with what comes late stepped by `late`.
    pub fn goes_along(&self, history: &Inputs, late: impl Fn(&Column, &[f64]) -> Vec<f64>) -> bool {
        let columns: Vec<Vec<f64>> = self
            .axes
            .iter()
            .map(|axis| {
                let now = axis.column.values(history).map_or_else(|| vec![axis.low; history.len()], <[f64]>::to_vec);
                if axis.late { late(&axis.column, &now) } else { now }
            })
            .collect();
        let points: Vec<Vec<f64>> =
            (0..history.len()).map(|row| std::iter::once(0.0).chain(columns.iter().map(|c| c[row])).collect()).collect();
        let input = match self.way {
            Way::Estimated(Sought { column, .. }) => column.values(history),
            Way::Known | Way::Recorded => None,
        };
        let answers = self.respond(self.effects, &points, input).ok().zip(self.model.respond_with(self.effects, history).ok());
        answers.is_some_and(|(at_points, along)| !super::sorting::differ(&along, &at_points))
    }
}

/// Inputs from which readings come.
fn beyond(span: &Span) -> [f64; 2] {
    let [below, above] = if span.ends { [0.0; 2] } else { BEYOND };
    [span.zero - below * span.width, span.zero + (1.0 + above) * span.width]
}

/// The columns besides the reading and the sought input that the models follow along `trial`.
pub(super) fn followed(model: &RunningModel, effects: &[AddedEffect], way: &Way, trial: &Inputs) -> Vec<Column> {
    let is_sought = |column: &Column| matches!(way, Way::Estimated(sought) if sought.column == *column);
    let matters = |column: &Column| {
        let mut without = trial.clone();
        column.put(&mut without, None);
        [&[][..], effects].into_iter().any(|effects| {
            let [with, without] = [trial, &without].map(|inputs| model.respond_with(effects, inputs).ok());
            with.is_some_and(|with| without.is_none_or(|without| super::sorting::differ(&with, &without)))
        })
    };
    let columns = crate::diagnosis::compensate::needed::columns(trial).into_iter();
    columns.filter(|column| *column != Column::Of(Role::Time) && !is_sought(column)).filter(|c| matters(c)).collect()
}

/// Whether the base model follows the clock.
pub(super) fn follows_the_clock(model: &RunningModel, trial: &Inputs) -> bool {
    let Some(time) = &trial.time_s else { return false };
    let later = Inputs { time_s: Some(time.iter().map(|t| 1.5 * t + 1.0).collect()), ..trial.clone() };
    let [now, later] = [trial, &later].map(|inputs| model.respond_with(&[], inputs).ok());
    now.zip(later).is_none_or(|(now, later)| super::sorting::differ(&now, &later))
}
