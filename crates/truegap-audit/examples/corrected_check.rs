//! The corrected model against finite elements: built-in sensors and designs that no table was made for, as a Markdown table.
//!
//! `cargo run -p truegap-audit --example corrected_check [DESIGNS [SKIP]]` (20 designs where no number is given; a quarter of an hour and more; SKIP
//! leaves out the built-in sensors and so many of the first designs)
//!
//! The reference is the bead cell with its fields, heated and loaded, plus what bending adds: the coupled disc less the same disc that is held flat.
//! `TRUEGAP_POINTS=1` prints every point.

use rayon::prelude::*;
use std::time::Instant;
use truegap_audit::corrections::{Corrected, Parts, coupled::Coupled, designs::held_out};
use truegap_audit::disc::{CoupledOptions, Whole};
use truegap_audit::{AuditError, Options, Study, Swap, Watch};
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
        "| sensor | C0 (pF) | span (pF) | greatest strain | bending, % of span | largest error (pF) | % of span | the disc alone, % of span | points | \
         finite elements (s a point) | corrected (us a point) |"
    );
    println!("|---|---|---|---|---|---|---|---|---|---|---|");
    for sensor in built_in.iter().filter(|_| skip == 0) {
        compare(sensor, &BUILT_IN.0, &BUILT_IN.1)?;
    }
    for sensor in held_out(&built_in[0], skip + count).into_iter().skip(skip) {
        if let Err(error) = compare(&sensor, &HELD_OUT.0, &HELD_OUT.1) {
            println!("| {} | {error} | | | | | | | | | |", sensor.name);
        }
    }
    Ok(())
}

/// What finite elements say at one point.
struct Exact {
    /// the cell's
    flat: Parts,
    /// what bending adds, pF
    bending: f64,
    /// the disc with rings for beads, with the cell's rim and tail, pF
    disc: f64,
    strain: f64,
}

impl Exact {
    fn total(&self) -> f64 {
        self.flat.total() + self.bending
    }
}

fn exact(coupled: &Coupled<'_>, whole: &Whole<'_>, at: (f64, f64)) -> Result<Exact, AuditError> {
    let cell = coupled.at(at.0, at.1)?;
    let [bent, flat] =
        [whole.solve(at.0, at.1)?, whole.solve_flat(at.0, at.1)?].map(|s| 1e12 * (s.charged.main + s.charged.backing));
    let Parts { rim, tail, stray, .. } = cell.parts;
    Ok(Exact { flat: cell.parts, bending: bent - flat, disc: bent + rim + tail + stray, strain: cell.strain })
}

/// The sensor with a load that its analytic model can carry: bonded beads are squeezed less than the free ones of that model, whose gap may close.
fn ranged(sensor: &Sensor) -> Sensor {
    let less = |share: f64| Sensor { full_scale: share * sensor.full_scale, ..sensor.clone() };
    let open = |of: &Sensor| {
        let watch = Watch::default();
        let study = Study::new(of, Options::default(), &watch);
        study.is_ok_and(|s| s.chain(Swap::none()).row(s.full_n(), 50.0).is_ok_and(|row| row.squeeze.strain < 0.4))
    };
    let watch = Watch::default();
    if Study::new(sensor, Options::default(), &watch).is_ok() {
        return sensor.clone();
    }
    [0.6, 0.5, 0.4, 0.3, 0.25].map(less).into_iter().find(open).unwrap_or_else(|| sensor.clone())
}

fn compare(sensor: &Sensor, shares: &[f64], temperatures: &[f64]) -> Result<(), AuditError> {
    let points: Vec<(f64, f64)> =
        temperatures.iter().flat_map(|&t| shares.iter().map(move |&s| (s * sensor.full_scale, t))).collect();
    let (coupled, corrected, watch) = (Coupled::new(sensor, 1e-5)?, Corrected::new(sensor)?, Watch::default());
    let ranged = ranged(sensor);
    let study = Study::new(&ranged, Options::default(), &watch)?;
    let whole = Whole::bonded(&study, CoupledOptions { target: 2e-5, ..CoupledOptions::default() })?;
    let begin = Instant::now();
    let exact = points.par_iter().map(|&at| exact(&coupled, &whole, at)).collect::<Result<Vec<_>, _>>()?;
    let slow = begin.elapsed().as_secs_f64() / points.len() as f64;
    let begin = Instant::now();
    let mut fast = Vec::new();
    for _ in 0..100 {
        fast = points.iter().map(|&(f, t)| corrected.capacitance_pf(f, t)).collect::<Result<Vec<_>, _>>()?;
    }
    let quick = begin.elapsed().as_secs_f64() / (100 * points.len()) as f64;
    let span = exact[shares.len() - 1].total() - exact[0].total();
    let percent = |pf: f64| 100.0 * pf / span;
    let worst = |of: &dyn Fn(usize) -> f64| (0..points.len()).map(|i| of(i).abs()).fold(0.0, f64::max);
    let error = |i: usize| fast[i] - exact[i].total();
    // rings are not beads: their baseline is another, so the change from it is compared
    let alone = |i: usize| (fast[i] - fast[0]) - (exact[i].disc - exact[0].disc);
    println!(
        "| {} | {:.3} | {span:.4} | {:.3} | {:.2} | {:.5} | {:.3} | {:.2} | {} | {slow:.1} | {:.2} |",
        sensor.name,
        exact[0].total(),
        worst(&|i| exact[i].strain),
        percent(worst(&|i| exact[i].bending)),
        worst(&error),
        percent(worst(&error)),
        percent(worst(&alone)),
        points.len(),
        1e6 * quick
    );
    if std::env::var_os("TRUEGAP_POINTS").is_some() {
        for (i, (force, celsius)) in points.iter().enumerate() {
            let (flat, model) = (exact[i].flat, corrected.parts(*force, *celsius)?);
            println!(
                "    {force:.2} N, {celsius} degC: strain {:.4}, bending {:+.5} pF, corrected off by {:+.5} pF (main and bending {:+.5}, rim {:+.5}, tail {:+.5})",
                exact[i].strain,
                exact[i].bending,
                error(i),
                model.main + model.backing - flat.main - flat.backing - exact[i].bending,
                model.rim - flat.rim,
                model.tail - flat.tail
            );
        }
    }
    Ok(())
}
