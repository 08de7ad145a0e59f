//! Something is switched inside the recording: after an unknown time the zero of the reading is another one, or a coefficient, or both.

mod extent;
mod of;
mod said;

use self::{
    extent::{Extent, length},
    of::Of,
    said::at,
};
use crate::{
    data::context::Context,
    effects::composed::words::{Driver, InWords, Kinetics, Place},
    effects::{
        course::{Course, without_a_jump},
        effect::{About, Effect, Family, FittedParameter, Once},
        memory::elapsed_s,
    },
    stats::spread,
    text::with_sd,
};
use truegap_core::{Drive, EffectId, Parameter, Readout, Stage, simulator::StageName};

/// A zero and a coefficient that change at one time.
pub enum RegimeChange {
    /// the zero, and the coefficient of the temperature, else of a driver, else the gain
    OfWhatMoves,
    /// the gain, and the zero, where the coefficient of something else could have changed as well
    OfTheGain,
}

impl RegimeChange {
    fn of(&self, context: &Context<'_>) -> Of {
        match self {
            Self::OfWhatMoves => Of::what_moves(context),
            Self::OfTheGain => Of::Reading,
        }
    }
}

struct Switch {
    of: Of,
    /// coefficient after less before
    coefficient: f64,
    /// zero after less before, where `x` is 0
    zero: f64,
    /// seconds after the first row of the middle of the change
    when_s: f64,
    /// seconds that it takes
    takes_s: f64,
}

impl Switch {
    fn apply(&self, drive: &Drive<'_>, readout: &Readout, value: &mut [f64], after: impl Fn(f64) -> f64) {
        if self.coefficient == 0.0 && self.zero == 0.0 {
            return;
        }
        for (row, value) in value.iter_mut().enumerate() {
            let x = match self.of {
                Of::Temperature => drive.temperature_c[row] - drive.reference_c,
                Of::Driver(course) => course.column(drive).map_or(0.0, |column| column[row]),
                Of::Reading => *value - readout.of_no_gain(),
                Of::Nothing => 0.0,
            };
            let share = after((elapsed_s(drive.inputs, row) - self.when_s) / self.takes_s);
            *value += share * (self.coefficient * x + self.zero);
        }
    }
}

impl Stage for Switch {
    fn readout(&self, drive: &Drive<'_>, readout: &Readout, value: &mut [f64]) {
        self.apply(drive, readout, value, |x| (x + 0.5).clamp(0.0, 1.0));
    }
}

/// Sibling: a change that settles exponentially, begun a little before its middle.
struct Settling(Switch);

impl Stage for Settling {
    fn readout(&self, drive: &Drive<'_>, readout: &Readout, value: &mut [f64]) {
        self.0.apply(drive, readout, value, |x| if x < -0.3 { 0.0 } else { -(-1.5 * (x + 0.3)).exp_m1() });
    }
}

/// How a change divides between zero and coefficient, as an angle: each of them may be all of it, and neither is a limit of the other.
const TURN: &str = "turn";
/// Angle at which the second of the two is all of the change; a little more is allowed, so that this is no limit.
const LARGEST_TURN: f64 = 0.7 * std::f64::consts::PI;
/// Deviation of the angle where only the zero can change. The number stays, so that a model of another recording is read beside such inputs.
const NEXT_TO_NO_TURN: f64 = 1e-6;

impl RegimeChange {
    /// Whether only a zero can change, and only within few rows: what moves goes one way only, so that one law before and one after are a law of the way that it goes. Where it turns once, friction jumps as well.
    fn jumps_only(&self, context: &Context<'_>) -> bool {
        matches!(self, Self::OfWhatMoves) && context.runs == 1 && Of::what_moves(context).goes_one_way(context)
    }

    /// What a change of size `change` with this angle does to coefficient and zero.
    fn divided(&self, change: f64, turn: f64, context: &Context<'_>) -> (f64, f64) {
        let of = self.of(context);
        let (middle, half) = of.middle_and_half(context);
        let (sin, cos) = turn.sin_cos();
        match self {
            _ if of == Of::Nothing => (0.0, change),
            Self::OfWhatMoves => (change * sin / half, change * (cos - sin * middle / half)),
            Self::OfTheGain => (change * cos, change * sin * of.span(context)),
        }
    }

    /// The angle as far as zero and coefficient can be told apart at the time of the change.
    fn turned(&self, values: &[f64], context: &Context<'_>) -> f64 {
        let turn = values.get(3).copied().unwrap_or(0.0);
        if turn == 0.0 { 0.0 } else { turn * told_apart_at(values[1], context, self.of(context)) }
    }

