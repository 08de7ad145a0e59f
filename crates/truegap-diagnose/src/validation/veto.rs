//! Rows left out have the last word: what predicts them worse than the calibrated base model in most parts, or with more than twice its error over all, is not claimed.
//!
//! Neither is what the noise says the same of: an effect that hardly stands out changes no error that one would see, so its errors are measured in the noise as well. There it must gain
//! what it costs to be one of many effects that were tried. What it gains in belief counts there, too: where the others could follow the rows only with numbers that nobody believes,
//! rows left out are followed as well with those numbers, and cannot tell.
//!
//! One part alone may be hard for the right physics too: where it holds the only first loading, or all that came before a change.
//!
//! Limits: a number for each run, or for whatever happens, foretells nothing of a run left out and is not judged by it.

use crate::{
    fit::optimum::Fit,
    validation::cross_validation::{Compared, HeldOutFit, PartError, compared, misfit_removed},
    validation::tuning::{CLEARLY_WORSE, EXTRAPOLATED, FAR_OUT, FELT, FORETOLD, PROOF},
};

/// Predictions of rows left out, by the base model and by the model stood behind.
pub(crate) struct Unseen {
    /// calibrated base model
    pub base: HeldOutFit,
    /// the model stood behind; absent where it is the base model
    pub named: Option<HeldOutFit>,
    /// squares by which the numbers of the model stood behind are more believable than those of the base model
    pub believed: f64,
    /// whether tests see nothing in what the model stood behind leaves: then its equations hold, and what its numbers leave open is as the noise says
    pub holds: bool,
}

/// How rows left out speak against a model.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(crate) enum Against {
    /// errors without it and with it
    Errors([f64; 2]),
    /// by how many squares of noise they are predicted worse with it; below 0 where they are predicted better, by less than proves anything
    Score(f64),
    /// errors without it and with it, which is smaller by less than a noise can say that was not measured
    Little([f64; 2]),
}

impl Against {
    /// How rows left out are predicted by the others, beside this model: as well, where it gains there and by less than proves anything; else better.
    pub fn others_predict(self) -> &'static str {
        match self {
            Self::Score(lost) if lost <= 0.0 => "as well",
            Self::Little([without, with]) if with <= without => "nearly as well",
            _ => "better",
        }
    }

    /// What it costs, for comparisons: clearly larger errors before scores, and scores before gains that are small.
    pub fn cost(self) -> (u8, f64) {
        match self {
            Self::Errors([without, with]) => (2, with / without),
            Self::Score(lost) => (1, lost),
            Self::Little([without, with]) => (0, with / without),
        }
    }
}

impl Unseen {
    /// The base model alone.
    pub fn nothing(base: HeldOutFit) -> Self {
        Self { base, named: None, believed: 0.0, holds: false }
    }

    /// Predictions `without` an effect and `with` it, and by how much more believable the numbers of its fit are; what its numbers leave open does not count.
    pub fn of(without: (HeldOutFit, &Fit), with: (HeldOutFit, &Fit)) -> Self {
        let believed = (without.1.disbelief() - with.1.disbelief()).max(0.0);
        Self { base: without.0, named: Some(with.0), believed, holds: false }
    }

    /// The same where what numbers leave open counts if the model with the effect `holds`.
    #[must_use]
    pub fn where_it_holds(self, holds: bool) -> Self {
        Self { holds, ..self }
    }

    /// Predictions of the model without what is named.
    pub fn without(&self) -> &HeldOutFit {
        &self.base
    }

    /// Predictions of the model stood behind.
    pub fn stood_behind(&self) -> &HeldOutFit {
        self.named.as_ref().unwrap_or(&self.base)
    }

    /// What speaks against the model: an error that is larger by more than [`EXTRAPOLATED`], or clearly larger and larger in most parts; or errors that are larger over all, measured
    /// in the noise, or smaller by next to nothing, and clearly smaller in no more than half of the parts. A noise that was not `measured` says nothing of errors that are clearly smaller.
    pub fn worse(&self, measured: bool) -> Option<Against> {
        let compared = self.compared()?;
        let [base, named] = compared.rmse;
        let mostly = named > CLEARLY_WORSE * base && compared.mostly_worse();
        if (named > EXTRAPOLATED * base || mostly) && !self.foreseen() {
            return Some(Against::Errors([base, named]));
        }
        let counts = measured || CLEARLY_WORSE * named > base;
        self.lost().filter(|_| counts).map(Against::Score)
    }

