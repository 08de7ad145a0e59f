//! Fits: the most probable point from a start, by [`super::levenberg_marquardt`].
//!
//! Limits: one mode; the caller gives the starting point.

use crate::{
    fit::{
        levenberg_marquardt::{Descent, FitOptions, inside},
        model::{Around, Model},
        optimum::Fit,
        ways::Ways,
    },
    whitening::whitener::Whitener,
};
use nalgebra::DMatrix;
use truegap_core::SimulationError;

/// Levenberg-Marquardt search inside the bounds, from `start`.
///
/// # Errors
/// Those of the simulator at the starting point; later steps that have no answer are shortened.
pub fn fit(model: &Model<'_>, whitener: &Whitener, start: &[f64], options: &FitOptions) -> Result<Fit, SimulationError> {
    fit_within(model, whitener, start, &model.bounds(), options)
}

/// The same inside narrower bounds; equal bounds hold a parameter still.
///
/// # Errors
/// As [`fit`].
pub(crate) fn fit_within(
    model: &Model<'_>,
    whitener: &Whitener,
    start: &[f64],
    bounds: &[(f64, f64)],
    options: &FitOptions,
) -> Result<Fit, SimulationError> {
    let mut search = Descent::at(model, whitener, start, bounds)?;
    search.refresh(0)?;
    search.run(options)?;
    Ok(search.finish())
}

/// As [`fit_within`]; `None` where a straight step from the start does not promise to leave less than `level`.
///
/// # Errors
/// As [`fit`].
pub(crate) fn fit_where_promising(
    model: &Model<'_>,
    whitener: &Whitener,
    start: &[f64],
    bounds: &[(f64, f64)],
    options: &FitOptions,
    level: f64,
) -> Result<Option<Fit>, SimulationError> {
    let mut search = Descent::at(model, whitener, start, bounds)?;
    search.refresh(0)?;
    if !search.promises_less_than(level) {
        return Ok(None);
    }
    search.run(options)?;
    Ok(Some(search.finish()))
}

/// As [`fit`] from a point around which the model is known: for several noises from one point.
///
/// # Errors
/// As [`fit`].
pub(crate) fn fit_around(
    model: &Model<'_>,
    whitener: &Whitener,
    start: &Around,
    options: &FitOptions,
) -> Result<Fit, SimulationError> {
    let bounds = model.bounds();
    let mut search = Descent::with(model, whitener, &bounds, start.z.clone(), start.whitened(whitener));
    search.run(options)?;
    Ok(search.finish())
}

/// As [`fit`], from a point where the derivatives by the first parameters are known already: `known` holds their columns.
///
/// # Errors
/// As [`fit`].
pub fn fit_onwards(
    model: &Model<'_>,
    whitener: &Whitener,
    start: &[f64],
    known: &DMatrix<f64>,
    options: &FitOptions,
) -> Result<Fit, SimulationError> {
    let bounds = model.bounds();
    let mut search = Descent::at(model, whitener, start, &bounds)?;
    search.know(known)?;
    search.run(options)?;
    Ok(search.finish())
}

/// As [`fit`] or, where derivatives by the first parameters are `known`, as [`fit_onwards`]; `None` where the search comes upon the way of one of the `others`, to which its own is added.
/// A `hopeless` model keeps the known derivatives where nothing is gained.
///
/// # Errors
/// As [`fit`].
pub(crate) fn fit_apart(
    model: &Model<'_>,
    whitener: &Whitener,
    start: &[f64],
    known: Option<&DMatrix<f64>>,
    options: &FitOptions,
    hopeless: bool,
    others: &mut Ways,
) -> Result<Option<Fit>, SimulationError> {
    let bounds = model.bounds();
    if others.lead_through(&inside(start, &bounds), 1) {
        return Ok(None);
    }
    let mut search = Descent::at(model, whitener, start, &bounds)?.apart_from(others);
    match known {
        Some(known) => search.know(known)?,
        None => search.refresh(0)?,
    }
    if let Some(known) = known.filter(|_| hopeless) {
        search = search.content_with(known.ncols());
    }
    let ended = search.run(options)?;
    let way = std::mem::take(&mut search.way);
    let fit = ended.then(|| search.finish());
    others.keep(way);
    Ok(fit)
}

/// A few steps inside narrower bounds (equal bounds hold a parameter still), from where the derivatives by the first parameters are known and not
/// computed again: a better starting point, not a fit. `None` where it comes upon the way of one of the `others`, or where a straight step from the start does not promise to leave less than `level`.
///
/// # Errors
/// As [`fit`].
pub(crate) fn approach(
    model: &Model<'_>,
    whitener: &Whitener,
    start: &[f64],
    bounds: &[(f64, f64)],
    known: &DMatrix<f64>,
    (options, level): (&FitOptions, f64),
    others: &mut Ways,
) -> Result<Option<Vec<f64>>, SimulationError> {
    let mut search = Descent::at(model, whitener, start, bounds)?.apart_from(others);
    for step in 0..options.iterations {
        if search.comes_upon_another() {
            return Ok(None);
        }
        search.know(known)?;
        if step == 0 && !search.promises_less_than(level) {
            return Ok(None);
        }
        if search.step().is_none_or(|gain| gain < options.tolerance) {
            break;
        }
    }
    let (z, way) = (search.z, search.way);
    others.keep(way);
    Ok(Some(z))
}
