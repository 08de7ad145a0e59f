//! Causes that no effect of the library holds, as rivals of those that one does: a zero or a gain that wanders, a jump inside a run, a reading that follows how fast
//! load or temperature change.
//!
//! A library that always finds its nearest member names unmodelled causes wrongly. Each of these causes is a set of columns that add to the reading with Gaussian weights of
//! unknown size, so that its evidence beside any fitted model is a closed form; an unmodelled cause that one of them describes with fewer numbers than the library
//! needs is called `unexplained`, with what it follows.
//!
//! Limits: linear about the fit; additive on the reading.

use crate::{
    data::{context::load_column, problem::Problem},
    effects::{
        effect::{Effect, ZeroCourse},
        memory::rates,
    },
    fit::{
        optimum::Linearised,
        score_test::{Scores, scores_with},
    },
    selection::tuning::{
        ABSORBED_COLUMN, LENGTHS, MOST_BESIDE, NEAR_THE_BEST, OCTAVES, RUN_KNOTS, UNMODELLED_PRIOR, WANDER_KNOTS,
    },
    selection::{candidates::Tried, effect_set::EffectSet, prior::one_more, tuning::RIGHT_FAMILY},
    stats::{log_mean_exp, symmetric_eigen},
    whitening::whitener::Whitener,
};
use nalgebra::DMatrix;
use rayon::prelude::*;
use std::ops::Range;

/// A kind of cause outside the library.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Cause {
    /// the zero wanders
    WanderingZero,
    /// the gain wanders
    WanderingGain,
    /// the reading jumps inside a run
    Jump,
    /// follows the speed of the load, whatever its direction
    LoadSpeed,
    /// follows the speed of the temperature, whatever its direction
    TemperatureSpeed,
    /// follows the rate of the temperature, with its sign
    TemperatureRate,
}

impl Cause {
    /// What a reader is told of it.
    pub fn says(self) -> &'static str {
        match self {
            Self::WanderingZero => "the zero wanders from row to row",
            Self::WanderingGain => "the gain wanders from row to row",
            Self::Jump => "the reading jumps inside a run",
            Self::LoadSpeed => "the reading follows how fast the load changes, up or down alike",
            Self::TemperatureRate => "the reading follows the rate of the temperature",
            Self::TemperatureSpeed => "the reading follows how fast the temperature changes, up or down alike",
        }
    }

    /// Whether it makes by itself the course of the zero that an effect of the library makes, so that the two are not weighed together.
    fn holds(self, course: ZeroCourse) -> bool {
        match self {
            Self::WanderingZero | Self::WanderingGain => course != ZeroCourse::Still,
            Self::Jump => course == ZeroCourse::InsideRuns,
            _ => false,
        }
    }

    /// Whether one of its columns acts, or all together.
    fn is_one_of(self) -> bool {
        self == Self::Jump
    }
}

/// A cause with its whitened columns, n x k.
struct Columns {
    cause: Cause,
    columns: DMatrix<f64>,
    /// products of the columns with one another
    gram: DMatrix<f64>,
    /// row at which each column acts, where one of them does
    rows: Vec<usize>,
}

/// An unmodelled cause beside a model.
#[derive(Clone, Debug)]
pub struct Unmodelled {
    /// the cause
    pub cause: Cause,
    /// effects of the model that it stands beside, ascending
    pub effects: EffectSet,
    /// log weight, on the scale of the models'
    pub weight: f64,
    /// log evidence that it adds to the model
    pub gain: f64,
    /// row before which it acts, where it acts at one
    pub row: Option<usize>,
}

/// The causes that these inputs could show.
pub struct Causes {
    list: Vec<Columns>,
    /// the zero wanders inside runs; none where no run is long enough
    inside: Option<Columns>,
}

