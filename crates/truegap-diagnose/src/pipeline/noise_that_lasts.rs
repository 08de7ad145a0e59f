//! What is left where nothing foretells it is noise, if nobody measured the noise.
//!
//! A noise that was not measured is taken from short stretches, since slow misfit may be physics. So slow noise counts as misfit at first. Once no effect, no mechanism, no mean and no smooth curve
//! through the inputs or along the rows predicts rows left out clearly better than the base model, nothing says that the rest is more than noise that lasts: the model agrees with the recording as far as that
//! can tell, and a recording at rest would tell more.
//!
//! **Source:** Stone, Cross-validatory choice and assessment of statistical predictions, J. R. Stat. Soc. B 36 (1974) 111, for what foretells.
//!
//! Limits: not for a base model with plates; a tone that is felt beside the noise, and what is louder than slow noise makes it, are more than noise.

use crate::{
    adequacy::interference::{every_row::Interference, tone::Tone},
    discovery::discover::with_mechanisms,
    noise::response::groups_alike,
    pipeline::{
        calibrated::predictions,
        interference::interference_beside,
        judged::{Judged, Told},
        prepare::Prepared,
    },
    selection::{
        candidates::{Search, Tried},
        unmodelled::{Cause, Unmodelled},
        verdict::{Decision, Verdict, stated},
    },
    validation::{
        cross_validation::{PartError, compared, parts_of},
        reference::{references, with_trend},
        tuning::{CLEARLY_WORSE, FELT, NO_LOUDER},
    },
};

/// What stands out beside the base model where all that `judged` finds and does not explain is noise, and no effect of the library and no mean foretells rows left out clearly better: at most a faint tone. `None` where it is more
/// than noise.
pub(crate) fn noise_alone(prepared: &Prepared<'_>, told: &Told<'_>, judged: &Judged) -> Option<Interference> {
    let decision = &judged.predicted.decision;
    let wanders = |unmodelled: &Unmodelled| unmodelled.cause == Cause::WanderingZero;
    let open =
        matches!(decision.verdict, Verdict::Unexplained | Verdict::Undecided) && decision.unmodelled.as_ref().is_none_or(wanders);
    let loud = judged.examined.before.left_over_noise > NO_LOUDER;
    // rows at neighbouring inputs that follow one another in a file say no more of a noise that lasts than short stretches of a clock do: a second bottle that was closed at the same depth
    let apart = || prepared.noise.measured && groups_alike(prepared.problem, &prepared.noise).is_empty();
    if !open || loud || judged.kept_back.is_some() || apart() {
        return None;
    }
    let searched = prepared.searched();
    let search = &prepared.search(&searched, told.progress, told.stop);
    let interference = interference_beside(prepared, search, judged.examined.selection.base()).ok()?;
    (is_noise(prepared, judged, &interference) && !is_fitted(prepared, search, judged)).then_some(interference)
}

/// Whether neither a tone that is felt is beside the base model nor any curve or line predicts rows left out clearly better.
pub(crate) fn is_noise(prepared: &Prepared<'_>, judged: &Judged, interference: &Interference) -> bool {
    is_faint(&interference.tone) && !is_a_curve(prepared, judged)
}

/// Whether a tone is none, or so faint that it would not be felt on rows left out. Bursts are asked of a noise that was measured alone.
fn is_faint(tone: &Tone) -> bool {
    !tone.is_significant() || 1.0 + 0.5 * tone.amplitude.powi(2) < FELT.powi(2)
}

/// Whether a straight line or a smooth curve through the inputs, or a line that drifts along the rows beside them, predicts rows left out clearly better than the base model.
fn is_a_curve(prepared: &Prepared<'_>, judged: &Judged) -> bool {
    let (problem, base) = (prepared.problem, &judged.by_base.unseen);
    let Some(error) = PartError::rmse_over(&base.parts) else { return true };
    let (_, parts) = parts_of(problem);
    let curves = references(problem, &parts, [base, base]).into_iter().filter_map(|reference| reference.held_out);
    curves.chain(with_trend(problem, &parts, [base, base])).any(|curve| CLEARLY_WORSE * curve < error)
}

/// Whether the likeliest model, or mechanisms composed of words, predict rows left out clearly better than the base model.
fn is_fitted(prepared: &Prepared<'_>, search: &Search<'_>, judged: &Judged) -> bool {
    let mechanisms = judged.composition.as_ref().map_or(&[][..], |composition| composition.mechanisms.as_slice());
    let search = &with_mechanisms(search, mechanisms);
    let selection = &judged.examined.selection;
    let likeliest = stated(selection).map(|model| &selection.models[model]);
    let composed = judged.composition.as_ref().map(|composition| &composition.tried);
    let better = |tried: &Tried| {
        let unseen = predictions(prepared, search, &judged.by_base, tried);
        // in however few parts
        compared(&judged.by_base.unseen, &unseen).is_some_and(|both| both.rmse[0] > CLEARLY_WORSE * both.rmse[1])
    };
    likeliest.into_iter().chain(composed).any(better)
}

impl Judged {
    /// The same where what is left is noise, with this `interference` at most: no words follow it.
    pub(crate) fn told_as_noise(mut self, prepared: &Prepared<'_>, interference: Interference) -> Self {
        if self.composition.take().is_some() {
            let library = prepared.testable.len();
            self.examined = self.examined.with(|selection| selection.of_the_library(library, 0));
        }
        self.predicted.decision = Decision::nothing(Verdict::Agrees, self.examined.selection.base);
        self.predicted.vetoed = None;
        self.interference = interference;
        self
    }
}
