//! A model of the library that predicts rows left out clearly better than the likeliest one under the noise, found by adding one effect after another.
//!
//! Evidence weighs models by a noise and by equations that are taken to hold. Where equations only describe, all models are off by more than the noise, and the likeliest one is
//! the one that follows the rows that it has seen. So a second choice is made by prediction alone: at each step the effect that foretells rows left out best, while it foretells them clearly
//! better than the model before it. It takes the place of the first choice where it predicts better by a tenth, or as well with fewer effects.
//! Where the first choice was to name nothing, a twentieth is enough.
//!
//! **Source:** Stone, Cross-validatory choice and assessment of statistical predictions, J. R. Stat. Soc. B 36 (1974) 111.
//!
//! Limits: not for a base model with plates, the equations of whose effects are derived; effects that promise most at each step; no number for whatever happens.

use crate::{
    adequacy::lack_of_fit::Adequacy,
    data::context::Number,
    effects::numbers::free_to_be_nothing,
    fit::{levenberg_marquardt::FitOptions, maximum_a_posteriori::fit, tuning::LOOSE},
    pipeline::{
        alone::{left_over, white},
        calibrated::predicted_like_base,
        judged::{Judged, Told},
        prepare::Prepared,
        richer_laws::{opened_ways, other_laws_of, promises},
        simple_laws::{Simple, simple},
    },
    selection::{
        candidates::{Search, Tried},
        refitted::fitted_from_nothing,
        tuning::HALF,
        verdict::Verdict,
        whole::whole,
    },
    text::Scale,
    validation::{
        cross_validation::{HeldOutFit, compared},
        tuning::{CLEARLY_WORSE, FELT, MOST_ADDED, MOST_ASKED, MOST_RIVALS},
    },
};
use std::{cell::Cell, sync::atomic::Ordering};

/// A model that predicts rows left out better.
pub(crate) struct ByRowsLeftOut {
    /// the model
    pub tried: Tried,
    /// numbers of its laws that are held at nothing
    pub held: Vec<Number>,
    /// what it foretells of rows left out
    pub unseen: HeldOutFit,
    /// what may stand in the place of each of its effects, itself first: what predicts rows left out nearly as well
    pub sets: Vec<Vec<usize>>,
    /// what it leaves over
    pub after: Adequacy,
    /// share of the misfit that it removes
    pub removed: f64,
    /// why it stands, for a reader
    pub says: String,
}

/// What rows left out choose.
pub(crate) enum Chosen {
    /// a model that predicts them better than what is stood behind
    Better(Box<ByRowsLeftOut>),
    /// what is stood behind, or nothing that could be asked
    AsItIs,
    /// the base model: no effect predicts them clearly better
    Nothing,
}

/// A model, the numbers of its laws that are held at nothing, and what it foretells.
struct Asked {
    tried: Tried,
    held: Vec<Number>,
    unseen: HeldOutFit,
}

/// For each effect of a model, models with another one in its place.
type Rivals = Vec<Vec<Asked>>;

/// What becomes of laws that have run to a limit of their numbers while effects are added. None is told of in the end.
#[derive(Clone, Copy, PartialEq)]
enum OnLimits {
    Refused,
    /// taken, since beside the next effect it may not lie there
    OnTheWay,
}

/// What a choice is made with.
struct Choice<'s, 'a> {
    prepared: &'s Prepared<'a>,
    /// under the noise
    search: &'s Search<'s>,
    /// that by which effects are added: under the noise, or by least squares where nothing explains the recording under it
    adding: &'s Search<'s>,
    judged: &'s Judged,
    /// whether a law was refused for a limit that it had run to
    refused: Cell<bool>,
}

