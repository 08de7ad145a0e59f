//! Thresholds of the search, of the weights of models and of the verdict, with where each comes from.
//!
//! Limits: where a line gives no reason or source of its own, the value was set on the open cases and on generated recordings, never on sealed ones
//! (`docs/history.md`).

// candidates.rs

/// Candidates that are fitted from near the prior as well, where calibration has driven the parameters far.
pub(crate) const LOOSE_FITS: usize = 8;

/// Promised gain in log likelihood below which an effect is fitted roughly: it cannot win.
pub(crate) const HOPELESS: f64 = 1.5;

/// Prior standard deviations beyond which a parameter counts as driven far.
pub(crate) const DRIVEN_FAR: f64 = 4.0;

/// Most starts from which an effect is fitted.
pub(crate) const STARTS: usize = 2;

/// Share of the best start's promise from which another is followed.
pub(crate) const PROMISING_START: f64 = 0.6;

/// Share of what the base model leaves that a size far from nothing must gain for a search to start there.
pub(crate) const FAR_SHARE: f64 = 0.5;

/// How many times what may be left a straight step from there may promise to leave: it is curved, but sizes that are of no use leave a hundred times as much.
pub(crate) const FAR_PROMISE: f64 = 4.0;

// examine.rs

/// Detectability below which an effect is not claimed: three standard deviations. From 4.5 to 8 was tried and no better on all counts (`docs/history.md`).
pub(crate) const VISIBLE: f64 = 3.0;

/// The same as a share of the whole misfit: the right physics in the wrong equation leaves as much behind, and another effect can pick that up. From 0.1 to 0.3 was
/// tried and no better (`docs/history.md`).
pub(crate) const VISIBLE_SHARE: f64 = 0.1;

// model_space.rs

/// Partners that are fitted at each step, those that promise most.
pub(crate) const PARTNERS: usize = 6;

/// Models of one size from which larger ones are tried.
pub(crate) const ABREAST: usize = 3;

/// Gain in log evidence from which a larger model is worth looking for still larger ones.
pub(crate) const CLEAR_GAIN: f64 = 3.0;

/// Difference in log weight beyond which a model is not looked at more closely.
pub(crate) const CLOSE: f64 = 12.0;

/// Models whose evidence is sampled, those with the most weight, and the draws for each.
pub(crate) const SAMPLED: (usize, usize) = (8, 128);

/// Standard error of a log weight from which on more draws change nothing: a probability is known to a twentieth of itself.
pub(crate) const ENOUGH_KNOWN: f64 = 0.05;

/// Difference in log weight within which a model may be named beside the best one, odds of a twentieth (`RIVAL`).
pub(crate) const MAY_BE_NAMED: f64 = 3.0;

/// Effective share of draws from which a sampled evidence stands in for Laplace's.
pub(crate) const ENOUGH_DRAWS: f64 = 0.1;

/// Likely models whose parts are fitted again.
pub(crate) const REFITTED_MODELS: usize = 3;

/// Gain in log evidence of such a part from which all is weighed anew.
pub(crate) const BETTER_PART: f64 = 0.5;

// posterior.rs

/// Probability below which a model is not looked at more closely.
pub(crate) const NEGLIGIBLE: f64 = 1e-4;

/// Log odds that are large enough to stand for certainty.
pub(crate) const LARGEST_GAIN: f64 = 500.0;

// prior.rs

/// Prior probabilities of 0, 1, 2 and 3 effects, shared evenly within each number.
pub(crate) const NUMBER_PRIOR: [f64; 4] = [0.5, 0.35, 0.12, 0.03];

// tempering.rs

/// Relative error that even the right physics has when written with the wrong equation (sibling forms; see `docs/diagnosis.md`). 14 % instead of 20 made 7 answers
/// wrong where 5 had been (`docs/history.md`).
pub(crate) const FORM_ERROR: f64 = 0.2;

/// Number of independent shapes over which that error spreads.
pub(crate) const FORM_SHAPES: f64 = 10.0;

/// Part of an error of form that shows in what a model leaves, the rest absorbed by its parameters: one in so many, in units of the noise variance. Four instead of
/// ten changed one answer of 120 (`docs/history.md`).
pub(crate) const ABSORBED_PART: f64 = 10.0;

/// Share of the misfit from which on it counts as foreseen.
pub(crate) const MOSTLY_FORESEEN: f64 = 0.9;