    /// The same, and what is too little for a noise that was not `measured`: an error that is smaller by less than [`CLEARLY_WORSE`], or one that is clearly larger and was [foreseen](Self::foreseen).
    /// Where the model stands out of whatever noise lasts (`stands_out`), such an error is none.
    pub fn against(&self, measured: bool, stands_out: impl FnOnce() -> bool) -> Option<Against> {
        let named = self.named.as_ref().filter(|_| !measured);
        let too_little = || little(&self.base, named?).filter(|_| !stands_out());
        let larger = |against: Against| match against {
            Against::Little(errors) if self.foreseen() && self.larger() => Against::Errors(errors),
            other => other,
        };
        self.worse(measured).or_else(|| too_little().map(larger))
    }

    /// Whether the error on rows left out is smaller by what is [`FELT`], in most parts.
    pub fn is_felt(&self) -> bool {
        self.compared().is_some_and(|both| both.better_by(FELT))
    }

    /// Whether rows left out are foretold so much better, in most parts, that no slow noise of this `level` does as much: 1 is the noise that was taken. Or whether the base model follows them with numbers
    /// that nobody believes: a slow noise moves numbers that the recording tells well by next to nothing of what is known of them beforehand.
    pub fn stands_out_of(&self, level: f64) -> bool {
        let level = level.max(1.0);
        self.believed > PROOF * level || self.gained().is_some_and(|(gained, mostly)| mostly && gained > FAR_OUT * level)
    }

    /// Whether the model foretells rows left out better where what its numbers leave open without them is counted: an error that it warned of is no mistake.
    fn foreseen(&self) -> bool {
        self.gained_beside_open_numbers().is_some_and(|gains| gains.iter().sum::<f64>() > PROOF)
    }

    /// Whether the error over all rows left out is clearly larger than that of the base model, in however few parts.
    pub fn larger(&self) -> bool {
        self.compared().is_some_and(|both| both.rmse[1] > CLEARLY_WORSE * both.rmse[0])
    }

    /// Whether errors of a row without a model and with it, on the `rows` that both were fitted to, are larger with it: by more squares of the noise of a row, `floor`, than its numbers are more believable. A
    /// base model may come nearer with numbers that nobody believes.
    pub fn farther(&self, [without, with]: [f64; 2], rows: usize, floor: f64) -> bool {
        with > without && rows as f64 * (with.powi(2) - without.powi(2)) > self.believed * floor.powi(2)
    }

    /// Share of the reproducible misfit that the model removes on rows left out; `None` where there is next to none. `floor` is the noise of a row, measured on `rows` of them.
    pub fn removed(&self, floor: f64, rows: usize) -> Option<f64> {
        let [base, named] = self.compared()?.rmse;
        misfit_removed(base, named, floor, rows)
    }

    /// Whether the model predicts most parts better.
    pub fn in_most_parts(&self) -> bool {
        self.compared().is_some_and(|both| both.mostly_better())
    }

    /// Errors of the base model and of the model stood behind; `None` where that is the base model.
    fn compared(&self) -> Option<Compared> {
        compared(&self.base, self.named.as_ref()?)
    }

    /// Squares of the noise that the model gains on rows left out, and whether most parts are foretold better; what the numbers of both models leave open is counted where both tell it and the model holds.
    fn gained(&self) -> Option<(f64, bool)> {
        let gains = self.gained_beside_open_numbers().or_else(|| self.each_gained(|part| part.score))?;
        let foretold = gains.iter().filter(|gain| **gain > FORETOLD).count();
        Some((gains.iter().sum(), 2 * foretold > gains.len()))
    }

    /// What the model gains in each part where what numbers leave open is counted; `None` where it is not told, or the model does not hold.
    fn gained_beside_open_numbers(&self) -> Option<Vec<f64>> {
        if self.holds { self.each_gained(|part| part.warned) } else { None }
    }

