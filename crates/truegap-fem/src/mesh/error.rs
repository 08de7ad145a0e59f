//! What can be wrong with a drawing or a mesh, each with the place and the remedy.

/// Errors of geometry, meshing and mesh files. Coordinates are metres.
#[derive(Debug, Clone, PartialEq, thiserror::Error)]
#[non_exhaustive]
pub enum MeshError {
    /// A coordinate is NaN or infinite.
    #[error("`{name}` has the point ({}, {}) m, which is not finite; give every coordinate a number", at[0], at[1])]
    NotFinite {
        /// Region or boundary.
        name: String,
        /// The point.
        at: [f64; 2],
    },
    /// There is nothing to mesh.
    #[error("the drawing has no region; give at least one [[region]] with a polygon")]
    NoRegion,
    /// An outline encloses no area.
    #[error("the outline of region `{region}` from ({}, {}) m encloses no area ({corners} sides); give at least three corners that are not in line", at[0], at[1])]
    OpenOutline {
        /// Region.
        region: String,
        /// Number of sides.
        corners: usize,
        /// Its first point.
        at: [f64; 2],
    },
    /// An outline crosses itself.
    #[error("the outline of `{name}` crosses itself at ({}, {}) m; reorder its corners, or split it into two regions", at[0], at[1])]
    CrossingOutline {
        /// Region or boundary.
        name: String,
        /// Where.
        at: [f64; 2],
    },
    /// A boundary names a region that is not there.
    #[error("boundary `{boundary}` follows the outline of region `{region}`, which does not exist; known regions: {known}")]
    UnknownRegion {
        /// Boundary.
        boundary: String,
        /// The missing name.
        region: String,
        /// Names that exist.
        known: String,
    },
    /// A boundary has an edge outside every region.
    #[error("boundary `{boundary}` lies on nothing near ({}, {}) m: no region touches it there; move the path or extend a region", at[0], at[1])]
    BoundaryOnNothing {
        /// Boundary.
        boundary: String,
        /// Middle of the first such edge.
        at: [f64; 2],
    },
    /// A later region covers an earlier one completely.
    #[error("region `{region}` has no area left after the later regions cut it; remove it or change the order")]
    RegionVanished {
        /// Region.
        region: String,
    },
    /// An axisymmetric domain reaches beyond the axis.
    #[error("the mesh reaches r = {r} m, beyond the axis; axisymmetric coordinates (r, z) need r >= 0")]
    BeyondAxis {
        /// Smallest radius.
        r: f64,
    },
    /// The triangulation library refused a point.
    #[error("the triangulation failed: {reason}; check the drawing for coordinates of very different size")]
    Triangulation {
        /// Its message.
        reason: String,
    },
    /// The requested size needs more triangles than allowed.
    #[error("the mesh needs more than {limit} triangles; raise max_edge, or leave out what is very thin")]
    TooManyTriangles {
        /// The limit.
        limit: usize,
    },
    /// The drawing needs more memory than there is.
    #[error(transparent)]
    TooLarge(#[from] truegap_limits::TooLarge),
    /// A size is not usable.
    #[error("the element size {size} m is not positive; give max_edge a positive length")]
    BadSize {
        /// The size.
        size: f64,
    },
    /// A triangle is inverted or flat.
    #[error("triangle {triangle} near ({}, {}) m is inverted or flat (area ratio {ratio:.3e}); reorder its corners, or mesh the curve finer", at[0], at[1])]
    InvertedTriangle {
        /// Its index.
        triangle: usize,
        /// Its first corner.
        at: [f64; 2],
        /// Smallest Jacobian over the largest squared edge.
        ratio: f64,
    },
    /// A table of the mesh points outside another.
    #[error("the mesh is inconsistent: {what} {index} refers to {refers}, but there are only {count}")]
    BadIndex {
        /// Kind of item.
        what: &'static str,
        /// Which.
        index: usize,
        /// What it refers to.
        refers: usize,
        /// How many there are.
        count: usize,
    },
    /// A boundary edge that is no edge of the triangles.
    #[error("boundary `{boundary}` has the edge {a}-{b}, which no triangle has; remove it or mesh the line")]
    NotAnEdge {
        /// Boundary.
        boundary: String,
        /// First node.
        a: usize,
        /// Second node.
        b: usize,
    },
    /// A name that the mesh does not have.
    #[error("the mesh has no boundary `{name}`; it has: {known}")]
    UnknownBoundary {
        /// The missing name.
        name: String,
        /// Names that exist.
        known: String,
    },
    /// A mesh file that cannot be read.
    #[error("{file}, line {line}: {what}")]
    File {
        /// Name of the file or of its source.
        file: String,
        /// Line, from 1.
        line: usize,
        /// What is wrong and how to fix it.
        what: String,
    },
}
