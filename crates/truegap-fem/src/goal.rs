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
    /// What a target is relative to: the magnitude of the value, or of its kind where the value may vanish (of a stress, the greatest component there).
    pub scale: f64,
}

impl Answer {
    /// Estimated error over the magnitude of the value, as a reader divides; 0 where there is no error, infinite where the value is 0 and there is one.
    pub fn relative_error_estimate(&self) -> f64 {
        self.over(self.value.abs())
    }

    /// Estimated error over the scale, which a target is compared with; 0 where there is no error, whatever the scale.
    pub fn error_over_scale(&self) -> f64 {
        self.over(self.scale)
    }

    fn over(&self, size: f64) -> f64 {
        if self.error_estimate == 0.0 { 0.0 } else { self.error_estimate / size }
    }
}

/// An answer and what every triangle contributes to its error.
pub(crate) struct Judged {
    pub answer: Answer,
    pub shares: Vec<f64>,
}

#[cfg(test)]
mod tests {
    use super::*;

    /// A hoop stress of 17.4 MPa beside an axial one of 105 MPa, off by 1789 Pa.
    #[test]
    fn an_error_is_relative_to_the_value_that_is_printed_and_a_target_to_its_kind() {
        let answer = Answer { name: "hoop".into(), value: -1.74e7, unit: "Pa", error_estimate: 1789.0, scale: 1.05e8 };
        assert!((answer.relative_error_estimate() - 1789.0 / 1.74e7).abs() < 1e-18);
        assert!((answer.error_over_scale() - 1789.0 / 1.05e8).abs() < 1e-18);
        let nothing = Answer { value: 0.0, error_estimate: 0.0, ..answer.clone() };
        assert_eq!(nothing.relative_error_estimate(), 0.0);
        assert_eq!(Answer { value: 0.0, ..answer }.relative_error_estimate(), f64::INFINITY);
    }
}
