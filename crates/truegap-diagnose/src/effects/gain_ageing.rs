//! The sensitivity changes slowly with the clock.

use crate::{
    data::context::Context,
    effects::composed::words::{Driver, InWords, Kinetics, Place},
    effects::{
        effect::{About, Effect, Family, FittedParameter},
        gain_error::{BESIDE, gain_is_fixed, is_given},
        memory::elapsed_s,
        offset_drift::{HOUR, USUAL_FADING, drifted},
    },
    text::{percent_with_sd, rounded},
};
use truegap_core::{Drive, EffectId, Parameter, Readout, Stage, simulator::StageName};

/// Gain that falls or rises at a rate which may itself fade or grow.
pub struct GainAgeing;

/// Greatest logarithm of a gain, either way: beyond it nothing is left of the reading, or of what came before.
const FARTHEST: f64 = 5.0;

struct Ageing {
    /// change of the logarithm of the gain an hour, at the first row
    per_hour: f64,
    fading_per_hour: f64,
    /// reading at which the gain changes nothing, spans above that without gain
    pivot: f64,
    /// whether readings are told from 0, as those beside a simulation are, or from the one without load
    from_zero: bool,
    /// hours after the first row at which the gain is as calibrated
    neutral_hours: f64,
}

impl Ageing {
    /// Logarithm of the gain `hours` after the first row.
    fn after(&self, hours: f64) -> f64 {
        let course = |hours| drifted(hours, self.fading_per_hour);
        (self.per_hour * (course(hours) - course(self.neutral_hours))).clamp(-FARTHEST, FARTHEST)
    }

    /// Applies `change`, a gain less 1 by its logarithm, to what stands above the pivot.
    fn apply(&self, drive: &Drive<'_>, readout: &Readout, value: &mut [f64], change: impl Fn(f64) -> f64) {
        let without = if self.from_zero { 0.0 } else { readout.of_no_gain() };
        let pivot = without + self.pivot * readout.span;
        for (row, value) in value.iter_mut().enumerate() {
            *value += (*value - pivot) * change(self.after(elapsed_s(drive.inputs, row) / HOUR));
        }
    }
}

impl Stage for Ageing {
    fn readout(&self, drive: &Drive<'_>, readout: &Readout, value: &mut [f64]) {
        self.apply(drive, readout, value, f64::exp_m1);
    }
}

/// Sibling: a gain that goes on straight, not as a share of what is left of it.
struct Straight(Ageing);

impl Stage for Straight {
    fn readout(&self, drive: &Drive<'_>, readout: &Readout, value: &mut [f64]) {
        self.0.apply(drive, readout, value, |log_gain| log_gain.max(-0.95));
    }
}

fn ageing(values: &[f64], context: &Context<'_>) -> Ageing {
    let neutral_hours = values.get(3).copied().unwrap_or(0.0);
    Ageing { per_hour: values[0], fading_per_hour: values[1], pivot: values[2], from_zero: is_given(context), neutral_hours }
}

/// Usual change of the logarithm of the gain over a recording: glass in the open loses 0.1 to 0.4 of its light by dirt until it is washed, a poisoned catalyst or a fouled electrode more.
const USUAL: f64 = 0.3;
/// Fastest at the first row, over the recording: that of one that is gone for good within a fiftieth of it.
const FASTEST: f64 = FARTHEST * QUICKEST_FADING;
/// Time constants in a recording from which on a gain is told by what is lost in the end: 5 % of it are to come.
const COMES_TO_REST: f64 = 3.0;
/// Greatest fading, over the recording: what has aged sooner is a few rows.
const QUICKEST_FADING: f64 = 50.0;

