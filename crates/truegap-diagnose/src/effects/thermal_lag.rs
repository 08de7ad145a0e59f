//! The sensor follows the thermometer with a time constant.

use crate::{
    data::context::Context,
    effects::composed::words::{Driver, InWords, Kinetics, Place},
    effects::{
        delay::reads_temperature,
        effect::{About, Effect, Family, FittedParameter},
        memory::first_order_lag,
        numbers::cut,
        slow_response::{self, OneAfterTheOther},
    },
};
use std::cell::Cell;
use truegap_core::{EffectId, Inputs, Parameter, Stage, simulator::StageName};

/// Thermal lag of a part that follows at once with its surface and a part that follows more slowly.
pub struct ThermalLag;

/// First-order lags side by side.
struct Lag {
    /// time constant in s, and share of the sensor that follows with it
    parts: Vec<(f64, f64)>,
    /// time constant in s of a first stage, which all of them are behind; 0 where there is none
    first_s: f64,
    /// change of the temperature before the first row of the recording, K/s; later runs begin in equilibrium
    before: f64,
}

impl Lag {
    /// A quick part and a part, `share` of the whole, that follows `slower` times more slowly; `tau_s` is the mean of both time constants.
    fn of_two(tau_s: f64, share: f64, slower: f64) -> Self {
        let quick = tau_s / (1.0 - share + share * slower);
        Self { parts: vec![(quick, 1.0 - share), (quick * slower, share)], first_s: 0.0, before: 0.0 }
    }

    /// One stage on the way of a temperature, in place; the first run may be on its way.
    fn stage(&self, inputs: &Inputs, tau_s: f64, temperature_c: &mut [f64]) {
        let begun = Cell::new(false);
        first_order_lag(
            inputs,
            tau_s,
            temperature_c,
            |first| if begun.replace(true) { first } else { first - tau_s * self.before },
        );
    }
}

impl Stage for Lag {
    fn thermal(&self, inputs: &Inputs, temperature_c: &mut [f64]) {
        if self.parts.iter().all(|(tau, _)| *tau <= 0.0) {
            return;
        }
        self.stage(inputs, self.first_s, temperature_c);
        let given = temperature_c.to_vec();
        temperature_c.fill(0.0);
        for (tau_s, share) in self.parts.iter().filter(|(_, share)| *share > 0.0) {
            let mut part = given.clone();
            self.stage(inputs, *tau_s, &mut part);
            temperature_c.iter_mut().zip(&part).for_each(|(sum, part)| *sum += share * part);
        }
    }
}

/// Sibling: the mean temperature of a slab heated on one face, the first modes of Fourier's series.
fn slab(tau_s: f64) -> Lag {
    const MODES: [f64; 4] = [1.0, 3.0, 5.0, 7.0];
    let all: f64 = MODES.iter().map(|n| (n * n).recip()).sum();
    Lag { parts: MODES.iter().map(|n| (1.1 * tau_s / (n * n), (n * n * all).recip())).collect(), first_s: 0.0, before: 0.0 }
}

/// Whether how the recording began is open. A stack of plates, whose every number its priors know, begins its runs in equilibrium; a rig begins when somebody presses the button.
fn begins_anyhow(context: &Context<'_>) -> bool {
    !context.has_plates()
}

/// Usual change before the first row, of what is late: the reading that is a temperature, else the temperature, K/s.
fn usual_rate(context: &Context<'_>) -> f64 {
    let span = if reads_temperature(context) { context.response_span.abs() } else { context.temperature_span().max(1.0) };
    slow_response::usual_rate(span, context)
}

