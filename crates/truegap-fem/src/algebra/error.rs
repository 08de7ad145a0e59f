//! How a linear solve fails.

/// Errors of the linear algebra.
#[derive(Debug, Clone, PartialEq, thiserror::Error)]
#[non_exhaustive]
pub enum SolveError {
    /// The matrix has a pivot that is zero or negative.
    #[error(
        "the system of {size} unknowns is not positive definite (pivot {pivot}); fix the rigid-body modes, or the state is unstable"
    )]
    NotPositiveDefinite {
        /// Elimination step.
        pivot: usize,
        /// Number of unknowns.
        size: usize,
    },
    /// The matrix is singular to working precision.
    #[error(
        "the system of {size} unknowns is singular to working precision (a known solution comes back with a relative error of {error:.1e}); hold every part of the body where it can move or, in electrostatics, give every part a boundary with a potential"
    )]
    Singular {
        /// Relative error of the solution of a system whose solution is known.
        error: f64,
        /// Number of unknowns.
        size: usize,
    },
    /// A solution does not satisfy its equations.
    #[error(
        "the solution of {size} unknowns leaves a relative residual of {residual:.1e} (allowed {allowed:.1e}); rescale the problem or check the materials for extreme ratios"
    )]
    Residual {
        /// Normwise backward error.
        residual: f64,
        /// Largest accepted.
        allowed: f64,
        /// Number of unknowns.
        size: usize,
    },
    /// An entry of the matrix is NaN or infinite.
    #[error("the matrix has an entry that is not finite in column {column}; check materials and geometry")]
    NotFinite {
        /// Column.
        column: usize,
    },
    /// Used before factorising, or with a matrix of another pattern.
    #[error("the matrix ({got} entries) does not have the pattern that was analysed ({expected} entries); analyse it again")]
    WrongPattern {
        /// Entries given.
        got: usize,
        /// Entries analysed.
        expected: usize,
    },
    /// Memory or index range exhausted in the analysis.
    #[error("the analysis of {size} unknowns failed: {reason}")]
    Analysis {
        /// Number of unknowns.
        size: usize,
        /// Message.
        reason: String,
    },
    /// A numbering of other unknowns than those of the elements.
    #[error(
        "the elements have {unknowns} unknowns, the numbering has {numbered} with {free} rows; make it with `Numbering::new` from a list over all unknowns"
    )]
    WrongNumbering {
        /// Unknowns of the elements.
        unknowns: usize,
        /// Unknowns of the numbering.
        numbered: usize,
        /// Rows of the numbering.
        free: usize,
    },
    /// An element with more unknowns than a scatter map can hold.
    #[error("element {element} has {unknowns} unknowns, at most {most} are possible; divide it")]
    ElementTooLarge {
        /// Index of the element.
        element: usize,
        /// Its unknowns.
        unknowns: usize,
        /// Most unknowns of an element.
        most: usize,
    },
    /// A matrix with more entries than positions.
    #[error("the system of {size} unknowns has {entries} entries, more than 32-bit positions can name; use a coarser mesh")]
    TooManyEntries {
        /// Entries of the lower triangle.
        entries: usize,
        /// Number of unknowns.
        size: usize,
    },
}
