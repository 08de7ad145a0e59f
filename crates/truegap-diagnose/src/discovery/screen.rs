//! Thousands of mechanisms weighed at once about a fit: the column of each, off what calibration can take up, against what is left.
//!
//! Limits: linear in the size about the fit; the numbers inside a mechanism lie on a grid.

use crate::{
    data::{
        angle::{begins_anew, turning},
        problem::Problem,
    },
    discovery::{
        grammar::{Angle, Law, Range, Times, laws},
        levers::{Lever, Seen, levers},
    },
    effects::{
        composed::{
            mechanism::{Numbers, Sentence},
            signal::{Courses, course, of_course, recorded},
            words::{Driver, Form, Kinetics, Place, Quantity},
        },
        course::{Course, is_a_way},
    },
    fit::{model::Model, optimum::Linearised},
    seeds::SEEDS,
    stats::{deviation, log_mean_exp, spread},
    whitening::whitener::Whitener,
};
use nalgebra::{DMatrix, DVector};
use rand::{RngExt, SeedableRng};
use rand_chacha::ChaCha8Rng;
use rayon::prelude::*;
use truegap_core::ends;

/// Lengths that the column of a mechanism may have, in units of the noise; its evidence is the mean over them.
const LENGTHS: [f64; 7] = [3.0, 8.0, 20.0, 50.0, 130.0, 350.0, 1000.0];
/// Share of a column's own length below which calibration is taken to absorb it.
const ABSORBED: f64 = 1e-6;
/// Turns of what is left against the histories, for the control.
const PERMUTATIONS: usize = 99;
/// Stretches of a recording whose signs are reversed for the control of a tone.
const STRETCHES: f64 = 16.0;
/// Cycles in a run from which something is called periodic.
const CYCLES: usize = 8;
/// Factor on the prior of electronics that follow the load itself: they are fed by the reading, and know of the load through it.
const BY_HEARSAY: f64 = 0.05;
/// Factor on the prior of a permittivity that follows the load: a solid's hardly does.
const ELECTROSTRICTION: f64 = 0.2;
/// Moments at which something may happen.
const MOMENTS: usize = 64;

/// One sentence with the best of its numbers.
#[derive(Clone, Debug)]
pub struct Screened {
    /// words
    pub sentence: Sentence,
    /// numbers of the grid that fit best
    pub numbers: Numbers,
    /// change of the reading, root mean square, per unit of the size
    pub swing: f64,
    /// fall of chi-squared that a straight step promises
    pub deviance: f64,
    /// what a fit made of it beyond that; 0 where none was made
    pub beyond: f64,
    /// log prior probability of the sentence
    pub log_prior: f64,
    /// (score, variance) of every point of the grid
    pub grid: Vec<(f64, f64)>,
}

impl Screened {
    /// Log evidence of the sentence, its size and its numbers unknown, where the noise has `temper` times the variance.
    pub fn evidence(&self, temper: f64) -> f64 {
        let of = |(score, variance): &(f64, f64)| {
            let z2 = score * score / variance / temper;
            let at = |length: &f64| {
                // the prior variance of the size makes the column `length` long in units of the noise
                let grown = 1.0 + length * length / temper;
                0.5 * z2 * (grown - 1.0) / grown - 0.5 * grown.ln()
            };
            log_mean_exp(&LENGTHS.iter().map(at).collect::<Vec<_>>())
        };
        let each: Vec<f64> = self.grid.iter().map(of).collect();
        log_mean_exp(&each)
    }

    /// The same with what the sentence is worth beforehand.
    pub fn weight(&self, temper: f64) -> f64 {
        self.evidence(temper) + 0.5 * self.beyond / temper + self.log_prior
    }
}

/// What came of a screen.
pub struct Screen {
    /// every sentence
    pub sentences: Vec<Screened>,
    /// greatest deviance of any sentence for each turn of the residual against the histories
    pub control: Vec<f64>,
    /// the same where that of tones is taken with stretches of the residual reversed: a tone that is turned about is the same tone
    pub control_of_tones: Vec<f64>,
    /// columns weighed
    pub columns: usize,
}

