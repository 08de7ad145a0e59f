//! The reading follows no faster than at a certain rate.

use crate::{
    data::{context::Context, problem::Problem},
    effects::composed::words::{Driver, InWords, Kinetics, Place},
    effects::{
        effect::{About, Effect, Family, FittedParameter},
        memory::walk,
    },
    text::with_sd,
};
use truegap_core::{Drive, EffectId, Parameter, Readout, Stage, simulator::StageName};

/// Limit of the rate of the reading, the same up and down.
pub struct RateLimit;

/// What is read after a step of the clock: from the true values before and after it, what was read before it, and how far the reading can go in it.
type Step = fn([f64; 2], f64, f64) -> f64;

struct Limit {
    /// s for one unit of the reading
    slowness: f64,
    step: Step,
}

/// Exact for a true value that is straight between rows: the reading goes as fast as it can until it meets the true value, and then with it or, where that is faster, after it.
fn straight([from, to]: [f64; 2], read: f64, reach: f64) -> f64 {
    let (behind, way) = (from - read, to - from);
    let side = if behind == 0.0 { way.signum() } else { behind.signum() };
    // share of the step after which they meet
    let closing = side * reach - way;
    let met = if behind == 0.0 { 0.0 } else { behind / closing };
    if !(0.0..1.0).contains(&met) || side * closing < 0.0 {
        return read + side * reach;
    }
    if way.abs() <= reach { to } else { read + side * reach * met + way.signum() * reach * (1.0 - met) }
}

/// For the sibling: slower where little is left.
fn rounded([_, to]: [f64; 2], read: f64, reach: f64) -> f64 {
    read + reach * ((to - read) / reach).tanh()
}

impl Stage for Limit {
    fn readout(&self, drive: &Drive<'_>, _: &Readout, value: &mut [f64]) {
        if self.slowness <= 0.0 {
            return;
        }
        let mut before = 0.0;
        walk(drive.inputs, |row, step| {
            let now = value[row];
            // each run begins where it should
            if let Some(step) = step.filter(|step| *step > 0.0) {
                value[row] = (self.step)([before, now], value[row - 1], step / self.slowness);
            }
            before = now;
        });
    }
}

/// Times that the reading takes for its whole span from which a search starts, in runs: while a limit is faster than every change, nothing is felt of it.
const TIMES: [f64; 4] = [0.003, 0.02, 0.1, 0.5];

impl Effect for RateLimit {
    fn id(&self) -> EffectId {
        EffectId("rate_limit")
    }
    fn stage(&self) -> StageName {
        StageName::Readout
    }
    fn family(&self) -> Family {
        Family::Readout
    }
    fn in_words(&self, _: &Context<'_>) -> Option<InWords> {
        Some(InWords { place: Place::Readout, driver: Driver::Reading, kinetics: Kinetics::FirstOrder })
    }
    fn about(&self) -> About {
        About {
            physics: "the reading follows no faster than at a certain rate: a motor, a valve, a pen, an amplifier at its slew rate",
            equation: "dv/dt = +r or -r while the reading is behind, else v = true; each run begins at the true value; r = 1 / s, s the slowness",
            excitation: "changes that are faster than the reading can follow, of more than one size, with a clock",
            impostors: &["slow_response", "readout_lag", "time_offset", "friction"],
            separates: "twice the step takes twice the time, along a straight line with a corner at its end",
            source: "Horowitz & Hill, The Art of Electronics, sec. 4.4 (slew rate)",
        }
    }
    fn parameters(&self, context: &Context<'_>) -> Vec<Parameter> {
        let run = context.run_s();
        let span = context.response_span.abs();
        // somewhere between a step and a run, in the logarithm
        let middle = 0.3 * (context.step_s() * run).sqrt();
        let unit = format!("s/{}", context.simulator.unit());
        vec![
            Parameter::normal("slowness", &unit, 0.0, middle / span, "time that the reading takes for one unit")
                .within(0.0, run / span),
        ]
    }
    fn far_sizes(&self, context: &Context<'_>, _: &Problem<'_>) -> Vec<f64> {
        let per_unit = context.run_s() / context.response_span.abs();
        TIMES.map(|time| time * per_unit).to_vec()
    }
    fn smooths(&self) -> bool {
        true
    }
    fn testable(&self, context: &Context<'_>) -> Result<(), String> {
        context.has(StageName::Readout)?;
        context.needs_clock()?;
        if context.has_plates() {
            return Err("the base model has places for memory of its own (creep, air, electronics)".into());
        }
        if !context.simulator.moves() {
            return Err("a value that does not move is not late".into());
        }
        context.needs_movement()
    }
    fn with(&self, values: &[f64], _: &Context<'_>) -> Box<dyn Stage> {
        Box::new(Limit { slowness: values[0], step: straight })
    }
    fn sibling(&self, values: &[f64], _: &Context<'_>) -> Option<Box<dyn Stage>> {
        Some(Box::new(Limit { slowness: values[0], step: rounded }))
    }
    fn says(&self, fitted: &[FittedParameter]) -> String {
        let slowness = &fitted[0];
        let rate = slowness.value.recip();
        let unit = slowness.parameter.unit.trim_start_matches("s/");
        let rate = with_sd(rate, rate * slowness.sd / slowness.value, &format!("{unit}/s"));
        format!("the reading follows no faster than {rate}")
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use truegap_core::Inputs;

    /// A true value that rises by 6 units within a second and falls later, at 2 units a second at most, sampled unevenly: straight up until both meet, and with it from there.
    #[test]
    fn a_step_takes_a_time_in_proportion_to_its_size() {
        let time = vec![0.0, 1.0, 1.5, 2.0, 3.5, 4.0, 5.0, 10.0, 12.0, 20.0];
        let inputs = Inputs { time_s: Some(time), run: vec![1; 10], ..Inputs::default() };
        let drive = Drive { inputs: &inputs, load: &[], temperature_c: &[], reference_c: 25.0, full_load: 1.0 };
        let mut value = vec![0.0, 6.0, 6.0, 6.0, 6.0, 6.0, 6.0, 0.0, -1.0, -1.0];
        Limit { slowness: 0.5, step: straight }.readout(&drive, &Readout { zero: 0.0, span: 6.0 }, &mut value);
        assert_eq!(value, [0.0, 2.0, 3.0, 4.0, 6.0, 6.0, 6.0, 0.0, -1.0, -1.0]);
    }

    #[test]
    fn the_sentence_tells_a_rate() {
        let parameter = Parameter::normal("slowness", "s/V", 0.0, 1.0, "slowness");
        let fitted = FittedParameter { parameter, value: 0.25, sd: 0.01, sd_of_fit: 0.01, at_limit: false };
        assert_eq!(RateLimit.says(&[fitted]), "the reading follows no faster than 4.00 V/s (sd 0.16)");
    }
}
