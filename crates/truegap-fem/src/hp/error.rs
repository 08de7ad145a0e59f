//! What the hp version does not do, and where it gives up.

use crate::mesh::{Mesh, Point};

/// A problem that the hp version leaves to the refinement of quadratic elements; coordinates are metres.
///
/// What is wrong with a problem for both methods is told by the errors of its physics.
#[derive(Debug, Clone, PartialEq, thiserror::Error)]
#[non_exhaustive]
pub enum HpError {
    /// An arc.
    #[error("region `{region}` has a curved edge at ({}, {}) m, and the hp version knows straight edges only", at[0], at[1])]
    Curved {
        /// Region.
        region: String,
        /// An end of the edge.
        at: Point,
    },
    /// An output that is no product of energies.
    #[error("output `{output}` is no energy and no {integral}, and the hp version gives these only")]
    Output {
        /// Output.
        output: String,
        /// What else there is in this physics.
        integral: &'static str,
    },
    /// Two potentials at one point.
    #[error(
        "boundaries `{a}` and `{b}` touch at ({}, {}) m, and the hp version needs a gap between conductors, and between them and open boundaries",
        at[0], at[1]
    )]
    Touching {
        /// A conductor.
        a: String,
        /// Another one, or an open boundary.
        b: String,
        /// Where.
        at: Point,
    },
    /// Large strain.
    #[error("region `{region}` has a law of large strain, and the hp version knows the linear one only")]
    Law {
        /// Region.
        region: String,
    },
    /// Rubber that hardly changes its volume.
    #[error("region `{region}` has a Poisson's ratio of {poisson}, and the hp version takes at most {most}")]
    Poisson {
        /// Region.
        region: String,
        /// Its Poisson's ratio.
        poisson: f64,
        /// The largest one.
        most: f64,
    },
    /// Warm bodies that expand.
    #[error("region `{region}` expands with the temperature, and the hp version knows no thermal strain")]
    Expansion {
        /// Region.
        region: String,
    },
    /// A load that is no displacement of a boundary.
    #[error("{place} has {load}, and the hp version takes bodies that displacements of boundaries alone hold and drive")]
    Load {
        /// Boundary, point or body.
        place: String,
        /// What is there.
        load: &'static str,
    },
    /// A reaction that is no product of energies.
    #[error("output `{output}` is the reaction of boundary `{boundary}`, which the hp version does not give: {reason}")]
    Reaction {
        /// Output.
        output: String,
        /// Boundary.
        boundary: String,
        /// Why.
        reason: String,
    },
    /// A first mesh that is fine already.
    #[error("the first mesh has {triangles} triangles, and the hp version takes {most} at most: it is fast from coarse ones")]
    FirstMesh {
        /// Triangles.
        triangles: usize,
        /// Most of them.
        most: usize,
    },
    /// The last degree is not enough.
    #[error(
        "output `{output}` has an estimated relative error of {estimate:.1e} at the highest degree of the hp version, with {unknowns} unknowns; {wanted:.1e} was asked for"
    )]
    NotReached {
        /// Output.
        output: String,
        /// Estimate reached.
        estimate: f64,
        /// Unknowns used.
        unknowns: usize,
        /// Error wanted.
        wanted: f64,
    },
}

/// Refuses a mesh with curved edges.
pub(crate) fn check_straight(mesh: &Mesh) -> Result<(), HpError> {
    let Some(edge) = mesh.curved_edges.first() else { return Ok(()) };
    let of = |t: &[u32; 3]| edge.nodes.iter().all(|n| t.contains(n));
    let region = mesh.triangles.iter().position(of).map_or(0, |t| mesh.triangle_regions[t]);
    Err(HpError::Curved { region: mesh.region_names[region as usize].clone(), at: mesh.points[edge.nodes[0] as usize] })
}