impl Screen {
    /// The likeliest sentence that says the same as sentence `index` but at once.
    pub fn at_once(&self, index: usize, temper: f64) -> Option<usize> {
        let late = &self.sentences[index].sentence;
        let law = |s: &Sentence| (s.quantity, s.action, s.form, s.even, s.below);
        let twin = |s: &Sentence| s.kinetics == Kinetics::Static && s.driver == late.driver && law(s) == law(late);
        let twins = self.sentences.iter().enumerate().filter(|(_, s)| twin(&s.sentence));
        twins.map(|(i, s)| (i, s.weight(temper))).max_by(|a, b| a.1.total_cmp(&b.1)).map(|(i, _)| i)
    }

    /// Takes the promises of sentences that were not fitted down to what the best of those that were, `fitted`, has kept: a straight step may promise more than there is.
    pub fn promise_no_more_than(&mut self, fitted: &[usize]) {
        let kept = |s: &Screened| s.deviance + s.beyond;
        let Some(most) = fitted.iter().map(|i| kept(&self.sentences[*i])).max_by(f64::total_cmp) else { return };
        for (index, s) in self.sentences.iter_mut().enumerate() {
            if !fitted.contains(&index) {
                s.beyond = s.beyond.min(most - s.deviance);
            }
        }
    }

    /// Probability that freedom alone does as well as `deviance`, which this sentence has: the share of turns that reach it, the recording itself counted.
    pub fn control_p_value(&self, sentence: &Sentence, deviance: f64) -> f64 {
        let control = if is_a_tone(sentence) { &self.control_of_tones } else { &self.control };
        let reached = control.iter().filter(|d| **d >= deviance).count();
        (reached + 1) as f64 / (control.len() + 1) as f64
    }
}

/// Screens every sentence about the fit `z` of `model`, whose linearised optimum is `linearised`; `knows_lag` where the library holds a thermal path of its own.
pub fn screen(model: &Model<'_>, z: &[f64], linearised: &Linearised, whitener: &Whitener, knows_lag: bool) -> Option<Screen> {
    let problem = model.problem;
    let (levers, seen) = levers(model, z)?;
    let at = Courses {
        inputs: problem.inputs,
        load: seen_load(problem, &seen),
        temperature: problem.inputs.temperature_c.as_ref().map(|_| seen.temperature.as_slice()),
        reading: problem.simulator.moves().then_some(seen.reading.as_slice()),
    };
    let ranges = ranges(&at);
    let mut laws = laws(&ranges, &times(problem, linearised));
    // on one loop, what bends or happens in time cannot be told from what follows the way that is gone
    if Course::of(model.context, 0).is_some_and(|course| !course.comes_again(model.context)) {
        laws.retain(|law| !is_bent_in_time(&law.sentence));
    }
    // rows in no order and without a clock are no way, and nothing was before or after
    if problem.inputs.time_s.is_none() {
        let runs = problem.inputs.runs();
        let is_way = |driver: &Driver| course(driver, &at).is_some_and(|column| is_a_way(&column, &runs));
        laws.retain(|law| {
            !matches!(law.sentence.kinetics, Kinetics::RateIndependent | Kinetics::Accumulating) || is_way(&law.sentence.driver)
        });
    }
    let [turned, reversed] = [turned(&linearised.residual), reversed(&linearised.residual)].map(|columns| columns.transpose());
    let places = places(&levers);
    let of_law = |law: &Law| {
        let Some(mut x) = course(&law.sentence.driver, &at) else { return Vec::new() };
        if law.sentence.even {
            x.iter_mut().for_each(|x| *x = x.abs());
        }
        let followed: Vec<Vec<f64>> =
            law.grid.iter().map(|numbers| of_course(&law.sentence, numbers, problem.inputs, x.clone())).collect();
        let fits = levers.iter().filter(|lever| suits(lever, &law.sentence, knows_lag));
        let mut by_chance = vec![&turned];
        by_chance.extend(is_a_tone(&law.sentence).then_some(&reversed));
        fits.filter_map(|lever| weighed(law, &followed, lever, &places, linearised, whitener, &by_chance)).collect::<Vec<_>>()
    };
    let each: Vec<(Screened, Vec<Vec<f64>>)> = laws.par_iter().flat_map_iter(of_law).collect();
    let (mut control, mut control_of_tones) = (vec![0.0; PERMUTATIONS], vec![0.0; PERMUTATIONS]);
    for (_, most) in &each {
        let greatest = |control: &mut Vec<f64>, most: &Vec<f64>| {
            control.iter_mut().zip(most).for_each(|(c, m)| *c = f64::max(*c, *m));
        };
        greatest(&mut control, &most[0]);
        greatest(&mut control_of_tones, most.last().unwrap_or(&most[0]));
    }
    let columns = each.iter().map(|(s, _)| s.grid.len()).sum();
    Some(Screen { sentences: each.into_iter().map(|(s, _)| s).collect(), control, control_of_tones, columns })
}

