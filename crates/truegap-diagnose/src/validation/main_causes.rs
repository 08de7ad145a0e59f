//! The fewest parts of a model that remove most of what the whole model removes on rows left out.
//!
//! Limits: every choice of parts is asked for, so a model has few.

use crate::validation::{
    cross_validation::{HeldOutFit, compared},
    tuning::{FAR_ABOVE, MAIN_SHARE, MOST_PARTS_OF_A_MODEL},
};

/// Squares by which a model predicts rows left out better than the base model, a row; `None` where no part was predicted by both.
pub(crate) fn removed(base: &HeldOutFit, model: &HeldOutFit) -> Option<f64> {
    let [before, after] = compared(base, model)?.rmse;
    Some(before.powi(2) - after.powi(2))
}

/// What the causes of a model have to remove where it removes the `whole` of what the base model leaves, which is `before`, in squares a row.
#[derive(Clone, Copy)]
pub(crate) struct Whole {
    pub before: f64,
    pub whole: f64,
    /// whether tests see nothing in what the whole model leaves
    pub holds: bool,
}

impl Whole {
    /// Whether causes that remove `squares` need no further part: tests see something beside the whole model all the same, or they hold as well. Or they leave no more than [`FAR_ABOVE`] times its error, and the
    /// further parts are not `borne_out` by rows left out.
    pub(crate) fn needs_no_more(&self, squares: f64, hold_too: impl FnOnce() -> bool, borne_out: impl FnOnce() -> bool) -> bool {
        !self.holds || hold_too() || (self.is_near(squares) && !borne_out())
    }

    /// Whether what causes leave that remove `squares` is no more than [`FAR_ABOVE`] times the error of the whole.
    pub(crate) fn is_near(&self, squares: f64) -> bool {
        self.before - squares <= FAR_ABOVE * FAR_ABOVE * (self.before - self.whole)
    }
}

/// What a choice of parts says by itself.
pub(crate) struct Asked<R, S> {
    /// squares that it removes a row; `None` where it could not be fitted
    pub removed: R,
    /// whether a law of it has run to a limit on which it does not lie in the whole model
    pub strained: S,
}

/// The fewest of `count` parts that remove `enough`, of as many the ones that remove most, and their share of the `whole`; all of them where no fewer do. Parts that remove most with a law on its limit stand for others that were
/// left out, so that more are needed.
pub(crate) fn fewest(
    count: usize,
    whole: f64,
    enough: impl Fn(&[usize], f64) -> bool,
    Asked { removed, strained }: &Asked<impl Fn(&[usize]) -> Option<f64>, impl Fn(&[usize]) -> bool>,
) -> (Vec<usize>, f64) {
    let all: Vec<usize> = (0..count).collect();
    if count > MOST_PARTS_OF_A_MODEL || whole <= 0.0 {
        return (all, 1.0);
    }
    for size in 1..count {
        let found = choices(count).filter(|kept| kept.len() == size);
        let found =
            found.filter_map(|kept| removed(&kept).filter(|squares| enough(&kept, *squares)).map(|squares| (squares, kept)));
        if let Some((squares, kept)) = found.max_by(|a, b| a.0.total_cmp(&b.0)).filter(|(_, kept)| !strained(kept)) {
            return (kept, squares / whole);
        }
    }
    (all, 1.0)
}

/// Every choice of so many parts but none of them.
fn choices(count: usize) -> impl Iterator<Item = Vec<usize>> {
    (1_usize..1 << count).map(move |choice| (0..count).filter(|part| choice & (1 << part) != 0).collect())
}

/// The choice of `count` parts that removes most with no law on its limit, and what it removes.
fn most_without_strain(
    count: usize,
    asked: &Asked<impl Fn(&[usize]) -> Option<f64>, impl Fn(&[usize]) -> bool>,
) -> Option<(Vec<usize>, f64)> {
    let few = if count > MOST_PARTS_OF_A_MODEL { 0 } else { count };
    let sound = choices(few).filter(|kept| !(asked.strained)(kept));
    sound.filter_map(|kept| (asked.removed)(&kept).map(|squares| (kept, squares))).max_by(|a, b| a.1.total_cmp(&b.1))
}

