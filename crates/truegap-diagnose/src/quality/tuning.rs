//! Thresholds for what is wrong with a recording, with where each comes from.
//!
//! Limits: where a line gives no reason or source of its own, the value was set on the open cases and on generated recordings, never on sealed ones
//! (`docs/history.md`).

// clipped.rs

/// Fewest rows at the rail.
pub(crate) const FEWEST_CLIPPED: usize = 8;

/// Share of all rows that must be at the rail.
pub(crate) const SHARE_CLIPPED: f64 = 0.005;

/// Share of its range that a driver must cross while the reading stays at the rail.
pub(crate) const CLIP_CROSSED: f64 = 0.08;

/// Share of neighbouring readings that are equal elsewhere, at most: a coarse reading is often at its extremes.
pub(crate) const CLIP_COARSE: f64 = 0.2;

/// Percentile of the steps from row to row below which one is no jump.
pub(crate) const CLIP_ORDINARY: usize = 99;

/// Rows elsewhere at the same inputs, as a share of those at the rail, up to which the rail is what stops the reading.
pub(crate) const PASSING: f64 = 0.2;

// dead.rs

/// Fewest rows of one value in a dead stretch.
pub(crate) const FEWEST_DEAD: usize = 20;

/// Share of all rows that a dead stretch must have.
pub(crate) const SHARE_DEAD: f64 = 0.02;

/// Share of its range that a driver (or the reading) must cross during a dead stretch.
pub(crate) const DEAD_CROSSED: f64 = 0.3;

/// Share of neighbouring values that are equal outside of a dead stretch, at most.
pub(crate) const DEAD_COARSE: f64 = 0.2;

/// Share of neighbouring curvatures of opposite sign above which a column jitters: 0.73 for white noise, 0 for a smooth course, 0.5 at the corners of one.
pub(crate) const JITTERS: f64 = 0.6;

/// Share of all curvatures that are not zero, at least, in a column that was measured.
pub(crate) const JITTER_BENDS: f64 = 0.5;

/// Share of the reading's range that it must rise, and fall, in a stretch to have been driven there.
pub(crate) const DRIVEN: f64 = 0.15;

/// Share of its change that a reading makes in the first third of a stretch in which it relaxes.
pub(crate) const AT_FIRST: f64 = 0.6;

// outliers.rs

/// Standard deviations beyond its neighbours at which a row is an outlier.
pub(crate) const OUTLIER_FAR: f64 = 12.0;

/// Ranges of its neighbours beyond them at which it is one.
pub(crate) const OUTLIER_BEYOND: f64 = 5.0;

/// Median distances from its median by which a value of an input stands outside its neighbours, at least, to be an outlier: a smaller one costs a row's noise.
pub(crate) const HALVES_BEYOND: f64 = 1.0;

/// Steps of an input that stands still from row to row count, at least so high beside an outlier, so many of them, and so large a share followed by the reading at once, by so many standard
/// deviations: then an outlier that it does not follow is none of them.
pub(crate) const AS_HIGH: f64 = 0.2;
pub(crate) const FEWEST_STEPS: usize = 3;
pub(crate) const FOLLOWED: f64 = 0.7;
pub(crate) const JUMPS: f64 = 5.0;

/// Most rows together that are outliers.
pub(crate) const OUTLIERS_TOGETHER: usize = 3;

/// Share of rows that are outliers beyond which a channel is no longer to be trusted.
pub(crate) const TOO_MANY_OUTLIERS: f64 = 0.02;

/// Outliers that are named one by one.
pub(crate) const OUTLIERS_NAMED: usize = 4;

// preconditions.rs

/// Change that counts as a change of temperature, K.
pub(crate) const WARMS: f64 = 0.3;

/// Rows of one value from which a response may hang.
pub(crate) const LONG_STANDSTILL: usize = 50;

/// Times that such a stretch must count against the changes elsewhere.
pub(crate) const STANDSTILL_SHARE: usize = 10;

/// Share of the full load that counts as a change of load.
pub(crate) const LOAD_CHANGES: f64 = 1e-3;

// range.rs

/// Share of the full scale up to which a load is in range; a load cell's zero and gain are good to some per cent.
pub(crate) const HIGHEST_LOAD: f64 = 1.1;

/// Share of the full scale down to which a load may be negative.
pub(crate) const LOWEST_LOAD: f64 = -0.05;

/// Temperatures in range, degrees Celsius.
pub(crate) const TEMPERATURES_C: (f64, f64) = (-40.0, 125.0);

// repeated.rs

/// Longest stretch of one value that is a repeat.
pub(crate) const LONGEST_REPEAT: usize = 12;

/// Steps of the reading by which rows usually differ, at least.
pub(crate) const FINE_STEPS: f64 = 2.5;

/// Factor on the number of neighbours that differ by one step above which equal ones are no chance.
pub(crate) const MORE_THAN_CHANCE: usize = 3;

/// So many more than that.
pub(crate) const A_FEW_REPEATS: usize = 5;

/// Share of rows above which a reading simply does not change.
pub(crate) const MOST_REPEATED: f64 = 0.3;

// rows.rs

/// Kelvins that a temperature has to move to drive a reading: rooms and thermometers wander by less.
pub(crate) const DRIVES: f64 = 1.0;

// wrong_sensor.rs

/// Share of the foreseen reading that the recorded one may be off, beside [`FAR_FROM_PRIOR`] standard deviations of what tolerances allow.
pub(crate) const OFF_BY: f64 = 0.05;

/// Standard deviations of what tolerances allow.
pub(crate) const FAR_FROM_PRIOR: f64 = 6.0;

/// Factor between recorded and foreseen range.
pub(crate) const LEVEL_RANGE: f64 = 4.0;

/// Factor between both ranges within which the readings move as foreseen.
pub(crate) const ALIKE: f64 = 1.3;

/// Rows that are compared with the sensor's model.
pub(crate) const LEVEL_SAMPLE: usize = 2000;

/// Share of the full scale that the load must cross for ranges to be compared.
pub(crate) const LOADED: f64 = 0.3;

/// Correlation with the foreseen readings from which they move together.
pub(crate) const MOVES_WITH: f64 = 0.9;

/// Prior standard deviations within which a number of the base model itself may make such a difference.
pub(crate) const REACHED_BY: f64 = 3.0;

/// Relative distance from a power of a thousand within which a unit was mistaken.
pub(crate) const POWER_OF_A_THOUSAND: f64 = 0.3;
