//! Vector arithmetic in the plane, for points given as `[first, second]` in metres.

/// A point or vector of the plane.
pub type Point = [f64; 2];

/// `a - b`.
#[inline]
pub fn minus(a: Point, b: Point) -> Point {
    [a[0] - b[0], a[1] - b[1]]
}

/// Point at the fraction `t` of the way from `a` to `b`.
#[inline]
pub fn along(a: Point, b: Point, t: f64) -> Point {
    [a[0] + t * (b[0] - a[0]), a[1] + t * (b[1] - a[1])]
}

/// Scalar product.
#[inline]
pub fn dot(a: Point, b: Point) -> f64 {
    a[0] * b[0] + a[1] * b[1]
}

/// Third component of the vector product: positive where `b` lies to the left of `a`.
#[inline]
pub fn cross(a: Point, b: Point) -> f64 {
    a[0] * b[1] - a[1] * b[0]
}

/// Euclidean length.
#[inline]
pub fn length(a: Point) -> f64 {
    a[0].hypot(a[1])
}

/// Distance of two points.
#[inline]
pub fn distance(a: Point, b: Point) -> f64 {
    length(minus(a, b))
}

/// Twice the signed area of the triangle `a b c` (positive: counter-clockwise).
#[inline]
pub fn twice_area(a: Point, b: Point, c: Point) -> f64 {
    cross(minus(b, a), minus(c, a))
}

/// Smallest inner angle of a triangle, degrees.
pub fn least_angle_degrees(corners: [Point; 3]) -> f64 {
    (0..3)
        .map(|i| {
            let (a, b, c) = (corners[i], corners[(i + 1) % 3], corners[(i + 2) % 3]);
            let (u, v) = (minus(b, a), minus(c, a));
            cross(u, v).abs().atan2(dot(u, v)).to_degrees()
        })
        .fold(f64::INFINITY, f64::min)
}