impl Causes {
    /// Columns of every cause, whitened.
    pub fn new(problem: &Problem<'_>, whitener: &Whitener) -> Self {
        let runs = problem.runs();
        let time = problem.inputs.time_s.as_deref();
        let load = load_column(problem.inputs, problem.simulator).filter(|l| moves(l));
        let warm = problem.inputs.temperature_c.as_deref().filter(|t| moves(t));
        let rows = problem.response.len();
        let knots = knots(&runs, rows);
        let inside: Vec<usize> = knots.iter().copied().filter(|k| runs.iter().all(|r| r.start != *k)).collect();
        let inside_runs = wandering(&inside, time, rows, |_| 1.0);
        let mut list = vec![
            (Cause::WanderingZero, wandering(&knots, time, rows, |_| 1.0)),
            (Cause::Jump, inside.iter().map(|k| step(*k, rows, &runs)).collect()),
        ];
        if let Some(load) = &load {
            list.push((Cause::WanderingGain, wandering(&knots, time, rows, |row| load[row])));
            list.push((Cause::LoadSpeed, laws(&rates(time, load, &runs), false)));
        }
        if let Some(warm) = warm {
            let rate = rates(time, warm, &runs);
            list.push((Cause::TemperatureSpeed, laws(&rate, false)));
            list.push((Cause::TemperatureRate, laws(&rate, true)));
        }
        let of = |(cause, columns): (Cause, Vec<Vec<f64>>)| {
            let columns = whitener.matrix(columns);
            let rows = if cause.is_one_of() { inside.clone() } else { Vec::new() };
            Columns { cause, gram: columns.tr_mul(&columns), columns, rows }
        };
        let inside = (runs.len() > 1 && !inside_runs.is_empty()).then(|| of((Cause::WanderingZero, inside_runs)));
        Self { list: list.into_iter().filter(|(_, c)| !c.is_empty()).map(of).collect(), inside }
    }

    /// Each cause beside the models near the best; `weight` is a model's log weight, `temper` its divisor of log evidence.
    ///
    /// A cause has no equation that could be in the wrong form, but freedom enough to follow what a wrong form leaves: it is weighed at noise of `temper` times
    /// the variance, where its freedom costs what it costs.
    pub fn beside<'t>(
        &self,
        models: &'t [Tried],
        library: &[&dyn Effect],
        weight: impl Fn(&Tried) -> f64 + Sync,
        temper: f64,
    ) -> Vec<Unmodelled> {
        let best = models.iter().map(&weight).fold(f64::NEG_INFINITY, f64::max);
        let close = |m: &&'t Tried| m.effects.is_empty() || weight(m) > best - NEAR_THE_BEST;
        let linearised = |m: &'t Tried| Some((m, m.fit.linearised())).filter(|(_, linearised)| linearised.is_reached());
        let mut near: Vec<(&'t Tried, Linearised)> = models.iter().filter(close).filter_map(linearised).collect();
        // the base model stays, whatever its weight
        let heavier = |a: &Tried, b: &Tried| weight(b).total_cmp(&weight(a));
        near.sort_by(|(a, _), (b, _)| b.effects.is_empty().cmp(&a.effects.is_empty()).then(heavier(a, b)));
        near.truncate(MOST_BESIDE);
        let share = (UNMODELLED_PRIOR / self.list.len().max(1) as f64).ln();
        let nothing = models.iter().find(|m| m.effects.is_empty()).map_or(0.0, |m| m.fit.objective());
        let one = |model: &Tried, linearised: &Linearised, columns: &Columns| {
            let (gain, tempered, row) = columns.gain(linearised, temper);
            let weight = weight(model) + one_more(model.effects.len()) + share + tempered;
            // beside a model, it has to be more than what the right family leaves in the wrong form
            let explained = (nothing - model.fit.objective()).max(0.0);
            let counts = model.effects.is_empty() || gain > (1.0 - RIGHT_FAMILY) * (explained + gain);
            counts.then(|| Unmodelled { cause: columns.cause, effects: model.key(), weight, gain, row })
        };
        let still = self.still_inside_runs(models, library, temper);
        let apart = |model: &Tried, cause: Cause| {
            !(still && cause == Cause::WanderingZero) && model.effects.iter().all(|e| !cause.holds(library[*e].zero_course()))
        };
        let of = |(model, linearised): &(&'t Tried, Linearised)| {
            let apart = self.list.iter().filter(|c| apart(model, c.cause));
            apart.filter_map(|c| one(model, linearised, c)).collect::<Vec<_>>()
        };
        near.par_iter().flat_map_iter(of).filter(|u| u.weight.is_finite()).collect()
    }

    /// Whether a number for each run leaves nothing that wanders inside one: a zero that wanders would do both.
    fn still_inside_runs(&self, models: &[Tried], library: &[&dyn Effect], temper: f64) -> bool {
        let steps = models.iter().find(|m| !m.effects.is_empty() && m.effects.iter().all(|e| library[*e].free_form()));
        let gain = |(inside, steps): (&Columns, &Tried)| inside.gain(&steps.fit.linearised(), temper).1;
        self.inside.as_ref().zip(steps).map(gain).is_some_and(|gain| gain <= 0.0)
    }
}

