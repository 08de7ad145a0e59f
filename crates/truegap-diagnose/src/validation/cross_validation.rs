//! Errors on rows that a fit did not see: whole runs left out, or blocks where there is one run.
//!
//! Limits: free-run prediction, so a slow drift between runs cannot be foreseen and counts as error.

use crate::{
    data::problem::Problem,
    fit::{
        levenberg_marquardt::{FitOptions, inside},
        maximum_a_posteriori::fit_around,
        model::{Around, Model},
        optimum::Fit,
    },
    selection::candidates::{Search, Tried},
    stats::share_removed,
    validation::{
        all_rows::AllRows,
        moved_numbers::Refit,
        tuning::{MOST_PARTS, PARTS_OF_ONE_RUN, TELLS, THERE},
        unforetold::{changes, hides, not_predicted},
    },
    whitening::noise_model::NoiseModel,
};
use nalgebra::{Cholesky, DMatrix, DVector};
use rayon::prelude::*;
use std::ops::Range;
use truegap_core::{Inputs, Joined};

/// Rows left out together.
pub struct Part {
    /// name for a reader
    pub name: String,
    /// row ranges
    pub rows: Vec<Range<usize>>,
}

/// Predictions of rows left out.
#[derive(Clone, Default)]
pub struct HeldOutFit {
    /// how rows were left out
    pub how: String,
    /// whether the models were calibrated by least squares, which `how` says then
    pub least_squares: bool,
    /// prediction a row; NaN where a part could not be predicted
    pub prediction: Vec<f64>,
    /// what became of each part, in the order of [`parts`]: the same parts for every model of one recording
    pub parts: Vec<PartError>,
    /// the fits without each part, but for those that had none
    pub refits: Vec<Refit>,
}

impl HeldOutFit {
    /// The same, told as calibrated by least squares.
    pub(crate) fn by_least_squares(self) -> Self {
        Self { how: self.how + "; calibrated by least squares", least_squares: true, ..self }
    }

    /// These predictions with the scores of others, which were made under the noise.
    #[must_use]
    pub fn scored_as(mut self, under_noise: &Self) -> Self {
        let parts = self.parts.iter_mut().zip(&under_noise.parts);
        parts.for_each(|(part, other)| (part.score, part.warned) = (other.score, other.warned));
        self
    }
}

/// One part left out.
#[derive(Clone)]
pub struct PartError {
    /// name for a reader
    pub name: String,
    /// sum of squared errors over its rows; `None` where it could not be predicted
    pub squares: Option<f64>,
    /// its rows
    pub rows: usize,
    /// squares of the whitened errors of its searched rows: the same errors, measured in the noise; `None` where it could not be predicted
    pub score: Option<f64>,
    /// the same where what the numbers of the fit leave open without the part is counted, see [`surprise`]; `None` where that says nothing: beside a base model without plates, which only describes, so that its
    /// numbers are less sure than the noise says, and of what is composed of words, which follows whatever there is and leaves room for it
    pub warned: Option<f64>,
}

/// Errors of two models on rows left out, over the parts that both predict.
pub struct Compared {
    /// root-mean-square error of the one and of the other
    pub rmse: [f64; 2],
    /// the same part by part, with its name
    pub parts: Vec<(String, f64, f64)>,
}

impl Compared {
    /// Whether the second model predicts better, over all rows by more than `times`, and in more than half of the parts.
    pub fn better_by(&self, times: f64) -> bool {
        self.rmse[0] > times * self.rmse[1] && self.mostly_better()
    }

    /// Whether the second model predicts better in more than half of the parts that tell.
    pub fn mostly_better(&self) -> bool {
        self.mostly(|first, second| second < first)
    }

    /// Whether the second model predicts worse in more than half of the parts that tell.
    pub fn mostly_worse(&self) -> bool {
        self.mostly(|first, second| second > first)
    }

