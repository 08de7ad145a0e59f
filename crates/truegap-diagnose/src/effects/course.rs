//! What drives a reading, as a column that friction and the like follow: a recorded driver, the load, the gap, a simulation.
//!
//! Limits: one column; a second driver is followed by a second effect of the kind.

use crate::{
    data::{
        context::{Context, load_column},
        moved::{HUMIDITY, follows},
    },
    effects::{composed::words::Driver, memory::walk},
    stats::{median, spread},
};
use std::borrow::Cow;
use truegap_core::{Drive, Inputs, Parameter, Simulator, ends};

/// Range of the load from which on it drives a reading, full loads.
const LOADED: f64 = 0.05;

/// Part of its range by which a column must rise, and fall, so that the two ways can be told.
const TURNED: f64 = 0.1;

/// Part of its range that a column goes there and back so that a loop from end to end can be seen.
const THERE_AND_BACK: f64 = 0.5;

/// Mean step from row to row of a sweep without a clock, in ranges: a table of mixtures, sorted in part, takes larger ones (0.08 to 0.3 in eight of others' tables; a magnet's loop 0.007).
const OF_A_SWEEP: f64 = 0.03;

/// Greatest rise and greatest fall of a column, over any stretch of it.
fn farthest(column: &[f64]) -> [f64; 2] {
    let (mut low, mut high) = (column[0], column[0]);
    column.iter().fold([0.0f64; 2], |[up, down], value| {
        (low, high) = (low.min(*value), high.max(*value));
        [up.max(value - low), down.max(high - value)]
    })
}

/// Part of its range that a column goes from row to row, at most, in half of the rows, so that rows in order are a way.
const A_STEP: f64 = 0.1;

/// Share of the steps of a way that go back on the step before, at most. Of 50 recordings without a clock, loops and sweeps have 0 to 0.1; tables, logs of a well and rows of pixels 0.33 to 0.75: what depends on the
/// way there cannot be told from what lasts from row to row.
const GOES_BACK: f64 = 0.25;

/// Whether rows that follow one another are near one another and go on in one way for some rows: a table of set points in any order is no way.
pub(crate) fn is_a_way(column: &[f64], runs: &[std::ops::Range<usize>]) -> bool {
    let steps: Vec<f64> = runs.iter().flat_map(|run| column[run.clone()].windows(2)).map(|pair| pair[1] - pair[0]).collect();
    let moved: Vec<f64> = steps.iter().copied().filter(|step| *step != 0.0).collect();
    let back = moved.windows(2).filter(|pair| pair[0] * pair[1] < 0.0).count();
    let sizes: Vec<f64> = steps.into_iter().map(f64::abs).collect();
    median(&sizes) <= A_STEP * spread(column) && back as f64 <= GOES_BACK * moved.len() as f64
}

/// Part of its range that a sweep crosses, and how often it has to go the same way.
const SWEEPS: (f64, usize) = (0.35, 2);
/// The same of a column that goes up and down in small steps while it drifts once through its range.
const FLUCTUATIONS: (f64, usize) = (0.1, 8);

/// Whether a column sweeps up, or down, again and again: in [`SWEEPS`] or in [`FLUCTUATIONS`].
fn comes_again(column: &[f64], runs: &[std::ops::Range<usize>]) -> bool {
    let column = without_a_jump(column);
    [SWEEPS, FLUCTUATIONS].into_iter().any(|(share, often)| sweeps(&column, runs, share * spread(&column)) >= often)
}

/// Part of its range over which a column jumps where it is told from another datum from then on.
const A_JUMP: f64 = 0.5;

/// The column without its one jump, if one step is as large as [`A_JUMP`] of its range and no other is half as large: a stage that is told from another datum from then on moves about each as it did before.
pub(crate) fn without_a_jump(column: &[f64]) -> Cow<'_, [f64]> {
    let steps = || column.windows(2).map(|pair| pair[1] - pair[0]).enumerate();
    let Some((row, jump)) = steps().max_by(|a, b| a.1.abs().total_cmp(&b.1.abs())) else { return Cow::Borrowed(column) };
    let is_alone = || steps().all(|(other, step)| other == row || step.abs() < 0.5 * jump.abs());
    if jump.abs() < A_JUMP * spread(column) || !is_alone() {
        return Cow::Borrowed(column);
    }
    Cow::Owned(column.iter().enumerate().map(|(k, value)| if k > row { value - jump } else { *value }).collect())
}