    fn switch(&self, values: &[f64], context: &Context<'_>) -> Switch {
        let (coefficient, zero) = self.divided(values[0], self.turned(values, context), context);
        Switch { of: self.of(context), coefficient, zero, when_s: values[1], takes_s: values[2] }
    }
}

/// Part of its range that the input must cross before a change and after it, so that there are two laws to be told.
const CROSSED: f64 = 0.35;

/// Earliest and latest time of a change (as [`elapsed_s`]) at which the input has moved before and moves after it; `None` where there is no such time.
///
/// A change at the edge of what moved would be another name for one coefficient throughout.
fn told_apart(context: &Context<'_>, of: Of) -> Option<(f64, f64)> {
    let inputs = context.inputs;
    let length = length(context);
    let column = match of {
        Of::Temperature => inputs.temperature_c.as_deref(),
        Of::Driver(Course::Driver(index)) => inputs.drivers.get(index).map(|driver| driver.values.as_slice()),
        Of::Reading => inputs.gap_m.as_deref().or(inputs.simulated.as_deref()),
        Of::Driver(_) | Of::Nothing => None,
    };
    let Some(column) = column.map(without_a_jump) else { return Some((ENDS.0 * length, ENDS.1 * length)) };
    let least = CROSSED * spread(&column);
    let moved = |mut rows: Box<dyn Iterator<Item = usize>>| {
        let (mut low, mut high) = (f64::INFINITY, f64::NEG_INFINITY);
        rows.find(|row| {
            (low, high) = (low.min(column[*row]), high.max(column[*row]));
            high - low >= least
        })
    };
    let earliest = elapsed_s(inputs, moved(Box::new(0..column.len()))?);
    let latest = elapsed_s(inputs, moved(Box::new((0..column.len()).rev()))?);
    (earliest < latest).then_some((earliest, latest))
}

/// Earliest and latest time of any change, as shares of the recording.
const ENDS: (f64, f64) = (0.05, 0.95);

/// How much of a change at this time may be one of the second of zero and coefficient: all between the times of [`told_apart`], nothing far outside of them, where the zero alone can change.
fn told_apart_at(when: f64, context: &Context<'_>, of: Of) -> f64 {
    let Some((earliest, latest)) = told_apart(context, of) else { return 0.0 };
    let outside = (earliest - when).max(when - latest).max(0.0);
    (1.0 - outside / (0.02 * length(context))).max(0.0)
}

