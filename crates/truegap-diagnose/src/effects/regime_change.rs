//! Something is switched inside the recording: a coefficient of the reading is another one after an unknown time.

use crate::{
    data::context::Context,
    effects::composed::words::{Driver, InWords, Kinetics, Place},
    effects::{
        course::Course,
        effect::{About, Effect, Family, FittedParameter},
        memory::elapsed_s,
    },
    stats::spread,
    text::{percent_with_sd, rounded, significant, with_sd},
};
use truegap_core::{Drive, EffectId, Parameter, Readout, Stage, simulator::StageName};

/// A coefficient and a zero that change at one time.
pub enum RegimeChange {
    /// that of the temperature, else of a driver, else the gain
    OfWhatMoves,
    /// the gain, where the coefficient of something else could have changed as well
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

/// What the coefficient is of.
#[derive(Clone, Copy, Debug, PartialEq)]
enum Of {
    Temperature,
    Driver(Course),
    /// the reading itself: a gain
    Reading,
    /// nothing moves: only the zero changes
    Nothing,
}

/// Temperature range from which on a coefficient can be told, K.
const WARMS: f64 = 2.0;

impl Of {
    fn what_moves(context: &Context<'_>) -> Self {
        if context.moved.temperature_k >= WARMS {
            return Self::Temperature;
        }
        match Course::of(context, 0) {
            Some(Course::Driver(index)) => Self::Driver(Course::Driver(index)),
            Some(_) => Self::Reading,
            None => Self::Nothing,
        }
    }

    /// What moves the reading or its coefficient, where that is no temperature.
    fn course(self, context: &Context<'_>) -> Option<Course> {
        match self {
            Self::Driver(course) => Some(course),
            Self::Reading => Course::of(context, 0),
            Self::Temperature | Self::Nothing => None,
        }
    }

    /// Range of what the coefficient is of, in its unit.
    fn span(self, context: &Context<'_>) -> f64 {
        match self {
            Self::Temperature => context.temperature_span(),
            Self::Driver(course) => course.span(context),
            Self::Reading | Self::Nothing => context.response_span.abs(),
        }
    }

    /// Unit of the coefficient.
    fn unit(self, context: &Context<'_>) -> String {
        let reading = context.simulator.unit();
        match self {
            Self::Temperature => format!("{reading}/K"),
            Self::Driver(course) => format!("{reading}/{}", course.unit(context)),
            Self::Reading => "1".into(),
            Self::Nothing => reading.into(),
        }
    }