/// How often a column goes the same way by at least so much.
fn sweeps(column: &[f64], runs: &[std::ops::Range<usize>], least: f64) -> usize {
    let mut sweeps = [0, 0];
    for run in runs {
        let (mut low, mut high, mut way) = (column[run.start], column[run.start], None);
        for value in &column[run.clone()] {
            (low, high) = (low.min(*value), high.max(*value));
            let now = if value - low >= least && way != Some(0) {
                0
            } else if high - value >= least && way != Some(1) {
                1
            } else {
                continue;
            };
            sweeps[now] += 1;
            (low, high, way) = (*value, *value, Some(now));
        }
    }
    sweeps[0].max(sweeps[1])
}

/// A column that moves a reading.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Course {
    /// the recorded driver of this number
    Driver(usize),
    /// recorded humidity, beside a base model without plates
    Humidity,
    /// load on the dielectric, in full loads
    Load,
    /// plate separation
    Gap,
    /// somebody else's simulation
    Simulated,
}

impl Course {
    /// The recorded driver of this number among those that moved; where none moved at all, number 0 stands for load, gap or simulation.
    ///
    /// `None` as well where it moved in the recording of a model file and these inputs do not have it.
    pub fn of(context: &Context<'_>, number: usize) -> Option<Self> {
        let moved = &context.moved;
        if let Some(name) = moved.drivers.get(number) {
            let recorded = context.inputs.drivers.iter().position(|driver| driver.name == *name).map(Self::Driver);
            let humidity = || (name == HUMIDITY && context.inputs.humidity_pct.is_some()).then_some(Self::Humidity);
            return recorded.or_else(humidity);
        }
        if number > 0 || !moved.drivers.is_empty() {
            return None;
        }
        if moved.load > LOADED {
            return Some(Self::Load);
        }
        [(moved.gap, Self::Gap), (moved.simulated, Self::Simulated)]
            .into_iter()
            .find_map(|(moves, course)| moves.then_some(course))
    }

    /// The same for an effect that is asked for its numbers: whether it could be shown at all is asked elsewhere, and the load stands for what is not there.
    pub fn or_load(context: &Context<'_>, number: usize) -> Self {
        Self::of(context, number).unwrap_or(Self::Load)
    }

    /// `Ok` where the driver of this number was recorded, moved, and the base model does not follow it by itself; `followed` says what there is instead where it does.
    ///
    /// # Errors
    /// The reason, for a reader.
    pub fn beside_the_base(context: &Context<'_>, number: usize, followed: &str) -> Result<(), String> {
        match Self::of(context, number) {
            Some(course) if course.is_followed(context) => Err(format!("the base model follows this driver by itself{followed}")),
            Some(Self::Driver(_) | Self::Humidity) => Ok(()),
            _ => Err(Self::missing(number)),
        }
    }

    /// Influence of the course on the reading, the size of an effect: as much as the whole reading over its range.
    pub fn influence(self, context: &Context<'_>, meaning: &str) -> Parameter {
        let unit = format!("{}/{}", context.simulator.unit(), self.unit(context));
        Parameter::normal("per_unit", &unit, 0.0, context.response_span.abs() / self.span(context), meaning)
    }

    /// Why there is no course of this number.
    pub fn missing(number: usize) -> String {
        let which = if number == 0 { "no driver" } else { "no second driver" };
        format!("{which} that moves was recorded; name one under [drivers]")
    }

    /// Whether the base model follows this recorded driver by itself: as it did where it was fitted, where that is known.
    pub fn is_followed(self, context: &Context<'_>) -> bool {
        let Some(name) = self.recorded_name(context) else { return false };
        if let Some(followed) = &context.moved.followed {
            return followed.iter().any(|other| other == name);
        }
        let ask = || follows(context.simulator, context.inputs, name, self.span(context));
        if let Self::Driver(index) = self { *context.followed[index].get_or_init(ask) } else { ask() }
    }

    /// Name of the recorded driver.
    fn recorded_name<'a>(self, context: &'a Context<'_>) -> Option<&'a str> {
        match self {
            Self::Driver(index) => context.inputs.drivers.get(index).map(|driver| driver.name.as_str()),
            Self::Humidity => Some(HUMIDITY),
            Self::Load | Self::Gap | Self::Simulated => None,
        }
    }

    /// The drivers that moved and that the base model follows by itself.
    fn of_the_base(context: &Context<'_>) -> impl Iterator<Item = Self> {
        let courses = (0..context.moved.drivers.len()).filter_map(|number| Self::of(context, number));
        courses.filter(|course| course.is_followed(context))
    }

    /// Their names.
    pub(crate) fn followed(context: &Context<'_>) -> Vec<String> {
        Self::of_the_base(context).filter_map(|course| course.recorded_name(context).map(str::to_owned)).collect()
    }

