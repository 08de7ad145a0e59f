//! The sensor by finite elements at one load and temperature: heated and loaded bead, field around it, field at the rim, field of the tail.
//!
//! The reference for [`super::Corrected`]: nothing is taken from a table. Limits: beads bonded and alike, the electrode flat between and beyond them
//! (what its bending adds comes from `disc::Whole`); modulus by (7).

use super::{BondedLayers, Parts};
use crate::{
    AuditError,
    assumptions::cell::{
        filled,
        tail_parallel_plate::{Section, edge_factor},
    },
    cell::{Cell, Layered, cell_capacitance, heated_and_loaded},
};
use std::f64::consts::PI;
use truegap_core::{
    Sensor, VACUUM_PERMITTIVITY,
    sensor::{Filling, Layout},
};
use truegap_model::{StackOptions, equations::load::loaded_thickness, equations::plates::Compression, stack::Device};

/// A sensor and the parts of it that do not depend on load and temperature.
pub struct Coupled<'a> {
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
pub struct CoupledState {
    /// what is read, pF
    pub capacitance_pf: f64,
    /// its parts
    pub parts: Parts,
    /// strain of the beads against their cold height
    pub strain: f64,
}

impl<'a> Coupled<'a> {
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
    pub fn at(&self, force_n: f64, temperature_c: f64) -> Result<CoupledState, AuditError> {
        let warm = self.device.at(temperature_c);
        let (silicone, plates) = (&self.sensor.dielectric.layer.material, &self.sensor.conductor.material);
        let grown = 1.0 + plates.expansion * warm.kelvin;
        let heat = (1.0 + silicone.expansion * warm.kelvin) / grown - 1.0;
        // everything is scaled by the plates' own expansion
        let cold = self.cell;
        let reduced = force_n / (self.count * warm.young * cold.face() * grown * grown);
        let bead = heated_and_loaded(&cold, heat, reduced, 0.3 * reduced - 2.0 * heat)?;
        let film = self.pressed_film(force_n, warm.areas.electrode, warm.layers.insulator);
        let hot =
            Cell { bead: cold.bead * grown, height: cold.height * grown, outer: warm.radius / self.count.sqrt(), film, ..cold };
        let cell = cell_capacitance(&hot, &bead.profile, filled(self.sensor), self.target)?.capacitance;
        let main = self.count * cell;
        let insulator = VACUUM_PERMITTIVITY * self.sensor.insulator.material.permittivity;
        let gap = hot.height * (1.0 - bead.strain);
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
        Ok(CoupledState { capacitance_pf: parts.total(), parts, strain: bead.strain })
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
