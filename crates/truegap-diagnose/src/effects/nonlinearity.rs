//! The law from what moves the reading to the reading is bent, where the base model has a straight one.

use crate::{
    data::context::Context,
    effects::composed::words::{Driver, InWords, Kinetics, Place},
    effects::effect::{About, Effect, Family, FittedParameter},
    text::{percent_of, percent_with_sd},
};
use truegap_core::{Drive, EffectId, Parameter, Readout, Stage, simulator::StageName};

/// A smooth bend of the characteristic between the ends of the span, where it is none.
pub struct Nonlinearity;

/// Bend over the span, and the weights of Legendre's first polynomials that lean and crowd it.
struct Bend {
    size: f64,
    weights: [f64; 3],
}

impl Bend {
    fn of(values: &[f64]) -> Self {
        Self { size: values[0], weights: [values[1], values[2], values[3]] }
    }

    /// Departure from the straight line between the ends, over the span, `x` of the span above the zero; straight on beyond the ends.
    fn at(&self, x: f64) -> f64 {
        let inside = x.clamp(0.0, 1.0);
        let law = |x: f64| 4.0 * x * (1.0 - x) * self.crowded(2.0 * x - 1.0);
        // the slope at the ends, where 4 x (1 - x) has 4 and -4
        let slope = if x > 1.0 { -4.0 * self.crowded(1.0) } else { 4.0 * self.crowded(-1.0) };
        self.size * (law(inside) + slope * (x - inside))
    }

    fn crowded(&self, u: f64) -> f64 {
        let [lean, crowd, more] = self.weights;
        1.0 + lean * u + crowd * 0.5 * (3.0 * u * u - 1.0) + more * 0.5 * u * (5.0 * u * u - 3.0)
    }

    /// Greatest departure between the ends, and where it is: shares of the span.
    fn most(&self) -> (f64, f64) {
        const LOOKED_AT: usize = 200;
        let all = (0..=LOOKED_AT).map(|k| k as f64 / LOOKED_AT as f64).map(|x| (self.at(x), x));
        all.max_by(|a, b| a.0.abs().total_cmp(&b.0.abs())).unwrap_or_default()
    }
}

impl Stage for Bend {
    fn readout(&self, _: &Drive<'_>, readout: &Readout, value: &mut [f64]) {
        bent(readout, value, self.size, |x| self.at(x));
    }
}

fn bent(readout: &Readout, value: &mut [f64], size: f64, law: impl Fn(f64) -> f64) {
    if readout.span == 0.0 || size == 0.0 {
        return;
    }
    for value in value {
        *value += readout.span * law((*value - readout.zero) / readout.span);
    }
}

/// Sibling: a sine between the ends instead of a parabola.
struct Arch(Bend);

impl Stage for Arch {
    fn readout(&self, _: &Drive<'_>, readout: &Readout, value: &mut [f64]) {
        let law = |x: f64| {
            let inside = x.clamp(0.0, 1.0);
            self.0.size * (std::f64::consts::PI * inside).sin() * self.0.crowded(2.0 * inside - 1.0)
        };
        bent(readout, value, self.0.size, law);
    }
}

