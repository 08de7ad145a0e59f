//! Which region of a drawing a point lies in.

use super::arrangement::Arrangement;
use super::curve::Curve;
use super::plane::{Point, twice_area};

/// Point-in-region test on the drawing, arcs taken as the chords of the mesh.
pub(crate) struct Inside {
    regions: Vec<Vec<Point>>,
}

impl Inside {
    pub fn new(drawing: &Arrangement, arc_step_degrees: f64) -> Inside {
        let chords = |c: &Curve| {
            let parts = c.arc.map_or(1, |(_, sweep)| (sweep.abs().to_degrees() / arc_step_degrees).ceil().max(1.0) as usize);
            (0..parts).map(|k| c.point(k as f64 / parts as f64)).collect::<Vec<_>>()
        };
        Inside { regions: drawing.regions.iter().map(|(_, curves)| curves.iter().flat_map(chords).collect()).collect() }
    }

    /// The last region that holds `p`.
    pub fn region(&self, p: Point) -> Option<u16> {
        (0..self.regions.len()).rev().find(|&i| encloses(&self.regions[i], p)).map(|i| i as u16)
    }
}

fn encloses(polygon: &[Point], p: Point) -> bool {
    let n = polygon.len();
    let mut inside = false;
    for i in 0..n {
        let (a, b) = (polygon[i], polygon[(i + 1) % n]);
        if (a[1] > p[1]) != (b[1] > p[1]) && (twice_area(a, b, p) > 0.0) == (b[1] > a[1]) {
            inside = !inside;
        }
    }
    inside
}
