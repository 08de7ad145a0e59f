//! What colours the stack.
//!
//! Limits: names only; units and colour maps are those of the layers.

/// What colours the stack.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub enum Colour {
    /// temperature
    Temperature,
    /// how far a point has moved
    #[default]
    Displacement,
    /// von Mises stress
    VonMises,
    /// electric potential
    Potential,
    /// electric field strength
    Field,
}

impl Colour {
    /// All of them, in the order in which a viewer offers those that do not colour the file.
    pub const ALL: [Self; 5] = [Self::Displacement, Self::VonMises, Self::Potential, Self::Field, Self::Temperature];
}