impl Effect for ThermalLag {
    fn id(&self) -> EffectId {
        EffectId("thermal_lag")
    }
    fn stage(&self) -> StageName {
        StageName::ThermalPath
    }
    fn family(&self) -> Family {
        Family::Thermal
    }
    fn in_words(&self, _: &Context<'_>) -> Option<InWords> {
        Some(InWords { place: Place::Inputs, driver: Driver::Temperature, kinetics: Kinetics::FirstOrder })
    }
    fn about(&self) -> About {
        About {
            physics: "heat takes time to arrive, so what is read is behind the temperature beside it",
            equation: "T_s = (1 - s) lag(T; q) + s lag(T; r q), lag first-order, tau = (1 - s) q + s r q; s = 0 is a single time constant; without plates, `before` is the rate of T before the first row, and T is lag(T; p tau) where a first stage comes before",
            excitation: "temperature that changes faster than the sensor can follow, with a clock",
            impostors: &["thermal_hysteresis", "offset_drift", "readout_lag"],
            separates: "the loop over temperature grows with the rate of heating and closes in a hold",
            source: "lumped heat capacities, Incropera, Fundamentals of Heat and Mass Transfer, ch. 5",
        }
    }
    fn parameters(&self, context: &Context<'_>) -> Vec<Parameter> {
        if reads_temperature(context) {
            return slow_response::parameters(context);
        }
        let scale = 0.2 * context.run_s();
        let mut list = vec![
            Parameter::normal("tau", "s", 0.0, scale, "time constant of the thermal path, mean of both parts")
                .within(0.0, 2.0 * context.longest_run_s),
            Parameter::normal("slow_share", "1", 0.0, 0.4, "part that follows more slowly").within(0.0, 1.0),
            Parameter::log_normal("slower", "1", 10.0, 0.7, "its time constant over that of the quick part").within(2.0, 200.0),
        ];
        if begins_anyhow(context) {
            list.push(Parameter::normal(
                "before",
                "K/s",
                0.0,
                usual_rate(context),
                "change of the temperature before the first row",
            ));
            list.push(slow_response::first_stage());
        }
        list
    }
    fn of_start(&self, context: &Context<'_>) -> &'static [&'static str] {
        if reads_temperature(context) || begins_anyhow(context) { slow_response::BEFORE } else { &[] }
    }
    fn starts(&self, context: &Context<'_>) -> Vec<Vec<f64>> {
        if reads_temperature(context) || begins_anyhow(context) {
            return cut(slow_response::starts(usual_rate(context)), self.parameters(context).len());
        }
        vec![vec![0.02, 10.0], vec![0.5, 15.0]]
    }
    fn share_of(&self, number: &str) -> Option<&'static str> {
        (number == "slower").then_some("slow_share")
    }
    fn may_be_nothing(&self) -> &'static [&'static str] {
        &["slow_share", "before"]
    }
    fn other_laws(&self) -> &'static [&'static [&'static str]] {
        slow_response::OTHER_LAWS
    }
    fn at_once(&self) -> &'static [&'static str] {
        slow_response::AT_ONCE_AS_WELL
    }
    fn smooths(&self) -> bool {
        true
    }
    fn testable(&self, context: &Context<'_>) -> Result<(), String> {
        context.needs_clock()?;
        if reads_temperature(context) {
            return context.has(StageName::Readout);
        }
        context.has(StageName::ThermalPath)?;
        context.needs_temperature(1.0)
    }
    fn with(&self, values: &[f64], context: &Context<'_>) -> Box<dyn Stage> {
        if reads_temperature(context) {
            return slow_response::late(values);
        }
        let [before, first] = [3, 4].map(|i| values.get(i).copied().unwrap_or(0.0));
        Box::new(Lag { before, first_s: first * values[0], ..Lag::of_two(values[0], values[1], values[2]) })
    }
    fn sibling(&self, values: &[f64], context: &Context<'_>) -> Option<Box<dyn Stage>> {
        if reads_temperature(context) {
            return Some(Box::new(OneAfterTheOther(values[0])));
        }
        Some(Box::new(slab(values[0])))
    }
    fn says(&self, fitted: &[FittedParameter]) -> String {
        format!("the sensor follows the thermometer with {}", slow_response::time_constants(fitted))
    }
    fn told(&self, fitted: &[FittedParameter], context: &Context<'_>, _: &[(EffectId, Vec<FittedParameter>)]) -> String {
        if reads_temperature(context) {
            return format!("the thermometer follows the temperature with {}", slow_response::quick_and_slow(fitted));
        }
        self.says(fitted)
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn behind_a_ramp(lag: &Lag) -> f64 {
        let time: Vec<f64> = (0..=4000).map(f64::from).collect();
        let inputs = Inputs { time_s: Some(time.clone()), run: vec![1; time.len()], ..Inputs::default() };
        let mut sensor = time.clone();
        lag.thermal(&inputs, &mut sensor);
        time[4000] - sensor[4000]
    }

    #[test]
    fn the_mean_time_constant_is_what_a_long_ramp_shows_whatever_the_parts() {
        for (share, slower) in [(0.0, 10.0), (0.5, 24.0), (0.85, 9.0)] {
            // the slowest part has a time constant of 96 s: e^-40 of the start is left
            approx::assert_relative_eq!(behind_a_ramp(&Lag::of_two(50.0, share, slower)), 50.0, max_relative = 1e-12);
        }
    }

    #[test]
    fn parts_of_any_share_are_the_sensor_itself_without_a_time_constant() {
        assert_eq!(behind_a_ramp(&Lag::of_two(0.0, 0.5, 10.0)), 0.0);
    }
}
