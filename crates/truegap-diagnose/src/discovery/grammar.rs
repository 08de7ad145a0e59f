//! Every sentence that a recording could support, with a grid of its numbers and its prior probability.
//!
//! A word costs what it is worth beforehand: places, actions, drivers, kinetics and forms share one each, the numbers of a grid share what their sentence is
//! worth. A plain law at once is likelier than a bent one that remembers.
//!
//! Limits: grids of half to one decade a step; the fit that follows moves the numbers freely.

use crate::effects::composed::{
    mechanism::{Numbers, Sentence, Sum},
    words::{Action, Driver, Form, Kinetics, Quantity},
};

/// What is known of a driver's course.
#[derive(Clone, Debug)]
pub struct Range {
    /// the driver
    pub driver: Driver,
    /// least value
    pub low: f64,
    /// greatest value
    pub high: f64,
    /// its usual size, for a rate: exceeded in one row of ten
    pub usual: f64,
    /// what it is of a turn, where it is an angle
    pub angle: Option<Angle>,
}

/// An angle that covers most of a turn.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Angle {
    /// a whole turn, driver's unit
    pub turn: f64,
    /// whether its number begins anew after each turn, so that it neither rises nor falls
    pub round: bool,
}

/// Clock of a recording.
#[derive(Clone, Debug, Default)]
pub struct Times {
    /// shortest step, s; 0 without a clock
    pub step_s: f64,
    /// from first to last row, s
    pub duration_s: f64,
    /// moments at which something may happen, s
    pub moments_s: Vec<f64>,
    /// periods that stand out in what is left, s
    pub periods_s: Vec<f64>,
}

/// A law of one driver with the grid of its numbers; the quantity in it stands for any.
#[derive(Clone, Debug)]
pub struct Law {
    /// words
    pub sentence: Sentence,
    /// grid
    pub grid: Vec<Numbers>,
    /// log of what driver, kinetics and form are worth beforehand
    pub log_prior: f64,
}

/// Share of a kinetics among those of one driver, before they are made to add up to 1.
fn share(kinetics: Kinetics) -> f64 {
    match kinetics {
        Kinetics::Static => 0.35,
        Kinetics::FirstOrder => 0.2,
        Kinetics::RateIndependent | Kinetics::Accumulating => 0.15,
        Kinetics::Event | Kinetics::Periodic => 0.075,
    }
}

/// Factor of a law that is not in proportion.
const BENT: f64 = 0.5;
/// Steps of a grid of time constants, as a factor.
const TAU_STEP: f64 = 2.2;
/// Shares of a range at which a threshold may lie.
const LEVELS: [f64; 7] = [0.125, 0.25, 0.375, 0.5, 0.625, 0.75, 0.875];
const FEW_LEVELS: [f64; 3] = [0.25, 0.5, 0.75];
/// Phases of a period; half a turn is the other sign.
const PHASES: usize = 4;

/// The laws of all drivers. Load and what is left of a load are one driver with two names, and share what one is worth.
pub fn laws(ranges: &[Range], times: &Times) -> Vec<Law> {
    let each: Vec<(bool, Vec<Weighed>)> = ranges.iter().map(|range| (is_load(&range.driver), of_driver(range, times))).collect();
    let total = |laws: &[Weighed]| laws.iter().map(|(_, _, worth)| worth).sum::<f64>();
    let of_load: f64 = each.iter().filter(|(load, _)| *load).map(|(_, own)| total(own)).sum();
    let drivers = each.iter().filter(|(load, _)| !load).count() + usize::from(of_load > 0.0);
    let mut all = Vec::new();
    for (load, own) in each {
        let whole = if load { of_load } else { total(&own) };
        let worth = |worth: f64| (worth / whole / drivers as f64).ln();
        all.extend(own.into_iter().map(|(sentence, grid, w)| Law { log_prior: worth(w), sentence, grid }));
    }
    all
}

fn is_load(driver: &Driver) -> bool {
    matches!(driver, Driver::Load | Driver::LoadHistory)
}

type Weighed = (Sentence, Vec<Numbers>, f64);

fn plain(driver: &Driver, kinetics: Kinetics, form: Form) -> Sentence {
    let (quantity, action) = (Quantity::Reading, Action::Adds);
    Sentence { quantity, action, driver: driver.clone(), kinetics, form, even: false, below: false, passing: false, sum: None }
}

