//! Physical directions along which a mismatch may lie: columns made of the inputs alone.
//!
//! Limits: smooth in the inputs, so that they see any library effect but fit none of them exactly.

use crate::{
    data::context::load_column,
    effects::memory::{first_order_lag, play, running_maximum},
    stats::spread,
};
use std::borrow::Cow;
use truegap_core::{Inputs, Simulator};

/// What a direction depends on; wording and grouping follow it.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord)]
pub enum Driver {
    /// size of the load
    Load,
    /// temperature
    Temperature,
    /// load times temperature
    LoadAndTemperature,
    /// going up or down in load
    LoadDirection,
    /// heating or cooling
    TemperatureDirection,
    /// how long the load has been there
    LoadHistory,
    /// how fast the load changes
    LoadRate,
    /// how long the temperature has been there
    TemperatureHistory,
    /// greatest load so far
    GreatestLoad,
    /// clock
    Clock,
    /// run
    Run,
    /// relative humidity
    Humidity,
    /// size of somebody else's simulation, and its way
    Simulated(Aspect),
    /// column of this number among the recorded drivers
    Recorded(usize, Aspect),
}

/// What of a recorded column a direction depends on.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord)]
pub enum Aspect {
    /// its value
    Size,
    /// rising or falling
    Direction,
    /// how fast it changes
    Rate,
    /// how long it has been there
    History,
}

impl Aspect {
    /// What a reader would call it, for a column of this name.
    fn says(self, name: &str) -> String {
        match self {
            Self::Size => format!("with {name}"),
            Self::Direction => format!("between rising and falling {}", name.trim_start_matches("the ")),
            Self::Rate => format!("with the speed of {name}"),
            Self::History => format!("with the time since {name} changed"),
        }
    }
}

impl Driver {
    /// Name of the column that orders it.
    pub fn column(self, inputs: &Inputs) -> Cow<'_, str> {
        Cow::Borrowed(match self {
            Self::Load
            | Self::LoadAndTemperature
            | Self::LoadDirection
            | Self::LoadHistory
            | Self::LoadRate
            | Self::GreatestLoad => "load",
            Self::Temperature | Self::TemperatureDirection | Self::TemperatureHistory => "temperature_c",
            Self::Clock => "time_s",
            Self::Run => "run",
            Self::Humidity => "humidity_pct",
            Self::Simulated(_) => "simulated",
            Self::Recorded(index, _) => return inputs.drivers.get(index).map_or("driver".into(), |d| d.name.as_str().into()),
        })
    }

    /// What a reader would call it.
    pub fn says(self, inputs: &Inputs) -> String {
        let words = match self {
            Self::Load => "with the size of the load",
            Self::Temperature if !is_loaded(inputs) => "with temperature",
            Self::Temperature => "with temperature, also without load",
            Self::LoadAndTemperature => "with load and temperature together",
            Self::LoadDirection => "between loading and unloading",
            Self::TemperatureDirection => "between heating and cooling",
            Self::LoadHistory => "with the time that a load has been held",
            Self::LoadRate => "with the speed of the load",
            Self::TemperatureHistory => "with the time since the temperature changed",
            Self::GreatestLoad => "with the greatest load so far",
            Self::Clock => "with the clock",
            Self::Run => "from run to run",
            Self::Humidity => "with humidity",
            Self::Simulated(aspect) => return aspect.says("the simulated value"),
            Self::Recorded(_, aspect) => return aspect.says(&self.column(inputs)),
        };
        words.to_owned()
    }
}

/// Whether anything was recorded that a reader would call a load.
fn is_loaded(inputs: &Inputs) -> bool {
    inputs.force_n.is_some() || inputs.pressure_pa.is_some() || inputs.gap_m.is_some()
}

/// One direction.
pub struct Direction {
    /// what it depends on
    pub driver: Driver,
    /// one entry a row
    pub column: Vec<f64>,
}

