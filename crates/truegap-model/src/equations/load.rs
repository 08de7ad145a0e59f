//! What a load does to beads and insulator: (11)-(15).
//!
//! Limits: frictionless beads of one Poisson's ratio; compressive strain below 1, tension above the strain at which a bead would neck without end.

use super::plates::Compression;
use pulp::Arch;
use rayon::prelude::*;

/// How a bead carries load: bulging with its Poisson's ratio, stiffening with strain.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct BeadLaw {
    /// Poisson's ratio; 0 for a dielectric that cannot spread
    pub poisson: f64,
    /// `[a, b]`: stress at strain e is E e (1 + a e + b e²); zeros for the paper's beads
    pub stiffening: [f64; 2],
}

impl BeadLaw {
    /// Load over E A at a strain, and its derivative.
    #[inline(always)]
    fn reduced_load(self, strain: f64) -> (f64, f64) {
        let [a, b] = self.stiffening;
        let spread = 1.0 + self.poisson * strain;
        let stiff = 1.0 + strain * (a + strain * b);
        let load = strain * spread * spread * stiff;
        let slope = spread * ((1.0 + 3.0 * self.poisson * strain) * stiff + strain * spread * (a + 2.0 * b * strain));
        (load, slope)
    }
}

/// Bead area under load.
///
/// $$ A(e) = A (1 + \nu e)^2 $$
///
/// | symbol | argument  | unit |
/// |--------|-----------|------|
/// | A      | `area`    | m²   |
/// | ν      | `poisson` | -    |
/// | e      | `strain`, compressive | - |
///
/// **Source:** \[hampson2023\] (11), with e = -ε_Z. **Assumes:** `FREE-SPREADING`. **Accuracy:** four roundings.
pub fn spread_area(area: f64, poisson: f64, strain: f64) -> f64 {
    let spread = 1.0 + poisson * strain;
    area * spread * spread
}

/// Load that brings beads to a compressive strain, over E A.
///
/// $$ \frac{F}{E A} = e (1 + \nu e)^2 (1 + a e + b e^2) $$
///
/// | symbol  | argument | unit |
/// |---------|----------|------|
/// | ν, a, b | `law`    | -    |
/// | e       | `strain`, compressive | - |
///
/// **Source:** \[hampson2023\] (12), corrected; the factor with a and b is own, 1 in the paper. **Assumes:** `FREE-SPREADING`. **Accuracy:** a few roundings.
pub fn reduced_load(law: BeadLaw, strain: f64) -> f64 {
    law.reduced_load(strain).0
}

/// Derivative of [`reduced_load`] by the strain.
///
/// $$ (1 + \nu e) \left[(1 + 3 \nu e)(1 + a e + b e^2) + e (1 + \nu e)(a + 2 b e)\right] $$
///
/// | symbol  | argument | unit |
/// |---------|----------|------|
/// | ν, a, b | `law`    | -    |
/// | e       | `strain`, compressive | - |
///
/// **Source:** derivative of [`reduced_load`]. **Accuracy:** a few roundings.
pub fn reduced_load_slope(law: BeadLaw, strain: f64) -> f64 {
    law.reduced_load(strain).1
}

/// Compressive strain of beads under a load; `None` where the beads cannot carry it.
///
/// $$ e (1 + \nu e)^2 (1 + a e + b e^2) = q, \qquad q = \frac{F}{E A} $$
///
/// | symbol  | argument       | unit |
/// |---------|----------------|------|
/// | q       | `reduced_load` | -    |
/// | ν, a, b | `law`          | -    |
///
/// The branch that starts at e = 0 for q = 0. A strain of 1 or more is returned as it is: the caller knows where the gap closes. Loads may be
/// slightly negative (noise of a load cell about zero).
///
/// **Source:** \[hampson2023\] (12), corrected to `E ν² ε³ - 2 E ν ε² + E ε + F/A = 0`; see `docs/errata.md`. **Assumes:** `FREE-SPREADING`.
/// **Accuracy:** 2e-15 relative, `the_strain_solves_its_equation`.
pub fn compressive_strain(reduced_load: f64, law: BeadLaw) -> Option<f64> {
    let nu = law.poisson;
    let q = reduced_load;
    if nu == 0.0 && law.stiffening == [0.0, 0.0] {
        // the equation is e = q
        return q.is_finite().then_some(q);
    }
    newton(q, first_guess(q, law), law).or_else(|| bisection(q, law))
}

/// Rows that [`compressive_strains`] solves side by side.
const ABREAST: usize = 16;
/// Such blocks that one processor solves at a time where another one is idle.
const SHARE: usize = 64;

