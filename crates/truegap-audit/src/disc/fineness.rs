//! How fine a section is meshed.
//!
//! Limits: columns and rows only; the grading at the rim is the section's own.

/// How fine a section is meshed.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Fineness {
    /// columns along the radius, grading at the rim not counted
    pub columns: usize,
    /// factor on the rows across each layer
    pub rows: usize,
}

impl Fineness {
    /// For values.
    pub const FINE: Self = Self { columns: 64, rows: 2 };
    /// Half of it, for the estimate of the error.
    pub const COARSE: Self = Self { columns: 32, rows: 1 };
}
