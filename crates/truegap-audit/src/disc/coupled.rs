//! The whole disc coupled: heat and load, the deformed section, the field on it, C(F, T).
//!
//! Beads are bonded rings of rubber with the force-strain law of the bead cell; the shield below is flat and grows like the conductor; the rim is a guard
//! ring (no field outside of the plates); the tail is that of (22). Steady state, one temperature.

use super::{
    bead_spring::BeadSpring,
    body::{Disc, Facing, Loading, Rings, Strains},
    contact::{Bond, Carried},
    field::{Field, field},
    fineness::Fineness,
    laminate::{Laminate, Sheet},
    rings::Gap,
    section::Section,
};
use crate::cell::{Cell, Growth, bonded_law, held_expansion};
use crate::{error::AuditError, study::Study};
use std::f64::consts::PI;
use truegap_core::sensor::Filling;
use truegap_core::{Sensor, VACUUM_PERMITTIVITY};
use truegap_fem::mesh::Mesh;
use truegap_model::equations::electrodes::Trace;
use truegap_model::equations::electrodes::tail_capacitance;
use truegap_model::stack::{Device, Warm};

/// Compressive strain of a bead of the warm sensor under a force (N) on all of them.
pub type BeadStrain<'a> = Box<dyn Fn(&Warm, f64) -> Result<f64, AuditError> + Send + Sync + 'a>;

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
    /// mesh of the section
    pub fineness: Fineness,
    /// relative error wanted of the capacitances on the deformed section
    pub target: f64,
}

impl Default for CoupledOptions {
    fn default() -> Self {
        Self { press: Press::RigidPlate, fineness: Fineness { columns: 48, rows: 2 }, target: 1e-4 }
    }
}

/// Capacitances of a coupled solution, F.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Charged {
    /// gap with the insulator in it
    pub main: f64,
    /// insulator behind the electrode; 0 in a mutual layout
    pub backing: f64,
    /// tail, by the model's (22) and the growth of a bonded insulator; 0 in a mutual layout
    pub tail: f64,
    /// beside the sensor
    pub stray: f64,
    /// estimated magnitude of the error of main + backing as a field on this section; that of its shape comes from two finenesses
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

/// What the rings must do: that of real beads, from the bead cell.
pub struct Beads<'a> {
    /// force-strain law
    pub strain: BeadStrain<'a>,
    /// expansion of the height between the plates, 1/K
    pub expansion: f64,
}

/// A sensor whose disc is to be solved.
pub struct Whole<'a> {
    sensor: &'a Sensor,
    device: &'a Device,
    beads: Beads<'a>,
    options: CoupledOptions,
    /// expansion of the rings' rubber that gives the beads' of the height, 1/K
    ring_expansion: f64,
}

/// Strain at which the rings are matched to the bead where the load is nearly none.
const AT_REST: f64 = 1e-3;

impl<'a> Beads<'a> {
    /// Beads that stick to both plates, by the finite elements of the cell.
    ///
    /// # Errors
    /// [`AuditError::Lacks`] where the dielectric has no beads; what the cell refuses.
    pub fn bonded(study: &Study<'_>) -> Result<Self, AuditError> {
        let law = bonded_law(study)?;
        let growth = Growth::of(study.sensor, held_expansion(&Cell::of(study.sensor)?)?.value);
        let strain = move |warm: &Warm, force_n: f64| {
            // held faces: the area grows less than that of a free bead, the height more
            let mut held = *warm;
            growth.apply(&mut held);
            law.strain(force_n / (held.areas.solid * held.young))
        };
        Ok(Self { strain: Box::new(strain), expansion: growth.height })
    }

    /// Beads that spread and expand freely: (3), (11), (12).
    pub fn free(sensor: &Sensor, device: &'a Device) -> Self {
        let strain = Box::new(move |warm: &Warm, force_n: f64| {
            let temperature_c = device.reference_c + warm.kelvin;
            device.strain(warm, force_n, 1.0, [0.0; 2]).map_err(|_| AuditError::NoResponse {
                force_n,
                temperature_c,
                strain: 1.0,
            })
        });
        Self { strain, expansion: sensor.dielectric.layer.material.expansion }
    }
}

impl<'a> Whole<'a> {
    /// The disc of a study with bonded beads.
    ///
    /// # Errors
    /// As [`Whole::new`] and [`Beads::bonded`].
    pub fn bonded(study: &'a Study<'_>, options: CoupledOptions) -> Result<Self, AuditError> {
        Self::new(study.sensor, &study.device, Beads::bonded(study)?, options)
    }