/// The model that predicts rows left out clearly better than what `judged` stands behind, or as well with fewer effects.
pub(crate) fn by_rows_left_out(prepared: &Prepared<'_>, told: &Told<'_>, judged: &Judged) -> Chosen {
    let searched = prepared.searched();
    let search = &prepared.search(&searched, told.progress, told.stop);
    let derived = search.context.has_plates();
    let free = told.options.withheld.is_none() && told.options.restricted.is_none() && judged.kept_back.is_none();
    // what was found and taken back shows a difference too, of which another effect may foretell more
    let taken_back = !judged.predicted.left_out.is_empty();
    let differs = judged.names_something() || taken_back || judged.predicted.decision.verdict != Verdict::Agrees;
    if derived || !free || !differs || told.stop.load(Ordering::Relaxed) {
        return Chosen::AsItIs;
    }
    let base = judged.examined.selection.base();
    if judged.names_something() {
        return Choice { prepared, search, adding: search, judged, refused: Cell::new(false) }.made(base.clone());
    }
    // noise of an instrument at rest weighs a misfit at work by its quick parts: a shift by which most of it goes may be beyond a hill there
    let Some(size) = left_over(&search.model_over(prepared.problem, &[]), &base.fit.z) else { return Chosen::AsItIs };
    let (noise, runs) = (white(&prepared.searched_noise, size), searched.runs());
    let (whitener, loose) = (noise.whitener(&runs, None), noise.scaled(LOOSE).whitener(&runs, None));
    let adding = &Search { whitener: &whitener, loose: &loose, scout: None, library: search.library.clone(), ..*search };
    adding.base().map_or(Chosen::AsItIs, |base| Choice { prepared, search, adding, judged, refused: Cell::new(false) }.made(base))
}

impl Choice<'_, '_> {
    /// From the base model as it is calibrated where effects are added.
    fn made(&self, base: Tried) -> Chosen {
        // richer laws are open from the start, since rows left out judge them at once; other laws are asked one at a time
        let held: Vec<Number> =
            self.search.library.iter().flat_map(|effect| other_laws_of(self.search, *effect)).flatten().collect();
        let base = || Asked { tried: base.clone(), held: held.clone(), unseen: self.judged.by_base.unseen.clone() };
        let found = self.forward(base(), OnLimits::Refused);
        let nothing = found.is_none();
        // a law that has run to a limit alone may hold beside another: a logarithm beside a drift that fades
        let on_the_way = if self.refused.get() { self.forward(base(), OnLimits::OnTheWay) } else { None };
        let better = [found, on_the_way].into_iter().flatten().filter_map(|found| self.better(self.exchanged(found)));
        match better.reduce(|a, b| if compared(&a.unseen, &b.unseen).is_some_and(|both| both.better_by(FELT)) { b } else { a }) {
            Some(better) => Chosen::Better(Box::new(better)),
            None if nothing => Chosen::Nothing,
            None => Chosen::AsItIs,
        }
    }

    /// A model that was `found`, where it is better than what is stood behind; `None` where it is not.
    fn better(&self, (found, rivals): (Asked, Option<Rivals>)) -> Option<ByRowsLeftOut> {
        let selection = &self.judged.examined.selection;
        let chosen = &selection.models[self.judged.predicted.decision.model];
        let told = self.judged.predicted.unseen.stood_behind();
        // better, or as well with fewer effects
        let fewer = found.tried.effects.len() < chosen.effects.len();
        // where nothing is named there is no other choice: what is clearly better than nothing is part of what is missing, however much it leaves
        let named = !chosen.effects.is_empty();
        let least = if named { FELT } else { CLEARLY_WORSE };
        let judged = |unseen: &HeldOutFit| {
            let both = compared(told, unseen)?;
            let clearly = both.better_by(least);
            (clearly || (fewer && both.rmse[1] <= both.rmse[0])).then_some((both.rmse, clearly))
        };
        // the same effects by other laws are another model
        judged(&found.unseen)?;
        let context = self.search.context.holding(found.held.clone());
        let narrow = &self.search.within(&context);
        let Simple { tried, held, unseen } =
            simple(self.prepared, narrow, &self.judged.by_base, &self.under_the_noise(narrow, &found.tried)?, 1.0)?;
        let ([first, second], clearly) = judged(&unseen)?;
        let after = self.prepared.lack_of_fit.adequacy(&tried.fit);
        let removed = self.judged.share_removed_by(self.prepared, &tried, &unseen, &after);
        if (named && after.fires() && removed < HALF) || runs_to_limit(narrow, &tried) {
            return None;
        }
        let unit = Scale::of(self.search.problem.simulator.unit(), second);
        let under_the_noise = match chosen.effects.as_slice() {
            [] => "nothing explains it under the noise".to_owned(),
            _ if found.tried.key() == chosen.key() => "other laws by this name would fit better under the noise".to_owned(),
            effects => format!("{} would fit better under the noise", self.prepared.names(effects)),
        };
        let says = format!(
            "{under_the_noise}, but {} predicts rows left out {} ({} against {}), so that was preferred",
            self.prepared.names(&tried.effects),
            if clearly { "better" } else { "as well" },
            unit.text(second),
            unit.text(first),
        );
        let rivals = rivals.unwrap_or_else(|| self.rivals(&found));
        let sets = self.with_first_choice(&tried.effects, sets(&found, rivals));
        Some(ByRowsLeftOut { tried, held, unseen, sets, after, removed, says })
    }

