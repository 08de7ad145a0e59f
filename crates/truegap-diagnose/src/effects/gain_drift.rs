//! The gain of the electronics moves with temperature.

use crate::{
    data::context::Context,
    effects::composed::words::{Driver, InWords, Kinetics, Place},
    effects::effect::{About, Effect, Family, FittedParameter, Separation},
    effects::gain_error::{BESIDE, gain_is_fixed, is_given},
    text::with_sd,
};
use truegap_core::{Drive, EffectId, Parameter, Readout, Stage, simulator::StageName};

/// Gain about the zero of the readout, in proportion to a temperature.
pub struct GainDrift;

struct Gain {
    per_k: f64,
    /// kelvin above the reference at which the gain is as calibrated
    neutral_k: f64,
    /// whether it follows the thermometer, as the electronics of a sensor do, or what is behind the thermal path
    of_thermometer: bool,
    /// whether readings are told from 0, as those beside a simulation are
    from_zero: bool,
}

impl Gain {
    /// Reading that the gain leaves alone.
    fn unmoved(&self, readout: &Readout) -> f64 {
        let (low, high) = (readout.zero.min(readout.zero + readout.span), readout.zero.max(readout.zero + readout.span));
        let aside = BESIDE * (high - low);
        if self.from_zero && (low - aside..=high + aside).contains(&0.0) { 0.0 } else { readout.of_no_gain() }
    }

    /// Applies `gain(kelvin above the reference)` to what stands above the zero.
    fn apply(&self, drive: &Drive<'_>, readout: &Readout, value: &mut [f64], gain: impl Fn(f64) -> f64) {
        let Some(recorded) = drive.inputs.temperature_c.as_deref() else { return };
        let temperature = if self.of_thermometer { recorded } else { drive.temperature_c };
        let unmoved = self.unmoved(readout);
        for (value, t) in value.iter_mut().zip(temperature) {
            *value += (*value - unmoved) * gain(t - drive.reference_c - self.neutral_k);
        }
    }
}

impl Stage for Gain {
    fn readout(&self, drive: &Drive<'_>, readout: &Readout, value: &mut [f64]) {
        self.apply(drive, readout, value, |kelvin| self.per_k * kelvin);
    }
}

/// Farthest temperature from the reference at which a simulation may have its gain, K: sources calibrate at 0 to 45 degC.
const FARTHEST_K: f64 = 25.0;

/// Size of that difference from which on it is spoken of, in standard deviations.
const SPOKEN_OF: f64 = 3.0;

fn gain(values: &[f64], context: &Context<'_>) -> Gain {
    let neutral_k = values.get(1).copied().unwrap_or(0.0);
    Gain { per_k: values[0], neutral_k, of_thermometer: is_of_a_sensor(context), from_zero: is_given(context) }
}

/// Whether the base model is a capacitive sensor's, whose electronics are of a known kind.
fn is_of_a_sensor(context: &Context<'_>) -> bool {
    context.has_plates()
}

/// Sibling: a reference of the converter that moves, and divides.
struct Divider(Gain);

impl Stage for Divider {
    fn readout(&self, drive: &Drive<'_>, readout: &Readout, value: &mut [f64]) {
        self.0.apply(drive, readout, value, |kelvin| 1.0 / (1.0 - self.0.per_k * kelvin) - 1.0);
    }
}

