//! A heated plate bonded to rings of springs, with nothing below it between them: thin plates in one variable.
//!
//! Limits: small deflection, one stiffness for all rings, springs that push and pull (Winkler), no shear in plate or rings. A load plate on it is in
//! [`super::plate_contact`].

use super::banded::Banded;
use super::columns::columns;
use super::rings::Ring;
use std::f64::consts::TAU;

/// A plate on rings.
#[derive(Clone, Debug, PartialEq)]
pub struct RingPlate {
    /// bending stiffness, N m
    pub bending: f64,
    /// Poisson's ratio of the plate
    pub poisson: f64,
    /// radius, m
    pub radius: f64,
    /// stiffness of the rings per their own area, Pa/m
    pub stiffness: f64,
    /// modulus of the rings against tilting over that against shortening: 1 for springs, less for rubber that can flow to the other side
    pub tilt: f64,
    /// where they are, from the axis outwards
    pub rings: Vec<Ring>,
}

/// Shape of a plate: heights and slopes at some radii, cubic between them.
#[derive(Clone, Debug, PartialEq)]
pub struct Bent {
    /// distances from the axis, m
    pub radii: Vec<f64>,
    /// height (m) and slope at each
    pub values: Vec<[f64; 2]>,
}

/// Elements to the narrowest ring, and to the radius where that makes fewer; as long ones between the rings.
const PARTS: f64 = 4.0;
const MOST: f64 = 100.0;
/// Gauss's points and weights on 0 to 1.
const GAUSS: [(f64, f64); 4] = [
    (0.069_431_844_202_973_71, 0.173_927_422_568_726_93),
    (0.330_009_478_207_571_87, 0.326_072_577_431_273_07),
    (0.669_990_521_792_428_1, 0.326_072_577_431_273_07),
    (0.930_568_155_797_026_3, 0.173_927_422_568_726_93),
];
impl RingPlate {
    /// Shape of the plate where it would have `curvature` (1/m) if it were free and `rim_force` (N) presses on its rim: the least of
    ///
    /// $$ \int \tfrac{D}{2} \left[ w''^2 + 2 \nu w'' \tfrac{w'}{r} + \tfrac{w'^2}{r^2} \right] - D (1 + \nu) \kappa \left( w'' + \tfrac{w'}{r} \right)
    ///    + \tfrac{k(r)}{2} w^2 \; 2 \pi r\,dr + F w(R) $$
    ///
    /// over cubic splines of one element or more a ring, by Gauss's rule.
    ///
    /// | symbol | argument    | unit |
    /// |--------|-------------|------|
    /// | D, ν, k | `self`     | N m, -, Pa/m (0 between the rings) |
    /// | κ      | `curvature` | 1/m  |
    /// | F      | `rim_force` | N    |
    ///
    /// **Source:** Timoshenko & Woinowsky-Krieger, Theory of Plates and Shells, art. 57, as an energy. **Accuracy:**
    /// `one_ring_that_covers_all_is_the_closed_form`, 1e-4 of the rim.
    pub fn bent(&self, curvature: f64, rim_force: f64) -> Bent {
        let radii = self.radii();
        let mut system = self.system(&radii, curvature, 0.0);
        let rim = 2 * (radii.len() - 1);
        system.right[rim] -= rim_force / TAU;
        Bent::of(radii, &system.solved())
    }

    /// Equations for heights and slopes at the radii; the rings push with `push` (Pa), as forces at the nodes, so that a load plate that
    /// touches at nodes can balance them. The energy is over 2 pi.
    pub(super) fn system(&self, radii: &[f64], curvature: f64, push: f64) -> Banded {
        let mut system = Banded::new(2 * radii.len());
        for (at, ends) in radii.windows(2).enumerate() {
            self.add_element(&mut system, 2 * at, [ends[0], ends[1]], [curvature, push]);
        }
        // no slope on the axis
        system.fix(1, 0.0);
        system
    }

    /// Nodes, m.
    pub(super) fn radii(&self) -> Vec<f64> {
        let mut stops: Vec<f64> = self.rings.iter().flat_map(|r| [r.inner, r.outer]).filter(|&r| r > 0.0).collect();
        stops.push(self.radius);
        stops.sort_by(f64::total_cmp);
        stops.dedup_by(|b, a| *b - *a <= 1e-9 * self.radius);
        let narrow = self.rings.iter().map(|r| r.outer - r.inner).fold(self.radius, f64::min);
        let step = (narrow / PARTS).max(self.radius / MOST);
        columns(&stops, step, 0.2 * step)
    }

