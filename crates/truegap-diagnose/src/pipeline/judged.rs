//! From what was examined to what is stood behind: hidden column, interference, rows left out, and what takes the verdict back.
//!
//! Where rows left out contradict all of the library's answer, a mechanism from outside it is looked for beside the base model, as if the library had had none. It has to stand the same tests.
//!
//! Where the noise was not measured, mechanisms have to foretell rows left out clearly better than the library's own answer: else that is told.
//!
//! Limits: nothing is put into words here.

use crate::{
    adequacy::{
        interference::every_row::Interference,
        lack_of_fit::{Adequacy, LackOfFitTests},
    },
    answer::Reserved,
    data::{context::Number, error::DiagnoseError},
    discovery::{
        compose::{Composition, compose},
        discover::with_mechanisms,
    },
    explain::hidden_input::slow_input::SlowInput,
    pipeline::{
        calibrated::{ByBase, by_base},
        interference::{beside_a_tone, with_interference},
        options::Options,
        predicted::{Predicted, predicted},
        prepare::Prepared,
    },
    selection::{
        candidates::{Progress, Search, Tried},
        examine::{Examined, examine, judge},
        posterior::Selection,
        verdict::{Decision, Verdict, interrupted, removed_by},
    },
    stats::share_removed,
    validation::{
        cross_validation::{HeldOutFit, compared},
        veto::Unseen,
    },
};
use std::sync::atomic::AtomicBool;

/// What the caller tells a diagnosis, and is told by it.
pub(crate) struct Told<'a> {
    /// what the caller chose
    pub options: &'a Options,
    /// told what is tried
    pub progress: &'a (dyn Fn(Progress) + Sync),
    /// set by the caller to end early
    pub asked: &'a AtomicBool,
    /// the same for the search, which is not begun where nothing may be named
    pub stop: &'a AtomicBool,
}

/// An answer before it is put into words.
pub(crate) struct Judged {
    /// models and probabilities, mechanisms counted; its decision is that before rows left out were asked
    pub examined: Examined,
    /// mechanisms from outside the library
    pub composition: Option<Composition>,
    /// the slow course in place of a column that was hidden on purpose
    pub slow: Option<SlowInput>,
    /// bursts and a tone in what the model stood behind leaves
    pub interference: Interference,
    /// why nothing is named whatever the models say
    pub kept_back: Option<Reserved>,
    /// the base model by itself
    pub by_base: ByBase,
    /// the decision, with predictions of rows left out counted
    pub predicted: Predicted,
    /// numbers of effects that are held at nothing
    pub held: Vec<Number>,
    /// the column whose quick motion the reading does not show, where a mean to both sides foretells as well as what was named
    pub smoothed: Option<String>,
}

/// Fits, weighs and decides, on the rows that are searched as they are.
///
/// # Errors
/// Those of the simulator.
pub(crate) fn examined_on_means(prepared: &Prepared<'_>, told: &Told<'_>) -> Result<Examined, DiagnoseError> {
    let searched = prepared.searched();
    let search = &prepared.search(&searched, told.progress, told.stop);
    beside_a_tone(prepared, search, examine(search, &prepared.lack_of_fit)?)
}

/// Decides once more, where probabilities or fits of the models have changed.
///
/// # Errors
/// Those of the simulator.
pub(crate) fn judged_again(
    prepared: &Prepared<'_>,
    search: &Search<'_>,
    selection: Selection,
) -> Result<Examined, DiagnoseError> {
    beside_a_tone(prepared, search, judge(search, &prepared.lack_of_fit, selection))
}

/// What is stood behind after rows left out were asked.
///
/// # Errors
/// Those of the simulator.
pub(crate) fn judged(
    prepared: &Prepared<'_>,
    told: &Told<'_>,
    examined: Examined,
    composition: Option<Composition>,
) -> Result<Judged, DiagnoseError> {
    let strained = composition.as_ref().is_some_and(|composition| composition.library_strained);
    // the odds of mechanisms are what the noise was taken for; and laws that have run to their limits, which the odds leave out, may still foretell rows left out better where equations only describe
    let doubtful = !prepared.noise_is_known() || (strained && !prepared.context.has_plates());
    let by_library = (composition.is_some() && doubtful).then(|| examined.clone());
    let first = judged_once(prepared, told, examined, composition, None)?;
    if let Some(examined) = by_library {
        let library = judged_once(prepared, told, examined, None, Some(first.by_base.clone()))?;
        if library.stands_before(&first, strained) {
            return Ok(library);
        }
    }
    if !first.took_all_back(prepared.testable.len()) || !may_compose(told.options) {
        return Ok(first);
    }
    if let Some(examined) = first.without_what_was_refuted(prepared, told)? {
        let second = judged_once(prepared, told, examined, None, Some(first.by_base.clone()))?;
        if second.names_something() {
            return Ok(second.after(first));
        }
    }
    let Some((examined, composition)) = first.refuted(prepared, told) else { return Ok(first) };
    let second = judged_once(prepared, told, examined, Some(composition), Some(first.by_base.clone()))?;
    Ok(if second.names_something() { second.after(first) } else { first })
}