impl Effect for GainAgeing {
    fn id(&self) -> EffectId {
        EffectId("gain_ageing")
    }
    fn stage(&self) -> StageName {
        StageName::Readout
    }
    fn family(&self) -> Family {
        Family::Readout
    }
    fn in_words(&self, _: &Context<'_>) -> Option<InWords> {
        Some(InWords { place: Place::Readout, driver: Driver::Time, kinetics: Kinetics::Static })
    }
    fn about(&self) -> About {
        About {
            physics: "the sensitivity falls or rises with the clock: dirt on a window, scale on a probe, a lamp, an electrode or a catalyst that ages",
            equation: "value = p + (true - p) exp(r (1 - exp(-k t)) / k), t from the first row, p the reading that it leaves alone (0 beside a simulation, that without load elsewhere, give or take); k = 0 goes on for ever; where the gain of the base model is not calibrated, the exponent is 0 at t = n",
            excitation: "a clock, and what is measured going up and down both early and late",
            impostors: &["offset_drift", "gain_change", "gain_drift", "driver_gain"],
            separates: "in proportion to the reading: a zero that drifts moves small readings as much as large ones; a step is over in a few rows",
            source: "sensitivity drift, JCGM 200:2012 (VIM), 4.21; soiling of optics: IEC 61724-1; fading by first-order loss of active sites: Levenspiel, Chemical Reaction Engineering, ch. 21",
        }
    }
    fn parameters(&self, context: &Context<'_>) -> Vec<Parameter> {
        let hours = context.length_s() / HOUR;
        let mut list = vec![
            Parameter::normal("rate", "1/h", 0.0, USUAL / hours, "relative change of the gain in an hour, at the first row")
                .within(-FASTEST / hours, FASTEST / hours),
            Parameter::normal("fading", "1/h", 0.0, USUAL_FADING / hours, "share of that rate that is lost in an hour")
                .within(-1.5 / hours, QUICKEST_FADING / hours),
            Parameter::normal("pivot", "spans", 0.0, 0.2, "reading that it leaves alone, above that without gain")
                .within(-BESIDE, BESIDE),
        ];
        if gain_is_fixed(context) {
            let meaning = "time after the first row at which the gain is that of the simulation";
            list.push(Parameter::normal("neutral", "h", 0.0, 0.5 * hours, meaning).within(-2.0 * hours, 2.0 * hours));
        }
        list
    }
    fn starts(&self, context: &Context<'_>) -> Vec<Vec<f64>> {
        let hours = context.length_s() / HOUR;
        let neutral: &[f64] = if gain_is_fixed(context) { &[0.0] } else { &[] };
        [[0.0, 0.0], [4.0, 0.0], [0.0, 0.3], [0.0, -0.3]]
            .map(|[fading, pivot]| [&[fading / hours, pivot], neutral].concat())
            .to_vec()
    }
    fn of_start(&self, context: &Context<'_>) -> &'static [&'static str] {
        if gain_is_fixed(context) { &["neutral"] } else { &[] }
    }
    fn comes_down_to(&self) -> Option<EffectId> {
        Some(EffectId("gain_error"))
    }
    fn may_be_nothing(&self) -> &'static [&'static str] {
        &["fading", "pivot", "neutral"]
    }
    fn testable(&self, context: &Context<'_>) -> Result<(), String> {
        context.has(StageName::Readout)?;
        if context.has_plates() {
            return Err("the base model has the ageing of its beads and of its electronics by temperature".into());
        }
        if !context.simulator.moves() {
            return Err("a value that does not move shows no gain".into());
        }
        context.needs_movement()?;
        context.needs_duration()
    }
    fn with(&self, values: &[f64], context: &Context<'_>) -> Box<dyn Stage> {
        Box::new(ageing(values, context))
    }
    fn sibling(&self, values: &[f64], context: &Context<'_>) -> Option<Box<dyn Stage>> {
        Some(Box::new(Straight(ageing(values, context))))
    }
    fn says(&self, fitted: &[FittedParameter]) -> String {
        let [rate, fading] = [&fitted[0], &fitted[1]];
        let way = if rate.value < 0.0 { "falls" } else { "rises" };
        if fading.value > 2.0 * fading.sd && fading.value > 0.0 {
            // at the first row it is of no use to say how fast: what is lost in the end is what one sees
            let last = (rate.value / fading.value).clamp(-FARTHEST, FARTHEST).exp();
            let size = percent_with_sd((last - 1.0).abs(), last * rate.sd / fading.value);
            return format!("the gain {way} by {size} in the end, with a time constant of {}", rounded(HOUR / fading.value, "s"));
        }
        format!("the gain {way} by {} an hour", percent_with_sd(rate.value.abs(), rate.sd))
    }
    fn told(&self, fitted: &[FittedParameter], context: &Context<'_>, _: &[(EffectId, Vec<FittedParameter>)]) -> String {
        let values: Vec<f64> = fitted.iter().map(|number| number.value).collect();
        let (law, hours) = (Ageing { neutral_hours: 0.0, ..ageing(&values, context) }, context.length_s() / HOUR);
        if law.fading_per_hour * hours > COMES_TO_REST {
            return self.says(fitted);
        }
        // a rate of a year an hour is not what a person would say, and no end is seen
        let last = law.after(hours).exp();
        let way = if last < 1.0 { "falls" } else { "rises" };
        let size = percent_with_sd((last - 1.0).abs(), last * drifted(hours, law.fading_per_hour) * fitted[0].sd);
        format!("the gain {way} by {size} from the first row to the last")
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use truegap_core::Inputs;

    fn read(law: &dyn Stage, true_values: [f64; 3]) -> Vec<f64> {
        let inputs = Inputs { run: vec![1; 3], time_s: Some(vec![0.0, HOUR, 2.0 * HOUR]), ..Inputs::default() };
        let drive = Drive { inputs: &inputs, load: &[], temperature_c: &[], reference_c: 25.0, full_load: 1.0 };
        let mut value = true_values.to_vec();
        law.readout(&drive, &Readout { zero: 1.0, span: 4.0 }, &mut value);
        value
    }

    fn halving(neutral_hours: f64) -> Ageing {
        Ageing { per_hour: -(2f64.ln()), fading_per_hour: 0.0, pivot: 0.0, from_zero: false, neutral_hours }
    }

    /// A gain that halves in an hour is a quarter after two; what stands at the reading of no gain stays.
    #[test]
    fn a_gain_that_halves_every_hour_is_a_quarter_after_two() {
        let law = halving(0.0);
        let value = read(&law, [5.0, 5.0, 5.0]);
        for (value, exact) in value.iter().zip([5.0, 3.0, 2.0]) {
            approx::assert_relative_eq!(*value, exact, max_relative = 1e-12);
        }
        assert_eq!(read(&law, [1.0, 1.0, 1.0]), [1.0, 1.0, 1.0]);
    }

    /// Where the simulation was calibrated after an hour, it is right there, and the gain was twice as large before.
    #[test]
    fn a_simulation_may_be_right_at_another_time() {
        let value = read(&halving(1.0), [5.0, 5.0, 5.0]);
        for (value, exact) in value.iter().zip([9.0, 5.0, 3.0]) {
            approx::assert_relative_eq!(*value, exact, max_relative = 1e-12);
        }
    }

    #[test]
    fn a_gain_is_told_by_what_is_lost_in_the_end_where_it_comes_to_rest() {
        let number = |name: &str, unit: &str, value: f64, sd: f64| {
            let parameter = Parameter::normal(name, unit, 0.0, 1.0, "");
            FittedParameter { parameter, value, sd, sd_of_fit: sd, at_limit: false }
        };
        let mut fitted =
            vec![number("rate", "1/h", -0.1, 0.01), number("fading", "1/h", 0.5, 0.05), number("pivot", "spans", 0.0, 0.0)];
        // exp(-0.2) is 0.819
        assert_eq!(GainAgeing.says(&fitted), "the gain falls by 18.1 % (sd 1.6) in the end, with a time constant of 120 min");
        fitted[1].value = 0.0;
        assert_eq!(GainAgeing.says(&fitted), "the gain falls by 10.0 % (sd 1.0) an hour");
    }
}
