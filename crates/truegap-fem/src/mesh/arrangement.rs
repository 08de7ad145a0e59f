//! Cuts all curves of a drawing at each other, so that they meet in vertices only.
//!
//! Works pair by pair: a drawing of 10 000 curves takes a second or two, one of ten times as many a hundred times as long.

use super::curve::Curve;
use super::error::MeshError;
use super::outline::{BoundaryPath, Geometry, check_closed};
use super::plane::{Point, distance, minus};

/// A curve between two vertices that meets no other curve in between.
#[derive(Debug, Clone)]
pub(crate) struct Piece {
    pub curve: Curve,
    pub ends: [usize; 2],
    /// Boundaries (indices into `Arrangement::boundaries`) that run along it.
    pub boundaries: Vec<u16>,
}

/// The drawing, cut.
#[derive(Debug, Clone, Default)]
pub(crate) struct Arrangement {
    pub vertices: Vec<Point>,
    pub pieces: Vec<Piece>,
    pub boundaries: Vec<String>,
    /// Closed curves of each region, as drawn.
    pub regions: Vec<(String, Vec<Curve>)>,
    pub tolerance: f64,
}

struct Drawn {
    curve: Curve,
    owner: usize,
    boundary: Option<u16>,
}

impl Arrangement {
    pub fn new(geometry: &Geometry) -> Result<Arrangement, MeshError> {
        if geometry.regions.is_empty() {
            return Err(MeshError::NoRegion);
        }
        // labels are 16-bit numbers, the last of which says that a face is outside
        for (found, things) in [(geometry.regions.len(), "regions"), (geometry.boundaries.len(), "boundaries")] {
            truegap_limits::count("the drawing", found, things, usize::from(u16::MAX) - 1, "join some of them")?;
        }
        let mut out = Arrangement::default();
        let mut drawn = Vec::new();
        out.draw_regions(geometry, &mut drawn)?;
        out.tolerance = 1e-9 * span(&drawn);
        check_self_crossings(geometry, &drawn, out.tolerance)?;
        out.draw_boundaries(geometry, &mut drawn)?;
        out.cut(&drawn);
        Ok(out)
    }

    fn draw_regions(&mut self, geometry: &Geometry, drawn: &mut Vec<Drawn>) -> Result<(), MeshError> {
        for (owner, region) in geometry.regions.iter().enumerate() {
            let curves = region.outline.curves(true);
            check_closed(region, &curves)?;
            drawn.extend(curves.iter().map(|&curve| Drawn { curve, owner, boundary: None }));
            self.regions.push((region.name.clone(), curves));
        }
        Ok(())
    }

    fn draw_boundaries(&mut self, geometry: &Geometry, drawn: &mut Vec<Drawn>) -> Result<(), MeshError> {
        for boundary in &geometry.boundaries {
            let known = self.boundaries.iter().position(|name| *name == boundary.name);
            let tag = known.unwrap_or(self.boundaries.len()) as u16;
            if known.is_none() {
                self.boundaries.push(boundary.name.clone());
            }
            let curves = match &boundary.path {
                BoundaryPath::Path(outline) => outline.curves(false),
                BoundaryPath::OutlineOf(region) => self.outline_of(&boundary.name, region)?,
            };
            if let Some(at) = curves.iter().flat_map(|c| [c.from, c.to]).find(|p| !(p[0].is_finite() && p[1].is_finite())) {
                return Err(MeshError::NotFinite { name: boundary.name.clone(), at });
            }
            drawn.extend(curves.into_iter().map(|curve| Drawn { curve, owner: usize::MAX, boundary: Some(tag) }));
        }
        Ok(())
    }

    fn outline_of(&self, boundary: &str, region: &str) -> Result<Vec<Curve>, MeshError> {
        let found: Vec<Curve> = self.regions.iter().filter(|(name, _)| name == region).flat_map(|(_, c)| c.clone()).collect();
        if found.is_empty() {
            let known = self.regions.iter().map(|(name, _)| name.as_str()).collect::<Vec<_>>().join(", ");
            return Err(MeshError::UnknownRegion { boundary: boundary.into(), region: region.into(), known });
        }
        Ok(found)
    }

    fn cut(&mut self, drawn: &[Drawn]) {
        let mut cuts: Vec<Vec<Point>> = drawn.iter().map(|d| vec![d.curve.from, d.curve.to]).collect();
        let frames = frames(drawn, self.tolerance);
        for i in 0..drawn.len() {
            for j in 0..drawn.len() {
                if apart(frames[i], frames[j]) {
                    continue;
                }
                if i != j {
                    let ends = [drawn[j].curve.from, drawn[j].curve.to];
                    cuts[i].extend(ends.into_iter().filter(|&p| drawn[i].curve.locate(p, self.tolerance).is_some()));
                }
                if i < j {
                    let meets = drawn[i].curve.meets(&drawn[j].curve, self.tolerance);
                    cuts[i].extend_from_slice(&meets);
                    cuts[j].extend_from_slice(&meets);
                }
            }
        }
        // End points first, so that cuts snap to drawn points and not the reverse.
        for d in drawn {
            self.vertex(d.curve.from);
            self.vertex(d.curve.to);
        }
        for (d, points) in drawn.iter().zip(cuts) {
            self.split(d, &points);
        }
    }