    /// What the model gains in each part that both models score; `None` where there is no such part.
    fn each_gained(&self, score: impl Fn(&PartError) -> Option<f64>) -> Option<Vec<f64>> {
        let parts = self.base.parts.iter().zip(&self.named.as_ref()?.parts);
        let gains: Vec<f64> = parts.filter_map(|(base, named)| Some(score(base)? - score(named)?)).collect();
        (!gains.is_empty()).then_some(gains)
    }

    /// Squares of the noise that the model loses on rows left out, where it foretells no more than half of the parts; what it gains there and in belief is no proof below [`PROOF`].
    fn lost(&self) -> Option<f64> {
        let (gained, mostly) = self.gained()?;
        (gained + self.believed < PROOF && !mostly).then_some(-gained)
    }
}

/// What speaks against an effect whose gain is hardly felt: errors `without` it and `with` it that differ by less than [`CLEARLY_WORSE`].
pub(crate) fn little(without: &HeldOutFit, with: &HeldOutFit) -> Option<Against> {
    let [without, with] = compared(without, with)?.rmse;
    (without < CLEARLY_WORSE * with).then_some(Against::Little([without, with]))
}

#[cfg(test)]
mod tests {
    use super::*;

    fn predicted(errors: &[f64]) -> HeldOutFit {
        let part =
            |squares: &f64| PartError { name: "run 1".into(), squares: Some(*squares), rows: 4, score: None, warned: None };
        HeldOutFit { parts: errors.iter().map(part).collect(), ..HeldOutFit::default() }
    }

    #[test]
    fn a_model_that_predicts_worse_is_told_from_one_that_predicts_better() {
        let worse = Unseen { base: predicted(&[4.0, 4.0]), named: Some(predicted(&[2.0, 70.0])), believed: 0.0, holds: true };
        assert_eq!(worse.worse(true), Some(Against::Errors([1.0, 3.0])));
        assert_eq!(
            Unseen { base: predicted(&[4.0]), named: Some(predicted(&[1.0])), believed: 0.0, holds: true }.worse(true),
            None
        );
        // an error that extrapolation makes in one part is no proof against it, one in most parts is
        let of = |named: &[f64]| {
            Unseen { base: predicted(&[4.0, 4.0, 4.0]), named: Some(predicted(named)), believed: 0.0, holds: true }.worse(true)
        };
        assert_eq!(of(&[2.0, 3.0, 16.0]), None);
        assert!(of(&[7.0, 5.0, 3.0]).is_some());
        // nor is a hundredth in every part
        assert_eq!(of(&[4.08, 4.08, 4.08]), None);
        assert_eq!(Unseen::nothing(predicted(&[4.0])).worse(true), None);
    }

    #[test]
    fn what_is_removed_on_rows_left_out_is_counted_above_the_noise_and_by_parts() {
        let of = |named: &[f64]| Unseen {
            base: predicted(&[64.0, 64.0, 64.0]),
            named: Some(predicted(named)),
            believed: 0.0,
            holds: true,
        };
        // errors of 4 and 2, and a noise of 1: 1 - (4 - 1) / (16 - 1)
        approx::assert_relative_eq!(of(&[16.0, 16.0, 16.0]).removed(1.0, 500).unwrap(), 0.8, max_relative = 1e-12);
        assert!(of(&[16.0, 16.0, 16.0]).in_most_parts());
        // one part for all
        assert!(!of(&[0.1, 66.0, 66.0]).in_most_parts());
        // nothing above the noise to remove
        let within = Unseen { base: predicted(&[4.0]), named: Some(predicted(&[3.0])), believed: 0.0, holds: true };
        assert_eq!(within.removed(1.0, 500), None);
        assert!(!Unseen::nothing(predicted(&[4.0])).in_most_parts());
    }