    fn add_element(&self, system: &mut Banded, first: usize, [a, b]: [f64; 2], [curvature, push]: [f64; 2]) {
        let length = b - a;
        let middle = 0.5 * (a + b);
        let ring = self.rings.iter().find(|r| r.inner <= middle && middle <= r.outer);
        let (springs, push) = if ring.is_some() { (self.stiffness, push) } else { (0.0, 0.0) };
        // a rigid foot of width b on springs k has the tilting stiffness k b² / 12 an area
        let soft = ring.map_or(0.0, |r| springs * (1.0 - self.tilt) * (r.outer - r.inner).powi(2) / 12.0);
        for (t, weight) in GAUSS {
            let r = a + t * length;
            let area = weight * length * r;
            let [value, slope, bend] = hermite(t, length);
            system.right[first] += area * push * (1.0 - t);
            system.right[first + 2] += area * push * t;
            for i in 0..4 {
                let around = slope[i] / r;
                let heated = self.bending * (1.0 + self.poisson) * curvature * (bend[i] + around);
                system.right[first + i] += area * heated;
                for j in 0..=i {
                    let other = slope[j] / r;
                    let mixed = self.poisson * (bend[i] * other + around * bend[j]);
                    let stretch = self.bending * (bend[i] * bend[j] + mixed + around * other);
                    system.add(
                        first + i,
                        first + j,
                        area * (stretch + springs * value[i] * value[j] - soft * slope[i] * slope[j]),
                    );
                }
            }
        }
    }
}

impl Bent {
    pub(super) fn of(radii: Vec<f64>, values: &[f64]) -> Self {
        Self { values: values.chunks(2).map(|v| [v[0], v[1]]).collect(), radii }
    }

    /// Mean over the disc of a function of radius (m) and height (m).
    pub fn mean_of(&self, f: impl Fn(f64, f64) -> f64) -> f64 {
        let element = |(k, ends): (usize, &[f64])| {
            let length = ends[1] - ends[0];
            let nodal = [self.values[k][0], self.values[k][1], self.values[k + 1][0], self.values[k + 1][1]];
            let at = |(t, weight): (f64, f64)| {
                let height: f64 = hermite(t, length)[0].iter().zip(nodal).map(|(n, v)| n * v).sum();
                let radius = ends[0] + t * length;
                weight * length * radius * f(radius, height)
            };
            GAUSS.into_iter().map(at).sum::<f64>()
        };
        let rim = self.radii.last().copied().unwrap_or(f64::NAN);
        2.0 * self.radii.windows(2).enumerate().map(element).sum::<f64>() / (rim * rim)
    }

    /// Mean over the disc of the sum of both curvatures, 1/m.
    ///
    /// $$ \frac{1}{\pi R^2} \int \nabla^2 w\,dA = \frac{2 w'(R)}{R} $$
    pub fn mean_bending(&self) -> f64 {
        let (Some(&rim), Some(last)) = (self.radii.last(), self.values.last()) else { return f64::NAN };
        2.0 * last[1] / rim
    }

    /// Height at a distance from the axis (m), m.
    pub fn height(&self, radius: f64) -> f64 {
        let k = self.radii.partition_point(|x| *x < radius).clamp(1, self.radii.len() - 1);
        let length = self.radii[k] - self.radii[k - 1];
        let n = hermite((radius - self.radii[k - 1]) / length, length)[0];
        let [a, b] = [self.values[k - 1], self.values[k]];
        n[0] * a[0] + n[1] * a[1] + n[2] * b[0] + n[3] * b[1]
    }

    /// Height at the rim, m.
    pub fn rim(&self) -> f64 {
        self.values.last().map_or(f64::NAN, |v| v[0])
    }
}

/// Values, slopes and second derivatives of the four cubics of an element: height and slope at its left end, then at its right one.
fn hermite(t: f64, length: f64) -> [[f64; 4]; 3] {
    let u = 1.0 - t;
    [
        [u * u * (1.0 + 2.0 * t), length * t * u * u, t * t * (3.0 - 2.0 * t), -length * t * t * u],
        [-6.0 * t * u / length, u * (1.0 - 3.0 * t), 6.0 * t * u / length, t * (3.0 * t - 2.0)],
        [
            (12.0 * t - 6.0) / (length * length),
            (6.0 * t - 4.0) / length,
            (6.0 - 12.0 * t) / (length * length),
            (6.0 * t - 2.0) / length,
        ],
    ]
}
