//! What a straight line and a smooth curve through the recorded inputs make of a reading: the rows that every physical model is to be read against.
//!
//! Limits: no memory and no product of two inputs; every row counts the same.

mod columns;
mod least_squares;
mod spline;

use crate::{
    data::problem::Problem,
    stats::rmse,
    validation::cross_validation::{HeldOutFit, Part, judged_rows},
};
use columns::{Column, intercepts, moving};
use least_squares::Design;
use serde::Serialize;

/// Knots of the smooth curve in each input: enough for an S, too few for a loop.
const KNOTS: usize = 5;

/// Errors of a plain curve through the recorded inputs.
#[derive(Clone, Debug, PartialEq, Serialize)]
pub struct Reference {
    /// `straight_line` or `smooth_curve`
    pub name: &'static str,
    /// the inputs that it goes through, for a reader
    pub inputs: Vec<String>,
    /// root-mean-square error in sample, response unit
    pub rmse: f64,
    /// the same over the rows left out that base model and model stood behind predict; absent (null) where there is none
    pub held_out: Option<f64>,
}

/// A straight line and a smooth curve through the inputs that move, on the same parts left out as `predicted`; empty where no input moves, and without
/// one that gives no number for any row.
///
/// The line is least squares in the inputs, the curve least squares in a natural cubic spline of [`KNOTS`] knots of each, added up; both have a constant, of each
/// recording where recordings have a level of their own.
///
/// **Source:** Hastie, Tibshirani & Friedman, The Elements of Statistical Learning, 2nd ed., sections 5.2.1 and 9.1.
pub(crate) fn references(problem: &Problem<'_>, parts: &[Part], predicted: [&HeldOutFit; 2]) -> Vec<Reference> {
    let inputs = moving(problem);
    if inputs.is_empty() {
        return Vec::new();
    }
    let line = inputs.iter().map(|input| input.values.clone()).collect();
    let curve = inputs.iter().flat_map(|input| spline::basis(&input.values, KNOTS)).collect();
    let counted = judged_rows(parts, predicted);
    let of = |name, columns| one(name, &inputs, problem, columns, &counted);
    [of("straight_line", line), of("smooth_curve", curve)].into_iter().flatten().collect()
}

/// Error on the same rows left out of a straight line through the inputs that move and along the rows: a reading that drifts is nearer to it, with a clock or without. `None` where no row is left out.
pub(crate) fn with_trend(problem: &Problem<'_>, parts: &[Part], predicted: [&HeldOutFit; 2]) -> Option<f64> {
    let (inputs, rows) = (moving(problem), problem.response.len());
    let along = (0..rows).map(|row| row as f64 / rows as f64 - 0.5).collect();
    let columns = inputs.iter().map(|input| input.values.clone()).chain([along]).collect();
    one("straight_line", &inputs, problem, columns, &judged_rows(parts, predicted))?.held_out
}

fn one(
    name: &'static str,
    inputs: &[Column],
    problem: &Problem<'_>,
    columns: Vec<Vec<f64>>,
    counted: &[&Part],
) -> Option<Reference> {
    let response = problem.response;
    let design = Design::new(intercepts(problem), columns, response);
    let all = design.without(&[]);
    let (mut squares, mut rows) = (0.0, 0);
    for part in counted {
        let fitted = design.without(&part.rows);
        for row in part.rows.iter().cloned().flatten() {
            squares += (design.predict(&fitted, row) - response[row]).powi(2);
            rows += 1;
        }
    }
    let prediction: Vec<f64> = (0..response.len()).map(|row| design.predict(&all, row)).collect();
    Some(Reference {
        name,
        inputs: inputs.iter().map(|input| input.name.clone()).collect(),
        rmse: rmse(&prediction, response, 0..response.len())?,
        held_out: (rows > 0).then(|| (squares / rows as f64).sqrt()),
    })
}

#[cfg(test)]
mod tests;
