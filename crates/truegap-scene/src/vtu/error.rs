//! What makes a grid impossible to write.

/// A grid that cannot be written.
#[derive(Debug, Clone, PartialEq, thiserror::Error)]
#[non_exhaustive]
pub enum VtuError {
    /// No cell.
    #[error("the grid has no cell; there is nothing to write")]
    Empty,
    /// A coordinate that is NaN or infinite.
    #[error("point {point} has a coordinate that is not finite")]
    NotFinite {
        /// Index of the point.
        point: usize,
    },
    /// A cell names a point that is not there.
    #[error("cell {cell} uses point {point}, but there are {points} points (counted from 0)")]
    NoSuchPoint {
        /// Index of the cell.
        cell: usize,
        /// Index of the point.
        point: usize,
        /// Number of points.
        points: usize,
    },
    /// A field of the wrong length.
    #[error("field `{field}` has {found} values for {wanted} {of}; give one for each")]
    Lengths {
        /// Name of the field.
        field: String,
        /// Values given.
        found: usize,
        /// Values needed.
        wanted: usize,
        /// `points` or `cells`.
        of: &'static str,
    },
    /// Two fields of one name on the same entities.
    #[error("two fields on {of} are called `{field}`; readers would keep only one")]
    SameName {
        /// The name.
        field: String,
        /// `points` or `cells`.
        of: &'static str,
    },
}
