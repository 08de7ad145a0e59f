//! The reading is a mean over some time to both sides of each row: no cause of the library, but what a noisy input asks for.
//!
//! Where the base model follows a column that holds noise or quick motion of its own, any physics that smooths that column errs less, a lag as well. A mean to both sides smooths without a delay:
//! it is what such a lag has to predict rows left out better than.
//!
//! Limits: beside base models without plates; a clock; windows shrink to what is symmetric at the ends of a run.

use crate::{
    data::context::Context,
    effects::effect::{About, Effect, Family, FittedParameter},
    text::rounded,
};
use std::ops::Range;
use truegap_core::{Drive, EffectId, Parameter, Readout, Stage, simulator::StageName};

/// A share of the reading is its mean over a window about each row.
pub(crate) struct MeanToBothSides;

/// The stage: a `share` of the reading is its mean over `half_width_s` to both sides.
pub(crate) struct Mean {
    pub share: f64,
    pub half_width_s: f64,
}

impl Stage for Mean {
    fn readout(&self, drive: &Drive<'_>, _: &Readout, value: &mut [f64]) {
        let Some(time) = drive.inputs.time_s.as_deref().filter(|_| self.share != 0.0 && self.half_width_s > 0.0) else { return };
        for run in drive.inputs.runs() {
            let means = means(&time[run.clone()], &value[run.clone()], self.half_width_s);
            value[run].iter_mut().zip(means).for_each(|(value, mean)| *value += self.share * (mean - *value));
        }
    }
}

/// Mean of a column, straight between its rows, over `half_width` to both sides of each; less where an end is nearer.
fn means(time: &[f64], column: &[f64], half_width: f64) -> Vec<f64> {
    let mut integral = vec![0.0; column.len()];
    for row in 1..column.len() {
        integral[row] = integral[row - 1] + 0.5 * (column[row] + column[row - 1]) * (time[row] - time[row - 1]);
    }
    // the ends of windows never go back from row to row
    let up_to = |at: f64, after: &mut usize| {
        while *after + 1 < time.len() && time[*after] < at {
            *after += 1;
        }
        let after = *after;
        let (before, width) = (after - 1, time[after] - time[after - 1]);
        let into = at - time[before];
        let slope = if width > 0.0 { (column[after] - column[before]) / width } else { 0.0 };
        integral[before] + into * (column[before] + 0.5 * slope * into)
    };
    let ends: Range<f64> = time[0]..time[time.len() - 1];
    let (mut upper, mut lower) = (1, 1);
    let mean = |(at, here): (&f64, &f64)| {
        let half = half_width.min(at - ends.start).min(ends.end - at);
        if half > 0.0 { (up_to(at + half, &mut upper) - up_to(at - half, &mut lower)) / (2.0 * half) } else { *here }
    };
    time.iter().zip(column).map(mean).collect()
}

/// Narrowest window, in steps of the clock: a narrower one sees the row alone.
const NARROWEST: f64 = 0.3;
/// Widest window, in lengths of a run.
const WIDEST: f64 = 0.05;

/// A usual half of a window, and the widest one.
pub(crate) fn widths_s(context: &Context<'_>) -> (f64, f64) {
    let step = context.step_s();
    (3.0 * step, (WIDEST * context.longest_run_s).max(2.0 * step))
}

impl Effect for MeanToBothSides {
    fn id(&self) -> EffectId {
        EffectId("mean_to_both_sides")
    }
    fn stage(&self) -> StageName {
        StageName::Readout
    }
    fn family(&self) -> Family {
        Family::Readout
    }
    fn about(&self) -> About {
        About {
            physics: "the reading does not show what is quick in the column that the base model follows: noise of that column, or a mean in the logger",
            equation: "value = true + s (mean of true over h to both sides - true)",
            excitation: "a clock",
            impostors: &[],
            separates: "comes without a delay",
            source: "Fuller, Measurement Error Models (1987), sec. 1.1",
        }
    }
    fn parameters(&self, context: &Context<'_>) -> Vec<Parameter> {
        let (usual, widest) = widths_s(context);
        let narrowest = NARROWEST * context.step_s();
        vec![
            Parameter::normal("share", "1", 0.0, 0.5, "share of the reading that is the mean").within(0.0, 1.0),
            Parameter::log_normal("half_width", "s", usual, 1.5, "half the window").within(narrowest, widest),
        ]
    }
    fn starts(&self, context: &Context<'_>) -> Vec<Vec<f64>> {
        [1.0, 4.0, 15.0].map(|steps| vec![steps * context.step_s()]).to_vec()
    }
    fn testable(&self, context: &Context<'_>) -> Result<(), String> {
        context.has(StageName::Readout)?;
        context.needs_clock()
    }
    fn with(&self, values: &[f64], _: &Context<'_>) -> Box<dyn Stage> {
        Box::new(Mean { share: values[0], half_width_s: values[1] })
    }
    fn says(&self, fitted: &[FittedParameter]) -> String {
        said(fitted[1].value)
    }
}

/// The mean in words, by half its window.
pub(crate) fn said(half_width_s: f64) -> String {
    format!("a mean over {} to both sides of each row", rounded(half_width_s, "s"))
}

#[cfg(test)]
mod tests {
    use super::*;

    /// On uneven rows, of a parabola's chords: compared with a sum over a fine grid.
    #[test]
    fn a_mean_is_the_integral_over_the_window() {
        let time = [0.0, 0.5, 2.0, 2.2, 3.0, 5.0, 6.0];
        let column = time.map(|t| (t - 2.0) * (t - 2.0));
        let chord = |at: f64| {
            let k = time.partition_point(|t| *t < at).clamp(1, 6);
            column[k - 1] + (column[k] - column[k - 1]) * (at - time[k - 1]) / (time[k] - time[k - 1])
        };
        let found = means(&time, &column, 1.2);
        for (row, at) in time.iter().enumerate() {
            let half = 1.2_f64.min(*at).min(6.0 - at);
            let fine = 20_000;
            let places = (0..fine).map(|k| at - half + 2.0 * half * (f64::from(k) + 0.5) / f64::from(fine));
            // midpoint sums of a line with kinks: 1e-8
            approx::assert_abs_diff_eq!(found[row], places.map(chord).sum::<f64>() / f64::from(fine), epsilon = 1e-6);
        }
    }

    #[test]
    fn a_straight_line_has_no_delay() {
        let time: Vec<f64> = (0..50).map(|row| f64::from(row) + 0.3 * f64::from(row % 3)).collect();
        let line: Vec<f64> = time.iter().map(|t| 3.0 - 0.2 * t).collect();
        for (mean, here) in means(&time, &line, 7.0).iter().zip(&line) {
            // rounding of the running sum
            approx::assert_abs_diff_eq!(*mean, *here, epsilon = 1e-12);
        }
    }
}
