//! A mechanism as an effect: it is fitted, held out, told and simulated like those of the library.
//!
//! Limits: a moment in time is not fitted, it is taken from the screen.

use crate::{
    data::context::Context,
    effects::composed::{
        acting::Acting,
        describe::describe,
        mechanism::{Mechanism, Numbers, Sentence},
        signal::{available, column},
        units::{driver_unit, size_unit},
        words::{Driver, Form, InWords, Kinetics, Quantity},
    },
    effects::effect::{About, Effect, Family, FittedParameter, ZeroCourse},
};
use truegap_core::{EffectId, Parameter, Stage, simulator::StageName};

/// A mechanism with a name and with what is known of its numbers.
#[derive(Clone, Debug, PartialEq)]
pub struct Composed {
    /// name as in answers
    pub id: EffectId,
    /// words
    pub sentence: Sentence,
    /// numbers where the fit starts
    pub start: Numbers,
    /// the size, and the numbers that are free
    pub parameters: Vec<Parameter>,
    /// what a reader is told of it in place of the words' own sentence; absent where the words speak
    pub says: Option<String>,
}

/// Share of the span of the response by which one prior standard deviation of the size moves it, as for effects of the library.
const SHARE: f64 = 0.2;
/// Natural logarithm by which a time constant, a width or a scale may be off from the grid that found it.
const LOG_SD: f64 = 0.8;

impl Composed {
    /// A mechanism found by the screen: priors about the numbers of the grid; a size of 1 moves the reading by `swing`, root mean square.
    pub fn found(id: EffectId, sentence: Sentence, start: Numbers, swing: f64, context: &Context<'_>) -> Self {
        let sd = SHARE * context.response_span.abs() / swing.max(f64::MIN_POSITIVE);
        let unit = size_unit(&sentence, context);
        let mut parameters =
            vec![Parameter::normal("size", &unit, 0.0, sd, "change of the quantity per unit of what the mechanism follows")];
        parameters.extend(inner(&sentence, start, &driver_unit(&sentence.driver, context)));
        Self { id, sentence, start, parameters, says: None }
    }
}

impl Mechanism {
    /// The stage with these values of its parameters, by name; `size` is one of them. Temperatures count from `reference_c`, degrees Celsius.
    pub fn stage<'v>(&self, values: impl Iterator<Item = (&'v str, f64)>, reference_c: f64) -> Box<dyn Stage> {
        let (numbers, size) = self.numbers.with(values);
        stage(&self.sentence, numbers, size, reference_c)
    }
}

/// The stage of a sentence.
pub fn stage(sentence: &Sentence, numbers: Numbers, size: f64, reference_c: f64) -> Box<dyn Stage> {
    let words = sentence.clone();
    Box::new(Acting {
        quantity: sentence.quantity,
        action: sentence.action,
        size,
        reference_c,
        column: Box::new(move |courses| column(&words, &numbers, courses)),
    })
}

/// The numbers that these words leave free.
fn inner(sentence: &Sentence, start: Numbers, unit: &str) -> Vec<Parameter> {
    let mut free = Vec::new();
    let positive = |name: &str, unit: &str, at: f64, meaning: &str| {
        Parameter::log_normal(name, unit, at, LOG_SD, meaning).within(at * 1e-3, at * 1e3)
    };
    match sentence.kinetics {
        Kinetics::FirstOrder => free.push(positive("tau", "s", start.tau_s, "time constant")),
        Kinetics::RateIndependent => free.push(positive("width", unit, start.width, "half width of the loop")),
        Kinetics::Periodic => {
            // a wave of a turn closes on itself: its period is known
            if start.turn == 0.0 {
                let period = Parameter::log_normal("period", unit, start.period, 0.02, "period");
                free.push(period.within(0.9 * start.period, 1.1 * start.period));
            }
            free.push(Parameter::normal("phase", "rad", start.phase, 0.8, "phase at 0"));
        }
        Kinetics::Static | Kinetics::Accumulating | Kinetics::Event => {}
    }
    if matches!(sentence.kinetics, Kinetics::Event | Kinetics::Periodic | Kinetics::RateIndependent) {
        return free;
    }
    match sentence.form {
        Form::Linear => {}
        Form::Power => {
            free.push(Parameter::normal("exponent", "1", start.exponent, 0.4, "exponent of the law").within(0.2, 5.0));
        }
        Form::Threshold => {
            let sd = 0.2 * start.scale.abs().max(f64::MIN_POSITIVE);
            free.push(Parameter::normal("threshold", unit, start.threshold, sd, "where it begins"));
        }
        Form::Saturating => free.push(positive("scale", unit, start.scale, "where it levels off")),
        Form::Peak => {
            free.push(Parameter::normal("threshold", unit, start.threshold, 2.0 * start.scale, "where it is"));
            free.push(positive("scale", unit, start.scale, "half width"));
        }
    }
    free
}

