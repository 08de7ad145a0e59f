//! A heated plate bonded to rings of springs, with nothing below it between them: thin plates in one variable.
//!
//! Limits: small deflection, one stiffness for all rings, springs that push and pull (Winkler), no shear in plate or rings.

use super::columns::columns;
use super::section::Ring;

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
    /// where they are, from the axis outwards
    pub rings: Vec<Ring>,
    /// radius up to which something holds the plate flat, m; 0 for nothing
    pub flat_to: f64,
}

/// Shape of a plate: heights and slopes at some radii, cubic between them.
#[derive(Clone, Debug, PartialEq)]
pub struct Bent {
    /// distances from the axis, m
    pub radii: Vec<f64>,
    /// height (m) and slope at each
    pub values: Vec<[f64; 2]>,
}

/// Elements to the narrowest ring; as long ones between the rings.
const PARTS: f64 = 2.0;
/// Stiffness of what holds a plate flat, over that of the rings.
const FLAT: f64 = 1e4;
/// Gauss's points and weights on 0 to 1.
const GAUSS: [(f64, f64); 4] = [
    (0.069_431_844_202_973_71, 0.173_927_422_568_726_93),
    (0.330_009_478_207_571_87, 0.326_072_577_431_273_07),
    (0.669_990_521_792_428_1, 0.326_072_577_431_273_07),
    (0.930_568_155_797_026_3, 0.173_927_422_568_726_93),
];
/// Half the width of the matrix's band: two values a node, two nodes an element.
const BAND: usize = 4;

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
        let mut system = Banded::new(2 * radii.len());
        for (at, ends) in radii.windows(2).enumerate() {
            self.add_element(&mut system, 2 * at, [ends[0], ends[1]], curvature);
        }
        // no slope on the axis; the energy is over 2 pi
        system.hold(1);
        let rim = 2 * (radii.len() - 1);
        system.right[rim] -= rim_force / std::f64::consts::TAU;
        let solved = system.solved();
        Bent { values: solved.chunks(2).map(|v| [v[0], v[1]]).collect(), radii }
    }

    fn radii(&self) -> Vec<f64> {
        let mut stops: Vec<f64> = self.rings.iter().flat_map(|r| [r.inner, r.outer]).filter(|&r| r > 0.0).collect();
        stops.extend([self.flat_to, self.radius].into_iter().filter(|&r| r > 0.0));
        stops.sort_by(f64::total_cmp);
        stops.dedup_by(|b, a| *b - *a <= 1e-9 * self.radius);
        let narrow = self.rings.iter().map(|r| r.outer - r.inner).fold(self.radius, f64::min);
        columns(&stops, narrow / PARTS, 0.2 * narrow / PARTS)
    }

    fn add_element(&self, system: &mut Banded, first: usize, [a, b]: [f64; 2], curvature: f64) {
        let length = b - a;
        let middle = 0.5 * (a + b);
        let held = self.rings.iter().any(|r| r.inner <= middle && middle <= r.outer);
        let springs = if middle < self.flat_to {
            FLAT * self.stiffness
        } else if held {
            self.stiffness
        } else {
            0.0
        };
        for (t, weight) in GAUSS {
            let r = a + t * length;
            let area = weight * length * r;
            let [value, slope, bend] = hermite(t, length);
            for i in 0..4 {
                let around = slope[i] / r;
                system.right[first + i] += area * self.bending * (1.0 + self.poisson) * curvature * (bend[i] + around);
                for j in 0..=i {
                    let other = slope[j] / r;
                    let mixed = self.poisson * (bend[i] * other + around * bend[j]);
                    let stretch = self.bending * (bend[i] * bend[j] + mixed + around * other);
                    system.add(first + i, first + j, area * (stretch + springs * value[i] * value[j]));
                }
            }
        }
    }
}

impl Bent {
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

/// A symmetric system whose entries lie near the diagonal; `rows[i][j]` is the entry in column `i - j`.
struct Banded {
    rows: Vec<[f64; BAND]>,
    right: Vec<f64>,
}

impl Banded {
    fn new(count: usize) -> Self {
        Self { rows: vec![[0.0; BAND]; count], right: vec![0.0; count] }
    }

    /// Adds to an entry of the lower half.
    fn add(&mut self, row: usize, column: usize, value: f64) {
        self.rows[row][row - column] += value;
    }

    /// Makes an unknown nought.
    fn hold(&mut self, unknown: usize) {
        self.rows[unknown] = [0.0; BAND];
        for below in 1..BAND {
            if let Some(row) = self.rows.get_mut(unknown + below) {
                row[below] = 0.0;
            }
        }
        self.rows[unknown][0] = 1.0;
        self.right[unknown] = 0.0;
    }

