//! Thresholds of what is told about a mismatch, with where each comes from.
//!
//! Limits: where a line gives no reason or source of its own, the value was set on the open cases and on generated recordings, never on sealed ones
//! (`docs/history.md`).

// conflicts.rs

/// Prior standard deviations beyond which a parameter contradicts what is known of it.
pub(crate) const AGAINST_PRIOR: f64 = 3.5;

/// The same for the difference between two regimes, of which several are tried.
pub(crate) const BETWEEN_REGIMES: f64 = 5.0;

/// Prior standard deviations from the centre up to which one straight step is a number to be told.
pub(crate) const TOLD_AS_FAR: f64 = 8.0;

/// Most recordings that are each set against the others.
pub(crate) const MOST_RECORDINGS: usize = 8;

/// Fewest rows on either side of two regimes that are compared.
pub(crate) const FEWEST_IN_A_REGIME: usize = 30;

// hidden_input/course.rs

/// Standard deviations of the walk of a hidden input that are tried, as shares of the response's range (zero) or of the gain.
pub(crate) const COURSE_SCALES: [f64; 9] = [1e-3, 3e-3, 1e-2, 3e-2, 0.1, 0.3, 1.0, 3.0, 10.0];

/// Steps towards the optimum of a hidden input, the model linearised again at each.
pub(crate) const COURSE_STEPS: usize = 4;

// hidden_input/knots.rs

/// Knots of a hidden input over a whole recording, about.
pub(crate) const MOST_KNOTS: f64 = 60.0;

/// Rows that a knot must have on average.
pub(crate) const ROWS_PER_KNOT: usize = 8;

// hidden_input/opened.rs

/// Stretches that are left out in turn to see how well a line is determined, about.
pub(crate) const JACKKNIFE_STRETCHES: usize = 20;

// hidden_input/slow_input.rs

/// Tempered log evidence from which the course of a hidden input is called missing.
pub(crate) const CONVINCING: f64 = 3.0;

/// Correlation from which a recovered course is said to follow the hidden column closely.
pub(crate) const FOLLOWS_CLOSELY: f64 = 0.9;

/// The same to follow it in part.
pub(crate) const FOLLOWS_IN_PART: f64 = 0.6;

/// Share of the range of a hidden column that it must cross in a run for a correlation there.
pub(crate) const MOVES_IN_A_RUN: f64 = 0.1;

/// Share of how far a course moves below which its error counts as known.
pub(crate) const DETERMINED: f64 = 0.5;

// locate.rs

/// Probability below which a direction is reported: the joint test has already found a mismatch, this only says where it lies.
pub(crate) const PLACE_LEVEL: f64 = 1e-3;

/// Standard deviations by which what a run leaves must be more than noise for the run to be named.
pub(crate) const LOUD_RUN: f64 = 4.0;

// next_experiment.rs

/// Standard deviations that an instrument change is taken to put between two effects: it tells one from the other for certain.
pub(crate) const CERTAIN: f64 = 20.0;

/// Hours that an instrument change is taken to need.
pub(crate) const REBUILD_H: f64 = 1.0;
