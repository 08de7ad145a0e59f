//! The two models of a sensor, as a correction asks them.
//!
//! Limits: what else they follow is held inside of them.

/// A model of readings, one a row, from the input that is to be estimated; everything else that it follows is known and held inside.
pub type Reading<'a, E> = dyn Fn(&[f64]) -> Result<Vec<f64>, E> + 'a;

/// The two models of one sensor, at the same calibration.
pub struct Models<'a, E> {
    /// without the added physics; a row's reading follows from the input of that row
    pub base: &'a Reading<'a, E>,
    /// with it
    pub augmented: &'a Reading<'a, E>,
}
