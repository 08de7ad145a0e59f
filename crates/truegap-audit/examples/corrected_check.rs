//! The corrected model against finite elements: built-in sensors and designs that no table was made for, as a Markdown table.
//!
//! `cargo run -p truegap-audit --example corrected_check [DESIGNS [SKIP]]` (20 designs where no number is given; a quarter of an hour and more; SKIP
//! leaves out the built-in sensors and so many of the first designs)
//!
//! The reference is `truegap_audit::reference::CellDisc`: the disc on rings that push and conduct as the finite elements of the bead cell do, bent by heat and
//! load, the field solved on what that leaves; rim and tail by finite elements. `TRUEGAP_POINTS=1` prints every point.

use rayon::prelude::*;
use std::time::Instant;
use truegap_audit::AuditError;
use truegap_audit::corrections::{Corrected, held_out};
use truegap_audit::reference::{CellDisc, DiscState, FlatCells};
use truegap_core::Sensor;
use truegap_core::sensor::builtin_sensors;

/// Loads as shares of the full one, and temperatures, degrees Celsius.
const BUILT_IN: ([f64; 4], [f64; 3]) = ([0.0, 0.25, 0.6, 1.0], [20.0, 35.0, 50.0]);
const HELD_OUT: ([f64; 3], [f64; 2]) = ([0.0, 0.4, 1.0], [20.0, 50.0]);

fn main() -> Result<(), Box<dyn std::error::Error>> {
    let number = |place: usize, default: usize| std::env::args().nth(place).and_then(|a| a.parse().ok()).unwrap_or(default);
    let (count, skip) = (number(1, 20), number(2, 0));
    let built_in = builtin_sensors().iter().take(3).map(|b| b.sensor()).collect::<Result<Vec<_>, _>>()?;
    println!(
        "| sensor | C0 (pF) | span (pF) | greatest strain | bending, % of span | largest error (pF) | % of span | points | \
         finite elements (s a point) | corrected (us a point) |"
    );
    println!("|---|---|---|---|---|---|---|---|---|---|");
    for sensor in built_in.iter().filter(|_| skip == 0) {
        compare(sensor, &BUILT_IN.0, &BUILT_IN.1)?;
    }
    for sensor in held_out(&built_in[0], skip + count).into_iter().skip(skip) {
        if let Err(error) = compare(&sensor, &HELD_OUT.0, &HELD_OUT.1) {
            println!("| {} | {error} | | | | | | | | |", sensor.name);
        }
    }
    Ok(())
}

fn compare(sensor: &Sensor, shares: &[f64], temperatures: &[f64]) -> Result<(), AuditError> {
    let points: Vec<(f64, f64)> =
        temperatures.iter().flat_map(|&t| shares.iter().map(move |&s| (s * sensor.full_scale, t))).collect();
    let (disc, corrected) = (CellDisc::new(FlatCells::new(sensor, 1e-5)?)?, Corrected::new(sensor)?);
    let begin = Instant::now();
    let exact = points.par_iter().map(|&(f, t)| disc.at(f, t)).collect::<Result<Vec<_>, _>>()?;
    let slow = begin.elapsed().as_secs_f64() / points.len() as f64;
    let begin = Instant::now();
    let mut fast = Vec::new();
    for _ in 0..100 {
        fast = points.iter().map(|&(f, t)| corrected.capacitance_pf(f, t)).collect::<Result<Vec<_>, _>>()?;
    }
    let quick = begin.elapsed().as_secs_f64() / (100 * points.len()) as f64;
    let span = exact[shares.len() - 1].capacitance_pf - exact[0].capacitance_pf;
    let percent = |pf: f64| 100.0 * pf / span;
    let worst = |of: &dyn Fn(usize) -> f64| (0..points.len()).map(|i| of(i).abs()).fold(0.0, f64::max);
    let largest = worst(&|i| fast[i] - exact[i].capacitance_pf);
    println!(
        "| {} | {:.3} | {span:.4} | {:.3} | {:.2} | {largest:.5} | {:.3} | {} | {slow:.1} | {:.2} |",
        sensor.name,
        exact[0].capacitance_pf,
        worst(&|i| exact[i].flat.strain),
        percent(worst(&|i| exact[i].bending())),
        percent(largest),
        points.len(),
        1e6 * quick
    );
    if std::env::var_os("TRUEGAP_POINTS").is_some() {
        points.iter().zip(&exact).try_for_each(|(at, exact)| print(&corrected, *at, exact))?;
    }
    Ok(())
}

fn print(corrected: &Corrected, (force, celsius): (f64, f64), exact: &DiscState) -> Result<(), AuditError> {
    let (model, flat, bent) = (corrected.parts(force, celsius)?, exact.flat.parts, corrected.gains(force, celsius));
    println!(
        "    {force:.2} N, {celsius} degC: strain {:.4}, bending {:+.5} pF; corrected off by {:+.5} pF: flat gap {:+.5}, bending of the gap {:+.5}, \
         behind the electrode {:+.5}, rim {:+.5}, tail {:+.5}",
        exact.flat.strain,
        exact.bending(),
        model.total() - exact.capacitance_pf,
        model.main / (1.0 + bent.main) - flat.main,
        model.main * bent.main / (1.0 + bent.main) - exact.main + flat.main,
        model.backing - exact.backing,
        model.rim - flat.rim,
        model.tail - flat.tail
    );
    Ok(())
}