    /// Whether this holds in more than half of the parts. A part in which next to nothing changes, beside that in which most does, does not tell the two models apart: an instrument at rest has as
    /// many minutes as one at work. One part that alone tells is no majority.
    fn mostly(&self, holds: impl Fn(f64, f64) -> bool) -> bool {
        let change = |part: &&(String, f64, f64)| (part.2.powi(2) - part.1.powi(2)).abs();
        let most = self.parts.iter().map(|part| change(&part)).fold(0.0, f64::max);
        let telling: Vec<_> = self.parts.iter().filter(|part| change(part) >= TELLS * most).collect();
        let counted = if telling.len() > 1 { telling } else { self.parts.iter().collect() };
        2 * counted.iter().filter(|(_, first, second)| holds(*first, *second)).count() > counted.len()
    }
}

/// Compares two models on the same rows; `None` where no part was predicted by both.
///
/// A part that one model cannot predict counts for neither: an error over fewer and easier rows would look like a better model.
pub fn compared(before: &HeldOutFit, after: &HeldOutFit) -> Option<Compared> {
    let (mut sums, mut rows, mut parts) = ([0.0; 2], 0, Vec::new());
    for (b, a) in before.parts.iter().zip(&after.parts) {
        let (Some(first), Some(second)) = (b.squares, a.squares) else { continue };
        parts.push((b.name.clone(), rmse(first, b.rows), rmse(second, b.rows)));
        sums = [sums[0] + first, sums[1] + second];
        rows += b.rows;
    }
    (rows > 0).then(|| Compared { rmse: sums.map(|sum| rmse(sum, rows)), parts })
}

/// Root-mean-square error of so many rows.
fn rmse(squares: f64, rows: usize) -> f64 {
    (squares / rows.max(1) as f64).sqrt()
}

impl PartError {
    /// Root-mean-square error; `None` where it could not be predicted.
    pub fn rmse(&self) -> Option<f64> {
        self.squares.map(|squares| rmse(squares, self.rows))
    }

    /// The same over several parts, those that could be predicted; `None` where there is none.
    pub fn rmse_over(parts: &[Self]) -> Option<f64> {
        let predicted = parts.iter().filter_map(|part| Some((part.squares?, part.rows)));
        let (squares, rows) = predicted.fold((0.0, 0), |sum, one| (sum.0 + one.0, sum.1 + one.1));
        (rows > 0).then(|| rmse(squares, rows))
    }
}

/// How to leave out rows of these runs.
pub fn parts(runs: &[Range<usize>], numbers: &[u32]) -> (String, Vec<Part>) {
    if runs.len() == 1 {
        let (run, n) = (&runs[0], runs[0].len());
        let block = |k: usize| run.start + k * n / PARTS_OF_ONE_RUN..run.start + (k + 1) * n / PARTS_OF_ONE_RUN;
        let parts = (0..PARTS_OF_ONE_RUN).map(|k| Part { name: format!("block {}", k + 1), rows: vec![block(k)] });
        return (
            format!("{PARTS_OF_ONE_RUN} blocks of the one run, each left out in turn"),
            parts.filter(|p| !p.rows[0].is_empty()).collect(),
        );
    }
    let count = runs.len().min(MOST_PARTS);
    let mut parts: Vec<Part> = (0..count).map(|_| Part { name: String::new(), rows: Vec::new() }).collect();
    for (index, run) in runs.iter().enumerate() {
        let part = &mut parts[index % count];
        let separator = if part.name.is_empty() { "run " } else { ", " };
        part.name += &format!("{separator}{}", numbers[run.start]);
        part.rows.push(run.clone());
    }
    (runs_in_turn(count, count < runs.len()), parts)
}

/// How whole runs are left out.
fn runs_in_turn(count: usize, in_groups: bool) -> String {
    let what = if in_groups { format!("runs in {count} groups, each group") } else { "each run".to_owned() };
    what + " left out in turn, predicted without having been seen"
}

