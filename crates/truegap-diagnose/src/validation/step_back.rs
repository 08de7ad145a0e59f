//! An effect without which the others predict rows left out better is not claimed beside them.
//!
//! A fuller model is likelier because it fits the rows that it has seen. Where the physics is right it foretells the others, too. One effect is left out after another,
//! each time the one that costs most, by the rule of [`crate::validation::veto`]; the smaller model takes the place that the base model has there. Where all of them
//! together predict rows left out worse than the base model does, one may be to blame: then it is enough that they are predicted better without it.
//!
//! Where the noise was not measured, nothing says how it lasts, and a course of the noise looks like a small effect. There an effect must be felt in the error on rows left out.
//!
//! Limits: only models that the search has fitted; a number for whatever happens foretells nothing and is not judged.

use crate::{
    selection::{candidates::Tried, posterior::Selection},
    validation::{
        cross_validation::{HeldOutFit, compared},
        veto::{Against, Unseen, little},
    },
};

/// An effect that is not claimed, or all mechanisms that were composed beside the others.
#[derive(Clone, Debug, PartialEq)]
pub(crate) struct LeftOut {
    /// indices into the library
    pub effects: Vec<usize>,
    /// what rows left out say
    pub against: Against,
}

/// What else is known of models.
#[derive(Clone, Copy)]
pub(crate) struct Known<'k> {
    /// whether the noise was measured
    pub measured: bool,
    /// whether a model leaves little enough to be named by itself
    pub enough: &'k dyn Fn(usize) -> bool,
    /// whether tests see nothing in what a model leaves
    pub holds: &'k dyn Fn(usize) -> bool,
    /// whether a model stands out of whatever noise lasts beside another one
    pub stands_out: &'k dyn Fn(usize, &Unseen) -> bool,
}