impl Effect for GainDrift {
    fn id(&self) -> EffectId {
        EffectId("gain_drift")
    }
    fn stage(&self) -> StageName {
        StageName::Readout
    }
    fn family(&self) -> Family {
        Family::Readout
    }
    fn in_words(&self, _: &Context<'_>) -> Option<InWords> {
        Some(InWords { place: Place::Readout, driver: Driver::Temperature, kinetics: Kinetics::Static })
    }
    fn about(&self) -> About {
        About {
            physics: "the gain of the electronics moves with the temperature of the room",
            equation: "value = zero + (true - zero) (1 + k (T - T0 - n)), zero the reading without load at T0, or 0 where readings have both signs or, beside a simulation, come within a span of it; n = 0 where the gain of the base model is calibrated; T the thermometer beside plates, else the temperature behind the thermal path",
            excitation: "load cycles at two or more temperatures",
            impostors: &["permittivity_temperature", "electrode_warp", "ageing"],
            separates: "no change without load, in proportion to the signal with it, without delay; calibration can hide it in the temperature coefficient of the modulus",
            source: "Analog Devices AD7746 data sheet (gain drift against temperature)",
        }
    }
    fn separations(&self) -> &'static [Separation] {
        &[Separation {
            rival: "permittivity_temperature",
            says: "put a fixed reference capacitor on the same electronics and take it through the same temperatures",
        }]
    }
    fn parameters(&self, context: &Context<'_>) -> Vec<Parameter> {
        // of electronics the size is known; of a law of nature or somebody's simulation it is not
        let (sd, most) = if is_of_a_sensor(context) { (3e-3, 0.03) } else { (0.03, 0.5) };
        let mut list = vec![Parameter::normal("per_kelvin", "1/K", 0.0, sd, "relative change of the gain").within(-most, most)];
        if gain_is_fixed(context) {
            let meaning = "temperature above the reference at which the gain is that of the simulation";
            list.push(Parameter::normal("neutral", "K", 0.0, 5.0, meaning).within(-FARTHEST_K, FARTHEST_K));
        }
        list
    }
    fn starts(&self, context: &Context<'_>) -> Vec<Vec<f64>> {
        vec![if gain_is_fixed(context) { vec![0.0] } else { Vec::new() }]
    }
    fn came_later(&self) -> Vec<&'static str> {
        vec!["neutral"]
    }
    fn may_be_nothing(&self) -> &'static [&'static str] {
        &["neutral"]
    }
    fn testable(&self, context: &Context<'_>) -> Result<(), String> {
        context.has(StageName::Readout)?;
        if is_of_a_sensor(context) {
            context.needs_temperature(2.0)?
        } else {
            context.needs_some_temperature()?
        }
        if !context.simulator.moves() {
            return Err("a value that does not move shows no gain".into());
        }
        context.needs_movement()
    }
    fn with(&self, values: &[f64], context: &Context<'_>) -> Box<dyn Stage> {
        Box::new(gain(values, context))
    }
    fn sibling(&self, values: &[f64], context: &Context<'_>) -> Option<Box<dyn Stage>> {
        Some(Box::new(Divider(gain(values, context))))
    }
    fn says(&self, fitted: &[FittedParameter]) -> String {
        let neutral = fitted.get(1).filter(|neutral| neutral.value.abs() > SPOKEN_OF * neutral.sd);
        let right = neutral.map_or_else(String::new, |neutral| {
            let way = if neutral.value < 0.0 { "below" } else { "above" };
            format!(
                ", and is that of the simulation {} {way} the reference temperature",
                with_sd(neutral.value.abs(), neutral.sd, "K")
            )
        });
        format!("the gain moves by {}{right}", with_sd(100.0 * fitted[0].value, 100.0 * fitted[0].sd, "%/K"))
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use truegap_core::Inputs;

    /// Change of a reading by 1 % in 10 K.
    fn change(from_zero: bool, readout: Readout, reading: f64) -> f64 {
        let inputs = Inputs { run: vec![1], temperature_c: Some(vec![30.0]), ..Inputs::default() };
        let drive = Drive { inputs: &inputs, load: &[], temperature_c: &[30.0], reference_c: 20.0, full_load: 1.0 };
        let mut value = vec![reading];
        Gain { per_k: 1e-3, neutral_k: 0.0, of_thermometer: false, from_zero }.readout(&drive, &readout, &mut value);
        value[0] - reading
    }

    /// A distance of 900 m grows by 9 m, whatever the shortest is that was measured: counted from that, a coefficient was named beside the gain.
    #[test]
    fn a_gain_beside_a_simulation_is_told_from_a_reading_of_nothing() {
        let distances = Readout { zero: 60.0, span: 840.0 };
        approx::assert_relative_eq!(change(true, distances, 900.0), 9.0, max_relative = 1e-12);
        approx::assert_relative_eq!(change(false, distances, 900.0), 8.4, max_relative = 1e-12);
        // 1000 hPa are far from none: there a gain would be a coefficient
        approx::assert_relative_eq!(change(true, Readout { zero: 990.0, span: 40.0 }, 1000.0), 0.1, max_relative = 1e-9);
    }
}
