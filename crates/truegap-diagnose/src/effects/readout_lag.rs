//! The electronics are a low pass.

use crate::{
    data::context::Context,
    effects::composed::words::{Driver, InWords, Kinetics, Place},
    effects::{
        between_rows,
        effect::{About, Effect, Family, FittedParameter, Separation},
        memory::{first_order_lag, lag_between_rows},
        numbers::cut,
    },
    text::with_sd,
};
use truegap_core::{Drive, EffectId, Parameter, Readout, Stage, simulator::StageName};

/// First-order low pass on the reading.
pub struct ReadoutLag;

struct LowPass {
    tau_s: f64,
    between: f64,
}

fn low_pass(values: &[f64]) -> LowPass {
    LowPass { tau_s: values[0], between: values.get(1).copied().unwrap_or(0.0) }
}

impl Stage for LowPass {
    fn readout(&self, drive: &Drive<'_>, _: &Readout, value: &mut [f64]) {
        lag_between_rows(drive.inputs, (self.tau_s, self.between), value, |first| first);
    }
}

/// Sibling: two equal poles one after the other, with the same delay of a ramp.
struct TwoPoles(LowPass);

impl Stage for TwoPoles {
    fn readout(&self, drive: &Drive<'_>, _: &Readout, value: &mut [f64]) {
        for _ in 0..2 {
            first_order_lag(drive.inputs, 0.5 * self.0.tau_s, value, |first| first);
        }
    }
}

impl Effect for ReadoutLag {
    fn id(&self) -> EffectId {
        EffectId("readout_lag")
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
            physics: "filter or conversion time of the electronics: the reading is behind the capacitance",
            equation: "tau dv/dt + v = true, at rest when a run starts; true is straight between rows, or a share |b| of it has the value of the later row (b > 0) or of the earlier one (b < 0), where rows left out bear that out",
            excitation: "load that changes fast, at more than one rate, with a clock",
            impostors: &["time_offset", "viscoelastic_creep", "trapped_air_stiffness", "rate_independent_hysteresis"],
            separates: "the loop over load grows with the rate of the reading, gone in a hold; a lag rounds corners, a time offset does not",
            source: "Oppenheim & Willsky, Signals and Systems, sec. 6.5 (first-order systems)",
        }
    }
    fn separations(&self) -> &'static [Separation] {
        &[Separation { rival: "viscoelastic_creep", says: "put a switched reference capacitor on the same electronics" }]
    }
    fn parameters(&self, context: &Context<'_>) -> Vec<Parameter> {
        let scale = context.of_device_s(0.1);
        let tau = Parameter::normal("tau", "s", 0.0, scale, "time constant of the electronics")
            .within(0.0, (0.5 * context.longest_run_s).max(scale));
        std::iter::once(tau).chain(between_rows::between_rows(context)).collect()
    }
    fn starts(&self, context: &Context<'_>) -> Vec<Vec<f64>> {
        cut(vec![vec![0.0]], self.parameters(context).len())
    }
    fn other_laws(&self) -> &'static [&'static [&'static str]] {
        &[between_rows::HELD]
    }
    fn at_once(&self) -> &'static [&'static str] {
        between_rows::HELD
    }
    fn smooths(&self) -> bool {
        true
    }
    fn testable(&self, context: &Context<'_>) -> Result<(), String> {
        context.has(StageName::Readout)?;
        context.needs_clock()?;
        if context.temperature_span() > 1.0 { Ok(()) } else { context.needs_movement() }
    }
    fn with(&self, values: &[f64], _: &Context<'_>) -> Box<dyn Stage> {
        Box::new(low_pass(values))
    }
    fn sibling(&self, values: &[f64], _: &Context<'_>) -> Option<Box<dyn Stage>> {
        Some(Box::new(TwoPoles(low_pass(values))))
    }
    fn says(&self, fitted: &[FittedParameter]) -> String {
        let lag = with_sd(fitted[0].value, fitted[0].sd, "s");
        format!("the electronics follow with a time constant of {lag}{}", between_rows::says(fitted))
    }
}
