//! The reading follows what it measures with a time constant, or two, side by side or one behind the other.

use crate::{
    data::context::Context,
    effects::composed::words::{Driver, InWords, Kinetics, Place},
    effects::{
        between_rows,
        delay::{Delay, reads_temperature},
        effect::{About, Effect, Family, FittedParameter},
        memory::{Haste, first_order_lag},
        numbers::cut,
    },
    text::{percent_of, percent_with_sd, significant, with_sd},
};
use truegap_core::{Drive, EffectId, Parameter, Readout, Stage, simulator::StageName};

/// Lag of the reading by two ways, a quick and a slow one, of any length up to that of a run.
pub struct SlowResponse;

pub(crate) struct Late(pub Delay);

impl Stage for Late {
    fn readout(&self, drive: &Drive<'_>, readout: &Readout, value: &mut [f64]) {
        let haste = Haste { at: (OF_THE_SPAN * readout.span).abs().max(f64::MIN_POSITIVE), ..self.0.haste };
        Delay { haste, ..self.0.clone() }.apply(drive.inputs, readout.zero, value);
    }
}

/// Sibling: two equal lags one after the other, with the same delay of a ramp.
pub(crate) struct OneAfterTheOther(pub f64);

impl Stage for OneAfterTheOther {
    fn readout(&self, drive: &Drive<'_>, _: &Readout, value: &mut [f64]) {
        for _ in 0..2 {
            first_order_lag(drive.inputs, 0.5 * self.0, value, |first| first);
        }
    }
}

/// Parameters of a lag of the reading: `tau`, `slow_share`, `slower`, `before`, `first_stage`, `recovery`, `haste`, `between_rows`.
pub(crate) fn parameters(context: &Context<'_>) -> Vec<Parameter> {
    let run = context.run_s();
    // somewhere between a step and a run, in the logarithm
    let middle = 0.3 * (context.step_s() * run).sqrt();
    let rate = usual_rate(context.response_span.abs(), context);
    let mut numbers = vec![
        Parameter::normal("tau", "s", 0.0, middle, "time constant of the reading, of its quick way where there are two")
            .within(0.0, run),
        Parameter::normal("slow_share", "1", 0.0, 0.4, "part that follows by the slower way").within(0.0, 1.0),
        Parameter::log_normal("slower", "1", 10.0, 0.7, "its time constant over that of the quick way").within(2.0, AT_ONCE),
        Parameter::normal("before", &format!("{}/s", context.simulator.unit()), 0.0, rate, "change before the first row"),
        first_stage(),
        Parameter::normal("recovery", "1", 0.0, 0.7, "log of the time constant of a falling reading over that of a rising one")
            .within(-MOST_APART, MOST_APART),
        Parameter::normal(HASTE, "1", 0.0, 0.5, "exponent of the difference that is left in the speed, less 1").within(-0.9, 2.0),
    ];
    numbers.extend(between_rows::between_rows(context));
    numbers
}

/// Log of the greatest ratio of the time constants of a rising and of a falling reading: 20 times.
const MOST_APART: f64 = 3.0;

/// Time constant of a stage that comes before the others: a wall before a core, an amplifier behind a probe.
pub(crate) fn first_stage() -> Parameter {
    let meaning = "time constant of a first stage, over that of the stage behind it";
    Parameter::normal(FIRST_STAGE, "1", 0.0, 0.5, meaning).within(-NONE_BELOW, MOST_OF_FIRST)
}

/// Below 0 there is no first stage either, so that a law without one lies on no limit.
const NONE_BELOW: f64 = 0.1;

const FIRST_STAGE: &str = "first_stage";
const HASTE: &str = "haste";

/// Difference at which the time constant is told where the speed is not in proportion to it, spans of the reading.
const OF_THE_SPAN: f64 = 0.1;

/// Numbers of other laws of a lag: two stages, one behind the other; a reading that falls more slowly than it rises, or faster; a speed that goes with a power of the difference; a true value that is held between rows.
pub(crate) const OTHER_LAWS: &[&[&str]] = &[&[FIRST_STAGE], &["recovery"], &[HASTE], between_rows::HELD];

/// Numbers of a lag whose lower limit is a law as good as any.
pub(crate) const AT_ONCE_AS_WELL: &[&str] = &[FIRST_STAGE, between_rows::BETWEEN_ROWS];

/// Most times that the first stage is slower than the one behind it: which of the two comes first is not seen, so that beyond 1 they change places.
const MOST_OF_FIRST: f64 = 4.0;

/// Most times that the slow way is slower: the quick one then comes at once, beside any clock. (200 was a limit to which the fit of two thermometers ran, one of which follows at once for the most part.)
pub(crate) const AT_ONCE: f64 = 1e4;

