//! What makes a design study impossible.
//!
//! Limits: the first problem found.

use crate::{metric::Metric, quantity::Quantity};

/// Why a study has no answer.
#[derive(Clone, Debug, PartialEq, thiserror::Error)]
#[non_exhaustive]
#[allow(missing_docs)] // the fields are named by the messages
pub enum DesignError {
    /// The plates touch.
    #[error(
        "`{sensor}` at {temperature_c} degC: {force_n:.3} N brings the plates together (strain {strain:.3}); lower the full-scale load, or give a thicker or stiffer dielectric"
    )]
    Touches { sensor: String, temperature_c: f64, force_n: f64, strain: f64 },
    /// The chain has no answer.
    #[error(
        "`{sensor}` at {temperature_c} degC and {force_n:.3} N has no answer: the silicone's modulus or the span is not positive; lower the temperature or the softening"
    )]
    NoAnswer { sensor: String, temperature_c: f64, force_n: f64 },
    /// Nothing to vary.
    #[error("`{sensor}` has no tolerance: every spread in its file is 0; write for example thickness = \"34 um +- 5 %\"")]
    NoTolerance { sensor: String },
    /// Too few samples.
    #[error("{samples} samples are too few; ask for {least} or more")]
    TooFewSamples { samples: usize, least: usize },
    /// Too many samples.
    #[error("{samples} samples are more than this study can place ({most}); ask for fewer, or average runs of different seeds")]
    TooManySamples { samples: usize, most: usize },
    /// A limit that nothing can meet by itself.
    #[error("the specification asks for {metric} from {low} to {high} {unit}, which is empty; swap the two")]
    EmptyLimit { metric: Metric, low: f64, high: f64, unit: &'static str },
    /// A range without a point.
    #[error(
        "the range of {quantity} from {low:.4e} to {high:.4e} (SI) is empty; the lower end must be below the upper, and both positive"
    )]
    EmptyRange { quantity: Quantity, low: f64, high: f64 },
    /// A list of values without a value.
    #[error("{quantity} has no value to choose from; list at least one")]
    NoLevel { quantity: Quantity },
    /// Nothing to choose.
    #[error("nothing may vary; leave at least one quantity free")]
    NoAxis,
    /// The sensor has no such part.
    #[error("`{sensor}` has no {quantity}; leave it out of the space")]
    NoSuchPart { sensor: String, quantity: Quantity },
    /// A limit that means nothing.
    #[error("the limit on the {limit} is {value}; give a number above 0, for the coverage at most 1")]
    NoSuchLimit { limit: &'static str, value: f64 },
    /// No point of the space is a sensor.
    #[error(
        "none of {tried} designs of the space meets all constraints; {excluded}; widen the space or relax the first of these"
    )]
    Infeasible { tried: usize, excluded: String },
    /// Too many sensors fail.
    #[error(
        "{refused} of {samples} sensors within the tolerances have plates that touch; the study would speak of the rest only: tighten the tolerances or lower the full-scale load"
    )]
    Refused { refused: usize, samples: usize },
}