/// The model to stand behind instead of `start`, its predictions of rows left out, and what was left out on the way. `enough` says whether a model leaves
/// little enough to be named by itself: else what is hardly felt where the noise was not `measured`, or loses a little in its squares, explains the rest all the same. Nor is what is hardly felt left out of a
/// model that `stands_out` of whatever noise lasts beside the one without it. Behind the first `library` effects stand composed mechanisms.
pub(crate) fn step_back(
    selection: &Selection,
    start: (usize, HeldOutFit),
    base: &HeldOutFit,
    unseen: impl Fn(&Tried) -> HeldOutFit,
    (library, free_form): (usize, impl Fn(usize) -> bool),
    Known { measured, enough, holds, stands_out }: Known<'_>,
) -> (usize, HeldOutFit, Vec<LeftOut>) {
    let ((mut model, mut named), mut left_out) = (start, Vec::new());
    // small gains are counted together: each is little beside the rest, and all of them may not be
    let mut nearest = named.clone();
    loop {
        let effects = &selection.models[model].effects;
        let with = || (named.clone(), &selection.models[model].fit);
        let all = Unseen::of((base.clone(), &selection.base().fit), with()).where_it_holds(holds(model));
        let doubtful = all.worse(measured).is_some() || all.larger();
        let smaller = |gone: Vec<usize>| {
            let others: Vec<usize> = effects.iter().copied().filter(|e| !gone.contains(e)).collect();
            let place = selection.models.iter().position(|m| m.key() == others.as_slice().into())?;
            (!others.is_empty() && !gone.is_empty() && !gone.iter().any(|e| free_form(*e))).then_some((gone, place))
        };
        // mechanisms were composed together, so that no model holds one of two
        let composed = effects.iter().copied().filter(|e| *e >= library).collect();
        let groups = effects.iter().map(|e| vec![*e]).chain([composed]);
        let judged = groups.filter_map(smaller).filter_map(|(effects, place)| {
            let without = &selection.models[place];
            let both = Unseen::of((unseen(without), &without.fit), with()).where_it_holds(holds(model));
            let better =
                || compared(&both.base, both.named.as_ref()?).map(|both| both.rmse).filter(|[without, with]| without < with);
            let stands = || {
                let beside = Unseen::of((base.clone(), &selection.base().fit), (both.base.clone(), &without.fit))
                    .where_it_holds(holds(place));
                beside.worse(measured).is_none() && !measured && enough(place)
            };
            let little = || little(&both.base, &nearest).filter(|_| stands() && !stands_out(model, &both));
            let doubted = || if doubtful { better().map(Against::Errors) } else { None };
            // what the noise alone tells of rows left out is no reason to name nothing
            let bearable = |against: &Against| doubtful || !matches!(against, Against::Score(_)) || enough(place);
            let against = both.worse(measured).filter(bearable).or_else(doubted).or_else(little)?;
            Some((place, both.base, LeftOut { effects, against }))
        });
        let cost = |left: &LeftOut| left.against.cost();
        let dearer = |a: (u8, f64), b: (u8, f64)| a.0.cmp(&b.0).then(a.1.total_cmp(&b.1));
        let Some((place, without, left)) = judged.max_by(|a, b| dearer(cost(&a.2), cost(&b.2))) else {
            return (model, named, left_out);
        };
        if !matches!(left.against, Against::Little(_)) {
            nearest = without.clone();
        }
        (model, named) = (place, without);
        left_out.push(left);
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::validation::cross_validation::PartError;

    /// Errors on two parts of a hundred rows each.
    fn errs(error: f64) -> HeldOutFit {
        let part =
            |_| PartError { name: "block".into(), squares: Some(100.0 * error * error), rows: 100, score: None, warned: None };
        HeldOutFit { parts: (0..2).map(part).collect(), ..HeldOutFit::default() }
    }

    /// What is left out of effects 0, 1 and 2, which err by 1.00 together; by `others` without some of them, and by 4 without all.
    fn left_out(others: &[(&[usize], f64)], measured: bool, enough: bool) -> Vec<usize> {
        left_out_of(others, (measured, enough, false))
    }

    /// The same where effects stand out of whatever noise lasts, or do not.
    fn left_out_of(others: &[(&[usize], f64)], (measured, enough, stands_out): (bool, bool, bool)) -> Vec<usize> {
        let whole: &[usize] = &[0, 1, 2];
        let models = [&[][..], whole].into_iter().chain(others.iter().map(|(effects, _)| *effects));
        let selection = Selection::of(&models.map(|effects| (effects, 0.0)).collect::<Vec<_>>());
        let error = |tried: &Tried| {
            let known = others.iter().find(|(effects, _)| *effects == tried.effects.as_slice());
            errs(known.map_or(1.0, |(_, error)| *error))
        };
        let (_, _, left) = step_back(
            &selection,
            (1, errs(1.0)),
            &errs(4.0),
            error,
            (2 + 1, |_| false),
            Known { measured, enough: &|_| enough, holds: &|_| true, stands_out: &|_, _| stands_out },
        );
        left.into_iter().flat_map(|left| left.effects).collect()
    }

    /// Each of two effects gains 3 % on rows left out, both together 7 %; the third is what counts.
    const HARDLY_FELT: &[(&[usize], f64)] = &[(&[0, 1], 1.03), (&[0, 2], 1.04), (&[1, 2], 2.0), (&[0], 1.07)];

    #[test]
    fn what_is_hardly_felt_is_left_out_where_the_noise_was_not_measured() {
        assert_eq!(left_out(HARDLY_FELT, false, true), [2]);
        // what stands out of whatever noise lasts is no course of it
        assert!(left_out_of(HARDLY_FELT, (false, true, true)).is_empty());
        // a noise that was measured tells such effects
        assert!(left_out(HARDLY_FELT, true, true).is_empty());
    }

    /// Small gains are counted together: without both, errors are 7 % larger, and one of them stays.
    #[test]
    fn small_gains_do_not_add_up_to_what_is_felt() {
        let felt_together: &[(&[usize], f64)] = &[(&[0, 1], 1.01), (&[0, 2], 1.04), (&[1, 2], 2.0), (&[0], 1.02)];
        assert_eq!(left_out(felt_together, false, true), [2, 1]);
        assert_eq!(left_out(HARDLY_FELT, false, true).len(), 1);
    }

    /// What explains the rest is told, however little it is felt: without it nothing could be named.
    #[test]
    fn what_the_rest_cannot_stand_without_stays() {
        assert!(left_out(HARDLY_FELT, false, false).is_empty());
    }

    /// Two mechanisms beside an effect gain 3 % together; no model holds one of them.
    #[test]
    fn mechanisms_go_together() {
        let all = Selection::of(&[(&[], 0.0), (&[0, 3, 4], 0.0), (&[0], 0.0)]);
        let error = |tried: &Tried| errs(if tried.effects == [0] { 1.03 } else { 1.0 });
        let (model, _, left) = step_back(
            &all,
            (1, errs(1.0)),
            &errs(4.0),
            error,
            (3, |_| false),
            Known { measured: false, enough: &|_| true, holds: &|_| true, stands_out: &|_, _| false },
        );
        assert_eq!((model, left[0].effects.as_slice()), (2, &[3, 4][..]));
    }

    /// Two effects err as one of them alone, and lose 5 squares of the noise beside it: it stays where the other alone could not be named, and goes where it could.
    #[test]
    fn a_few_squares_of_the_noise_are_no_reason_to_name_nothing() {
        let scored = |error: f64, score: f64| {
            let part = |_| PartError {
                name: "block".into(),
                squares: Some(100.0 * error * error),
                rows: 100,
                score: Some(score),
                warned: None,
            };
            HeldOutFit { parts: (0..2).map(part).collect(), ..HeldOutFit::default() }
        };
        let all = Selection::of(&[(&[], 0.0), (&[0, 1], 0.0), (&[0], 0.0)]);
        let alone = |_: &Tried| scored(1.0, 100.0);
        let left = |enough: bool| {
            let start = (1, scored(1.0, 102.5));
            step_back(
                &all,
                start,
                &scored(4.0, 900.0),
                alone,
                (2, |_| false),
                Known { measured: true, enough: &|_| enough, holds: &|_| true, stands_out: &|_, _| false },
            )
            .2
        };
        assert!(left(false).is_empty());
        assert_eq!(left(true)[0].effects, [1]);
    }
}
