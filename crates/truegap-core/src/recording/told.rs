//! What is told of a recording beside its files: columns in one line each, the order of its dates, and whether its response is asked for.
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
    /// whether nothing but what was done is asked for: a table without a response, which no TOML names, is then a recording whose response is empty
    pub inputs_alone: bool,
}

impl Told {
    /// The same, with drivers that are called after a role as columns of that role.
    pub(super) fn by_roles(&self) -> Self {
        Self { map: self.map.iter().map(Mapped::as_role).collect(), ..self.clone() }
    }
}

impl Manifest {
    /// The same with what is told in place of what the TOML says.
    pub fn told(mut self, told: &Told, header: &[Heading]) -> Self {
        self.dayfirst = told.dayfirst.or(self.dayfirst);
        self.inputs_alone = told.inputs_alone;
        self.mapped(&told.map, header)
    }
}