impl Columns {
    /// Log evidence that the cause adds to a model, its size unknown; the same where the noise has `temper` times the variance; and the row at which it acts.
    fn gain(&self, linearised: &Linearised, temper: f64) -> (f64, f64, Option<usize>) {
        let found = scores_with(linearised, &self.columns, &self.gram);
        let louder = Scores { scores: &found.scores / temper, covariance: &found.covariance / temper };
        let seen = |k: usize| found.scores[k].powi(2) / found.covariance[(k, k)].max(f64::MIN_POSITIVE);
        let clearest = (0..self.rows.len()).max_by(|a, b| seen(*a).total_cmp(&seen(*b)));
        (self.of_any_length(&found), self.of_any_length(&louder), clearest.map(|k| self.rows[k]))
    }

    fn of_any_length(&self, found: &Scores) -> f64 {
        let each: Vec<f64> = if self.cause.is_one_of() {
            LENGTHS.iter().map(|length| one_of(found, *length)).collect()
        } else {
            let apart = apart(found);
            LENGTHS.iter().map(|length| together(&apart, *length)).collect()
        };
        log_mean_exp(&each)
    }
}

/// Evidence for one of several columns, each with a weight under which it is `length` long.
fn one_of(found: &Scores, length: f64) -> f64 {
    let gain = |k: usize| {
        let variance = found.covariance[(k, k)];
        if variance <= 0.0 {
            return 0.0;
        }
        let z2 = found.scores[k].powi(2) / variance;
        let prior = length * length;
        0.5 * z2 * prior / (1.0 + prior) - 0.5 * (1.0 + prior).ln()
    };
    let each: Vec<f64> = (0..found.scores.len()).map(gain).collect();
    log_mean_exp(&each)
}

/// Scores along directions that do not correlate: variance and score of each that calibration leaves.
fn apart(found: &Scores) -> Vec<(f64, f64)> {
    let eigen = symmetric_eigen((&found.covariance + found.covariance.transpose()) * 0.5);
    let greatest = eigen.eigenvalues.iter().copied().fold(0.0, f64::max);
    let directions = eigen.eigenvalues.iter().zip(eigen.eigenvectors.column_iter());
    directions.filter(|(v, _)| **v > ABSORBED_COLUMN * greatest).map(|(v, d)| (*v, d.dot(&found.scores))).collect()
}

/// Evidence for all columns together, independent weights under which their sum is `length` long: log N(r; 0, P + w B B^T) less log N(r; 0, P), by the
/// directions of B^T P^-1 B.
fn together(apart: &[(f64, f64)], length: f64) -> f64 {
    let total: f64 = apart.iter().map(|(variance, _)| variance).sum();
    let weight = if total > 0.0 { length * length / total } else { 0.0 };
    let one = |(variance, score): &(f64, f64)| {
        let grown = 1.0 + weight * variance;
        0.5 * weight * score * score / grown - 0.5 * grown.ln()
    };
    apart.iter().map(one).sum()
}

