//! A slow input that was not recorded: whether the recording asks for one, and how well its course is recovered.
//!
//! The course is decided before the hidden column is looked at: [`SlowInput::of`] knows nothing of it, [`SlowInput::opened`] sets the two side by side.
//!
//! Limits: one course, through the zero or the gain of the reading; slower than the distance of its knots.

use crate::{
    data::problem::Problem,
    effects::memory::at_time,
    explain::hidden_input::course::{Course, Through, along, recover, respond},
    explain::tuning::{CONVINCING, DETERMINED, FOLLOWS_CLOSELY, FOLLOWS_IN_PART, MOVES_IN_A_RUN},
    fit::{levenberg_marquardt::FitOptions, maximum_a_posteriori::fit, model::Model},
    selection::{
        candidates::{Search, Tried},
        posterior::Selection,
    },
    stats::{deviation, rmse},
    text::{Scale, significant},
};
use serde::Serialize;
use std::ops::Range;
use truegap_core::{Driver, Inputs};

/// A column that was hidden on purpose.
#[derive(Clone, Debug, PartialEq)]
pub struct Hidden {
    /// role, as in files: temperature, humidity, ...
    pub column: String,
    /// unit of `values`
    pub unit: String,
    /// one a row; NaN where it was not recorded
    pub values: Vec<f64>,
}

/// A column that was hidden on purpose, opened after its course had been recovered without it.
#[derive(Clone, Debug, PartialEq, Serialize)]
pub struct ConcealedColumn {
    /// role of the column
    pub column: String,
    /// its unit
    pub unit: String,
    /// whether the recording, without the column, asks for a slow input that was not recorded
    pub missing: bool,
    /// the answer as a sentence
    pub says: String,
    /// how the course reaches the reading
    pub through: Through,
    /// unit of the course: that of the response, or 1 for a relative gain
    pub course_unit: String,
    /// log evidence of the course over the calibrated base model
    pub log_evidence_over_base: f64,
    /// the same over the likeliest model of the library
    pub log_evidence_over_library: f64,
    /// divisor of log evidence, as for the models of the library
    pub temper: f64,
    /// knots of the course
    pub knots: usize,
    /// share of the rows at which the recording determines the course; only these are compared with the column
    pub determined: f64,
    /// correlation of the course with the column; absent where the column does not move
    pub correlation: Option<f64>,
    /// change of the course per unit of the column, with its 95 % interval
    pub slope: Option<[f64; 3]>,
    /// errors over all rows
    pub all: CourseErrors,
    /// the same run by run
    pub runs: Vec<CourseRun>,
}

/// Root-mean-square errors, in the unit of the response.
#[derive(Clone, Copy, Debug, PartialEq, Serialize)]
pub struct CourseErrors {
    /// calibrated base model without the column; absent where it has no answer
    pub rmse_before: Option<f64>,
    /// with the recovered course; absent where the model has no answer with it
    pub rmse_after: Option<f64>,
    /// base model calibrated with the column opened; absent where it has no answer
    pub rmse_opened: Option<f64>,
}

/// One run.
#[derive(Clone, Copy, Debug, PartialEq, Serialize)]
pub struct CourseRun {
    /// its number
    pub run: u32,
    /// rows
    pub rows: usize,
    /// correlation of course and column; absent where one does not move
    pub correlation: Option<f64>,
    /// errors
    #[serde(flatten)]
    pub errors: CourseErrors,
}

/// A course, and whether the recording asks for it.
pub struct SlowInput {
    course: Course,
    over_base: f64,
    over_library: f64,
    temper: f64,
}

impl SlowInput {
    /// Recovers the course and weighs it against everything that was tried.
    pub fn of(search: &Search<'_>, selection: &Selection) -> Option<Self> {
        let course = recover(search, selection.base())?;
        let best = selection.models.iter().map(|m| m.fit.log_evidence).fold(f64::NEG_INFINITY, f64::max);
        let over_base = course.log_evidence - selection.base().fit.log_evidence;
        let over_library = course.log_evidence - best;
        Some(Self { course, over_base, over_library, temper: selection.temper })
    }