/// Whether it says that something bends, begins or happens at a time.
fn is_bent_in_time(sentence: &Sentence) -> bool {
    let bent = sentence.kinetics == Kinetics::Static && sentence.form != Form::Linear;
    sentence.driver == Driver::Time && (bent || sentence.kinetics == Kinetics::Event)
}

fn seen_load<'s>(problem: &Problem<'_>, seen: &'s Seen) -> Option<&'s [f64]> {
    problem.simulator.load(problem.inputs).map(|_| seen.load.as_slice())
}

/// Drivers that move.
fn ranges(at: &Courses<'_>) -> Vec<Range> {
    let mut drivers = vec![
        Driver::Load,
        Driver::LoadHistory,
        Driver::LoadRate,
        Driver::Temperature,
        Driver::TemperatureRate,
        Driver::Time,
        Driver::Reading,
    ];
    let round = |name: &str| at.inputs.drivers.iter().any(|driver| driver.name == name && begins_anew(driver));
    for (name, _, _) in recorded(at.inputs) {
        drivers.push(Driver::Recorded(name.clone()));
        // where an angle begins anew, its number runs at no speed that means anything
        drivers.extend((!round(&name)).then_some(Driver::RateOf(name)));
    }
    let of = |driver: Driver| {
        let mut x = course(&driver, at)?;
        let moves = spread(&x) > 0.0;
        let (low, high) = ends(x.iter().copied());
        x.iter_mut().for_each(|x| *x = x.abs());
        let tenth = x.len().saturating_sub(1) * 9 / 10;
        let usual = *x.select_nth_unstable_by(tenth, f64::total_cmp).1;
        let usual = if usual > 0.0 { usual } else { high.abs().max(low.abs()) };
        let angle = match &driver {
            Driver::Recorded(name) => recorded(at.inputs)
                .into_iter()
                .find(|(own, ..)| own == name)
                .and_then(|(_, _, unit)| turning(&unit, low, high))
                .map(|turn| Angle { turn, round: round(name) }),
            _ => None,
        };
        moves.then_some(Range { driver, low, high, usual, angle })
    };
    drivers.into_iter().filter_map(of).collect()
}

/// The clock, with moments at even numbers of rows and the periods that stand out in what is left.
fn times(problem: &Problem<'_>, linearised: &Linearised) -> Times {
    let Some(clock) = problem.inputs.time_s.as_deref() else { return Times::default() };
    let rows = clock.len();
    let steps = problem.inputs.steps_s();
    let step_s = steps.iter().copied().filter(|s| *s > 0.0).fold(f64::INFINITY, f64::min);
    let moments_s = (1..MOMENTS).map(|k| clock[k * rows / MOMENTS] - clock[0]).collect();
    let periods_s = tones(problem, linearised);
    let duration_s = clock[rows - 1] - clock[0];
    Times { step_s: if step_s.is_finite() { step_s } else { 0.0 }, duration_s, moments_s, periods_s }
}