/// The same where the last part, behind `names` others, was composed of words: the fewest of the others that remove most of what those remove together, and the words where those are more than half of
/// the `whole`. Names that run to a limit without the words stand for them, and are fewer: the ones that remove most without that. `None` where names remove next to nothing, so that words are all.
pub(crate) fn names_first(
    names: usize,
    whole: f64,
    asked: &Asked<impl Fn(&[usize]) -> Option<f64>, impl Fn(&[usize]) -> bool>,
) -> Option<(Vec<usize>, f64)> {
    let all: Vec<usize> = (0..names).collect();
    let together = if names == 0 { None } else { (asked.removed)(&all) }?;
    if together < (1.0 - MAIN_SHARE) * whole || whole <= 0.0 {
        return None;
    }
    let (mut causes, by_names) = if (asked.strained)(&all) {
        most_without_strain(names, asked).filter(|(_, squares)| *squares >= (1.0 - MAIN_SHARE) * whole)?
    } else {
        let (causes, share) = fewest(names, together, |_, squares| squares >= MAIN_SHARE * together, asked);
        (causes, share * together)
    };
    if 2.0 * by_names >= whole {
        return Some((causes, by_names / whole));
    }
    causes.push(names);
    let with_words = if causes.len() == names + 1 { None } else { (asked.removed)(&causes) };
    Some((causes, with_words.map_or(1.0, |squares| squares / whole)))
}

/// The `causes` without the doubted ones after the first, and the share of what the whole model removes that is left to the others, as `share_of` gives it for some parts. They stay where the others are not `enough`, or predict worse than the
/// base model. The first is the one without which most is lost.
pub(crate) fn without_doubted(
    (causes, share): (Vec<usize>, f64),
    enough: impl Fn(&[usize], f64) -> bool,
    share_of: impl Fn(&[usize]) -> Option<f64>,
    doubted: impl Fn(usize) -> bool,
) -> (Vec<usize>, f64) {
    if causes.len() < 2 || !causes.iter().any(|part| doubted(*part)) {
        return (causes, share);
    }
    let without = |part: usize| causes.iter().copied().filter(|cause| *cause != part).collect::<Vec<_>>();
    let left = causes.iter().filter_map(|part| Some((*part, share_of(&without(*part))?)));
    let Some((first, _)) = left.min_by(|a, b| a.1.total_cmp(&b.1)) else { return (causes, share) };
    let kept: Vec<usize> = causes.iter().copied().filter(|part| *part == first || !doubted(*part)).collect();
    match share_of(&kept) {
        // what predicts worse than the base model is no cause alone, however doubtful the name beside it is
        Some(left) if kept.len() < causes.len() && left > 0.0 && enough(&kept, left) => (kept, left),
        _ => (causes, share),
    }
}

/// The `causes` and those of the other `parts` that are `sure` beside all but themselves, with the share of what the whole model removes that all of them remove together.
pub(crate) fn with_sure(
    (causes, share): (Vec<usize>, f64),
    parts: usize,
    share_of: impl Fn(&[usize]) -> Option<f64>,
    sure: impl Fn(usize, &[usize]) -> bool,
) -> (Vec<usize>, f64) {
    let all_but = |part: usize| (0..parts).filter(|other| *other != part).collect::<Vec<_>>();
    let claimed: Vec<usize> = (0..parts).filter(|part| causes.contains(part) || sure(*part, &all_but(*part))).collect();
    // a share takes as many fits as there are parts
    let removed = if claimed.len() > causes.len() { share_of(&claimed) } else { None };
    removed.map_or((causes, share), |removed| (claimed, removed))
}

#[cfg(test)]
mod tests {
    use super::*;

    /// Parts of which none runs to a limit.
    fn sound<R: Fn(&[usize]) -> Option<f64>>(removed: R) -> Asked<R, fn(&[usize]) -> bool> {
        Asked { removed, strained: |_| false }
    }

    #[test]
    fn a_sure_part_is_a_cause_beside_the_first() {
        let share_of = |parts: &[usize]| Some(0.5 + 0.1 * parts.len() as f64);
        let sure = |part: usize, others: &[usize]| part == 2 && others == [0, 1];
        assert_eq!(with_sure((vec![0], 0.6), 3, share_of, sure), (vec![0, 2], 0.7));
        assert_eq!(with_sure((vec![0], 0.6), 3, share_of, |_, _| false), (vec![0], 0.6));
    }

    /// Whether causes remove nine tenths and need no further part.
    fn is_enough(whole: &Whole, squares: f64, holds_too: bool, borne_out: bool) -> bool {
        squares >= MAIN_SHARE * whole.whole && whole.needs_no_more(squares, || holds_too, || borne_out)
    }