    /// Errors that nobody sees by eye, measured in the noise. A mimic gains in the parts that it was fitted to and loses 30 squares of noise in one that it was not; the right physics
    /// may lose more in the part that holds the only first loading and gains in the others.
    #[test]
    fn what_the_noise_says_of_rows_left_out_counts_where_errors_are_alike() {
        let believed = |gains: [f64; 4], believed: f64| {
            let fit = |gain: &dyn Fn(usize) -> f64| {
                let part = |k: usize| PartError {
                    name: "run".into(),
                    squares: Some(400.0),
                    rows: 100,
                    score: Some(100.0 - gain(k)),
                    warned: None,
                };
                HeldOutFit { parts: (0..4).map(part).collect(), ..HeldOutFit::default() }
            };
            Unseen { base: fit(&|_| 0.0), named: Some(fit(&|k| gains[k])), believed, holds: true }.worse(true)
        };
        let of = |gains| believed(gains, 0.0);
        // halves, so that sums are exact
        assert_eq!(of([0.25, 0.5, -30.0, -1.0]), Some(Against::Score(30.25)));
        assert_eq!(of([40.0, 12.0, -3000.0, 14.0]), None);
        // clearly better in one part of four: by chance, unless it is by more than trying many effects costs
        assert_eq!(of([0.25, 0.5, 9.0, -1.0]), Some(Against::Score(-8.75)));
        assert_eq!(of([0.25, 0.5, 19.0, -1.0]), None);
        assert_eq!(of([2.5, 3.5, 2.5, -1.0]), None);
        // the base model follows all rows as well, with numbers that nobody believes
        assert_eq!(believed([0.25, 0.5, -0.25, -1.0], 60.0), None);
        assert_eq!(believed([0.25, 0.5, -80.0, -1.0], 60.0), Some(Against::Score(80.25)));
    }

    /// Errors of 10 and 11 in 100 rows with a noise of 5 are 84 squares apart: a base model whose numbers are further off by 90 squares has followed the rows with numbers that nobody believes.
    #[test]
    fn larger_errors_count_beyond_what_nobody_believes() {
        let of = |believed: f64, errors| {
            Unseen { base: predicted(&[4.0]), named: None, believed, holds: true }.farther(errors, 100, 5.0)
        };
        assert!(of(0.0, [10.0, 11.0]) && of(80.0, [10.0, 11.0]));
        assert!(!of(90.0, [10.0, 11.0]));
        assert!(!of(0.0, [11.0, 10.0]) && !of(0.0, [10.0, 10.0]));
    }

    /// Errors of 20 and 18, in two parts, one of which loses 30 squares of a noise and the other nothing: where that noise was taken from what a model leaves, the smaller error counts.
    #[test]
    fn a_noise_that_was_not_measured_says_nothing_of_errors_that_are_smaller() {
        let fit = |error: f64, lost: f64| {
            let part = |score| PartError {
                name: "block".into(),
                squares: Some(100.0 * error * error),
                rows: 100,
                score: Some(score),
                warned: None,
            };
            let parts = vec![part(100.0), part(100.0 + lost)];
            HeldOutFit { parts, ..HeldOutFit::default() }
        };
        let of = |error: f64| Unseen { base: fit(20.0, 0.0), named: Some(fit(error, 30.0)), believed: 0.0, holds: true };
        assert_eq!(of(18.0).worse(true), Some(Against::Score(30.0)));
        assert_eq!(of(18.0).worse(false), None);
        assert_eq!(of(19.5).worse(false), Some(Against::Score(30.0)));
    }

