//! What a mean to both sides foretells as well is no lag: the column that the base model follows may hold noise, or quick motion, of its own.
//!
//! A lag, a friction or a shift beside a model that follows a noisy column smooths the noise, and errs less for that alone. A mean over some rows to both sides does the same and comes without
//! a delay. What is named has to foretell rows left out clearly better than such a mean, or beside it, as it has to beside the base model alone; else nothing is named, and a reader is told of the mean.
//!
//! Names that gain less than a twentieth stand by a noise that was measured, and a mean that gains as little is measured in it as well: a lag and an early clock that undo one another do what it does.
//!
//! Where nothing is named and something is said to be missing, the mean is asked as well: where it leaves nothing that tests see, what was missing is noise of the column.
//!
//! Limits: base models without plates that follow a column on a clock; one window for the whole recording.

use crate::{
    data::context::Context,
    discovery::discover::with_mechanisms,
    effects::{
        course::Course,
        effect::Effect,
        mean_to_both_sides::{MeanToBothSides, said},
    },
    fit::optimum::Fit,
    pipeline::{
        calibrated::{predicted_like_base, predictions},
        judged::{Judged, Told},
        predicted::Predicted,
        prepare::Prepared,
    },
    selection::{
        candidates::{Search, Tried},
        verdict::{Decision, Verdict},
    },
    text::{capitalised, significant},
    validation::{
        cross_validation::{HeldOutFit, compared},
        tuning::CLEARLY_WORSE,
        veto::Unseen,
    },
};
use std::sync::atomic::Ordering;

/// What is told in place of a name, where a mean foretells as well.
pub(crate) struct ByAMean {
    pub verdict: Verdict,
    /// why what was named is not claimed
    pub says: String,
    /// the column whose quick motion the reading does not show
    pub followed: String,
}

/// What a mean says.
pub(crate) enum Mean {
    /// nothing: rows left out are predicted as well without one, or no mean means anything
    Nothing,
    /// it predicts them better than the base model alone, and what is told stands all the same
    Better,
    /// it is told in place of what is
    Instead(ByAMean),
}

/// What is told in place of what is named, where that foretells no clearly better than a mean.
pub(crate) fn by_a_mean(prepared: &Prepared<'_>, told: &Told<'_>, judged: &Judged) -> Mean {
    foretold(prepared, told, judged).unwrap_or(Mean::Nothing)
}

/// What a mean says, where it can be asked and predicts rows left out clearly better than the base model alone.
fn foretold(prepared: &Prepared<'_>, told: &Told<'_>, judged: &Judged) -> Option<Mean> {
    let context = &prepared.context;
    let named_something = judged.names_something();
    let missing = named_something || judged.predicted.decision.verdict == Verdict::Unexplained;
    let asked = missing && judged.kept_back.is_none() && !told.stop.load(Ordering::Relaxed);
    if !asked {
        return None;
    }
    let followed = smoothed_column(context)?;
    let searched = prepared.searched();
    let mechanisms = judged.composition.as_ref().map_or(&[][..], |composition| composition.mechanisms.as_slice());
    let search = &with_mechanisms(&prepared.search(&searched, told.progress, told.stop), mechanisms);
    let (ref search, mean) = with_the_mean(search);
    let tried = search.add_each(judged.examined.selection.base(), &[mean], 1, "a mean").pop()?;
    let unseen = predicted_like_base(prepared, search, &judged.by_base, &tried);
    let named = judged.predicted.unseen.stood_behind();
    let small = named_something && does_as_much(prepared, search, judged, &tried);
    if !small && !compared(&judged.by_base.unseen, &unseen)?.better_by(CLEARLY_WORSE) {
        return None;
    }
    let both = compared(&unseen, named)?;
    let fires = || prepared.lack_of_fit.adequacy(&tried.fit).fires();
    let [with_mean, without] = both.rmse.map(|rmse| significant(rmse, 3));
    let (mean_said, unit) = (said(half_width_s(search, &tried)), search.problem.simulator.unit());
    let followed = followed.name(context).to_string();
    if !named_something {
        if fires() {
            return Some(Mean::Better);
        }
        let says = format!(
            "{mean_said}, which comes without a delay, predicts rows left out better ({with_mean} against {without} {unit}): what is quick in {followed} may be noise of its own, so nothing is missing for it",
        );
        return Some(Mean::Instead(ByAMean { verdict: Verdict::Agrees, says: capitalised(&says), followed }));
    }
    if !small && (both.better_by(CLEARLY_WORSE) || felt_beside(prepared, search, judged, mean, &unseen)) {
        return Some(Mean::Better);
    }
    // what the named law leaves was little enough for its form to be right: the mean leaves as little
    let adequate = judged.predicted.decision.verdict != Verdict::WrongForm || !fires();
    let verdict = if adequate { Verdict::Agrees } else { Verdict::Unexplained };
    // a name may predict better over all, and in a few parts only
    let few = if both.rmse[1] * CLEARLY_WORSE < both.rmse[0] { " in half of the parts or more" } else { "" };
    let says = format!(
        "{} would fit, but {mean_said}, which comes without a delay, predicts rows left out as well{few} ({with_mean} against {without} {unit}): what is quick in {followed} may be noise of its own, so it is not claimed",
        capitalised(&prepared.names(&judged.stood_behind().effects)),
    );
    Some(Mean::Instead(ByAMean { verdict, says, followed }))
}

