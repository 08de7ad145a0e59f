//! A drift that is named beside a noise with a memory is compared with a zero that wanders as a random walk.
//!
//! A drift with two or three numbers takes the slow part of a random walk, and a noise with a memory, itself read from the walk, takes the quick part: nothing is left then, and the drift seems to explain
//! all. A walk has one number and does both. Where the drift is no likelier than that, an input that was not recorded may wander, and the name is not all that can be said.
//!
//! Where more than a drift is named and the walk is likelier, a drift alone is asked once more beside a walk: a clock that goes at another rate wanders as well, and two courses of its zero take that apart.
//!
//! **Source:** Nelson & Kang, Spurious periodicity in inappropriately detrended time series, Econometrica 49 (1981) 741; the walk as a state of the filter: Durbin & Koopman, Time Series Analysis by State Space
//! Methods, section 2.1.
//!
//! Limits: effects of the library that move the zero by the clock alone; each run begins where the clock lets the walk be by then.

use crate::{
    data::error::DiagnoseError,
    effects::{
        composed::words::{Driver, Kinetics, Place},
        effect::ZeroCourse,
    },
    fit::{levenberg_marquardt::FitOptions, maximum_a_posteriori::fit, model::Model, optimum::Fit, under_noise::UnderNoise},
    pipeline::{
        judged::{Judged, Told},
        prepare::Prepared,
        simple_laws::{Simple, simple},
    },
    selection::{
        candidates::{Search, Tried},
        tuning::{MEMORY_DOUBLES, OFTEN, RIVAL, SHORTEST_WANDER, WALKS},
        unmodelled::{Cause, Unmodelled},
        verdict::{Decision, Verdict},
    },
    stats::rms,
    validation::{cross_validation::compared, tuning::CLEARLY_WORSE},
    whitening::{
        noise_model::NoiseModel,
        whitener::{InputError, Lasting, Noise, Whitener},
    },
};
use std::sync::atomic::Ordering;

/// The same, with the drifts beside which a zero that wanders cannot be excluded: where that is much likelier than they are and nothing else is named, nothing is.
///
/// # Errors
/// Those of the simulator.
pub(crate) fn beside_a_walk(
    prepared: &Prepared<'_>,
    told: &Told<'_>,
    judged: Judged,
) -> Result<(Judged, Vec<usize>), DiagnoseError> {
    let searched = prepared.searched();
    let context = prepared.context.holding(judged.held.clone());
    let search = prepared.search(&searched, told.progress, told.stop);
    let search = search.within(&context);
    let has_memory = prepared.noise.lasts() || prepared.noise.response.ar_sd > 0.0;
    let asked = has_memory && judged.kept_back.is_none() && judged.names_something() && !told.stop.load(Ordering::Relaxed);
    let drifts = drifts(&search, judged.stood_behind());
    if !asked || drifts.is_empty() || prepared.problem.simulator.joined().is_some() || searched.inputs.time_s.is_none() {
        return Ok((judged, Vec::new()));
    }
    let [walk, named] = with_and_without(&search, &prepared.searched_noise, judged.stood_behind(), &drifts)?;
    let odds = walk - named;
    let alone = drifts.len() == judged.stood_behind().effects.len();
    if odds > -RIVAL.ln() && alone {
        let judged = match drift_beside(prepared, told, &judged, walk)? {
            Some(drift) => judged.told_as_a_drift(prepared, drift),
            None => judged.told_as_a_walk(odds),
        };
        return Ok((judged, Vec::new()));
    }
    Ok((judged, if odds > RIVAL.ln() { drifts } else { Vec::new() }))
}