/// Angle from which a change is looked for as well: most of it is the second of the two.
const STEEP: f64 = 1.2;
impl Effect for RegimeChange {
    fn id(&self) -> EffectId {
        EffectId(match self {
            Self::OfWhatMoves => "regime_change",
            Self::OfTheGain => "gain_change",
        })
    }
    fn stage(&self) -> StageName {
        StageName::Readout
    }
    fn family(&self) -> Family {
        Family::Readout
    }
    fn in_words(&self, _: &Context<'_>) -> Option<InWords> {
        Some(InWords { place: Place::Readout, driver: Driver::Time, kinetics: Kinetics::Event })
    }
    fn about(&self) -> About {
        About {
            physics: "something is switched inside the recording (a compensation, a repair, a new firmware): the zero, a coefficient, or both are others afterwards",
            equation: "value = true + q h(t) (cos a + sin a (x - m) / s), h from 0 to 1 at t_c, straight over w; x is T_s - T0, else a driver, else the reading, m its mean and s half its range; a = 0 is a jump of the zero; the coefficient before is that of `temperature_coefficient` (or `driver_coefficient`) beside it; a changed gain: value = true + q h(t) (cos a y + sin a S), y the reading and S its range",
            excitation: "temperature (or a driver) that moves before and after the change; where what moves goes one way only, a zero that jumps within a fiftieth of the recording",
            impostors: &[
                "temperature_coefficient",
                "driver_coefficient",
                "offset_drift",
                "offset_steps",
                "gain_drift",
                "nonlinearity",
            ],
            separates: "one law before and one law after a time, each the same throughout",
            source: "Basseville & Nikiforov, Detection of Abrupt Changes, ch. 2; Quandt, J. Am. Stat. Assoc. 53 (1958) 873 (switching regressions)",
        }
    }
    fn beside(&self, values: &[f64], context: &Context<'_>) -> Option<&'static str> {
        // the angle as it was fitted: one that means little at its time is fitted again from nothing
        let of_zero = values.get(3).is_none_or(|turn| turn.sin().abs() < MOSTLY_ZERO * turn.cos().abs());
        match self.of(context) {
            _ if of_zero => None,
            Of::Temperature => Some("temperature_coefficient"),
            Of::Driver(_) => Some("driver_coefficient"),
            Of::Reading | Of::Nothing => None,
        }
    }
    fn at_once(&self) -> &'static [&'static str] {
        &["takes"]
    }
    fn may_be_nothing(&self) -> &'static [&'static str] {
        &[TURN]
    }
    fn of_recorder(&self) -> bool {
        true
    }
    fn happens(&self, values: &[f64], context: &Context<'_>) -> Option<Once> {
        let (when, takes) = (values[1], values[2]);
        let unit = if matches!(self, Self::OfTheGain) { context.response_span.abs() } else { 1.0 };
        let is_a_moment = Extent::of(self.jumps_only(context), context).is_a_moment(takes);
        Some(Once { when: when - 0.5 * takes..when + 0.5 * takes, change: unit * values[0], is_a_moment })
    }
    fn parameters(&self, context: &Context<'_>) -> Vec<Parameter> {
        let (of, length, jumps_only) = (self.of(context), length(context), self.jumps_only(context));
        let extent = Extent::of(jumps_only, context);
        let unit = if context.shortest_step_s.is_some() { "s" } else { "rows" };
        let (of_size, size, meaning, turned) = match self {
            Self::OfWhatMoves => (
                context.simulator.unit().to_string(),
                context.response_span.abs(),
                "change of the reading: of its zero in the middle of the range, and by its coefficient at the ends, as a root of squares",
                "0: the zero alone changes; pi/2: the coefficient alone, about the middle of the range",
            ),
            Self::OfTheGain => {
                ("1".to_string(), 1.0, "gain after less before", "0: the gain alone changes; pi/2: the zero alone")
            }
        };
        let mut list = vec![
            Parameter::normal("change", &of_size, 0.0, size, meaning),
            Parameter::normal("when", unit, 0.5 * length, 0.4 * length, "time of the change after the first row")
                .within(ENDS.0 * length, ENDS.1 * length),
            Parameter::log_normal("takes", unit, extent.usual(), 1.5, "time that the change takes")
                .within(extent.shortest, extent.limit()),
        ];
        if of != Of::Nothing {
            let known = if jumps_only { NEXT_TO_NO_TURN } else { 1.0 };
            list.push(Parameter::normal(TURN, "rad", 0.0, known, turned).within(-LARGEST_TURN, LARGEST_TURN));
        }
        list
    }
    fn starts(&self, context: &Context<'_>) -> Vec<Vec<f64>> {
        let (of, length, jumps_only) = (self.of(context), length(context), self.jumps_only(context));
        let extent = Extent::of(jumps_only, context);
        let share = |k: usize| ENDS.0 + (ENDS.1 - ENDS.0) * (k as f64 + 0.5) / extent.times as f64;
        let times = (0..extent.times).map(|k| length * share(k));
        let takes = extent.looked_for();
        if of == Of::Nothing {
            return times.map(|t| vec![t, takes]).collect();
        }
        let steep = |t: f64| !jumps_only && told_apart_at(t, context, of) > 0.0;
        let turns = |t: f64| if steep(t) { vec![0.0, STEEP] } else { vec![0.0] };
        times.flat_map(|t| turns(t).into_iter().map(move |turn| vec![t, takes, turn])).collect()
    }
    fn comes_down_to(&self) -> Option<EffectId> {
        Some(EffectId("gain_error"))
    }
    fn testable(&self, context: &Context<'_>) -> Result<(), String> {
        context.has(StageName::Readout)?;
        // it is said when something was switched, which rows without a clock cannot say
        context.needs_clock()?;
        if matches!(self, Self::OfTheGain) {
            if context.has_plates() {
                return Err("the base model has places for a change of its own".into());
            }
            if Of::what_moves(context) == Of::Reading {
                return Err("the same as a change of regime here".into());
            }
            if !context.simulator.moves() {
                return Err("a value that does not move shows no gain".into());
            }
            context.needs_movement()?;
        }
        if context.has_plates() && !matches!(self.of(context), Of::Driver(_)) {
            return Err(
                "the base model has places for temperature and history of its own; jumps between runs are offset steps".into()
            );
        }
        if context.simulator.joined().is_some_and(|joined| joined.count() > 1) {
            return Err("a change at one time belongs to one recording; diagnose it by itself".into());
        }
        let jumps_only = self.jumps_only(context);
        if let Some(course) = self.of(context).course(context).filter(|course| !jumps_only && !course.comes_again(context)) {
            let name = course.name(context);
            return Err(format!(
                "{name} goes up or down no more than once; a change at one time cannot be told from a law of the way that it goes"
            ));
        }
        let rows = context.inputs.len();
        if rows < FEWEST {
            return Err(format!("{rows} rows only, too few for two laws"));
        }
        match told_apart(context, self.of(context)) {
            None if !jumps_only => Err("what the coefficient is of does not move both before and after any time".into()),
            _ => Ok(()),
        }
    }
    fn with(&self, values: &[f64], context: &Context<'_>) -> Box<dyn Stage> {
        Box::new(self.switch(values, context))
    }
    fn sibling(&self, values: &[f64], context: &Context<'_>) -> Option<Box<dyn Stage>> {
        Some(Box::new(Settling(self.switch(values, context))))
    }
    fn says(&self, fitted: &[FittedParameter]) -> String {
        let change = &fitted[0];
        format!("{}: the reading changes by {}", at(fitted), with_sd(change.value, change.sd, &change.parameter.unit))
    }
    fn told(&self, fitted: &[FittedParameter], context: &Context<'_>, beside: &[(EffectId, Vec<FittedParameter>)]) -> String {
        let before = |id: &str| {
            let found = beside.iter().find(|(effect, _)| effect.0 == id).and_then(|(_, f)| f.first());
            found.map_or(0.0, |before| before.value)
        };
        let (of, at, reading) = (self.of(context), at(fitted), context.simulator.unit());
        let share = told_apart_at(fitted[1].value, context, of);
        let (turn, sd_of_turn) = fitted.get(3).map_or((0.0, 0.0), |turn| (share * turn.value, share * turn.sd));
        let (change, sd) = (fitted[0].value, fitted[0].sd);
        let (coefficient, zero) = self.divided(change, turn, context);
        let (sin, cos) = turn.sin_cos();
        let of_second = (sin * sd).hypot(change * cos * sd_of_turn) / of.middle_and_half(context).1;
        let switched = |old: f64, name: &str| said::coefficient((&at, name), old, [coefficient, of_second], &of.unit(context));
        // the reading above its lowest value is what the gain counts from
        let step = (zero + coefficient * 0.5 * context.response_span.abs(), reading);
        let mostly_zero = sin.abs() < cos.abs() && (turn.abs() < STRAIGHT || turn.abs() < 2.0 * sd_of_turn);
        match (of, self) {
            (_, Self::OfTheGain) => said::gain(&at, [coefficient, (cos * sd).hypot(change * sin * sd_of_turn)], step),
            (Of::Temperature, _) if !mostly_zero => switched(before("temperature_coefficient"), "temperature"),
            (Of::Driver(course), _) if !mostly_zero => switched(before("driver_coefficient"), course.name(context)),
            (Of::Reading, _) if !mostly_zero => said::gain(&at, [coefficient, of_second], step),
            _ => said::zero(&at, [change, sd], reading),
        }
    }
}