    /// A gain takes what a lag leaves from 1.16 to the noise of 0.625, where tests see the difference and all blocks are foretold better: less than twice the error.
    #[test]
    fn a_part_that_tests_see_and_most_parts_bear_out_is_a_cause() {
        let (before, lag, noise) = (7.247_f64, 1.158_f64, 0.625_f64);
        let whole = Whole { before: before.powi(2), whole: before.powi(2) - noise.powi(2), holds: true };
        let squares = before.powi(2) - lag.powi(2);
        assert!(!is_enough(&whole, squares, false, true) && is_enough(&whole, squares, false, false));
        // what tests do not see is none, nor is anything where they see something beside all
        assert!(is_enough(&whole, squares, true, true));
        assert!(is_enough(&Whole { holds: false, ..whole }, squares, false, true));
    }

    /// A lag alone runs to its limit to follow a drift as well; beside the drift it does not.
    #[test]
    fn a_law_that_runs_to_its_limit_stands_for_what_was_left_out() {
        let of = |kept: &[usize]| {
            Some(match kept {
                [0] => 96.2,
                [1] => 94.5,
                _ => 96.9,
            })
        };
        let with = |strained: bool| Asked { removed: of, strained: move |kept: &[usize]| strained && kept == [0] };
        let fewest = |strained: bool| fewest(2, 96.9, |_, squares| squares >= 0.9 * 96.9, &with(strained)).0;
        assert_eq!((fewest(true), fewest(false)), (vec![0, 1], vec![0]));
    }

    /// Without the words a settling runs to its limit to follow what they follow: it is no cause.
    #[test]
    fn names_that_run_to_a_limit_without_the_words_are_fewer() {
        let of = |kept: &[usize]| {
            Some(match kept {
                [0] => 88.0,
                [0, 1] => 98.1,
                [0, 2] => 98.0,
                [0, 1, 2] => 98.6,
                _ => 0.0,
            })
        };
        let with = |strained: bool| Asked { removed: of, strained: move |kept: &[usize]| strained && kept == [0, 1] };
        let causes = |strained: bool| names_first(2, 98.6, &with(strained)).unwrap().0;
        assert_eq!((causes(true), causes(false)), (vec![0], vec![0, 1]));
    }

    /// A late influence of the sun with a time constant beyond the recording is the sun added up, which words say: without them it removes 99 of 100 on that limit, beside them next to nothing.
    #[test]
    fn a_name_that_runs_to_a_limit_without_the_words_is_not_told_for_them() {
        let of = |late: f64| move |kept: &[usize]| Some(if kept.len() == 2 { 100.0 } else { [late, 99.9][kept[0]] });
        let with = |late: f64| Asked { removed: of(late), strained: |kept: &[usize]| kept == [0] };
        assert_eq!(names_first(1, 100.0, &with(99.0)), None);
        assert_eq!(fewest(2, 100.0, |_, squares| squares >= 90.0, &with(99.0)).0, [1]);
        assert_eq!(names_first(1, 100.0, &sound(of(99.0))).unwrap().0, [0]);
    }

    /// Parts that remove 60, 30 and 10 of 100.
    #[test]
    fn a_doubted_part_after_the_first_is_no_cause() {
        let of = |kept: &[usize]| Some(kept.iter().map(|part| [0.6, 0.3, 0.1][*part]).sum());
        let all = || (vec![0, 1, 2], 1.0);
        let (causes, share) = without_doubted(all(), |_, _| true, of, |part| part == 1);
        assert_eq!(causes, [0, 2]);
        approx::assert_relative_eq!(share, 0.7, max_relative = 1e-12);
        // the first stays, doubted or not
        assert_eq!(without_doubted(all(), |_, _| true, of, |part| part == 0), all());
        assert_eq!(without_doubted(all(), |_, _| true, of, |_| true).0, [0]);
        assert_eq!(without_doubted((vec![1], 0.3), |_, _| true, of, |_| true), (vec![1], 0.3));
        assert_eq!(without_doubted(all(), |_, _| true, |_| None, |_| true), all());
    }

    /// Of a loop and a late clock the clock is lost least without, and predicts worse than the base model alone: the doubted loop stays beside it.
    #[test]
    fn what_predicts_worse_alone_than_the_base_model_is_no_cause() {
        let of = |alone: f64| {
            move |kept: &[usize]| {
                Some(match kept {
                    [0] => -0.2,
                    [1] => alone,
                    _ => 1.0,
                })
            }
        };
        let causes = |alone: f64| without_doubted((vec![0, 1], 1.0), |_, _| true, of(alone), |part| part == 0).0;
        assert_eq!((causes(-0.1), causes(0.1)), (vec![0, 1], vec![1]));
    }