fn moves(column: &[f64]) -> bool {
    crate::stats::spread(column) > 0.0
}

/// Evenly spaced rows, and the first of every run but the first; of many runs as many as are known apart, evenly.
fn knots(runs: &[Range<usize>], rows: usize) -> Vec<usize> {
    let mut knots: Vec<usize> = (1..WANDER_KNOTS).map(|k| k * rows / WANDER_KNOTS).filter(|k| *k > 0).collect();
    let starts: Vec<usize> = runs.iter().skip(1).map(|r| r.start).collect();
    let kept = starts.len().min(RUN_KNOTS);
    knots.extend((0..kept).map(|k| starts[k * starts.len() / kept]));
    knots.sort_unstable();
    knots.dedup();
    knots
}

/// 1 from row `from` to the end of its run, 0 elsewhere.
fn step(from: usize, rows: usize, runs: &[Range<usize>]) -> Vec<f64> {
    let end = runs.iter().find(|r| r.contains(&from)).map_or(rows, |r| r.end);
    (0..rows).map(|row| if (from..end).contains(&row) { 1.0 } else { 0.0 }).collect()
}

/// Steps of a random walk, as large as the time since the one before lets it go; `factor` is what it multiplies.
fn wandering(knots: &[usize], time: Option<&[f64]>, rows: usize, factor: impl Fn(usize) -> f64) -> Vec<Vec<f64>> {
    let at = |row: usize| time.map_or(row as f64, |t| t[row]);
    let mut before = 0;
    let mut columns = Vec::new();
    for &knot in knots {
        let size = (at(knot) - at(before)).max(0.0).sqrt();
        before = knot;
        columns.push((0..rows).map(|row| if row >= knot { size * factor(row) } else { 0.0 }).collect());
    }
    columns
}

/// Any law of a speed, or of a rate with its sign: hat functions of the logarithm of the speed, 0 at rest.
fn laws(rate: &[f64], signed: bool) -> Vec<Vec<f64>> {
    let greatest = rate.iter().fold(0.0_f64, |most, r| most.max(r.abs()));
    if greatest <= 0.0 {
        return Vec::new();
    }
    let octave: Vec<f64> = rate.iter().map(|r| -(r.abs() / greatest).log2()).collect();
    let hat = |k: usize, row: usize| (1.0 - (octave[row] - k as f64).abs()).max(0.0);
    let sign = |row: usize| if signed { rate[row].signum() } else { 1.0 };
    let columns = (0..OCTAVES).map(|k| (0..rate.len()).map(|row| sign(row) * hat(k, row)).collect::<Vec<f64>>());
    columns.filter(|c| c.iter().any(|v| *v != 0.0)).collect()
}

#[cfg(test)]
mod tests {
    use super::*;
    use nalgebra::{Cholesky, DVector};
    use rand::SeedableRng;
    use rand_chacha::ChaCha8Rng;
    use rand_distr::{Distribution, StandardNormal};

    const ROWS: usize = 240;

    fn noise(seed: u64) -> DVector<f64> {
        let random = &mut ChaCha8Rng::seed_from_u64(seed);
        DVector::from_fn(ROWS, |_, _| StandardNormal.sample(random))
    }

    /// Scores where nothing is calibrated.
    fn scored(columns: &[Vec<f64>], residual: &DVector<f64>) -> Scores {
        let b = DMatrix::from_fn(ROWS, columns.len(), |row, k| columns[k][row]);
        Scores { scores: b.tr_mul(residual), covariance: b.tr_mul(&b) }
    }

    fn walk() -> Vec<Vec<f64>> {
        wandering(&knots(&[0..120, 120..ROWS], ROWS), None, ROWS, |_| 1.0)
    }

    fn jumps() -> Vec<Vec<f64>> {
        (1..40).map(|k| step(6 * k, ROWS, &[0..120, 120..ROWS])).collect()
    }

