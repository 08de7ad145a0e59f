//! The beads are softer below the greatest load so far.

use crate::{
    data::context::Context,
    effects::composed::words::{Driver, InWords, Kinetics, Place},
    effects::{
        effect::{About, Effect, Family, FittedParameter},
        memory::greatest_so_far,
    },
    text::percent_with_sd,
};
use statrs::function::erf::erf;
use truegap_core::{Drive, EffectId, Parameter, Stage, simulator::StageName};

/// Damage by the greatest load ever, with a share that heals on the way back up to it.
pub struct MullinsSoftening;

struct Softening {
    depth: f64,
    scale: f64,
    healing: f64,
}

impl Softening {
    fn new(values: &[f64]) -> Self {
        Self { depth: values[0], scale: values[1], healing: values[2] }
    }

    /// Multiplies the modulus by `1 - depth [(1 - healing) damage(greatest load) + healing below(load², greatest load²)]`.
    fn apply(&self, drive: &Drive<'_>, factor: &mut [f64], damage: impl Fn(f64) -> f64, below: impl Fn(f64, f64) -> f64) {
        let mut known = (0.0, 0.0);
        let greatest = greatest_so_far(drive.load, 0.0);
        for ((factor, &load), greatest) in factor.iter_mut().zip(drive.load).zip(greatest) {
            if greatest <= 0.0 {
                continue;
            }
            if greatest != known.0 {
                known = (greatest, damage(greatest));
            }
            let load = load.max(0.0);
            let healing = below(greatest * greatest - load * load, self.scale * self.scale + SLOPE * greatest * greatest);
            *factor *= 1.0 - self.depth * ((1.0 - self.healing) * known.1 + self.healing * healing);
        }
    }
}

impl Stage for Softening {
    fn modulus(&self, drive: &Drive<'_>, factor: &mut [f64]) {
        self.apply(drive, factor, |greatest| -(-greatest / self.scale).exp_m1(), |below, scale| erf(below / scale));
    }
}

/// Growth of the energy scale with the greatest energy; values between 0.1 and 0.5 are usual for filled rubbers.
const SLOPE: f64 = 0.3;

/// Sibling: rational functions of the greatest load and of what is left below it.
struct Rational(Softening);

impl Stage for Rational {
    fn modulus(&self, drive: &Drive<'_>, factor: &mut [f64]) {
        let damage = |greatest: f64| 1.4 * greatest / (greatest + self.0.scale);
        self.0.apply(drive, factor, damage, |below, scale| 1.4 * below / (below + scale));
    }
}

impl Effect for MullinsSoftening {
    fn id(&self) -> EffectId {
        EffectId("mullins_softening")
    }
    fn stage(&self) -> StageName {
        StageName::Beads
    }
    fn family(&self) -> Family {
        Family::MechanicalMemory
    }
    fn in_words(&self, _: &Context<'_>) -> Option<InWords> {
        Some(InWords { place: Place::Mechanics, driver: Driver::LoadHistory, kinetics: Kinetics::Accumulating })
    }
    fn about(&self) -> About {
        About {
            physics: "chains of the rubber let go as the load passes what it has borne before; below that load the beads are softer ever after",
            equation: "E = E0 [1 - d ((1 - q) (1 - exp(-M / l)) + q erf((M² - L²) / (l² + 0.3 M²)))], M the greatest load over all runs; q = 0 damage for good, q = 1 only below M",
            excitation: "a first loading, at best to growing peaks, and loads repeated below them",
            impostors: &["ageing", "strain_stiffening", "rate_independent_hysteresis", "viscoelastic_creep"],
            separates: "the first cycle to a new peak differs from all later ones, which agree with one another; no recovery over a rest",
            source: "Simo, Comput. Methods Appl. Mech. Eng. 60 (1987) 153 (damage by the greatest strain); Ogden & Roxburgh, Proc. R. Soc. A 455 (1999) 2861 (softer only below it)",
        }
    }
    fn parameters(&self, _: &Context<'_>) -> Vec<Parameter> {
        vec![
            Parameter::normal("depth", "1", 0.0, 0.1, "share of the modulus that a very large load takes away").within(0.0, 0.9),
            Parameter::log_normal("load", "full loads", 0.5, 0.7, "load that does two thirds of the damage").within(0.02, 20.0),
            Parameter::normal("healing", "1", 0.5, 0.5, "share of the softening that is there below the greatest load only")
                .within(0.0, 1.0),
        ]
    }
    fn starts(&self, _: &Context<'_>) -> Vec<Vec<f64>> {
        vec![vec![0.2, 0.05], vec![0.7, 0.05], vec![0.2, 0.95], vec![0.7, 0.95]]
    }
    fn testable(&self, context: &Context<'_>) -> Result<(), String> {
        context.has(StageName::Beads)?;
        context.needs_load()
    }
    fn with(&self, values: &[f64], _: &Context<'_>) -> Box<dyn Stage> {
        Box::new(Softening::new(values))
    }
    fn sibling(&self, values: &[f64], _: &Context<'_>) -> Option<Box<dyn Stage>> {
        Some(Box::new(Rational(Softening::new(values))))
    }
    fn says(&self, fitted: &[FittedParameter]) -> String {
        let (scale, healing) = (fitted[1].value, fitted[2].value);
        let unloaded = (1.0 - healing) * -(-1.0 / scale).exp_m1() + healing * erf(1.0 / (scale * scale + SLOPE));
        let full = fitted[0].value * unloaded;
        let share = if fitted[0].value > 0.0 { full / fitted[0].value } else { 0.0 };
        format!(
            "after its first loading the dielectric is softer for good: {} once the full load has been borne",
            percent_with_sd(full, fitted[0].sd * share)
        )
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use truegap_core::Inputs;

    fn factors(stage: &Softening, load: &[f64]) -> Vec<f64> {
        let inputs = Inputs { run: (0..load.len() as u32).collect(), ..Inputs::default() };
        let cold = vec![20.0; load.len()];
        let drive = Drive { inputs: &inputs, load, temperature_c: &cold, reference_c: 20.0, full_load: 1.0 };
        let mut factor = vec![1.0; load.len()];
        stage.modulus(&drive, &mut factor);
        factor
    }

    #[test]
    fn softening_stays_through_runs_and_may_heal_at_the_greatest_load() {
        let scale = 1.0 / std::f64::consts::LN_2;
        // a greatest load of 1 then does half the damage
        let for_good = factors(&Softening { depth: 0.2, scale, healing: 0.0 }, &[0.0, 1.0, 0.5]);
        for (f, exact) in for_good.iter().zip([1.0, 0.9, 0.9]) {
            approx::assert_abs_diff_eq!(*f, exact, epsilon = 1e-15);
        }
        // erf(0.75 / (0.2 + 0.3)) = erf(1.5) = 0.966105146475310727
        let below = factors(&Softening { depth: 0.2, scale: 0.2f64.sqrt(), healing: 1.0 }, &[0.0, 1.0, 0.5]);
        for (f, exact) in below.iter().zip([1.0, 1.0, 1.0 - 0.2 * 0.966_105_146_475_310_7]) {
            approx::assert_abs_diff_eq!(*f, exact, epsilon = 1e-12);
        }
    }
}
