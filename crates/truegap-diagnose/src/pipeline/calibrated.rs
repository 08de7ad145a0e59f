//! How a model is calibrated where it predicts rows left out: under the noise, or by least squares as the base model is told.
//!
//! Two models are compared, and never two ways to calibrate.
//!
//! Limits: models that the search has fitted.

use crate::{
    pipeline::{
        alone::{Alone, alone, left_over, white},
        prepare::Prepared,
    },
    selection::candidates::{Search, Tried},
    validation::{
        cross_validation::{HeldOutFit, compared, held_out},
        tuning::FELT,
    },
};

/// The base model by itself: how it is told, and what it foretells of rows left out.
#[derive(Clone)]
pub(crate) struct ByBase {
    /// calibrated by least squares, where that is another one
    pub alone: Option<Alone>,
    /// whether fuller models are calibrated by least squares as well
    pub squares: bool,
    /// predictions of rows left out
    pub unseen: HeldOutFit,
}

/// Predicts rows left out by the base model, which is calibrated by least squares as well where something is `missing`. Where nothing is, it is told so only if that predicts rows left out
/// better by a tenth: a channel that hangs for most of its rows takes the level from the few that move.
pub(crate) fn by_base(prepared: &Prepared<'_>, search: &Search<'_>, base: &Tried, missing: bool) -> ByBase {
    let all = prepared.all_rows();
    let under_noise = prepared.foretold(search, base);
    let alone = alone(prepared, search, all, base).map(|alone| {
        let unseen = held_out(search, &alone.noise, &alone.tried, all).scored_as(&under_noise);
        (alone, unseen)
    });
    let told =
        |(_, unseen): &(Alone, HeldOutFit)| missing || compared(&under_noise, unseen).is_some_and(|both| both.better_by(FELT));
    let (alone, unseen) = match alone.filter(told) {
        Some((alone, unseen)) => (Some(alone), unseen),
        None => (None, under_noise),
    };
    // the equations of effects without plates describe: what they leave is more than the noise, whether the base model alone says so or not
    let squares = missing && (alone.is_some() || !search.context.has_plates());
    ByBase { alone, squares, unseen }
}

/// Predictions of rows left out, by the better of two ways to calibrate where least squares are one.
pub(crate) fn predictions(prepared: &Prepared<'_>, search: &Search<'_>, by_base: &ByBase, tried: &Tried) -> HeldOutFit {
    let squares = by_base.squares.then(|| by_least_squares(prepared, search, tried)).flatten();
    nearer(prepared.foretold(search, tried), squares)
}

/// Predictions of rows left out, calibrated as the base model is told: by least squares, half the work of [`predictions`], where that is another calibration of the base model, else as these.
pub(crate) fn predicted_like_base(prepared: &Prepared<'_>, search: &Search<'_>, by_base: &ByBase, tried: &Tried) -> HeldOutFit {
    if by_base.alone.is_none() {
        return predictions(prepared, search, by_base, tried);
    }
    by_least_squares(prepared, search, tried).unwrap_or_else(|| prepared.foretold(search, tried))
}

/// Predictions of rows left out by a model that is calibrated by least squares: under white noise as large as what it leaves over.
fn by_least_squares(prepared: &Prepared<'_>, search: &Search<'_>, tried: &Tried) -> Option<HeldOutFit> {
    let (noise, all) = (&prepared.searched_noise, prepared.all_rows());
    let size = left_over(&search.model_over(all.problem, &tried.effects), &tried.fit.z)?;
    let ask = || held_out(search, &white(noise, size), tried, all).by_least_squares();
    Some(prepared.answered(search, tried, true, ask))
}

/// What a model foretells, calibrated under the noise or, as the base model is where that is told alone, by least squares: else the two ways to calibrate would be compared, and not the
/// two models.
fn nearer(under_noise: HeldOutFit, squares: Option<HeldOutFit>) -> HeldOutFit {
    let better = |squares: &HeldOutFit| compared(&under_noise, squares).is_some_and(|both| both.rmse[1] < both.rmse[0]);
    match squares.filter(better) {
        Some(squares) => squares.scored_as(&under_noise),
        None => under_noise,
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::validation::cross_validation::PartError;

    fn predicted(squares: f64) -> HeldOutFit {
        let part = PartError { name: "run 1".into(), squares: Some(squares), rows: 4, score: None, warned: None };
        HeldOutFit { parts: vec![part], ..HeldOutFit::default() }
    }

    /// Calibrated by least squares, the base model leaves 4. A model that leaves 9 under the noise and 2 by least squares is no worse.
    #[test]
    fn where_least_squares_predict_better_they_are_told() {
        let told = |under_noise, squares: Option<f64>| nearer(predicted(under_noise), squares.map(predicted)).parts[0].squares;
        assert_eq!(told(9.0, Some(2.0)), Some(2.0));
        assert_eq!(told(3.0, Some(4.0)), Some(3.0));
        assert_eq!(told(9.0, None), Some(9.0));
    }
}
