//! A section turned about its axis.
//!
//! (r, z) at angle θ becomes x = r cos θ, y = z, z = -r sin θ: right-handed with +Y up, as glTF wants it.

use super::boundary;
use super::error::SolidError;
use super::layer::Layer;
use super::profile::Profile;
use super::sweep::Sweep;

/// Positions (m) and unit normals of all vertices in one state.
#[derive(Debug, Clone, PartialEq)]
pub struct Shape {
    /// Vertex positions (x, y, z), m.
    pub positions: Vec<[f64; 3]>,
    /// Outward unit normals.
    pub normals: Vec<[f64; 3]>,
}

/// A closed triangle surface in several states with the same vertices.
#[derive(Debug, Clone, PartialEq)]
pub struct Surface {
    /// Point of the section that each vertex comes from.
    pub source: Vec<usize>,
    /// Corner indices, counter-clockwise seen from outside.
    pub triangles: Vec<[u32; 3]>,
    /// The shape at rest, then at each displacement factor asked for.
    pub shapes: Vec<Shape>,
}

/// Where a vertex of the surface is taken from.
enum Origin {
    /// Corner of the outline on the ring at an angle.
    Turned { corner: usize, angle: f64 },
    /// Point of the section on a cut face at an angle; `side` is -1 for the first face, 1 for the last.
    Cut { point: usize, angle: f64, side: f64 },
}

/// Turns `layer` at rest and displaced by each of `factors` times its displacement.
///
/// # Errors
/// Arrays that do not fit, values that are not finite, points behind the axis, flat or overlapping triangles.
pub fn revolve(layer: &Layer, factors: &[f64], sweep: Sweep) -> Result<Surface, SolidError> {
    sweep.check()?;
    layer.check(factors.iter().copied().fold(1.0, f64::max))?;
    let section = boundary::oriented(&layer.name, &layer.points, &layer.triangles)?;
    let outline = boundary::edges(&layer.name, &section)?;
    let widest = layer.points.iter().map(|p| p[0]).fold(0.0, f64::max);
    let on_axis: Vec<bool> = layer.points.iter().map(|p| p[0] <= 1e-9 * widest).collect();
    let profile = Profile::new(&layer.points, &outline, &on_axis);
    let angles = sweep.angles();

    let (mut origins, mut triangles) = turned(&profile, &on_axis, &angles, sweep.is_full());
    if !sweep.is_full() {
        add_cut_faces(&section, layer.points.len(), &angles, &mut origins, &mut triangles);
    }
    let source = origins
        .iter()
        .map(|origin| match origin {
            Origin::Turned { corner, .. } => profile.corners[*corner].point,
            Origin::Cut { point, .. } => *point,
        })
        .collect();
    let states = [0.0].iter().chain(factors).map(|&factor| layer.displaced(factor));
    let shapes = states.map(|points| shape(&origins, &profile, &points, &on_axis)).collect();
    Ok(Surface { source, triangles, shapes })
}

fn turned(profile: &Profile, on_axis: &[bool], angles: &[f64], full: bool) -> (Vec<Origin>, Vec<[u32; 3]>) {
    let rings = angles.len();
    let corners = profile.corners.len();
    let origins = angles.iter().flat_map(|&angle| (0..corners).map(move |corner| Origin::Turned { corner, angle })).collect();
    let mut triangles = Vec::new();
    for ring in 0..if full { rings } else { rings - 1 } {
        let next = (ring + 1) % rings;
        for &[a, b] in &profile.edges {
            let at = |ring: usize, corner: usize| (ring * corners + corner) as u32;
            let pole = |corner: usize| on_axis[profile.corners[corner].point];
            if !pole(a) {
                triangles.push([at(ring, a), at(next, a), at(ring, b)]);
            }
            if !pole(b) {
                triangles.push([at(ring, b), at(next, a), at(next, b)]);
            }
        }
    }
    (origins, triangles)
}

fn add_cut_faces(
    section: &[[usize; 3]],
    points: usize,
    angles: &[f64],
    origins: &mut Vec<Origin>,
    triangles: &mut Vec<[u32; 3]>,
) {
    for (angle, side) in [(angles[0], -1.0), (angles[angles.len() - 1], 1.0)] {
        let mut index = vec![None; points];
        for corners in section {
            let [a, b, c] = corners.map(|point| {
                *index[point].get_or_insert_with(|| {
                    origins.push(Origin::Cut { point, angle, side });
                    origins.len() as u32 - 1
                })
            });
            triangles.push(if side < 0.0 { [a, b, c] } else { [a, c, b] });
        }
    }
}

fn shape(origins: &[Origin], profile: &Profile, points: &[[f64; 2]], on_axis: &[bool]) -> Shape {
    let normals: Vec<[f64; 2]> = profile.corners.iter().map(|corner| profile.normal(corner, points)).collect();
    let place = |point: usize, angle: f64| {
        let radius = if on_axis[point] { 0.0 } else { points[point][0] };
        [radius * angle.cos(), points[point][1], -radius * angle.sin()]
    };
    let (positions, normals) = origins
        .iter()
        .map(|origin| match *origin {
            Origin::Turned { corner, angle } => {
                let [r, z] = normals[corner];
                (place(profile.corners[corner].point, angle), [r * angle.cos(), z, -r * angle.sin()])
            }
            Origin::Cut { point, angle, side } => (place(point, angle), [-side * angle.sin(), 0.0, -side * angle.cos()]),
        })
        .unzip();
    Shape { positions, normals }
}