    fn split(&mut self, drawn: &Drawn, points: &[Point]) {
        let mut stops: Vec<(f64, usize)> = Vec::with_capacity(points.len());
        for &p in points {
            let vertex = self.vertex(p);
            // A full turn starts and ends at one point: keep both fractions.
            let t = match p {
                _ if p == drawn.curve.from => Some(0.0),
                _ if p == drawn.curve.to => Some(1.0),
                _ => drawn.curve.locate(self.vertices[vertex], 2.0 * self.tolerance),
            };
            if let Some(t) = t
                && !stops.iter().any(|s| s.1 == vertex)
            {
                stops.push((t, vertex));
            }
        }
        stops.sort_by(|a, b| a.0.total_cmp(&b.0));
        for pair in stops.windows(2) {
            let (a, b) = (pair[0], pair[1]);
            let curve = drawn.curve.part((a.0, self.vertices[a.1]), (b.0, self.vertices[b.1]));
            self.add_piece(curve, [a.1, b.1], drawn.boundary);
        }
    }

    fn add_piece(&mut self, curve: Curve, ends: [usize; 2], boundary: Option<u16>) {
        let middle = curve.point(0.5);
        let same = |p: &&mut Piece| {
            (p.ends == ends || p.ends == [ends[1], ends[0]]) && distance(p.curve.point(0.5), middle) <= 4.0 * self.tolerance
        };
        if let Some(piece) = self.pieces.iter_mut().find(same) {
            if let Some(tag) = boundary
                && !piece.boundaries.contains(&tag)
            {
                piece.boundaries.push(tag);
            }
            return;
        }
        self.pieces.push(Piece { curve, ends, boundaries: boundary.into_iter().collect() });
    }

    /// A point with coordinates of less than 1e-12 of the drawing's span taken for 0: the axis and other coordinate lines stay exact, whatever an arc or a
    /// division has rounded, and the triangulation refuses denormal coordinates.
    pub fn on_coordinate_lines(&self, p: Point) -> Point {
        p.map(|x| if x.abs() < 1e-3 * self.tolerance { 0.0 } else { x })
    }

    fn vertex(&mut self, p: Point) -> usize {
        if let Some(i) = self.vertices.iter().position(|&q| distance(p, q) <= self.tolerance) {
            return i;
        }
        self.vertices.push(self.on_coordinate_lines(p));
        self.vertices.len() - 1
    }
}

/// Lower and upper corner.
type Frame = [Point; 2];

/// Rectangles that hold the curves and all that lies within a few tolerances of them.
fn frames(drawn: &[Drawn], tolerance: f64) -> Vec<Frame> {
    let frame = |d: &Drawn| {
        let (from, to, slack) = (d.curve.from, d.curve.to, 8.0 * tolerance);
        let (mut low, mut high) = ([0, 1].map(|k| from[k].min(to[k])), [0, 1].map(|k| from[k].max(to[k])));
        if let Some((circle, _)) = d.curve.arc {
            low = [0, 1].map(|k| low[k].min(circle.centre[k] - circle.radius));
            high = [0, 1].map(|k| high[k].max(circle.centre[k] + circle.radius));
        }
        [low.map(|x| x - slack), high.map(|x| x + slack)]
    };
    drawn.iter().map(frame).collect()
}

fn apart([low, high]: Frame, [other_low, other_high]: Frame) -> bool {
    (0..2).any(|k| low[k] > other_high[k] || other_low[k] > high[k])
}

fn span(drawn: &[Drawn]) -> f64 {
    let mut low = [f64::INFINITY; 2];
    let mut high = [f64::NEG_INFINITY; 2];
    for p in drawn.iter().flat_map(|d| [d.curve.from, d.curve.point(0.5), d.curve.to]) {
        for k in 0..2 {
            low[k] = low[k].min(p[k]);
            high[k] = high[k].max(p[k]);
        }
    }
    let d = minus(high, low);
    d[0].hypot(d[1])
}

fn check_self_crossings(geometry: &Geometry, drawn: &[Drawn], tolerance: f64) -> Result<(), MeshError> {
    let frames = frames(drawn, tolerance);
    for (i, a) in drawn.iter().enumerate() {
        let near = |(j, b): &(usize, &Drawn)| b.owner == a.owner && !apart(frames[i], frames[*j]);
        for (_, b) in drawn.iter().enumerate().skip(i + 1).filter(near) {
            let ends = [a.curve.from, a.curve.to, b.curve.from, b.curve.to];
            let crossing =
                a.curve.meets(&b.curve, tolerance).into_iter().find(|&p| ends.iter().all(|&e| distance(e, p) > 4.0 * tolerance));
            if let Some(at) = crossing {
                return Err(MeshError::CrossingOutline { name: geometry.regions[a.owner].name.clone(), at });
            }
        }
    }
    Ok(())
}
