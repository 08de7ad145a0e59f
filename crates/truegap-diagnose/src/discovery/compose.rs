//! When mechanisms are composed, beside which model, and whether one takes the place of what the library says.
//!
//! A mechanism has to be likelier than all of the library and than every unmodelled course together. An equation of the library whose shape has run to the limit of
//! what it means is no rival: the fit says that its law does not hold.
//!
//! Limits: one recording; two mechanisms at most.

use crate::{
    adequacy::lack_of_fit::{Adequacy, LackOfFitTests},
    discovery::{
        discover::{Discovery, IDS, discover, fitted, widened},
        marginals::SURE,
        same_words::says_all_of,
    },
    effects::composed::{
        effect::Composed,
        words::{Driver, Kinetics},
    },
    selection::{
        candidates::{Search, Tried},
        detectability::detectability,
        posterior::Selection,
        tuning::RIGHT_FAMILY,
        verdict::{Decision, Verdict, removed_by},
    },
};

/// Share of the misfit that a named effect has to remove to be all; the same share of what other words for it remove makes those a matter of form.
const A_TENTH: f64 = 0.9;
/// Standard deviations by which the recording wants a shape beyond its limit, one-sided 95 %: a shape that is hardly known lies on a limit by chance.
const CLEARLY_BEYOND: f64 = 1.645;
/// Gain in log evidence, divided as the selection's, that a second mechanism must bring.
const CLEAR: f64 = 3.0;

/// Mechanisms beside a model.
pub struct Composition {
    /// the mechanisms; their indices follow those of the library
    pub mechanisms: Vec<Discovery>,
    /// the model with them
    pub tried: Tried,
    /// log odds against the library and all unmodelled causes together
    pub log_odds: f64,
    /// whether the library's own answer has run to the limits of its equations
    pub library_strained: bool,
    /// whether they only put into words what the library has explained
    pub in_other_words: bool,
    /// whether they stand by their odds; else by what they foretell beside names of the library
    pub by_odds: bool,
}

/// Mechanisms where the library leaves something; `None` where it does not, or where freedom alone does as well. A library that rows left out have `refuted` is no rival.
pub fn compose(
    search: &Search<'_>,
    selection: &Selection,
    decision: &Decision,
    after: &Adequacy,
    lack_of_fit: &LackOfFitTests,
    refuted: bool,
) -> Option<Composition> {
    let chosen = &selection.models[decision.model];
    let strained = refuted || is_strained(search, lack_of_fit, selection.base(), chosen);
    if search.problem.simulator.joined().is_some() || !leaves_something(decision, after, strained) {
        return None;
    }
    let mut launches = vec![selection.base()];
    launches.extend(
        selection
            .likeliest_named()
            .map(|index| &selection.models[index])
            .filter(|m| !refuted && !is_strained(search, lack_of_fit, selection.base(), m)),
    );
    let mut best: Option<Composition> = None;
    for from in launches {
        let found = beside(search, selection, from, lack_of_fit, strained);
        let better = |f: &Composition| best.as_ref().is_none_or(|b| f.log_odds > b.log_odds);
        best = found.filter(better).or(best);
        if best.as_ref().is_some_and(|b| !lack_of_fit.adequacy(&b.tried.fit).fires()) {
            break;
        }
    }
    let explained = |tried: &Tried| tried.fit.explains_beyond(&selection.base().fit);
    let matter_of_form = |found: &Composition| {
        explained(chosen) >= A_TENTH * explained(&found.tried) && says_all_of(search, chosen, &found.tried, &found.mechanisms)
    };
    best.filter(|found| strained || !matter_of_form(found))
}

/// Mechanisms beside the base model, whatever the library says; `None` where freedom alone does as well. A library whose laws are `strained` is no rival.
pub fn describe(search: &Search<'_>, selection: &Selection, lack_of_fit: &LackOfFitTests, strained: bool) -> Option<Composition> {
    if search.problem.simulator.joined().is_some() {
        return None;
    }
    let found = beside(search, selection, selection.base(), lack_of_fit, strained)?;
    Some(Composition { in_other_words: true, ..found })
}