/// The drift of the library, by its simple law, that is likeliest beside a walk, where what is named is less likely than the `walk` alone, of that log evidence: two courses of the zero, or one that turns, may take a walk apart that a
/// clock adds to its rate. `None` where it is no much likelier than the walk, or foretells rows left out no clearly better than the base model.
fn drift_beside(prepared: &Prepared<'_>, told: &Told<'_>, judged: &Judged, walk: f64) -> Result<Option<Simple>, DiagnoseError> {
    let searched = prepared.searched();
    let search = &prepared.search(&searched, told.progress, told.stop);
    let drifts: Vec<usize> =
        (0..search.library.len()).filter(|e| search.library[*e].zero_course() == ZeroCourse::InsideRuns).collect();
    let mut likeliest = (walk - RIVAL.ln(), None);
    for tried in search.add_each(judged.examined.selection.base(), &drifts, drifts.len(), "a drift beside a walk") {
        let Some(drift) = simple(prepared, search, &judged.by_base, &tried, 1.0) else { continue };
        if !compared(&judged.by_base.unseen, &drift.unseen).is_some_and(|both| both.better_by(CLEARLY_WORSE)) {
            continue;
        }
        let context = search.context.holding(drift.held.clone());
        let model = search.within(&context).model(&drift.tried.effects);
        let evidence = beside_walk(&model, &drift.tried.fit, &prepared.searched_noise)?;
        if evidence > likeliest.0 {
            likeliest = (evidence, Some(drift));
        }
    }
    Ok(likeliest.1)
}

/// Effects of a model that move the zero by the clock alone; none where one of it is no effect of the library.
fn drifts(search: &Search<'_>, tried: &Tried) -> Vec<usize> {
    if tried.effects.iter().any(|effect| *effect >= search.library.len()) {
        return Vec::new();
    }
    let switches = |effect: usize| {
        let words = search.library[effect].in_words(search.context);
        words.is_some_and(|w| w.place == Place::Readout && w.driver == Driver::Time && w.kinetics == Kinetics::Event)
    };
    let drifts = |effect: &usize| search.library[*effect].zero_course() == ZeroCourse::InsideRuns || switches(*effect);
    tried.effects.iter().copied().filter(drifts).collect()
}

/// Log evidence of a model without its `drifts`, beside a walk and white noise, and of the model itself: under its noise, or beside a walk as well, whichever is likelier.
fn with_and_without(search: &Search<'_>, noise: &NoiseModel, tried: &Tried, drifts: &[usize]) -> Result<[f64; 2], DiagnoseError> {
    let whole = search.model(&tried.effects);
    let rest: Vec<usize> = tried.effects.iter().copied().filter(|effect| !drifts.contains(effect)).collect();
    let Some(without) = search.part_of(tried, &rest) else { return Ok([f64::NEG_INFINITY, 0.0]) };
    let walk = beside_walk(&search.model(&without.effects), &without.fit, noise)?;
    let named = evidence(&tried.fit, search.whitener).max(beside_walk(&whole, &tried.fit, noise)?);
    Ok([walk, named])
}

/// Log evidence of a fit, with the constant of its noise.
pub(crate) fn evidence(fit: &Fit, whitener: &Whitener) -> f64 {
    fit.log_evidence - 0.5 * whitener.log_determinant
}

/// Memories of the wanders that are weighed in a recording of this length, in the unit of its step.
pub(crate) fn memories(step: f64, longest: f64) -> impl Iterator<Item = f64> {
    (0..).map(move |k| SHORTEST_WANDER * step * MEMORY_DOUBLES.powi(k)).take_while(move |memory| OFTEN * memory <= longest)
}

/// Log evidence of a model beside the likeliest walk.
fn beside_walk(model: &Model<'_>, start: &Fit, noise: &NoiseModel) -> Result<f64, DiagnoseError> {
    let runs = model.problem.runs();
    let weighed = UnderNoise::of(model, start)?;
    let size = rms(model.misfit(&start.z)?.into_iter());
    let time = model.problem.inputs.time_s.as_deref().unwrap_or(&[]);
    let filter = |ratio: f64, white: f64| with_walk(noise, time, ratio * white, white).whitener(&runs, None);
    let of = |ratio: f64| weighed.as_loud(size, |white| filter(ratio, white));
    let likeliest = WALKS.map(of).into_iter().max_by(|a, b| a.0.total_cmp(&b.0));
    let Some((.., filter)) = likeliest else { return Ok(f64::NEG_INFINITY) };
    Ok(evidence(&fit(model, &filter, &start.z, &FitOptions::default())?, &filter))
}