/// [`compressive_strain`] of each load, to the last bit; NaN where the beads cannot carry it.
///
/// Sixteen rows take their steps side by side, which spares most of what a row alone waits for; those that do not settle are solved by themselves.
pub fn compressive_strains(reduced_loads: &[f64], law: BeadLaw) -> Vec<f64> {
    let alone = |q: &f64| compressive_strain(*q, law).unwrap_or(f64::NAN);
    if law.poisson == 0.0 && law.stiffening == [0.0, 0.0] {
        return reduced_loads.iter().map(alone).collect();
    }
    let plain = law.stiffening == [0.0, 0.0];
    let mut strains = vec![0.0; reduced_loads.len()];
    let solve = |(loads, strains): (&[f64], &mut [f64])| {
        let Ok(block) = <&[f64; ABREAST]>::try_from(loads) else {
            return loads.iter().zip(strains).for_each(|(q, strain)| *strain = alone(q));
        };
        // wide registers where there are any: the same operations, so the same digits
        let (found, settled) = Arch::new().dispatch(
            #[inline(always)]
            || newton_abreast(block, law),
        );
        for (k, (q, strain)) in block.iter().zip(strains).enumerate() {
            *strain = if settled[k] > 0.0 && (plain || rises_to(found[k], law)) { found[k] } else { alone(q) };
        }
    };
    reduced_loads.par_chunks(ABREAST).zip(strains.par_chunks_mut(ABREAST)).with_min_len(SHARE).for_each(solve);
    strains
}

/// Newton's iteration of [`newton`] for many loads: where each has come to, and 1 where it has settled on the branch through zero, else 0.
#[inline(always)]
fn newton_abreast(q: &[f64; ABREAST], law: BeadLaw) -> ([f64; ABREAST], [f64; ABREAST]) {
    let mut strain = q.map(|q| first_guess(q, law));
    let (mut done, mut rising) = ([0.0; ABREAST], [0.0; ABREAST]);
    for _ in 0..6 {
        for k in 0..ABREAST {
            let (load, slope) = law.reduced_load(strain[k]);
            let step = (load - q[k]) / slope;
            let next = strain[k] - step;
            let open = done[k] == 0.0;
            rising[k] = if open { slope } else { rising[k] };
            done[k] = if open && step.abs() <= SETTLED * next.abs() { 1.0 } else { done[k] };
            strain[k] = if open { next } else { strain[k] };
        }
        if done.iter().sum::<f64>() == ABREAST as f64 {
            break;
        }
    }
    let settled = |k: usize| {
        let on_branch = rising[k] > 0.0 && 1.0 + 3.0 * law.poisson * strain[k] > 0.0 && strain[k].is_finite();
        if on_branch { done[k] } else { 0.0 }
    };
    (strain, std::array::from_fn(settled))
}

/// A step below this share of the strain ends the iteration: it leaves an error of its square.
const SETTLED: f64 = 1e-8;

/// Padé form of the inverse series q - 2 nu q^2 + 7 nu^2 q^3 - ...: 7e-7 at nu q = 0.1, 1e-3 at 0.5.
fn first_guess(q: f64, law: BeadLaw) -> f64 {
    let x = law.poisson * q;
    q * (1.0 + x * (8.3 + x * (16.2 + 3.8 * x))) / (1.0 + x * (10.3 + x * (29.8 + 21.3 * x)))
}

/// Newton's iteration; `None` where it does not settle on the branch through zero.
fn newton(q: f64, start: f64, law: BeadLaw) -> Option<f64> {
    let mut strain = start;
    for _ in 0..12 {
        let (load, slope) = law.reduced_load(strain);
        let step = (load - q) / slope;
        strain -= step;
        if step.abs() <= SETTLED * strain.abs() {
            let on_branch = slope > 0.0 && 1.0 + 3.0 * law.poisson * strain > 0.0 && strain.is_finite();
            let monotone = law.stiffening == [0.0, 0.0] || rises_to(strain, law);
            return (on_branch && monotone).then_some(strain);
        }
    }
    (q == 0.0).then_some(0.0)
}

/// Whether load rises all the way from no strain to `strain`, so that the root is the first one.
fn rises_to(strain: f64, law: BeadLaw) -> bool {
    (1..=8).fold(true, |rises, i| rises & (law.reduced_load(strain * f64::from(i) / 8.0).1 > 0.0))
}

/// The first root away from zero, by marching and halving; slow and sure.
fn bisection(q: f64, law: BeadLaw) -> Option<f64> {
    const STEP: f64 = 1.0 / 64.0;
    let direction = q.signum();
    if !q.is_finite() {
        return None;
    }
    let mut low = 0.0;
    loop {
        let high = low + direction * STEP;
        let (load, slope) = law.reduced_load(high);
        if (load - q) * direction >= 0.0 {
            return Some(halve(low, high, |e| (law.reduced_load(e).0 - q) * direction));
        }
        if slope <= 0.0 || high.abs() > 4.0 {
            return None;
        }
        low = high;
    }
}