/// The same for several recordings: runs, and blocks of single runs where recordings have parameters that no other recording could tell.
fn joint_parts(joined: &dyn Joined, inputs: &Inputs) -> (String, Vec<Part>) {
    let mut chunks: Vec<(String, Range<usize>)> = Vec::new();
    // what one recording has of its own it has against the others, the first one included
    let blocks = (0..joined.count()).any(|index| joined.has_own(index));
    for index in 0..joined.count() {
        let rows = joined.rows(index, inputs);
        let runs: Vec<Range<usize>> = inputs.runs().into_iter().filter(|r| rows.contains(&r.start)).collect();
        match runs.as_slice() {
            [run] if blocks => {
                let edge = |k: usize| run.start + k * run.len() / PARTS_OF_ONE_RUN;
                let block = |k: usize| (format!("block {} of recording {}", k + 1, index + 1), edge(k)..edge(k + 1));
                chunks.extend((0..PARTS_OF_ONE_RUN).map(block).filter(|(_, rows)| !rows.is_empty()));
            }
            runs => chunks.extend(runs.iter().map(|run| (format!("run {}", inputs.run[run.start]), run.clone()))),
        }
    }
    let pieces = chunks.len();
    let count = pieces.min(MOST_PARTS);
    let mut parts: Vec<Part> = (0..count).map(|_| Part { name: String::new(), rows: Vec::new() }).collect();
    for (index, (name, rows)) in chunks.into_iter().enumerate() {
        let part = &mut parts[index % count];
        part.name += if part.name.is_empty() { "" } else { ", " };
        part.name += &name;
        part.rows.push(rows);
    }
    let how = match (blocks, pieces > count) {
        (true, false) => "runs, and blocks of recordings that are one run, each left out in turn".into(),
        (true, true) => format!("runs, and blocks of recordings that are one run, in {count} groups, each left out in turn"),
        (false, in_groups) => runs_in_turn(count, in_groups),
    };
    (how, parts)
}

/// The parts of a problem that are left out one after another, and how.
pub(crate) fn parts_of(problem: &Problem<'_>) -> (String, Vec<Part>) {
    match problem.simulator.joined() {
        Some(joined) => joint_parts(joined, problem.inputs),
        None => parts(&problem.runs(), &problem.inputs.run),
    }
}

/// The parts that two models both predict: those over which [`compared`] compares them.
pub(crate) fn judged_rows<'a>(parts: &'a [Part], [first, second]: [&HeldOutFit; 2]) -> Vec<&'a Part> {
    let both = first.parts.iter().zip(&second.parts).map(|(a, b)| a.squares.is_some() && b.squares.is_some());
    parts.iter().zip(both).filter_map(|(part, both)| both.then_some(part)).collect()
}

/// What a fit without a part foretells of every row, its scores on the rows of the part, and the fit.
type Foretold = (Vec<f64>, Scores, Refit);

/// As [`PartError`] has them.
struct Scores {
    score: f64,
    warned: Option<f64>,
}

/// Fits `tried` without each part in turn and predicts every row of it.
pub fn held_out(search: &Search<'_>, noise: &NoiseModel, tried: &Tried, all: AllRows<'_>) -> HeldOutFit {
    let (mut how, parts) = parts_of(all.problem);
    let model = search.model_over(all.problem, &tried.effects);
    let searched = search.model(&tried.effects);
    let whitener = noise.whitener(&search.problem.runs(), None);
    // every part is fitted from one point, where the rows that it keeps differ and the model does not
    let around = searched.around(&inside(&tried.fit.z, &searched.bounds())).ok();
    let of_library = tried.effects.iter().all(|e| search.library[*e].words().is_none());
    let warns = search.context.has_plates() && of_library;
    let slopes = around.as_ref().filter(|_| warns).map(|around| around.whitened(&whitener).1);
    let changes = changes(&searched, &tried.fit.z);
    let is_hidden = |part: &&Part| hides(&part.rows, all.problem.inputs, &changes);
    how += &not_predicted(&parts.iter().filter(is_hidden).map(|part| part.name.as_str()).collect::<Vec<_>>());
    let predict = |part: &Part| {
        if is_hidden(&part) {
            return None;
        }
        let Fit { z, sd, hessian, .. } = without(search, noise, &searched, around.as_ref()?, part, all.first)?;
        let mut errors = searched.misfit(&z).ok()?;
        whitener.apply(&mut errors);
        let kept = kept(part, errors.len(), all.first);
        let out: Vec<usize> = (0..errors.len()).filter(|row| !kept[*row]).collect();
        let errors = DVector::from_fn(out.len(), |i, _| errors[out[i]]);
        let warned = slopes.as_ref().map(|slopes| surprise(&errors, &slopes.select_rows(&out), &hessian));
        let scores = Scores { score: errors.norm_squared(), warned };
        Some((model.respond(&z).ok()?, scores, Refit { z, sd }))
    };
    let predicted: Vec<Option<Foretold>> = parts.par_iter().map(predict).collect();
    let response = &all.told();
    // NaN marks the rows that no part predicts, and those that tell nothing; every error below is taken over the finite ones only, and there is none where there are none
    let mut prediction = vec![f64::NAN; response.len()];
    for (part, values) in parts.iter().zip(&predicted) {
        let Some((values, ..)) = values else { continue };
        part.rows.iter().for_each(|rows| prediction[rows.clone()].copy_from_slice(&values[rows.clone()]));
    }
    all.untold.iter().for_each(|rows| prediction[rows.clone()].fill(f64::NAN));
    let of_part = |(part, predicted): (&Part, &Option<Foretold>)| {
        let error = part_error(part, predicted.as_ref().map(|(values, ..)| values.as_slice()), response);
        let scores = predicted.as_ref().map(|(_, scores, _)| scores);
        PartError { score: scores.map(|scores| scores.score), warned: scores.and_then(|scores| scores.warned), ..error }
    };
    let parts = parts.iter().zip(&predicted).map(of_part).collect();
    let refits = predicted.into_iter().flatten().map(|(.., refit)| refit).collect();
    HeldOutFit { how, least_squares: false, prediction, parts, refits }
}

