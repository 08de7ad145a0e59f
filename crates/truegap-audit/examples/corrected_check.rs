//! The corrected model against coupled finite elements: built-in sensors and designs that no table was made for, as a Markdown table.
//!
//! `cargo run -p truegap-audit --example corrected_check [DESIGNS]` (20 designs where no number is given; minutes)

use rayon::prelude::*;
use std::time::Instant;
use truegap_audit::AuditError;
use truegap_audit::corrections::{Corrected, coupled::Coupled, designs::held_out};
use truegap_core::Sensor;
use truegap_core::sensor::builtin_sensors;

/// Loads as shares of the full one, and temperatures, degrees Celsius.
const BUILT_IN: ([f64; 4], [f64; 3]) = ([0.0, 0.25, 0.6, 1.0], [20.0, 35.0, 50.0]);
const HELD_OUT: ([f64; 3], [f64; 2]) = ([0.0, 0.4, 1.0], [20.0, 50.0]);

fn main() -> Result<(), Box<dyn std::error::Error>> {
    let count = std::env::args().nth(1).and_then(|a| a.parse().ok()).unwrap_or(20);
    let built_in = builtin_sensors().iter().take(3).map(|b| b.sensor()).collect::<Result<Vec<_>, _>>()?;
    println!(
        "| sensor | C0 (pF) | span (pF) | greatest strain | largest error (pF) | % of span | points | finite elements (s a point) | corrected (us a point) |"
    );
    println!("|---|---|---|---|---|---|---|---|---|");
    for sensor in &built_in {
        compare(sensor, &BUILT_IN.0, &BUILT_IN.1)?;
    }
    for sensor in held_out(&built_in[0], count) {
        if let Err(error) = compare(&sensor, &HELD_OUT.0, &HELD_OUT.1) {
            println!("| {} | {error} | | | | | | | |", sensor.name);
        }
    }
    Ok(())
}

fn compare(sensor: &Sensor, shares: &[f64], temperatures: &[f64]) -> Result<(), AuditError> {
    let points: Vec<(f64, f64)> =
        temperatures.iter().flat_map(|&t| shares.iter().map(move |&s| (s * sensor.full_scale, t))).collect();
    let (coupled, corrected) = (Coupled::new(sensor, 1e-5)?, Corrected::new(sensor)?);
    let begin = Instant::now();
    let exact = points.par_iter().map(|&(f, t)| coupled.at(f, t)).collect::<Result<Vec<_>, _>>()?;
    let slow = begin.elapsed().as_secs_f64() / points.len() as f64;
    let begin = Instant::now();
    let mut fast = Vec::new();
    for _ in 0..100 {
        fast = points.iter().map(|&(f, t)| corrected.capacitance_pf(f, t)).collect::<Result<Vec<_>, _>>()?;
    }
    let quick = begin.elapsed().as_secs_f64() / (100 * points.len()) as f64;
    let span = exact[shares.len() - 1].capacitance_pf - exact[0].capacitance_pf;
    let errors: Vec<f64> = fast.iter().zip(&exact).map(|(f, e)| f - e.capacitance_pf).collect();
    let worst = errors.iter().fold(0.0f64, |w, e| w.max(e.abs()));
    let strain = exact.iter().map(|e| e.strain).fold(0.0, f64::max);
    println!(
        "| {} | {:.3} | {span:.4} | {strain:.3} | {worst:.5} | {:.3} | {} | {slow:.2} | {:.2} |",
        sensor.name,
        exact[0].capacitance_pf,
        100.0 * worst / span,
        points.len(),
        1e6 * quick
    );
    if std::env::var_os("TRUEGAP_POINTS").is_some() {
        for ((point, e), error) in points.iter().zip(&exact).zip(&errors) {
            println!("    {point:?} {:.5} pF, strain {:.5}, corrected {error:+.5} pF", e.capacitance_pf, e.strain);
        }
    }
    Ok(())
}
