//! What the true value does between two rows, where a lag is not long beside the step from row to row.
//!
//! Rows tell a value at instants. A lag needs it in between as well. Straight lines are right on the mean, where what is measured moves by itself. What is commanded by a program that also records, a valve or a
//! heater, is held: between two rows it has the value of the later one, or still that of the earlier one. A simulation that goes from row to row by Euler's rule does the same: the implicit rule the first, the
//! explicit one the second.
//!
//! Limits: one number for all rows; only where something that moves the reading jumps.

use crate::{data::context::Context, effects::effect::FittedParameter};
use truegap_core::Parameter;

/// Name of the number.
pub(crate) const BETWEEN_ROWS: &str = "between_rows";

/// The law that it opens.
pub(crate) const HELD: &[&str] = &[BETWEEN_ROWS];

/// The number, as [`crate::effects::memory::Lag`] has it; `None` where nothing jumps: what moves smoothly is straight between rows, and to be held is half a step late or early, which a time offset says.
pub(crate) fn between_rows(context: &Context<'_>) -> Option<Parameter> {
    let meaning = "the true value between two rows: 0 straight, 1 that of the later row, -1 that of the earlier row";
    context.moved.jumps.then(|| Parameter::normal(BETWEEN_ROWS, "1", 0.0, 0.5, meaning).within(-1.0, 1.0))
}

/// Below it, what is done between rows is not spoken of: a tenth of a step.
const SPOKEN_OF: f64 = 0.2;

/// `; between two rows the true value is already that of the later row`, where it is held by that much.
pub(crate) fn says(fitted: &[FittedParameter]) -> &'static str {
    let number = fitted.iter().find(|p| p.parameter.name == BETWEEN_ROWS).map_or(0.0, |p| p.value);
    match number {
        n if n > SPOKEN_OF => "; between two rows the true value is already that of the later row",
        n if n < -SPOKEN_OF => "; between two rows the true value is still that of the earlier row",
        _ => "",
    }
}

#[cfg(test)]
mod tests {
    use crate::effects::memory::{first_order_lag, lag_between_rows};
    use truegap_core::Inputs;

    /// Held, a lag goes by exp(-h / tau) of what is left from row to row, towards the row behind or the one before; half held it is the mean of that and of straight lines, since it is linear in its input.
    #[test]
    fn a_held_column_follows_the_exponential_of_each_step() {
        let time: Vec<f64> = (0..200).map(|row| f64::from(row) + if row % 3 == 0 { 0.4 } else { 0.0 }).collect();
        let inputs = Inputs { time_s: Some(time.clone()), run: vec![1; 200], ..Inputs::default() };
        let x: Vec<f64> = (0..200).map(|row| f64::from(row / 17 * 5 % 7)).collect();
        let lag = |between: f64| {
            let mut y = x.clone();
            lag_between_rows(&inputs, (6.0, between), &mut y, |first| first);
            y
        };
        for (between, behind) in [(1.0, 0), (-1.0, 1)] {
            let mut y = x[0];
            for (row, late) in lag(between).iter().enumerate().skip(1) {
                y += (x[row - behind] - y) * -(-(time[row] - time[row - 1]) / 6.0).exp_m1();
                approx::assert_abs_diff_eq!(*late, y, epsilon = 1e-12);
            }
        }
        let mut straight = x.clone();
        first_order_lag(&inputs, 6.0, &mut straight, |first| first);
        let [half, held] = [lag(0.5), lag(1.0)];
        (0..200).for_each(|row| approx::assert_abs_diff_eq!(half[row], 0.5 * (straight[row] + held[row]), epsilon = 1e-12));
    }
}
