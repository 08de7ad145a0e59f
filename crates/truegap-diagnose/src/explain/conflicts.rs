//! What residuals cannot show: parameters pushed away from what is known of them, or different between regimes.
//!
//! Limits: refits by regime are one straight step from the common fit.

use crate::{
    data::context::load_column,
    explain::tuning::{AGAINST_PRIOR, BETWEEN_REGIMES, FEWEST_IN_A_REGIME, MOST_RECORDINGS, TOLD_AS_FAR},
    fit::optimum::Fit,
    selection::candidates::{Search, Tried},
    text::{deviations, significant, two, uncapitalised},
};
use nalgebra::{Cholesky, DMatrix, DVector};
use serde::Serialize;
use truegap_core::{Inputs, Joined, Parameter, ends};

/// Calibration against what is known beforehand.
#[derive(Clone, Debug, Serialize)]
pub struct Conflict {
    /// sentence
    pub says: String,
    /// parameter
    pub parameter: String,
    /// standard deviations off
    pub z: f64,
    /// whether two parts of the recording differ in it, rather than the fit from what was known beforehand
    pub between_parts: bool,
}

/// All conflicts of a fitted base model.
pub fn conflicts(search: &Search<'_>, base: &Tried) -> Vec<Conflict> {
    let mut found = against_prior(search, base);
    found.extend(between_regimes(search, base));
    found
}

fn against_prior(search: &Search<'_>, base: &Tried) -> Vec<Conflict> {
    let model = search.model(&base.effects);
    let values = model.values(&base.fit.z);
    let parameters = model.parameters.iter().zip(&base.fit.z).zip(values).take(model.base_count());
    let conflicting = parameters.filter(|((_, z), _)| z.abs() > AGAINST_PRIOR);
    conflicting
        .map(|((p, z), value)| Conflict { says: pushed(p, *z, value), parameter: p.name.clone(), z: *z, between_parts: false })
        .collect()
}

/// `to fit, Young's modulus (young_rtv) must fall from 1.08 MPa to 0.821 MPa (by 23.6 %), 4.7 standard deviations ...`.
fn pushed(parameter: &Parameter, z: f64, value: f64) -> String {
    let (known, wanted) = two(parameter.centre(), value, &parameter.unit);
    let verb = if z < 0.0 { "fall" } else { "rise" };
    let share = 100.0 * (value / parameter.centre() - 1.0).abs();
    let share = if share.is_finite() && share < 1e3 { format!(" (by {} %)", significant(share, 3)) } else { String::new() };
    let off = deviations(z.abs());
    format!(
        "to fit, {} must {verb} from {known} to {wanted}{share}, {off} standard deviations of what is known of it",
        named(parameter)
    )
}

/// What a parameter means and its name, once where the meaning begins with the name.
fn named(parameter: &Parameter) -> String {
    let meaning = uncapitalised(&parameter.meaning);
    let bare = meaning.trim_start_matches("the ").replace('`', "");
    if bare == parameter.name || bare.starts_with(&format!("{} ", parameter.name)) {
        return format!("the {}", meaning.trim_start_matches("the "));
    }
    format!("the {meaning} ({})", parameter.name)
}

/// `the height (height_rtv) would be 161 µm at small loads but 163 µm at large loads, 6.2 standard deviations apart`.
fn differs(p: &Parameter, regime: &Regime, [first, second]: [f64; 2], z: f64) -> String {
    let (name, apart) = (named(p), deviations(z.abs()));
    let values = [first, second].map(|z| p.prior.at(z));
    let told = |z: f64, value: f64| z.abs() < TOLD_AS_FAR && (p.bounds.0..=p.bounds.1).contains(&value);
    if !(told(first, values[0]) && told(second, values[1])) {
        let word = if values[0] < values[1] { "smaller" } else { "larger" };
        return format!(
            "{name} would be far {word} {} than {}, {apart} standard deviations apart and outside what it can be",
            regime.first, regime.second
        );
    }
    let (a, b) = two(values[0], values[1], &p.unit);
    format!("{name} would be {a} {} but {b} {}, {apart} standard deviations apart", regime.first, regime.second)
}

/// Share of the rows that may stray from one course.
const STRAY: f64 = 0.02;

/// A way to part the rows in two.
struct Regime {
    first: String,
    second: String,
    in_second: Vec<bool>,
}