    /// A sensor and the behaviour of its beads.
    ///
    /// # Errors
    /// [`AuditError::Lacks`] where the dielectric has no beads; what the solver refuses.
    pub fn new(sensor: &'a Sensor, device: &'a Device, beads: Beads<'a>, options: CoupledOptions) -> Result<Self, AuditError> {
        let Filling::Beads { .. } = sensor.dielectric.filling else {
            return Err(AuditError::Lacks { sensor: sensor.name.clone(), part: "beads" });
        };
        let mut whole = Self { sensor, device, beads, options, ring_expansion: 0.0 };
        whole.ring_expansion = whole.matched_expansion()?;
        Ok(whole)
    }

    /// The expansion of a ring's height is `plates + g (own - plates)`, with g from one kelvin under a fixed plate.
    fn matched_expansion(&self) -> Result<f64, AuditError> {
        let mut disc = self.section(0.0, self.sensor.reference_c)?;
        let Some(beads) = disc.beads else { return Ok(0.0) };
        let own = self.sensor.dielectric.layer.material.expansion;
        let push = |disc: &mut Disc, expansion: f64| {
            disc.beads = Some(BeadSpring { expansion, ..beads });
            disc.flattened(1.0, 0.0)
        };
        let (hot, still) = (push(&mut disc, own)?, push(&mut disc, 0.0)?);
        let stiffness = disc.flattened(0.0, AT_REST * beads.height)? / (AT_REST * beads.height);
        let g = (hot - still) / (stiffness * own * beads.height);
        let plates = self.sensor.conductor.material.expansion;
        Ok(plates + (self.beads.expansion - plates) / g)
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
        self.charge(disc, carried, temperature_c)
    }

    /// The same with the electrode held flat by a rigid plate that also pulls: what is left of [`Whole::solve`] where nothing bends.
    ///
    /// # Errors
    /// As [`Whole::solve`].
    pub fn solve_flat(&self, force_n: f64, temperature_c: f64) -> Result<Coupled, AuditError> {
        let disc = self.disc(force_n, temperature_c)?;
        let carried = disc.held_flat(temperature_c - self.sensor.reference_c, force_n)?;
        self.charge(disc, carried, temperature_c)
    }

    /// The field on a deformed disc.
    fn charge(&self, disc: Disc, carried: Carried, temperature_c: f64) -> Result<Coupled, AuditError> {
        let deformed = carried.solution.deformed_mesh();
        let field = field(&deformed, &|region| self.permittivity(region), self.options.target)?;
        let charged = self.charged(&field, temperature_c);
        Ok(Coupled { disc, carried, deformed, field, charged, kelvin: temperature_c - self.sensor.reference_c })
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
        let mut disc = self.section(force_n, temperature_c)?;
        let (Some(beads), Rings::Rubber { young, poisson }) = (disc.beads, disc.rings) else { return Ok(disc) };
        let stiffness = PI * disc.plate.radius * disc.plate.radius * beads.stiffness();
        // A ring is stiffer or softer than a bead of the same rubber; force goes with the modulus, so one solution tells by how much.
        let travel = (force_n / stiffness).max(AT_REST * beads.height);
        let found = disc.flattened(0.0, travel)?;
        disc.rings = Rings::Rubber { young: young * travel * stiffness / found, poisson };
        Ok(disc)
    }

    /// The disc with rings of the bead's apparent modulus.
    fn section(&self, force_n: f64, temperature_c: f64) -> Result<Disc, AuditError> {
        let warm = self.device.at(temperature_c);
        let mut beads = BeadSpring::new(self.sensor, &warm, force_n, &self.beads.strain)?;
        // strain is of the height that the beads have grown to, freely or held
        beads.young *= (1.0 + beads.expansion * warm.kelvin) / (1.0 + self.beads.expansion * warm.kelvin);
        beads.expansion = self.ring_expansion;
        let facing = Facing {
            sheet: Sheet::of("facing", &self.sensor.insulator),
            shield_expansion: self.sensor.conductor.material.expansion,
        };
        let plate = Laminate::backed(self.sensor);
        let gap = Gap::Rings { height: beads.height, coverage: beads.coverage, zones: BeadSpring::zones(self.sensor) };
        let section = Section::new(&plate, &gap, Some(facing.sheet.thickness), self.options.fineness)?;
        let rings = Rings::Rubber { young: beads.young, poisson: self.sensor.dielectric.layer.material.poisson };
        Ok(Disc { plate, section, beads: Some(beads), rings, facing: Some(facing), air: true, strains: Strains::Large })
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
        // the insulator of the tail is bonded to its conductors like that of the disc
        let film = Sheet::of("tail", &self.sensor.insulator);
        let growth = film.held_growth(self.sensor.conductor.material.expansion);
        let insulator = film.thickness * (1.0 + growth * (temperature_c - self.sensor.reference_c));
        Charged {
            main: field.main,
            backing: shown * field.backing,
            tail: shown * tail_capacitance(self.permittivity("backing"), trace, insulator),
            stray: self.sensor.stray.value,
            error_estimate: field.error_estimate,
        }
    }
}
