//! Why nothing can be concluded from a recording.
//!
//! Limits: plain data.

/// Why nothing can be concluded from a recording.
#[derive(Debug, thiserror::Error)]
#[non_exhaustive]
pub enum DiagnoseError {
    /// Too short.
    #[error("{rows} row{} too few to tell anything; record at least {needed}", if *rows == 1 { " is" } else { "s are" })]
    TooFewRows {
        /// rows found
        rows: usize,
        /// rows needed
        needed: usize,
    },
    /// The response never moves.
    #[error("the response is {value} {unit} in every row: a dead channel; check the wiring and the column that [columns] names")]
    DeadChannel {
        /// the value
        value: f64,
        /// its unit
        unit: String,
    },
    /// Nothing is done to the sensor.
    #[error(
        "the {column} is {value} in all {rows} rows and no temperature changes: nothing can be told of a sensor to which nothing is done; record a \
         load cycle or a temperature sweep, or set model = \"constant\" under [base] for a study of drift"
    )]
    ConstantInput {
        /// force, pressure or gap
        column: &'static str,
        /// its value with unit
        value: String,
        /// rows
        rows: usize,
    },
    /// The model has no answer at the recording's inputs.
    #[error(transparent)]
    Simulation(#[from] truegap_core::SimulationError),
    /// Somebody asked to stop before anything was known.
    #[error("stopped before the base model was calibrated; nothing is known yet")]
    Stopped,
}

/// Fewest rows that can tell anything.
pub const FEWEST_ROWS: usize = 20;
