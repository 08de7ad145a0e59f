//! The sensor as equal bead cells at one load and temperature: heated and loaded bead, field around it, field at the rim, field of the tail.
//!
//! Limits: beads bonded and alike, the electrode flat between and beyond them (what its bending adds comes from [`super::CellDisc`]); modulus by (7).

use crate::{
    assumptions::cell::{Section, edge_factor},
    cell::{Cell, Layered, PressedAt, cell_capacitance, filled, heated_and_loaded, heated_and_squeezed},
    corrections::{BondedLayers, Parts},
    error::AuditError,
};
use std::f64::consts::PI;
use truegap_core::{
    Sensor, VACUUM_PERMITTIVITY,
    sensor::{Filling, Layout},
};
use truegap_model::{
    StackOptions,
    equations::load::loaded_thickness,
    equations::plates::Compression,
    stack::{Device, Warm},
};

/// A sensor and the parts of it that do not depend on load and temperature.
pub struct FlatCells<'a> {
    sensor: &'a Sensor,
    device: Device,
    layers: BondedLayers,
    cell: Cell,
    count: f64,
    tail: f64,
    target: f64,
}

/// What finite elements say at one load and temperature.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct CellState {
    /// what is read, pF
    pub capacitance_pf: f64,
    /// its parts
    pub parts: Parts,
    /// strain of the beads against their cold height
    pub strain: f64,
    /// height of the beads, m
    pub gap: f64,
    /// thickness of the insulator below them, m
    pub film: f64,
    /// radius of the electrode, m
    pub radius: f64,
}

/// How all cells together answer to a small change of the height of their beads.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct CellSlopes {
    /// the change of height, m
    pub step: f64,
    /// force for the height given up, N/m
    pub stiffness: f64,
    /// capacitance of the gap with beads lower and higher by the step, F
    pub main: [f64; 2],
}

/// A heated bead in its grown cell.
struct Heated {
    /// thermal strain of the bead over that of the plates
    heat: f64,
    /// force of all beads over the reduced load of one, N
    force: f64,
    cell: Cell,
}

/// Strain by which slopes are taken: beads answer in a straight line so far, and the finite elements do not notice their own rounding.
const STEP: f64 = 0.01;