/// Periods of the strongest line in the spectrum of each of the longest runs, s.
fn tones(problem: &Problem<'_>, linearised: &Linearised) -> Vec<f64> {
    let Some(clock) = problem.inputs.time_s.as_deref() else { return Vec::new() };
    let mut runs = problem.runs();
    runs.sort_by_key(|r| std::cmp::Reverse(r.len()));
    let mut planner = rustfft::FftPlanner::<f64>::new();
    let mut periods = Vec::new();
    for run in runs.into_iter().take(3).filter(|r| r.len() >= 64) {
        let part = linearised.residual.rows(run.start, run.len());
        let mut values: Vec<rustfft::num_complex::Complex<f64>> = part.iter().map(|v| (*v).into()).collect();
        planner.plan_fft_forward(run.len()).process(&mut values);
        let power = |line: &usize| values[*line].norm_sqr();
        let strongest = (CYCLES..run.len() / 2).max_by(|a, b| power(a).total_cmp(&power(b)));
        let length_s = clock[run.end - 1] - clock[run.start];
        periods.extend(strongest.map(|line| length_s / line as f64).filter(|p| *p > 0.0));
    }
    periods
}

/// Quantities with a lever, and how many each place has.
fn places(levers: &[Lever]) -> Vec<(Place, usize)> {
    let mut places: Vec<(Place, usize)> = Vec::new();
    for lever in levers {
        let place = lever.quantity.place();
        match places.iter_mut().find(|(p, _)| *p == place) {
            Some((_, count)) => *count += 1,
            None => places.push((place, 1)),
        }
    }
    places
}

/// Whether a mechanism of this driver may act there: the reading is known at the end of the chain only.
fn suits(lever: &Lever, sentence: &Sentence, knows_lag: bool) -> bool {
    match (lever.quantity, &sentence.driver) {
        // a sensor that is late behind its thermometer, where the library has that
        (Quantity::Temperature, Driver::Temperature | Driver::TemperatureRate) => !knows_lag,
        (Quantity::Temperature, Driver::Load | Driver::LoadRate | Driver::LoadHistory) => false,
        (quantity, Driver::Reading) => quantity == Quantity::Reading,
        _ => true,
    }
}

