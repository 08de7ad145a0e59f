//! What the library explains is told in words as well, as if no effect had a name.
//!
//! A library is never whole: where the effect that acts is not in it, the nearest member explains as much, and nothing in the recording says that the name is wrong. Words composed beside the
//! base model know no names. They are listed, with their odds against the library's answer, and the verdict stays what it was.
//!
//! Limits: beside the base model alone, so that of several causes the clearest is told; nothing is named here.

use crate::{
    discovery::compose::describe,
    pipeline::{
        judged::{Judged, Told, may_compose},
        prepare::Prepared,
    },
    selection::verdict::Verdict,
};

/// The same answer with what it says in words beside it, where something is missing and nothing was composed yet.
pub(crate) fn described(prepared: &Prepared<'_>, told: &Told<'_>, judged: Judged) -> Judged {
    let nothing_missing = judged.predicted.decision.verdict == Verdict::Agrees;
    if nothing_missing || judged.composition.is_some() || judged.kept_back.is_some() || !may_compose(told.options) {
        return judged;
    }
    let searched = prepared.searched();
    let search = &prepared.search(&searched, told.progress, told.stop);
    match describe(search, &judged.examined.selection, &prepared.lack_of_fit) {
        Some(composition) => judged.described_by(composition),
        None => judged,
    }
}
