//! What a firmware can do about each added effect: hold it in a table, lag an input, undo a lag of the reading, or nothing.
//!
//! Limits: what an effect does is found by asking the running model along a trial history, so that an effect of another kind is left out and never corrected wrong.

use super::lags::Lags;
use crate::diagnosis::compensate::input::{Column, Sought, Way};
use crate::diagnosis::compensate::needed;
use crate::models::{LeftOut, Parted, RunningModel, corrected_for};
use truegap_core::{Inputs, Role, ends};
use truegap_diagnose::Library;
use truegap_diagnose::answer::AddedEffect;
use truegap_diagnose::mechanism::{Driver, Kinetics};

const MEMORY: &str = "it depends on what came before, by more than one time constant of an input or of the reading";
const NOT_LAST: &str = "it is no lag of the whole reading by one time constant: something acts behind it, or it has another law";
const SECOND_LAG: &str = "it is a second lag of the reading";
const NO_LAG: &str = "its time constant is 0";

/// Part of the range of the answers by which two differ.
const DIFFERS: f64 = 1e-6;

/// An input that comes late.
pub(super) struct LateInput {
    pub effect: AddedEffect,
    pub column: Column,
    pub lags: Lags,
}

/// A lag of the reading, the last that happens to it.
#[derive(Clone, Debug, PartialEq)]
pub(super) struct LagOfReading {
    pub id: String,
    pub tau_s: f64,
}

/// The added effects by what a firmware does about them.
pub(super) struct Sorted {
    /// those of the tables and those that lag an input, in the order of the chain; those that are marked as carried stay in the reading
    pub tabulated: Vec<AddedEffect>,
    pub late: Vec<LateInput>,
    pub lag: Option<LagOfReading>,
    pub left_out: Vec<LeftOut>,
}

impl Sorted {
    /// Ids of the effects for which a reading is corrected.
    pub fn corrected_for(&self) -> Vec<String> {
        corrected_for(&self.tabulated).chain(self.lag.iter().map(|lag| lag.id.clone())).collect()
    }

    fn leave_out(&mut self, added: &AddedEffect, why: &'static str) {
        self.tabulated.retain(|kept| kept != added);
        self.late.retain(|late| late.effect != *added);
        // what is only carried is named already
        if !added.carried {
            self.left_out.push(LeftOut { effect: added.id.clone(), why });
        }
    }
}

/// Sorts what `parted` keeps; `way` is how the base model gets its input.
pub(super) fn sorted(model: &RunningModel, parted: &Parted, way: &Way, library: &Library) -> Sorted {
    let trial = trial(model, way);
    let mut sorted = Sorted { tabulated: parted.kept.clone(), late: Vec::new(), lag: None, left_out: parted.left_out.clone() };
    let mut lag_of_reading = None;
    for added in &parted.kept {
        let words = model.words_of(library, added);
        match kind(model, added, words.as_ref(), &trial) {
            Kind::Static => {}
            Kind::Late(column, lags) if column.values(&trial).is_some() => {
                sorted.late.push(LateInput { effect: added.clone(), column, lags });
            }
            Kind::Late(..) | Kind::Memory => sorted.leave_out(added, MEMORY),
            // what is only carried stays in the reading
            Kind::OfReading if added.carried => sorted.leave_out(added, MEMORY),
            Kind::OfReading if lag_of_reading.is_some() => sorted.leave_out(added, SECOND_LAG),
            Kind::OfReading => {
                lag_of_reading = Some(added.clone());
                sorted.tabulated.retain(|kept| kept != added);
            }
        }
    }
    // one memory may show beside another effect alone, as one of the temperature beside a coefficient
    let is_late = |sorted: &Sorted, added: &AddedEffect| sorted.late.iter().any(|late| late.effect == *added);
    while !is_static(model, &without_late(&sorted), &trial) {
        let Some(last) = sorted.tabulated.iter().rev().find(|added| !is_late(&sorted, added)).cloned() else { break };
        sorted.leave_out(&last, MEMORY);
    }
    if let Some(added) = lag_of_reading {
        let tau_s = number(&added, "tau");
        let lag = LagOfReading { id: added.id.clone(), tau_s };
        match (tau_s > 0.0, is_last(model, &sorted.tabulated, &added, tau_s, &trial)) {
            (false, _) => sorted.leave_out(&added, NO_LAG),
            (true, false) => sorted.leave_out(&added, NOT_LAST),
            (true, true) => sorted.lag = Some(lag),
        }
    }
    sorted
}

impl Sorted {
    /// Leaves out the effects that lag an input where the whole does not go as their lags say.
    pub fn leave_out_late(&mut self) {
        let late: Vec<AddedEffect> = self.late.iter().map(|late| late.effect.clone()).collect();
        late.iter().for_each(|added| self.leave_out(added, MEMORY));
    }
}

/// What an effect is to a firmware.
enum Kind {
    Static,
    Late(Column, Lags),
    OfReading,
    Memory,
}