    #[test]
    fn the_evidence_of_many_columns_is_that_of_a_correlated_gaussian() {
        let columns = walk();
        let residual = noise(1);
        let found = scored(&columns, &residual);
        let variance = 400.0 / found.covariance.trace();
        let b = DMatrix::from_fn(ROWS, columns.len(), |row, k| columns[k][row]);
        // the other route: the covariance of all rows, no identity for determinant and inverse
        let whole = DMatrix::identity(ROWS, ROWS) + &b * b.transpose() * variance;
        let factor = Cholesky::new(whole).unwrap();
        let log_det: f64 = factor.l_dirty().diagonal().iter().map(|d| 2.0 * d.ln()).sum();
        let exact = 0.5 * residual.norm_squared() - 0.5 * residual.dot(&factor.solve(&residual)) - 0.5 * log_det;
        // rounding of 240 x 240 against 64 x 64
        assert!((together(&apart(&found), 20.0) - exact).abs() < 1e-8, "{exact}");
    }

    #[test]
    fn noise_alone_gives_no_evidence_and_a_planted_course_gives_much() {
        let gain = |columns: &[Vec<f64>], residual: &DVector<f64>| together(&apart(&scored(columns, residual)), 20.0);
        let walked = walk();
        for seed in 0..20 {
            assert!(gain(&walked, &noise(seed)) < 2.0, "{seed}");
        }
        let random = &mut ChaCha8Rng::seed_from_u64(7);
        let mut course = DVector::zeros(ROWS);
        for column in &walked {
            let step: f64 = StandardNormal.sample(random);
            course += DVector::from_column_slice(column) * step;
        }
        course *= 20.0 / course.norm();
        assert!(gain(&walked, &(noise(3) + course)) > 50.0);
    }

    #[test]
    fn a_jump_is_rather_a_jump_than_a_wandering_zero() {
        let columns = jumps();
        let planted = DVector::from_column_slice(&columns[11]) * 1.5 + noise(5);
        let (jump, walk) = (one_of(&scored(&columns, &planted), 20.0), together(&apart(&scored(&walk(), &planted)), 20.0));
        assert!(jump > walk + 5.0 && walk > 20.0, "{jump} {walk}");
        assert!(one_of(&scored(&columns, &noise(5)), 20.0) < 0.0);
    }

    /// What a zero does from run to run is a course of many steps, however many runs there are: its evidence takes the directions of a matrix with a row for each.
    #[test]
    fn many_runs_do_not_make_more_knots_and_few_keep_theirs() {
        let of = |count: usize| (0..count).map(|k| 8 * k..8 * (k + 1)).collect::<Vec<Range<usize>>>();
        let few = knots(&of(100), 800);
        assert!(of(100).iter().skip(1).all(|run| few.contains(&run.start)));
        let many = knots(&of(2000), 16_000);
        assert!(many.len() < RUN_KNOTS + WANDER_KNOTS, "{}", many.len());
        assert!(many.windows(2).all(|pair| pair[1] - pair[0] <= 16_000 / WANDER_KNOTS));
    }

    #[test]
    fn steps_end_with_their_run_and_rates_do_not_cross_runs() {
        let jump = step(100, ROWS, &[0..120, 120..ROWS]);
        assert_eq!(jump.iter().sum::<f64>(), 20.0);
        let (column, time) = (vec![0.0, 1.0, 3.0, 10.0, 10.0], vec![0.0, 1.0, 2.0, 50.0, 51.0]);
        assert_eq!(rates(Some(&time), &column, &[0..3, 3..5]), vec![1.0, 1.5, 2.0, 0.0, 0.0]);
        // a speed of 1/4 is two octaves down, one of 0.75 between the greatest and its half
        let law = laws(&[-2.0, 0.5, 0.0, 1.5], false);
        assert_eq!((law.len(), law[0][0], law[2][1], law[0][2]), (3, 1.0, 1.0, 0.0));
        assert!((law[0][3] + law[1][3] - 1.0).abs() < 1e-12 && laws(&[-2.0], true)[0][0] == -1.0);
    }
}