    /// Whether a slow input is missing: the course is worth it, and no model of the library does as well.
    pub fn is_missing(&self) -> bool {
        self.over_base.min(self.over_library) / self.temper > CONVINCING
    }

    /// What is missing, in words; for a verdict.
    pub fn says(&self) -> String {
        let way = match self.course.through {
            Through::Zero => "moves the reading up and down",
            Through::Gain => "changes the gain of the reading",
        };
        format!("missing is an input that was not recorded: a slow course that {way}, which nothing in the library explains")
    }

    /// Opens a hidden column and sets it beside the course; `all` has every row.
    pub fn opened(
        &self,
        search: &Search<'_>,
        base: &Tried,
        all: &Problem<'_>,
        hidden: &Hidden,
    ) -> (ConcealedColumn, CourseTrace) {
        let course = along(&self.course.knots.hats(all.inputs), &self.course.levels);
        let sd = along(&self.course.knots.hats(all.inputs), &self.course.sd);
        let runs = all.inputs.runs();
        let known = determined(&course, &sd);
        // a straight line is drawn through the rows that are finite; those that the recording does not determine are not among them
        let seen: Vec<f64> = course.iter().zip(&known).map(|(c, known)| if *known { *c } else { f64::NAN }).collect();
        let share = known.iter().filter(|k| **k).count() as f64 / known.len().max(1) as f64;
        let line = crate::explain::hidden_input::opened::line(&hidden.values, &seen, &runs);
        let before = Model::new(all, search.context, Vec::new()).respond(&base.fit.z).ok();
        let after = respond(search, all.inputs, &self.course.z, self.course.through, course.clone()).ok();
        let with_column = with_column(search, all, hidden);
        let errors = |rows: Range<usize>| CourseErrors {
            rmse_before: before.as_ref().and_then(|p| rmse(p, all.response, rows.clone())),
            rmse_after: after.as_ref().and_then(|p| rmse(p, all.response, rows.clone())),
            rmse_opened: with_column.as_ref().and_then(|p| rmse(p, all.response, rows)),
        };
        let of_run = |rows: &Range<usize>| CourseRun {
            run: all.inputs.run[rows.start],
            rows: rows.len(),
            correlation: moves(&hidden.values, rows)
                .then(|| crate::explain::hidden_input::opened::correlation(&hidden.values, &seen, rows))
                .flatten(),
            errors: errors(rows.clone()),
        };
        let course_unit = if self.course.through == Through::Zero { all.simulator.unit().to_owned() } else { "1".to_owned() };
        let column = ConcealedColumn {
            column: hidden.column.clone(),
            unit: hidden.unit.clone(),
            missing: self.is_missing(),
            says: self.sentence(hidden, line, &course_unit, share),
            through: self.course.through,
            course_unit: course_unit.clone(),
            log_evidence_over_base: self.over_base,
            log_evidence_over_library: self.over_library,
            temper: self.temper,
            knots: self.course.knots.count(),
            determined: share,
            correlation: line.map(|l| l.correlation),
            slope: line.map(|l| [l.slope, l.interval.0, l.interval.1]),
            all: errors(0..all.response.len()),
            runs: runs.iter().map(of_run).collect(),
        };
        (column, CourseTrace { course, sd, hidden: hidden.values.clone(), course_unit })
    }

