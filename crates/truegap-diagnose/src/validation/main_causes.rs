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
    /// Whether causes that remove `squares` are enough: they remove [`MAIN_SHARE`], and need no further part.
    pub(crate) fn is_enough(&self, squares: f64, hold_too: impl FnOnce() -> bool) -> bool {
        squares >= MAIN_SHARE * self.whole && self.needs_no_more(squares, hold_too)
    }

    /// Whether causes that remove `squares` need no further part: tests see something beside the whole model all the same, or the causes leave no more than [`FAR_ABOVE`] times its error, or they hold as well.
    pub(crate) fn needs_no_more(&self, squares: f64, hold_too: impl FnOnce() -> bool) -> bool {
        !self.holds || self.is_near(squares) || hold_too()
    }

    /// Whether what causes leave that remove `squares` is no more than [`FAR_ABOVE`] times the error of the whole.
    pub(crate) fn is_near(&self, squares: f64) -> bool {
        self.before - squares <= FAR_ABOVE * FAR_ABOVE * (self.before - self.whole)
    }
}

/// The fewest of `count` parts that remove `enough`, of as many the ones that remove most, and their share of the `whole`; all of them where no fewer do. `removed` gives the squares that a choice of parts
/// removes a row, `None` where it could not be fitted.
pub(crate) fn fewest(
    count: usize,
    whole: f64,
    enough: impl Fn(&[usize], f64) -> bool,
    removed: impl Fn(&[usize]) -> Option<f64>,
) -> (Vec<usize>, f64) {
    let all: Vec<usize> = (0..count).collect();
    if count > MOST_PARTS_OF_A_MODEL || whole <= 0.0 {
        return (all, 1.0);
    }
    for size in 1..count {
        let choices = (1_usize..1 << count).filter(|choice| choice.count_ones() as usize == size);
        let found = choices.filter_map(|choice| {
            let kept: Vec<usize> = all.iter().copied().filter(|part| choice & (1 << part) != 0).collect();
            removed(&kept).filter(|squares| enough(&kept, *squares)).map(|squares| (squares, kept))
        });
        if let Some((squares, kept)) = found.max_by(|a, b| a.0.total_cmp(&b.0)) {
            return (kept, squares / whole);
        }
    }
    (all, 1.0)
}

/// The same where the last part, behind `names` others, was composed of words: the fewest of the others that remove most of what those remove together, and the words where those are more than half of
/// the `whole`. `None` where names remove next to nothing, so that words are all.
pub(crate) fn names_first(names: usize, whole: f64, removed: impl Fn(&[usize]) -> Option<f64>) -> Option<(Vec<usize>, f64)> {
    let all: Vec<usize> = (0..names).collect();
    let by_names = if names == 0 { None } else { removed(&all) }?;
    if by_names < (1.0 - MAIN_SHARE) * whole || whole <= 0.0 {
        return None;
    }
    let (mut causes, share) = fewest(names, by_names, |_, squares| squares >= MAIN_SHARE * by_names, &removed);
    if 2.0 * by_names >= whole {
        return Some((causes, share * by_names / whole));
    }
    causes.push(names);
    let with_words = if causes.len() == names + 1 { None } else { removed(&causes) };
    Some((causes, with_words.map_or(1.0, |squares| squares / whole)))
}

/// The `causes` without the doubted ones after the first, and the share of what the whole model removes that is left to the others, as `share_of` gives it for some parts. They stay where the others are not `enough`. The first is the one
/// without which most is lost.
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
        Some(left) if kept.len() < causes.len() && enough(&kept, left) => (kept, left),
        _ => (causes, share),
    }
}

#[cfg(test)]
mod tests {
    use super::*;

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

    /// The first part removes 93 of 100, the second 6, the third 1.
    #[test]
    fn a_small_part_beside_a_large_one_is_not_among_the_causes() {
        let of = |kept: &[usize]| Some(kept.iter().map(|part| [93.0, 6.0, 1.0][*part]).sum());
        assert_eq!(fewest(3, 100.0, |_, squares| squares >= 90.0, of).0, [0]);
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
        let with = |holds: bool| fewest(3, 99.9991, |_, squares| whole(holds).is_enough(squares, || false), of).0;
        assert_eq!(with(true), [0, 1]);
        // where tests still see something, an equation that is slightly off leaves as much
        assert_eq!(with(false), [0]);
        // nor is it set aside for its name
        let without = |holds: bool| {
            let enough = |_: &[usize], share: f64| whole(holds).needs_no_more(share * 99.9991, || false);
            without_doubted((vec![0, 1], 1.0), enough, |kept| of(kept).map(|squares| squares / 99.9991), |part| part == 1).0
        };
        assert_eq!((without(true), without(false)), (vec![0, 1], vec![0]));
    }

    /// A sag of the supply leaves three and a half times the error that a drift beside it leaves, of which tests see nothing. Half as much again is left by a curve that is slightly off.
    #[test]
    fn a_part_without_which_twice_the_error_of_the_whole_is_left_is_a_cause() {
        let whole = Whole { before: 400.0, whole: 399.0, holds: true };
        let enough = |error: f64, holds_too: bool| whole.is_enough(400.0 - error * error, || holds_too);
        assert!(!enough(3.5, false) && enough(1.5, false));
        // tests that see nothing in what the others leave need no further part; nor does it matter where they see something beside all
        assert!(enough(3.5, true) && !enough(7.0, true));
        assert!(Whole { holds: false, ..whole }.is_enough(400.0 - 3.5 * 3.5, || false));
    }

    #[test]
    fn parts_that_matter_alike_stay() {
        let of = |kept: &[usize]| Some(kept.iter().map(|part| [60.0, 40.0][*part]).sum());
        assert_eq!(fewest(2, 100.0, |_, squares| squares >= 90.0, of), (vec![0, 1], 1.0));
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
        assert_eq!(fewest(3, 100.0, |_, squares| squares >= 90.0, of).0, [0]);
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
        let (causes, share) = names_first(2, 100.0, of(46.0)).unwrap();
        assert_eq!(causes, [0, 2]);
        approx::assert_relative_eq!(share, 0.98, max_relative = 1e-12);
        let (causes, share) = names_first(2, 100.0, of(94.0)).unwrap();
        assert_eq!(causes, [0]);
        approx::assert_relative_eq!(share, 0.95 * 0.94, max_relative = 1e-12);
        assert_eq!(names_first(2, 100.0, of(5.0)), None);
        assert_eq!(names_first(0, 100.0, of(5.0)), None);
    }

    #[test]
    fn where_nothing_is_removed_or_fitted_all_stay() {
        assert_eq!(fewest(2, 0.0, |_, _| true, |_| Some(0.0)).0, [0, 1]);
        assert_eq!(fewest(2, 1.0, |_, _| true, |_| None).0, [0, 1]);
    }
}