/// Share of the misfit that the right family removes even with the wrong equation.
pub(crate) const RIGHT_FAMILY: f64 = 0.7;

/// Share of the misfit on rows left out that another choice removes at least, where it takes the place of names: what is left of an instrument is always more than its noise.
pub(crate) const HALF: f64 = 0.5;

// unmodelled.rs

/// Prior probability that something outside the library acts, over that of something inside, shared evenly by the causes.
pub(crate) const UNMODELLED_PRIOR: f64 = 0.1;

/// Rows at which a wandering course may turn, and at which a jump may lie.
pub(crate) const WANDER_KNOTS: usize = 64;

/// Most starts of runs among these rows: each takes a row of an eigenproblem beside every model, and two thousand of them would take minutes.
pub(crate) const RUN_KNOTS: usize = 200;

/// Sizes over which the evidence of a cause is averaged: lengths that its columns may have, in units of the noise.
pub(crate) const LENGTHS: [f64; 6] = [3.0, 8.0, 20.0, 50.0, 130.0, 350.0];

/// Log weight below the best model's down to which models are set beside an unmodelled cause.
pub(crate) const NEAR_THE_BEST: f64 = 20.0;

/// Most models that are set beside an unmodelled cause.
pub(crate) const MOST_BESIDE: usize = 12;

/// Share of the largest variance below which calibration is taken to absorb a direction.
pub(crate) const ABSORBED_COLUMN: f64 = 1e-7;

/// Speeds at which a law of the speed is free, each half of the one before, from the greatest down.
pub(crate) const OCTAVES: usize = 8;

// wanders.rs of the pipeline

/// How far a walk goes over a recording, in noise of a row: a factor of 1.8 apart, which is within a fifth of a unit of log likelihood of the best.
pub(crate) const WALKS: [f64; 12] = [0.3, 0.56, 1.0, 1.8, 3.2, 5.6, 10.0, 18.0, 32.0, 56.0, 100.0, 320.0];

// lasting_noise.rs of the pipeline

/// Memory of the shortest wander that is weighed, in rows.
pub(crate) const SHORTEST_WANDER: f64 = 3.0;

/// Memory of the next one over that of the one before.
pub(crate) const MEMORY_DOUBLES: f64 = 2.0;

/// Memories that a run is long, from which on a wander comes back often: a sample of ten tells a variance to a half.
pub(crate) const OFTEN: f64 = 10.0;

// verdict.rs

/// Probability of "nothing is missing" below which a mismatch is called present.
pub(crate) const DETECTED: f64 = 0.05;

/// Probability of "nothing is missing" above which recording and model agree. Of 480 generated recordings 28 have one of 0.05 to 0.6, and something is missing in 27 of them; 207 have more, and
/// nothing is missing in 163 of these.
pub(crate) const AGREED: f64 = 0.6;

/// Probability that a named effect must have to be stated without rivals.
pub(crate) const SURE: f64 = 0.9;

/// Odds against the best model within which a rival is not excluded.
pub(crate) const RIVAL: f64 = 0.05;

/// Share of the misfit that an adequate equation removes: what is left has a tenth of its size, half of what a right equation in another form may leave
/// (`FORM_ERROR`). Instruments and equations are rarely better, and the tests of lack of fit see a thousandth of a large misfit; the rest is described beside the answer.
pub(crate) const ADEQUATE: f64 = 0.99;

/// Probability from which on an effect is told beside others that have rivals.
pub(crate) const LIKELIER_THAN_NOT: f64 = 0.5;

/// Root mean square of what is left, over the noise, from which on an equation is not adequate whatever it removes: 20 dB. Of the real recordings that are explained none
/// leaves more than five times its noise; a magnetic loop whose curve alone was found leaves ninety times.
pub(crate) const LOUD_REST: f64 = 10.0;

// weak_effects.rs

/// Probability that an effect which a model does not hold acts all the same, too weakly to be named: of some thirty, one or two do.
pub(crate) const WEAK: f64 = 0.05;

/// Noise deviations by which such an effect stands out of what calibration leaves of it, where it acts: any of these, from what nobody can see to what is plain.
pub(crate) const VISIBLE_BY: [f64; 9] = [0.5, 1.0, 2.0, 4.0, 8.0, 16.0, 32.0, 64.0, 128.0];
