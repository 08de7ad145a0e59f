//! A recording of the S15 as finite elements have it, in the analytic model's stead: bonded, heated and loaded beads with the field around them, field at the
//! rims, the electrode on its beads. No table and no equation of the diagnosis takes part.
//!
//! `cargo run -p truegap-audit --example bonded_recording > validation/recordings/bonded/recording.csv` (a quarter of an hour)
//!
//! Limits: noise is white; the sensor has its nominal sizes, and its silicone the modulus given below.

use rand::SeedableRng;
use rand_chacha::ChaCha8Rng;
use rand_distr::{Distribution, Normal};
use rayon::prelude::*;
use truegap_audit::AuditError;
use truegap_audit::reference::{CellDisc, FlatCells};
use truegap_core::{Curve, Sensor, sensor::builtin_sensors};

/// Loads of the finite elements, as shares of the full one: close where a load begins to press the rim flat.
const LOADS: [f64; 9] = [0.0, 0.02, 0.06, 0.12, 0.25, 0.4, 0.6, 0.8, 1.0];
/// Their temperatures, degrees Celsius.
const CELSIUS: [f64; 4] = [20.0, 30.0, 40.0, 50.0];
/// Rows of a run, and the time between two, s.
const ROWS: (usize, f64) = (240, 2.0);
/// Noise of reading (pF), load (N) and temperature (K).
const NOISE: [f64; 3] = [0.002, 0.002, 0.02];
/// What the drawn silicone has of the modulus in the sensor's file.
const MODULUS: f64 = 1.06;

fn main() -> Result<(), Box<dyn std::error::Error>> {
    let mut sensor = builtin_sensors()[0].sensor()?;
    sensor.dielectric.layer.material.young.value *= MODULUS;
    let grid = grid(&sensor)?;
    let random = &mut ChaCha8Rng::seed_from_u64(20_26);
    let [reading, load, heat] = NOISE.map(|sd| Normal::new(0.0, sd));
    let (reading, load, heat) = (reading?, load?, heat?);
    println!("run,time_s,force_n,temperature_c,capacitance_pf");
    for (run, course) in COURSES.iter().enumerate() {
        for row in 0..ROWS.0 {
            let along = row as f64 / ROWS.0 as f64;
            let (share, celsius) = (course.load.at(along), course.celsius.at(along));
            let exact = capacitance(&grid, share, celsius) + reading.sample(random);
            let time = (run * (ROWS.0 + 60) + row) as f64 * ROWS.1;
            let (force, warm) = (share * sensor.full_scale + load.sample(random), celsius + heat.sample(random));
            println!("{},{time:.1},{force:.4},{warm:.3},{exact:.4}", run + 1);
        }
    }
    Ok(())
}

/// What is done to the sensor in a run.
struct Course {
    load: Zigzag,
    celsius: Zigzag,
}

/// Between two values there and back, so many times.
struct Zigzag {
    low: f64,
    high: f64,
    times: f64,
}

impl Zigzag {
    const fn new(low: f64, high: f64, times: f64) -> Self {
        Self { low, high, times }
    }

    const fn still(value: f64) -> Self {
        Self::new(value, value, 0.0)
    }

    /// Value at a share of the run; a tenth of rest at either end.
    fn at(&self, along: f64) -> f64 {
        let moving = ((along - 0.1) / 0.8).clamp(0.0, 1.0);
        let phase = (moving * self.times).fract();
        self.low + (self.high - self.low) * (1.0 - (2.0 * phase - 1.0).abs())
    }
}

const COURSES: [Course; 6] = [
    Course { load: Zigzag::new(0.0, 1.0, 2.0), celsius: Zigzag::still(22.0) },
    Course { load: Zigzag::still(0.0), celsius: Zigzag::new(21.0, 49.0, 1.0) },
    Course { load: Zigzag::still(0.6), celsius: Zigzag::new(21.0, 49.0, 1.0) },
    Course { load: Zigzag::new(0.0, 1.0, 2.0), celsius: Zigzag::still(48.0) },
    Course { load: Zigzag::new(0.0, 0.5, 3.0), celsius: Zigzag::still(35.0) },
    Course { load: Zigzag::new(0.0, 1.0, 1.0), celsius: Zigzag::still(22.0) },
];

/// Capacitance over load, pF, one curve a temperature.
fn grid(sensor: &Sensor) -> Result<Vec<Curve>, AuditError> {
    let disc = CellDisc::new(FlatCells::new(sensor, 1e-6)?)?;
    let exact = |force: f64, celsius: f64| disc.at(force, celsius).map(|state| state.capacitance_pf);
    let points: Vec<(f64, f64)> = CELSIUS.iter().flat_map(|&c| LOADS.map(|l| (l, c))).collect();
    let values = points.par_iter().map(|&(l, c)| exact(l * sensor.full_scale, c)).collect::<Result<Vec<_>, _>>()?;
    for ((load, celsius), value) in points.iter().zip(&values) {
        eprintln!("{load} of full load, {celsius} degC: {value:.5} pF");
    }
    let curve = |row: &[f64]| Curve {
        id: "capacitance".into(),
        says: "finite elements".into(),
        argument: "load over full load".into(),
        argument_unit: "1".into(),
        value: "capacitance".into(),
        value_unit: "pF".into(),
        points: LOADS.iter().zip(row).map(|(l, v)| [*l, *v]).collect(),
        accuracy: 1e-5,
    };
    Ok(values.chunks(LOADS.len()).map(curve).collect())
}

/// Lagrange's cubic over the temperatures, of the curves over load.
fn capacitance(grid: &[Curve], share: f64, celsius: f64) -> f64 {
    let weight = |i: usize| {
        let others = CELSIUS.iter().enumerate().filter(|(j, _)| *j != i);
        others.map(|(_, c)| (celsius - c) / (CELSIUS[i] - c)).product::<f64>()
    };
    grid.iter().enumerate().map(|(i, curve)| weight(i) * curve.at(share)).sum()
}
