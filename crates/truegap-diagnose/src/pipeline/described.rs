//! What the library explains is told in words as well, as if no effect had a name.
//!
//! A library is never whole: where the effect that acts is not in it, the nearest member explains as much, and nothing in the recording says that the name is wrong. Words composed beside the
//! base model know no names. They are listed, with their odds against the library's answer, and the verdict stays what it was.
//!
//! Where they are likelier than all of the library, explain more and say something else, the answer is theirs: one space of models holds both. They have to foretell rows left out as well; clearly better where the noise was
//! not measured, as the odds are what the noise was taken for.
//!
//! Limits: beside the base model alone, so that of several causes the clearest is told.

use crate::{
    data::error::DiagnoseError,
    discovery::{
        compose::{Composition, describe},
        same_words::says_the_same,
    },
    pipeline::{
        by_name::by_name,
        judged::{Judged, Told, judged_once, may_compose},
        laws_on_limits::lies_on_limits,
        prepare::Prepared,
    },
    selection::verdict::Verdict,
};

/// The same answer with what it says in words beside it, where something is missing and nothing was composed yet; the answer of the words, where they are likelier.
///
/// # Errors
/// Those of the simulator.
pub(crate) fn described(prepared: &Prepared<'_>, told: &Told<'_>, judged: Judged) -> Result<Judged, DiagnoseError> {
    let nothing_missing = judged.predicted.decision.verdict == Verdict::Agrees;
    if nothing_missing || judged.composition.is_some() || judged.kept_back.is_some() || !may_compose(told.options) {
        return Ok(judged);
    }
    let searched = prepared.searched();
    let search = &prepared.search(&searched, told.progress, told.stop);
    let strained = lies_on_limits(search, judged.stood_behind(), &judged.predicted.decision);
    let found = describe(search, &judged.examined.selection, &prepared.lack_of_fit, strained);
    let Some(composition) = found else { return Ok(judged) };
    // words never decide whether something is missing
    let another =
        judged.names_something() && !says_the_same(search, judged.stood_behind(), &composition.tried, &composition.mechanisms);
    let evidence = [judged.stood_behind(), &composition.tried].map(|model| model.fit.log_evidence);
    if !another || !are_likelier(composition.log_odds, evidence) {
        return Ok(judged.described_by(in_other_words(composition)));
    }
    let named = Composition { in_other_words: false, ..composition };
    let likelier = judged_once(prepared, told, judged.examined.clone(), Some(named), Some(judged.by_base.clone()))?;
    let likelier = match by_name(prepared, told, &likelier) {
        Some(name) => likelier.told_by(name),
        None => likelier,
    };
    let borne_out = match prepared.noise_is_known() {
        true => likelier.foretells_as_well_as(&judged),
        false => !judged.stands_before(&likelier, strained),
    };
    if likelier.names_something() && borne_out {
        return Ok(likelier);
    }
    Ok(match likelier.composition {
        Some(composition) => judged.described_by(in_other_words(composition)),
        None => judged,
    })
}

/// Whether words are likelier than names, by odds that leave room for equations that are off, and by the log evidence of `[names, words]` as it is: what explains more does not give its place up only because some
/// equation might be off.
fn are_likelier(log_odds: f64, [names, words]: [f64; 2]) -> bool {
    log_odds > 0.0 && words > names
}

/// Mechanisms beside a library that keeps its answer.
fn in_other_words(composition: Composition) -> Composition {
    Composition { in_other_words: true, library_strained: false, ..composition }
}

#[cfg(test)]
mod tests {
    use super::*;

    /// Jumps between runs explain 12.8 units of log evidence more than a mean of the time, whose odds are 5 to 1 once evidence is divided by what equations may be off by.
    #[test]
    fn words_that_explain_less_do_not_take_the_place_of_names() {
        assert!(!are_likelier(5.0_f64.ln(), [179.9, 167.1]));
        assert!(are_likelier(5.0_f64.ln(), [167.1, 179.9]));
        assert!(!are_likelier(-0.1, [167.1, 179.9]));
    }
}
