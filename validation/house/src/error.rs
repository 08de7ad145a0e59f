//! What keeps the graph from being drawn.

/// The workspace or its order cannot be read.
#[derive(Debug, thiserror::Error)]
#[non_exhaustive]
pub enum HouseError {
    /// A file or folder that cannot be read.
    #[error("{path} cannot be read: {reason}")]
    Read {
        /// from the root of the workspace
        path: String,
        /// what the system says
        reason: std::io::Error,
    },
    /// A file that is no TOML.
    #[error("{path} is no TOML: {reason}")]
    Toml {
        /// from the root of the workspace
        path: String,
        /// what the reader says
        reason: Box<toml::de::Error>,
    },
    /// A part of the declared order that is missing or of another kind.
    #[error("{path}: `{key}` should be {expected}")]
    Order {
        /// file of the order
        path: String,
        /// table or key
        key: String,
        /// what belongs there
        expected: &'static str,
    },
    /// A `mod` line without a file.
    #[error("{file}: `mod {name};` has no file; looked for {looked_for}")]
    NoModule {
        /// file of the line
        file: String,
        /// module
        name: String,
        /// the two places
        looked_for: String,
    },
}
