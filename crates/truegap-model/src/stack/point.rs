//! The stack at one point: every column that the walk comes by, and the slopes of its readings.
//!
//! Limits: one point; a row that has no answer leaves none.

use super::{
    device::Device,
    plates::{PICO, ends, force_n},
    sloped::{BESIDE, QUANTITIES, Shape, aspect, at, sloped},
};
use crate::equations::load::{BeadLaw, reduced_load_slope};
use std::cell::RefCell;
use truegap_core::{
    Dielectric, Drive, GapReadings, Geometry, PlateColumns, Readings, Readout, Refusal, RefusedRow, SimulationError,
};

/// Columns of the stack at a point.
#[derive(Default)]
pub(super) struct Point {
    /// load over full load
    pub load: Vec<f64>,
    pub temperature_c: Vec<f64>,
    /// factor on the modulus
    pub modulus: Vec<f64>,
    pub stiffening: [f64; 2],
    /// strain before its history
    pub elastic: Vec<f64>,
    /// strain for one unit of reduced load
    pub yielding: Vec<f64>,
    pub warp_factor: f64,
    pub warp_kelvin: Vec<f64>,
    /// extra gap and sag as stages give them
    pub gap: Vec<f64>,
    pub sag: Vec<f64>,
    /// factors on the permittivities
    pub beads: Vec<f64>,
    pub insulator: Vec<f64>,
    /// curvature for one kelvin of warp
    pub bend: Vec<f64>,
    /// what the capacitances are computed from
    pub shape: [Vec<f64>; QUANTITIES],
    /// main gap, F, and its slopes by each quantity
    pub main: Vec<f64>,
    pub by: [Vec<f64>; QUANTITIES],
    /// insulator behind the electrode and tail, F, and its slopes by the quantities of [`BESIDE`]
    pub beside: Vec<f64>,
    pub beside_by: [Vec<f64>; BESIDE.len()],
    /// mean separation of the electrodes over their radius
    pub aspect: Vec<f64>,
}

impl Point {
    /// Room for the readings of so many rows.
    fn allot(&mut self, rows: usize) {
        let Self { bend, shape, main, by, beside, beside_by, aspect, .. } = self;
        let readings = [bend, main, beside, aspect].into_iter().chain(shape).chain(by).chain(beside_by);
        readings.for_each(|column| *column = vec![0.0; rows]);
    }
}

/// Computes every row with its slopes, and keeps them.
pub(super) struct Kept<'a> {
    device: &'a Device,
    values: &'a [f64],
    point: RefCell<Point>,
}

impl<'a> Kept<'a> {
    pub fn new(device: &'a Device, values: &'a [f64]) -> Self {
        Self { device, values, point: RefCell::default() }
    }

    pub fn into_point(self) -> Point {
        self.point.into_inner()
    }
}

impl PlateColumns for Kept<'_> {
    fn strains(&self, drive: &Drive<'_>, modulus: &[f64], stiffening: [f64; 2]) -> Result<Vec<f64>, RefusedRow> {
        let device = self.device;
        let law = BeadLaw { poisson: device.poisson, stiffening };
        let mut elastic = Vec::with_capacity(modulus.len());
        for (row, &modulus) in modulus.iter().enumerate() {
            let warm = device.at(drive.temperature_c[row]);
            let strain = device.strain(&warm, force_n(drive, row), modulus, stiffening);
            elastic.push(strain.map_err(|refusal| (row, refusal))?);
        }
        let mut point = self.point.borrow_mut();
        point.load = drive.load.to_vec();
        point.temperature_c = drive.temperature_c.to_vec();
        point.modulus = modulus.to_vec();
        point.stiffening = stiffening;
        point.yielding = elastic.iter().map(|strain| reduced_load_slope(law, *strain).recip()).collect();
        point.elastic.clone_from(&elastic);
        Ok(elastic)
    }

    fn warp_factor(&self) -> f64 {
        self.device.warp_factor()
    }

    fn readings(&self, drive: &Drive<'_>, geometry: &Geometry<'_>, factors: &Dielectric) -> Result<Readings, RefusedRow> {
        let device = self.device;
        let point = &mut *self.point.borrow_mut();
        let (rows, cold) = (drive.load.len(), device.rubber.thickness);
        point.allot(rows);
        for row in 0..rows {
            let warm = device.at(drive.temperature_c[row]);
            let bend = device.bend(&warm, 1.0);
            let mut shape: Shape = [0.0; QUANTITIES];
            shape[at::CURVATURE] = geometry.warp_factor * geometry.warp_kelvin[row] * bend;
            shape[at::RADIUS] = warm.radius;
            shape[at::SOLID] = warm.areas.solid;
            shape[at::BEADS] = warm.layers.beads;
            shape[at::INSULATOR] = warm.layers.insulator;
            shape[at::STRAIN] = geometry.strain[row];
            shape[at::FORCE] = force_n(drive, row);
            shape[at::EXTRA] = geometry.gap[row] * cold;
            shape[at::TILT] = geometry.tilt[row];
            shape[at::SAG] = geometry.sag[row] * cold;
            shape[at::SOLID_PERMITTIVITY] = device.rubber.permittivity * factors.beads[row];
            shape[at::BEHIND] = device.insulator.permittivity * factors.insulator[row];
            let sloped = sloped(device, &shape).ok_or((row, Refusal::Touches { strain: geometry.strain[row] }))?;
            point.bend[row] = bend;
            point.shape.iter_mut().zip(shape).for_each(|(column, value)| column[row] = value);
            point.by.iter_mut().zip(sloped.by).for_each(|(column, value)| column[row] = value);
            point.beside_by.iter_mut().zip(sloped.beside_by).for_each(|(column, value)| column[row] = value);
            (point.main[row], point.beside[row], point.aspect[row]) = (sloped.main, sloped.beside, aspect(device, &shape));
        }
        point.warp_factor = geometry.warp_factor;
        point.warp_kelvin.clone_from(&geometry.warp_kelvin);
        point.gap.clone_from(&geometry.gap);
        point.sag.clone_from(&geometry.sag);
        point.beads.clone_from(&factors.beads);
        point.insulator.clone_from(&factors.insulator);
        let value = point.main.iter().zip(&point.beside).map(|(main, beside)| (main + beside + device.stray) * PICO).collect();
        let plates = point.main.iter().map(|main| main * PICO).collect();
        Ok(Readings { value, gap: Some(GapReadings { aspect: point.aspect.clone(), plates }) })
    }

    fn readout(&self) -> Result<Readout, SimulationError> {
        ends(self.device, self.values)
    }
}
