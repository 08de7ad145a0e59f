//! Thresholds of the noise estimates, with where each comes from.
//!
//! Limits: where a line gives no reason or source of its own, the value was set on the open cases and on generated recordings, never on sealed ones
//! (`docs/history.md`).

// block_average.rs

/// Shares of the range that load and temperature may move within a group, tried in turn until few groups are left.
pub(crate) const GROUP_MOVES: [f64; 6] = [0.0, 0.002, 0.005, 0.01, 0.02, 0.04];

/// Times the target number of groups above which the next share is tried.
pub(crate) const TOO_MANY_GROUPS: usize = 3;

/// Share of its range within which a driver counts as still: its noise is not known.
pub(crate) const DRIVER_STILL: f64 = 2e-3;

// crossings.rs

/// Times as long as its neighbours, from which on a stretch between two crossings is a hold.
pub(crate) const HOLD: f64 = 4.0;

// denoise.rs

/// Longest stretch of a straight line on either side of a row.
pub(crate) const LONGEST_LINE: usize = 32;

/// Standard deviations by which a row may leave its line.
pub(crate) const OFF_THE_LINE: f64 = 3.5;

/// Rows over which `crookedness` looks on either side; twice as many on one.
pub(crate) const SHORT_LINE: usize = 3;

// denoised_inputs.rs

/// Steps of a thermometer, K, that nobody commands.
pub(crate) const FINE_K: f64 = 1.0;

/// Scatter about short lines, over that of noise, from which on a column is no course of straight lines.
pub(crate) const CROOKED: f64 = 0.85;

// follows_drivers.rs

/// Half widths of plays that tell which way a driver goes, as shares of its range.
pub(crate) const DRIVER_WIDTHS: [f64; 4] = [0.003, 0.01, 0.03, 0.1];

// input.rs

/// Share of the estimate from second differences below which another is believed; noise alone stays above it.
pub(crate) const CLEARLY_SMALLER: f64 = 0.8;

/// What `crookedness` makes of white noise of variance 1.
pub(crate) const STRAIGHT: f64 = 0.55;

/// Least share of the upper limit that is believed to be noise.
pub(crate) const LEAST_LEFT: f64 = 0.3;

/// Rows of a short stretch over which scatter is taken.
pub(crate) const SCATTER_STRETCH: usize = 12;

/// Share of the median of all below which the quieter stretches are believed; noise alone gives about 0.8.
pub(crate) const MOSTLY_CURVED: f64 = 0.5;

/// Rows of a run from which the scatter about short lines is believed.
pub(crate) const LONG_RUN: usize = 100;

// learned_again.rs

/// Share of what a noise was taken for, above which one that is learned again changes nothing that a reader could tell: how well a noise that nobody measured is known (`UNSEEN`) is more.
pub(crate) const STILL_AS_LOUD: f64 = 0.85;

/// Factors on slow noise that was weighed beside a misfit: the steps of its grid of sizes (`SLOW_SHARES`), and none.
pub(crate) const LESS_SLOW: [f64; 6] = [0.56, 0.32, 0.18, 0.1, 0.03, 0.0];

/// Log likelihood by which a quieter noise has to be likelier: half of the deviance that factors of their own need (`CLEARLY_TOO_LOUD`).
pub(crate) const CLEARLY_QUIETER: f64 = 10.0;

// louder.rs

/// Rows on either side that a row is compared with.
pub(crate) const BESIDE: usize = 4;

/// Scatters beyond which rows are counted: noise of 10 000 rows has none.
pub(crate) const FAR_OFF: f64 = 4.5;

/// Scatters from its neighbours on both sides beyond which a single row is wild: Gaussian noise of a million rows has none beyond 6, and the scatter is known to a tenth or so.
pub(crate) const WILD: f64 = 8.0;

/// Share of the variance that a wild row is to have, from which on it is known to be one.
pub(crate) const KNOWN_TO_BE_WILD: f64 = 0.25;

/// Fewest rows that are far off, for noise with heavy tails.
pub(crate) const FEWEST_FAR_OFF: usize = 3;

/// Least share of the rows that are far off, for the same.
pub(crate) const SHARE_FAR_OFF: f64 = 0.001;

/// Scatters beyond which a row weighs less.
pub(crate) const WEIGHS_LESS: f64 = 2.5;

/// Degrees of freedom of the t distribution whose weights are taken.
pub(crate) const TAIL_FREEDOM: f64 = 3.0;

// grows.rs

