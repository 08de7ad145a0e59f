//! Sizes and thresholds of the tests of an answer, with where each comes from.
//!
//! Limits: where a line gives no reason or source of its own, the value was set on the open cases and on generated recordings, never on sealed ones
//! (`docs/history.md`).

// among_rivals.rs

/// Most rivals whose predictions of rows left out are compared: each takes as many fits as there are parts.
pub(crate) const MOST_RIVALS: usize = 5;

// ceiling.rs

/// How many times larger the error at a ceiling is without it, at least: than in other rows, and than with it.
pub(crate) const CEILING_CLEARLY: f64 = 3.0;

/// Share of the rows at a ceiling in which the model goes beyond it, at least: noise carries rows that lie close below it up to it.
pub(crate) const CEILING_MOSTLY: f64 = 0.8;

/// How many times larger the error in other rows may be with a ceiling: it has nothing to do with them.
pub(crate) const CEILING_HARMS: f64 = 1.02;

// confirmation.rs

/// Blocks that a recording of few runs is cut into: enough for a p-value of 2 in 4096.
pub(crate) const CONFIRMATION_BLOCKS: usize = 12;

/// Fewest rows of a block of a recording that confirms.
pub(crate) const SHORTEST_BLOCK: usize = 4;

/// Most blocks whose signs are flipped in every way; of more, [`SIGN_DRAWS`] ways are drawn.
pub(crate) const EXACT_BLOCKS: usize = 14;

/// Ways of flipping signs that are drawn.
pub(crate) const SIGN_DRAWS: usize = 9999;

// cross_validation.rs

/// Most parts that are left out one after another.
pub(crate) const MOST_PARTS: usize = 10;

/// Blocks that a single run is cut into.
pub(crate) const PARTS_OF_ONE_RUN: usize = 6;

/// Standard deviations of the noise's own square that a misfit must have for a share of it to mean something.
pub(crate) const THERE: f64 = 4.0;

/// Share of the change of mean squares in the part that changes most, from which on a part tells two models apart.
pub(crate) const TELLS: f64 = 0.01;

// held_numbers.rs

/// Probability from which a model is fitted again with numbers held: less likely ones are neither told nor weighed any more.
pub(crate) const REFITTED_FROM: f64 = 1e-3;

/// Size of a number that is at nothing at the least, in standard deviations, up to which it is not told from nothing: the two of a test at 5 %.
pub(crate) const TOLD_FROM_NOTHING: f64 = 2.0;

// pipeline/by_name.rs

/// Effects of the library that are tried for each of two mechanisms, those that promise most: nine choices, each of which takes as many fits as there are parts.
pub(crate) const MOST_NAMES: usize = 3;

// pipeline/by_rows_left_out.rs

/// Most effects that are added by what rows left out say: as many as the model space has in one model.
pub(crate) const MOST_ADDED: usize = 3;

/// Effects that are asked for rows left out at each step, those that promise most.
pub(crate) const MOST_ASKED: usize = 6;

/// Times by which rows left out must be predicted better for a further effect, or for another choice of as many: the best of a dozen trials gains a twentieth by chance more often than one does.
pub(crate) const FELT: f64 = 1.1;

// main_causes.rs

/// Share of what a whole model removes on rows left out, in squares, that its causes remove. An equation that is off by a third of a cause leaves a tenth of its squares, and another effect
/// follows that. In answers to 92 real recordings whose names had been written down, 21 effects stood for less than a tenth; 16 of them were not among those names (docs/real-recordings.md).
pub(crate) const MAIN_SHARE: f64 = 0.9;

/// Times the error of a whole model in which tests see nothing that its causes may leave on rows left out without a further part. Of 15 answers to real recordings that carried a part, and 13 to generated
/// ones, nine are of effects of the library alone and leave nothing that tests see: without the parts that are right (five) 3.3 to 6.2 times the error is left, without those that are wrong (a clock, a gain beside a curve) 0.7 to 1.75 times.
/// Below it a part is a cause where tests see something without it and most parts that are left out bear it out.
pub(crate) const FAR_ABOVE: f64 = 2.0;

/// Most parts of a model whose every choice is asked for: 30 choices.
pub(crate) const MOST_PARTS_OF_A_MODEL: usize = 5;

// permutation.rs

/// Permutations of a history; the control is their median.
pub(crate) const PERMUTATIONS: usize = 19;

// pipeline/carried.rs