fn of_driver(range: &Range, times: &Times) -> Vec<Weighed> {
    let mut laws = match (&range.driver, range.driver.is_rate(), range.angle) {
        (Driver::Time, ..) => of_time(times),
        (_, true, _) => of_rate(range, times),
        (_, _, Some(angle)) if angle.round => of_turn(&range.driver, angle.turn),
        _ => of_course(range, times),
    };
    laws.retain(|(_, grid, _)| !grid.is_empty());
    // the members of one kinetics share what it is worth, a bent one half as much as a straight one
    let kinds: Vec<(Kinetics, f64)> = laws.iter().map(|(s, _, worth)| (s.kinetics, *worth)).collect();
    for (sentence, _, worth) in &mut laws {
        let all: f64 = kinds.iter().filter(|(kinetics, _)| *kinetics == sentence.kinetics).map(|(_, worth)| worth).sum();
        *worth *= share(sentence.kinetics) / all;
    }
    laws
}

/// Laws of a form on a range: the grid of a form, 1 where it is in proportion.
fn forms(range: &Range, levels: &[f64]) -> Vec<(Form, bool, Vec<Numbers>, f64)> {
    let (low, span) = (range.low, range.high - range.low);
    let of = |number: &dyn Fn(f64) -> Numbers, shares: &[f64]| shares.iter().map(|s| number(*s)).collect::<Vec<_>>();
    let threshold = of(&|s| Numbers { threshold: low + s * span, scale: span, ..Numbers::default() }, levels);
    let scales = of(&|s| Numbers { scale: s * span, ..Numbers::default() }, &[0.1, 0.3, 1.0]);
    let powers = of(&|exponent| Numbers { exponent, ..Numbers::default() }, &[0.5, 2.0, 3.0]);
    vec![
        (Form::Linear, false, vec![Numbers::default()], 1.0),
        (Form::Power, false, powers, BENT),
        (Form::Threshold, false, threshold.clone(), BENT),
        (Form::Threshold, true, threshold, BENT),
        (Form::Saturating, false, scales, BENT),
    ]
}

/// Load, temperature, reading, a recorded column.
fn of_course(range: &Range, times: &Times) -> Vec<Weighed> {
    let d = &range.driver;
    let span = range.high - range.low;
    let mut laws: Vec<Weighed> = Vec::new();
    if *d != Driver::LoadHistory {
        for (form, below, grid, worth) in forms(range, &LEVELS) {
            laws.push((Sentence { below, ..plain(d, Kinetics::Static, form) }, grid, worth));
        }
        if range.low < 0.0 && range.high > 0.0 {
            let square = vec![Numbers { exponent: 2.0, ..Numbers::default() }, Numbers { exponent: 1.0, ..Numbers::default() }];
            laws.push((Sentence { even: true, ..plain(d, Kinetics::Static, Form::Power) }, square, BENT));
        }
        for (form, below, grid, worth) in forms(range, &FEW_LEVELS)
            .into_iter()
            .filter(|(form, below, _, _)| matches!(form, Form::Linear | Form::Power | Form::Threshold) && !below)
        {
            laws.push((Sentence { below, ..plain(d, Kinetics::FirstOrder, form) }, late(&grid, times), worth));
        }
        if matches!(d, Driver::Load | Driver::Temperature | Driver::Reading) {
            // the base model follows these at once: what is late takes the place of that
            let passing = Sentence { passing: true, ..plain(d, Kinetics::FirstOrder, Form::Linear) };
            laws.push((passing, late(&[Numbers::default()], times), 1.0));
        }
        let widths = [0.01, 0.03, 0.1, 0.3].map(|s| Numbers { width: s * span, ..Numbers::default() }).to_vec();
        laws.push((plain(d, Kinetics::RateIndependent, Form::Linear), widths, 1.0));
        match range.angle {
            Some(angle) => laws.extend(of_turn(d, angle.turn)),
            None => laws.push((plain(d, Kinetics::Periodic, Form::Linear), periods(span, &HARMONICS), 1.0)),
        }
        if matches!(d, Driver::Recorded(_)) && range.angle.is_none() {
            laws.push((plain(d, Kinetics::Static, Form::Peak), peaks(range.low, span, 0.0), BENT));
        }
    }
    if *d != Driver::Load {
        laws.extend(accumulating(range, times));
        let level = |s: f64| Numbers { threshold: range.low + s * span, scale: span, ..Numbers::default() };
        laws.push((plain(d, Kinetics::Event, Form::Linear), LEVELS.map(level).to_vec(), 1.0));
    }
    laws
}

/// Periods of a range, as so many to the range: fewer than three are a bent course and no period.
const HARMONICS: [f64; 10] = [3.0, 4.0, 5.0, 6.0, 8.0, 12.0, 16.0, 24.0, 32.0, 48.0];

