//! A name that only smooths is carried, and not claimed beside others.
//!
//! A lag and a clock that undo one another, or a play beside a cause, smooth what is quick in the column that the base model follows. Where a mean to both sides does as much in the place of a name, beside all
//! other names, nothing is seen of the name but that. The model keeps it, for it predicts.
//!
//! Names are asked one after another, with the mean in the place of those before: of a lag and a clock that undo one another either may be left out first.
//!
//! Limits: base models without plates that follow a column on a clock; one name, alone, is asked by `by_a_mean`.

use crate::{
    effects::mean_to_both_sides::said,
    pipeline::{
        by_a_mean::{half_width_s, smoothed_column, with_the_mean},
        calibrated::{ByBase, predictions},
        prepare::Prepared,
    },
    selection::{
        candidates::{Search, Tried},
        tuning::ADEQUATE,
        verdict::{Decision, Verdict},
    },
    text::{capitalised, significant, spoken},
    validation::{
        cross_validation::{HeldOutFit, compared},
        tuning::CLEARLY_WORSE,
    },
};

/// The decision on the model `chosen`, which foretells what is `named`, with the names that only smooth among those that are carried; and what a reader is told of them.
pub(crate) fn beside_a_mean(
    prepared: &Prepared<'_>,
    search: &Search<'_>,
    chosen: &Tried,
    (decision, named): (Decision, &HeldOutFit),
    by_base: &ByBase,
) -> (Decision, Vec<String>) {
    let claimed: Vec<usize> = chosen.effects.iter().copied().filter(|e| !decision.carried.contains(e)).collect();
    if smoothed_column(search.context).is_none() || claimed.len() < 2 {
        return (decision, Vec::new());
    }
    let (ref search, mean) = with_the_mean(search);
    let foretold = |tried: &Tried| predictions(prepared, search, by_base, tried);
    let without = |smooths: &[usize]| {
        let kept: Vec<usize> = chosen.effects.iter().copied().filter(|e| !smooths.contains(e)).collect();
        search.part_of(chosen, &kept)
    };
    let (mut smooths, mut says) = (Vec::new(), Vec::new());
    for effect in claimed.iter().copied().filter(|effect| search.library[*effect].smooths()) {
        let together = [smooths.as_slice(), &[effect]].concat();
        if together.len() == claimed.len() {
            break;
        }
        let Some(others) = without(&together) else { continue };
        let Some(tried) = search.add_each(&others, &[mean], 1, "beside a mean").pop() else { continue };
        let clearly = |a: &HeldOutFit, b: &HeldOutFit| compared(a, b).is_some_and(|both| both.better_by(CLEARLY_WORSE));
        let by_mean = foretold(&tried);
        let Some(both) = compared(&by_mean, named) else { continue };
        // what is hardly felt has to be foretold by the mean to the last digit
        let felt = clearly(&foretold(&others), named);
        let as_much = if felt { !clearly(&by_mean, named) } else { both.rmse[0] <= both.rmse[1] };
        if !as_much {
            continue;
        }
        let [with_mean, with_name] = both.rmse.map(|rmse| significant(rmse, 3));
        says.push(format!(
            "{} only smooths: {}, which comes without a delay, predicts rows left out as well in its place ({with_mean} against {with_name} {}), so it is not claimed",
            capitalised(&spoken(search.library[effect].id().0)),
            said(half_width_s(search, &tried)),
            search.problem.simulator.unit(),
        ));
        smooths = together;
    }
    if smooths.is_empty() {
        return (decision, says);
    }
    let near = decision.verdict == Verdict::Explained || decision.claimed >= ADEQUATE;
    let carried = ([decision.carried.as_slice(), &smooths].concat(), decision.claimed, near);
    let after = prepared.lack_of_fit.adequacy(&chosen.fit);
    (decision.carrying(carried, &chosen.effects, &after), says)
}