/// Usual change before the first row, a second: five spans in a run.
pub(crate) fn usual_rate(span: f64, context: &Context<'_>) -> f64 {
    5.0 * span / context.run_s()
}

/// In equilibrium at first, or on its way up or down by `rate`: what was switched on or poured in just before the first row.
pub(crate) fn starts(rate: f64) -> Vec<Vec<f64>> {
    [[0.02, 10.0, 0.0], [0.5, 15.0, 0.0], [0.02, 10.0, rate], [0.02, 10.0, -rate]]
        .map(|[share, slower, before]| vec![share, slower, before, 0.0, 0.0, 0.0, 0.0])
        .to_vec()
}

pub(crate) fn late(values: &[f64]) -> Box<dyn Stage> {
    let [tau, share, slower, before, first, recovery, power, between] =
        std::array::from_fn(|i| values.get(i).copied().unwrap_or(0.0));
    let haste = Haste { power, ..Haste::default() };
    Box::new(Late(Delay { first_s: first * tau, recovery, haste, between, ..Delay::of_two(tau, share, slower, before) }))
}

/// Number of a late reading that says how it stood before its first row.
pub(crate) const BEFORE: &[&str] = &["before"];

/// Standard deviations from which a share of the slow way is spoken of, however small it is.
const STANDS_OUT: f64 = 3.0;
/// Share of the slow way from which it is spoken of, however unsure it is: a reader who is told of the quick way alone waits too short.
const MATTERS: f64 = 0.05;

/// `75 % of a change`, which the quick way carries; `None` where the slow one is not spoken of.
fn by_the_quick_way(share: &FittedParameter) -> Option<String> {
    let (quick, sd) = (1.0 - share.value, share.sd);
    let stands_out = share.value > STANDS_OUT * sd;
    let told = || if stands_out { percent_of(quick) } else { percent_with_sd(quick, sd) };
    (stands_out || share.value > MATTERS).then(|| told() + " of a change")
}

/// `a time constant of 4.20 min (sd 0.10)` of the quick way, with the slow one where there is one.
pub(crate) fn quick_and_slow(fitted: &[FittedParameter]) -> String {
    let [tau, slower] = [0, 2].map(|i| fitted[i].value);
    let slow = || crate::text::rounded(slower * tau, "s");
    let apart = by_the_quick_way(&fitted[1]).map(|quick| format!(" for {quick}, the rest with {}", slow()));
    format!("a time constant of {}{}{}", with_sd(tau, fitted[0].sd, "s"), apart.unwrap_or_default(), richer(fitted))
}

/// ` (8.0 s where the reading rises, 25.0 s where it falls), behind a first stage of 12.0 s`, as far as the law has these.
fn richer(fitted: &[FittedParameter]) -> String {
    let number = |name: &str| fitted.iter().find(|p| p.parameter.name == name).map_or(0.0, |p| p.value);
    let seconds = |factor: f64| crate::text::rounded(factor * fitted[0].value, "s");
    let (first, recovery) = (number(FIRST_STAGE), number("recovery"));
    let apart =
        |half: f64| format!(" ({} where the reading rises, {} where it falls)", seconds((-half).exp()), seconds(half.exp()));
    let ways = if recovery.abs() > NO_STAGE { apart(0.5 * recovery) } else { String::new() };
    let stage = if first > NO_STAGE { format!(", behind a first stage of {}", seconds(first)) } else { String::new() };
    let haste = number(HASTE);
    let of_a_power = if haste.abs() > NO_STAGE {
        format!(" at a tenth of the span, its speed going with the difference to the power of {}", significant(1.0 + haste, 3))
    } else {
        String::new()
    };
    of_a_power + &ways + &stage + between_rows::says(fitted)
}

/// Share of the time constant, or log of a ratio, below which a number of a richer law is not spoken of.
const NO_STAGE: f64 = 1e-3;

/// The same where the number is the mean of both time constants.
pub(crate) fn time_constants(fitted: &[FittedParameter]) -> String {
    let [tau, share, slower] = [0, 1, 2].map(|i| fitted[i].value);
    let quick = tau / (1.0 - share + share * slower);
    let [fast, slow] = [quick, slower * quick].map(|s| crate::text::rounded(s, "s"));
    let apart = by_the_quick_way(&fitted[1]).map(|part| format!(": {part} with {fast}, the rest with {slow}"));
    format!("a time constant of {}{}{}", with_sd(tau, fitted[0].sd, "s"), apart.unwrap_or_default(), richer(fitted))
}