/// Mechanisms beside `from`, a model of the library, whatever their odds.
pub fn compose_beside(
    search: &Search<'_>,
    selection: &Selection,
    from: &Tried,
    lack_of_fit: &LackOfFitTests,
) -> Option<Composition> {
    let found = beside(search, selection, from, lack_of_fit, false)?;
    Some(Composition { by_odds: false, ..found })
}

/// Whether there is anything to compose for.
fn leaves_something(decision: &Decision, after: &Adequacy, strained: bool) -> bool {
    match decision.verdict {
        Verdict::Unexplained | Verdict::WrongForm => true,
        Verdict::Explained | Verdict::Ambiguous => strained || (after.fires() && decision.removed < A_TENTH),
        Verdict::Agrees | Verdict::Undecided => false,
    }
}

/// One mechanism beside `from`, and a second one where the first leaves something.
fn beside(
    search: &Search<'_>,
    selection: &Selection,
    from: &Tried,
    lack_of_fit: &LackOfFitTests,
    strained: bool,
) -> Option<Composition> {
    let scale = selection.temper * lack_of_fit.slack();
    let first = discover(search, from, scale, IDS[0])?;
    let tried = first.tried.clone();
    let rival = |m: &Tried| !strained || m.effects.is_empty();
    let log_odds = selection.log_odds_beside(from, first.gain, lack_of_fit.slack(), rival);
    let second = if lack_of_fit.adequacy(&tried.fit).fires() { second(search, &first, scale) } else { None };
    let Some(second) = second else {
        return Some(Composition {
            mechanisms: vec![first],
            tried,
            log_odds,
            library_strained: strained,
            in_other_words: false,
            by_odds: true,
        });
    };
    // what two gain together is known in the order in which they were found
    let beside_the_first = second.gain;
    let mechanisms = match the_other_first(search, from, &second, scale) {
        Some(others) if surer(&others, (&first, &second)) => others,
        _ => [first, second],
    };
    let (tried, log_odds) = (mechanisms[1].tried.clone(), log_odds + beside_the_first);
    Some(Composition {
        mechanisms: mechanisms.into(),
        tried,
        log_odds,
        library_strained: strained,
        in_other_words: false,
        by_odds: true,
    })
}

/// The mechanism beside `first` that explains most of what that leaves.
fn second(search: &Search<'_>, first: &Discovery, scale: f64) -> Option<Discovery> {
    discover(&widened(search, &first.effect), &first.tried, scale, IDS[1]).filter(|more| more.gain > CLEAR)
}

/// The second mechanism told first, and what explains most beside it: what stood for both of two at first is looked for anew.
fn the_other_first(search: &Search<'_>, from: &Tried, second: &Discovery, scale: f64) -> Option<[Discovery; 2]> {
    let effect = Composed { id: IDS[0], ..second.effect.clone() };
    let tried = fitted(search, from, &effect)?;
    let alone = Discovery { effect, tried, words: second.words.clone(), rival: None, ..*second };
    let more = self::second(search, &alone, scale)?;
    Some([alone, more])
}

/// Whether two mechanisms, the one with the surer words first, fit no worse than those found one after another.
fn surer(others: &[Discovery; 2], (first, second): (&Discovery, &Discovery)) -> bool {
    let fits = others[1].tried.fit.objective() < second.tried.fit.objective() + CLEAR;
    fits && others[0].words.sureness() > f64::max(first.words.sureness(), others[1].words.sureness())
}

/// Whether it says no more than that something happened once: that is a place in the recording and no physics that another recording could confirm.
fn is_a_moment(effect: &Composed) -> bool {
    effect.sentence.driver == Driver::Time && effect.sentence.kinetics == Kinetics::Event
}

