//! What makes a layer impossible to turn into a solid.

/// A layer or a sweep that cannot be turned into a solid.
#[derive(Debug, Clone, PartialEq, thiserror::Error)]
#[non_exhaustive]
pub enum SolidError {
    /// No triangle.
    #[error("layer `{layer}` has no triangle; leave it out")]
    EmptyLayer {
        /// Name of the layer.
        layer: String,
    },
    /// A triangle names a point that is not there.
    #[error("layer `{layer}`: triangle {triangle} uses point {point}, but there are {points} points (counted from 0)")]
    NoSuchPoint {
        /// Name of the layer.
        layer: String,
        /// Index of the triangle.
        triangle: usize,
        /// Index of the point.
        point: usize,
        /// Number of points.
        points: usize,
    },
    /// An array with another length than the points.
    #[error("layer `{layer}`: {found} values of {what} for {points} points; give one a point, or none")]
    Lengths {
        /// Name of the layer.
        layer: String,
        /// `displacement` or `field`.
        what: &'static str,
        /// Length found.
        found: usize,
        /// Number of points.
        points: usize,
    },
    /// A coordinate, displacement or field value that is NaN or infinite.
    #[error("layer `{layer}`: {what} of point {point} is not finite; leave out the triangles where it is not known")]
    NotFinite {
        /// Name of the layer.
        layer: String,
        /// `position`, `displacement` or `field`.
        what: &'static str,
        /// Index of the point.
        point: usize,
    },
    /// A point on the wrong side of the axis, at rest or displaced.
    #[error(
        "layer `{layer}`: point {point} lies at r = {radius_m} m {state}; r must not be negative (a smaller exaggeration helps where only the exaggerated shape crosses the axis)"
    )]
    BehindAxis {
        /// Name of the layer.
        layer: String,
        /// Index of the point.
        point: usize,
        /// Its radius in metres.
        radius_m: f64,
        /// `at rest` or `deformed`.
        state: &'static str,
    },
    /// A triangle without area.
    #[error("layer `{layer}`: triangle {triangle} has no area; remove it")]
    FlatTriangle {
        /// Name of the layer.
        layer: String,
        /// Index of the triangle.
        triangle: usize,
    },
    /// Triangles that overlap: an edge with two triangles on one side.
    #[error(
        "layer `{layer}`: the edge between points {from} and {to} has more than one triangle on a side; the triangulation overlaps"
    )]
    Overlap {
        /// Name of the layer.
        layer: String,
        /// One end of the edge.
        from: usize,
        /// Other end of the edge.
        to: usize,
    },
    /// A sweep that is not between 0 and 360 degrees or has too few segments.
    #[error(
        "a sweep of {degrees} degrees with {segments} segments a full turn is none; use more than 0 and up to 360 degrees, and at least 8 segments"
    )]
    Sweep {
        /// Angle asked for.
        degrees: f64,
        /// Segments a full turn.
        segments: usize,
    },
}
