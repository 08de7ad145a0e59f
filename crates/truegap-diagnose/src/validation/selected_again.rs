//! What is named, chosen anew without each part of the recording in turn, and how well that choice predicts the part.
//!
//! Rows left out say how well the numbers of a choice carry over; the choice itself was made with all rows. Here it is made without them as well: base model, candidates,
//! evidence and verdict see nothing of the part. It takes as many searches as there are parts.
//!
//! Limits: noise, block averages and the scale of priors come from all rows; mechanisms composed of words are not looked for; the inputs of the part stay, since what a
//! sensor remembers of them is part of the other rows.

use crate::{
    adequacy::{directions::Direction, lack_of_fit::LackOfFitTests},
    fit::tuning::LOOSE,
    selection::{
        candidates::{Progress, Search},
        examine::examine,
        verdict::Verdict,
    },
    validation::{
        all_rows::AllRows,
        cross_validation::{Part, kept, parts_of},
    },
    whitening::noise_model::NoiseModel,
};
use std::sync::atomic::Ordering;

/// A choice made without one part of the recording.
pub(crate) struct ChosenWithout {
    /// the part
    pub part: Part,
    /// what was decided without it
    pub verdict: Verdict,
    /// indices of the effects named without it, ascending
    pub effects: Vec<usize>,
    /// predictions of every row; `None` where there is none
    pub prediction: Option<Vec<f64>>,
}

/// Chooses again without each part; `noise` is that of the rows that are searched. Ends early where it is asked to, and leaves out a part without which nothing can be
/// fitted.
pub(crate) fn selected_again(
    search: &Search<'_>,
    noise: &NoiseModel,
    directions: &[Direction],
    all: AllRows<'_>,
) -> Vec<ChosenWithout> {
    let going_on = || !search.stop.load(Ordering::Relaxed);
    let parts = parts_of(all.problem).1;
    let count = parts.len();
    let one = |(index, part): (usize, Part)| {
        let (what, done) = (format!("{} of {count} parts left out", index + 1), index as f64 / count as f64);
        (search.progress)(Progress { step: "chosen again", what, done });
        let (verdict, mut effects, z) = without(search, noise, directions, &part, all.first).filter(|_| going_on())?;
        let model = search.model_over(all.problem, &effects);
        let prediction = model.respond(&z).ok();
        effects.sort_unstable();
        Some(ChosenWithout { part, verdict, effects, prediction })
    };
    parts.into_iter().enumerate().take_while(|_| going_on()).filter_map(one).collect()
}

/// Verdict, effects and coordinates of the model stood behind without a part.
fn without(
    search: &Search<'_>,
    noise: &NoiseModel,
    directions: &[Direction],
    part: &Part,
    first: Option<&[usize]>,
) -> Option<(Verdict, Vec<usize>, Vec<f64>)> {
    let runs = search.problem.runs();
    let keep = kept(part, search.problem.response.len(), first);
    let whitener = noise.whitener(&runs, Some(&keep));
    let loose = noise.scaled(LOOSE).whitener(&runs, Some(&keep));
    let lack_of_fit = LackOfFitTests::of(search.problem, noise, &whitener, directions, Some(&keep));
    // a search of its own is one step of this stage, whatever it goes through itself
    let quiet = |_: Progress| {};
    let library = search.library.clone();
    let fewer = Search { whitener: &whitener, loose: &loose, scout: None, library, progress: &quiet, ..*search };
    let examined = examine(&fewer, &lack_of_fit).ok()?;
    let model = &examined.selection.models[examined.decision.model];
    Some((examined.decision.verdict, model.effects.clone(), model.fit.z.clone()))
}
