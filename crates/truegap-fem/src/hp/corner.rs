//! Exponents of the singular solutions `d^a` at a corner, from its angles, materials and conditions.
//!
//! An integer exponent belongs to a polynomial in every sector and is no singularity; the least other one decides how far a mesh must be graded.

use super::fan::{Edge, Wedge};
use nalgebra::Complex;
use std::f64::consts::PI;

/// Exponents above this one are left to the degree of the elements.
const LARGEST: f64 = 4.0;
/// Where nothing is known: that of a crack, or of the edge of a thin plate.
const UNKNOWN: f64 = 0.5;
/// Exponents this near to an integer are taken for it.
const INTEGER: f64 = 1e-7;

/// What a physics knows of exponents.
pub(crate) trait Side {
    /// The least exponent of the wedge that is not an integer, or `None` where there is none up to 4.
    fn exponent(&self, wedge: &Wedge) -> Option<f64>;
}

/// Exponents of potentials; permittivity of every region (F/m).
pub(crate) struct Laplace<'a>(pub &'a [f64]);

impl Side for Laplace<'_> {
    /// **Source:** separation of variables; potential and flux are carried from sector to sector.
    fn exponent(&self, wedge: &Wedge) -> Option<f64> {
        let condition = |a: f64| {
            // columns: the solutions that start with potential 1, and with flux 1
            let mut m = [[1.0, 0.0], [0.0, 1.0]];
            for &(angle, region) in &wedge.sectors {
                let e = self.0[region as usize] / self.0[wedge.sectors[0].1 as usize];
                let (s, c) = (a * angle).sin_cos();
                m = m.map(|[u, q]| [c * u + s * q / e, c * q - s * e * u]);
            }
            let Some(ends) = wedge.ends else { return m[0][0] + m[1][1] - 2.0 };
            let [start, end] = ends.map(|e| usize::from(e == Edge::Held));
            m[start][1 - end]
        };
        if wedge.ends.is_some_and(|e| e.contains(&Edge::Other)) {
            return Some(UNKNOWN);
        }
        zeros(condition).find(|a| !is_integer(*a))
    }
}

fn is_integer(a: f64) -> bool {
    (a - a.round()).abs() < INTEGER
}

/// Zeros of a function in (0, 4], those where it touches zero without crossing included.
fn zeros(f: impl Fn(f64) -> f64) -> impl Iterator<Item = f64> {
    let step = 1e-2;
    let at = move |k: usize| (k as f64 + 0.37) * step;
    let mut known = [at(0), at(1)].map(&f);
    (0..(LARGEST / step) as usize).filter_map(move |k| {
        let [a, b, c] = [k, k + 1, k + 2].map(at);
        let [fa, fb, fc] = [known[0], known[1], f(c)];
        known = [fb, fc];
        if fa * fb <= 0.0 {
            return Some(bisected(&f, [a, b]));
        }
        let touches = fb * fc > 0.0 && fb.abs() < fa.abs().min(fc.abs());
        touches.then(|| lowest(&|x| f(x).abs(), [a, c])).filter(|low| f(*low).abs() < 1e-9)
    })
}

fn bisected(f: &impl Fn(f64) -> f64, [mut a, mut b]: [f64; 2]) -> f64 {
    let sign = f(a) > 0.0;
    for _ in 0..60 {
        let c = 0.5 * (a + b);
        if (f(c) > 0.0) == sign { a = c } else { b = c }
    }
    0.5 * (a + b)
}

fn lowest(f: &impl Fn(f64) -> f64, [mut a, mut b]: [f64; 2]) -> f64 {
    let golden = 0.381_966_011_250_105;
    for _ in 0..60 {
        let (c, d) = (a + golden * (b - a), b - golden * (b - a));
        if f(c) < f(d) { b = d } else { a = c }
    }
    0.5 * (a + b)
}

/// Exponents of displacements in plane strain, to which axisymmetric bodies come near their corners; Poisson's ratio of every region.
pub(crate) struct Williams<'a>(pub &'a [f64]);

impl Side for Williams<'_> {
    /// One material; of several, and where a condition is mixed, the exponent is taken to be 1/2.
    fn exponent(&self, wedge: &Wedge) -> Option<f64> {
        let (&[(angle, region)], Some(ends)) = (wedge.sectors.as_slice(), wedge.ends) else { return Some(UNKNOWN) };
        let kappa = 3.0 - 4.0 * self.0[region as usize];
        match ends {
            [Edge::Other, _] | [_, Edge::Other] => Some(UNKNOWN),
            [Edge::Mirror, Edge::Mirror] => (!is_integer(PI / angle)).then_some(UNKNOWN),
            [Edge::Mirror, end] | [end, Edge::Mirror] => williams(2.0 * angle, [end, end], kappa),
            ends => williams(angle, ends, kappa),
        }
    }
}

