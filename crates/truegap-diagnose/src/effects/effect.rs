//! What an effect of the library must say of itself.
//!
//! Limits: an effect knows the inputs and the chain, never the recorded response; where a search may start is told of it (`far_sizes`).

use crate::{
    data::{context::Context, problem::Problem},
    effects::composed::{mechanism::Mechanism, words::InWords},
};
use truegap_core::{EffectId, Parameter, Stage, simulator::StageName};

/// Groups of effects that a reader would call the same kind of thing; a claim may be right about the family and wrong about the member.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash, serde::Serialize)]
#[serde(rename_all = "snake_case")]
pub enum Family {
    /// how load reaches the dielectric, and how stiff it is: no memory
    StaticMechanics,
    /// strain that remembers load
    MechanicalMemory,
    /// temperature: lag, warp, permittivity
    Thermal,
    /// field and gap geometry
    Field,
    /// electronics and clocks
    Readout,
    /// the surroundings: water
    Environment,
}

/// What a reader should know of an effect before any number is fitted.
#[derive(Clone, Copy, Debug, serde::Serialize)]
pub struct About {
    /// one sentence: the physics
    pub physics: &'static str,
    /// the equation as fitted, in plain text
    pub equation: &'static str,
    /// what a recording must contain to show it
    pub excitation: &'static str,
    /// effects that it is usually mistaken for
    pub impostors: &'static [&'static str],
    /// what tells it from them
    pub separates: &'static str,
    /// where the physics is described
    pub source: &'static str,
}

/// An instrument change that tells an effect from another where no profile of load and temperature can.
#[derive(Clone, Copy, Debug, PartialEq, Eq, serde::Serialize)]
pub struct Separation {
    /// id of the effect that it is told from
    pub rival: &'static str,
    /// what to do
    pub says: &'static str,
}

/// How an effect moves the zero of the reading by itself, with numbers of its own instead of an equation in the inputs.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum ZeroCourse {
    /// not at all
    Still,
    /// from run to run
    BetweenRuns,
    /// inside runs as well
    InsideRuns,
}

/// A parameter after the fit.
#[derive(Clone, Debug, PartialEq)]
pub struct FittedParameter {
    /// name, unit, prior
    pub parameter: Parameter,
    /// most probable value, in the parameter's unit
    pub value: f64,
    /// standard deviation, in the parameter's unit, with physics that may act beside what is named
    pub sd: f64,
    /// part of it that the fit itself has, from noise and prior
    pub sd_of_fit: f64,
    /// whether the value lies on a bound
    pub at_limit: bool,
}