/// Root between `low` (negative value) and `high` (not negative).
fn halve(mut low: f64, mut high: f64, value: impl Fn(f64) -> f64) -> f64 {
    for _ in 0..80 {
        let middle = 0.5 * (low + high);
        if value(middle) >= 0.0 { high = middle } else { low = middle }
    }
    high
}

/// Left-hand side of the printed cubic for the strain, over E.
///
/// $$ \nu^2 \epsilon_Z^3 - 2 \nu \epsilon_Z^2 - \epsilon_Z + q $$
///
/// | symbol | argument       | unit |
/// |--------|----------------|------|
/// | ε_Z    | `strain`, positive in tension | - |
/// | q      | `reduced_load` | -    |
/// | ν      | `poisson`      | -    |
///
/// **Source:** \[hampson2023\] (12), as printed; the sign of its linear term is wrong.
pub fn load_cubic_as_printed(strain: f64, reduced_load: f64, poisson: f64) -> f64 {
    let e = strain;
    poisson * poisson * e * e * e - 2.0 * poisson * e * e - e + reduced_load
}

/// Root of the printed cubic that starts at zero load, positive in tension: a load *opens* the gap; `None` where Newton's iteration finds none.
///
/// | symbol | argument       | unit |
/// |--------|----------------|------|
/// | q      | `reduced_load` | -    |
/// | ν      | `poisson`      | -    |
///
/// **Source:** \[hampson2023\] (12), as printed. Its magnitude differs from the corrected strain by 0.11 % at 0.05, 0.65 % at 0.13 and 2.8 % at 0.3.
pub fn strain_as_printed(reduced_load: f64, poisson: f64) -> Option<f64> {
    let mut e = reduced_load / (1.0 + 2.0 * poisson * reduced_load);
    for _ in 0..50 {
        let slope = 3.0 * poisson * poisson * e * e - 4.0 * poisson * e - 1.0;
        let step = load_cubic_as_printed(e, reduced_load, poisson) / slope;
        e -= step;
        if step.abs() <= 1e-15 * e.abs() || e == 0.0 {
            return Some(e);
        }
    }
    None
}

/// Height of the beads under load.
///
/// $$ d = d(T) (1 - e) $$
///
/// | symbol | argument | unit |
/// |--------|----------|------|
/// | d(T)   | `height` | m    |
/// | e      | `strain`, compressive | - |
///
/// **Source:** \[hampson2023\] (13), with e = -ε_Z. **Accuracy:** two roundings.
pub fn loaded_height(height: f64, strain: f64) -> f64 {
    height * (1.0 - strain)
}

/// Thickness of the insulator under load.
///
/// $$ d = d(T) (1 - p / E) $$
///
/// | symbol | argument      | unit |
/// |--------|---------------|------|
/// | d(T)   | `thickness`   | m    |
/// | p, E   | `compression` | Pa   |
///
/// **Source:** \[hampson2023\] (14), with p = -σ. **Assumes:** `LINEAR-SOLID`. **Accuracy:** three roundings.
pub fn loaded_thickness(thickness: f64, compression: Compression) -> f64 {
    thickness * (1.0 - compression.strain())
}

/// The layers between the electrodes, m.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Layers {
    /// beads and air, m
    pub beads: f64,
    /// insulator, m
    pub insulator: f64,
}

/// Mean separation of the electrodes.
///
/// $$ d_{average} = d_{silicone} + d_{polyimide} $$
///
/// | symbol | argument | unit |
/// |--------|----------|------|
/// | d      | `layers` | m    |
///
/// **Source:** \[hampson2023\] (15). **Accuracy:** one rounding.
pub fn mean_separation(layers: Layers) -> f64 {
    layers.beads + layers.insulator
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn strains_side_by_side_are_those_of_each_row_to_the_last_bit() {
        let mut loads: Vec<f64> = (-20..60).map(|i| 0.02 * f64::from(i)).collect();
        loads.extend([1e-300, -0.2, 3.0, 40.0, -5.0, f64::NAN, f64::INFINITY, 0.3]);
        for (poisson, stiffening) in
            [(0.48, [0.0; 2]), (0.3, [0.4, 2.0]), (0.0, [-0.9, 0.2]), (0.0, [0.0; 2]), (0.48, [-1.5, 0.3])]
        {
            let law = BeadLaw { poisson, stiffening };
            let found = compressive_strains(&loads, law);
            for (q, found) in loads.iter().zip(found) {
                assert_eq!(compressive_strain(*q, law).unwrap_or(f64::NAN).to_bits(), found.to_bits(), "{q} {law:?}");
            }
        }
    }

    #[test]
    fn what_cannot_spread_strains_as_newtons_iteration_finds_to_the_last_bit() {
        let law = BeadLaw::default();
        for q in [0.0, 1e-300, 0.3, -0.2, 1.0, 7.0, f64::INFINITY, f64::NAN] {
            assert_eq!(compressive_strain(q, law), newton(q, q, law).or_else(|| bisection(q, law)), "{q}");
        }
    }
}