/// White noise of a row beside a random walk that goes as far as `walk` (standard deviation) over the whole recording, in place of the reading's own noise.
pub(crate) fn with_walk(noise: &NoiseModel, time_s: &[f64], walk: f64, white: f64) -> NoiseModel {
    let (first, last) = (time_s.first().copied().unwrap_or(0.0), time_s.last().copied().unwrap_or(1.0));
    let each = walk * walk / (last - first).max(f64::MIN_POSITIVE);
    let variance: Vec<f64> = time_s.iter().map(|t| each * (t - first).max(0.0)).collect();
    // a walk goes on from where it is: what it was is all of it, and what is new is added
    let memory = |row: usize| match row.checked_sub(1) {
        Some(before) if variance[row] > 0.0 => (variance[before] / variance[row]).min(1.0).sqrt(),
        _ => 0.0,
    };
    let memory = (0..time_s.len()).map(memory).collect();
    with_lasting(noise, Lasting { variance, memory, of_reading: true }, white)
}

/// White noise of a row beside what lasts of a reading, in place of its own noise.
pub(crate) fn with_lasting(noise: &NoiseModel, lasting: Lasting, white: f64) -> NoiseModel {
    let of_inputs = noise.input_error.lasting.iter().filter(|lasting| !lasting.of_reading).cloned();
    let lasting = of_inputs.chain([lasting]).collect();
    let response = Noise { white_sd: white, ar_sd: 0.0, ar_correlation: 0.0 };
    NoiseModel { response, input_error: InputError { lasting, ..noise.input_error.clone() }, ..noise.clone() }
}

impl Judged {
    /// The same where a zero that wanders, at these log odds, stands in the place of all that is named.
    pub(crate) fn told_as_a_walk(mut self, odds: f64) -> Self {
        let base = self.examined.selection.base;
        let effects = self.examined.selection.models[base].key();
        let walk = Unmodelled { cause: Cause::WanderingZero, effects, weight: odds, gain: odds, row: None };
        let decision = Decision { unmodelled: Some(walk), ..Decision::nothing(Verdict::Unexplained, base) };
        self.predicted = self.predicted.with_nothing(decision, &self.by_base);
        self.held = Vec::new();
        self
    }

    /// The same where one drift beside a walk stands in the place of all that is named.
    fn told_as_a_drift(self, prepared: &Prepared<'_>, drift: Simple) -> Self {
        let Simple { tried, held, unseen } = drift;
        let after = prepared.lack_of_fit.adequacy(&tried.fit);
        let removed = self.share_removed_by(prepared, &tried, &unseen, &after);
        let sets: Vec<Vec<usize>> = tried.effects.iter().map(|effect| vec![*effect]).collect();
        self.told_by_sets(tried, held, unseen, after, (sets, removed))
    }
}

impl Decision {
    /// The same where a cause outside the library cannot be excluded in the place of these effects: nothing is open where none of them is claimed.
    #[must_use]
    pub(crate) fn with_open(self, open: &[usize]) -> Self {
        if open.iter().all(|effect| self.carried.contains(effect)) {
            return self;
        }
        Self { verdict: Verdict::Ambiguous, unmodelled_rivals: true, ..self }
    }
}

#[cfg(test)]
#[allow(clippy::single_range_in_vec_init)] // one run
pub(crate) mod tests {
    use super::*;
    use crate::{
        Options, Problem,
        common::{Plate, without_rest},
    };
    use nalgebra::{DMatrix, DVector};
    use rand::SeedableRng;
    use rand_chacha::ChaCha8Rng;
    use rand_distr::{Distribution, StandardNormal};
    use std::sync::atomic::AtomicBool;
    use truegap_core::Simulator;

    const ROWS: usize = 600;
    /// White noise of a row.
    pub(crate) const NOISE: f64 = 0.01;

    /// A noise that nobody measured.
    pub(crate) fn noise(rows: usize, response: Noise) -> NoiseModel {
        NoiseModel::unmeasured(response, InputError::white(vec![0.0; rows]))
    }

    /// Covariance of a walk and white noise: `s^2 t_i` of the earlier of two rows, and the white variance of one; rows a second or four apart.
    #[test]
    fn the_filter_of_a_walk_is_the_inverse_of_its_covariance() {
        let time: Vec<f64> = (0..40).map(|row| f64::from(row) + 3.0 * f64::from(row / 7)).collect();
        let (walk, white, length) = (2.0, 0.3, time[39]);
        let covariance =
            DMatrix::from_fn(40, 40, |i, j| walk * walk * time[i.min(j)] / length + if i == j { white * white } else { 0.0 });
        let white_alone = Noise { white_sd: 1.0, ar_sd: 0.5, ar_correlation: 0.9 };
        is_inverse(&with_walk(&noise(40, white_alone), &time, walk, white), covariance);
    }