    /// The first part removes 93 of 100, the second 6, the third 1.
    #[test]
    fn a_small_part_beside_a_large_one_is_not_among_the_causes() {
        let of = |kept: &[usize]| Some(kept.iter().map(|part| [93.0, 6.0, 1.0][*part]).sum());
        assert_eq!(fewest(3, 100.0, |_, squares| squares >= 90.0, &sound(of)).0, [0]);
    }

    /// The base model leaves 100, a clock alone 2.5, a lag beside it 0.001 and a curve beside those two 0.0009: noise is 0.0009.
    #[test]
    fn a_part_that_takes_the_rest_down_to_noise_is_a_cause_however_small_it_is() {
        let of = |kept: &[usize]| {
            Some(match kept {
                [0] | [0, 2] => 97.5,
                [0, 1] => 99.999,
                [0, 1, 2] => 99.9991,
                _ => 20.0,
            })
        };
        let whole = |holds: bool| Whole { before: 100.0, whole: 99.9991, holds };
        let with = |holds: bool| fewest(3, 99.9991, |_, squares| is_enough(&whole(holds), squares, false, false), &sound(of)).0;
        assert_eq!(with(true), [0, 1]);
        // where tests still see something, an equation that is slightly off leaves as much
        assert_eq!(with(false), [0]);
        // nor is it set aside for its name
        let without = |holds: bool| {
            let enough = |_: &[usize], share: f64| whole(holds).needs_no_more(share * 99.9991, || false, || false);
            without_doubted((vec![0, 1], 1.0), enough, |kept| of(kept).map(|squares| squares / 99.9991), |part| part == 1).0
        };
        assert_eq!((without(true), without(false)), (vec![0, 1], vec![0]));
    }

    /// A sag of the supply leaves three and a half times the error that a drift beside it leaves, of which tests see nothing. Half as much again is left by a curve that is slightly off.
    #[test]
    fn a_part_without_which_twice_the_error_of_the_whole_is_left_is_a_cause() {
        let whole = Whole { before: 400.0, whole: 399.0, holds: true };
        let enough = |error: f64, holds_too: bool| is_enough(&whole, 400.0 - error * error, holds_too, false);
        assert!(!enough(3.5, false) && enough(1.5, false));
        // tests that see nothing in what the others leave need no further part; nor does it matter where they see something beside all
        assert!(enough(3.5, true) && !enough(7.0, true));
        assert!(is_enough(&Whole { holds: false, ..whole }, 400.0 - 3.5 * 3.5, false, false));
    }

    #[test]
    fn parts_that_matter_alike_stay() {
        let of = |kept: &[usize]| Some(kept.iter().map(|part| [60.0, 40.0][*part]).sum());
        assert_eq!(fewest(2, 100.0, |_, squares| squares >= 90.0, &sound(of)), (vec![0, 1], 1.0));
    }

    /// Two parts undo one another: without either the model is far off, without both it is as good.
    #[test]
    fn parts_that_undo_one_another_are_seen_together() {
        let of = |kept: &[usize]| {
            Some(match kept {
                [0, 1] | [0, 2] => 40.0,
                [0] => 97.0,
                _ => 0.0,
            })
        };
        assert_eq!(fewest(3, 100.0, |_, squares| squares >= 90.0, &sound(of)).0, [0]);
    }

    /// Words that do all of it by themselves take nothing from the names that were there first, and are a cause where those leave more than half.
    #[test]
    fn names_come_before_words() {
        let of = |names: f64| {
            move |kept: &[usize]| {
                Some(match kept {
                    [0, 1] => names,
                    [0] => 0.95 * names,
                    [0, 2] => 98.0,
                    _ => 0.0,
                })
            }
        };
        let (causes, share) = names_first(2, 100.0, &sound(of(46.0))).unwrap();
        assert_eq!(causes, [0, 2]);
        approx::assert_relative_eq!(share, 0.98, max_relative = 1e-12);
        let (causes, share) = names_first(2, 100.0, &sound(of(94.0))).unwrap();
        assert_eq!(causes, [0]);
        approx::assert_relative_eq!(share, 0.95 * 0.94, max_relative = 1e-12);
        assert_eq!(names_first(2, 100.0, &sound(of(5.0))), None);
        assert_eq!(names_first(0, 100.0, &sound(of(5.0))), None);
    }

    #[test]
    fn where_nothing_is_removed_or_fitted_all_stay() {
        assert_eq!(fewest(2, 0.0, |_, _| true, &sound(|_| Some(0.0))).0, [0, 1]);
        assert_eq!(fewest(2, 1.0, |_, _| true, &sound(|_| None)).0, [0, 1]);
    }
}
