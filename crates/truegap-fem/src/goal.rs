//! What is asked of a problem and what is answered, the same for every physics.
//!
//! Limits: one number an answer; which goals there are, each physics says.

/// A named goal.
#[derive(Debug, Clone, PartialEq)]
pub struct Quantity<G> {
    /// Name in the results.
    pub name: String,
    /// What it is.
    pub goal: G,
}

/// A value with its unit and how far off it may be.
#[derive(Debug, Clone, PartialEq)]
pub struct Answer {
    /// Name; entries of a matrix carry `[row,column]`.
    pub name: String,
    /// Value in `unit`.
    pub value: f64,
    /// SI unit.
    pub unit: &'static str,
    /// Estimated magnitude of the error, in `unit`.
    pub error_estimate: f64,
    /// What the error is compared with: the magnitude of the value, or of its kind where the value may vanish.
    pub scale: f64,
}

impl Answer {
    /// Estimated error over the scale; 0 where there is no error, whatever the scale.
    pub fn relative_error_estimate(&self) -> f64 {
        if self.error_estimate == 0.0 { 0.0 } else { self.error_estimate / self.scale }
    }
}

/// An answer and what every triangle contributes to its error.
pub(crate) struct Judged {
    pub answer: Answer,
    pub shares: Vec<f64>,
}