/// A number by which an effect is told from what it would be on a limit of it.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Mark {
    /// told from the lower limit: a loop of no width has one way only
    Above(&'static str),
    /// told from the upper limit: what is late by more than a recording adds up
    Below(&'static str),
}

impl Mark {
    /// Whether the number of this name, at `z` between its `bounds` and known to `sd`, is the mark and not told from its limit.
    pub(crate) fn is_unseen(self, name: &str, z: f64, sd: f64, bounds: (f64, f64)) -> bool {
        let (own, aside, seen) = match self {
            Self::Above(own) => (own, z - bounds.0, WIDTH_SEEN),
            Self::Below(own) => (own, bounds.1 - z, TIME_SEEN),
        };
        own == name && aside < seen * sd
    }
}

/// Distance from the lower limit from which on a width is told from nothing, in standard deviations, as shares of a law are.
const WIDTH_SEEN: f64 = 2.0;
/// The same for a time constant from that of a whole recording: a long one is hardly known in any case.
const TIME_SEEN: f64 = 1.0;

/// Something that happens once in a recording.
#[derive(Clone, Debug, PartialEq)]
pub struct Once {
    /// from when until when: seconds after the first row, rows without a clock
    pub when: std::ops::Range<f64>,
    /// how much higher or lower the reading stands afterwards, in its unit
    pub change: f64,
    /// whether it is a moment: what takes as long as it may goes on for a while, and rows that see some of it foretell the rest
    pub is_a_moment: bool,
}

/// Omitted physics: one stage of the chain that the base model takes to be the identity.
///
/// `parameters(..)[0]` is the *size*: 0 means that the effect is absent, and the response is smooth in it.
pub trait Effect: Send + Sync {
    /// Stable name.
    fn id(&self) -> EffectId;
    /// Place in the chain.
    fn stage(&self) -> StageName;
    /// Kind of thing.
    fn family(&self) -> Family;
    /// The words that a mechanism of its kind is composed of: where it acts, what it follows, how in time; `None` where no words say it.
    fn in_words(&self, _context: &Context<'_>) -> Option<InWords> {
        None
    }
    /// What a reader should know.
    fn about(&self) -> About;
    /// Free parameters with unit, prior and bounds; the first is the size, whose prior is centred on 0 unless it is
    /// [`Effect::foreseen`].
    fn parameters(&self, context: &Context<'_>) -> Vec<Parameter>;
    /// Whether somebody else has computed the size: it is a share of what is foreseen, with a prior about 1, and not about 0.
    fn foreseen(&self) -> bool {
        false
    }
    /// Every place of the chain that it acts at; one cause may show at several.
    fn touches(&self) -> Vec<StageName> {
        vec![self.stage()]
    }
    /// Instrument changes that tell it from others; a pair of effects is listed by one of the two.
    fn separations(&self) -> &'static [Separation] {
        &[]
    }
    /// How it moves the zero by itself: an unmodelled cause that does the same is not weighed beside it.
    fn zero_course(&self) -> ZeroCourse {
        ZeroCourse::Still
    }
    /// Whether it is what a clipped reading shows, so that it may be named where readings are clipped.
    fn clips(&self) -> bool {
        false
    }
    /// Whether it has no equation that could be wrong, but a number for whatever happens; what it leaves is then another cause.
    fn free_form(&self) -> bool {
        false
    }
    /// Whether its shape describes a curve and is no law: a shape on a bound then says nothing against it.
    fn describes(&self) -> bool {
        false
    }
    /// Whether it belongs to what recorded and not to what was recorded, as a clock does: its numbers mean nothing in another recording.
    fn of_recorder(&self) -> bool {
        false
    }
    /// Whether it is an error of the recorded input, as a load cell has one: a reading that is corrected for it would agree with the error.
    fn of_reference(&self) -> bool {
        false
    }
    /// Names of the numbers that say how this recording began: another recording began in its own way.
    fn of_start(&self, _context: &Context<'_>) -> &'static [&'static str] {
        &[]
    }
    /// The number that says how much there is of what `_number` describes: a second time constant means nothing without its share.
    fn share_of(&self, _number: &str) -> Option<&'static str> {
        None
    }
    /// Period of what comes back by itself, s: a line in the spectrum at a multiple of its frequency is another wave of the same shape.
    fn comes_back_s(&self) -> Option<f64> {
        None
    }
    /// What happens once, where something does.
    fn happens(&self, _values: &[f64], _context: &Context<'_>) -> Option<Once> {
        None
    }
    /// Whether it goes with the date, so that another recording shows it where both tell theirs.
    fn by_date(&self) -> bool {
        false
    }
    /// Its numbers in the first of several recordings, from those fitted to all; the same where all have them in common.
    fn of_first(&self, fitted: Vec<FittedParameter>, _context: &Context<'_>) -> Vec<FittedParameter> {
        fitted
    }
    /// Id of the effect that it changes, beside which alone it means something with these numbers: a changed coefficient needs the coefficient.
    fn beside(&self, _values: &[f64], _context: &Context<'_>) -> Option<&'static str> {
        None
    }
    /// Its words, where it is composed of words: a model file then holds all of it.
    fn words(&self) -> Option<Mechanism> {
        None
    }
    /// Values of the parameters behind the size from which a search starts; one empty list where the size is all there is.
    fn starts(&self, _context: &Context<'_>) -> Vec<Vec<f64>> {
        vec![Vec::new()]
    }
    /// Sizes, in the unit of the size, from which a search in these rows starts as well: where the reading goes up and down with the size, so that no straight step leads from nothing to the right one.
    fn far_sizes(&self, _context: &Context<'_>, _searched: &Problem<'_>) -> Vec<f64> {
        Vec::new()
    }
    /// The effect whose law this one holds as a special case: an influence that comes late is a plain one where nothing is seen of its lag. It is named only where more is seen than that.
    fn comes_down_to(&self) -> Option<EffectId> {
        None
    }
    /// Name of the number that is 0 in the law that this one comes down to, and by which a person tells the two apart.
    fn apart_by(&self) -> Option<&'static str> {
        None
    }
    /// The number on a limit of which the effect would be another one. Where it is not told from there, the law lies on that limit.
    fn mark(&self) -> Option<Mark> {
        None
    }
    /// Names of numbers that are 0 in the simplest law that goes by this name: a bend, a second way. Where rows left out do not bear them out, they are held there.
    fn may_be_nothing(&self) -> &'static [&'static str] {
        &[]
    }
    /// Names of numbers of a richer law by the same name, 0 in the law that is tried at first. They are opened where rows left out bear them out.
    fn may_be_more(&self) -> &'static [&'static str] {
        &[]
    }
    /// Numbers of other laws by the same name, a list of names for each law, 0 in the law that is tried at first. They are opened as those of a richer law are, one law at a time.
    fn other_laws(&self) -> &'static [&'static [&'static str]] {
        &[]
    }
    /// Names of the numbers of all laws but the one that is tried at first: they are held at 0 until then.
    fn held_at_first(&self) -> Vec<&'static str> {
        [self.may_be_more(), &self.other_laws().concat()].concat()
    }
    /// Names of the numbers that its law has not had from the beginning: they are 0 in a model file that knows nothing of them.
    fn came_later(&self) -> Vec<&'static str> {
        self.held_at_first()
    }
    /// Names of numbers, behind the size, whose lower limit is a law as good as any: what takes no time or no way. One that lies there does not say that the law fails.
    fn at_once(&self) -> &'static [&'static str] {
        &[]
    }
    /// Whether it smooths what is quick in a column that the base model follows, beside what else it does.
    fn smooths(&self) -> bool {
        false
    }
    /// Whether this recording could show it at all.
    ///
    /// # Errors
    /// The reason why not, for a reader.
    fn testable(&self, context: &Context<'_>) -> Result<(), String>;
    /// The stage with these values.
    fn with(&self, values: &[f64], context: &Context<'_>) -> Box<dyn Stage>;
    /// The same physics by other equations, with the same parameters: made for testing recovery, never fitted.
    fn sibling(&self, _values: &[f64], _context: &Context<'_>) -> Option<Box<dyn Stage>> {
        None
    }
    /// What a reader should be told, with the fitted numbers in it.
    fn says(&self, fitted: &[FittedParameter]) -> String;
    /// The same for this recording: with the names of its drivers, in neutral words where the base model is no stack of a sensor, and with what the effects
    /// `beside` it are fitted to.
    fn told(&self, fitted: &[FittedParameter], _context: &Context<'_>, _beside: &[(EffectId, Vec<FittedParameter>)]) -> String {
        self.says(fitted)
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    /// A loop of 0.163 % (sd 0.129) on the narrowest of 0.1627 %, and a lag of 149 min (sd 52) in a run of 150 min: neither is told from its limit.
    #[test]
    fn a_mark_is_told_from_its_limit_by_its_deviation() {
        let (width, lag) = (Mark::Above("half_width"), Mark::Below("tau"));
        let bounds = |low: f64, high: f64| (low.ln(), high.ln());
        assert!(width.is_unseen("half_width", 0.163_f64.ln(), 0.79, bounds(0.1627, 81.0)));
        assert!(!width.is_unseen("half_width", 3.0_f64.ln(), 0.05, bounds(0.1627, 81.0)));
        assert!(!width.is_unseen("rounding", 0.163_f64.ln(), 0.79, bounds(0.1627, 81.0)));
        assert!(lag.is_unseen("tau", 149.0_f64.ln(), 0.35, bounds(0.1, 150.0)));
        assert!(!lag.is_unseen("tau", 40.0_f64.ln(), 0.35, bounds(0.1, 150.0)));
    }
}