/// One round of it, with these mechanisms among the models; the base model by itself where it is `known`.
///
/// # Errors
/// Those of the simulator.
pub(crate) fn judged_once(
    prepared: &Prepared<'_>,
    told: &Told<'_>,
    examined: Examined,
    composition: Option<Composition>,
    known: Option<ByBase>,
) -> Result<Judged, DiagnoseError> {
    let searched = prepared.searched();
    let mechanisms = composition.as_ref().map_or(&[][..], |c| c.mechanisms.as_slice());
    let search = &with_mechanisms(&prepared.search(&searched, told.progress, told.stop), mechanisms);
    let too_much = |found: &&Composition| found.leave_too_much(&examined.selection, &prepared.lack_of_fit);
    let uncounted = composition.as_ref().filter(too_much).map(|found| (found, examined.selection.clone()));
    let mut examined = match &composition {
        Some(composition) => counted(composition, examined, &prepared.lack_of_fit),
        None => examined,
    };
    let selection = &examined.selection;
    let hidden = told.options.hidden.first();
    let slow = hidden.and_then(|_| SlowInput::of(search, selection));
    let (interference, decision) = with_interference(prepared, search, &examined)?;
    let (decision, kept_back) = reserved(decision, selection, slow.as_ref(), told.options);
    let missing = decision.verdict != Verdict::Agrees;
    let by_base = known.unwrap_or_else(|| by_base(prepared, search, selection.base(), missing));
    let mut predicted = predicted(prepared, search, selection, decision, &by_base, kept_back.is_none());
    let key = selection.models[predicted.decision.model].key();
    if let Some((found, uncounted)) = uncounted.filter(|(found, _)| found.tried.key() != key) {
        examined = examined.with(|_| found.listed_in(uncounted));
        predicted.decision.model = examined.selection.place_of(key);
    }
    let held = prepared.context.held.clone();
    Ok(Judged { examined, composition, slow, interference, kept_back, by_base, predicted, held, smoothed: None })
}

impl Judged {
    pub(crate) fn names_something(&self) -> bool {
        self.predicted.decision.model != self.examined.selection.base
    }

    /// Whether it names something that foretells rows left out as well as what `other` names; clearly better where its laws are `strained`, that is have run to their limits.
    pub(crate) fn stands_before(&self, other: &Self, strained: bool) -> bool {
        let borne_out = |judged: &Self, beside: &Self| judged.beside(beside).against(false, || false).is_none();
        let better = || if strained { borne_out(self, other) } else { !other.names_something() || !borne_out(other, self) };
        self.names_something() && better()
    }

    /// Whether rows left out are predicted no worse than by what `other` stands behind.
    pub(crate) fn foretells_as_well_as(&self, other: &Self) -> bool {
        self.beside(other).worse(true).is_none()
    }

    /// What it foretells of rows left out, beside what `other` does.
    fn beside(&self, other: &Self) -> Unseen {
        let told = |judged: &Self| judged.predicted.unseen.stood_behind().clone();
        Unseen::of((told(other), &other.stood_behind().fit), (told(self), &self.stood_behind().fit))
    }

    pub(crate) fn stood_behind(&self) -> &Tried {
        &self.examined.selection.models[self.predicted.decision.model]
    }

    /// Share of the misfit that a model removes: under the noise or on rows left out, whichever is more.
    pub(crate) fn share_removed_by(&self, prepared: &Prepared<'_>, tried: &Tried, unseen: &HeldOutFit, after: &Adequacy) -> f64 {
        let base = self.examined.selection.base();
        let under_noise = removed_by(tried.fit.explains_beyond(&base.fit), after);
        let [before, left] = compared(&self.by_base.unseen, unseen).map_or([1.0, 1.0], |both| both.rmse);
        under_noise.max(share_removed(before, left, prepared.noise.floor().min(left)))
    }

    /// Whether rows left out took back all that was named, and all of it was of the `library` effects.
    fn took_all_back(&self, library: usize) -> bool {
        let (selection, named) = (&self.examined.selection, self.examined.decision.model);
        let named_something = named != selection.base && self.kept_back.is_none();
        let of_the_library = selection.models[named].effects.iter().all(|e| *e < library);
        named_something && of_the_library && self.predicted.decision.model == selection.base
    }

    /// What was examined without models that hold what rows left out contradict, where others are likely enough to be rivals.
    fn without_what_was_refuted(&self, prepared: &Prepared<'_>, told: &Told<'_>) -> Result<Option<Examined>, DiagnoseError> {
        let searched = prepared.searched();
        let search = &prepared.search(&searched, told.progress, told.stop);
        let refuted = &self.predicted.refuted;
        if refuted.is_empty() {
            return Ok(None);
        }
        let Some(selection) = self.examined.selection.clone().without_holders_of(refuted, search.library.len()) else {
            return Ok(None);
        };
        let examined = judged_again(prepared, search, selection)?;
        Ok((examined.decision.model != examined.selection.base).then_some(examined))
    }