    /// A model that was found, under the noise: its optimum, or, where it was found by least squares, the place that it has.
    fn under_the_noise(&self, search: &Search<'_>, found: &Tried) -> Option<Tried> {
        if self.judged.names_something() {
            return search.polished(found);
        }
        let there = FitOptions { iterations: 0, ..FitOptions::default() };
        let fit = fit(&search.model(&found.effects), search.whitener, &found.fit.z, &there).ok()?;
        Some(Tried { effects: found.effects.clone(), fit })
    }

    /// One effect after another, each the one that foretells rows left out best; `None` where none foretells them clearly better than the base model.
    fn forward(&self, base: Asked, on_limits: OnLimits) -> Option<Asked> {
        let mut best = base;
        for _ in 0..MOST_ADDED {
            let mut added = self.added(&best.tried, &best.held, (MOST_ASKED, on_limits));
            let least = if best.tried.effects.is_empty() { CLEARLY_WORSE } else { FELT };
            let asked: Vec<&HeldOutFit> = added.iter().map(|asked| &asked.unseen).collect();
            let Some(index) = foretells_most(&best.unseen, &asked, least) else { break };
            best = added.swap_remove(index);
        }
        Some(best).filter(|best| !best.tried.effects.is_empty())
    }

    /// A model that was `found` with its effects [`exchanged`], and its rivals where they were asked: not of one effect, which was the best of them.
    fn exchanged(&self, found: Asked) -> (Asked, Option<Rivals>) {
        if found.tried.effects.len() < 2 {
            return (found, None);
        }
        let (found, rivals) = exchanged(found, |asked| &asked.unseen, |asked| self.rivals(asked));
        (found, Some(rivals))
    }

    /// For each effect of a model, the models with another one in its place.
    fn rivals(&self, model: &Asked) -> Rivals {
        let own = self.adding.without_each(&model.tried);
        let of = |effect: &usize| {
            let without =
                own.iter().find(|tried| !tried.effects.contains(effect) && tried.effects.len() + 1 == model.tried.effects.len());
            without.map_or_else(Vec::new, |without| self.added(without, &model.held, (MOST_RIVALS, OnLimits::Refused)))
        };
        model.tried.effects.iter().map(of).collect()
    }

    /// Models with one effect more, the `most` that promise most, asked for rows left out; each with the law of its new effect as it is and with the simple law that it holds as a special case.
    fn added(&self, from: &Tried, held: &[Number], (most, on_limits): (usize, OnLimits)) -> Vec<Asked> {
        let context = self.search.context.holding(held.to_vec());
        let search = &self.adding.within(&context);
        let of_equations: Vec<usize> = (0..search.library.len()).filter(|e| !search.library[*e].free_form()).collect();
        let added = search.add_each(from, &of_equations, most, "rows left out");
        added
            .into_iter()
            .filter_map(|tried| whole(search, tried))
            .filter_map(|tried| self.asked(search, tried, on_limits))
            .collect()
    }

