//! The insulator takes up water from the air.

use crate::{
    data::context::Context,
    effects::composed::words::{Driver, InWords, Kinetics, Place},
    effects::{
        effect::{About, Effect, Family, FittedParameter},
        memory::lag_through_runs,
        permittivity_temperature::has_insulator,
        scale,
    },
    text::{percent_with_sd, rounded},
};
use truegap_core::{Dielectric, Drive, EffectId, Parameter, Stage, simulator::StageName};

/// Permittivity in proportion to the water taken up, with an optional delay.
pub struct HumidityUptake;

/// Relative humidity at which permittivities are quoted, per cent (IEC 60068-1 standard atmosphere); a fixed one, so that a fitted
/// coefficient means the same in every recording.
const STANDARD_PCT: f64 = 50.0;

struct Uptake {
    per_pct: f64,
    tau_s: f64,
    insulator: bool,
}

impl Uptake {
    fn new(values: &[f64], context: &Context<'_>) -> Self {
        Self { per_pct: values[0], tau_s: values[1], insulator: has_insulator(context) }
    }

    /// Multiplies the permittivity by `1 + factor(humidity after the delay)`.
    fn apply(&self, drive: &Drive<'_>, factors: &mut Dielectric, factor: impl Fn(f64) -> f64) {
        let Some(humidity) = &drive.inputs.humidity_pct else { return };
        let mut inside = humidity.clone();
        lag_through_runs(drive.inputs, self.tau_s, &mut inside);
        let wet = if self.insulator { &mut factors.insulator } else { &mut factors.beads };
        wet.iter_mut().zip(&inside).for_each(|(wet, pct)| *wet *= 1.0 + factor(*pct));
    }
}

impl Stage for Uptake {
    fn dielectric(&self, drive: &Drive<'_>, factors: &mut Dielectric) {
        self.apply(drive, factors, |pct| self.per_pct * (pct - STANDARD_PCT));
    }
}

/// Sibling: a sorption isotherm that bends, with the same slope at the standard humidity.
struct Isotherm(Uptake);

impl Stage for Isotherm {
    fn dielectric(&self, drive: &Drive<'_>, factors: &mut Dielectric) {
        let bend = 4e-3;
        self.0.apply(drive, factors, |pct| {
            let above = pct - STANDARD_PCT;
            self.0.per_pct * above * (1.0 + bend * above)
        });
    }
}

impl Effect for HumidityUptake {
    fn id(&self) -> EffectId {
        EffectId("humidity_uptake")
    }
    fn stage(&self) -> StageName {
        StageName::Dielectric
    }
    fn family(&self) -> Family {
        Family::Environment
    }
    fn in_words(&self, _: &Context<'_>) -> Option<InWords> {
        Some(InWords { place: Place::Dielectric, driver: Driver::Recorded("humidity".into()), kinetics: Kinetics::FirstOrder })
    }
    fn about(&self) -> About {
        About {
            physics: "polyimide (or the foam) takes up water, whose permittivity is large",
            equation: "eps (1 + k (H - 50 %)), tau dH/dt + H = RH on the clock through all runs",
            excitation: "relative humidity that moves by several per cent",
            impostors: &["offset_drift", "permittivity_temperature", "ageing"],
            separates: "follows the hygrometer, at every load alike; without a humidity column it cannot be named",
            source: "Melcher, Daben & Arlt, IEEE Trans. Electr. Insul. 24 (1989) 31 (moisture in Kapton); DuPont Kapton HN data sheet",
        }
    }
    fn parameters(&self, context: &Context<'_>) -> Vec<Parameter> {
        let sd = scale::prior_sd(context, 2e-3, |size| self.with(&[size, 0.0], context));
        let delay = 0.05 * context.length_s();
        vec![
            Parameter::normal(
                "per_pct",
                "1/%RH",
                0.0,
                sd,
                "relative change of the permittivity per per cent of relative humidity",
            )
            .within(0.0, 0.02),
            Parameter::normal("tau", "s", 0.0, delay, "time the water takes to get in").within(0.0, 20.0 * delay),
        ]
    }
    fn starts(&self, context: &Context<'_>) -> Vec<Vec<f64>> {
        vec![vec![0.0], vec![0.03 * context.duration_s]]
    }
    fn testable(&self, context: &Context<'_>) -> Result<(), String> {
        context.has(StageName::Dielectric)?;
        match context.humidity_range {
            None => Err("no humidity column".into()),
            Some((low, high)) if high - low < 3.0 => Err(format!("the relative humidity changes by {:.1} % only", high - low)),
            Some(_) => Ok(()),
        }
    }
    fn with(&self, values: &[f64], context: &Context<'_>) -> Box<dyn Stage> {
        Box::new(Uptake::new(values, context))
    }
    fn sibling(&self, values: &[f64], context: &Context<'_>) -> Option<Box<dyn Stage>> {
        Some(Box::new(Isotherm(Uptake::new(values, context))))
    }
    fn says(&self, fitted: &[FittedParameter]) -> String {
        let (size, tau) = (&fitted[0], &fitted[1]);
        let delay =
            if tau.value > 2.0 * tau.sd { format!(", with a delay of {}", rounded(tau.value, "s")) } else { String::new() };
        format!(
            "the dielectric takes up water: its permittivity grows by {} per per cent of relative humidity{delay}",
            percent_with_sd(size.value, size.sd)
        )
    }
}
