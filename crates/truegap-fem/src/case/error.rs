//! What can be wrong with a case file.

/// Errors of case files, each naming the file and the place in it.
#[derive(Debug, Clone, PartialEq, thiserror::Error)]
#[non_exhaustive]
pub enum CaseError {
    /// Not TOML, or a key that does not exist.
    #[error("{file}: {message}")]
    Syntax {
        /// File.
        file: String,
        /// Message of the parser, with line and column.
        message: String,
    },
    /// Another schema.
    #[error("{file}: schema is `{found}`; this program reads `truegap.case/1`")]
    Schema {
        /// File.
        file: String,
        /// What it says.
        found: String,
    },
    /// A word that is not among those allowed.
    #[error("{file}, {place}: `{found}` is not known; use one of: {known}")]
    UnknownWord {
        /// File.
        file: String,
        /// Key.
        place: String,
        /// What it says.
        found: String,
        /// Allowed words.
        known: String,
    },
    /// A quantity without or with a wrong unit.
    #[error("{file}, {place}: `{found}` is not {wanted}; write for example \"{example}\"")]
    Quantity {
        /// File.
        file: String,
        /// Key.
        place: String,
        /// What it says.
        found: String,
        /// Kind of quantity.
        wanted: &'static str,
        /// A good one.
        example: &'static str,
    },
    /// Something necessary is missing.
    #[error("{file}, {place}: {what} is missing; {remedy}")]
    Missing {
        /// File.
        file: String,
        /// Where.
        place: String,
        /// What.
        what: &'static str,
        /// What to do.
        remedy: &'static str,
    },
    /// More than can be handled.
    #[error(transparent)]
    TooLarge(#[from] truegap_limits::TooLarge),
    /// A value that makes no sense there.
    #[error("{file}, {place}: {what}")]
    Invalid {
        /// File.
        file: String,
        /// Where.
        place: String,
        /// What is wrong and how to fix it.
        what: String,
    },
}