/// All directions that these inputs excite; those of each recording, where there are several, and one from recording to recording.
pub fn directions(inputs: &Inputs, simulator: &dyn Simulator) -> Vec<Direction> {
    let Some(joined) = simulator.joined() else { return of_one(inputs, simulator) };
    let mut list = Vec::new();
    for index in 0..joined.count() {
        let rows = joined.rows(index, inputs);
        let mut own = of_one(&joined.inputs(index, inputs), joined.model(index));
        if index > 0 {
            own.push(Direction { driver: Driver::Run, column: vec![1.0; rows.len()] });
        }
        for Direction { driver, column } in own {
            let mut whole = vec![0.0; inputs.len()];
            whole[rows.clone()].copy_from_slice(&column);
            push(&mut list, driver, whole);
        }
    }
    list
}

fn of_one(inputs: &Inputs, simulator: &dyn Simulator) -> Vec<Direction> {
    let mut list = Vec::new();
    let load = load_column(inputs, simulator).filter(|l| spread(l) > 1e-3);
    let warm = inputs.temperature_c.as_ref().filter(|t| spread(t) > 0.3).map(|t| unit(t));
    if let Some(load) = &load {
        mechanical(inputs, &unit(load), &mut list);
    }
    if let Some(warm) = &warm {
        thermal(inputs, warm, &mut list);
    }
    if let (Some(load), Some(warm)) = (&load, &warm) {
        let load = unit(load);
        for (i, j) in [(1, 1), (2, 1), (1, 2), (3, 1), (2, 2)] {
            push(&mut list, Driver::LoadAndTemperature, zip(&load, warm, |l, w| l.powi(i) * legendre(j, w)));
        }
    }
    for (index, driver) in inputs.drivers.iter().enumerate() {
        followed(inputs, &driver.values, |aspect| Driver::Recorded(index, aspect), &mut list);
    }
    if let (None, Some(simulated)) = (&load, &inputs.simulated) {
        followed(inputs, simulated, Driver::Simulated, &mut list);
    }
    surroundings(inputs, &mut list);
    list
}

fn mechanical(inputs: &Inputs, load: &[f64], list: &mut Vec<Direction>) {
    for order in 1..=5 {
        push(list, Driver::Load, map(load, |l| legendre(order, 2.0 * l - 1.0)));
    }
    push(list, Driver::Load, map(load, |l| (-l / 0.05).exp()));
    let held = play(inputs, 0.04, load, |_| 0.0);
    let up = zip(load, &held, |l, h| (l - h) / 0.04);
    for order in 0..=2 {
        push(list, Driver::LoadDirection, zip(&up, load, |u, l| u * l.powi(order)));
    }
    let greatest = running_maximum(load);
    push(list, Driver::GreatestLoad, zip(&greatest, load, |g, l| g * l));
    push(list, Driver::GreatestLoad, zip(&greatest, load, |g, l| (g - l).max(0.0) * l));
    if let Some(times) = time_scales(inputs) {
        for tau in times {
            let mut late = load.to_vec();
            first_order_lag(inputs, tau, &mut late, |_| 0.0);
            push(list, Driver::LoadHistory, zip(load, &late, |l, m| l - m));
        }
        push(list, Driver::LoadRate, rate(inputs, load));
    }
}

fn thermal(inputs: &Inputs, warm: &[f64], list: &mut Vec<Direction>) {
    for order in 1..=4 {
        push(list, Driver::Temperature, map(warm, |w| legendre(order, 2.0 * w - 1.0)));
    }
    let held = play(inputs, 0.08, warm, |first| first);
    push(list, Driver::TemperatureDirection, zip(warm, &held, |w, h| (w - h) / 0.08));
    push(list, Driver::TemperatureDirection, zip(warm, &held, |w, h| (w - h) / 0.08 * w));
    if let Some(times) = time_scales(inputs) {
        for tau in times.into_iter().skip(1) {
            let mut late = warm.to_vec();
            first_order_lag(inputs, tau, &mut late, |first| first);
            push(list, Driver::TemperatureHistory, zip(warm, &late, |w, m| w - m));
        }
    }
}

