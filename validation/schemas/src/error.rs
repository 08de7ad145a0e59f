//! Why there is no schema.

use std::path::PathBuf;

/// What is wrong with the sources, and where.
#[derive(Debug, thiserror::Error)]
#[non_exhaustive]
#[allow(missing_docs)] // the fields are named by the messages
pub enum SchemaError {
    /// A file that cannot be read or written.
    #[error("{file}: {source}")]
    File { file: PathBuf, source: std::io::Error },
    /// A file that is not Rust.
    #[error("{file}: {source}")]
    Syntax { file: PathBuf, source: syn::Error },
    /// A file that is not JSON.
    #[error("{file}: {source}")]
    Json { file: PathBuf, source: serde_json::Error },
    /// A type that no source defines, or several do.
    #[error(
        "the type `{name}` used in {place} is defined in {found}; one place is wanted: say which in `validation/schemas/src/index.rs`, or write it by hand"
    )]
    Type { name: String, place: String, found: String },
    /// Something that this reader does not know.
    #[error("{place}: {what} is not known here; add it to `validation/schemas/src`")]
    Unknown { place: String, what: String },
}