    /// What was examined as if the library had no answer, and the mechanism beside the base model.
    fn refuted(&self, prepared: &Prepared<'_>, told: &Told<'_>) -> Option<(Examined, Composition)> {
        let searched = prepared.searched();
        let search = &prepared.search(&searched, told.progress, told.stop);
        let selection = self.examined.selection.clone().refuted(search.library.len());
        let decision = Decision::nothing(Verdict::Unexplained, selection.base);
        let before = self.examined.before;
        let composition = compose(search, &selection, &decision, &before, &prepared.lack_of_fit, true)?;
        Some((Examined { selection, before, after: before, decision }, composition))
    }

    /// The same with `tried` stood behind in the place of the model that was: what it `holds` at nothing, what it foretells, what it leaves, and the decision for its place and that of the base
    /// model.
    pub(crate) fn stands_behind(
        mut self,
        tried: Tried,
        held: Vec<Number>,
        unseen: HeldOutFit,
        after: Adequacy,
        decide: impl FnOnce(usize, usize) -> Decision,
    ) -> Self {
        let (place, key) = (self.predicted.decision.model, tried.key());
        let base = &self.examined.selection.base().fit;
        let unseen = Unseen::of((self.by_base.unseen.clone(), base), (unseen, &tried.fit));
        self.examined = self.examined.with(|selection| selection.told_as(place, tried));
        let selection = &self.examined.selection;
        let decision = decide(selection.place_of(key), selection.base);
        self.predicted = self.predicted.with(unseen, decision, after);
        self.held = held;
        self
    }

    /// The same for a model that removes this share of the misfit, decided by what may stand in the place of each of its effects.
    pub(crate) fn told_by_sets(
        self,
        tried: Tried,
        held: Vec<Number>,
        unseen: HeldOutFit,
        after: Adequacy,
        (sets, removed): (Vec<Vec<usize>>, f64),
    ) -> Self {
        let verdict = Decision::of_sets(sets.iter(), removed, &after);
        self.stands_behind(tried, held, unseen, after, |model, base| Decision {
            model,
            sets,
            removed,
            ..Decision::nothing(verdict, base)
        })
    }

    /// The same with mechanisms beside what is stood behind: they are among the models, and the decision is not asked again.
    pub(crate) fn described_by(mut self, composition: Composition) -> Self {
        let key = self.stood_behind().key();
        self.examined = self.examined.with(|selection| composition.listed_in(selection));
        // the order of the models has changed
        self.predicted.decision.model = self.examined.selection.place_of(key);
        Self { composition: Some(composition), ..self }
    }

    /// The same with what was left out on the way.
    fn after(mut self, first: Self) -> Self {
        self.predicted.left_out.splice(0..0, first.predicted.left_out);
        self
    }
}

/// Mechanisms from outside the library, where anything may be named at all.
pub(crate) fn composed(prepared: &Prepared<'_>, examined: &Examined, told: &Told<'_>) -> Option<Composition> {
    let Told { options, progress, stop, .. } = told;
    let searched = prepared.searched();
    let search = &prepared.search(&searched, progress, stop);
    let Examined { selection, decision, after, .. } = examined;
    may_compose(options).then(|| compose(search, selection, decision, after, &prepared.lack_of_fit, false)).flatten()
}

/// Whether anything from outside the library may be named.
pub(crate) fn may_compose(options: &Options) -> bool {
    options.compose && options.withheld.is_none() && options.restricted.is_none()
}

/// What was examined, with the mechanisms among its models and in its decision.
fn counted(composition: &Composition, examined: Examined, lack_of_fit: &LackOfFitTests) -> Examined {
    let examined = examined.with(|selection| composition.counted_in(selection));
    let (decision, after) = composition.decide(&examined.selection, examined.decision, lack_of_fit);
    Examined { decision, after: after.unwrap_or(examined.after), ..examined }
}

/// The decision, taken back where the recording may not be trusted or an input is missing that was hidden on purpose; with the reason.
fn reserved(
    decision: Decision,
    selection: &Selection,
    slow: Option<&SlowInput>,
    options: &Options,
) -> (Decision, Option<Reserved>) {
    let missing = slow.filter(|slow| slow.is_missing());
    let reserved = |says: String| Reserved { says, withheld: options.withheld.is_some(), input_missing: missing.is_some() };
    if let Some(why) = &options.withheld {
        return (interrupted(selection), Some(reserved(why.clone())));
    }
    match missing {
        Some(slow) => (Decision { verdict: Verdict::Unexplained, ..interrupted(selection) }, Some(reserved(slow.says()))),
        None => (decision, None),
    }
}