fn between_regimes(search: &Search<'_>, base: &Tried) -> Vec<Conflict> {
    let model = search.model(&base.effects);
    let mut found: Vec<(Regime, Conflict)> = Vec::new();
    for regime in regimes(search) {
        let Some((first, second)) = both(&base.fit, &regime.in_second) else { continue };
        let worst =
            (0..model.base_count()).map(|i| (i, apart(&first, &second, i))).max_by(|a, b| a.1.abs().total_cmp(&b.1.abs()));
        if let Some((index, z)) = worst.filter(|w| w.1.abs() > BETWEEN_REGIMES) {
            let p = &model.parameters[index];
            let says = differs(p, &regime, [first.0[index], second.0[index]], z);
            let conflict = Conflict { says, parameter: p.name.clone(), z, between_parts: true };
            match found
                .iter_mut()
                .find(|(other, told)| told.parameter == p.name && one_course(&other.in_second, &regime.in_second))
            {
                Some(known) if known.1.z.abs() < z.abs() => *known = (regime, conflict),
                Some(_) => {}
                None => found.push((regime, conflict)),
            }
        }
    }
    found.into_iter().map(|(_, conflict)| conflict).collect()
}

/// Whether two ways to part the rows follow one course: one part of the first lies within one part of the second, as where the temperature only
/// falls and the cool rows are among the late ones.
fn one_course(first: &[bool], second: &[bool]) -> bool {
    let in_both = |a: bool, b: bool| first.iter().zip(second).filter(|(x, y)| (**x, **y) == (a, b)).count();
    let few = first.len() as f64 * STRAY;
    [(false, false), (false, true), (true, false), (true, true)].iter().any(|(a, b)| (in_both(*a, *b) as f64) < few)
}

fn regimes(search: &Search<'_>) -> Vec<Regime> {
    let inputs = search.problem.inputs;
    let n = inputs.len();
    let mut list = Vec::new();
    let mut halves = |first: &str, second: &str, column: &[f64]| {
        let (low, high) = ends(column.iter().copied());
        let middle = 0.5 * (low + high);
        let in_second = column.iter().map(|v| *v > middle).collect();
        list.push(Regime { first: first.into(), second: second.into(), in_second });
    };
    if let Some(load) = load_column(inputs, search.problem.simulator) {
        halves("at small loads", "at large loads", &load);
        let rising: Vec<f64> = (0..n).map(|i| if i > 0 && load[i] > load[i - 1] { 1.0 } else { 0.0 }).collect();
        halves("while unloading or at rest", "while loading", &rising);
    }
    for driver in inputs.drivers.iter().filter(|driver| crate::stats::spread(&driver.values) > 0.0) {
        halves(&format!("at low {}", driver.name), &format!("at high {}", driver.name), &driver.values);
    }
    if let Some(temperature) = &inputs.temperature_c {
        halves("when cool", "when warm", temperature);
    }
    match search.problem.simulator.joined() {
        Some(joined) => list.extend(by_recording(joined, inputs)),
        None => {
            let order: Vec<f64> = (0..n).map(|i| i as f64).collect();
            halves("in the first half of the recording", "in the second half", &order);
        }
    }
    list
}

/// One recording against the others.
fn by_recording(joined: &dyn Joined, inputs: &Inputs) -> Vec<Regime> {
    let count = joined.count();
    let against = |index: usize| {
        let rows = joined.rows(index, inputs);
        let others = if count == 2 { "in recording 1".to_owned() } else { "in the other recordings".to_owned() };
        let in_second = (0..inputs.len()).map(|row| rows.contains(&row)).collect();
        Regime { first: others, second: format!("in recording {}", index + 1), in_second }
    };
    let first = if count == 2 { 1 } else { 0 };
    (first..count.min(MOST_RECORDINGS)).map(against).collect()
}

/// Variance, in units of the prior's, from which a part of a recording says next to nothing of a parameter.
const UNTOLD: f64 = 0.9;

/// Optimum and variances of each part, one straight step from the common fit: (z, variance) twice.
type Parted = (Vec<f64>, Vec<f64>);

fn both(fit: &Fit, in_second: &[bool]) -> Option<(Parted, Parted)> {
    let n = fit.z.len();
    let (mut gram, mut gradient) = (DMatrix::zeros(n, n), DVector::zeros(n));
    let mut count = 0;
    for (row, inside) in in_second.iter().enumerate() {
        if *inside {
            count += 1;
            let line = fit.jacobian.row(row);
            gram.ger(1.0, &line.transpose(), &line.transpose(), 1.0);
            gradient.axpy(fit.residual[row], &line.transpose(), 1.0);
        }
    }
    if count < FEWEST_IN_A_REGIME || in_second.len() - count < FEWEST_IN_A_REGIME {
        return None;
    }
    let whole = &fit.hessian - known(fit);
    let whole_gradient = fit.jacobian.tr_mul(&DVector::from_column_slice(&fit.residual));
    let second = part(fit, &gram, &gradient)?;
    let first = part(fit, &(whole - gram), &(whole_gradient - gradient))?;
    Some((first, second))
}

