//! The whole disc coupled: heat and load, the deformed section, the field on it, C(F, T).
//!
//! Beads are bonded rings of rubber with the force-strain law of the bead cell; the rim is a guard ring (no field outside of the plates); the tail is the
//! model's. Steady state, one temperature.

use super::body::{Loading, Rings, Strains};
use super::contact::{Bond, Carried};
use super::field::{Field, field};
use super::{BeadSpring, Disc, Fineness, Gap, Laminate, Section, Sheet};
use crate::AuditError;
use std::f64::consts::PI;
use truegap_core::sensor::Filling;
use truegap_core::{Sensor, VACUUM_PERMITTIVITY};
use truegap_fem::mesh::Mesh;
use truegap_model::equations::electrodes::Trace;
use truegap_model::equations::electrodes::tail_capacitance;
use truegap_model::stack::{Device, Warm};

/// Compressive strain of a bead of the warm sensor under a force (N) on all of them.
pub type BeadStrain<'a> = dyn Fn(&Warm, f64) -> Result<f64, AuditError> + Sync + 'a;

/// How a force reaches the disc.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Press {
    /// through a rigid flat plate without friction, as in the paper's experiment
    RigidPlate,
    /// evenly spread
    Even,
}

/// Settings of a coupled solution.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct CoupledOptions {
    /// how the force reaches the disc
    pub press: Press,
    /// mesh
    pub fineness: Fineness,
}

impl Default for CoupledOptions {
    fn default() -> Self {
        Self { press: Press::RigidPlate, fineness: Fineness { columns: 48, rows: 2 } }
    }
}

/// Capacitances of a coupled solution, F.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Charged {
    /// gap with the insulator in it
    pub main: f64,
    /// insulator behind the electrode; 0 in a mutual layout
    pub backing: f64,
    /// tail, by the model's (22); 0 in a mutual layout
    pub tail: f64,
    /// beside the sensor
    pub stray: f64,
    /// estimated magnitude of the error of main + backing on this mesh
    pub error_estimate: f64,
}

impl Charged {
    /// What is read, F.
    pub fn total(&self) -> f64 {
        self.main + self.backing + self.tail + self.stray
    }
}

/// A disc under load and heat with its field.
#[derive(Clone, Debug)]
pub struct Coupled {
    /// the disc
    pub disc: Disc,
    /// its equilibrium
    pub carried: Carried,
    /// the deformed section, air included
    pub deformed: Mesh,
    /// potential and field on the deformed insulators, beads and air
    pub field: Field,
    /// capacitances
    pub charged: Charged,
    /// temperature above the reference, K
    pub kelvin: f64,
}

/// A sensor whose disc is to be solved.
pub struct Whole<'a> {
    sensor: &'a Sensor,
    device: &'a Device,
    strain: &'a BeadStrain<'a>,
    options: CoupledOptions,
}

/// Strain at which the rings are matched to the bead where the load is nearly none.
const AT_REST: f64 = 1e-3;

impl<'a> Whole<'a> {
    /// A sensor with the force-strain law of its beads.
    ///
    /// # Errors
    /// [`AuditError::Lacks`] where the dielectric has no beads.
    pub fn new(
        sensor: &'a Sensor,
        device: &'a Device,
        strain: &'a BeadStrain<'a>,
        options: CoupledOptions,
    ) -> Result<Self, AuditError> {
        match sensor.dielectric.filling {
            Filling::Beads { .. } => Ok(Self { sensor, device, strain, options }),
            Filling::Solid { .. } => Err(AuditError::Lacks { sensor: sensor.name.clone(), part: "beads" }),
        }
    }

    /// Equilibrium, deformed section, field and capacitance at a force (N) and a temperature (degrees Celsius).
    ///
    /// # Errors
    /// Where no equilibrium is found, the deformed section folds, or the law of the beads refuses.
    pub fn solve(&self, force_n: f64, temperature_c: f64) -> Result<Coupled, AuditError> {
        let disc = self.disc(force_n, temperature_c)?;
        let kelvin = temperature_c - self.sensor.reference_c;
        let carried = match self.options.press {
            Press::RigidPlate if force_n > 0.0 => disc.pressed(kelvin, force_n, Bond::Bonded)?,
            _ => disc.carried(kelvin, &Loading::Even(force_n), Bond::Bonded)?,
        };
        let deformed = carried.solution.deformed_mesh();
        let field = field(&deformed, &|region| self.permittivity(region))?;
        let charged = self.charged(&field, temperature_c);
        Ok(Coupled { disc, carried, deformed, field, charged, kelvin })
    }

    /// C(F, T), pF.
    ///
    /// # Errors
    /// As [`Whole::solve`].
    pub fn capacitance_pf(&self, force_n: f64, temperature_c: f64) -> Result<f64, AuditError> {
        Ok(1e12 * self.solve(force_n, temperature_c)?.charged.total())
    }

    /// The disc with rings as stiff as the beads at this load and temperature.
    ///
    /// # Errors
    /// As [`Whole::solve`].
    pub fn disc(&self, force_n: f64, temperature_c: f64) -> Result<Disc, AuditError> {
        let warm = self.device.at(temperature_c);
        let beads = BeadSpring::new(self.sensor, &warm, force_n, self.strain)?;
        let insulator = Sheet::of("facing", &self.sensor.insulator);
        let plate = Laminate::backed(self.sensor);
        let gap = Gap::Rings { height: beads.height, coverage: beads.coverage, zones: BeadSpring::zones(self.sensor) };
        let section = Section::new(&plate, &gap, Some(insulator.thickness), self.options.fineness)?;
        let poisson = self.sensor.dielectric.layer.material.poisson;
        let rings = Rings::Rubber { young: beads.young, poisson };
        let mut disc =
            Disc { plate, section, beads: Some(beads), rings, facing: Some(insulator), air: true, strains: Strains::Large };
        let area = PI * disc.plate.radius * disc.plate.radius;
        let strain = (force_n / (area * beads.coverage * beads.young)).max(AT_REST);
        // A ring is stiffer or softer than a bead of the same rubber; force goes with the modulus, so one solution tells by how much.
        let found = disc.flattened(strain * beads.height)?;
        let wanted = strain * area * beads.coverage * beads.young;
        disc.rings = Rings::Rubber { young: beads.young * wanted / found, poisson };
        Ok(disc)
    }

    fn permittivity(&self, region: &str) -> f64 {
        let relative = match region {
            "air" => self.sensor.dielectric.surrounding_permittivity,
            "facing" | "backing" => self.sensor.insulator.material.permittivity,
            _ => self.sensor.dielectric.layer.material.permittivity,
        };
        VACUUM_PERMITTIVITY * relative
    }

    fn charged(&self, field: &Field, temperature_c: f64) -> Charged {
        let shielded = self.sensor.layout == truegap_core::sensor::Layout::Shielded;
        let shown = f64::from(u8::from(shielded));
        let trace = Trace { length: self.sensor.tail.0, width: self.sensor.tail.1 };
        let insulator = self.device.at(temperature_c).layers.insulator;
        Charged {
            main: field.main,
            backing: shown * field.backing,
            tail: shown * tail_capacitance(self.permittivity("backing"), trace, insulator),
            stray: self.sensor.stray.value,
            error_estimate: field.error_estimate,
        }
    }
}
