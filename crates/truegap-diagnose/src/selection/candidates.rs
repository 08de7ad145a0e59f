//! Which effects, alone and together, explain a recording: singles, forward steps, swaps, pairs of the best.
//!
//! Limits: at most three effects at once.

use crate::{
    data::{context::Context, problem::Problem},
    effects::{effect::Effect, sentence::at_once},
    fit::{
        levenberg_marquardt::{FitOptions, objective},
        maximum_a_posteriori::{approach, fit, fit_apart, fit_onwards, fit_where_promising},
        model::Model,
        optimum::{Fit, Linearised},
        score_test::scores,
        ways::Ways,
    },
    noise::scout::{Scout, scouted},
    selection::effect_set::EffectSet,
    selection::start::{Start, held_from, keep_best, with_one_more, zero_size},
    selection::tuning::{DRIVEN_FAR, FAR_PROMISE, FAR_SHARE, HOPELESS, LOOSE_FITS, PROMISING_START, STARTS},
    whitening::{noise_model::NoiseModel, whitener::Whitener},
};
use nalgebra::DMatrix;
use rayon::prelude::*;
use std::{
    collections::BTreeMap,
    sync::atomic::{AtomicBool, Ordering},
};
use truegap_core::SimulationError;

/// A model that was fitted: the base with some effects of the library.
#[derive(Clone)]
pub struct Tried {
    /// indices into [`Search::library`], in the order in which they were added
    pub effects: Vec<usize>,
    /// its fit
    pub fit: Fit,
}

impl Tried {
    /// The same effects whatever their order.
    pub fn key(&self) -> EffectSet {
        EffectSet::from(self.effects.as_slice())
    }
}

#[cfg(test)]
impl Tried {
    /// A model with these effects that leaves `residual`, all its numbers at 0: for what is made of fitted models.
    pub(crate) fn leaving(residual: Vec<f64>, effects: &[usize]) -> Self {
        let (count, rows) = (1 + effects.len(), residual.len());
        let free = vec![(f64::NEG_INFINITY, f64::INFINITY); count];
        let (z, kinds) = (vec![0.0; count], crate::fit::model::Kinds::default());
        let fit = crate::fit::optimum::finish(z, residual, DMatrix::zeros(rows, count), &free, kinds, (1, true));
        Self { effects: effects.to_vec(), fit }
    }
}

/// What is being tried, for a progress bar.
#[derive(Clone, Debug)]
pub struct Progress {
    /// step of the pipeline
    pub step: &'static str,
    /// what is tried
    pub what: String,
    /// share done, 0 to 1
    pub done: f64,
}

/// Numbers of effects, each as some fits of smaller models have found them.
pub(crate) type Found = BTreeMap<usize, Vec<Vec<f64>>>;

/// Everything a search needs.
pub struct Search<'a> {
    /// recording and simulator
    pub problem: &'a Problem<'a>,
    /// facts for the effects
    pub context: &'a Context<'a>,
    /// effects that this recording can show
    pub library: Vec<&'a dyn Effect>,
    /// noise
    pub whitener: &'a Whitener,
    /// the same noise, many times larger: a fit to it stays near what is known beforehand
    pub loose: &'a Whitener,
    /// few rows, on which the calibration of the base model begins
    pub scout: Option<&'a Scout>,
    /// told what is tried
    pub progress: &'a (dyn Fn(Progress) + Sync),
    /// set from outside to end early with what is known
    pub stop: &'a AtomicBool,
}

impl<'a> Search<'a> {
    /// The base model alone.
    ///
    /// # Errors
    /// Those of the simulator.
    pub fn base(&self) -> Result<Tried, SimulationError> {
        let model = self.model(&[]);
        Ok(Tried { effects: Vec::new(), fit: scouted(&model, self.whitener, self.loose, self.scout, NoiseModel::clone)? })
    }