fn periods(span: f64, counts: &[f64]) -> Vec<Numbers> {
    let phase = |k: usize| std::f64::consts::PI * k as f64 / PHASES as f64;
    let of = |count: f64| (0..PHASES).map(move |k| Numbers { period: span / count, phase: phase(k), ..Numbers::default() });
    if span > 0.0 { counts.iter().flat_map(|count| of(*count)).collect() } else { Vec::new() }
}

/// Laws that are the same again after a turn: waves of a whole part of it, and a peak about one direction.
fn of_turn(driver: &Driver, turn: f64) -> Vec<Weighed> {
    let waves = periods(turn, &PARTS_OF_A_TURN).into_iter().map(|numbers| Numbers { turn, ..numbers }).collect();
    vec![
        (plain(driver, Kinetics::Periodic, Form::Linear), waves, 1.0),
        (plain(driver, Kinetics::Static, Form::Peak), peaks(0.0, turn, turn), 1.0),
    ]
}

/// Waves to a turn.
const PARTS_OF_A_TURN: [f64; 8] = [1.0, 2.0, 3.0, 4.0, 5.0, 6.0, 8.0, 12.0];
/// Half widths of a peak, as shares of a range, each with its places so near to one another that none lies between two.
const PEAKS: [f64; 3] = [0.02, 0.05, 0.12];

fn peaks(low: f64, span: f64, turn: f64) -> Vec<Numbers> {
    let of = |share: f64| {
        let places = (0.5 / share).ceil() as usize;
        let at = move |k: usize| low + span * (k as f64 + 0.5) / places as f64;
        (0..places).map(move |k| Numbers { threshold: at(k), scale: share * span, turn, ..Numbers::default() })
    };
    PEAKS.into_iter().flat_map(of).collect()
}

/// What adds up: each sum in proportion, by a root and levelling off.
fn accumulating(range: &Range, times: &Times) -> Vec<Weighed> {
    let span = range.high - range.low;
    let sums = [(Sum::Greatest, span), (Sum::Path, 20.0 * span), (Sum::Dose, span * times.duration_s)];
    let mut laws = Vec::new();
    for (sum, whole) in sums.into_iter().filter(|(_, whole)| *whole > 0.0) {
        let of = |form: Form| Sentence { sum: Some(sum), ..plain(&range.driver, Kinetics::Accumulating, form) };
        let scales = [0.01, 0.1, 0.5].map(|s| Numbers { scale: s * whole, ..Numbers::default() }).to_vec();
        laws.push((of(Form::Linear), vec![Numbers::default()], 1.0));
        laws.push((of(Form::Power), vec![Numbers { exponent: 0.5, ..Numbers::default() }], BENT));
        laws.push((of(Form::Saturating), scales, BENT));
    }
    laws
}

/// A rate: 0 at rest, with a sign.
fn of_rate(range: &Range, times: &Times) -> Vec<Weighed> {
    let d = &range.driver;
    let scales = [0.02, 0.1, 0.5].map(|s| Numbers { scale: s * range.usual, ..Numbers::default() }).to_vec();
    let beyond = |s: f64| Numbers { threshold: s * range.usual, scale: range.usual, ..Numbers::default() };
    let powers = |exponents: &[f64]| exponents.iter().map(|e| Numbers { exponent: *e, ..Numbers::default() }).collect::<Vec<_>>();
    let mut laws: Vec<Weighed> = Vec::new();
    for even in [false, true] {
        let of = |kinetics: Kinetics, form: Form| Sentence { even, ..plain(d, kinetics, form) };
        laws.push((of(Kinetics::Static, Form::Linear), vec![Numbers::default()], 1.0));
        laws.push((of(Kinetics::Static, Form::Power), powers(&[0.5, 2.0]), BENT));
        laws.push((of(Kinetics::Static, Form::Saturating), scales.clone(), BENT));
        laws.push((of(Kinetics::FirstOrder, Form::Linear), late(&[Numbers::default()], times), 1.0));
    }
    let dead_zone = Sentence { even: true, ..plain(d, Kinetics::Static, Form::Threshold) };
    laws.push((dead_zone, [0.05, 0.2, 0.6].map(beyond).to_vec(), BENT));
    laws
}