    fn sentence(
        &self,
        hidden: &Hidden,
        line: Option<crate::explain::hidden_input::opened::Line>,
        course_unit: &str,
        share: f64,
    ) -> String {
        let asked = match (self.is_missing(), self.over_base / self.temper > CONVINCING) {
            (true, _) => {
                format!("without the column for {}, the recording asks for a slow input that was not recorded", hidden.column)
            }
            (false, true) => format!(
                "without the column for {}, a slow course would help, but effects of the library explain the recording as well",
                hidden.column
            ),
            (false, false) => format!("without the column for {}, the recording asks for no further slow input", hidden.column),
        };
        let Some(line) = line else { return format!("{asked}; opened, column and course do not move enough to be compared") };
        let scale = Scale::of(course_unit, line.slope.abs().max(line.interval.1 - line.slope));
        let (unit, factor) = if course_unit == "1" { ("%".to_owned(), 100.0) } else { (scale.unit, scale.factor) };
        let digits = |v: f64| significant(v * factor, 3);
        let follows = match line.correlation.abs() {
            c if c > FOLLOWS_CLOSELY => "follows it closely",
            c if c > FOLLOWS_IN_PART => "follows it in part",
            _ => "does not follow it",
        };
        let where_ = match share {
            s if s > 0.99 => String::new(),
            s => format!(", on the {:.0} % of the rows at which the recording determines it", 100.0 * s),
        };
        format!(
            "{asked}; opened, the recovered course {follows}{where_}: correlation {}, {} {unit} per {} (95 % interval {} to {})",
            significant(line.correlation, 3),
            digits(line.slope),
            hidden.unit,
            digits(line.interval.0),
            digits(line.interval.1)
        )
    }
}

/// Whether a column crosses a tenth of its range in some rows; below that a correlation is one of noise.
fn moves(column: &[f64], rows: &Range<usize>) -> bool {
    let range = |values: &[f64]| {
        let finite = values.iter().copied().filter(|v| v.is_finite());
        finite.clone().fold(f64::NEG_INFINITY, f64::max) - finite.fold(f64::INFINITY, f64::min)
    };
    range(&column[rows.clone()]) > MOVES_IN_A_RUN * range(column)
}

/// Rows at which the course is known better than to half of how far it moves.
fn determined(course: &[f64], sd: &[f64]) -> Vec<bool> {
    let moves = deviation(course);
    sd.iter().map(|sd| *sd < DETERMINED * moves).collect()
}

/// Response of the base model calibrated with the column opened.
fn with_column(search: &Search<'_>, all: &Problem<'_>, hidden: &Hidden) -> Option<Vec<f64>> {
    if hidden.values.iter().any(|v| !v.is_finite()) {
        return None;
    }
    let restored = |inputs: &Inputs, values: Vec<f64>| {
        let mut inputs = inputs.clone();
        match hidden.column.as_str() {
            "temperature" => inputs.temperature_c = Some(values),
            "humidity" => inputs.humidity_pct = Some(values),
            "force" => inputs.force_n = Some(values),
            "pressure" => inputs.pressure_pa = Some(values),
            "gap" => inputs.gap_m = Some(values),
            // what is no role was a driver
            name => inputs.drivers.push(Driver { name: name.into(), unit: hidden.unit.clone(), values }),
        }
        inputs
    };
    let every = restored(all.inputs, hidden.values.clone());
    let problem = Problem { inputs: &every, response: all.response, simulator: all.simulator };
    let fewer = restored(search.problem.inputs, means(all.inputs, search.problem.inputs, &hidden.values));
    let searched = Problem { inputs: &fewer, response: search.problem.response, simulator: all.simulator };
    let model = Model::new(&searched, search.context, Vec::new());
    let found = fit(&model, search.whitener, &vec![0.0; model.parameters.len()], &FitOptions::default()).ok()?;
    Model::new(&problem, search.context, Vec::new()).respond(&found.z).ok()
}

/// A column of all rows at the times of fewer rows.
fn means(all: &Inputs, fewer: &Inputs, column: &[f64]) -> Vec<f64> {
    if all.len() == fewer.len() {
        return column.to_vec();
    }
    let (Some(time), Some(at)) = (&all.time_s, &fewer.time_s) else { return column.to_vec() };
    let mut values = Vec::with_capacity(fewer.len());
    for (run, rows) in all.runs().iter().zip(fewer.runs()) {
        for row in rows {
            values.push(at_time(time, column, run, at[row]));
        }
    }
    values
}

/// A course that was recovered, a value a row.
#[derive(Clone, Debug, Default)]
pub struct CourseTrace {
    /// the course, in `course_unit`
    pub course: Vec<f64>,
    /// its standard deviation
    pub sd: Vec<f64>,
    /// the hidden column, in its own unit
    pub hidden: Vec<f64>,
    /// unit of the course; 1 for a relative gain
    pub course_unit: String,
}