    /// A model asked for rows left out, with the best of the laws of its last effect; `None` where a law has run to a limit of its numbers, which is refused: there it does not hold.
    fn asked(&self, search: &Search<'_>, tried: Tried, on_limits: OnLimits) -> Option<Asked> {
        let effect = search.library[*tried.effects.last()?];
        let ask = |search: &Search<'_>, tried: Tried| {
            if on_limits == OnLimits::Refused && runs_to_limit(search, &tried) {
                self.refused.set(true);
                return None;
            }
            let unseen = predicted_like_base(self.prepared, search, &self.judged.by_base, &tried);
            Some(Asked { tried, held: search.context.held.clone(), unseen })
        };
        let numbers = free_to_be_nothing(effect, search.context);
        let with = |held: Vec<Number>, opened: &[Number]| {
            let context = search.context.holding(held);
            let search = &search.within(&context);
            let other = fitted_from_nothing(search, &tried, &[&search.context.held, opened].concat())?;
            if opened.is_empty() || promises(&other, &tried) { ask(search, other) } else { None }
        };
        let plain = (!numbers.is_empty()).then(|| with([search.context.held.as_slice(), &numbers].concat(), &[]));
        let laws = other_laws_of(search, effect).into_iter();
        let ways =
            laws.flat_map(|opened| opened_ways(search, &tried, &opened).into_iter().map(move |held| (opened.clone(), held)));
        let others: Vec<Asked> = ways.filter_map(|(opened, held)| with(held, &opened)).collect();
        let as_it_is = [plain.flatten(), ask(search, tried.clone())].into_iter().flatten().reduce(|a, b| better_of(a, b, 1.0));
        // another law has to be clearly better
        others.into_iter().fold(as_it_is, |best, other| {
            Some(match best {
                Some(best) => better_of(best, other, CLEARLY_WORSE),
                None => other,
            })
        })
    }

    /// The sets of `effects` with what evidence had chosen: where the two choices differ, what the one names in the place of the other is not excluded.
    fn with_first_choice(&self, effects: &[usize], sets: Vec<Vec<usize>>) -> Vec<Vec<usize>> {
        let decision = &self.judged.predicted.decision;
        let chosen = &self.judged.examined.selection.models[decision.model].effects;
        let only_there = |effect: &&usize| !effects.contains(effect) && **effect < self.search.library.len();
        let place = |effect: &usize| chosen.iter().position(|e| e == effect).and_then(|place| decision.sets.get(place));
        let instead: Vec<usize> =
            chosen.iter().filter(only_there).flat_map(|e| place(e).cloned().unwrap_or_else(|| vec![*e])).collect();
        let with = |(effect, mut set): (&usize, Vec<usize>)| {
            if !chosen.contains(effect) {
                let new: Vec<usize> = instead.iter().copied().filter(|e| !set.contains(e) && !effects.contains(e)).collect();
                set.extend(new);
            }
            set
        };
        effects.iter().zip(sets).map(with).collect()
    }
}

/// Which of the models that were `asked` foretells most beside the one `before`, of those that predict rows left out better by more than `least`: the one that leaves the least share of its error. A
/// part in which a change of one model lies is not asked of it, so that errors as such are over other rows in each.
fn foretells_most(before: &HeldOutFit, asked: &[&HeldOutFit], least: f64) -> Option<usize> {
    let share = |asked: &HeldOutFit| {
        let both = compared(before, asked)?;
        both.better_by(least).then(|| both.rmse[1] / both.rmse[0])
    };
    let shares = asked.iter().enumerate().filter_map(|(index, asked)| Some((index, share(asked)?)));
    shares.min_by(|a, b| a.1.total_cmp(&b.1)).map(|(index, _)| index)
}

/// A model that was `found`, or what its `rivals` lead to while the best of them foretells rows left out clearly better, and the rivals of that: the effect that was added first was best alone, and need not be beside what came after
/// it.
fn exchanged<T>(mut found: T, unseen: impl Fn(&T) -> &HeldOutFit, rivals: impl Fn(&T) -> Vec<Vec<T>>) -> (T, Vec<Vec<T>>) {
    let mut others = rivals(&found);
    for _ in 0..MOST_ADDED {
        let asked: Vec<&HeldOutFit> = others.iter().flatten().map(&unseen).collect();
        let Some(index) = foretells_most(unseen(&found), &asked, FELT) else { break };
        found = others.into_iter().flatten().nth(index).unwrap_or(found);
        others = rivals(&found);
    }
    (found, others)
}

