//! How many triangles a drawing will need, before any is made.
//!
//! Limits: an estimate from below for the size field (its `max_edge` alone counts), measured for thin layers; what a narrow corner needs is not seen.

use super::arrangement::{Arrangement, Piece};
use super::curve::Curve;
use super::error::MeshError;
use super::options::MeshOptions;
use super::plane::{Point, cross, distance, dot, minus};
use truegap_limits::Need;

/// Memory of a triangle while it is meshed, bytes (measured: 6.2 GB for 4 million).
const MEMORY_OF_A_TRIANGLE: f64 = 1.5e3;

/// Triangles of a layer over its length by its thickness (measured: 4 million for 1e6).
const OF_A_LAYER: f64 = 4.0;

/// Length over distance from which two lines are the sides of a thin layer.
const THIN: f64 = 1e3;

/// Refuses a drawing whose mesh would not fit into the memory there is.
pub(crate) fn check_size(drawing: &Arrangement, options: &MeshOptions) -> Result<(), MeshError> {
    let filled = by_size(drawing, options.size.max_edge);
    let (layers, thinnest) = by_layers(drawing);
    let (triangles, why, remedy) = if filled >= layers {
        let why = format!("edges of {:e} m", options.size.max_edge);
        (filled, why, "raise max_edge")
    } else {
        let why = format!(
            "a layer {:.1e} times as thin as it is long near ({:.6e}, {:.6e}) m",
            thinnest.0, thinnest.1[0], thinnest.1[1]
        );
        (layers, why, "draw the layer thicker or shorter, or leave it out")
    };
    let asked = format!("{why}, so about {triangles:.1e} triangles,");
    Ok(truegap_limits::check(Need { place: "mesh", asked: &asked, bytes: triangles * MEMORY_OF_A_TRIANGLE, remedy })?)
}

/// Triangles that edges of at most `max_edge` need at least: by the area of the largest region, and by the length of all lines.
fn by_size(drawing: &Arrangement, max_edge: f64) -> f64 {
    let area = drawing.regions.iter().map(|(_, curves)| area(curves)).fold(0.0, f64::max);
    let length: f64 = drawing.pieces.iter().map(|p| length(&p.curve)).sum();
    // the mesher leaves triangles up to half of max_edge^2, and edges up to 1.2 of it
    (area / (0.5 * max_edge * max_edge)).max(length / (1.2 * max_edge))
}

fn area(curves: &[Curve]) -> f64 {
    let points: Vec<Point> = curves.iter().flat_map(|c| [c.point(0.0), c.point(0.25), c.point(0.5), c.point(0.75)]).collect();
    let Some(&start) = points.first() else { return 0.0 };
    let spoke = |i: usize| minus(points[i % points.len()], start);
    (0..points.len()).map(|i| 0.5 * cross(spoke(i), spoke(i + 1))).sum::<f64>().abs()
}

fn length(curve: &Curve) -> f64 {
    match curve.arc {
        Some((circle, sweep)) => circle.radius * sweep.abs(),
        None => distance(curve.from, curve.to),
    }
}

/// Triangles between parallel lines that are close to each other, and the thinnest such place: distance over length, and where.
fn by_layers(drawing: &Arrangement) -> (f64, (f64, Point)) {
    let lines: Vec<&Piece> = drawing.pieces.iter().filter(|p| p.curve.arc.is_none()).collect();
    let (mut triangles, mut thinnest) = (0.0, (f64::INFINITY, [0.0; 2]));
    for (i, line) in lines.iter().enumerate() {
        let others = lines.iter().enumerate().filter(|(j, _)| *j != i);
        let ratio = others.map(|(_, other)| slenderness(&line.curve, &other.curve)).fold(0.0, f64::max);
        if ratio < THIN {
            continue;
        }
        // every layer is seen from both of its sides
        triangles += 0.5 * OF_A_LAYER * ratio;
        if 1.0 / ratio < thinnest.0 {
            thinnest = (1.0 / ratio, line.curve.point(0.5));
        }
    }
    (triangles, thinnest)
}

/// Length along which two lines run beside each other over their distance; 0 where they do not, or meet.
fn slenderness(a: &Curve, b: &Curve) -> f64 {
    let (u, whole) = (minus(a.to, a.from), distance(a.from, a.to));
    let along = |p: Point| dot(minus(p, a.from), u) / whole;
    let off = |p: Point| cross(u, minus(p, a.from)) / whole;
    let (s, t) = (along(b.from), along(b.to));
    let beside = s.max(t).min(whole) - s.min(t).max(0.0);
    let (near, far) = (off(b.from), off(b.to));
    let gap = near.abs().max(far.abs());
    let apart = near * far > 0.0;
    if apart && beside > THIN * gap { beside / gap } else { 0.0 }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::mesh::{Geometry, MeshOptions, Outline, SizeField, mesh_geometry};

    fn layer(thickness: f64) -> Geometry {
        Geometry::default().region("layer", Outline::rectangle([0.0, 0.0], [1.0, thickness]))
    }

    #[test]
    fn the_estimate_of_a_thin_layer_is_what_the_mesher_makes() {
        let drawing = layer(1e-4);
        let estimate = by_layers(&Arrangement::new(&drawing).unwrap()).0;
        let made = mesh_geometry(&drawing, &MeshOptions::default()).unwrap().triangles.len() as f64;
        // the mesher fills the surroundings of the layer as well and drops them; a factor of 4 decides nothing here
        assert!(estimate / made < 4.0 && made / estimate < 4.0, "{estimate} {made}");
    }

    #[test]
    fn the_estimate_of_small_edges_is_below_what_the_mesher_makes() {
        let drawing = layer(0.5);
        let options = MeshOptions { size: SizeField::uniform(0.02), ..MeshOptions::default() };
        let estimate = by_size(&Arrangement::new(&drawing).unwrap(), 0.02);
        let made = mesh_geometry(&drawing, &options).unwrap().triangles.len() as f64;
        assert!(estimate <= made && made < 6.0 * estimate, "{estimate} {made}");
    }

    #[test]
    fn what_does_not_fit_is_refused_before_it_is_made() {
        let begin = std::time::Instant::now();
        let told = mesh_geometry(&layer(1e-7), &MeshOptions::default()).unwrap_err().to_string();
        assert!(told.contains("1.0e-7 times as thin") && told.contains("TRUEGAP_MEMORY"), "{told}");
        let options = MeshOptions { size: SizeField::uniform(1e-9), ..MeshOptions::default() };
        let told = mesh_geometry(&layer(0.5), &options).unwrap_err().to_string();
        assert!(told.contains("raise max_edge") && told.contains("of memory"), "{told}");
        assert!(begin.elapsed().as_secs() < 5);
    }
}
