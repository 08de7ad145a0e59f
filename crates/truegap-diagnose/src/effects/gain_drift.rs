//! The gain of the electronics moves with temperature.

use crate::{
    data::context::Context,
    effects::composed::words::{Driver, InWords, Kinetics, Place},
    effects::effect::{About, Effect, Family, FittedParameter, Separation},
    text::with_sd,
};
use truegap_core::{Drive, EffectId, Parameter, Readout, Stage, simulator::StageName};

/// Gain about the zero of the readout, in proportion to a temperature.
pub struct GainDrift;

struct Gain {
    per_k: f64,
    /// whether it follows the thermometer, as the electronics of a sensor do, or what is behind the thermal path
    of_thermometer: bool,
}

impl Gain {
    /// Applies `gain(kelvin above the reference)` to what stands above the zero.
    fn apply(&self, drive: &Drive<'_>, readout: &Readout, value: &mut [f64], gain: impl Fn(f64) -> f64) {
        let Some(recorded) = drive.inputs.temperature_c.as_deref() else { return };
        let temperature = if self.of_thermometer { recorded } else { drive.temperature_c };
        for (value, t) in value.iter_mut().zip(temperature) {
            *value += (*value - readout.zero) * gain(t - drive.reference_c);
        }
    }
}

impl Stage for Gain {
    fn readout(&self, drive: &Drive<'_>, readout: &Readout, value: &mut [f64]) {
        self.apply(drive, readout, value, |kelvin| self.per_k * kelvin);
    }
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
            equation: "value = zero + (true - zero) (1 + k (T - T0)), zero the reading without load at T0; T the thermometer beside plates, else the temperature behind the thermal path",
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
        vec![Parameter::normal("per_kelvin", "1/K", 0.0, sd, "relative change of the gain").within(-most, most)]
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
        Box::new(Gain { per_k: values[0], of_thermometer: is_of_a_sensor(context) })
    }
    fn sibling(&self, values: &[f64], context: &Context<'_>) -> Option<Box<dyn Stage>> {
        Some(Box::new(Divider(Gain { per_k: values[0], of_thermometer: is_of_a_sensor(context) })))
    }
    fn says(&self, fitted: &[FittedParameter]) -> String {
        format!("the gain moves by {}", with_sd(100.0 * fitted[0].value, 100.0 * fitted[0].sd, "%/K"))
    }
}