impl Effect for SlowResponse {
    fn id(&self) -> EffectId {
        EffectId("slow_response")
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
            physics: "the reading follows what it measures with a time constant, by a quick way (a vent, a surface) and a slow one (a housing, a core)",
            equation: "value = (1 - s) lag(x; tau) + s lag(x; r tau), s the slow share, r how much slower; x is the true value, or lag(true; q tau) where a first stage comes before; tau is sqrt(e^c) times as long while the reading falls and as short while it rises, c the recovery; its speed goes with (|x - value| / (S / 10))^h besides, h the haste, S the span; x is straight between rows, or a share |b| of it has the value of the later row (b > 0) or of the earlier one (b < 0); `before` is the rate of the true value before the first row, and before each run in proportion to where it begins",
            excitation: "a simulated value or gap that changes faster than the reading can follow, with a clock",
            impostors: &["readout_lag", "time_offset", "offset_drift", "friction", "stress_relaxation"],
            separates: "behind on the way up and on the way down, by more the faster it goes, and there in the end",
            source: "Incropera, Fundamentals of Heat and Mass Transfer, ch. 5; Oppenheim & Willsky, Signals and Systems, sec. 6.5",
        }
    }
    fn parameters(&self, context: &Context<'_>) -> Vec<Parameter> {
        parameters(context)
    }
    fn of_start(&self, _: &Context<'_>) -> &'static [&'static str] {
        BEFORE
    }
    fn starts(&self, context: &Context<'_>) -> Vec<Vec<f64>> {
        cut(starts(usual_rate(context.response_span.abs(), context)), self.parameters(context).len())
    }
    fn share_of(&self, number: &str) -> Option<&'static str> {
        (number == "slower").then_some("slow_share")
    }
    fn may_be_nothing(&self) -> &'static [&'static str] {
        &["slow_share"]
    }
    fn other_laws(&self) -> &'static [&'static [&'static str]] {
        OTHER_LAWS
    }
    fn at_once(&self) -> &'static [&'static str] {
        AT_ONCE_AS_WELL
    }
    fn smooths(&self) -> bool {
        true
    }
    fn testable(&self, context: &Context<'_>) -> Result<(), String> {
        context.has(StageName::Readout)?;
        context.needs_clock()?;
        if context.has(StageName::Beads).is_ok() {
            return Err("the base model has places for memory of its own (creep, air, electronics)".into());
        }
        if reads_temperature(context) {
            return Err("the reading is a temperature: what delays it is a thermal lag".into());
        }
        if !context.simulator.moves() {
            return Err("a value that does not move is not late".into());
        }
        context.needs_movement()
    }
    fn with(&self, values: &[f64], _: &Context<'_>) -> Box<dyn Stage> {
        late(values)
    }
    fn sibling(&self, values: &[f64], _: &Context<'_>) -> Option<Box<dyn Stage>> {
        Some(Box::new(OneAfterTheOther(values[0])))
    }
    fn says(&self, fitted: &[FittedParameter]) -> String {
        format!("the reading follows late, with {}", quick_and_slow(fitted))
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    /// Numbers of a fit, each with its error.
    fn fitted(numbers: [(f64, f64); 3]) -> Vec<FittedParameter> {
        let number = |(value, sd): (f64, f64)| FittedParameter {
            parameter: Parameter::normal("number", "1", 0.0, 1.0, "number"),
            value,
            sd,
            sd_of_fit: sd,
            at_limit: false,
        };
        numbers.map(number).to_vec()
    }

    /// "120 ms" was told where a quarter of a change follows with 8.3 s: its share was unsure.
    #[test]
    fn a_slow_way_that_matters_is_told_however_unsure_its_share_is() {
        for (share_sd, share) in [(0.02, "75 %"), (0.1, "75 % (sd 10)"), (f64::NAN, "75.0 %")] {
            let fitted = fitted([(0.12, 0.01), (0.25, share_sd), (69.0, 5.0)]);
            let says = format!("a time constant of 120 ms (sd 10) for {share} of a change, the rest with 8.28 s");
            assert_eq!(quick_and_slow(&fitted), says);
        }
        // 10 s is the mean of 4 s and 28 s
        let mean = fitted([(10.0, 1.0), (0.25, 0.1), (7.0, 5.0)]);
        assert_eq!(
            time_constants(&mean),
            "a time constant of 10.0 s (sd 1.0): 75 % (sd 10) of a change with 4.00 s, the rest with 28.0 s"
        );
    }

    #[test]
    fn a_slow_way_of_next_to_nothing_is_told_where_it_is_sure_alone() {
        let with = |sd: f64| quick_and_slow(&fitted([(0.12, 0.01), (0.02, sd), (69.0, 5.0)]));
        assert_eq!(with(0.01), "a time constant of 120 ms (sd 10)");
        assert_eq!(with(0.002), "a time constant of 120 ms (sd 10) for 98 % of a change, the rest with 8.28 s");
    }
}
