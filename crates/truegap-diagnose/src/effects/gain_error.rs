//! The scale of a simulation that is given is off by a factor.

use crate::{
    data::context::Context,
    effects::composed::words::{Driver, InWords, Kinetics, Place},
    effects::effect::{About, Effect, Family, FittedParameter},
    text::percent_with_sd,
};
use truegap_core::{Drive, EffectId, Parameter, Readout, Stage, simulator::StageName};

/// Factor between the reading and a simulation whose gain is not calibrated.
pub struct GainError;

/// The factor less 1.
struct Factor(f64);

impl Stage for Factor {
    fn readout(&self, _: &Drive<'_>, _: &Readout, value: &mut [f64]) {
        value.iter_mut().for_each(|value| *value += self.0 * *value);
    }
}

/// Whether a number of a base model is the factor on a simulation that is given: a ratio, and no reading.
fn is_factor(number: &Parameter) -> bool {
    number.name == "gain" && (number.unit.is_empty() || number.unit.contains(" per "))
}

/// Whether a simulation is given whose gain is not calibrated: then a factor is an effect, and so is the state in which a gain that moves is right.
pub fn gain_is_fixed(context: &Context<'_>) -> bool {
    is_given(context) && !gain_is_free(context)
}

/// Farthest reading that a gain leaves alone, spans beside what is read: from farther away a gain is a zero that moves with what changes it (generated: a drift of 0.3 V was told as either with a zero five spans
/// away, and a sensor that its current heats as a gain about a reading 1.8 spans above).
pub const BESIDE: f64 = 1.0;

/// Whether a simulation is given that moves: its readings are told from 0.
pub fn is_given(context: &Context<'_>) -> bool {
    context.moved.simulated && !context.has_plates()
}

fn gain_is_free(context: &Context<'_>) -> bool {
    context.simulator.parameters().iter().any(is_factor)
}

impl Effect for GainError {
    fn id(&self) -> EffectId {
        EffectId("gain_error")
    }
    fn stage(&self) -> StageName {
        StageName::Readout
    }
    fn family(&self) -> Family {
        Family::Readout
    }
    fn in_words(&self, _: &Context<'_>) -> Option<InWords> {
        Some(InWords { place: Place::Readout, driver: Driver::Reading, kinetics: Kinetics::Static })
    }
    fn about(&self) -> About {
        About {
            physics: "the scale is off by a factor: a calibration, a reference, a constant of the material in the simulation",
            equation: "value = (1 + g) true",
            excitation: "a simulation that moves, and whose gain is not free under [base]",
            impostors: &["nonlinearity", "saturation", "gain_drift", "gain_change"],
            separates: "in proportion to the reading, the same all the time; a straight line through reading over simulation",
            source: "gain error, IEC 60359; Pallas-Areny & Webster, Sensors and Signal Conditioning, sec. 1.3",
        }
    }
    fn parameters(&self, _: &Context<'_>) -> Vec<Parameter> {
        vec![Parameter::normal("error", "1", 0.0, 0.1, "reading over simulation, less 1").within(-0.99, 10.0)]
    }
    fn testable(&self, context: &Context<'_>) -> Result<(), String> {
        context.has(StageName::Readout)?;
        if !is_given(context) {
            return Err("no simulation that moves is given; the gain of other base models is calibrated".into());
        }
        if gain_is_free(context) {
            return Err("the gain of the simulation is free under [base], so that calibration takes it up".into());
        }
        Ok(())
    }
    fn with(&self, values: &[f64], _: &Context<'_>) -> Box<dyn Stage> {
        Box::new(Factor(values[0]))
    }
    fn sibling(&self, values: &[f64], _: &Context<'_>) -> Option<Box<dyn Stage>> {
        // the number as the logarithm of the factor
        Some(Box::new(Factor(values[0].exp_m1())))
    }
    fn says(&self, fitted: &[FittedParameter]) -> String {
        let error = &fitted[0];
        let way = if error.value < 0.0 { "smaller" } else { "larger" };
        let size = percent_with_sd(error.value.abs(), error.sd);
        format!(
            "the scale is off: the reading is {size} {way} than the simulation, in proportion (free = [\"gain\", \"offset\"] under [base] calibrates it)"
        )
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use truegap_core::Inputs;

    #[test]
    fn the_reading_is_a_multiple_of_the_simulation() {
        let inputs = Inputs { run: vec![1; 3], ..Inputs::default() };
        let drive = Drive { inputs: &inputs, load: &[], temperature_c: &[], reference_c: 25.0, full_load: 1.0 };
        let mut value = vec![-1.0, 0.0, 4.0];
        Factor(0.25).readout(&drive, &Readout { zero: -1.0, span: 5.0 }, &mut value);
        assert_eq!(value, [-1.25, 0.0, 5.0]);
    }
}
