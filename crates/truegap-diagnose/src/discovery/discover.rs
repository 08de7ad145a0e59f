//! The mechanism that describes what the library leaves: screened, fitted, weighed, one or two.
//!
//! Limits: entered only where something reproducible is left; it never decides whether something is missing.

use crate::{
    discovery::{
        marginals::{SURE, WordProbabilities, marginals},
        screen::{Screen, Screened, screen},
    },
    effects::{
        composed::{effect::Composed, mechanism::Sentence, words::Kinetics},
        effect::Effect,
    },
    selection::candidates::{Search, Tried},
    stats::log_sum_exp,
};
use rayon::prelude::*;
use std::sync::atomic::Ordering;
use truegap_core::{EffectId, simulator::StageName};

/// Names of discovered mechanisms in answers, the clearest first.
pub const IDS: [EffectId; 2] = [EffectId("discovered"), EffectId("discovered_second")];

/// Sentences that are fitted after a screen.
const FITTED: usize = 6;
/// Log weight by which a sentence that acts at once may be less likely than one that is hardly late, and still say the same.
const CLOSE: f64 = 3.0;
/// Share of turned histories that may do as well, at most.
const BY_CHANCE: f64 = 0.05;
/// Relative error that a composed law has beside the physics it stands for, and the number of shapes over which it spreads: as for equations of the library.
const FORM_ERROR: f64 = 0.2;
const FORM_SHAPES: f64 = 10.0;

/// A mechanism found.
pub struct Discovery {
    /// as an effect
    pub effect: Composed,
    /// the model that it stands beside, with it: its index follows those of the library
    pub tried: Tried,
    /// how sure its words are
    pub words: WordProbabilities,
    /// log evidence that some sentence adds to the model it stands beside, its prior counted, on the scale of a selection's weights
    pub gain: f64,
    /// share of turned histories in which freedom alone does as well
    pub control_p_value: f64,
    /// columns that were weighed
    pub weighed: usize,
    /// the nearest mechanism that has another value of the least sure word
    pub rival: Option<Rival>,
}

/// A mechanism that the recording does not tell from the one found.
pub struct Rival {
    /// the word
    pub word: &'static str,
    /// its values, of what was found and of the rival, for a reader
    pub values: [String; 2],
    /// as an effect
    pub effect: Composed,
    /// fitted in the place of the one found
    pub tried: Tried,
}

/// The mechanism beside `from` that explains most; `None` where none stands above the control. `scale` divides log evidence as in the selection.
pub fn discover(search: &Search<'_>, from: &Tried, scale: f64, id: EffectId) -> Option<Discovery> {
    if search.stop.load(Ordering::Relaxed) {
        return None;
    }
    let model = search.model(&from.effects);
    let knows_lag = search.library.iter().any(|effect| effect.stage() == StageName::ThermalPath);
    let mut found = screen(&model, &from.fit.z, &from.fit.linearised(), search.whitener, knows_lag)?;
    let first = found.sentences.iter().max_by(|a, b| a.deviance.total_cmp(&b.deviance))?;
    let (clearest, control_p_value) = (first.deviance, found.control_p_value(&first.sentence, first.deviance));
    if control_p_value > BY_CHANCE {
        return None;
    }
    let temper = temper(clearest);
    let (best, others) = best_fit(search, from, &mut found, temper, id)?;
    let gain = log_sum_exp(&found.sentences.iter().map(|s| s.weight(scale)).collect::<Vec<_>>());
    let words = marginals(&found.sentences, temper);
    let rival = rival(search, from, &found, &best.effect, &words, others, temper);
    Some(Discovery { effect: best.effect, tried: best.tried, words, gain, control_p_value, weighed: found.columns, rival })
}

/// Divisor of log evidence: words are told apart by no less than the error of their laws.
fn temper(deviance: f64) -> f64 {
    1.0 + FORM_ERROR * FORM_ERROR * deviance / FORM_SHAPES
}

/// Indices of the sentences that are fitted: those with most weight, one of each quantity, driver and kinetics.
fn promising(found: &Screen, temper: f64) -> Vec<usize> {
    let mut order: Vec<(usize, f64)> = found.sentences.iter().map(|s| s.weight(temper)).enumerate().collect();
    order.sort_by(|a, b| b.1.total_cmp(&a.1));
    let kind = |s: &Screened| (s.sentence.quantity, s.sentence.driver.clone(), s.sentence.kinetics);
    let mut kinds = Vec::new();
    let mut chosen = Vec::new();
    for (index, _) in order {
        let own = kind(&found.sentences[index]);
        if !kinds.contains(&own) {
            kinds.push(own);
            chosen.push(index);
        }
        if chosen.len() == FITTED {
            break;
        }
    }
    chosen
}

/// A sentence that was fitted: its place among those screened, its weight, the effect and the model with it.
struct Fitted {
    index: usize,
    weight: f64,
    effect: Composed,
    tried: Tried,
}

