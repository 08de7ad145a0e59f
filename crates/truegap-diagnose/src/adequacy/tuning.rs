//! Thresholds of the lack-of-fit tests and of interference, with where each comes from.
//!
//! Limits: levels are probabilities under the noise model with everything counted that was tried; they were fixed on generated recordings and the open cases, never on
//! sealed cases (`docs/diagnosis.md`).

/// Probability below which a lack-of-fit test fires: one false alarm in ten thousand recordings whose noise is as taken.
pub(crate) const LACK_OF_FIT_LEVEL: f64 = 1e-4;

/// Relative uncertainty of the noise beyond which the tests are not blunted further.
pub(crate) const MOST_UNCERTAIN: f64 = 0.5;

/// Most stretches whose means are tested together.
pub(crate) const STRETCHES: usize = 240;

/// Probability below which a tone is one: what calibration leaves of a slow mismatch is periodic, too, where the load is.
pub(crate) const TONE_LEVEL: f64 = 1e-8;

/// Difference of frequency, in cycles a row, up to which a line of the lack-of-fit test and a tone are one: a cycle of the shortest run that has lines.
pub(crate) const ALIKE: f64 = 1.0 / 64.0;

/// Fewest rows of a run that is listened to.
pub(crate) const SHORTEST_RUN: usize = 64;

/// Spread of the steps in time, over their median, up to which a run counts as evenly sampled; and of the pace of runs that are added up.
pub(crate) const EVEN: f64 = 0.02;

/// Lowest frequency, in cycles of the longest run.
pub(crate) const LOWEST_CYCLES: usize = 8;

/// Half width of the stretch of spectrum that a line is compared with, and of the gap about the line, in cycles of the longest run.
pub(crate) const AROUND: (usize, usize) = (40, 4);

/// Parts of a run that must hold a steady tone alike, and fewest rows of a part.
pub(crate) const PARTS_OF_A_RUN: usize = 8;
/// See [`PARTS_OF_A_RUN`].
pub(crate) const FEWEST_ROWS_OF_A_PART: usize = 16;

/// Frequencies tried within one cycle of the longest run on each side of a line.
pub(crate) const FREQUENCY_STEPS: usize = 20;

/// Share of a steady tone's squares by which its parts may be apart beside the noise: whitening and lost rows change it a little from part to part. A tone that is there in half of the rows
/// has half of its squares apart.
pub(crate) const STEADY_SHARE: f64 = 0.15;

/// Probability below which a burst is one: noise is rarely quite Gaussian.
pub(crate) const BURST_LEVEL: f64 = 1e-6;

/// Rows over which bursts are looked for.
pub(crate) const BURST_WINDOWS: [usize; 2] = [8, 24];

/// Fits whose lack-of-fit tests are remembered: the best one, asked again and again, beside those that come and go.
pub(crate) const ASKED: usize = 4;