/// Whether the effects whose shape lies on a limit that is not a plain special case (nothing or all of a part) carry the explanation, and the recording wants the shape
/// beyond it or misfit is left: the fit says that the law does not hold. A law that explains a small part beside others that hold says nothing against those.
pub fn is_strained(search: &Search<'_>, lack_of_fit: &LackOfFitTests, base: &Tried, tried: &Tried) -> bool {
    let leaves_misfit = lack_of_fit.adequacy(&tried.fit).fires();
    let at_limit = |index: &usize| {
        let beyond = |i: usize| leaves_misfit || tried.fit.pull(i) > CLEARLY_BEYOND;
        search.on_limits(tried, *index).into_iter().any(beyond)
    };
    let law = |index: &usize| !search.library[tried.effects[*index]].describes();
    let strained = (0..tried.effects.len()).filter(law).filter(at_limit);
    // nothing is said of a law without which the model has no answer
    let carried: Option<f64> = strained.map(|index| detectability(search, tried, index).map(|d| d.powi(2))).sum();
    let explained = tried.fit.explains_beyond(&base.fit);
    carried.is_some_and(|carried| carried > 0.0 && carried > (1.0 - RIGHT_FAMILY) * explained)
}

impl Composition {
    /// The selection with the mechanisms' model in it. A library whose best equation has run to its limits, and what mimics that, is set aside.
    pub fn counted_in(&self, selection: Selection) -> Selection {
        self.with(selection, self.log_odds)
    }

    /// The same with no probability for it: other words for what is explained, or what leaves too much to be an answer, take nothing from the others.
    pub fn listed_in(&self, selection: Selection) -> Selection {
        self.with(selection, f64::NEG_INFINITY)
    }

    fn with(&self, selection: Selection, log_odds: f64) -> Selection {
        let selection = if self.library_strained { selection.base_alone() } else { selection };
        selection.with_model(self.tried.clone(), log_odds, self.mechanisms.len())
    }

    /// Whether place, driver and kinetics of each are sure.
    pub fn sure(&self) -> bool {
        self.mechanisms.iter().all(|m| m.words.sure(SURE))
    }

    /// Whether they leave too much to be an answer.
    pub fn leave_too_much(&self, selection: &Selection, lack_of_fit: &LackOfFitTests) -> bool {
        self.stands(selection, &lack_of_fit.adequacy(&self.tried.fit)).is_none()
    }

    /// The decision with the mechanisms counted; `selection` holds their model already.
    pub fn decide(
        &self,
        selection: &Selection,
        decision: Decision,
        lack_of_fit: &LackOfFitTests,
    ) -> (Decision, Option<Adequacy>) {
        let Some(model) = selection.models.iter().position(|m| m.key() == self.tried.key()) else { return (decision, None) };
        let after = lack_of_fit.adequacy(&self.tried.fit);
        let says_something = self.mechanisms.iter().all(|m| !is_a_moment(&m.effect));
        let likelier = self.log_odds > 0.0 && says_something;
        let Some((removed, verdict)) = self.stands(selection, &after).filter(|_| likelier) else {
            // what is less likely than a mechanism that is no answer is none either
            let named = decision.model != selection.base;
            return (if likelier && named { Decision::nothing(Verdict::Unexplained, selection.base) } else { decision }, None);
        };
        let sets = self.tried.effects.iter().map(|e| vec![*e]).collect();
        (Decision { model, sets, removed, ..Decision::nothing(verdict, selection.base) }, Some(after))
    }

    /// The share that the mechanisms remove and their verdict where they stand; `None` where they leave too much.
    fn stands(&self, selection: &Selection, after: &Adequacy) -> Option<(f64, Verdict)> {
        let explained = self.tried.fit.explains_beyond(&selection.base().fit);
        let removed = removed_by(explained, after);
        let verdict = match Decision::adequate(removed, after) {
            true if self.sure() => Some(Verdict::Explained),
            true => Some(Verdict::Ambiguous),
            false if removed >= A_TENTH => Some(Verdict::WrongForm),
            false => None,
        };
        verdict.map(|verdict| (removed, verdict))
    }
}
