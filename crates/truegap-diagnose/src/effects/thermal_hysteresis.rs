//! The warp differs on heating and cooling.

use crate::{
    data::context::Context,
    effects::composed::words::{Driver, InWords, Kinetics, Place},
    effects::{
        effect::{About, Effect, Family, FittedParameter},
        memory::{Play, play_set, walk},
    },
    text::{percent_with_sd, rounded, with_sd},
};
use truegap_core::{Drive, EffectId, Geometry, Parameter, Stage, simulator::StageName};

/// A play on temperature that holds the electrode back, evenly or the more the further it is from its flat state.
pub struct ThermalHysteresis;

/// Temperature above the reference at which the size is quoted, K.
const QUOTED_AT: f64 = 30.0;

/// Where the base model has no warp, the play moves the mean gap.
struct Stick {
    size: f64,
    width_k: f64,
    growth: f64,
    warps: bool,
}

impl Stick {
    fn new(values: &[f64], context: &Context<'_>) -> Self {
        let warps = context.simulator.warps() == Some(true);
        Self { size: values[0], width_k: values[1], growth: values[2], warps }
    }

    /// What a slip of 1 moves where the temperature is `above` the reference.
    fn reach(&self, above: f64) -> f64 {
        self.size * (1.0 + self.growth * (above / QUOTED_AT - 1.0))
    }

    /// Column that moves.
    fn moved<'a>(&self, geometry: &'a mut Geometry<'_>) -> &'a mut Vec<f64> {
        if self.warps { &mut geometry.warp_kelvin } else { &mut geometry.gap }
    }
}

impl Stage for Stick {
    fn geometry(&self, drive: &Drive<'_>, geometry: &mut Geometry<'_>) {
        let moved = self.moved(geometry);
        let mut play = Play::new(self.width_k, 0.0);
        walk(drive.inputs, |row, step| {
            let t = drive.temperature_c[row];
            if step.is_none() {
                play.state = t;
            }
            moved[row] += self.reach(t - drive.reference_c) * play.slip(t) / self.width_k;
        });
    }
}

/// Sibling: a set of plays, which rounds the corners of the loop.
struct Rounded(Stick);

impl Stage for Rounded {
    fn geometry(&self, drive: &Drive<'_>, geometry: &mut Geometry<'_>) {
        let moved = self.0.moved(geometry);
        let t = |row: usize| drive.temperature_c[row];
        let add = |row: usize, slip: f64| moved[row] += self.0.reach(t(row) - drive.reference_c) * slip;
        play_set(drive.inputs, self.0.width_k, t, |first| first, add);
    }
}

impl Effect for ThermalHysteresis {
    fn id(&self) -> EffectId {
        EffectId("thermal_hysteresis")
    }
    fn stage(&self) -> StageName {
        StageName::Geometry
    }
    fn family(&self) -> Family {
        Family::Thermal
    }
    fn in_words(&self, _: &Context<'_>) -> Option<InWords> {
        Some(InWords { place: Place::Geometry, driver: Driver::Temperature, kinetics: Kinetics::RateIndependent })
    }
    fn about(&self) -> About {
        About {
            physics: "the electrode sticks to the beads or yields, so its warp is behind the temperature on heating and on cooling, however slow",
            equation: "warp dT = (T - T0) + s [1 - g + g (T - T0) / 30 K] p, p = (play(T; w) - T) / w, at rest when a run starts; without warp in the base model the gap moves so",
            excitation: "temperature that turns around, by more than twice the width",
            impostors: &["thermal_lag", "offset_drift", "permittivity_temperature"],
            separates: "the loop over temperature keeps its width at every rate and stays open in a hold",
            source: "Visintin, Differential Models of Hysteresis, ch. III; Armitage et al., Sensors 23:3778 (3.5 % of full scale between room temperature and 40 degC)",
        }
    }
    fn parameters(&self, context: &Context<'_>) -> Vec<Parameter> {
        let reach = (0.15 * context.temperature_span()).max(0.2);
        let size = if context.simulator.warps() == Some(true) {
            Parameter::normal(
                "lag",
                "K",
                0.0,
                4.0,
                "temperature by which the warp is behind on a long rise or fall, 30 K above the reference",
            )
            .within(0.0, 100.0)
        } else {
            Parameter::normal(
                "gap",
                "unloaded gaps",
                0.0,
                2e-3,
                "half opening of the loop of the mean gap, 30 K above the reference",
            )
            .within(-0.2, 0.2)
        };
        vec![
            size,
            Parameter::log_normal("width", "K", reach, 0.7, "turn of the temperature after which half of it has changed sign")
                .within(0.2, (2.0 * context.temperature_span()).max(1.0)),
            Parameter::normal("growth", "1", 0.5, 0.5, "0: the same at every temperature, 1: in proportion to the warp")
                .within(0.0, 1.0),
        ]
    }
    fn starts(&self, context: &Context<'_>) -> Vec<Vec<f64>> {
        let span = context.temperature_span().max(1.0);
        [0.05, 0.15, 0.4].iter().flat_map(|w| [vec![w * span, 0.1], vec![w * span, 0.9]]).collect()
    }
    fn testable(&self, context: &Context<'_>) -> Result<(), String> {
        context.has(StageName::Geometry)?;
        context.needs_temperature(3.0)
    }
    fn with(&self, values: &[f64], context: &Context<'_>) -> Box<dyn Stage> {
        Box::new(Stick::new(values, context))
    }
    fn sibling(&self, values: &[f64], context: &Context<'_>) -> Option<Box<dyn Stage>> {
        Some(Box::new(Rounded(Stick::new(values, context))))
    }
    fn says(&self, fitted: &[FittedParameter]) -> String {
        let (size, width) = (&fitted[0], fitted[1].value);
        if size.parameter.unit == "K" {
            return format!(
                "heating and cooling differ however slow: the warp is {} behind, reversed within {} of a turn",
                with_sd(size.value, size.sd, "K"),
                rounded(2.0 * width, "K")
            );
        }
        format!(
            "heating and cooling differ however slow: the gap by {} either way, reversed within {} of a turn",
            percent_with_sd(size.value, size.sd),
            rounded(2.0 * width, "K")
        )
    }
}