    /// The base model with these effects.
    pub fn model(&self, effects: &[usize]) -> Model<'a> {
        self.model_over(self.problem, effects)
    }

    /// The same over the rows of another problem, as every row of which the searched ones are means.
    pub fn model_over<'m>(&self, problem: &'m Problem<'m>, effects: &[usize]) -> Model<'m>
    where
        'a: 'm,
    {
        Model::new(problem, self.context, effects.iter().map(|i| self.library[*i]).collect())
    }

    /// The same search in another context.
    pub(crate) fn within<'n>(&'n self, context: &'n Context<'n>) -> Search<'n> {
        Search { context, library: self.library.clone(), ..*self }
    }

    /// Adds each of `candidates` to `from`, in parallel; only the `most` that promise most are fitted.
    pub fn add_each(&self, from: &Tried, candidates: &[usize], most: usize, step: &'static str) -> Vec<Tried> {
        self.add_each_as_found(from, candidates, most, step, &Found::default())
    }

    /// The same, which also starts where an effect's numbers were found by an earlier fit.
    pub(crate) fn add_each_as_found(
        &self,
        from: &Tried,
        candidates: &[usize],
        most: usize,
        step: &'static str,
        found: &Found,
    ) -> Vec<Tried> {
        let open = |c: &&usize| !from.effects.contains(c) && !self.stop.load(Ordering::Relaxed);
        let linearised = from.fit.linearised();
        let loosened = self.loosened(from).map(|l| (l.fit.linearised(), l));
        let mut launches = vec![Launch { from, linearised: &linearised, noise: LaunchNoise::Measured }];
        launches.extend(loosened.as_ref().map(|(linearised, from)| Launch { from, linearised, noise: LaunchNoise::Loose }));
        let starts = |candidate: usize| launches.iter().map(|l| self.promising(*l, candidate, found)).collect::<Vec<_>>();
        let mut promising: Vec<(usize, Vec<Vec<Start>>)> = candidates.par_iter().filter(open).map(|c| (*c, starts(*c))).collect();
        let gain =
            |starts: &[Vec<Start>]| starts.iter().filter_map(|s| s.first()).map(|s| s.gain).fold(f64::NEG_INFINITY, f64::max);
        promising.retain(|(_, starts)| gain(starts) > f64::NEG_INFINITY);
        promising.sort_by(|a, b| gain(&b.1).total_cmp(&gain(&a.1)));
        promising.truncate(most);
        keep_best(&mut promising, 1, LOOSE_FITS);
        let done = std::sync::atomic::AtomicUsize::new(0);
        let total = promising.len().max(1) as f64;
        let fitted = promising.par_iter().filter(|_| !self.stop.load(Ordering::Relaxed)).filter_map(|(candidate, starts)| {
            let fits = launches.iter().zip(starts).filter_map(|(launch, starts)| self.add(*launch, *candidate, starts));
            let tried = fits.max_by(|a, b| a.fit.log_evidence.total_cmp(&b.fit.log_evidence));
            let count = done.fetch_add(1, Ordering::Relaxed) + 1;
            (self.progress)(Progress { step, what: self.library[*candidate].id().to_string(), done: count as f64 / total });
            tried
        });
        fitted.collect()
    }

    /// `launch` with one more effect, fitted from its most promising starts; `None` where no start has an answer.
    fn add(&self, launch: Launch<'_>, candidate: usize, starts: &[Start]) -> Option<Tried> {
        let mut effects = launch.from.effects.clone();
        effects.push(candidate);
        let model = self.model(&effects);
        let best = starts.first()?;
        let close = starts.iter().take(STARTS).filter(|s| s.gain >= PROMISING_START * best.gain);
        let starts: Vec<&Start> = if best.gain > HOPELESS { close.collect() } else { vec![best] };
        let mut been = Been::default();
        let fits = starts.iter().filter_map(|s| self.refine(&model, s, launch, &mut been));
        let fit = fits.max_by(|a, b| a.log_evidence.total_cmp(&b.log_evidence))?;
        // a larger model cannot fit worse than the one that it holds: start again from there
        let lost = launch.noise == LaunchNoise::Measured
            && !self.library[candidate].foreseen()
            && fit.objective() > launch.from.fit.objective() + 0.5;
        let again = if lost { self.with_nothing_added(&model, launch, best) } else { None };
        Some(Tried { effects, fit: again.unwrap_or(fit) })
    }

    /// The noise under which `launch` was fitted.
    fn whitener_of(&self, launch: Launch<'_>) -> &'a Whitener {
        match launch.noise {
            LaunchNoise::Measured => self.whitener,
            LaunchNoise::Loose => self.loose,
        }
    }

    /// A fit that starts where the new effect is absent, with the shape of `start`.
    fn with_nothing_added(&self, model: &Model<'_>, launch: Launch<'_>, start: &Start) -> Option<Fit> {
        let mut z = start.z.clone();
        let first = launch.from.fit.z.len();
        z[..first].copy_from_slice(&launch.from.fit.z);
        z[first] = zero_size(model, model.effects.len() - 1);
        fit_onwards(model, self.whitener, &z, &launch.from.fit.jacobian, &FitOptions::default()).ok()
    }

    /// Places of the numbers of effect `index` of a model, its size aside, that lie on a limit which is no plain special case (nothing or all of a part): there its law does not hold. So does one whose mark is not told
    /// from there.
    pub(crate) fn on_limits(&self, tried: &Tried, index: usize) -> Vec<usize> {
        let model = self.model(&tried.effects);
        let values = model.values(&tried.fit.z);
        let effect = model.effects[index];
        let special = |i: usize| {
            let value = values[i];
            value == 0.0 || (value - 1.0).abs() < 1e-9 || at_once(effect, &model.parameters[i], value)
        };
        let (z, sd, bounds) = (&tried.fit.z, &tried.fit.sd, model.bounds());
        let unseen =
            |i: usize| effect.mark().is_some_and(|mark| mark.is_unseen(&model.parameters[i].name, z[i], sd[i], bounds[i]));
        model.range_of(index).skip(1).filter(|i| (tried.fit.at_limit[*i] && !special(*i)) || unseen(*i)).collect()
    }

    /// The effects of a model that are kept, and the places of their coordinates and of the base model's.
    fn kept(&self, tried: &Tried, keeps: impl Fn(usize) -> bool) -> (Vec<usize>, Vec<usize>) {
        let whole = self.model(&tried.effects);
        let indices = || (0..tried.effects.len()).filter(|index| keeps(*index));
        let places = (0..whole.base_count()).chain(indices().flat_map(|index| whole.range_of(index)));
        (indices().map(|index| tried.effects[index]).collect(), places.collect())
    }

    /// The part of a model that holds these of its effects, fitted from where the whole one lies; `None` where it has no answer.
    pub(crate) fn part_of(&self, tried: &Tried, effects: &[usize]) -> Option<Tried> {
        let (effects, kept) = self.kept(tried, |index| effects.contains(&tried.effects[index]));
        let start: Vec<f64> = kept.iter().map(|i| tried.fit.z[*i]).collect();
        let fit = fit(&self.model(&effects), self.whitener, &start, &FitOptions::default()).ok()?;
        Some(Tried { effects, fit })
    }

    /// The same models with one effect less each, started from where the larger one ended: a shape that was found in company may hold alone, too.
    pub fn without_each(&self, tried: &Tried) -> Vec<Tried> {
        let without = |index: usize| {
            let (effects, kept) = self.kept(tried, |other| other != index);
            let start: Vec<f64> = kept.iter().map(|i| tried.fit.z[*i]).collect();
            let known = tried.fit.jacobian.select_columns(&kept);
            let fit = fit_onwards(&self.model(&effects), self.whitener, &start, &known, &FitOptions::default()).ok()?;
            Some(Tried { effects, fit })
        };
        (0..tried.effects.len()).filter_map(without).collect()
    }

    /// The same model, fitted to the end.
    pub fn polished(&self, tried: &Tried) -> Option<Tried> {
        let model = self.model(&tried.effects);
        let fit = fit_onwards(&model, self.whitener, &tried.fit.z, &tried.fit.jacobian, &FitOptions::default()).ok()?;
        Some(Tried { effects: tried.effects.clone(), fit })
    }

    /// Where calibration has driven the parameters of `from` far from what is known of them, hiding physics that is missing: its fit to
    /// larger noise, which stays near; more physics is better looked for from there.
    fn loosened(&self, from: &Tried) -> Option<Tried> {
        let model = self.model(&from.effects);
        let base = model.base_count();
        if from.fit.z[..base].iter().all(|z| z.abs() < DRIVEN_FAR) {
            return None;
        }
        let mut start = from.fit.z.clone();
        start[..base].fill(0.0);
        fit(&model, self.loose, &start, &FitOptions::default()).ok().map(|fit| Tried { effects: from.effects.clone(), fit })
    }

    /// Refits with everything free, after a first fit that holds the shape of the new effect; `None` where it would go a way on which an earlier start has `been`.
    fn refine(&self, model: &Model<'_>, start: &Start, launch: Launch<'_>, been: &mut Been) -> Option<Fit> {
        let before = launch.from.fit.z.len();
        let bounds = held_from(model, &start.z, before + 1);
        let held = FitOptions { iterations: 3, tolerance: 1.0 };
        let mut z = start.z.clone();
        if z.len() > before + 1 {
            let known = &launch.from.fit.jacobian;
            z = approach(model, self.whitener_of(launch), &z, &bounds, known, (&held, f64::INFINITY), &mut been.held).ok()??;
        }
        let hopeless = start.gain <= HOPELESS;
        let options = FitOptions { iterations: if hopeless { 3 } else { 6 }, tolerance: 0.5 };
        if launch.noise == LaunchNoise::Measured {
            let known = Some(launch.from.fit.jacobian.as_ref());
            return fit_apart(model, self.whitener, &z, known, &options, hopeless, &mut been.measured).ok()?;
        }
        let options = |iterations: usize| FitOptions { iterations, tolerance: 0.5 };
        z = fit_apart(model, self.whitener_of(launch), &z, None, &options(8), false, &mut been.loose).ok()??.z;
        fit_apart(model, self.whitener, &z, None, &options(20), false, &mut been.measured).ok()?
    }

    /// Starting points of one more effect, most promising first, judged by one straight step from `from`.
    fn promising(&self, launch: Launch<'_>, candidate: usize, found: &Found) -> Vec<Start> {
        let mut effects = launch.from.effects.clone();
        effects.push(candidate);
        let model = &self.model(&effects);
        let last = model.effects.len() - 1;
        let parameters = &model.parameters[model.range_of(last)];
        let bounds = model.bounds()[model.first_of(last)];
        let mut starts: Vec<Start> = Vec::new();
        let to_z = |shape: Vec<f64>| parameters.iter().skip(1).zip(shape).map(|(p, v)| p.prior.z(v)).collect::<Vec<f64>>();
        let shapes: Vec<Vec<f64>> = model.effects[last].starts(self.context).into_iter().map(to_z).collect();
        for shape in &shapes {
            // a size that is foreseen lies far from 0, where it starts
            let (zero, foreseen) = (zero_size(model, last), -zero_size(model, last));
            for trial in [0.01, 0.5, -0.5].into_iter().chain((foreseen != 0.0).then_some(foreseen)) {
                // a step away from none, which a size that is foreseen may not reach
                if (bounds.0..=bounds.1).contains(&(zero + trial)) {
                    starts.extend(self.straight_step(launch, model, trial, shape, bounds));
                }
            }
        }
        if launch.from.effects.is_empty() {
            let far =
                model.effects[last].far_sizes(self.context, self.problem).into_iter().map(|size| parameters[0].prior.z(size));
            let shape = shapes.first().map_or(&[][..], Vec::as_slice);
            starts.extend(far.filter(|z| (bounds.0..=bounds.1).contains(z)).filter_map(|z| self.far(launch, model, z, shape)));
        }
        let found = found.get(&candidate).map_or(&[][..], Vec::as_slice);
        // less than a start has to promise beside the best one is not followed
        let least = PROMISING_START * starts.iter().map(|start| start.gain).fold(0.0, f64::max);
        starts.extend(found.iter().filter_map(|numbers| self.as_found(launch, model, numbers, least)));
        starts.sort_by(|a, b| b.gain.total_cmp(&a.gain));
        starts
    }

    /// `from` with one more effect, from where an earlier fit found its numbers; `None` where that leaves more than `objective` before all is fitted.
    pub(crate) fn otherwise(&self, from: &Tried, candidate: usize, numbers: &[f64], objective: f64) -> Option<Tried> {
        let linearised = from.fit.linearised();
        let launch = Launch { from, linearised: &linearised, noise: LaunchNoise::Measured };
        let effects: Vec<usize> = from.effects.iter().copied().chain([candidate]).collect();
        let model = self.model(&effects);
        let least = from.fit.objective() - objective;
        let start = self.as_found(launch, &model, numbers, least)?;
        let fit = self.refine(&model, &start, launch, &mut Been::default())?;
        Some(Tried { effects, fit })
    }

    /// A start with the new effect's numbers as an earlier fit found them, the others moved to where they are best beside these; `None` where that does not gain more than `least`, or nothing.
    fn as_found(&self, launch: Launch<'_>, model: &Model<'_>, numbers: &[f64], least: f64) -> Option<Start> {
        let from = &launch.from.fit;
        let z: Vec<f64> = from.z.iter().chain(numbers).copied().collect();
        let bounds = held_from(model, &z, from.z.len());
        let options = FitOptions { iterations: 2, tolerance: 1.0 };
        let whitener = self.whitener_of(launch);
        let level = from.objective() - least.max(0.0);
        let z = approach(model, whitener, &z, &bounds, &from.jacobian, (&options, level), &mut Ways::default()).ok()??;
        let gain = from.objective() - objective(model, &model.residual(&z, whitener).ok()?, &z);
        (gain > least.max(0.0)).then_some(Start { z, gain })
    }

    /// Size that a straight line through size 0 and one `trial` from there promises, and its gain in log likelihood.
    fn straight_step(
        &self,
        launch: Launch<'_>,
        model: &Model<'_>,
        trial: f64,
        shape: &[f64],
        bounds: (f64, f64),
    ) -> Option<Start> {
        let from = launch.from;
        let zero = zero_size(model, model.effects.len() - 1);
        let (mut z, column) = with_one_more(model, &from.fit, zero + trial, shape, self.whitener_of(launch))?;
        let found = scores(launch.linearised, &DMatrix::from_column_slice(column.len(), 1, &column));
        let (score, variance) = (found.scores[0], found.covariance[(0, 0)]);
        let best =
            (zero + (score - zero) / (variance + 1.0)).clamp(bounds.0, bounds.1).clamp(zero.min(0.0) - 4.0, zero.max(0.0) + 4.0);
        let step = best - zero;
        z[from.fit.z.len()] = if step == 0.0 { (zero + 1e-3 * trial.signum()).clamp(bounds.0, bounds.1) } else { best };
        Some(Start { z, gain: score * step - 0.5 * variance * step * step })
    }

    /// A start with this size, the base model calibrated beside it: what does not follow the reading at all is calibrated to no influence, and no shift of that shows.
    fn far(&self, launch: Launch<'_>, model: &Model<'_>, size: f64, shape: &[f64]) -> Option<Start> {
        let from = &launch.from.fit;
        let z: Vec<f64> = from.z.iter().copied().chain([size]).chain(shape.iter().copied()).collect();
        let bounds = held_from(model, &z, from.z.len());
        let (whitener, options) = (self.whitener_of(launch), FitOptions { iterations: 1, tolerance: 0.5 });
        let worth_it = FAR_PROMISE * (1.0 - FAR_SHARE) * from.objective();
        let found = fit_where_promising(model, whitener, &z, &bounds, &options, worth_it).ok()??;
        let gain = from.objective() - found.objective();
        // by chance one of many sizes gains a little; what is meant is most of what is left
        (gain > FAR_SHARE * from.objective()).then_some(Start { z: found.z, gain })
    }
}

/// Under which noise a model to start from was fitted.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
enum LaunchNoise {
    /// that of the recording
    Measured,
    /// many times more: the model stays near what is known beforehand
    Loose,
}

/// A fitted model to start from.
#[derive(Clone, Copy)]
struct Launch<'a> {
    from: &'a Tried,
    linearised: &'a Linearised,
    noise: LaunchNoise,
}

/// Where the searches from earlier starts of one model have been: while its shape was held, under larger noise, and under that of the recording.
#[derive(Default)]
struct Been {
    held: Ways,
    loose: Ways,
    measured: Ways,
}