/// Groups of rows, by their reading or its speed, among which scatter is compared.
pub(crate) const READING_GROUPS: usize = 6;

/// Ratio of scatters of the loudest and the quietest group from which on noise grows: five standard deviations of 3000 rows.
pub(crate) const NOISE_GROWS: f64 = 1.6;

/// Fewest rows of a group in which scatter is taken.
pub(crate) const ROWS_OF_A_GROUP: usize = 60;

/// Squared correlation of scatter and reading over the groups from which noise grows along the reading.
pub(crate) const GROWS_EVENLY: f64 = 0.8;

/// Ratio of the scatter of a group and of the law along the speed from which on it is none: a group of 60 rows has its scatter to 10 %, and laws of two parts bend.
pub(crate) const EVEN_SPEEDS: f64 = 1.6;

// neighbours.rs

/// Rows for each column that is taken out of neighbours: half of them are left to be noise.
pub(crate) const NEIGHBOURS_OF_EACH: usize = 4;

/// Rows from which on a run is compared with itself alone.
pub(crate) const OWN_NEIGHBOURS: usize = 32;

/// Rows from one at neighbouring inputs to the next, in half of them, from which on they lie apart in the file.
pub(crate) const ROWS_APART: f64 = 3.0;

/// Fewest rows from which noise is taken in this way.
pub(crate) const FEWEST_NEIGHBOURS: usize = 16;

// reml.rs

/// Fewest stretches among which one can be told to stand out.
pub(crate) const FEWEST_BLOCKS: usize = 5;

/// Factor on the median variance above which a stretch is left out: 4 standard deviations for the shortest stretch.
pub(crate) const OUTLYING_BLOCK: f64 = 1.9;

/// Log likelihood that two more parameters must gain (BIC at a few hundred rows is about 6; AIC is 2).
pub(crate) const WORTH_A_PARAMETER: f64 = 3.0;

// rescale.rs

/// Share of its variance below which what is left over shows that a noise is not as loud as taken: three standard deviations in 200 rows.
pub(crate) const TOO_LOUD: f64 = 0.7;

/// Factors on the standard deviation of a noise that was too loud.
pub(crate) const LOWER_NOISE: [f64; 8] = [1.0, 0.84, 0.7, 0.59, 0.5, 0.35, 0.25, 0.12];

/// Least factor on what comes from the inputs: how noisy a wandering load is, its own differences say that well.
pub(crate) const LEAST_OF_INPUTS: f64 = 0.35;

/// Deviance by which factors of their own must be better than one for both.
pub(crate) const CLEARLY_TOO_LOUD: f64 = 20.0;

// response.rs

/// Fewest rows at rest that a noise model may rest on.
pub(crate) const ENOUGH_ROWS: usize = 120;

/// Most rows at rest that are used; more would not change the figures.
pub(crate) const PLENTY_OF_ROWS: usize = 6000;

/// Least relative uncertainty of a noise that was not measured at rest.
pub(crate) const UNSEEN: f64 = 0.25;

/// Fewest rows measured again at the same inputs that noise is taken from.
pub(crate) const FEWEST_REPLICATES: usize = 12;

// rest.rs

/// Fewest rows of a stretch at rest.
pub(crate) const SHORTEST_REST: usize = 40;

/// Rows of a short stretch, where there is no rest.
pub(crate) const SHORT_STRETCH: usize = 24;

/// Share of its range within which a driver counts as at rest: its noise is not known.
pub(crate) const DRIVER_RESTS: f64 = 0.01;

/// Relative change of the pace within which rows at rest belong together.
pub(crate) const EVEN_PACE: f64 = 0.3;

/// Fewest rows of a short stretch.
pub(crate) const FEWEST_OF_A_STRETCH: usize = 8;

// changing_level.rs

/// Rows to either side from which the level of a row is told, tried in turn.
pub(crate) const LEVEL_ROWS: [usize; 4] = [12, 25, 50, 100];

/// Rows that the level of all rows counts for beside those.
pub(crate) const LEAST_LEVEL: f64 = 4.0;

/// Times the median level from which on something failed and nothing is merely loud: waves in a storm reach three, and a cell that fails by 50 times its noise is told with eight, since few rows tell a level.
pub(crate) const FAILS: f64 = 6.0;

// clock.rs

/// Fewest stamps of a stretch that a pace is taken from.
pub(crate) const FEWEST_STAMPS: usize = 8;

/// Distance of stamps from an even pace, in ticks, that rounding makes: half a tick, and what the line misses.
pub(crate) const EVEN_STAMPS: f64 = 0.6;

