//! The disc on rings that stand for bead cells: as stiff as those and conducting as they do, at each load and temperature.
//!
//! Heat and load bend the section, the field is solved on what they leave of it. Limits: rings of equal share, each a spring that is straight about the
//! flat state; a rigid load plate without friction; the field at the rim, the tail and what is beside the sensor are those of the cells.

use super::cells::{CellSlopes, CellState, FlatCells};
use super::ring_medium::{FlatRings, RingMedium};
use crate::cell::Cell;
use crate::cell::filled;
use crate::disc::{
    BeadSpring, Bond, Carried, Disc, Facing, Field, Fineness, Gap, Laminate, Loading, Ring, Rings, Section, Sheet, Strains, field,
};
use crate::error::AuditError;
use std::f64::consts::PI;
use truegap_core::{VACUUM_PERMITTIVITY, sensor::Layout};

/// A sensor whose disc is to be solved.
pub struct CellDisc<'a> {
    cells: FlatCells<'a>,
    cell: Cell,
    fineness: Fineness,
}

/// The disc at one load and temperature.
#[derive(Clone, Debug)]
pub struct DiscState {
    /// what is read, pF
    pub capacitance_pf: f64,
    /// gap, pF
    pub main: f64,
    /// insulator behind the electrode, pF
    pub backing: f64,
    /// the cells of which its rings are made, between flat plates
    pub flat: CellState,
    /// the disc and its equilibrium
    pub disc: Disc,
    /// the equilibrium
    pub carried: Carried,
    /// heights of the rings, m
    pub heights: Vec<f64>,
    /// their relative permittivities
    pub permittivities: Vec<f64>,
}

impl DiscState {
    /// What bending adds to the flat cells, pF.
    pub fn bending(&self) -> f64 {
        self.capacitance_pf - self.flat.capacitance_pf
    }
}

/// Mesh of the section.
const FINENESS: Fineness = Fineness { columns: 48, rows: 2 };

impl<'a> CellDisc<'a> {
    /// A sensor of cells.
    ///
    /// # Errors
    /// [`AuditError::Lacks`] without beads.
    pub fn new(cells: FlatCells<'a>) -> Result<Self, AuditError> {
        Self::with(cells, FINENESS)
    }

    /// The same on another mesh of the section.
    ///
    /// # Errors
    /// As [`CellDisc::new`].
    pub fn with(cells: FlatCells<'a>, fineness: Fineness) -> Result<Self, AuditError> {
        let cell = Cell::of(cells.sensor())?;
        Ok(Self { cells, cell, fineness })
    }