/// How little so many rows are foretold: twice the negative log of the density that the fit without them gives to their whitened `errors`, up to a constant of the rows. `slopes` are the whitened
/// derivatives of these rows by the numbers of the model (rows x numbers), `known` the curvature of the fit: what other rows and the prior know of its numbers. An error that the numbers may still make, as
/// little as they are known, is no surprise; a model that leaves much open pays for it.
///
/// With errors `e`, slopes `J` and curvature `H` the rows have the covariance `1 + J H^-1 J'`, so this is `e'e - (J'e)' (H + J'J)^-1 J'e + ln det (H + J'J) - ln det H`. The squares alone where `H` has no inverse.
fn surprise(errors: &DVector<f64>, slopes: &DMatrix<f64>, known: &DMatrix<f64>) -> f64 {
    let squares = errors.norm_squared();
    let (before, after) = (Cholesky::new(known.clone()), Cholesky::new(known + slopes.tr_mul(slopes)));
    let (Some(before), Some(after)) = (before, after) else { return squares };
    let follows = slopes.tr_mul(errors);
    squares - follows.dot(&after.solve(&follows)) + after.ln_determinant() - before.ln_determinant()
}

/// The error of a part without its score, `values` the predictions of every row, over the rows that have a response.
pub(crate) fn part_error(part: &Part, values: Option<&[f64]>, response: &[f64]) -> PartError {
    let rows = || part.rows.iter().cloned().flatten().filter(|row| !response[*row].is_nan());
    let squares = |values: &[f64]| rows().map(|row| (values[row] - response[row]).powi(2)).sum();
    PartError { name: part.name.clone(), squares: values.map(squares), rows: rows().count(), score: None, warned: None }
}

/// Which of the searched rows do not come from a part; `first` as in [`AllRows`].
pub(crate) fn kept(part: &Part, searched: usize, first: Option<&[usize]>) -> Vec<bool> {
    let source = |row: usize| first.map_or(row, |f| f[row]);
    (0..searched).map(|row| !part.rows.iter().any(|r| r.contains(&source(row)))).collect()
}

/// The fit without one part.
fn without(
    search: &Search<'_>,
    noise: &NoiseModel,
    model: &Model<'_>,
    around: &Around,
    part: &Part,
    first: Option<&[usize]>,
) -> Option<Fit> {
    let keep = kept(part, search.problem.response.len(), first);
    let whitener = noise.whitener(&search.problem.runs(), Some(&keep));
    fit_around(model, &whitener, around, &FitOptions::default()).ok()
}

/// Share of the reproducible misfit that is removed ([`share_removed`]); `None` where nothing is there to remove.
pub fn misfit_removed(before: f64, after: f64, floor: f64, rows: usize) -> Option<f64> {
    let there = before * before - floor * floor;
    // the floor's own square is uncertain by floor^2 sqrt(2 / rows it was measured on)
    let uncertain = floor * floor * (2.0 / rows.max(1) as f64).sqrt();
    (there > THERE * uncertain).then(|| share_removed(before, after, floor))
}