/// Tick of a clock, in steps of its rows, above which a longer step may be a row that was lost.
pub(crate) const COARSEST_TICK: f64 = 0.5;

// rounding.rs

/// Share of neighbouring rows with one value below which the noise of a column dithers its steps away.
pub(crate) const COARSE: f64 = 0.3;

/// Distinct values from which on a grid is one.
pub(crate) const FEWEST_LEVELS: usize = 8;

/// Times that a column goes by one step and back, from which on it stands on a grid of that step however few its values.
pub(crate) const FEWEST_FLICKERS: usize = 8;

/// Distance of spacings from whole steps, in steps.
pub(crate) const OFF_GRID: f64 = 0.12;

/// Share of the reading's change that falls on the rows at which a column changes, above which the change was real.
pub(crate) const REAL_CHANGE: f64 = 0.6;

/// Mean over root mean square of the changes of a column, above which all are alike.
pub(crate) const ALL_ALIKE: f64 = 0.7;

/// Share of moving rows on exact lines above which a column was commanded.
pub(crate) const COMMANDED: f64 = 0.85;

/// Memories of the error of a rounded column in which a plateau passes, in a hold.
pub(crate) const MEMORIES_IN_A_HOLD: f64 = 0.05;

/// The same on a slow course.
pub(crate) const MEMORIES_ON_A_COURSE: f64 = 4.0;

/// Difference of two holds, in steps, below which they stand on one level.
pub(crate) const ONE_LEVEL: f64 = 0.25;

/// Most levels whose errors are kept apart, the longest first.
pub(crate) const MOST_LEVELS: usize = 24;

/// Times as long as its neighbours, from which on a plateau is a hold.
pub(crate) const LONGER_PLATEAU: usize = 4;

// slow.rs

/// Log likelihood by which slow noise must be likelier.
pub(crate) const CLEARLY_COLOURED: f64 = 1.0;

/// Log likelihood at rest by which slow noise may be less likely than noise with one memory, and is still a rival to be weighed: three standard deviations.
pub(crate) const STILL_ALLOWED: f64 = 4.5;

/// Memories that a stretch at rest has to hold for one of that length to be told: a few go with the slow course that is taken out.
pub(crate) const MEMORIES_OF_A_STRETCH: f64 = 10.0;

/// Variances of a part of slow noise that are tried, over that of the white part.
pub(crate) const SLOW_SHARES: [f64; 7] = [0.003, 0.01, 0.03, 0.1, 0.3, 1.0, 3.0];

// slow_parts.rs

/// Memory of the shortest part of slow noise, rows.
pub(crate) const SHORTEST_MEMORY: f64 = 1.5;

/// Memory of the next part over that of the one before.
pub(crate) const LONGER_MEMORY: f64 = 8.0;

/// Parts of slow noise at least, up to a memory of 768 rows.
pub(crate) const FEWEST_MEMORIES: usize = 4;

// switching.rs

/// Spread of a column that is noise and nothing else, in its standard deviations.
pub(crate) const ONLY_NOISE: f64 = 10.0;

/// Rows by which a reading may come after what it follows.
pub(crate) const LATEST_ROW: usize = 8;

/// Standard deviations beyond which a correlation of changes is none of chance, many rows and several delays tried.
pub(crate) const BY_CHANCE: f64 = 8.0;

// off_at_rest.rs

/// Part of what was read within which all rest has one reading, as that of an instrument that is off.
pub(crate) const ONE_READING: f64 = 0.05;

/// Times the noise of such rest from which on a scatter within a few rows at work is another one: the same limit as for a rest that is loud (`LOUD_REST`).
pub(crate) const LOUDER_AT_WORK: f64 = 10.0;

// several.rs

/// Prior standard deviations from which on the error of the inputs is carried through the calibrated numbers instead of the foreseen ones.
pub(crate) const CARRIED_ANEW: f64 = 4.0;

// tones.rs

/// Cycles of a run from which on a line is a tone.
pub(crate) const FEWEST_CYCLES: usize = 6;

/// Lines on each side of one that it is compared with.
pub(crate) const BESIDE_A_LINE: usize = 12;

/// Power over the mean of the lines beside it from which on a line stands out: noise passes it in one line of 3 million (`exp(-15)`).
pub(crate) const LINE_STANDS_OUT: f64 = 15.0;

/// Most tones that are taken out of a run.
pub(crate) const MOST_TONES: usize = 3;