    /// The column whose course the base model follows, on a clock of its own: a load that moves, a gap, a simulation, else the first driver that the base model follows by itself.
    ///
    /// # Errors
    /// That nothing of this kind was recorded.
    pub fn on_a_clock(context: &Context<'_>) -> Result<Self, String> {
        if context.inputs.gap_m.is_some() {
            return Ok(Self::Gap);
        }
        if context.inputs.simulated.is_some() {
            return Ok(Self::Simulated);
        }
        let Err(why) = context.needs_load() else { return Ok(Self::Load) };
        Self::of_the_base(context).next().ok_or(why)
    }

    /// What it is in words.
    pub fn driver(self, context: &Context<'_>) -> Driver {
        match self {
            Self::Driver(index) => {
                Driver::Recorded(context.inputs.drivers.get(index).map(|d| d.name.clone()).unwrap_or_default())
            }
            Self::Humidity => Driver::Recorded(HUMIDITY.into()),
            Self::Load => Driver::Load,
            Self::Gap => Driver::Recorded("gap".into()),
            Self::Simulated => Driver::Reading,
        }
    }

    /// The column as the stages see it; `None` where it was not recorded.
    pub fn column<'a>(self, drive: &Drive<'a>) -> Option<&'a [f64]> {
        if self == Self::Load { Some(drive.load) } else { self.of_inputs(drive.inputs) }
    }

    /// The column of the inputs; `None` where it was not recorded, and of the load, which the base model makes of them.
    fn of_inputs(self, inputs: &Inputs) -> Option<&[f64]> {
        match self {
            Self::Driver(index) => inputs.drivers.get(index).map(|driver| driver.values.as_slice()),
            Self::Humidity => inputs.humidity_pct.as_deref(),
            Self::Load => None,
            Self::Gap => inputs.gap_m.as_deref(),
            Self::Simulated => inputs.simulated.as_deref(),
        }
    }

    /// Least and greatest value of a recorded driver, in the recording in which the effect was found; 0 and 1 of anything else.
    pub fn ends(self, context: &Context<'_>) -> [f64; 2] {
        let range = self.recorded_name(context).and_then(|name| context.moved.ranges.get(name));
        range.copied().unwrap_or([0.0, 1.0])
    }

    /// Middle between the ends of the column, in its unit: of a recorded driver, in the recording in which the effect was found.
    pub fn middle(self, context: &Context<'_>) -> f64 {
        if let Self::Driver(_) | Self::Humidity = self {
            let [least, greatest] = self.ends(context);
            return 0.5 * (least + greatest);
        }
        let (least, greatest) = self.recorded(context).map_or((0.0, 0.0), |column| ends(column.iter().copied()));
        0.5 * (least + greatest)
    }

    /// Range of the column, in its unit; 1 where it does not move.
    pub fn span(self, context: &Context<'_>) -> f64 {
        let range = match self {
            Self::Load => Some(context.load_span()),
            other => other.of_inputs(context.inputs).map(spread),
        };
        range.filter(|range| *range > 0.0).unwrap_or(1.0)
    }

    /// The column as it was recorded.
    pub fn recorded<'a>(self, context: &Context<'a>) -> Option<Cow<'a, [f64]>> {
        self.among(context.inputs, context.simulator)
    }

    /// The column among these inputs of a base model.
    pub fn among<'a>(self, inputs: &'a Inputs, simulator: &dyn Simulator) -> Option<Cow<'a, [f64]>> {
        match self {
            Self::Load => load_column(inputs, simulator).map(Cow::Owned),
            other => other.of_inputs(inputs).map(Cow::Borrowed),
        }
    }

    /// Whether the column goes up and down again inside the runs, by [`TURNED`] of its range each way.
    pub fn turns(self, context: &Context<'_>) -> bool {
        let inputs = context.inputs;
        let Some(column) = self.recorded(context) else { return false };
        if inputs.time_s.is_none() && !is_a_way(&column, &inputs.runs()) {
            return false;
        }
        let least = TURNED * self.span(context);
        let ways = inputs.runs().into_iter().map(|run| farthest(&column[run]));
        let most = ways.fold([0.0f64; 2], |most, [up, down]| [most[0].max(up), most[1].max(down)]);
        most.iter().all(|way| *way >= least)
    }

    /// Whether the column goes over [`THERE_AND_BACK`] of its range and back within one run; where there is no clock, in steps of a sweep.
    pub fn goes_and_returns(self, context: &Context<'_>) -> bool {
        let inputs = context.inputs;
        let Some(column) = self.recorded(context) else { return false };
        let (least, step) = (THERE_AND_BACK * self.span(context), OF_A_SWEEP * self.span(context));
        let swept = |run: &[f64]| {
            let path: f64 = run.windows(2).map(|pair| (pair[1] - pair[0]).abs()).sum();
            inputs.time_s.is_some() || path <= step * run.len() as f64
        };
        let there_and_back = |run: &[f64]| swept(run) && farthest(run).iter().all(|way| *way >= least);
        inputs.runs().into_iter().any(|run| there_and_back(&column[run]))
    }

    /// Whether the column goes the same way twice: a sweep over a loop, or runs that begin anew. Where it does not, what follows the way that it goes cannot be told from what happens in time.
    pub fn comes_again(self, context: &Context<'_>) -> bool {
        self.recorded(context).is_some_and(|column| comes_again(&column, &context.inputs.runs()))
    }

    /// Mean speed of the column, in its unit a second (a row without a clock).
    pub fn usual_speed(self, context: &Context<'_>) -> f64 {
        let inputs = context.inputs;
        let Some(column) = self.of_inputs(inputs) else { return 0.0 };
        let (mut way, mut time) = (0.0, 0.0);
        walk(inputs, |row, step| {
            if let Some(step) = step {
                way += (column[row] - column[row - 1]).abs();
                time += step;
            }
        });
        if time > 0.0 { way / time } else { 0.0 }
    }

    /// Unit of the column.
    pub fn unit(self, context: &Context<'_>) -> String {
        match self {
            Self::Driver(index) => context.inputs.drivers.get(index).map_or_else(|| "1".into(), |driver| driver.unit.clone()),
            Self::Humidity => "%".into(),
            Self::Load => "full loads".into(),
            Self::Gap => "m".into(),
            Self::Simulated => context.simulator.simulated_unit().into(),
        }
    }

    /// What a reader would call it.
    pub fn name<'a>(self, context: &Context<'a>) -> &'a str {
        match self {
            Self::Driver(index) => context.inputs.drivers.get(index).map_or("the driver", |driver| driver.name.as_str()),
            Self::Humidity => HUMIDITY,
            Self::Load => "the load",
            Self::Gap => "the gap",
            Self::Simulated => "the simulated value",
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_loop_goes_each_way_once_and_what_follows_it_goes_one_of_them_again() {
        let along = |ends: &[f64]| {
            let leg = |pair: &[f64]| (0..20).map(|k| pair[0] + (pair[1] - pair[0]) * f64::from(k) / 20.0).collect::<Vec<_>>();
            ends.windows(2).flat_map(leg).collect::<Vec<f64>>()
        };
        let once = |ends: &[f64]| {
            let column = along(ends);
            comes_again(&column, std::slice::from_ref(&(0..column.len())))
        };
        assert!(!once(&[0.0, 1.0]));
        assert!(!once(&[0.0, 1.0, 1.0, 0.0]));
        assert!(!once(&[0.3, 0.5, 0.4, 1.0, 0.0]));
        assert!(once(&[0.0, 1.0, 0.0, 1.0]));
        assert!(once(&[0.0, 1.0, 0.3, 0.9]));
        // it fluctuates while it drifts once through its range; noise that is as quick is no way that it goes
        let drifting =
            |size: f64| (0..400).map(|k| f64::from(k) / 400.0 + size * (f64::from(k) / 5.0).sin()).collect::<Vec<f64>>();
        let fluctuates = |size: f64| comes_again(&drifting(size), std::slice::from_ref(&(0..400)));
        assert!(fluctuates(0.1) && !fluctuates(0.02));
        // two runs, each up
        let column = along(&[0.0, 1.0, 0.0]);
        assert!(comes_again(&[&column[..20], &column[..20]].concat(), &[0..20, 20..40]));
    }

    #[test]
    fn a_column_with_another_datum_moves_as_it_did_before() {
        let level = |k: u32| 0.3 * (f64::from(k) / 20.0).sin();
        let column: Vec<f64> = (0..400).map(|k| level(k) + if k < 90 { 12.0 } else { 0.0 }).collect();
        assert!(comes_again(&column, std::slice::from_ref(&(0..400))));
        approx::assert_abs_diff_eq!(spread(&without_a_jump(&column)), 0.6, epsilon = 0.02);
        // a square wave has many
        let square: Vec<f64> = (0..400).map(|k| f64::from(k / 50 % 2)).collect();
        assert_eq!(*without_a_jump(&square), *square);
    }

    #[test]
    fn a_loop_is_a_way_and_a_log_of_a_well_is_none() {
        let one_run = |column: &[f64]| is_a_way(column, std::slice::from_ref(&(0..column.len())));
        let there_and_back: Vec<f64> = (0..200).map(|k| f64::from(100 - (k - 100i32).abs())).collect();
        assert!(one_run(&there_and_back));
        // steps of all sizes and both ways, each small beside the range
        let mut depth = 0.0;
        let log: Vec<f64> = (0..200)
            .map(|k| {
                depth += (f64::from(k) * 2.4).sin();
                depth + f64::from(k) / 10.0
            })
            .collect();
        assert!(!one_run(&log));
    }
}