    /// Asserts that the filter of a noise of one run weighs a column as its covariance does.
    pub(crate) fn is_inverse(noise: &NoiseModel, covariance: DMatrix<f64>) {
        let rows = covariance.nrows();
        let y: Vec<f64> = (0..rows).map(|row| (0.4 * row as f64).sin()).collect();
        let factor = covariance.cholesky().unwrap();
        let column = DVector::from_column_slice(&y);
        let exact = column.dot(&factor.solve(&column)) + factor.l_dirty().diagonal().iter().map(|d| 2.0 * d.ln()).sum::<f64>();
        let filter = noise.whitener(&[0..rows], None);
        let mut whitened = y;
        filter.apply(&mut whitened);
        approx::assert_relative_eq!(filter.deviance(&whitened), exact, max_relative = 1e-10);
    }

    /// What is `asked` of the base model and of the drift that is fitted to what `zero` adds to a plate, in so many rows with white noise, which is `taken` for another one.
    pub(crate) fn beside_a_drift<T>(
        (seed, rows, taken): (u64, usize, Noise),
        zero: impl Fn(&[f64]) -> Vec<f64>,
        asked: impl FnOnce(&Search<'_>, &NoiseModel, &Tried) -> T,
    ) -> T {
        let inputs = without_rest(rows);
        let random = &mut ChaCha8Rng::seed_from_u64(seed);
        let drawn: Vec<f64> = (0..2 * rows).map(|_| StandardNormal.sample(random)).collect();
        let plate = Plate::new(Some(false));
        let clean = plate.respond(&plate.centre(), &inputs, &[]).unwrap();
        let zero = zero(&drawn[..rows]);
        let response: Vec<f64> = (0..rows).map(|row| clean[row] + zero[row] + NOISE * drawn[rows + row]).collect();
        let problem = Problem { inputs: &inputs, response: &response, simulator: &plate };
        let options = Options { effects: vec!["offset_drift".into()], ..Options::default() };
        let prepared = Prepared::new(&problem, noise(rows, taken), &options).unwrap();
        let searched = prepared.searched();
        let stop = AtomicBool::new(false);
        let search = prepared.search(&searched, &|_| (), &stop);
        let named = search.add_each(&search.base().unwrap(), &[0], 1, "test").pop().unwrap();
        asked(&search, &prepared.searched_noise, &named)
    }

    /// A zero that settles at ten times the noise.
    pub(crate) fn settles(rows: usize) -> Vec<f64> {
        (0..rows).map(|row| 10.0 * NOISE * (1.0 - (-(row as f64) / 200.0).exp())).collect()
    }

    /// Log odds of a walk against that drift, under the noise of one memory that short stretches of a walk have.
    fn odds(seed: u64, zero: impl Fn(&[f64]) -> Vec<f64>) -> f64 {
        let steep = Noise { white_sd: NOISE, ar_sd: NOISE, ar_correlation: 0.97 };
        beside_a_drift((seed, ROWS, steep), zero, |search, noise, named| {
            assert_eq!(drifts(search, named), [0]);
            let [walk, named] = with_and_without(search, noise, named, &[0]).unwrap();
            walk - named
        })
    }

    #[test]
    fn a_walk_is_not_excluded_beside_a_drift_and_a_drift_excludes_it() {
        for seed in 1..5 {
            let walk = |steps: &[f64]| {
                let step = |at: &mut f64, step: &f64| {
                    *at += 0.3 * NOISE * step;
                    Some(*at)
                };
                steps.iter().scan(0.0, step).collect()
            };
            let found = odds(seed, walk);
            assert!(found > RIVAL.ln(), "{seed}: {found}");
            let found = odds(seed, |_| settles(ROWS));
            assert!(found < RIVAL.ln(), "{seed}: {found}");
        }
    }

    #[test]
    fn what_is_carried_and_not_claimed_leaves_nothing_open() {
        let decision = || Decision { model: 1, sets: vec![vec![3], vec![7]], ..Decision::nothing(Verdict::Explained, 0) };
        assert_eq!(decision().with_open(&[7]).verdict, Verdict::Ambiguous);
        assert_eq!(decision().with_open(&[]).verdict, Verdict::Explained);
        assert_eq!(Decision { carried: vec![7], ..decision() }.with_open(&[7]).verdict, Verdict::Explained);
    }
}