    /// The cells that its rings stand for.
    pub fn cells(&self) -> &FlatCells<'a> {
        &self.cells
    }

    /// The disc at a force (N) on a rigid plate and a temperature (degrees Celsius).
    ///
    /// # Errors
    /// [`AuditError::Fem`] where a solver fails, [`AuditError::NotConverged`] where the contact does not settle.
    pub fn at(&self, force_n: f64, temperature_c: f64) -> Result<DiscState, AuditError> {
        self.solve(force_n, temperature_c, false)
    }

    /// The disc with its electrode held flat by a plate that also pulls: the cells again, but for what the edges of its layers do.
    ///
    /// # Errors
    /// As [`CellDisc::at`].
    pub fn held_flat(&self, force_n: f64, temperature_c: f64) -> Result<DiscState, AuditError> {
        self.solve(force_n, temperature_c, true)
    }

    fn solve(&self, force_n: f64, temperature_c: f64, held: bool) -> Result<DiscState, AuditError> {
        let sensor = self.cells.sensor();
        let flat = self.cells.at(force_n, temperature_c)?;
        let slopes = self.cells.slopes(&flat, force_n, temperature_c)?;
        let medium = RingMedium::of(&self.flat_rings(&flat), flat.gap, 1e-12 * flat.parts.main, &slopes)?;
        let kelvin = temperature_c - sensor.reference_c;
        let disc = self.disc(force_n, kelvin, &flat, &slopes)?;
        let carried = if held {
            disc.held_flat(kelvin, force_n)?
        } else if force_n > 0.0 {
            disc.pressed(kelvin, force_n, Bond::Bonded)?
        } else {
            disc.carried(kelvin, &Loading::None, Bond::Bonded)?
        };
        let heights = disc.section.rings.iter().map(|ring| height(&disc, &carried, *ring)).collect::<Result<Vec<_>, _>>()?;
        let permittivities: Vec<f64> = heights.iter().map(|h| medium.at(*h)).collect();
        let field = self.field(&carried, &permittivities)?;
        let backing = if sensor.layout == Layout::Shielded { 1e12 * field.backing } else { 0.0 };
        let main = 1e12 * field.main;
        let capacitance_pf = flat.capacitance_pf + main + backing - flat.parts.main - flat.parts.backing;
        Ok(DiscState { capacitance_pf, main, backing, flat, disc, carried, heights, permittivities })
    }

    /// The disc with rings that carry the force where they are as high as the flat cells' beads, and as stiff as those there: they are so high without
    /// force that one straight line does both. They grow like the plates, which are to find them as wide as the permittivity was found for.
    fn disc(&self, force_n: f64, kelvin: f64, flat: &CellState, slopes: &CellSlopes) -> Result<Disc, AuditError> {
        let sensor = self.cells.sensor();
        let (plate, facing) = (Laminate::backed(sensor), Sheet::of("facing", &sensor.insulator));
        let coverage = self.cell.coverage();
        let expansion = sensor.conductor.material.expansion;
        let height = (flat.gap + force_n / slopes.stiffness) / (1.0 + expansion * kelvin);
        let young = slopes.stiffness * height / (coverage * PI * plate.radius * plate.radius);
        let gap = Gap::Rings { height, coverage, zones: BeadSpring::zones(sensor) };
        let section = Section::new(&plate, &gap, Some(facing.thickness), self.fineness)?;
        Ok(Disc {
            plate,
            section,
            beads: Some(BeadSpring { young, coverage, height, expansion }),
            rings: Rings::Springs,
            facing: Some(Facing { sheet: facing, shield_expansion: expansion }),
            air: true,
            strains: Strains::Large,
        })
    }

    fn flat_rings(&self, flat: &CellState) -> FlatRings {
        let (sensor, filled) = (self.cells.sensor(), filled(self.cells.sensor()));
        FlatRings {
            plate: Laminate { radius: flat.radius, ..Laminate::backed(sensor) },
            film: flat.film,
            coverage: self.cell.coverage(),
            zones: BeadSpring::zones(sensor),
            film_permittivity: filled.film,
            air_permittivity: filled.air,
            fineness: self.fineness,
            target: self.cells.target(),
        }
    }

    fn field(&self, carried: &Carried, rings: &[f64]) -> Result<Field, AuditError> {
        let filled = filled(self.cells.sensor());
        let of = |region: &str| {
            let ring = region.strip_prefix("ring ").and_then(|number| number.parse::<usize>().ok());
            let relative = match ring {
                Some(number) => rings[number - 1],
                None if region == "air" => filled.air,
                None => filled.film,
            };
            VACUUM_PERMITTIVITY * relative
        };
        field(&carried.solution.deformed_mesh(), &of, self.cells.target())
    }
}

/// Mean height of a ring that has been bent, m: three Gauss points over its width.
fn height(disc: &Disc, carried: &Carried, ring: Ring) -> Result<f64, AuditError> {
    const GAUSS: [(f64, f64); 3] = [(0.112_701_665_379_258_3, 5.0), (0.5, 8.0), (0.887_298_334_620_741_7, 5.0)];
    let bottom = disc.facing.as_ref().map_or(0.0, |f| f.sheet.thickness);
    let rise = |at: [f64; 2]| carried.solution.displacement_at(at).map_err(AuditError::fem("height of a ring"));
    let (mut sum, mut weights) = (0.0, 0.0);
    for (t, weight) in GAUSS {
        let r = ring.inner + t * (ring.outer - ring.inner);
        sum += weight * r * (rise([r, disc.section.face])?[1] - rise([r, bottom])?[1]);
        weights += weight * r;
    }
    Ok(disc.section.face - bottom + sum / weights)
}