/// Stated probability from which a name after the first is claimed beside a base model without plates: names below are more often wrong than right. Of 45 such names in answers to 502 real recordings 14 were right, with what may
/// stand in their place.
pub(crate) const CLAIMED_FROM: f64 = 0.5;

/// The same from which a name after the first is claimed where rows left out bear it out, whatever else is left: of names above, three of four are right.
pub(crate) const SURE_FROM: f64 = 0.75;

// pipeline/noise_that_lasts.rs

/// Times the noise of short stretches that what is left may be, root mean square of both whitened, and still be noise that lasts. Noise like 1/f makes 1.0 to 1.3 of it in simulated recordings, and
/// up to 1.7 is left in real ones in which nothing is missing; of two conductivity cells of which one fails 100 times the noise is left.
pub(crate) const NO_LOUDER: f64 = 2.0;

// recovery/case.rs

/// Log probability below which a model of a simulated recording is not kept.
pub(crate) const KEPT_LOG_PROBABILITY: f64 = -14.0;

// recovery/fill.rs

/// Rows on which the bank searches.
pub(crate) const BANK_ROWS: usize = 500;

/// Simulated recordings after which the answers are stored.
pub(crate) const STORE_EVERY: usize = 16;

/// Most effects that get a larger share of the bank.
pub(crate) const LIKELY_EFFECTS: usize = 5;

/// Probability from which an effect may get a larger share of the bank.
pub(crate) const LIKELY_FROM: f64 = 0.005;

// recovery/power.rs

/// Standard deviation of what is known of the logarithm of the power beforehand: few claims change little.
pub(crate) const POWER_LOG_SD: f64 = 0.4;

/// Range of powers looked at, in logarithms, and the steps.
pub(crate) const POWER_RANGE: (f64, f64, usize) = (-1.4, 1.4, 281);

// recovery/truth.rs

/// Range of detectabilities of concealed causes, logarithmically even.
pub(crate) const CONCEALED_DETECTABILITY: (f64, f64) = (4.0, 80.0);

/// Prior standard deviations beyond which no size is drawn.
pub(crate) const BELIEVABLE: f64 = 3.0;

/// Draws of the sensor tried before a recording is given up (its plates touch).
pub(crate) const MOST_DRAWS: usize = 20;

/// Share of the least detectability that a cause must reach where no size gives what was drawn.
pub(crate) const STILL_SEEN: f64 = 0.5;

/// Relative change of a size below which it counts as found.
pub(crate) const SIZE_FOUND: f64 = 0.05;

// veto.rs

/// Share of the reproducible misfit on rows left out below which a model whose rest is rejected as well says nothing of the cause: a level and a slope that are calibrated anew change as much.
pub(crate) const NEXT_TO_NOTHING: f64 = 0.1;

/// Factor on the base model's error that the right physics may reach where its numbers are known less well without a part. Right answers on generated recordings
/// reach 1.95; a wrong one on a real recording reached 2.4.
pub(crate) const EXTRAPOLATED: f64 = 2.0;

/// Times the base model's error on rows left out that is clearly more: an effect that hardly stands out changes the error of a thousand rows by less.
pub(crate) const CLEARLY_WORSE: f64 = 1.05;

/// Squares of the noise by which a part must be predicted better to be foretold: one unit of log likelihood.
pub(crate) const FORETOLD: f64 = 2.0;

/// Squares of the noise that rows left out must gain in all where most parts gain nothing: 5 units of log likelihood, which one effect of some thirty costs beforehand. On 41 real
/// recordings the least that a claimed effect gains is 23; one beside a time offset of weather fronts gains 3.7.
pub(crate) const PROOF: f64 = 10.0;

/// Times the level of what is left of slow noise, in squares, that rows left out must gain where the noise was not measured and the error is hardly smaller: that of three [`PROOF`]s.
pub(crate) const FAR_OUT: f64 = 3.0 * PROOF;

// recovery/confusion.rs

/// Detectability from which single causes are counted, as in the targets of the blind studies.
pub(crate) const SINGLES_FROM: f64 = 10.0;

/// The same of pairs.
pub(crate) const PAIRS_FROM: f64 = 16.0;

// unforetold.rs

/// Times what a model leaves by which a change in it must exceed that, so that a part which holds it is not predicted. With every change so hidden, noise like 1/f was told as a mismatch.
pub(crate) const JUMPS_OUT: f64 = 3.0;
