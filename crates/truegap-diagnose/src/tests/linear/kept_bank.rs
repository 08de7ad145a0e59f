//! Under which name a finished recovery bank is kept.

use super::{World, effects::Line, noise};
use crate::{validation::recovery::key::key, whitening::noise_model::NoiseModel};

/// The name, for a base model of one column, in a noise that `change` has changed.
fn name(column: impl Fn(usize) -> f64, change: impl Fn(NoiseModel) -> NoiseModel) -> String {
    let mut world = World::new(2, 12, &[1.0]);
    world.line = Line::with(vec![(0.5, (0..24).map(column).collect())]);
    let y: Vec<f64> = (0..24).map(|row| f64::from(row % 5)).collect();
    let noise = change(noise(&world, &y));
    world.search(&y, |search, _| key(search, &world.inputs, &noise, &[]))
}

/// Programs and tables have the same name and may have the same numbers: a bank of the old one is none of the new one.
#[test]
fn a_bank_is_kept_for_one_base_model_and_one_reading() {
    let kept = name(|row| row as f64, |noise| noise);
    assert_eq!(kept, name(|row| row as f64, |noise| noise));
    // a number about 0 does nothing at the centre of its prior
    assert_ne!(kept, name(|row| row as f64 + if row == 7 { 1e-6 } else { 0.0 }, |noise| noise));
    assert_ne!(kept, name(|row| row as f64, |noise| NoiseModel { step: 0.1, ..noise }));
}
