//! Permittivities change with temperature.

use crate::{
    data::context::Context,
    effects::composed::words::{Driver, InWords, Kinetics, Place},
    effects::{
        effect::{About, Effect, Family, FittedParameter},
        scale,
    },
    text::{rounded, with_sd},
};
use truegap_core::{Dielectric, Drive, EffectId, Parameter, Stage, simulator::StageName};

/// Temperature coefficients of beads and insulator.
pub struct PermittivityTemperature;

/// Weight of the beads in the mix. The shields of a stack lie on the thin insulator, so that a coefficient there moves the reading
/// some thirty times as much as the same coefficient of the beads; with this weight both ends of the mix are of one size.
const BEADS_WEIGHT: f64 = 30.0;

struct Coefficients {
    beads_per_k: f64,
    insulator_per_k: f64,
}

impl Coefficients {
    /// From size and mix; a model without an insulator has the beads only.
    fn new(values: &[f64]) -> Self {
        match *values {
            [size, mix, ..] => Self { beads_per_k: BEADS_WEIGHT * size * mix, insulator_per_k: size * (1.0 - mix) },
            [size] => Self { beads_per_k: size, insulator_per_k: 0.0 },
            [] => Self { beads_per_k: 0.0, insulator_per_k: 0.0 },
        }
    }
}

impl Stage for Coefficients {
    fn dielectric(&self, drive: &Drive<'_>, factors: &mut Dielectric) {
        for (row, t) in drive.temperature_c.iter().enumerate() {
            let above = t - drive.reference_c;
            factors.beads[row] *= 1.0 + self.beads_per_k * above;
            factors.insulator[row] *= 1.0 + self.insulator_per_k * above;
        }
    }
}

/// Sibling: Clausius and Mossotti, a polarisability per volume that changes in proportion to temperature.
struct ClausiusMossotti(Coefficients);

/// Permittivity of silicone and polyimide at which the sibling's slope meets the coefficient.
const PERMITTIVITY: f64 = 3.4;

/// Factor on the permittivity where its coefficient at the reference is `per_k`.
fn clausius_mossotti(per_k: f64, above: f64) -> f64 {
    let filling = (PERMITTIVITY - 1.0) / (PERMITTIVITY + 2.0);
    let slope = per_k * PERMITTIVITY * 3.0 / ((PERMITTIVITY + 2.0) * (PERMITTIVITY - 1.0));
    let x = filling * (1.0 + slope * above);
    (1.0 + 2.0 * x) / (1.0 - x) / PERMITTIVITY
}

impl Stage for ClausiusMossotti {
    fn dielectric(&self, drive: &Drive<'_>, factors: &mut Dielectric) {
        for (row, t) in drive.temperature_c.iter().enumerate() {
            let above = t - drive.reference_c;
            factors.beads[row] *= clausius_mossotti(self.0.beads_per_k, above);
            factors.insulator[row] *= clausius_mossotti(self.0.insulator_per_k, above);
        }
    }
}

/// Whether the base model has an insulator; the plates have one dielectric only.
pub(crate) fn has_insulator(context: &Context<'_>) -> bool {
    context.simulator.has_insulator()
}

impl Effect for PermittivityTemperature {
    fn id(&self) -> EffectId {
        EffectId("permittivity_temperature")
    }
    fn stage(&self) -> StageName {
        StageName::Dielectric
    }
    fn family(&self) -> Family {
        Family::Thermal
    }
    fn in_words(&self, _: &Context<'_>) -> Option<InWords> {
        Some(InWords { place: Place::Dielectric, driver: Driver::Temperature, kinetics: Kinetics::Static })
    }
    fn about(&self) -> About {
        About {
            physics: "the permittivity of the silicone beads or of the polyimide changes with temperature",
            equation: "eps_beads (1 + 30 s m (T - T0)), eps_insulator (1 + s (1 - m) (T - T0)); with one dielectric: eps (1 + s (T - T0))",
            excitation: "temperature that moves by several kelvin, at two loads to tell beads from insulator",
            impostors: &["gain_drift", "electrode_warp", "thermal_lag", "humidity_uptake"],
            separates: "follows the sensor's temperature without a loop; insulator: the same at every load; beads: grows as the gap closes. A gain that moves with temperature differs only by a reference capacitor",
            source: "Kittel, Introduction to Solid State Physics, ch. 16 (Clausius-Mossotti); DuPont Kapton HN data sheet (permittivity over temperature)",
        }
    }
    fn parameters(&self, context: &Context<'_>) -> Vec<Parameter> {
        if !has_insulator(context) {
            let sd = scale::prior_sd(context, 1e-3, |size| self.with(&[size], context));
            return vec![
                Parameter::normal("coefficient", "1/K", 0.0, sd, "temperature coefficient of the permittivity")
                    .within(-0.02, 0.02),
            ];
        }
        let sd = scale::prior_sd(context, 2e-4, |size| self.with(&[size, 0.0], context));
        vec![
            Parameter::normal(
                "coefficient",
                "1/K",
                0.0,
                sd,
                "coefficient of the insulator, plus a thirtieth of that of the beads",
            )
            .within(-1e-3, 1e-3),
            Parameter::normal("mix", "1", 0.5, 0.5, "0: insulator alone, 1: beads alone").within(-0.5, 1.5),
        ]
    }
    fn starts(&self, context: &Context<'_>) -> Vec<Vec<f64>> {
        if has_insulator(context) { vec![vec![0.0], vec![1.0]] } else { vec![Vec::new()] }
    }
    fn testable(&self, context: &Context<'_>) -> Result<(), String> {
        context.has(StageName::Dielectric)?;
        context.needs_temperature(2.0)
    }
    fn with(&self, values: &[f64], _: &Context<'_>) -> Box<dyn Stage> {
        Box::new(Coefficients::new(values))
    }
    fn sibling(&self, values: &[f64], _: &Context<'_>) -> Option<Box<dyn Stage>> {
        Some(Box::new(ClausiusMossotti(Coefficients::new(values))))
    }
    fn says(&self, fitted: &[FittedParameter]) -> String {
        let values: Vec<f64> = fitted.iter().map(|f| f.value).collect();
        let ppm = Coefficients::new(&values);
        if values.len() == 1 {
            return format!("the permittivity changes by {}", with_sd(ppm.beads_per_k, fitted[0].sd, "1/K"));
        }
        format!(
            "permittivities change with temperature: insulator {}, beads {} (sd of their sum as seen by the insulator {})",
            rounded(ppm.insulator_per_k, "1/K"),
            rounded(ppm.beads_per_k, "1/K"),
            rounded(fitted[0].sd, "1/K")
        )
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn the_sibling_has_the_slope_of_the_coefficient_at_the_reference() {
        let (per_k, step) = (3e-4, 1e-3);
        let slope = (clausius_mossotti(per_k, step) - clausius_mossotti(per_k, -step)) / (2.0 * step);
        // central difference of step 1 mK: rounding 1e-13
        approx::assert_relative_eq!(slope, per_k, max_relative = 1e-8);
    }
}