fn kind(model: &RunningModel, added: &AddedEffect, words: Option<&(Driver, Kinetics)>, trial: &Inputs) -> Kind {
    match (added.id.as_str(), words) {
        ("readout_lag" | "slow_response", _) => Kind::OfReading,
        ("thermal_lag", _) if lags_the_reading(model, added, trial) => Kind::OfReading,
        ("thermal_lag", _) => {
            let [tau, share, slower, first] = ["tau", "slow_share", "slower", "first_stage"].map(|name| number(added, name));
            Kind::Late(Column::Of(Role::Temperature), Lags::of_two(tau, share, slower, first))
        }
        ("late_driver" | "late_second_driver", Some((Driver::Recorded(name), _))) => {
            Kind::Late(column_of(name, trial), Lags::of_two(number(added, "tau"), 0.0, 1.0, 0.0))
        }
        (_, Some((_, kinetics))) if !matches!(kinetics, Kinetics::Static | Kinetics::Periodic) => Kind::Memory,
        _ if is_static(model, std::slice::from_ref(added), trial) => Kind::Static,
        _ => Kind::Memory,
    }
}

fn column_of(name: &str, trial: &Inputs) -> Column {
    match trial.drivers.iter().any(|driver| driver.name == name) || name != Role::Humidity.key() {
        true => Column::Driver(name.into()),
        false => Column::Of(Role::Humidity),
    }
}

/// A number of an effect by its name; 0 where it has none.
fn number(added: &AddedEffect, name: &str) -> f64 {
    added.parameters.iter().find(|p| p.name == name).map_or(0.0, |p| p.value)
}

/// A history of one run in which everything that the model was made with moves.
pub(super) fn trial(model: &RunningModel, way: &Way) -> Inputs {
    let sought: Option<&Sought> = if let Way::Estimated(sought) = way { Some(sought) } else { None };
    let mut trial = needed::trial(model, sought);
    let rows = trial.len();
    let simulator = model.simulator();
    if simulator.needs().contains(&Role::Temperature) && trial.temperature_c.is_none() {
        trial.temperature_c = Some(vec![simulator.reference_c(); rows]);
    }
    trial
}

/// Whether a lag shows at a temperature that stands still: the reading is late then, which is a temperature itself.
fn lags_the_reading(model: &RunningModel, added: &AddedEffect, trial: &Inputs) -> bool {
    let still = Inputs { temperature_c: trial.temperature_c.as_ref().map(|t| vec![t[0]; t.len()]), ..trial.clone() };
    let [with, without] = [std::slice::from_ref(added), &[]].map(|effects| model.respond_with(effects, &still).ok());
    with.zip(without).is_some_and(|(with, without)| differ(&with, &without))
}

/// Whether each row is answered by itself: the same in another order, with a past of its own.
pub(super) fn is_static(model: &RunningModel, effects: &[AddedEffect], trial: &Inputs) -> bool {
    let Ok(whole) = model.respond_with(effects, trial) else { return false };
    let rows = trial.len();
    let mut turned = trial.clone();
    for column in needed::columns(trial) {
        if column != Column::Of(Role::Time) {
            let values = column.values(trial).map(|values| values.iter().rev().copied().collect());
            column.put(&mut turned, values);
        }
    }
    turned.run = (1..).take(rows).collect();
    let Ok(mut apart) = model.respond_with(effects, &turned) else { return false };
    apart.reverse();
    !differ(&whole, &apart)
}

/// Whether two columns of answers differ by more than the last digits of their range.
pub(super) fn differ(a: &[f64], b: &[f64]) -> bool {
    let (low, high) = ends(a.iter().copied());
    let near = DIFFERS * (high - low) + f64::EPSILON * 64.0 * low.abs().max(high.abs());
    a.iter().zip(b).any(|(a, b)| (a - b).abs() > near || a.is_nan() || b.is_nan())
}

fn without_late(sorted: &Sorted) -> Vec<AddedEffect> {
    let is_late = |added: &&AddedEffect| sorted.late.iter().any(|late| late.effect == **added);
    sorted.tabulated.iter().filter(|added| !is_late(added)).cloned().collect()
}

/// Whether the model with the lag answers as the model without it, behind a lag of one time constant.
fn is_last(model: &RunningModel, before: &[AddedEffect], lag: &AddedEffect, tau_s: f64, trial: &Inputs) -> bool {
    let mut straight = lag.clone();
    // a true value that is held between rows is told apart by rows alone: what is undone is the same
    straight.parameters.iter_mut().filter(|p| p.name == "between_rows").for_each(|p| p.value = 0.0);
    let order = model.effects();
    let mut with: Vec<AddedEffect> = before.iter().cloned().chain([straight]).collect();
    with.sort_by_key(|added| order.iter().position(|id| *id == added.id));
    let answers = model.respond_with(&with, trial).ok().zip(model.respond_with(before, trial).ok());
    answers.is_some_and(|(with, without)| !differ(&with, &Lags::of_two(tau_s, 0.0, 1.0, 0.0).late(trial, &without)))
}