/// The column whose quick motion a mean smooths; `None` where no mean means anything.
pub(crate) fn smoothed_column(context: &Context<'_>) -> Option<Course> {
    let means = !context.has_plates() && MeanToBothSides.testable(context).is_ok();
    means.then(|| Course::on_a_clock(context).ok()).flatten()
}

/// The same search with the mean behind its library, and the place of the mean there.
pub(crate) fn with_the_mean<'s>(search: &Search<'s>) -> (Search<'s>, usize) {
    let library = search.library.iter().copied().chain([&MeanToBothSides as &dyn Effect]).collect();
    (Search { library, ..*search }, search.library.len())
}

/// Whether rows left out are predicted clearly better by what is named and the `mean` together than by the mean alone, which predicts `by_mean`: then it does something else than smooth.
fn felt_beside(prepared: &Prepared<'_>, search: &Search<'_>, judged: &Judged, mean: usize, by_mean: &HeldOutFit) -> bool {
    let together = search.add_each(judged.stood_behind(), &[mean], 1, "beside a mean").pop();
    let foretold = together.map(|tried| predicted_like_base(prepared, search, &judged.by_base, &tried));
    foretold.and_then(|both| compared(by_mean, &both)).is_some_and(|both| both.better_by(CLEARLY_WORSE))
}

/// Whether what is named gains on rows left out what is hardly felt, and in the noise no more beside a model with the `mean` alone than proves anything: names that undo one another smooth, too.
fn does_as_much(prepared: &Prepared<'_>, search: &Search<'_>, judged: &Judged, mean: &Tried) -> bool {
    let (base, named) = (&judged.by_base.unseen, judged.predicted.unseen.stood_behind());
    let felt = compared(base, named).is_none_or(|both| both.better_by(CLEARLY_WORSE));
    let ask = || predictions(prepared, search, &judged.by_base, mean);
    !felt && no_more_than(&ask(), &mean.fit, (named, &judged.stood_behind().fit), base)
}

/// Whether rows left out are predicted better by a mean than by the base model, and measured in the noise by what is named no better than by the mean.
fn no_more_than(by_mean: &HeldOutFit, mean: &Fit, (named, fit): (&HeldOutFit, &Fit), base: &HeldOutFit) -> bool {
    let smooths = compared(base, by_mean).is_some_and(|both| both.rmse[1] < both.rmse[0]);
    smooths && Unseen::of((by_mean.clone(), mean), (named.clone(), fit)).worse(true).is_some()
}

/// Half the window of a model whose last effect is the mean.
pub(crate) fn half_width_s(search: &Search<'_>, tried: &Tried) -> f64 {
    let model = search.model(&tried.effects);
    let values = model.values(&tried.fit.z);
    let last = tried.effects.len().saturating_sub(1);
    model.range_of(last).last().map_or(0.0, |place| values[place])
}

impl Judged {
    /// The same with nothing named.
    pub(crate) fn taken_back(mut self, ByAMean { verdict, says, followed }: ByAMean) -> Self {
        let decision = Decision::nothing(verdict, self.examined.selection.base);
        let left_out = [self.predicted.left_out, vec![says]].concat();
        self.predicted = Predicted {
            unseen: Unseen::nothing(self.by_base.unseen.clone()),
            decision,
            after: None,
            vetoed: None,
            left_out,
            refuted: Vec::new(),
        };
        self.held = Vec::new();
        self.smoothed = Some(followed);
        self
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::validation::cross_validation::PartError;

    /// Six parts of 242 rows; errors, and squares in the noise that are gained in each.
    fn foretold(error: f64, gained: [f64; 6]) -> HeldOutFit {
        let part = |gained: f64| PartError {
            name: "block".into(),
            squares: Some(242.0 * error * error),
            rows: 242,
            score: Some(240.0 - gained),
            warned: None,
        };
        HeldOutFit { parts: gained.map(part).into(), ..HeldOutFit::default() }
    }

    /// A simulation with noise of its own: a lag and an early clock that undo one another gain 3 % and a hundred squares of a measured noise, and so does a mean.
    #[test]
    fn names_that_gain_what_a_mean_gains_are_no_more_than_a_mean() {
        let fit = &Tried::leaving(vec![1.0], &[]).fit;
        let (base, mean) = (foretold(0.0463, [0.0; 6]), foretold(0.0450, [18.5, 9.3, 18.9, 11.7, 10.5, -0.9]));
        let named = foretold(0.0449, [19.5, 11.4, 20.5, 12.1, 12.0, -0.1]);
        assert!(no_more_than(&mean, fit, (&named, fit), &base));
        // a late clock gains as much, and a mean next to nothing of it, or nothing
        assert!(!no_more_than(&foretold(0.0462, [0.5; 6]), fit, (&named, fit), &base));
        assert!(!no_more_than(&base, fit, (&base, fit), &base));
    }
}