#[cfg(test)]
mod tests {
    use super::*;

    /// Parts of ten rows each with these errors; `None` could not be predicted.
    fn fit(errors: &[Option<f64>]) -> HeldOutFit {
        let part = |(k, error): (usize, &Option<f64>)| PartError {
            name: format!("run {}", k + 1),
            squares: error.map(|e| 10.0 * e * e),
            rows: 10,
            score: None,
            warned: None,
        };
        HeldOutFit { parts: errors.iter().enumerate().map(part).collect(), ..HeldOutFit::default() }
    }

    /// Three blocks at rest, in which errors change by next to nothing, tell nothing: the two at work do. One block that alone tells is no majority.
    #[test]
    fn parts_in_which_nothing_changes_do_not_tell() {
        let of = |parts: &[(f64, f64)]| Compared {
            rmse: [2.0, 1.0],
            parts: parts.iter().map(|(first, second)| ("block".to_owned(), *first, *second)).collect(),
        };
        let at_work = of(&[(26.0, 44.0), (43.0, 44.0), (139.0, 141.0), (4104.0, 1354.0), (2618.0, 941.0), (69.0, 73.0)]);
        assert!(at_work.mostly_better() && at_work.better_by(1.5) && !at_work.mostly_worse());
        let back = of(&at_work.parts.iter().map(|(_, first, second)| (*second, *first)).collect::<Vec<_>>());
        assert!(back.mostly_worse() && !back.mostly_better());
        let one_alone = of(&[(1.0, 1.1), (1.0, 1.1), (1000.0, 100.0)]);
        assert!(!one_alone.mostly_better() && one_alone.mostly_worse());
        let halves = of(&[(3.0, 1.0), (1.0, 3.0)]);
        assert!(!halves.mostly_better() && !halves.mostly_worse());
    }

    /// Run 1 failed before and run 3 after: only run 2 says how the two compare, and it is told by its own name. By position, run 2 before would stand beside run 1
    /// after; over all rows that each predicts, after would win by the hard run that it leaves out.
    #[test]
    fn before_and_after_are_over_the_same_rows_and_parts_keep_their_names() {
        let (before, after) = (fit(&[None, Some(2.0), Some(9.0)]), fit(&[Some(1.0), Some(3.0), None]));
        let found = compared(&before, &after).unwrap();
        assert_eq!(found.parts, [("run 2".to_owned(), 2.0, 3.0)]);
        assert_eq!(found.rmse, [2.0, 3.0]);
    }

    /// The other route: the covariance of the rows, its inverse and its determinant.
    #[test]
    fn rows_surprise_as_their_joint_density_says() {
        let errors = DVector::from_column_slice(&[3.0, -1.0, 0.5]);
        let slopes = DMatrix::from_row_slice(3, 2, &[2.0, 0.0, 1.0, 0.3, -0.5, 1.0]);
        let known = DMatrix::from_row_slice(2, 2, &[1.5, 0.2, 0.2, 4.0]);
        let covariance = DMatrix::identity(3, 3) + &slopes * known.clone().try_inverse().unwrap() * slopes.transpose();
        let exact = (covariance.clone().try_inverse().unwrap() * &errors).dot(&errors) + f64::ln(covariance.determinant());
        approx::assert_relative_eq!(surprise(&errors, &slopes, &known), exact, max_relative = 1e-12);
        // a number that is hardly known makes any error along its slope, and nothing else
        let open = |known: f64| {
            surprise(&DVector::from_element(1, 30.0), &DMatrix::from_element(1, 1, 1.0), &DMatrix::from_element(1, 1, known))
        };
        approx::assert_relative_eq!(open(1e12), 900.0, max_relative = 1e-9);
        assert!(open(1e-3) < 10.0, "{}", open(1e-3));
    }

    #[test]
    fn where_no_part_can_be_predicted_there_is_no_error_of_zero() {
        assert!(compared(&fit(&[None, None]), &fit(&[Some(1.0), Some(1.0)])).is_none());
    }
}
