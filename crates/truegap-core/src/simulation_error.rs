//! Why a model has no answer, for a recording and for one row of it.
//!
//! Limits: the first row without an answer is named, not all of them.

use crate::inputs::Role;

/// Why a model has no answer.
#[derive(Clone, Debug, PartialEq, thiserror::Error)]
#[non_exhaustive]
pub enum SimulationError {
    /// The plates touch.
    #[error(
        "row {row}: a load of {load_si} closes the gap (strain {strain}); leave out loads beyond the sensor's range, or give a thicker or stiffer dielectric"
    )]
    GapCloses {
        /// row of the inputs
        row: usize,
        /// load, SI
        load_si: f64,
        /// compressive strain reached
        strain: f64,
    },
    /// A named driver that the model follows.
    #[error("the base model `{model}` follows the driver `{name}`, which was not recorded; name its column under [drivers]")]
    MissingDriver {
        /// model
        model: String,
        /// name under `[drivers]`
        name: String,
    },
    /// A column that the model needs.
    #[error("the base model `{model}` needs a column `{}`; name it under [columns] or choose another [base] model", .role.key())]
    MissingColumn {
        /// model
        model: String,
        /// the column's role
        role: Role,
    },
    /// A row that a table does not hold.
    #[error("row {row}: {} is {value} (SI), outside the table, which goes from {low} to {high}; extend the table, or leave the row out", .role.key())]
    OutsideTable {
        /// row of the inputs
        row: usize,
        /// the column
        role: Role,
        /// its value, SI
        value: f64,
        /// least value of the table
        low: f64,
        /// greatest value of the table
        high: f64,
    },
    /// No number, or one that is not finite, came out.
    #[error(
        "row {row}: the model has no finite response there{}; check load and temperature of the row, and the sensor's file or the simulator that was asked",
        parameters_told(parameters)
    )]
    NotFinite {
        /// row of the inputs
        row: usize,
        /// parameter values
        parameters: Vec<f64>,
    },
    /// A simulator outside this program failed: no answer came, or nonsense. No other parameter values would help.
    #[error("{says}")]
    Program {
        /// what happened, in a sentence that names the program
        says: String,
    },
    /// Not one value for each parameter.
    #[error(
        "the base model `{model}` has {expected} parameters, but {given} values were given; give one value for each parameter of the model, in their order"
    )]
    WrongNumberOfValues {
        /// model
        model: String,
        /// number of its parameters
        expected: usize,
        /// number of values given
        given: usize,
    },
}

fn parameters_told(parameters: &[f64]) -> String {
    if parameters.is_empty() { String::new() } else { format!(" with the parameters {parameters:?}") }
}

/// Why one row has no answer; [`Refusal::at`] says which row.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Refusal {
    /// the plates touch
    Touches {
        /// compressive strain
        strain: f64,
    },
    /// modulus not positive, or a tension that no strain answers
    NoAnswer,
}

impl Refusal {
    /// The error of a row, its load (SI) and the parameter values.
    pub fn at(self, row: usize, load_si: f64, values: &[f64]) -> SimulationError {
        match self {
            Self::Touches { strain } => SimulationError::GapCloses { row, load_si, strain },
            Self::NoAnswer => SimulationError::NotFinite { row, parameters: values.to_vec() },
        }
    }
}

/// The response, if every row of it is finite.
///
/// # Errors
/// [`SimulationError::NotFinite`] with the first row that is not, and the parameter values.
pub fn check_finite(response: Vec<f64>, values: &[f64]) -> Result<Vec<f64>, SimulationError> {
    match response.iter().position(|value| !value.is_finite()) {
        None => Ok(response),
        Some(row) => Err(SimulationError::NotFinite { row, parameters: values.to_vec() }),
    }
}
