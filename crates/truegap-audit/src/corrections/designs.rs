//! Random designs of the paper's space, the same every time, for checks on sensors that no table was made for.
//!
//! Limits: designs whose beads fit, whose gap stays open and whose strain stays within the tables.

use super::{corrected::Corrected, range::halton};
use truegap_core::{Sensor, sensor::Filling};

/// Conductors, platings and insulators of the paper's Table 2, um; a plating of 0 is none.
const COPPER: [f64; 3] = [10.0, 17.0, 34.0];
const TIN: [f64; 3] = [0.0, 5.0, 9.0];
const POLYIMIDE: [f64; 3] = [10.0, 25.0, 75.0];

/// The first `count` designs of a Halton sequence over the paper's Table 2 that the corrected model covers up to full load at 50 degC.
pub fn held_out(like: &Sensor, count: usize) -> Vec<Sensor> {
    (1..4000).filter_map(|i| design(like, i)).filter(covered).take(count).collect()
}

fn covered(sensor: &Sensor) -> bool {
    let fits = sensor.check("held-out design").is_ok();
    fits && Corrected::new(sensor).is_ok_and(|model| model.capacitance_pf(sensor.full_scale, 50.0).is_ok())
}

/// Design number `index`.
fn design(like: &Sensor, index: usize) -> Option<Sensor> {
    let share = |base| halton(index, base);
    let between = |low: f64, high: f64, base| low + (high - low) * share(base);
    let one_of = |list: [f64; 3], base| list[((3.0 * share(base)) as usize).min(2)] * 1e-6;
    let mut sensor = like.clone();
    sensor.name = format!("held-out {index}");
    let rubber = &mut sensor.dielectric.layer;
    rubber.material.young.value = between(0.7e6, 1.5e6, 2);
    rubber.thickness.value = between(150e-6, 210e-6, 3);
    sensor.conductor.thickness.value = one_of(COPPER, 5);
    let tin = one_of(TIN, 7);
    match (&mut sensor.plating, tin > 0.0) {
        (Some(plating), true) => plating.thickness.value = tin,
        (plating, _) => *plating = None,
    }
    sensor.insulator.thickness.value = one_of(POLYIMIDE, 11);
    sensor.diameter.value = between(6e-3, 15e-3, 13);
    let Filling::Beads { count, diameter } = &mut sensor.dielectric.filling else { return None };
    *count = between(50.0, 97.0, 17).round() as u32;
    diameter.value = between(300e-6, 760e-6, 19);
    Some(sensor)
}