    /// Two runs: without the other one a drift is hardly known, and each is missed by twice the error of the base model. Where the scores count what its numbers leave open, the drift warned of that.
    #[test]
    fn a_larger_error_that_was_foreseen_is_no_mistake() {
        let of = |gain: f64, warns: bool| {
            let fit = |error: f64, warned: f64| {
                let warned = warns.then_some(warned);
                let part = |_| PartError {
                    name: "run".into(),
                    squares: Some(100.0 * error * error),
                    rows: 100,
                    score: Some(100.0 * error),
                    warned,
                };
                HeldOutFit { parts: (0..2).map(part).collect(), ..HeldOutFit::default() }
            };
            Unseen { base: fit(1.0, 500.0), named: Some(fit(2.5, 500.0 - gain)), believed: 0.0, holds: true }
        };
        assert_eq!(of(100.0, false).worse(true), Some(Against::Errors([1.0, 2.5])));
        assert_eq!(of(100.0, true).worse(true), None);
        assert_eq!(of(4.0, true).worse(true), Some(Against::Errors([1.0, 2.5])));
        // where tests see something in what the model leaves, its numbers are less sure than the noise says
        assert_eq!(of(100.0, true).where_it_holds(false).worse(true), Some(Against::Errors([1.0, 2.5])));
        // where the noise was not measured, it has to stand out of one that lasts as well
        assert_eq!(of(100.0, true).against(false, || true), None);
        assert_eq!(of(100.0, true).against(false, || false), Some(Against::Errors([1.0, 2.5])));
    }

    /// The base model follows all rows with numbers that are 40 squares less believable than those beside the effect: no noise moves numbers so far that the recording tells well.
    #[test]
    fn what_hides_in_numbers_that_nobody_believes_stands_out_of_a_slow_noise() {
        let same = || predicted(&[4.0, 4.0]);
        let of = |believed: f64| Unseen { base: same(), named: Some(same()), believed, holds: true };
        assert!(of(40.0).stands_out_of(1.0) && of(40.0).stands_out_of(3.0));
        assert!(!of(40.0).stands_out_of(5.0) && !of(8.0).stands_out_of(0.2));
    }

    /// An error that is 4 % larger without an effect is nothing to a noise that was not measured; one that is 6 % larger is.
    #[test]
    fn a_small_gain_counts_where_the_noise_was_measured() {
        let of = |without: f64| Unseen {
            base: predicted(&[without, without]),
            named: Some(predicted(&[4.0, 4.0])),
            believed: 0.0,
            holds: true,
        };
        let small = of(4.0 * 1.04f64.powi(2));
        assert!(matches!(small.against(false, || false), Some(Against::Little(_))));
        assert_eq!(small.against(true, || false), None);
        assert_eq!(of(4.0 * 1.06f64.powi(2)).against(false, || false), None);
        // larger errors speak first, and against more
        let larger = of(3.0).against(false, || false).unwrap();
        assert!(matches!(larger, Against::Errors(_)) && larger.cost() > small.against(false, || false).unwrap().cost());
        assert!(Against::Score(1.0).cost() > small.against(false, || false).unwrap().cost());
    }

    /// Four runs gain 20 squares each, 80 in all: more than a slow noise of level 1 does (30), less than one of level 3 (90). One run that gains all of it is no law.
    #[test]
    fn what_is_foretold_in_most_parts_stands_out_of_a_slow_noise() {
        let fit = |gains: [f64; 4]| {
            let part = |k: usize| PartError {
                name: "run".into(),
                squares: Some(400.0),
                rows: 100,
                score: Some(100.0 - gains[k]),
                warned: None,
            };
            HeldOutFit { parts: (0..4).map(part).collect(), ..HeldOutFit::default() }
        };
        let of = |gains, level| {
            Unseen { base: fit([0.0; 4]), named: Some(fit(gains)), believed: 0.0, holds: true }.stands_out_of(level)
        };
        assert!(of([20.0; 4], 1.0) && of([20.0; 4], 0.4));
        assert!(!of([20.0; 4], 3.0));
        assert!(!of([80.0, 1.0, 1.0, 1.0], 1.0));
        assert!(!Unseen::nothing(fit([0.0; 4])).stands_out_of(1.0));
    }

    /// Errors of 11 and 10 without an effect and with it: a tenth more is felt, a twentieth is not.
    #[test]
    fn an_error_that_is_a_tenth_smaller_is_felt() {
        let of = |without: f64| {
            let base = predicted(&[400.0 * without.powi(2), 400.0 * without.powi(2)]);
            Unseen { base, named: Some(predicted(&[400.0 * 100.0, 400.0 * 100.0])), believed: 0.0, holds: true }.is_felt()
        };
        assert!(of(11.01) && !of(10.5));
        assert!(!Unseen::nothing(predicted(&[4.0])).is_felt());
    }
}
