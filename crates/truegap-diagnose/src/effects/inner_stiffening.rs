//! A spring inside somebody else's simulator stiffens.

use crate::{
    data::context::Context,
    effects::composed::words::{Driver, InWords, Kinetics, Place},
    effects::effect::{About, Effect, Family, FittedParameter},
    effects::scale::unloaded,
    text::with_sd,
};
use truegap_core::{Drive, EffectId, Parameter, Stage, simulator::StageName};

/// A restoring force that grows faster than the response, where the simulation has it in proportion: it takes part of the load that moves the instrument.
pub struct InnerStiffening;

struct Spring {
    cubic: f64,
    /// response at which there is none of it
    rest: f64,
    /// share of a row by which the force is behind the response: a simulator takes one step a row, and forces act during the step
    late: f64,
}

impl Spring {
    fn take(&self, drive: &Drive<'_>, response: &[f64], load: &mut [f64], force: impl Fn(f64) -> f64) {
        let taken = |y: f64| self.cubic * force(y - self.rest) / drive.full_load;
        for run in drive.inputs.runs() {
            let mut before = response[run.start];
            for (load, y) in load[run.clone()].iter_mut().zip(&response[run]) {
                *load -= taken(y + self.late * (before - y));
                before = *y;
            }
        }
    }
}

impl Stage for Spring {
    fn feeds_back(&self) -> bool {
        self.cubic != 0.0
    }
    fn feedback(&self, drive: &Drive<'_>, response: &[f64], load: &mut [f64]) {
        self.take(drive, response, load, |y| y * y * y);
    }
}

/// Sibling: a spring whose stiffening levels off, by a third at the far end of the recorded range.
struct Levelling(Spring, f64);

impl Stage for Levelling {
    fn feeds_back(&self) -> bool {
        self.0.feeds_back()
    }
    fn feedback(&self, drive: &Drive<'_>, response: &[f64], load: &mut [f64]) {
        self.0.take(drive, response, load, |y| y * y * y / (1.0 + 0.5 * (y / self.1).powi(2)));
    }
}

/// Range of the recorded response; 1 where it does not move.
fn range(context: &Context<'_>) -> f64 {
    let range = context.response_span.abs();
    if range > 0.0 { range } else { 1.0 }
}

fn spring(values: &[f64]) -> Spring {
    Spring { cubic: values[0], rest: values[1], late: values[2] }
}

impl Effect for InnerStiffening {
    fn id(&self) -> EffectId {
        EffectId("inner_stiffening")
    }
    fn stage(&self) -> StageName {
        StageName::LoadPath
    }
    fn family(&self) -> Family {
        Family::StaticMechanics
    }
    fn in_words(&self, _: &Context<'_>) -> Option<InWords> {
        Some(InWords { place: Place::Mechanics, driver: Driver::Reading, kinetics: Kinetics::Static })
    }
    fn about(&self) -> About {
        About {
            physics: "a spring, a membrane or a stop inside the instrument stiffens (or softens), and the simulation holds it as linear",
            equation: "load that moves it = load - k3 (y - y0)^3, y the simulated response up to one row before; the simulator is asked again until load and response are at one",
            excitation: "responses of several sizes; for an instrument that swings, more than one amplitude",
            impostors: &["load_cell_error", "contact_toe_in", "saturation"],
            separates: "acts before the inertia and damping of the instrument: a law of the load or of the reading alone gives wrong phases near a resonance",
            source: "Duffing, Erzwungene Schwingungen, Vieweg 1918; the fixed point: Lelarasmee et al., IEEE Trans. CAD 1 (1982) 131",
        }
    }
    fn parameters(&self, context: &Context<'_>) -> Vec<Parameter> {
        let range = range(context);
        let load = context.load_span() * context.simulator.full_load().unwrap_or(1.0);
        let inputs = context.inputs;
        let load_unit = if inputs.pressure_pa.is_some() && inputs.force_n.is_none() { "Pa" } else { "N" };
        let unit = format!("{load_unit}/{}³", context.simulator.unit());
        vec![
            Parameter::normal("cubic", &unit, 0.0, 0.5 * load / range.powi(3), "cubic part of the restoring force"),
            Parameter::normal(
                "rest",
                context.simulator.unit(),
                unloaded(context),
                0.2 * range,
                "response at which there is none of it",
            ),
            Parameter::normal(
                "late",
                "rows",
                0.5,
                0.3,
                "by which the force is behind the response, as the simulator's steps have it",
            )
            .within(0.0, 1.0),
        ]
    }
    fn starts(&self, context: &Context<'_>) -> Vec<Vec<f64>> {
        vec![vec![unloaded(context), 0.5]]
    }
    fn testable(&self, context: &Context<'_>) -> Result<(), String> {
        if !context.simulator.feeds_back() {
            return Err(
                "acts inside a simulator: a function, or a program with inside = true under [base], that a load drives".into()
            );
        }
        context.needs_load()
    }
    fn with(&self, values: &[f64], _: &Context<'_>) -> Box<dyn Stage> {
        Box::new(spring(values))
    }
    fn sibling(&self, values: &[f64], context: &Context<'_>) -> Option<Box<dyn Stage>> {
        Some(Box::new(Levelling(spring(values), range(context))))
    }
    fn says(&self, fitted: &[FittedParameter]) -> String {
        let FittedParameter { parameter, value, sd, .. } = &fitted[0];
        let way = if *value > 0.0 { "stiffens" } else { "softens" };
        format!("a spring inside the instrument {way}: its force has a cubic part of {}", with_sd(*value, *sd, &parameter.unit))
    }
}