/// Size, way, speed and history of a recorded column that physics may follow.
fn followed(inputs: &Inputs, column: &[f64], driver: impl Fn(Aspect) -> Driver, list: &mut Vec<Direction>) {
    if spread(column) <= 0.0 {
        return;
    }
    let x = unit(column);
    for order in 1..=4 {
        push(list, driver(Aspect::Size), map(&x, |x| legendre(order, 2.0 * x - 1.0)));
    }
    let held = play(inputs, 0.04, &x, |first| first);
    let way = zip(&x, &held, |x, h| (x - h) / 0.04);
    for order in 0..=1 {
        push(list, driver(Aspect::Direction), zip(&way, &x, |w, x| w * x.powi(order)));
    }
    if let Some(times) = time_scales(inputs) {
        for tau in times {
            let mut late = x.clone();
            first_order_lag(inputs, tau, &mut late, |first| first);
            push(list, driver(Aspect::History), zip(&x, &late, |x, l| x - l));
        }
        push(list, driver(Aspect::Rate), rate(inputs, &x));
    }
}

fn surroundings(inputs: &Inputs, list: &mut Vec<Direction>) {
    if let Some(time) = &inputs.time_s {
        let clock = unit(time);
        for order in 1..=3 {
            push(list, Driver::Clock, map(&clock, |t| legendre(order, 2.0 * t - 1.0)));
        }
    }
    let runs = inputs.runs();
    if runs.len() <= 40 {
        for run in runs.iter().skip(1) {
            let mut column = vec![0.0; inputs.len()];
            column[run.clone()].fill(1.0);
            push(list, Driver::Run, column);
        }
    }
    if let Some(humidity) = inputs.humidity_pct.as_ref().filter(|h| spread(h) > 0.5) {
        let wet = unit(humidity);
        push(list, Driver::Humidity, wet.clone());
        push(list, Driver::Humidity, map(&wet, |w| legendre(2, 2.0 * w - 1.0)));
        if let Some(times) = time_scales(inputs) {
            let mut late = wet.clone();
            first_order_lag(inputs, times[times.len() - 1], &mut late, |first| first);
            push(list, Driver::Humidity, zip(&wet, &late, |a, b| a - b));
        }
    }
}

/// Five time constants from the shortest step to the longest run; `None` without a clock.
fn time_scales(inputs: &Inputs) -> Option<Vec<f64>> {
    let time = inputs.time_s.as_ref()?;
    let shortest = inputs.steps_s().into_iter().filter(|s| *s > 0.0).fold(f64::INFINITY, f64::min);
    let longest = inputs.runs().iter().map(|r| time[r.end - 1] - time[r.start]).fold(0.0, f64::max);
    let ratio = (longest / shortest).max(2.0);
    shortest.is_finite().then(|| (0..5).map(|k| shortest * ratio.powf((f64::from(k) + 0.7) / 5.5)).collect())
}

/// Change per second.
fn rate(inputs: &Inputs, load: &[f64]) -> Vec<f64> {
    let steps = inputs.steps_s();
    let mut rate = vec![0.0; load.len()];
    for row in 1..load.len() {
        if steps[row] > 0.0 {
            rate[row] = (load[row] - load[row - 1]) / steps[row];
        }
    }
    rate
}

fn push(list: &mut Vec<Direction>, driver: Driver, column: Vec<f64>) {
    if spread(&column) > 1e-9 {
        list.push(Direction { driver, column });
    }
}

fn map(x: &[f64], f: impl Fn(f64) -> f64) -> Vec<f64> {
    x.iter().map(|v| f(*v)).collect()
}

fn zip(x: &[f64], y: &[f64], f: impl Fn(f64, f64) -> f64) -> Vec<f64> {
    x.iter().zip(y).map(|(a, b)| f(*a, *b)).collect()
}

/// The column moved and scaled onto 0 to 1.
fn unit(x: &[f64]) -> Vec<f64> {
    let low = x.iter().copied().fold(f64::INFINITY, f64::min);
    let width = spread(x).max(1e-300);
    map(x, |v| (v - low) / width)
}

/// Legendre polynomial by its recurrence.
///
/// **Source:** NIST Digital Library of Mathematical Functions, section 18.9(i).
fn legendre(order: i32, x: f64) -> f64 {
    let (mut before, mut now) = (1.0, x);
    if order == 0 {
        return before;
    }
    for k in 1..order {
        let k = f64::from(k);
        (before, now) = (now, ((2.0 * k + 1.0) * x * now - k * before) / (k + 1.0));
    }
    now
}
