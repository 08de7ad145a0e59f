//! Numbers of fits and of their evidence, with where each comes from.
//!
//! Limits: where a line gives no reason or source of its own, the value was set on the open cases and on generated recordings, never on sealed ones
//! (`docs/history.md`).

// importance.rs

/// Degrees of freedom of the proposal: tails heavier than the posterior's.
pub(crate) const PROPOSAL_FREEDOM: f64 = 6.0;

/// Curvature, in units of the prior's, above which a direction is stiff.
pub(crate) const STIFF: f64 = 100.0;

/// Most steps in which the stiff directions are fitted, and the promise below which they are.
pub(crate) const STIFF_STEPS: (usize, f64) = (4, 0.1);

/// Part of the draws after which it is asked whether they are enough: one in so many.
pub(crate) const FIRST_DRAWS: usize = 4;

// few_jumps.rs

/// Most runs of which it is asked whether they alone jump.
pub(crate) const FEW_JUMPS: usize = 3;

// laplace.rs

/// Scales, in prior standard deviations, over which what is known of a size beforehand is spread.
pub(crate) const SIZE_SCALES: [f64; 5] = [4.0, 1.0, 0.25, 1.0 / 16.0, 1.0 / 64.0];

/// Standard deviations beyond which a tail is taken by its asymptotic series.
pub(crate) const FAR_FROM_BOUND: f64 = 20.0;

// levenberg_marquardt.rs

/// How far the first nonmonotone step goes, in prior standard deviations; after one that succeeds further, after one that fails less far.
pub(crate) const REACH: f64 = 3.0;

/// Nonmonotone steps that may fail in a row.
pub(crate) const FAILED_STEPS: usize = 3;

/// Steps back down after a nonmonotone step.
pub(crate) const STEPS_BACK: usize = 3;

/// Curvature added in every direction on the way back down: much for sloppy directions, nothing for stiff ones.
pub(crate) const PINNED: f64 = 100.0;

/// Most corrections of a step with one Jacobian.
pub(crate) const CHORDS: usize = 5;

// model.rs

/// Step of the difference quotients, in prior standard deviations.
pub(crate) const DIFFERENCE_STEP: f64 = 1e-3;

// optimum.rs

/// Promise, in units of the objective, below which a fit counts as converged.
pub(crate) const REACHED: f64 = 1.0;

// prior.rs

/// Probability that what is known of one number is grossly wrong.
pub(crate) const WRONG_PRIOR: f64 = 0.02;

/// Factor on the standard deviation of a number whose prior is grossly wrong.
pub(crate) const WIDER_PRIOR: f64 = 10.0;

// several_starts.rs

/// Factor on the noise of a loose fit, which stays near what is known beforehand.
pub(crate) const LOOSE: f64 = 30.0;

/// Difference of two objectives below which they are of one optimum.
pub(crate) const SAME_OPTIMUM: f64 = 0.5;

/// Sloppiest directions along which starts are laid, and their distance in posterior standard deviations.
pub(crate) const START_DIRECTIONS: (usize, f64) = (3, 4.0);

// ways.rs

/// Prior standard deviations, in every coordinate, within which two searches are at one place: a hundredth of what the next step along a sloppy direction is, and along a stiff one the next
/// step finds the floor from either.
pub(crate) const SAME_PLACE: f64 = 0.01;