/// Curvature of what is known beforehand.
fn known(fit: &Fit) -> DMatrix<f64> {
    DMatrix::from_diagonal(&DVector::from_iterator(fit.z.len(), fit.prior.curvature()))
}

fn part(fit: &Fit, gram: &DMatrix<f64>, gradient: &DVector<f64>) -> Option<Parted> {
    let n = fit.z.len();
    let factor = Cholesky::new(gram + known(fit))?;
    let z = DVector::from_column_slice(&fit.z);
    let there = &z + factor.solve(&(gradient - DVector::from_iterator(n, fit.prior.gradient())));
    let covariance = factor.inverse();
    Some((there.iter().copied().collect(), covariance.diagonal().iter().copied().collect()))
}

/// Standard deviations between the two optima of a parameter.
///
/// Both shrink towards the prior they have in common: for a parameter drawn from it, two optima with posterior variances a and b differ by
/// a (1 - b) + b (1 - a). A part that says nothing of the parameter (variance 1) cannot contradict the other, and where neither says anything there is nothing to
/// compare: what is left of the formula is rounding.
fn apart(first: &Parted, second: &Parted, index: usize) -> f64 {
    let (a, b) = (first.1[index].min(1.0), second.1[index].min(1.0));
    if a.min(b) > UNTOLD {
        return 0.0;
    }
    (second.0[index] - first.0[index]) / (a * (1.0 - b) + b * (1.0 - a)).max(1e-18).sqrt()
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_name_is_told_once() {
        let zero = Parameter::normal("zero", "pF", 0.0, 1.0, "the `zero` of the simulator");
        assert_eq!(named(&zero), "the `zero` of the simulator");
        let young = Parameter::normal("young_rtv", "Pa", 1e6, 5e4, "Young's modulus of the silicone");
        assert_eq!(named(&young), "the Young's modulus of the silicone (young_rtv)");
    }

    #[test]
    fn one_monotone_temperature_course_is_one_way_to_part_the_rows() {
        let late: Vec<bool> = (0..100).map(|i| i >= 50).collect();
        let warm: Vec<bool> = (0..100).map(|i| i < 30).collect();
        let heated_twice: Vec<bool> = (0..100).map(|i| i % 50 < 25).collect();
        assert!(one_course(&warm, &late));
        assert!(!one_course(&heated_twice, &late));
    }

    #[test]
    fn a_pushed_parameter_is_told_in_units_and_three_digits() {
        let young = Parameter::normal("young_rtv", "Pa", 1.0753e6, 53_765.0, "Young's modulus of the silicone");
        assert_eq!(
            pushed(&young, -4.73, 0.8210e6),
            "to fit, the Young's modulus of the silicone (young_rtv) must fall from 1.08 MPa to 0.821 MPa (by 23.6 %), \
             4.7 standard deviations of what is known of it"
        );
        let stray = Parameter::normal("stray_capacitance", "pF", 0.0, 0.3, "capacitance beside the sensor");
        let says = pushed(&stray, 5.0, 1.5);
        assert!(
            says.contains("must rise from 0 fF to 1.50 pF, 5.0 standard") || says.contains("from 0 pF to 1.50 pF,"),
            "{says}"
        );
    }

    /// The zero of recording 2 against recording 1, which neither of them tells by itself: 0.006 of its prior apart, and rounding of the variances is no proof.
    #[test]
    fn what_neither_part_tells_is_no_conflict() {
        let part = |z: f64, variance: f64| (vec![z], vec![variance]);
        assert_eq!(apart(&part(6e-8, 1.0), &part(0.0066, 1.0 + 1e-12), 0), 0.0);
        assert_eq!(apart(&part(0.0, 1.0), &part(3.0, 1e-4), 0), 3.0 / (1.0f64 - 1e-4).sqrt());
    }

    #[test]
    fn a_step_too_long_for_a_number_is_told_without_one() {
        let modulus = Parameter {
            bounds: (1.01, 1e6),
            ..Parameter::log_normal("modulus", "full loads", 5.0, 1.0, "Load that closes the gap")
        };
        let regime = Regime { first: "at small loads".into(), second: "at large loads".into(), in_second: Vec::new() };
        let says = differs(&modulus, &regime, [-4.75, 6.6], 137.0);
        assert_eq!(
            says,
            "the load that closes the gap (modulus) would be far smaller at small loads than at large loads, 137 standard deviations apart and \
             outside what it can be"
        );
        let says = differs(&modulus, &regime, [0.1, 0.3], 6.24);
        assert!(
            says.contains("would be 5.53 full loads at small loads but 6.75 full loads at large loads, 6.2 standard"),
            "{says}"
        );
    }
}
