//! Straight lines and circular arcs: where they run, meet and are cut.
//!
//! Only these two; a spline has to be given as arcs or as short lines.

use super::plane::{Point, along, cross, distance, dot, minus, twice_area};
use std::f64::consts::TAU;

/// A circle in the plane (m).
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Circle {
    /// Centre.
    pub centre: Point,
    /// Radius.
    pub radius: f64,
}

impl Circle {
    /// The circle through three points, or `None` where they lie on one line.
    pub fn through(a: Point, b: Point, c: Point) -> Option<Circle> {
        let d = 2.0 * twice_area(a, b, c);
        let (u, v) = (minus(b, a), minus(c, a));
        let (uu, vv) = (dot(u, u), dot(v, v));
        if d.abs() <= 1e-12 * (uu + vv) {
            return None;
        }
        let x = (v[1] * uu - u[1] * vv) / d;
        let y = (u[0] * vv - v[0] * uu) / d;
        Some(Circle { centre: [a[0] + x, a[1] + y], radius: x.hypot(y) })
    }

    /// The point of the circle nearest to `p` (any point of it where `p` is the centre).
    pub fn project(&self, p: Point) -> Point {
        let d = minus(p, self.centre);
        let s = self.radius / d[0].hypot(d[1]).max(f64::MIN_POSITIVE);
        [self.centre[0] + s * d[0], self.centre[1] + s * d[1]]
    }

    fn angle(&self, p: Point) -> f64 {
        let d = minus(p, self.centre);
        d[1].atan2(d[0])
    }
}

/// A directed piece of an outline.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(crate) struct Curve {
    /// Where it starts.
    pub from: Point,
    /// Where it ends.
    pub to: Point,
    /// The circle it runs on and the angle it sweeps (radians, positive counter-clockwise); `None` for a line.
    pub arc: Option<(Circle, f64)>,
}

impl Curve {
    /// A straight line.
    pub fn line(from: Point, to: Point) -> Curve {
        Curve { from, to, arc: None }
    }

    /// The arc from `from` over `via` to `to`; a line where the three are in line.
    pub fn arc(from: Point, via: Point, to: Point) -> Curve {
        let Some(circle) = Circle::through(from, via, to) else {
            return Curve::line(from, to);
        };
        let turn = (circle.angle(to) - circle.angle(from)).rem_euclid(TAU);
        let sweep = if twice_area(from, via, to) > 0.0 { turn } else { turn - TAU };
        Curve { from, to, arc: Some((circle, sweep)) }
    }

    /// Point at the fraction `t` of the way (of the angle, on an arc).
    pub fn point(&self, t: f64) -> Point {
        match self.arc {
            _ if t <= 0.0 => self.from,
            _ if t >= 1.0 => self.to,
            None => along(self.from, self.to, t),
            Some((circle, sweep)) => {
                let angle = circle.angle(self.from) + t * sweep;
                [circle.centre[0] + circle.radius * angle.cos(), circle.centre[1] + circle.radius * angle.sin()]
            }
        }
    }

    /// Fraction of the way at which `p` lies, or `None` where it is farther than `tolerance` from the curve.
    pub fn locate(&self, p: Point, tolerance: f64) -> Option<f64> {
        let t = match self.arc {
            None => {
                let d = minus(self.to, self.from);
                dot(minus(p, self.from), d) / dot(d, d)
            }
            Some((circle, sweep)) => {
                let turn = (circle.angle(p) - circle.angle(self.from)) * sweep.signum();
                let wrapped = turn.rem_euclid(TAU);
                let slack = tolerance / circle.radius;
                let turn = if wrapped > TAU - slack { wrapped - TAU } else { wrapped };
                turn / sweep.abs()
            }
        };
        let t = t.clamp(0.0, 1.0);
        (distance(self.point(t), p) <= tolerance).then_some(t)
    }

    /// The part between two fractions of the way, with the given end points.
    pub fn part(&self, (t0, from): (f64, Point), (t1, to): (f64, Point)) -> Curve {
        Curve { from, to, arc: self.arc.map(|(circle, sweep)| (circle, sweep * (t1 - t0))) }
    }

    /// Points in which two curves meet, shared end points included, overlaps left out.
    pub fn meets(&self, other: &Curve, tolerance: f64) -> Vec<Point> {
        let candidates = match (self.arc, other.arc) {
            (None, None) => line_line(self, other),
            (None, Some((circle, _))) => line_circle(self, circle),
            (Some((circle, _)), None) => line_circle(other, circle),
            (Some((a, _)), Some((b, _))) => circle_circle(a, b),
        };
        candidates.into_iter().filter(|&p| self.locate(p, tolerance).is_some() && other.locate(p, tolerance).is_some()).collect()
    }
}

fn line_line(a: &Curve, b: &Curve) -> Vec<Point> {
    let (u, v) = (minus(a.to, a.from), minus(b.to, b.from));
    let d = cross(u, v);
    if d.abs() <= 1e-12 * (dot(u, u) * dot(v, v)).sqrt() {
        return Vec::new();
    }
    vec![along(a.from, a.to, cross(minus(b.from, a.from), v) / d)]
}

fn line_circle(line: &Curve, circle: Circle) -> Vec<Point> {
    let u = minus(line.to, line.from);
    let w = minus(line.from, circle.centre);
    let (a, b, c) = (dot(u, u), dot(u, w), dot(w, w) - circle.radius * circle.radius);
    let root = b * b - a * c;
    if root < 0.0 {
        // A tangent line misses by rounding: offer the nearest point and let the tolerance decide.
        return vec![along(line.from, line.to, -b / a)];
    }
    let s = root.sqrt();
    [-s, s].into_iter().map(|s| along(line.from, line.to, (s - b) / a)).collect()
}

fn circle_circle(a: Circle, b: Circle) -> Vec<Point> {
    let d = minus(b.centre, a.centre);
    let dd = dot(d, d);
    if dd <= 1e-24 * a.radius * a.radius {
        return Vec::new();
    }
    let s = 0.5 * (1.0 + (a.radius * a.radius - b.radius * b.radius) / dd);
    let h = (a.radius * a.radius / dd - s * s).max(0.0).sqrt();
    let foot = along(a.centre, b.centre, s);
    [-h, h].into_iter().map(|h| [foot[0] - h * d[1], foot[1] + h * d[0]]).collect()
}