/// Fits the most promising sentences beside `from`, corrects what the screen promised of them, and gives the one with the most weight, and the others.
fn best_fit(search: &Search<'_>, from: &Tried, found: &mut Screen, temper: f64, id: EffectId) -> Option<(Fitted, Vec<Fitted>)> {
    let mut all: Vec<Fitted> = Vec::new();
    let fits: Vec<(usize, Option<(Composed, Tried)>)> = promising(found, temper)
        .into_par_iter()
        .map(|index| (index, fit_of(search, from, &found.sentences[index], id)))
        .collect();
    for (index, fit) in fits {
        all.extend(fit.map(|fit| corrected(from, found, (index, temper), fit)));
    }
    // late by less than two rows: that is at once, and another sentence says so
    for late in all.iter().filter(|f| is_at_once(search, f)).map(|f| f.index).collect::<Vec<_>>() {
        let Some(twin) = found.at_once(late, temper) else { continue };
        if !all.iter().any(|f| f.index == twin) {
            let fit = fit_of(search, from, &found.sentences[twin], id);
            all.extend(fit.map(|fit| corrected(from, found, (twin, temper), fit)));
        }
        if found.sentences[twin].weight(temper) > found.sentences[late].weight(temper) - CLOSE {
            found.sentences[late].beyond = f64::NEG_INFINITY;
            all.retain(|f| f.index != late);
        }
    }
    let kept: Vec<usize> = all.iter().map(|f| f.index).collect();
    found.promise_no_more_than(&kept);
    let best = all.iter().enumerate().max_by(|a, b| a.1.weight.total_cmp(&b.1.weight))?.0;
    let best = all.swap_remove(best);
    Some((best, all))
}

/// A sentence that was fitted beside `from`, and what the screen promised of it corrected.
fn corrected(from: &Tried, found: &mut Screen, (index, temper): (usize, f64), (effect, tried): (Composed, Tried)) -> Fitted {
    let s = &mut found.sentences[index];
    s.beyond = 2.0 * (from.fit.objective() - tried.fit.objective()) - s.deviance;
    Fitted { index, weight: s.weight(temper), effect, tried }
}

/// The likeliest mechanism with another value of the least sure word; one that was not fitted yet is.
fn rival(
    search: &Search<'_>,
    from: &Tried,
    found: &Screen,
    effect: &Composed,
    words: &WordProbabilities,
    fitted: Vec<Fitted>,
    temper: f64,
) -> Option<Rival> {
    let word = words.least_sure(SURE)?;
    let own = word.of(&effect.sentence.in_words());
    let differs = |sentence: &Sentence| word.of(&sentence.in_words()) != own;
    let open = found.sentences.iter().enumerate().filter(|(_, s)| differs(&s.sentence) && s.beyond.is_finite());
    let (index, next) = open.max_by(|a, b| a.1.weight(temper).total_cmp(&b.1.weight(temper)))?;
    let values = [own.clone(), word.of(&next.sentence.in_words())];
    let known = fitted.into_iter().find(|f| f.index == index).map(|f| (f.effect, f.tried));
    let (effect, tried) = known.or_else(|| fit_of(search, from, next, effect.id))?;
    Some(Rival { word: word.name(), values, effect, tried })
}

/// A sentence as an effect and as fitted beside `from`.
fn fit_of(search: &Search<'_>, from: &Tried, s: &Screened, id: EffectId) -> Option<(Composed, Tried)> {
    let effect = Composed::found(id, s.sentence.clone(), s.numbers, s.swing, search.context);
    effect.testable(search.context).ok()?;
    let tried = fitted(search, from, &effect)?;
    Some((effect, tried))
}

/// Whether it is late by less than two rows. What is late in the place of what is at once is a rate where it is that quick, and says so itself.
fn is_at_once(search: &Search<'_>, Fitted { effect, tried, .. }: &Fitted) -> bool {
    let tau_s = time_constant(&values(search, tried, effect), effect);
    let late = effect.sentence.kinetics == Kinetics::FirstOrder && !effect.sentence.passing;
    late && tau_s < 2.0 * search.context.shortest_step_s.unwrap_or(0.0)
}

/// Values of the parameters of `effect`, the last of the model.
fn values(search: &Search<'_>, tried: &Tried, effect: &Composed) -> Vec<f64> {
    let model = widened(search, effect).model(&tried.effects);
    let values = model.values(&tried.fit.z);
    values[model.range_of(tried.effects.len() - 1)].to_vec()
}

/// Its time constant, s.
fn time_constant(values: &[f64], effect: &Composed) -> f64 {
    let names = effect.parameters.iter().map(|p| p.name.as_str());
    effect.start.with(names.zip(values.iter().copied())).0.tau_s
}

/// `from` with one more effect from outside the library, which gets the index behind those of the library.
pub fn fitted(search: &Search<'_>, from: &Tried, effect: &dyn Effect) -> Option<Tried> {
    let wider = widened(search, effect);
    let index = search.library.len();
    let tried = wider.add_each(from, &[index], 1, "composing").into_iter().next()?;
    wider.polished(&tried).or(Some(tried))
}

/// The same search with one more effect behind the library.
pub fn widened<'s>(search: &Search<'s>, effect: &'s dyn Effect) -> Search<'s> {
    let mut library = search.library.clone();
    library.push(effect);
    Search { library, ..*search }
}

/// The same search with these mechanisms behind the library.
pub fn with_mechanisms<'s>(search: &Search<'s>, mechanisms: &'s [Discovery]) -> Search<'s> {
    let mut library = search.library.clone();
    library.extend(mechanisms.iter().map(|m| &m.effect as &dyn Effect));
    Search { library, ..*search }
}