    /// The solution, by factors L D Lᵀ.
    fn solved(mut self) -> Vec<f64> {
        let count = self.rows.len();
        for i in 0..count {
            for j in (1..BAND.min(i + 1)).rev() {
                let column = i - j;
                let known: f64 =
                    (j + 1..BAND.min(i + 1)).map(|k| self.rows[i][k] * self.rows[column][k - j] * self.rows[i - k][0]).sum();
                self.rows[i][j] = (self.rows[i][j] - known) / self.rows[column][0];
            }
            let own: f64 = (1..BAND.min(i + 1)).map(|k| self.rows[i][k] * self.rows[i][k] * self.rows[i - k][0]).sum();
            self.rows[i][0] -= own;
            let above: f64 = (1..BAND.min(i + 1)).map(|k| self.rows[i][k] * self.right[i - k]).sum();
            self.right[i] -= above;
        }
        let mut x: Vec<f64> = self.right.iter().zip(&self.rows).map(|(b, row)| b / row[0]).collect();
        for i in (0..count).rev() {
            let below: f64 = (1..BAND.min(count - i)).map(|k| self.rows[i + k][k] * x[i + k]).sum();
            x[i] -= below;
        }
        x
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::disc::foundation::Foundation;

    fn plate(rings: Vec<Ring>) -> RingPlate {
        RingPlate { bending: 5e-4, poisson: 0.34, radius: 7.5e-3, stiffness: 1.2e9, rings, flat_to: 0.0 }
    }

    fn zones(count: usize, coverage: f64) -> Vec<Ring> {
        let pitch = 7.5e-3 / count as f64;
        let ring = |j: usize| {
            let margin = 0.5 * (1.0 - coverage) * pitch;
            Ring { inner: pitch * j as f64 + margin, outer: pitch * (j + 1) as f64 - margin }
        };
        (0..count).map(ring).collect()
    }

    #[test]
    fn one_ring_that_covers_all_is_the_closed_form() {
        // many rings that touch each other, so that the elements are small
        let plate = plate(zones(12, 1.0));
        let bent = plate.bent(1.4, 0.0);
        let exact = Foundation { bending: 5e-4, poisson: 0.34, radius: 7.5e-3, stiffness: 1.2e9 }.held(1.4).unwrap();
        let rim = exact.height(7.5e-3);
        assert!((bent.rim() / rim - 1.0).abs() < 1e-4, "{} {rim}", bent.rim());
        for (r, v) in bent.radii.iter().zip(&bent.values) {
            assert!((v[0] - exact.height(*r)).abs() < 1e-4 * rim, "{r}: {} {}", v[0], exact.height(*r));
        }
        // springs push as much as they pull
        assert!(bent.mean_of(|_, w| w).abs() < 1e-4 * rim);
        assert!((bent.mean_of(|_, _| 1.0) - 1.0).abs() < 1e-12);
    }

    #[test]
    fn without_springs_to_speak_of_the_plate_is_the_free_sphere() {
        let mut plate = plate(zones(4, 0.5));
        plate.stiffness = 10.0;
        let bent = plate.bent(1.4, 0.0);
        let sag = bent.rim() - bent.values[0][0];
        assert!((sag / (0.5 * 1.4 * 7.5e-3_f64.powi(2)) - 1.0).abs() < 1e-6, "{sag}");
    }

    #[test]
    fn a_force_on_the_rim_is_carried_by_the_rings_and_does_what_the_curvature_does_to_the_rim() {
        let plate = plate(zones(5, 0.25));
        let (pushed, heated) = (plate.bent(0.0, 2.0), plate.bent(1.4, 0.0));
        let carried = -pushed.mean_of(|r, w| if plate.rings.iter().any(|q| q.inner <= r && r <= q.outer) { w } else { 0.0 });
        let area = std::f64::consts::PI * plate.radius * plate.radius;
        // cubics balance exactly; what is left is rounding in a matrix of stiff, short elements
        let share = carried * plate.stiffness * area / 2.0;
        assert!((share - 1.0).abs() < 1e-7, "{share}");
        // Betti: the rim's fall under the force times the force on it is the work of the thermal moment on the slope of the other.
        let work = plate.bending * (1.0 + plate.poisson) * 1.4 * pushed.mean_bending() * area;
        assert!((work / (-2.0 * heated.rim()) - 1.0).abs() < 1e-7, "{work} {}", heated.rim());
    }

    #[test]
    fn rings_leave_an_overhang_that_curls_and_balance_their_forces() {
        let plate = plate(zones(5, 0.25));
        let bent = plate.bent(1.4, 0.0);
        let held: f64 = plate
            .rings
            .iter()
            .map(|ring| {
                let n = 400;
                let h = (ring.outer - ring.inner) / f64::from(n);
                (0..n).map(|i| ring.inner + h * (f64::from(i) + 0.5)).map(|r| r * h * height(&bent, r)).sum::<f64>()
            })
            .sum();
        let total = bent.rim() * 7.5e-3 * 7.5e-3;
        assert!(held.abs() < 1e-4 * total, "{held} {total}");
        // more than the overhang alone would curl if the last ring held it like a wall, less than the even layer of as stiff springs and the free strip
        let overhang = 7.5e-3 - plate.rings[4].outer;
        let clamped = 0.5 * 1.4 * overhang * overhang;
        let even = Foundation { bending: 5e-4, poisson: 0.34, radius: 7.5e-3, stiffness: 0.25 * 1.2e9 }.held(1.4).unwrap();
        assert!(bent.rim() > clamped && bent.rim() < 2.0 * even.height(7.5e-3), "{} {clamped}", bent.rim());
        assert!(bent.mean_of(|_, w| w) > 0.0);
    }

    fn height(bent: &Bent, r: f64) -> f64 {
        let k = bent.radii.partition_point(|x| *x < r).clamp(1, bent.radii.len() - 1);
        let length = bent.radii[k] - bent.radii[k - 1];
        let n = hermite((r - bent.radii[k - 1]) / length, length)[0];
        let [a, b] = [bent.values[k - 1], bent.values[k]];
        n[0] * a[0] + n[1] * a[1] + n[2] * b[0] + n[3] * b[1]
    }
}
