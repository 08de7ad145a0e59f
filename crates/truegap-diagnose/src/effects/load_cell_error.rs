//! The reference of the load errs.

use crate::{
    data::context::Context,
    effects::composed::words::{Driver, InWords, Kinetics, Place},
    effects::{
        effect::{About, Effect, Family, FittedParameter, Separation},
        memory::play_set,
    },
    text::percent_with_sd,
};
use truegap_core::{EffectId, Inputs, Parameter, Stage, simulator::StageName};

/// Errors of zero, gain, linearity and hysteresis of the load cell.
///
/// Calibration takes up most of a zero and of a gain, but not their temperature: silicone that is loaded where the cell reads nothing gets softer with heat.
pub struct LoadCellError;

/// Half width of the cell's hysteresis, full loads.
const WIDTH: f64 = 0.1;

struct Cell {
    size: f64,
    /// never more than half of the error of linearity: a cell of nothing but hysteresis is not known, beads of it are
    hysteresis: f64,
    zero: f64,
    gain: f64,
}

impl Cell {
    /// Adds the errors of zero and gain, of linearity `bow(load)`, 1 at half load, and of hysteresis.
    fn apply(&self, inputs: &Inputs, load: &mut [f64], bow: impl Fn(f64) -> f64) {
        let given = load.to_vec();
        play_set(
            inputs,
            WIDTH,
            |row| given[row],
            |_| 0.0,
            |row, slip| {
                let straight = self.zero + self.gain * given[row];
                load[row] += self.size * (bow(given[row]) + straight + self.hysteresis * slip);
            },
        );
    }
}

impl Stage for Cell {
    fn load(&self, inputs: &Inputs, load: &mut [f64]) {
        self.apply(inputs, load, |load| 4.0 * load * (1.0 - load));
    }
}

/// Sibling: a bow that follows a sine.
struct Sine(Cell);

impl Stage for Sine {
    fn load(&self, inputs: &Inputs, load: &mut [f64]) {
        self.0.apply(inputs, load, |load| (std::f64::consts::PI * load).sin());
    }
}

fn cell(values: &[f64]) -> Cell {
    Cell { size: values[0], hysteresis: values[1], zero: values[2], gain: values[3] }
}

impl Effect for LoadCellError {
    fn id(&self) -> EffectId {
        EffectId("load_cell_error")
    }
    fn stage(&self) -> StageName {
        StageName::Inputs
    }
    fn family(&self) -> Family {
        Family::StaticMechanics
    }
    fn in_words(&self, _: &Context<'_>) -> Option<InWords> {
        Some(InWords { place: Place::Inputs, driver: Driver::Load, kinetics: Kinetics::Static })
    }
    fn about(&self) -> About {
        About {
            physics: "the load cell that the sensor is compared with errs itself: in zero, gain, linearity, hysteresis",
            equation: "L_true = L + q [4 L (1 - L) + z + g L + h s], s the slip of three plays as in `rate_independent_hysteresis`, w = 0.1",
            excitation: "load over the whole range, up and down",
            impostors: &["strain_stiffening", "contact_toe_in", "rate_independent_hysteresis", "eccentric_load"],
            separates: "the same error at the same load, whatever the temperature and whichever sensor; another reference changes it",
            source: "VDI/VDE/DKD 2638 (load cells: linearity and hysteresis); class 0.1 to 0.5 of full scale",
        }
    }
    fn of_reference(&self) -> bool {
        true
    }
    fn touches(&self) -> Vec<StageName> {
        vec![StageName::LoadPath] // a wrong reference is a wrong load
    }
    fn separations(&self) -> &'static [Separation] {
        &[Separation { rival: "rate_independent_hysteresis", says: "exchange the load cell, or load with weights" }]
    }
    fn parameters(&self, _: &Context<'_>) -> Vec<Parameter> {
        vec![
            Parameter::normal("bow", "full loads", 0.0, 0.01, "error of linearity at half load").within(-0.1, 0.1),
            Parameter::normal("hysteresis", "bows", 0.0, 0.3, "hysteresis of the cell over its error of linearity")
                .within(-0.5, 0.5),
            Parameter::normal("zero", "bows", 0.0, 1.0, "error of its zero over that of linearity").within(-5.0, 5.0),
            Parameter::normal("gain", "bows", 0.0, 1.0, "error of its gain over that of linearity").within(-5.0, 5.0),
        ]
    }
    fn starts(&self, _: &Context<'_>) -> Vec<Vec<f64>> {
        vec![vec![0.0; 3]]
    }
    fn testable(&self, context: &Context<'_>) -> Result<(), String> {
        context.has(StageName::Inputs)?;
        context.has(StageName::LoadPath)?;
        context.needs_load()
    }
    fn with(&self, values: &[f64], _: &Context<'_>) -> Box<dyn Stage> {
        Box::new(cell(values))
    }
    fn sibling(&self, values: &[f64], _: &Context<'_>) -> Option<Box<dyn Stage>> {
        Some(Box::new(Sine(cell(values))))
    }
    fn says(&self, fitted: &[FittedParameter]) -> String {
        format!("the load cell errs by {} of full load at half load", percent_with_sd(fitted[0].value, fitted[0].sd))
    }
}
