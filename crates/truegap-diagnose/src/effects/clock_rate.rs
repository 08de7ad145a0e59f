//! The clocks of load and response run at different rates.

use crate::{
    data::context::Context,
    effects::composed::words::{Driver, InWords, Kinetics, Place},
    effects::{
        course::Course,
        each_recording::EachRecording,
        effect::{About, Effect, Family, FittedParameter},
        memory::at_time,
    },
    text::{rounded, with_sd},
};
use truegap_core::{EffectId, Inputs, Parameter, Stage, simulator::StageName};

/// A difference of clocks that grows as the recording goes on.
pub struct ClockRate;

#[derive(Clone, Copy)]
struct Clocks {
    /// seconds that the load's rows fall behind in a second, as where its clock runs fast
    rate: f64,
    /// seconds after the first row at which both clocks agree
    agree_s: f64,
}

impl Clocks {
    /// Seconds by which the load stands late in the rows, `elapsed_s` after the first row.
    fn late_s(self, elapsed_s: f64) -> f64 {
        self.rate * (elapsed_s - self.agree_s)
    }
}

impl Stage for Clocks {
    fn late_s(&self, elapsed_s: f64) -> f64 {
        Self::late_s(*self, elapsed_s)
    }
}

/// Sibling: a buffer that loses (or repeats) a second's worth of rows at a time, so that the clocks part in steps.
struct Lost(Clocks);

/// Steps in which the sibling's clocks part between first and last row.
const LOSSES: f64 = 12.0;

impl Stage for Lost {
    fn load(&self, inputs: &Inputs, load: &mut [f64]) {
        let Some(time) = &inputs.time_s else { return };
        let (first, length) = (time[0], time[time.len() - 1] - time[0]);
        let given = load.to_vec();
        for run in inputs.runs() {
            for row in run.clone() {
                let elapsed = length / LOSSES * ((time[row] - first) * LOSSES / length).round();
                let wanted = time[row] + self.0.late_s(elapsed);
                load[row] = at_time(time, &given, &run, wanted);
            }
        }
    }
}

fn clocks(values: &[f64]) -> Clocks {
    Clocks { rate: values[0], agree_s: values[1] }
}

/// The same, of each recording where there are several: clocks belong to a recording, not to the sensor.
pub fn of_each_recording() -> EachRecording<ClockRate> {
    EachRecording { inner: ClockRate, make: |values| Box::new(clocks(values)) }
}

impl Effect for ClockRate {
    fn id(&self) -> EffectId {
        EffectId("clock_rate")
    }
    fn stage(&self) -> StageName {
        StageName::Inputs
    }
    fn family(&self) -> Family {
        Family::Readout
    }
    fn in_words(&self, _: &Context<'_>) -> Option<InWords> {
        Some(InWords { place: Place::Inputs, driver: Driver::LoadRate, kinetics: Kinetics::Static })
    }
    fn about(&self) -> About {
        About {
            physics: "load and response were recorded by two clocks (or counted as samples of two rates), and one runs faster",
            equation: "the load at time t stands in the row of t + r (t - a), t from the first row; between rows straight or by a cubic, as the rows say",
            excitation: "load that changes fast, early and late in the recording, with a clock",
            impostors: &["time_offset", "rate_independent_hysteresis", "viscoelastic_creep", "readout_lag", "mullins_softening"],
            separates: "the response is behind the load at one end of the recording and ahead of it at the other, which nothing physical is",
            source: "Mills, Computer Network Time Synchronization (offset and frequency of a clock)",
        }
    }
    fn parameters(&self, context: &Context<'_>) -> Vec<Parameter> {
        let length = context.length_s();
        vec![
            Parameter::normal(
                "rate",
                "s/s",
                0.0,
                USUAL,
                "time by which the load's rows fall behind in a second, as where its clock runs fast",
            )
            .within(-MOST, MOST),
            // clocks that agree long before or after are off by about a constant: that is another effect
            Parameter::normal("agree", "s", 0.5 * length, 0.5 * length, "time after the first row at which both clocks agree")
                .within(0.0, length),
        ]
    }
    fn starts(&self, context: &Context<'_>) -> Vec<Vec<f64>> {
        [0.05, 0.5].map(|share| vec![share * context.duration_s]).to_vec()
    }
    fn testable(&self, context: &Context<'_>) -> Result<(), String> {
        context.has(StageName::Inputs)?;
        context.needs_clock()?;
        Course::on_a_clock(context).map(|_| ())
    }
    fn with(&self, values: &[f64], _: &Context<'_>) -> Box<dyn Stage> {
        Box::new(clocks(values))
    }
    fn sibling(&self, values: &[f64], context: &Context<'_>) -> Option<Box<dyn Stage>> {
        context.simulator.full_load().map(|_| Box::new(Lost(clocks(values))) as Box<dyn Stage>)
    }
    fn says(&self, fitted: &[FittedParameter]) -> String {
        said("the load", fitted)
    }
    fn told(&self, fitted: &[FittedParameter], context: &Context<'_>, _: &[(EffectId, Vec<FittedParameter>)]) -> String {
        said(Course::on_a_clock(context).map_or("the load", |course| course.name(context)), fitted)
    }
}

fn said(whose: &str, fitted: &[FittedParameter]) -> String {
    let (rate, agree) = (fitted[0].value, fitted[1].value);
    // an event at time t that a fast clock stamps t + r t stands in a later row
    let (way, clock) = if rate < 0.0 { ("ahead", "slow") } else { ("behind", "fast") };
    format!(
        "in the rows {whose} falls {way} of the response by {} a second, as where its clock runs {clock}; they agree {} after the first row",
        with_sd(rate.abs(), fitted[0].sd, "s"),
        rounded(agree, "s")
    )
}

/// Standard deviation of the rate: nominal sampling rates are kept to some tenths of a per cent.
const USUAL: f64 = 3e-3;
/// Greatest rate: beyond it someone would have noticed.
pub(crate) const MOST: f64 = 0.05;

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn the_clocks_agree_where_they_are_said_to_and_part_at_the_rate() {
        let clocks = Clocks { rate: -0.006, agree_s: 200.0 };
        assert_eq!(clocks.late_s(200.0), 0.0);
        // 6 ms a second over 200 s either way
        approx::assert_relative_eq!(clocks.late_s(0.0), 1.2, max_relative = 1e-15);
        approx::assert_relative_eq!(clocks.late_s(400.0), -1.2, max_relative = 1e-15);
    }

    #[test]
    fn lost_rows_follow_the_clocks_within_half_a_loss() {
        let time: Vec<f64> = (0..=600).map(f64::from).collect();
        let inputs = Inputs { time_s: Some(time.clone()), run: vec![1; 601], ..Inputs::default() };
        let mut load = time.clone();
        Lost(Clocks { rate: 0.01, agree_s: 0.0 }).load(&inputs, &mut load);
        // a ramp of slope 1 shows the shift itself; 50 s between losses part the clocks by 0.5 s, half of it either way
        let off = |t: usize| load[t] - time[t] - 0.01 * time[t];
        assert!((0..590).all(|t| off(t).abs() < 0.2501) && (0..590).any(|t| off(t).abs() > 0.2));
    }
}
