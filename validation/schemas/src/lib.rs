//! JSON Schemas of every file and output, written from the types that the program reads and writes.
//!
//! Limits: reads the sources as text, so that no crate is built with more than it needs; knows the `serde` attributes that the workspace uses, and stops with an
//! error at any other.

mod attributes;
mod document;
mod error;
mod index;
mod kind;
mod schema;

pub use document::{DOCUMENTS, Document, written};
pub use error::SchemaError;
pub use index::Index;
