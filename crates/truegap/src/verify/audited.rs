//! An audit and the bodies beside it, as its report needs them.
//!
//! Limits: plain data.

use truegap_audit::{Audit, Options};

/// An audit and where it comes from.
#[derive(Clone, Debug)]
pub struct Audited {
    /// what was found
    pub audit: Audit,
    /// range and accuracy
    pub options: Options,
    /// full load, N
    pub full_n: f64,
    /// the command that made it
    pub command: String,
}

/// A body to look at beside the table.
#[derive(Clone, Debug)]
pub struct Body {
    /// name of its files, without ending
    pub name: String,
    /// what it shows, a sentence
    pub says: String,
    /// for 3D viewers
    pub glb: Vec<u8>,
    /// its section, for ParaView
    pub vtu: String,
}
