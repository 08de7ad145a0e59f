//! What the tables give for one sensor, and the analytic chain with it.
//!
//! Limits: as [`super::Corrected`]; smooth in load and temperature but for the loads at which a load plate touches at another place.

use super::{
    bead_law::BeadLaw,
    bonded::BondedLayers,
    library::library,
    one_sensor::{check_permittivities, field},
    parts::Parts,
    table::Table,
    warped::{BeadsAt, Warp, Warped},
};
use crate::{
    cell::{Cell, Growth},
    error::AuditError,
};
use truegap_core::{Sensor, VACUUM_PERMITTIVITY, sensor::Layout};
use truegap_model::{
    StackOptions,
    stack::{Capacitances, Device, Refusal, Warm},
};

/// What the tables give for one sensor.
#[derive(Clone, Debug)]
pub(super) struct Pieces {
    pub device: Device,
    pub beads: BeadLaw,
    /// over (temperature above the reference, strain)
    pub field: Table,
    pub rim: Table,
    pub tail: f64,
    pub growth: Growth,
    pub layers: BondedLayers,
    pub warp: Warp,
}

impl Pieces {
    pub(super) fn new(sensor: &Sensor) -> Result<Self, AuditError> {
        let lacks = |part| AuditError::Lacks { sensor: sensor.name.clone(), part };
        if sensor.layout != Layout::Shielded {
            return Err(lacks("shields, for which the field at the rim is tabulated"));
        }
        let (cell, tables) = (Cell::of(sensor)?, library()?);
        check_permittivities(sensor)?;
        let compressibility = 1.0 - 2.0 * cell.poisson;
        let s = cell.shape_factor();
        let radius = 0.5 * sensor.diameter.value;
        let electrode = sensor.conductor.thickness.value + sensor.plating.as_ref().map_or(0.0, |p| p.thickness.value);
        let growth = Growth::of(sensor, tables.held_expansion.at(&[s, compressibility])?);
        let tail = match sensor.tail {
            (length, width) if length * width > 0.0 => {
                tables.tail_edge.at(&[width / cell.film, sensor.conductor.thickness.value / cell.film])?
            }
            _ => 1.0,
        };
        let beads = BeadLaw::of(&cell, tables)?;
        let layers = BondedLayers::of(sensor);
        let device = Device::new(&layers.sensor, StackOptions { warp: false, ..StackOptions::default() });
        let cold_area = device.warmed_by(0.0).areas.solid;
        let state = |kelvin: f64, strain: f64| {
            let mut warm = device.warmed_by(kelvin);
            growth.apply(&mut warm);
            let stiffness = warm.young * beads.tangent(strain)? * warm.areas.solid / (cold_area * warm.layers.beads);
            let force = warm.young * warm.areas.solid * beads.load(strain)?;
            Ok((BeadsAt { gap: warm.layers.beads * (1.0 - strain), stiffness }, force))
        };
        Ok(Self {
            warp: Warp::of(&Warped::of(sensor)?, state)?,
            field: field(tables, &device, growth, &cell)?,
            rim: tables.rim_field.given(&[cell.film / radius, electrode / radius])?,
            beads,
            device,
            tail,
            growth,
            layers,
        })
    }

    /// The warm sensor with beads whose faces are held.
    pub(super) fn warm(&self, temperature_c: f64) -> Warm {
        let mut warm = self.device.at(temperature_c);
        self.growth.apply(&mut warm);
        warm
    }

    /// Strain of the beads of a warm sensor under a force (N).
    pub(super) fn strain(&self, warm: &Warm, force_n: f64) -> Result<f64, AuditError> {
        self.beads.strain(force_n / (warm.areas.solid * warm.young))
    }

    /// Capacitance of the flat gap by the field of its cells, F, and what the field at the rim adds, F: between cells of that capacitance the rim sees
    /// one medium.
    pub(super) fn field_and_rim(&self, warm: &Warm, strain: f64, flat: &Capacitances) -> Result<[f64; 2], AuditError> {
        let main = flat.shares.main * self.field.at(&[warm.kelvin, strain])?;
        let gap = warm.layers.beads * (1.0 - strain);
        let medium = gap / (warm.areas.electrode * VACUUM_PERMITTIVITY * (1.0 / main - 1.0 / flat.insulator));
        Ok([main, VACUUM_PERMITTIVITY * warm.radius * self.rim.at(&[medium, gap / warm.radius])?])
    }

    /// What is added up at a force (N) and a temperature (degrees Celsius).
    pub(super) fn parts(&self, force_n: f64, temperature_c: f64) -> Result<Parts, AuditError> {
        let warm = self.warm(temperature_c);
        let strain = self.strain(&warm, force_n)?;
        let row = self.device.plain(&warm, force_n, strain);
        let refuse = |refusal| {
            let strain = if let Refusal::Touches { strain } = refusal { strain } else { f64::NAN };
            AuditError::NoResponse { force_n, temperature_c, strain }
        };
        let flat = self.device.capacitances(&warm, &row).map_err(refuse)?;
        let [main, rim] = self.field_and_rim(&warm, strain, &flat)?;
        let bent = self.warp.gains(warm.kelvin, force_n);
        let thicker = 1.0 + self.layers.backing_per_kelvin * warm.kelvin;
        Ok(Parts {
            main: 1e12 * main * (1.0 + bent.main),
            backing: 1e12 * flat.shares.backing * (1.0 + bent.backing) / thicker,
            rim: 1e12 * rim,
            tail: 1e12 * flat.shares.tail * self.tail,
            stray: 1e12 * self.layers.sensor.stray.value,
        })
    }
}