impl<'a> FlatCells<'a> {
    /// The sensor.
    pub fn sensor(&self) -> &'a Sensor {
        self.sensor
    }

    /// Relative error wanted of the fields.
    pub(crate) fn target(&self) -> f64 {
        self.target
    }

    /// A sensor; `target` is the relative error of its fields.
    ///
    /// # Errors
    /// [`AuditError::Lacks`] without beads, [`AuditError::Fem`].
    pub fn new(sensor: &'a Sensor, target: f64) -> Result<Self, AuditError> {
        let cell = Cell::of(sensor)?;
        let count = match sensor.dielectric.filling {
            Filling::Beads { count, .. } => f64::from(count),
            Filling::Solid { .. } => return Err(AuditError::Lacks { sensor: sensor.name.clone(), part: "beads" }),
        };
        let has_tail = sensor.layout == Layout::Shielded && sensor.tail.0 * sensor.tail.1 > 0.0;
        let tail = if has_tail { edge_factor(Section::of(sensor), target)?.value } else { 1.0 };
        let layers = BondedLayers::of(sensor);
        let device = Device::new(&layers.sensor, StackOptions { warp: false, ..StackOptions::default() });
        Ok(Self { sensor, device, layers, cell, count, tail, target })
    }

    /// The sensor at a force (N) and a temperature (degrees Celsius).
    ///
    /// # Errors
    /// [`AuditError::Fem`] where a solver fails.
    pub fn at(&self, force_n: f64, temperature_c: f64) -> Result<CellState, AuditError> {
        let warm = self.device.at(temperature_c);
        let heated = self.heated(force_n, &warm);
        let reduced = force_n / heated.force;
        let bead = heated_and_loaded(&self.cell, heated.heat, reduced, 0.3 * reduced - 2.0 * heated.heat)?;
        let main = self.main(&heated, &bead)?;
        let (film, gap) = (heated.cell.film, heated.cell.height * (1.0 - bead.strain));
        let insulator = VACUUM_PERMITTIVITY * self.sensor.insulator.material.permittivity;
        let layered = self.layers(warm.radius, film, gap, main, insulator);
        // a small difference of large numbers
        let rim = layered.rim(0.2 * self.target)?.value;
        let shielded = self.sensor.layout == Layout::Shielded;
        let thicker = 1.0 + self.layers.backing_per_kelvin * warm.kelvin;
        let backing = if shielded { insulator * PI * warm.radius * warm.radius / (film * thicker) } else { 0.0 };
        let (length, width) = self.sensor.tail;
        let tail = if shielded { 2.0 * insulator * length * width / warm.layers.insulator * self.tail } else { 0.0 };
        let [main, backing, rim, tail, stray] = [main, backing, rim, tail, self.sensor.stray.value].map(|c| 1e12 * c);
        let parts = Parts { main, backing, rim, tail, stray };
        Ok(CellState { capacitance_pf: parts.total(), parts, strain: bead.strain, gap, film, radius: warm.radius })
    }

    /// Slopes at a state that was found at the same force (N) and temperature (degrees Celsius): differences to beads that are strained by 0.01 less and more.
    ///
    /// # Errors
    /// [`AuditError::Fem`] where a solver fails.
    pub fn slopes(&self, state: &CellState, force_n: f64, temperature_c: f64) -> Result<CellSlopes, AuditError> {
        let heated = self.heated(force_n, &self.device.at(temperature_c));
        let near = |strain: f64| heated_and_squeezed(&self.cell, heated.heat, strain);
        let (lower, higher) = (near(state.strain + STEP)?, near(state.strain - STEP)?);
        let step = STEP * heated.cell.height;
        Ok(CellSlopes {
            step,
            stiffness: heated.force * (lower.reduced_load - higher.reduced_load) / (2.0 * step),
            main: [self.main(&heated, &lower)?, self.main(&heated, &higher)?],
        })
    }

    /// Everything is scaled by the plates' own expansion.
    fn heated(&self, force_n: f64, warm: &Warm) -> Heated {
        let (silicone, plates) = (&self.sensor.dielectric.layer.material, &self.sensor.conductor.material);
        let grown = 1.0 + plates.expansion * warm.kelvin;
        let cold = self.cell;
        let film = self.pressed_film(force_n, warm.areas.electrode, warm.layers.insulator);
        Heated {
            heat: (1.0 + silicone.expansion * warm.kelvin) / grown - 1.0,
            force: self.count * warm.young * cold.face() * grown * grown,
            cell: Cell {
                bead: cold.bead * grown,
                height: cold.height * grown,
                outer: warm.radius / self.count.sqrt(),
                film,
                ..cold
            },
        }
    }

    /// Capacitance of the gap of all cells, F.
    fn main(&self, heated: &Heated, bead: &PressedAt) -> Result<f64, AuditError> {
        Ok(self.count * cell_capacitance(&heated.cell, &bead.profile, filled(self.sensor), self.target)?.capacitance)
    }

    fn pressed_film(&self, force_n: f64, area: f64, thickness: f64) -> f64 {
        let young = self.layers.sensor.insulator.material.young.value;
        loaded_thickness(thickness, Compression { pressure: force_n / area, young })
    }

    /// Flat layers with the medium between them that has the capacitance of the cells.
    fn layers(&self, radius: f64, film: f64, gap: f64, main: f64, insulator: f64) -> Layered {
        let area = PI * radius * radius;
        let medium = gap / (area / main - film / insulator);
        let sensor = self.sensor;
        Layered {
            radius,
            backing: (sensor.layout == Layout::Shielded).then_some(film),
            electrode: sensor.conductor.thickness.value + sensor.plating.as_ref().map_or(0.0, |p| p.thickness.value),
            film,
            beads: gap,
            film_permittivity: insulator,
            bead_permittivity: medium,
        }
    }
}