/// Time itself.
fn of_time(times: &Times) -> Vec<Weighed> {
    let d = &Driver::Time;
    let range = Range { driver: Driver::Time, low: 0.0, high: times.duration_s, usual: times.duration_s, angle: None };
    let mut laws: Vec<Weighed> = Vec::new();
    for (form, below, grid, worth) in forms(&range, &LEVELS).into_iter().filter(|(_, below, _, _)| !below) {
        laws.push((Sentence { below, ..plain(d, Kinetics::Static, form) }, grid, worth));
    }
    laws.push((plain(d, Kinetics::FirstOrder, Form::Linear), late(&[Numbers::default()], times), 1.0));
    let moments = times.moments_s.iter().map(|t| Numbers { threshold: *t, ..Numbers::default() }).collect();
    laws.push((plain(d, Kinetics::Event, Form::Linear), moments, 1.0));
    let tones = times.periods_s.iter().flat_map(|p| periods(*p, &[1.0])).collect();
    laws.push((plain(d, Kinetics::Periodic, Form::Linear), tones, 1.0));
    laws
}

/// The same numbers with every time constant from half a step to the whole recording; none without a clock.
fn late(grid: &[Numbers], times: &Times) -> Vec<Numbers> {
    if times.step_s <= 0.0 || times.duration_s <= 0.0 {
        return Vec::new();
    }
    let mut all = Vec::new();
    let mut tau_s = 0.5 * times.step_s;
    while tau_s < times.duration_s {
        all.extend(grid.iter().map(|numbers| Numbers { tau_s, ..*numbers }));
        tau_s *= TAU_STEP;
    }
    all
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn what_all_laws_are_worth_adds_up_to_one_with_every_word_among_them() {
        let range = |driver: Driver, low: f64| Range { driver, low, high: 1.0, usual: 0.1, angle: None };
        let drivers = [Driver::Load, Driver::LoadHistory, Driver::LoadRate, Driver::Temperature, Driver::Time];
        let ranges: Vec<Range> = drivers.iter().map(|d| range(d.clone(), if d.is_rate() { -1.0 } else { 0.0 })).collect();
        let times = Times { step_s: 0.1, duration_s: 600.0, moments_s: vec![100.0, 300.0], periods_s: vec![50.0] };
        let laws = laws(&ranges, &times);
        let total: f64 = laws.iter().map(|law| law.log_prior.exp()).sum();
        approx::assert_abs_diff_eq!(total, 1.0, epsilon = 1e-12);
        use Kinetics::*;
        for kinetics in [Static, FirstOrder, RateIndependent, Accumulating, Event, Periodic] {
            assert!(laws.iter().any(|law| law.sentence.kinetics == kinetics), "{kinetics:?}");
        }
    }

    /// Static is 0.35 of what a driver is worth that has all six kinetics, what adds up 0.15.
    #[test]
    fn a_load_and_its_history_are_one_driver() {
        let range = |driver: Driver| Range { driver, low: 0.0, high: 1.0, usual: 0.1, angle: None };
        let times = Times { step_s: 0.1, duration_s: 600.0, moments_s: Vec::new(), periods_s: Vec::new() };
        let laws = laws(&[Driver::Load, Driver::LoadHistory, Driver::Temperature].map(range), &times);
        let worth = |of: &dyn Fn(&Sentence) -> bool| {
            laws.iter().filter(|law| of(&law.sentence)).map(|law| law.log_prior.exp()).sum::<f64>()
        };
        let close = |found: f64, known: f64| approx::assert_abs_diff_eq!(found, known, epsilon = 1e-12);
        close(worth(&|s| s.driver == Driver::Temperature), 0.5);
        close(worth(&|s| s.driver == Driver::Load && s.kinetics == Kinetics::Static), 0.35 / 2.0);
        close(worth(&|s| s.driver == Driver::LoadHistory && s.kinetics == Kinetics::Accumulating), 0.15 / 2.0);
    }

    /// The base model follows these at once: what is late behind them may take the place of that.
    #[test]
    fn what_the_base_model_follows_may_be_late_in_its_place() {
        let range = |driver: Driver| Range { driver, low: 0.0, high: 1.0, usual: 0.1, angle: None };
        let times = Times { step_s: 0.1, duration_s: 600.0, moments_s: Vec::new(), periods_s: Vec::new() };
        let laws =
            laws(&[Driver::Load, Driver::Temperature, Driver::Reading, Driver::Recorded("supply".into())].map(range), &times);
        let in_its_place = laws.iter().filter(|law| law.sentence.passing).map(|law| law.sentence.driver.word());
        assert_eq!(in_its_place.collect::<Vec<_>>(), ["load", "temperature", "reading"]);
    }

    #[test]
    fn without_a_clock_nothing_is_late() {
        let range = Range { driver: Driver::Load, low: 0.0, high: 1.0, usual: 1.0, angle: None };
        assert!(laws(&[range], &Times::default()).iter().all(|law| law.sentence.kinetics != Kinetics::FirstOrder));
    }
}