/// For each effect of a model: itself, and those of its `rivals` with which it predicts rows left out nearly as well.
fn sets(model: &Asked, rivals: Rivals) -> Vec<Vec<usize>> {
    // clearly worse is what the model is clearly better than
    let near = |asked: &Asked| compared(&asked.unseen, &model.unseen).is_some_and(|both| !both.better_by(CLEARLY_WORSE));
    let set = |(effect, rivals): (&usize, Vec<Asked>)| {
        let new = rivals.iter().filter(|asked| near(asked)).filter_map(|asked| asked.tried.effects.last().copied());
        std::iter::once(*effect).chain(new.filter(|new| !model.tried.effects.contains(new))).collect()
    };
    model.tried.effects.iter().zip(rivals).map(set).collect()
}

/// The second of two models where it predicts rows left out `least` times better or more, else the first.
fn better_of(first: Asked, second: Asked, least: f64) -> Asked {
    let better = compared(&first.unseen, &second.unseen).is_some_and(|both| both.rmse[0] > least * both.rmse[1]);
    if better { second } else { first }
}

/// Whether the law of an effect of a model has run to a limit.
fn runs_to_limit(search: &Search<'_>, tried: &Tried) -> bool {
    (0..tried.effects.len()).any(|index| !search.on_limits(tried, index).is_empty())
}

impl Judged {
    /// The same with the model that predicts rows left out better stood behind.
    pub(crate) fn told_by_rows_left_out(mut self, better: ByRowsLeftOut) -> Self {
        let ByRowsLeftOut { tried, held, unseen, sets, after, removed, says } = better;
        self.predicted.left_out = vec![says];
        self.told_by_sets(tried, held, unseen, after, (sets, removed))
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::validation::cross_validation::PartError;

    /// Parts of ten rows each with these errors; `None` was not asked.
    fn unseen(errors: [Option<f64>; 3]) -> HeldOutFit {
        let part = |error: Option<f64>| PartError {
            name: String::new(),
            squares: error.map(|e| 10.0 * e * e),
            rows: 10,
            score: None,
            warned: None,
        };
        HeldOutFit { parts: errors.into_iter().map(part).collect(), ..HeldOutFit::default() }
    }

    /// Others of 1.00 are 0.97 and 0.80, of that 0.79 and 0.60, and of that none that is a tenth better.
    #[test]
    fn effects_are_exchanged_while_that_foretells_more() {
        let model = |error: f64| unseen([Some(error); 3]);
        let others = |at: &HeldOutFit| {
            let error = PartError::rmse_over(&at.parts).unwrap();
            let near = |of: f64| (error - of).abs() < 1e-9;
            match () {
                () if near(1.0) => vec![vec![model(0.97)], vec![model(0.8)]],
                () if near(0.8) => vec![vec![model(0.6), model(0.79)], Vec::new()],
                () => vec![vec![model(0.58)]],
            }
        };
        let (found, rivals) = exchanged(model(1.0), |at| at, others);
        let error = |of: &HeldOutFit| PartError::rmse_over(&of.parts).unwrap();
        approx::assert_relative_eq!(error(&found), 0.6, max_relative = 1e-12);
        // and its rivals are those of what was found in the end
        approx::assert_relative_eq!(error(&rivals[0][0]), 0.58, max_relative = 1e-12);
    }

    /// A change lies in the third part, where errors are largest. What is asked for the others alone leaves nine tenths of the error there, in smaller numbers than what halves it in all three.
    #[test]
    fn what_leaves_the_least_share_goes_first_whatever_rows_it_was_asked_for() {
        let before = unseen([Some(10.0), Some(10.0), Some(60.0)]);
        let halves = unseen([Some(5.0), Some(5.0), Some(30.0)]);
        let changes = unseen([Some(8.0), Some(8.0), None]);
        let worse = unseen([Some(11.0), Some(11.0), Some(59.0)]);
        assert_eq!(foretells_most(&before, &[&changes, &halves, &worse], 1.1), Some(1));
        assert_eq!(foretells_most(&before, &[&changes, &worse], 1.1), Some(0));
        assert_eq!(foretells_most(&before, &[&worse], 1.0), None);
    }
}
