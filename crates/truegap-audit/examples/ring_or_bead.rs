//! What a disc of rubber rings has wrong where it stands for a disc of beads, part by part, as a Markdown table.
//!
//! `cargo run -p truegap-audit --example ring_or_bead` (some minutes)
//!
//! `disc::Whole` has rings of rubber with a bead's force, height and growth; `reference::CellDisc` has rings that push and conduct as bead cells do. Changes of
//! the capacitance from the unloaded cold state, in per cent of the span: rubber rings less bead cells.

use truegap_audit::cell::Cell;
use truegap_audit::corrections::held_out;
use truegap_audit::disc::{BeadSpring, Coupled, CoupledOptions, Fineness, Gap, Laminate, RingPlate, Section, Whole};
use truegap_audit::reference::{CellDisc, CellSlopes, DiscState, FlatCells};
use truegap_audit::{AuditError, Options, Study, Watch};
use truegap_core::Sensor;
use truegap_core::sensor::builtin_sensors;

/// Cold and loaded, hot, hot and loaded: force (N), temperature (degrees Celsius).
const POINTS: [(f64, f64); 3] = [(4.5, 20.0), (0.0, 50.0), (4.5, 50.0)];

fn main() -> Result<(), Box<dyn std::error::Error>> {
    let s15 = builtin_sensors()[0].sensor()?;
    println!(
        "| sensor | at | all | height of the gap | field in it | behind the electrode, flat | bending |\n|---|---|---|---|---|---|---|"
    );
    let chosen = |sensor: &Sensor| ["held-out 32", "held-out 55"].contains(&sensor.name.as_str());
    let designs: Vec<Sensor> = held_out(&s15, 36).into_iter().filter(chosen).collect();
    for sensor in std::iter::once(&s15).chain(&designs) {
        compare(sensor)?;
    }
    println!(
        "\n| sensor | tilting stiffness of beads over that of rings of springs | change of the rim's slope by that at 50 degC |\n|---|---|---|"
    );
    std::iter::once(&s15).chain(&designs).try_for_each(tilt)?;
    Ok(())
}

/// One state of both discs.
struct Both {
    rubber: Coupled,
    rubber_flat: Coupled,
    cells: DiscState,
    slopes: CellSlopes,
}

impl Both {
    fn at(whole: &Whole<'_>, disc: &CellDisc<'_>, (force, celsius): (f64, f64)) -> Result<Self, AuditError> {
        let cells = disc.at(force, celsius)?;
        let slopes = disc.cells().slopes(&cells.flat, force, celsius)?;
        Ok(Self { rubber: whole.solve(force, celsius)?, rubber_flat: whole.solve_flat(force, celsius)?, cells, slopes })
    }

    /// Rubber rings less bead cells, pF: capacitance for the height of the gap, for the field in it, behind the electrode, by bending.
    fn parts(&self) -> Result<[f64; 4], AuditError> {
        let flat = &self.cells.flat;
        let height = self.gap()? - flat.gap;
        let by_height = 1e12 * (self.slopes.main[1] - self.slopes.main[0]) / (2.0 * self.slopes.step) * height;
        let charged = &self.rubber_flat.charged;
        let both = |c: &Coupled| 1e12 * (c.charged.main + c.charged.backing);
        Ok([
            by_height,
            1e12 * charged.main - flat.parts.main - by_height,
            1e12 * charged.backing - flat.parts.backing,
            both(&self.rubber) - both(&self.rubber_flat) - self.cells.bending(),
        ])
    }

    /// Height of the gap between the flat electrode and the insulator below it, m.
    fn gap(&self) -> Result<f64, AuditError> {
        let (disc, solution) = (&self.rubber_flat.disc, &self.rubber_flat.carried.solution);
        let below = disc.facing.as_ref().map_or(0.0, |f| f.sheet.thickness);
        let middle = 0.5 * (disc.section.rings[1].inner + disc.section.rings[1].outer);
        let rise = |z: f64| solution.displacement_at([middle, z]).map_err(AuditError::fem("height of the gap"));
        Ok(disc.section.face - below + rise(disc.section.face)?[1] - rise(below)?[1])
    }
}

fn compare(sensor: &Sensor) -> Result<(), AuditError> {
    let watch = Watch::default();
    // the analytic model, whose study this is, may not carry the whole load
    let less = Sensor { full_scale: 0.25 * sensor.full_scale, ..sensor.clone() };
    let study = Study::new(sensor, Options::default(), &watch).or_else(|_| Study::new(&less, Options::default(), &watch))?;
    let whole = Whole::bonded(&study, CoupledOptions { target: 2e-5, ..CoupledOptions::default() })?;
    let disc = CellDisc::new(FlatCells::new(sensor, 1e-5)?)?;
    let at = |point| Both::at(&whole, &disc, point);
    let rest = at((0.0, 20.0))?;
    let (from, base) = (rest.parts()?, rest.cells.capacitance_pf);
    let loaded = at(POINTS[0])?;
    let span = loaded.cells.capacitance_pf - base;
    let print = |both: &Both, (force, celsius): (f64, f64)| -> Result<(), AuditError> {
        let parts = both.parts()?;
        let [height, field, behind, bending] = [0, 1, 2, 3].map(|i| 100.0 * (parts[i] - from[i]) / span);
        let all = height + field + behind + bending;
        println!(
            "| {} | {force} N, {celsius} degC | {all:+.2} | {height:+.2} | {field:+.2} | {behind:+.2} | {bending:+.2} |",
            sensor.name
        );
        Ok(())
    };
    print(&loaded, POINTS[0])?;
    POINTS[1..].iter().try_for_each(|&point| print(&at(point)?, point))
}

/// Beads are as wide as they are, rings of springs as wide as their share: what the beads' own resistance to tilting would change.
///
/// Incompressible disc: tilting 1 + 2/3 S², shortening 1 + 2 S² times Young's modulus (Gent & Meinecke 1970), over a quarter of the squared radius; a ring
/// of springs has a twelfth of its squared width.
fn tilt(sensor: &Sensor) -> Result<(), AuditError> {
    let (cell, plate, zones) = (Cell::of(sensor)?, Laminate::backed(sensor), BeadSpring::zones(sensor));
    let gap = Gap::Rings { height: cell.height, coverage: cell.coverage(), zones };
    let rings = Section::new(&plate, &gap, None, Fineness::COARSE)?.rings;
    let (width, squared) = (rings[0].outer - rings[0].inner, cell.shape_factor() * cell.shape_factor());
    let yields = (1.0 + 2.0 / 3.0 * squared) / (1.0 + 2.0 * squared);
    let ratio = yields * cell.bead * cell.bead / 4.0 / (width * width / 12.0);
    let stiffness = sensor.dielectric.layer.material.young.value * (1.0 + 2.0 * squared) / cell.height;
    let (bending, poisson, radius) = (plate.bending_stiffness(), plate.poisson(), plate.radius);
    let curvature = plate.curvature_per_kelvin() * 30.0;
    let slope = |tilt: f64| {
        let plate = RingPlate { bending, poisson, radius, stiffness, tilt, rings: rings.clone() };
        plate.bent(curvature, 0.0).mean_bending()
    };
    println!("| {} | {ratio:.2} | {:+.1} % |", sensor.name, 100.0 * (slope(ratio) / slope(1.0) - 1.0));
    Ok(())
}
