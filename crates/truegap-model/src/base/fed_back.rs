//! A load that the answer itself takes part of: the fixed point of `load = acting + feedback(respond(load))`, without a look inside the simulator.
//!
//! Waveform relaxation (Lelarasmee, Ruehli & Sangiovanni-Vincentelli, IEEE Trans. CAD 1 (1982) 131) over all rows at once, hastened by Anderson's mixing (J. ACM 12 (1965)
//! 547; Walker & Ni, SIAM J. Numer. Anal. 49 (2011) 1715): a plain repetition need not converge where the instrument resonates.
//!
//! Limits: one load; a feedback so strong that [`MOST`] questions do not settle it has no answer.

use nalgebra::{Cholesky, DMatrix, DVector};
use truegap_core::SimulationError;

/// Questions put before it is given up.
const MOST: usize = 80;
/// Steps before that are mixed.
const MIXED: usize = 10;
/// What is left of the equation where it counts as solved, over the greatest load.
const SETTLED: f64 = 1e-9;
/// Times by which what is left may grow before it is given up.
const HOPELESS: f64 = 1e6;
/// Ridge under the squares of the steps, over the greatest: they become parallel near the solution.
const RIDGE: f64 = 1e-14;

/// The response at which the load is what acts and what the response adds to it.
///
/// # Errors
/// Those of `respond`; [`SimulationError::NotFinite`] where no load settles.
pub(super) fn fed_back(
    acting: &[f64],
    feedback: impl Fn(&[f64], &mut [f64]),
    respond: impl Fn(&[f64]) -> Result<Vec<f64>, SimulationError>,
) -> Result<Vec<f64>, SimulationError> {
    let scale = acting.iter().fold(f64::MIN_POSITIVE, |most, load| most.max(load.abs()));
    let mut load = DVector::from_column_slice(acting);
    let (mut loads, mut lefts): (Vec<DVector<f64>>, Vec<DVector<f64>>) = (Vec::new(), Vec::new());
    for _ in 0..MOST {
        let response = respond(load.as_slice())?;
        let mut asked = acting.to_vec();
        feedback(&response, &mut asked);
        let left = DVector::from_vec(asked) - &load;
        let most = left.amax();
        if most <= SETTLED * scale {
            return Ok(response);
        }
        if most.is_nan() || most >= HOPELESS * scale {
            break;
        }
        let next = mixed(&load, &left, &loads, &lefts);
        loads.push(std::mem::replace(&mut load, next));
        lefts.push(left);
        if loads.len() > MIXED {
            loads.remove(0);
            lefts.remove(0);
        }
    }
    // all rows are solved together: the first stands for all
    Err(SimulationError::NotFinite { row: 0, parameters: Vec::new() })
}

/// The next load: that combination of the last ones at which what is left, taken as linear, is least.
fn mixed(load: &DVector<f64>, left: &DVector<f64>, loads: &[DVector<f64>], lefts: &[DVector<f64>]) -> DVector<f64> {
    let plain = load + left;
    if lefts.is_empty() {
        return plain;
    }
    let steps = DMatrix::from_columns(&lefts.iter().map(|before| left - before).collect::<Vec<_>>());
    let moves = DMatrix::from_columns(&loads.iter().map(|before| load - before).collect::<Vec<_>>());
    let mut squares = steps.tr_mul(&steps);
    let ridge = RIDGE * squares.diagonal().amax();
    (0..squares.nrows()).for_each(|i| squares[(i, i)] += ridge);
    Cholesky::new(squares).map_or_else(|| plain.clone(), |factor| &plain - (moves + &steps) * factor.solve(&steps.tr_mul(left)))
}

#[cfg(test)]
mod tests {
    use super::*;

    /// Semi-implicit Euler of `x'' + 0.8 x' + 40 x + cubic x^3 = F`: a resonance, at which a plain repetition diverges.
    fn spring(force: &[f64], cubic: f64) -> Vec<f64> {
        let (mut x, mut v) = (0.0, 0.0);
        let row = |f: &f64| {
            v += 0.02 * (f - 0.8 * v - 40.0 * x - cubic * x * x * x);
            x += 0.02 * v;
            x
        };
        force.iter().map(row).collect()
    }

    fn shaken() -> Vec<f64> {
        (0..600).map(|row| 0.02 * f64::from(row)).map(|t| 5.0 * (2.0 * t).sin() + 4.0 * (5.5 * t).cos()).collect()
    }

    /// The cubic force taken from the load of the linear spring, against the cubic term in the equation of motion itself. The force acts a row late: `x` of a row is that
    /// after its step, and the equation's is that before.
    #[test]
    fn a_linear_simulator_with_feedback_is_the_nonlinear_one() {
        let force = shaken();
        for cubic in [5.0, 30.0, 120.0] {
            let taken = |x: &[f64], load: &mut [f64]| {
                load.iter_mut().skip(1).zip(x).for_each(|(load, x)| *load -= cubic * x * x * x);
            };
            let found = fed_back(&force, taken, |load| Ok(spring(load, 0.0))).unwrap();
            let exact = spring(&force, cubic);
            let most = exact.iter().fold(0.0_f64, |most, x| most.max(x.abs()));
            assert!(cubic * most * most > 0.2, "the cubic force is seen: {most}");
            found.iter().zip(&exact).for_each(|(a, b)| assert!((a - b).abs() < 1e-8 * most, "{cubic}: {a} {b}"));
        }
    }

    #[test]
    fn a_feedback_that_runs_away_has_no_answer() {
        let force = vec![1.0; 50];
        let taken = |x: &[f64], load: &mut [f64]| load.iter_mut().zip(x).for_each(|(load, x)| *load += x.abs().exp());
        assert!(matches!(fed_back(&force, taken, |load| Ok(load.to_vec())), Err(SimulationError::NotFinite { .. })));
    }
}