/// What a changed coefficient may move the ends of the range by, of what the zero moves, so that the change is first of all one of the zero and needs no coefficient beside it. With as much as the zero moves
/// a change near the beginning stood for a coefficient throughout.
const MOSTLY_ZERO: f64 = 1.0 / 3.0;

/// Angle below which the zero is all that changes, for a reader.
const STRAIGHT: f64 = 0.05;

/// Fewest rows in which two laws are looked for.
const FEWEST: usize = 60;

#[cfg(test)]
mod tests {
    use super::*;
    use truegap_core::Inputs;

    #[test]
    fn a_coefficient_and_a_zero_change_at_one_time() {
        let inputs = Inputs { time_s: Some(vec![0.0, 10.0, 90.0, 100.0]), run: vec![1; 4], ..Inputs::default() };
        let temperature_c = [21.0, 25.0, 21.0, 25.0];
        let drive = Drive { inputs: &inputs, load: &[0.0; 4], temperature_c: &temperature_c, reference_c: 20.0, full_load: 1.0 };
        let mut value = vec![5.0; 4];
        // none before and 0.3 after; the zero falls by 0.3 x 4
        let switch = Switch { of: Of::Temperature, coefficient: 0.3, zero: -1.2, when_s: 50.0, takes_s: 4.0 };
        switch.readout(&drive, &Readout { zero: 0.0, span: 1.0 }, &mut value);
        let wanted = [5.0, 5.0, 5.0 + 0.3 - 1.2, 5.0 + 1.5 - 1.2];
        value.iter().zip(wanted).for_each(|(v, w)| approx::assert_abs_diff_eq!(*v, w, epsilon = 1e-12));
    }
}