impl Effect for Nonlinearity {
    fn id(&self) -> EffectId {
        EffectId("nonlinearity")
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
            physics: "the characteristic is bent where the base model has a straight one: linearity error of a sensor, an amplifier, a law of nature",
            equation: "value = true + b S 4 x (1 - x) [1 + c1 P1(u) + c2 P2(u) + c3 P3(u)], x the reading above its zero over the span S, u = 2 x - 1, P Legendre's polynomials; straight on beyond the ends",
            excitation: "readings all over the span",
            impostors: &["saturation", "temperature_coefficient", "driver_coefficient", "offset_drift"],
            separates: "one curve, up and down, slow and fast, today and tomorrow",
            source: "terminal-based nonlinearity, IEC 61298-2; Pallas-Areny & Webster, Sensors and Signal Conditioning, sec. 1.3",
        }
    }
    fn parameters(&self, _: &Context<'_>) -> Vec<Parameter> {
        let weight =
            |name: &str, sd: f64, meaning: &str| Parameter::normal(name, "1", 0.0, sd, meaning).within(-8.0 * sd, 8.0 * sd);
        vec![
            Parameter::normal(
                "bend",
                "spans",
                0.0,
                0.1,
                "departure midway from the straight line between the ends, over the span",
            ),
            weight("lean", 1.0, "how far the bend leans to the upper end"),
            weight("crowd", 0.7, "how far it crowds to both ends"),
            weight("more", 0.5, "how far it turns"),
        ]
    }
    fn starts(&self, _: &Context<'_>) -> Vec<Vec<f64>> {
        vec![vec![0.0, 0.0, 0.0], vec![2.0, 0.5, 0.0], vec![-2.0, 0.5, 0.0]]
    }
    fn testable(&self, context: &Context<'_>) -> Result<(), String> {
        context.has(StageName::Readout)?;
        if context.has(StageName::Dielectric).is_ok() {
            return Err("the base model has places for a bent law of its own (stiffening, gap, saturation)".into());
        }
        if !context.simulator.moves() {
            return Err("a value that does not move is not bent".into());
        }
        context.needs_movement()
    }
    fn with(&self, values: &[f64], _: &Context<'_>) -> Box<dyn Stage> {
        Box::new(Bend::of(values))
    }
    fn sibling(&self, values: &[f64], _: &Context<'_>) -> Option<Box<dyn Stage>> {
        Some(Box::new(Arch(Bend::of(values))))
    }
    fn says(&self, fitted: &[FittedParameter]) -> String {
        let values: Vec<f64> = fitted.iter().map(|p| p.value).collect();
        let (most, at) = Bend::of(&values).most();
        // the greatest departure is in proportion to the size
        let sd = if fitted[0].value == 0.0 { fitted[0].sd } else { fitted[0].sd * (most / fitted[0].value).abs() };
        let side = if most < 0.0 { "below" } else { "above" };
        format!(
            "the characteristic is bent: at {} of its span it lies {} of the span {side} the straight line between its ends",
            percent_of(at),
            percent_with_sd(most.abs(), sd)
        )
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn the_ends_stay_and_the_middle_departs_by_the_size() {
        let bend = Bend::of(&[0.1, 0.0, 0.0, 0.0]);
        assert_eq!((bend.at(0.0), bend.at(1.0)), (0.0, 0.0));
        approx::assert_relative_eq!(bend.at(0.5), 0.1);
        // a parabola is its own closed form: 4 b x (1 - x)
        approx::assert_relative_eq!(bend.at(0.2), 0.4 * 0.2 * 0.8);
        approx::assert_relative_eq!(bend.most().0, 0.1);
    }

    #[test]
    fn it_goes_straight_on_beyond_the_ends_without_a_kink() {
        let bend = Bend::of(&[0.1, 1.5, -0.4, 0.3]);
        for end in [0.0, 1.0] {
            let step = 1e-6;
            let (inside, outside) = if end == 0.0 { (step, -step) } else { (1.0 - step, 1.0 + step) };
            // second order in the step on one side, exact on the other
            approx::assert_abs_diff_eq!(bend.at(inside) + bend.at(outside), 2.0 * bend.at(end), epsilon = 1e-10);
        }
        approx::assert_relative_eq!(bend.at(1.4), 4.0 * bend.at(1.1), max_relative = 1e-12);
    }

    /// Legendre's polynomials are 1 at 1 and (-1)^k at -1, and orthogonal on -1 to 1: two facts that share no code with the sums above.
    #[test]
    fn the_weights_are_those_of_legendres_polynomials() {
        let alone = |k: usize| {
            let mut values = [1.0, 0.0, 0.0, 0.0];
            values[k] = 1.0;
            let with = Bend::of(&values);
            let without = Bend::of(&[1.0, 0.0, 0.0, 0.0]);
            move |u: f64| with.crowded(u) - without.crowded(u)
        };
        for k in 1..=3 {
            approx::assert_relative_eq!(alone(k)(1.0), 1.0);
            approx::assert_relative_eq!(alone(k)(-1.0), if k % 2 == 0 { 1.0 } else { -1.0 });
            for other in (1..=3).filter(|other| *other != k) {
                let steps = 4000;
                let at = |i: usize| 2.0 * (i as f64 + 0.5) / f64::from(steps) - 1.0;
                let product: f64 =
                    (0..steps as usize).map(|i| alone(k)(at(i)) * alone(other)(at(i))).sum::<f64>() / f64::from(steps);
                // midpoint rule: an error of second order in 1/2000
                approx::assert_abs_diff_eq!(product, 0.0, epsilon = 1e-6);
            }
        }
    }
}