/// A sentence at one lever, and the greatest deviance of its grid for each residual that came `by_chance`, a row each.
fn weighed(
    law: &Law,
    followed: &[Vec<f64>],
    lever: &Lever,
    places: &[(Place, usize)],
    linearised: &Linearised,
    whitener: &Whitener,
    by_chance: &[&DMatrix<f64>],
) -> Option<(Screened, Vec<Vec<f64>>)> {
    let product = |u: &Vec<f64>| u.iter().zip(&lever.of_row).map(|(u, s)| u * s).collect::<Vec<f64>>();
    let mut columns: Vec<Vec<f64>> = followed.iter().map(product).collect();
    let swings: Vec<f64> = columns.iter().map(|b| deviation(b)).collect();
    let finite: Vec<bool> = columns.iter().map(|b| b.iter().all(|b| b.is_finite())).collect();
    whitener.apply_each(&mut columns);
    let mut grid = Vec::with_capacity(followed.len());
    let (mut left, mut variances) = (Vec::new(), Vec::new());
    for (b, finite) in columns.into_iter().zip(finite) {
        if !finite {
            grid.push((0.0, 1.0));
            continue;
        }
        let b = DVector::from_vec(b);
        let length = b.norm_squared();
        let taken = linearised.taken.tr_mul(&b);
        let variance = length - taken.norm_squared();
        if variance <= ABSORBED * length || length == 0.0 {
            grid.push((0.0, 1.0));
            continue;
        }
        grid.push((b.dot(&linearised.residual), variance));
        left.push(b - &linearised.taken * taken);
        variances.push(variance);
    }
    let greatest = |residuals: &&DMatrix<f64>| {
        let mut most = vec![0.0; residuals.nrows()];
        if !left.is_empty() {
            for (scores, variance) in (*residuals * DMatrix::from_columns(&left)).column_iter().zip(&variances) {
                most.iter_mut().zip(scores.iter()).for_each(|(most, s)| *most = f64::max(*most, s * s / variance));
            }
        }
        most
    };
    let control: Vec<Vec<f64>> = by_chance.iter().map(greatest).collect();
    let deviance = |(score, variance): &(f64, f64)| score * score / variance;
    let best = (0..grid.len()).max_by(|a, b| deviance(&grid[*a]).total_cmp(&deviance(&grid[*b])))?;
    let place = lever.quantity.place();
    let beside = places.iter().find(|(p, _)| *p == place).map_or(1, |(_, count)| *count);
    let sentence = Sentence { quantity: lever.quantity, action: lever.action, ..law.sentence.clone() };
    let log_prior = law.log_prior - ((places.len() * beside) as f64).ln() + plausibility(place, &sentence.driver, places).ln();
    let (numbers, swing, deviance) = (law.grid[best], swings[best], deviance(&grid[best]));
    Some((Screened { sentence, numbers, swing, deviance, beyond: 0.0, log_prior, grid }, control))
}

/// Factor on the prior of a place that hardly knows its driver.
fn plausibility(place: Place, driver: &Driver, places: &[(Place, usize)]) -> f64 {
    let of_load = matches!(driver, Driver::Load | Driver::LoadHistory | Driver::LoadRate);
    let mechanics = places.iter().any(|(p, _)| *p == Place::Mechanics);
    match place {
        // what couples from a moving stage into the electronics follows its speed
        Place::Readout if mechanics && of_load && *driver != Driver::LoadRate => BY_HEARSAY,
        Place::Dielectric if of_load => ELECTROSTRICTION,
        _ => 1.0,
    }
}

/// Whether it goes up and down with time or with a driver: over a sweep of the driver that is a tone as well.
fn is_a_tone(sentence: &Sentence) -> bool {
    sentence.kinetics == Kinetics::Periodic
}

/// What is left, with the sign of stretches reversed by chance: each stays what it was, and no tone goes through all of them.
fn reversed(residual: &DVector<f64>) -> DMatrix<f64> {
    let rows = residual.len();
    let mut random = ChaCha8Rng::seed_from_u64(SEEDS.reversed_residual);
    let mut reversed = DMatrix::zeros(rows, PERMUTATIONS);
    for mut column in reversed.column_iter_mut() {
        let (first, length) = (random.random_range(0.0..1.0), rows as f64 / STRETCHES);
        let mut signs = [0.0; STRETCHES as usize + 2];
        signs.iter_mut().for_each(|sign| *sign = if random.random() { 1.0 } else { -1.0 });
        for row in 0..rows {
            column[row] = residual[row] * signs[(row as f64 / length + first) as usize];
        }
    }
    reversed
}

/// What is left, turned about by chance against the histories: columns of a control of equal freedom.
fn turned(residual: &DVector<f64>) -> DMatrix<f64> {
    let rows = residual.len();
    let mut random = ChaCha8Rng::seed_from_u64(SEEDS.turned_residual);
    let mut turned = DMatrix::zeros(rows, PERMUTATIONS);
    for mut column in turned.column_iter_mut() {
        let by = (rows as f64 * random.random_range(0.05..0.95)) as usize;
        let back: bool = random.random();
        for row in 0..rows {
            let from = (row + by) % rows;
            column[row] = residual[if back { rows - 1 - from } else { from }];
        }
    }
    turned
}

#[cfg(test)]
mod tests;