impl Effect for Composed {
    fn id(&self) -> EffectId {
        self.id
    }
    fn stage(&self) -> StageName {
        match self.sentence.quantity {
            Quantity::Load => StageName::LoadPath,
            Quantity::Temperature => StageName::ThermalPath,
            Quantity::Modulus | Quantity::Strain => StageName::Beads,
            Quantity::Gap | Quantity::Warp => StageName::Geometry,
            Quantity::Permittivity => StageName::Dielectric,
            Quantity::Reading => StageName::Readout,
        }
    }
    fn family(&self) -> Family {
        let remembers = !matches!(self.sentence.kinetics, Kinetics::Static | Kinetics::Periodic);
        match self.sentence.quantity {
            Quantity::Reading | Quantity::Load => Family::Readout,
            Quantity::Temperature | Quantity::Permittivity => Family::Thermal,
            Quantity::Gap | Quantity::Warp => Family::Field,
            Quantity::Modulus | Quantity::Strain if remembers => Family::MechanicalMemory,
            Quantity::Modulus | Quantity::Strain => Family::StaticMechanics,
        }
    }
    fn about(&self) -> About {
        About {
            physics: "a mechanism composed of words: what follows what, how, and where in the chain",
            equation: "quantity + size u, or quantity (1 + size u); u = kinetics of form of driver",
            excitation: "its driver must move otherwise than what the base model already follows",
            impostors: &[],
            separates: "the words that are least sure, each with its probability",
            source: "Langley & Arvay, AAAI 2017 (inductive process modelling): processes are composed of entities and equation forms",
        }
    }
    fn zero_course(&self) -> ZeroCourse {
        if self.sentence.driver == Driver::Time { ZeroCourse::InsideRuns } else { ZeroCourse::Still }
    }
    fn parameters(&self, _: &Context<'_>) -> Vec<Parameter> {
        self.parameters.clone()
    }
    fn in_words(&self, _: &Context<'_>) -> Option<InWords> {
        Some(self.sentence.in_words())
    }
    fn words(&self) -> Option<Mechanism> {
        Some(Mechanism { sentence: self.sentence.clone(), numbers: self.start })
    }
    fn starts(&self, _: &Context<'_>) -> Vec<Vec<f64>> {
        vec![self.parameters.iter().skip(1).map(Parameter::centre).collect()]
    }
    fn testable(&self, context: &Context<'_>) -> Result<(), String> {
        context.has(Effect::stage(self))?;
        match available(&self.sentence.driver, context) {
            true => Ok(()),
            false => Err(format!("`{}` was not recorded or does not move", self.sentence.driver.word())),
        }
    }
    fn with(&self, values: &[f64], context: &Context<'_>) -> Box<dyn Stage> {
        let names = self.parameters.iter().map(|p| p.name.as_str());
        let (numbers, size) = self.start.with(names.zip(values.iter().copied()));
        stage(&self.sentence, numbers, size, context.reference_c)
    }
    fn says(&self, fitted: &[FittedParameter]) -> String {
        self.says.clone().unwrap_or_else(|| describe(&self.sentence, &self.start, fitted, None))
    }
    fn told(&self, fitted: &[FittedParameter], context: &Context<'_>, _: &[(EffectId, Vec<FittedParameter>)]) -> String {
        let own = describe(&self.sentence, &self.start, fitted, Some(context));
        self.says.as_ref().map_or_else(|| own.clone(), |says| format!("{says}: {own}"))
    }
}
