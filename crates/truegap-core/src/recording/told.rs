//! What is told of a recording beside its files: columns in one line each, and the order of its dates.
//!
//! Limits: what is told goes before what a TOML says.

use super::{heading::Heading, manifest::Manifest, map::Mapped};

/// What is told of a recording beside its files.
#[derive(Clone, Debug, Default, PartialEq, Eq)]
pub struct Told {
    /// columns by their roles and drivers
    pub map: Vec<Mapped>,
    /// whether the day stands first in dates such as 01/03/2026; `None` where nobody says
    pub dayfirst: Option<bool>,
}

impl Manifest {
    /// The same with what is told in place of what the TOML says.
    pub fn told(mut self, told: &Told, header: &[Heading]) -> Self {
        self.dayfirst = told.dayfirst.or(self.dayfirst);
        self.mapped(&told.map, header)
    }
}
