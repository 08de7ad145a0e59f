//! The warp differs on heating and cooling.

use crate::{
    context::Context,
    effect::{About, Effect, Family, FittedParameter},
    memory::{Play, play_set, walk},
};
use truegap_core::{Drive, EffectId, Geometry, Parameter, Stage, simulator::StageName};

/// A set of plays on temperature that holds the electrode back.
pub struct ThermalHysteresis;

/// Where the base model has no warp, the play moves the mean gap.
struct Stick {
    size: f64,
    width_k: f64,
    warps: bool,
}

impl Stick {
    fn new(values: &[f64], context: &Context<'_>) -> Self {
        Self { size: values[0], width_k: values[1], warps: context.simulator.warps() == Some(true) }
    }
}

impl Stage for Stick {
    fn geometry(&self, drive: &Drive<'_>, geometry: &mut Geometry<'_>) {
        let moved = if self.warps { &mut geometry.warp_kelvin } else { &mut geometry.gap };
        let temperature = |row: usize| drive.temperature_c[row];
        play_set(drive.inputs, self.width_k, temperature, |first| first, |row, slip| moved[row] += self.size * slip);
    }
}

/// Sibling: one play, whose slip fades into the limit smoothly.
struct Smooth(Stick);

impl Stage for Smooth {
    fn geometry(&self, drive: &Drive<'_>, geometry: &mut Geometry<'_>) {
        let moved = if self.0.warps { &mut geometry.warp_kelvin } else { &mut geometry.gap };
        let mut play = Play::new(1.6 * self.0.width_k, 0.0);
        walk(drive.inputs, |row, step| {
            if step.is_none() {
                play.state = drive.temperature_c[row];
            }
            let slip = play.slip(drive.temperature_c[row]) / play.width;
            moved[row] += self.0.size * (1.5 * slip - 0.5 * slip.powi(3));
        });
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
    fn about(&self) -> About {
        About {
            physics: "the electrode sticks to the beads or yields, so its warp is behind the temperature on heating and on cooling, however slow",
            equation: "warp dT = (T - T0) + s p, p = sum_k (play(T; w_k) - T) / sum_k w_k, three plays with half widths (0.4, 0.8, 1.8) w at rest when a run starts; without warp in the base model: gap + s p",
            excitation: "temperature that turns around, by more than twice the width",
            impostors: &["thermal_lag", "offset_drift", "permittivity_temperature"],
            separates: "the loop over temperature keeps its width at every rate and stays open in a hold",
            source: "Visintin, Differential Models of Hysteresis, ch. III; Armitage et al., Sensors 23:3778 (3.5 % of full scale between room temperature and 40 degC)",
        }
    }
    fn parameters(&self, context: &Context<'_>) -> Vec<Parameter> {
        let reach = (0.15 * context.temperature_span()).max(0.2);
        let size = if context.simulator.warps() == Some(true) {
            Parameter::normal("lag", "K", 0.0, 4.0, "temperature by which the warp is behind, on a long rise or fall")
                .within(0.0, 100.0)
        } else {
            Parameter::normal("gap", "unloaded gaps", 0.0, 2e-3, "half opening of the loop of the mean gap").within(-0.2, 0.2)
        };
        vec![
            size,
            Parameter::log_normal("width", "K", reach, 0.7, "turn of the temperature after which half of it has changed sign")
                .within(0.2, (2.0 * context.temperature_span()).max(1.0)),
        ]
    }
    fn starts(&self, context: &Context<'_>) -> Vec<Vec<f64>> {
        let span = context.temperature_span().max(1.0);
        vec![vec![0.05 * span], vec![0.15 * span], vec![0.4 * span]]
    }
    fn testable(&self, context: &Context<'_>) -> Result<(), String> {
        context.has(StageName::Geometry)?;
        context.needs_temperature(3.0)
    }
    fn with(&self, values: &[f64], context: &Context<'_>) -> Box<dyn Stage> {
        Box::new(Stick::new(values, context))
    }
    fn sibling(&self, values: &[f64], context: &Context<'_>) -> Option<Box<dyn Stage>> {
        Some(Box::new(Smooth(Stick::new(values, context))))
    }
    fn says(&self, fitted: &[FittedParameter]) -> String {
        let (size, width) = (&fitted[0], fitted[1].value);
        if size.parameter.unit == "K" {
            return format!(
                "heating and cooling differ however slow: the warp is {:.2} K behind (sd {:.2}), reversed within {:.1} K of a turn",
                size.value,
                size.sd,
                2.0 * width
            );
        }
        format!(
            "heating and cooling differ however slow: the gap by {:.4} % (sd {:.4}) either way, reversed within {:.1} K of a turn",
            100.0 * size.value,
            100.0 * size.sd,
            2.0 * width
        )
    }
}
