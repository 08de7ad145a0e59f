//! Thresholds of what is told, with where each comes from.
//!
//! Limits: none of them decides a verdict; they say what is worth a reader's time.

/// Detectability at which an effect would have been seen: twice the 3 below which none is claimed.
pub(crate) const SEEN: f64 = 6.0;

/// Probability from which an unmodelled cause is told; those below one per cent are counted, not listed.
pub(crate) const NOT_NEGLIGIBLE: f64 = 0.01;

/// Share of the raw effect in the base parameters from which calibration is said to have concealed it.
pub(crate) const MOSTLY_ABSORBED: f64 = 0.9;

/// Noise floors below which the error in sample looks like noise.
pub(crate) const LIKE_NOISE: f64 = 2.0;

/// Detectability from which a finding is stated plainly; below it is "most consistent with". The targets of the blind studies start at 10.
pub(crate) const PLAINLY_SEEN: f64 = 10.0;

/// Log evidence from which an unmodelled cause is worth mentioning where nothing is named: odds of 20 000 before its prior.
pub(crate) const NEARLY: f64 = 10.0;

/// Probability below which a line in the spectrum is worth mentioning: far below the level of the test, because it is one clause of a sentence on something else.
pub(crate) const CLEAR_LINE: f64 = 1e-6;

/// Rivals of the likeliest model that the next experiment is to tell it from.
pub(crate) const MOST_RIVALS: usize = 3;

/// Share of a model's probability up to which another one is excluded: the odds at which a verdict has no rival.
pub(crate) const NOT_EXCLUDED: f64 = 0.05;

/// Detectability below which nothing of an effect stands out of the noise: less than one standard deviation.
pub(crate) const NOTHING: f64 = 1.0;

/// Probability from which a detectability below [`NOTHING`] contradicts it: what a named effect must have.
pub(crate) const SURE: f64 = 0.9;

/// Log odds that a name is right that its answer has alone and that stands at even odds among the models, beside a base model without plates: recordings by other people whose right names were written
/// down before the first run (`validation/stated`).
pub(crate) const LEVEL: f64 = 0.696;

/// How much they rise with the log odds among the models.
pub(crate) const SLOPE: f64 = 0.147;

/// What one of several names has more: less, for an equation that is slightly off leaves a rest that other names follow.
pub(crate) const BESIDE_OTHERS: f64 = -0.619;

/// What a name after the first has more than the first.
pub(crate) const LATER: f64 = -0.569;

/// What a name that is only carried has more than one that is claimed after the first.
pub(crate) const CARRIED: f64 = -1.068;

/// Log odds beyond which a name does not count as surer: 0.99 and 0.01. Beyond them names are right no more often.
pub(crate) const LARGEST_LOG_ODDS: f64 = 4.6;

/// Stated probability below which a name is told with "perhaps": it is more often wrong than right.
pub(crate) const DOUBTFUL: f64 = 0.5;