/// Least real part, not an integer, of the exponents of a wedge of the angle (rad) with `kappa = 3 - 4 nu`.
///
/// | ends | condition |
/// |---|---|
/// | free, free | `sin^2(a w) = a^2 sin^2 w` |
/// | held, held | `kappa^2 sin^2(a w) = a^2 sin^2 w` |
/// | held, free | `kappa sin^2(a w) = (1 + kappa)^2 / 4 - a^2 sin^2 w` |
///
/// **Source:** Williams, J. Appl. Mech. 19 (1952) 526, table of conditions for plane strain.
fn williams(angle: f64, ends: [Edge; 2], kappa: f64) -> Option<f64> {
    let free = ends.iter().filter(|e| **e == Edge::Free).count();
    let [k, constant, sign] = match free {
        2 => [1.0, 0.0, 1.0],
        0 => [kappa * kappa, 0.0, 1.0],
        _ => [kappa, 0.25 * (1.0 + kappa) * (1.0 + kappa), -1.0],
    };
    let s = angle.sin() * angle.sin();
    let f = |a: Complex<f64>| {
        let (sine, cosine) = ((a * angle).sin(), (a * angle).cos());
        (sine * sine * k - a * a * (sign * s) - constant, sine * cosine * (2.0 * angle * k) - a * (2.0 * sign * s))
    };
    let mut least: Option<f64> = None;
    for start in (0..160).map(|i| Complex::new(0.05 + LARGEST * f64::from(i / 8) / 20.0, 0.25 * f64::from(i % 8))) {
        let mut a = start;
        for _ in 0..60 {
            let (value, slope) = f(a);
            let step = value / slope;
            a -= step;
            if !(step.norm_sqr() > 1e-30 * a.norm_sqr()) {
                break;
            }
        }
        let found = f(a).0.norm() < 1e-9 && a.re > 1e-3 && a.re <= LARGEST;
        // at an integer free ends have rigid motions and uniform stress; double zeros are met to half of the digits only
        let regular = a.im.abs() < 1e-5 && (a.re - a.re.round()).abs() < 1e-5;
        if found && !regular && least.is_none_or(|l| a.re < l) {
            least = Some(a.re);
        }
    }
    least
}

#[cfg(test)]
mod tests {
    use super::*;

    fn wedge(sectors: &[(f64, u16)], ends: [Edge; 2]) -> Wedge {
        Wedge { sectors: sectors.to_vec(), ends: Some(ends) }
    }

    #[test]
    fn potentials_have_the_exponents_of_the_books() {
        let one = Laplace(&[1.0, 1.0]);
        let held = [Edge::Held; 2];
        for (angle, ends, expected) in [
            (2.0 * PI, held, Some(0.5)),
            (1.5 * PI, held, Some(2.0 / 3.0)),
            (1.5 * PI, [Edge::Free; 2], Some(2.0 / 3.0)),
            (PI, [Edge::Held, Edge::Free], Some(0.5)),
            (1.5 * PI, [Edge::Held, Edge::Free], Some(1.0 / 3.0)),
            (PI, held, None),
            (0.5 * PI, [Edge::Held, Edge::Free], None),
        ] {
            let found = one.exponent(&wedge(&[(angle, 0)], ends));
            match expected {
                None => assert_eq!(found, None, "{angle} {ends:?}"),
                Some(a) => assert!((found.unwrap_or(f64::NAN) - a).abs() < 1e-8, "{angle} {ends:?}: {found:?}"),
            }
        }
    }

    #[test]
    fn a_corner_of_dielectric_in_another_has_its_exponent() {
        // A right angle of permittivity e in one of 1: tan(a pi / 4) tan(3 a pi / 4) = -e or -1 / e, the field even or odd about the diagonal.
        for e in [0.2, 5.0, 40.0] {
            let two = Laplace(&[e, 1.0]);
            let found = two.exponent(&Wedge { sectors: vec![(0.5 * PI, 0), (1.5 * PI, 1)], ends: None }).unwrap_or(f64::NAN);
            let left = |a: f64| (a * PI / 4.0).tan() / (a * 3.0 * PI / 4.0).tan();
            assert!(found > 0.5 && found < 1.0, "{found}");
            let off = [-e, -1.0 / e].map(|r| (left(found) - r).abs() / r.abs());
            assert!(off[0].min(off[1]) < 1e-6, "{found}: {off:?}");
        }
    }

    #[test]
    fn rubber_has_the_exponents_of_williams() {
        let of = |nu: f64, angle: f64, ends: [Edge; 2]| Williams(&[nu]).exponent(&wedge(&[(angle, 0)], ends));
        // crack, and a free right angle outwards and inwards (0.5445: Williams 1952)
        assert!((of(0.3, 2.0 * PI, [Edge::Free; 2]).unwrap_or(f64::NAN) - 0.5).abs() < 1e-7);
        assert!((of(0.3, 1.5 * PI, [Edge::Free; 2]).unwrap_or(f64::NAN) - 0.544_484).abs() < 1e-5);
        assert!((of(0.3, 0.5 * PI, [Edge::Free; 2]).unwrap_or(f64::NAN) - 2.739_593).abs() < 1e-5);
        // bonded and free at a right angle: 0.711 for nu = 0.3, 0.595 for an incompressible body
        assert!((of(0.3, 0.5 * PI, [Edge::Held, Edge::Free]).unwrap_or(f64::NAN) - 0.711_17).abs() < 1e-4);
        assert!((of(0.5, 0.5 * PI, [Edge::Free, Edge::Held]).unwrap_or(f64::NAN) - 0.594_6).abs() < 1e-3);
        assert_eq!(of(0.49, PI, [Edge::Held; 2]), None);
        assert_eq!(of(0.49, 0.5 * PI, [Edge::Held, Edge::Mirror]), None);
        // nothing is known of two materials
        assert_eq!(of(0.49, PI, [Edge::Other, Edge::Free]), Some(0.5));
    }
}