    /// Middle of the column over the recording, from where the coefficient counts to begin with.
    fn middle(self, context: &Context<'_>) -> f64 {
        let half = |column: &[f64]| column.iter().sum::<f64>() / column.len().max(1) as f64;
        match self {
            Self::Temperature => context.inputs.temperature_c.as_deref().map_or(0.0, half) - context.reference_c,
            Self::Driver(Course::Driver(index)) => context.inputs.drivers.get(index).map_or(0.0, |d| half(&d.values)),
            _ => 0.0,
        }
    }
}

struct Switch {
    of: Of,
    /// coefficient after less before
    change: f64,
    /// seconds after the first row of the middle of the change
    when_s: f64,
    /// seconds that it takes
    takes_s: f64,
    /// zero after less before, over `change`
    jump: f64,
}

impl Switch {
    fn apply(&self, drive: &Drive<'_>, readout: &Readout, value: &mut [f64], after: impl Fn(f64) -> f64) {
        if self.change == 0.0 {
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
            *value += self.change * share * (x + self.jump);
        }
    }
}

impl Stage for Switch {
    fn readout(&self, drive: &Drive<'_>, readout: &Readout, value: &mut [f64]) {
        self.apply(drive, readout, value, |x| (x + 0.5).clamp(0.0, 1.0));
    }
}

/// Sibling: a change that settles exponentially.
struct Settling(Switch);

impl Stage for Settling {
    fn readout(&self, drive: &Drive<'_>, readout: &Readout, value: &mut [f64]) {
        self.0.apply(drive, readout, value, |x| if x < 0.0 { 0.0 } else { -(-2.0 * x).exp_m1() });
    }
}

/// Length over which a change can be looked for: seconds, or rows without a clock.
fn length(context: &Context<'_>) -> f64 {
    if context.shortest_step_s.is_some() { context.length_s() } else { context.inputs.len() as f64 }
}

fn switch(values: &[f64], of: Of) -> Switch {
    let jump = if of == Of::Nothing { 1.0 } else { values[3] };
    Switch { of, change: values[0], when_s: values[1], takes_s: values[2], jump }
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
    let Some(column) = column else { return Some((0.05 * length, 0.95 * length)) };
    let least = CROSSED * spread(column);
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

/// Standard deviation of a jump, in ranges of what the coefficient is of: far above 1, so that a zero may change beside a coefficient that hardly does.
const JUMPS: f64 = 5.0;
/// Times at which a change is looked for to begin with.
const LOOKED_AT: usize = 16;
/// Longest that a change may take, as a share of the recording: what takes longer is a drift, and nothing was switched. It is looked for as long as from one of these times to the next, or at that
/// length where this is shorter, so that its time is found from afar.
const LONGEST: f64 = 0.05;

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
            physics: "something is switched inside the recording (a compensation, a repair, a new firmware): zero and coefficient are others afterwards",
            equation: "value = true + q h(t) (x + z), h from 0 to 1 at t_c, straight over w; x is T_s - T0, else a driver, else the reading; the coefficient before is that of `temperature_coefficient` (or `driver_coefficient`) beside it",
            excitation: "temperature (or a driver) that moves before and after the change",
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
    fn beside(&self, context: &Context<'_>) -> Option<&'static str> {
        match self.of(context) {
            Of::Temperature => Some("temperature_coefficient"),
            Of::Driver(_) => Some("driver_coefficient"),
            Of::Reading | Of::Nothing => None,
        }
    }
    fn of_recorder(&self) -> bool {
        true
    }
    fn parameters(&self, context: &Context<'_>) -> Vec<Parameter> {
        let of = self.of(context);
        let (span, length) = (of.span(context).max(f64::MIN_POSITIVE), length(context));
        let size = if of == Of::Nothing { context.response_span.abs() } else { context.response_span.abs() / span };
        let step = context.step_s().min(0.01 * length);
        let (earliest, latest) = told_apart(context, of).unwrap_or((0.01 * length, 0.99 * length));
        let unit = if context.shortest_step_s.is_some() { "s" } else { "rows" };
        let mut list = vec![
            Parameter::normal("change", &of.unit(context), 0.0, size, "coefficient after the change less that before"),
            Parameter::normal("when", unit, 0.5 * length, 0.4 * length, "time of the change after the first row")
                .within(earliest, latest),
            Parameter::log_normal("takes", unit, (0.4 * LONGEST * length).max(step), 1.5, "time that the change takes")
                .within(step, (LONGEST * length).max(2.0 * step)),
        ];
        if of != Of::Nothing {
            let x = if of == Of::Reading { "reading" } else { "change of the reading" };
            let meaning = format!("zero after less before, over the {x} that a changed coefficient of 1 makes");
            list.push(Parameter::normal("jump", "1", -of.middle(context), JUMPS * span, &meaning));
        }
        list
    }
    fn starts(&self, context: &Context<'_>) -> Vec<Vec<f64>> {
        let (of, length) = (self.of(context), length(context));
        let (earliest, latest) = told_apart(context, of).unwrap_or((0.0, length));
        let times = (0..LOOKED_AT).map(|k| earliest + (latest - earliest) * (k as f64 + 0.5) / LOOKED_AT as f64);
        let takes = ((latest - earliest) / LOOKED_AT as f64).min(LONGEST * length);
        if of == Of::Nothing {
            return times.map(|t| vec![t, takes]).collect();
        }
        let jumps = [0.0, 0.5 * JUMPS * of.span(context)].map(|jump| jump - of.middle(context));
        times.flat_map(|t| jumps.map(|jump| vec![t, takes, jump])).collect()
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
        if let Some(course) = self.of(context).course(context).filter(|course| !course.comes_again(context)) {
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
            None => Err("what the coefficient is of does not move both before and after any time".into()),
            Some(_) => Ok(()),
        }
    }
    fn with(&self, values: &[f64], context: &Context<'_>) -> Box<dyn Stage> {
        Box::new(switch(values, self.of(context)))
    }
    fn sibling(&self, values: &[f64], context: &Context<'_>) -> Option<Box<dyn Stage>> {
        Some(Box::new(Settling(switch(values, self.of(context)))))
    }
    fn says(&self, fitted: &[FittedParameter]) -> String {
        said(fitted, "its input", None)
    }
    fn told(&self, fitted: &[FittedParameter], context: &Context<'_>, beside: &[(EffectId, Vec<FittedParameter>)]) -> String {
        let before = |id: &str| beside.iter().find(|(effect, _)| effect.0 == id).and_then(|(_, f)| f.first());
        match self.of(context) {
            Of::Temperature => said(fitted, "temperature", before("temperature_coefficient")),
            Of::Driver(course) => said(fitted, course.name(context), before("driver_coefficient")),
            Of::Reading => {
                let said = said(fitted, "its input", None);
                // the reading above its lowest value is what the gain counts from
                let step = fitted[0].value * (fitted[3].value + 0.5 * context.response_span.abs());
                format!("{said}, and the reading by {} in the middle of its range", rounded(step, context.simulator.unit()))
            }
            Of::Nothing => said(fitted, "its input", None),
        }
    }
}

/// Fewest rows in which two laws are looked for.
const FEWEST: usize = 60;

/// Share of the change below which a coefficient counts as none.
const NONE: f64 = 0.05;

/// `before` is the coefficient that a finding beside it gives to the whole recording.
fn said(fitted: &[FittedParameter], of: &str, before: Option<&FittedParameter>) -> String {
    let (change, when, takes) = (&fitted[0], &fitted[1], &fitted[2]);
    let at = if when.parameter.unit == "s" {
        // a change that takes long is not known better than to its own length
        format!("{} after the first row", with_sd(when.value, when.sd.max(0.3 * takes.value), "s"))
    } else {
        format!("at about row {}", significant(when.value.round(), 4))
    };
    let unit = change.parameter.unit.as_str();
    let by = with_sd(change.value, change.sd, unit);
    if fitted.len() < 4 {
        return format!("something is switched {at}: the zero changes by {by}");
    }
    if unit == "1" {
        let by = percent_with_sd(change.value, change.sd);
        return format!("something is switched {at}: the gain changes by {by}");
    }
    let old = before.map_or(0.0, |before| before.value);
    let told = |value: f64| {
        if value.abs() < NONE * change.value.abs() {
            format!("about none ({})", rounded(value, unit))
        } else {
            rounded(value, unit)
        }
    };
    format!(
        "something is switched {at}: the coefficient of {of} is {} before and {} after it (change {by})",
        told(old),
        told(old + change.value)
    )
}

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
        let switch = Switch { of: Of::Temperature, change: 0.3, when_s: 50.0, takes_s: 4.0, jump: -4.0 };
        switch.readout(&drive, &Readout { zero: 0.0, span: 1.0 }, &mut value);
        let wanted = [5.0, 5.0, 5.0 + 0.3 - 1.2, 5.0 + 1.5 - 1.2];
        value.iter().zip(wanted).for_each(|(v, w)| approx::assert_abs_diff_eq!(*v, w, epsilon = 1e-12));
    }
}
