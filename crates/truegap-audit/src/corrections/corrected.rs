//! The analytic chain with finite elements' answers in the place of its broken pieces, at its own speed.
//!
//! Limits: bonded beads that hold the electrode flat; the box of each table; shielded layout; full contact (no lift-off), no bending between beads.

use super::{Axis, Table, library, make};
use crate::{
    AuditError,
    assumptions::cell::filled,
    cell::{Cell, Growth},
    fit::Chebyshev,
};
use truegap_core::{
    Inputs, Parameter, Role, Sensor, SimulationError, Simulator, Stage, VACUUM_PERMITTIVITY, sensor::Layout, simulator::StageName,
};
use truegap_model::{
    Stack, StackOptions,
    stack::{Device, Refusal, Warm},
};

/// The corrected model of one sensor.
#[derive(Clone, Debug)]
pub struct Corrected {
    sensor: Sensor,
    stack: Stack,
    pieces: Pieces,
}

/// What the tables give for one sensor.
#[derive(Clone, Debug)]
struct Pieces {
    device: Device,
    secant: Chebyshev,
    /// over (temperature above the reference, strain)
    field: Table,
    rim: Table,
    tail: f64,
    growth: Growth,
    softest: f64,
}

impl Corrected {
    /// The corrected model of a sensor.
    ///
    /// # Errors
    /// [`AuditError::Uncovered`] where the sensor lies outside of a table, [`AuditError::Lacks`] without beads or shields.
    pub fn new(sensor: &Sensor) -> Result<Self, AuditError> {
        let options = StackOptions { warp: false, ..StackOptions::default() };
        Ok(Self { sensor: sensor.clone(), stack: Stack::new(sensor, options), pieces: Pieces::new(sensor)? })
    }

    /// The sensor.
    pub fn sensor(&self) -> &Sensor {
        &self.sensor
    }

    /// What is read at a force (N) and a temperature (degrees Celsius), pF.
    ///
    /// # Errors
    /// [`AuditError::Uncovered`] where the beads are squeezed beyond their table.
    pub fn capacitance_pf(&self, force_n: f64, temperature_c: f64) -> Result<f64, AuditError> {
        self.pieces.capacitance_pf(force_n, temperature_c)
    }

    /// Strain of the beads at a force (N) and a temperature (degrees Celsius).
    ///
    /// # Errors
    /// As [`Corrected::capacitance_pf`].
    pub fn strain(&self, force_n: f64, temperature_c: f64) -> Result<f64, AuditError> {
        let warm = self.pieces.warm(temperature_c);
        self.pieces.strain(force_n / (warm.areas.solid * warm.young))
    }
}

impl Pieces {
    fn new(sensor: &Sensor) -> Result<Self, AuditError> {
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
        let secant = curve(&tables.bead_load.given(&[s, compressibility])?);
        let device = Device::new(sensor, StackOptions { warp: false, ..StackOptions::default() });
        Ok(Self {
            softest: secant.at(0.0)?,
            secant,
            field: field(&tables.cell_field, &device, growth, &cell)?,
            rim: tables.rim_field.given(&[cell.film / radius, electrode / radius])?,
            device,
            tail,
            growth,
        })
    }

    /// The warm sensor with beads whose faces are held.
    fn warm(&self, temperature_c: f64) -> Warm {
        let mut warm = self.device.at(temperature_c);
        self.growth.apply(&mut warm);
        warm
    }

    /// Strain at a load over modulus and area, by Newton's method on e k(e).
    fn strain(&self, reduced_load: f64) -> Result<f64, AuditError> {
        let mut strain = (reduced_load / self.softest).clamp(0.0, self.secant.high);
        for _ in 0..50 {
            let step = 1e-4 * self.secant.high;
            let (low, high) = ((strain - step).max(0.0), (strain + step).min(self.secant.high));
            let load = |e: f64| Ok::<f64, AuditError>(e * self.secant.at(e)?);
            let slope = (load(high)? - load(low)?) / (high - low);
            let next = strain - (load(strain)? - reduced_load) / slope;
            if (next - strain).abs() <= 1e-12 {
                // an argument beyond the table is refused here
                self.secant.at(next)?;
                return Ok(next);
            }
            strain = if next > self.secant.high { 0.5 * (strain + self.secant.high) } else { next.max(0.0) };
        }
        let what = "load over modulus and bead area".to_owned();
        let high = self.secant.high * self.secant.at(self.secant.high)?;
        Err(AuditError::Uncovered { what, value: reduced_load, low: 0.0, high, remedy: "take a smaller load" })
    }

    fn capacitance_pf(&self, force_n: f64, temperature_c: f64) -> Result<f64, AuditError> {
        let warm = self.warm(temperature_c);
        let strain = self.strain(force_n / (warm.areas.solid * warm.young))?;
        let row = self.device.plain(&warm, force_n, strain);
        let refuse = |refusal| {
            let strain = if let Refusal::Touches { strain } = refusal { strain } else { f64::NAN };
            AuditError::NoResponse { force_n, temperature_c, strain }
        };
        let mut parts = self.device.capacitances(&warm, &row).map_err(refuse)?;
        let gap = warm.layers.beads * (1.0 - strain);
        let mixed = parts.beads * gap / (warm.areas.electrode * VACUUM_PERMITTIVITY);
        parts.shares.main *= self.field.at(&[warm.kelvin, strain])?;
        parts.shares.main += VACUUM_PERMITTIVITY * warm.radius * self.rim.at(&[mixed, gap / warm.radius])?;
        parts.shares.tail *= self.tail;
        Ok(self.device.total(parts.shares) * 1e12)
    }
}

/// Temperatures above the reference that the corrected model covers, K.
const KELVIN: [f64; 2] = [-30.0, 40.0];

/// Field over mixture of a sensor over (temperature above the reference, strain): the bead as heat has left it, by its mean area and its height.
fn field(table: &Table, device: &Device, growth: Growth, cell: &Cell) -> Result<Table, AuditError> {
    let strains = table.axes.last().cloned().unwrap_or_else(|| Axis::linear("compressive strain", 0.0, make::GREATEST_STRAIN, 1));
    let axes = vec![Axis::linear("temperature above the reference (K)", KELVIN[0], KELVIN[1], 3), strains];
    let cold_area = device.warmed_by(0.0).areas.solid;
    let factor = |p: &Vec<f64>| {
        let mut warm = device.warmed_by(p[0]);
        growth.apply(&mut warm);
        let wider = (warm.areas.solid / cold_area).sqrt();
        let shape = cell.shape_factor() * wider * cell.height / warm.layers.beads;
        let coverage = warm.areas.solid / warm.areas.electrode;
        table.at(&[shape, coverage, warm.layers.insulator / warm.layers.beads, p[1]])
    };
    let values = Table::nodes(&axes).iter().map(factor).collect::<Result<Vec<_>, _>>()?;
    Ok(Table::interpolating(&table.id, &table.says, axes, values))
}

/// A table of one argument as a curve.
fn curve(table: &Table) -> Chebyshev {
    let (low, high) = table.axes.first().map_or((0.0, 0.0), |axis| (axis.low, axis.high));
    Chebyshev { low, high, coefficients: table.coefficients.clone() }
}

fn check_permittivities(sensor: &Sensor) -> Result<(), AuditError> {
    let (has, wants) = (filled(sensor), make::PERMITTIVITIES);
    let pairs = [("bead", has.bead, wants.bead), ("air", has.air, wants.air), ("insulator", has.film, wants.film)];
    match pairs.into_iter().find(|(_, a, b)| (a / b - 1.0).abs() > 1e-3) {
        None => Ok(()),
        Some((part, value, wanted)) => {
            let what = format!("relative permittivity of the {part}");
            let remedy = "the fields are tabulated for the paper's permittivities; run `truegap audit`, which computes";
            Err(AuditError::Uncovered { what, value, low: wanted, high: wanted, remedy })
        }
    }
}

/// Why no stage plugs in.
const COMPLETE: &str = "the corrected model has its own beads, geometry and field; plug effects into the model `stack`";

impl Simulator for Corrected {
    fn name(&self) -> &str {
        "corrected"
    }

    fn unit(&self) -> &str {
        "pF"
    }

    fn parameters(&self) -> &[Parameter] {
        self.stack.parameters()
    }

    fn needs(&self) -> &[Role] {
        &[Role::Force]
    }

    fn lacks(&self, _stage: StageName) -> Option<&'static str> {
        Some(COMPLETE)
    }

    fn full_load(&self) -> Option<f64> {
        Some(self.sensor.full_scale)
    }

    fn warps(&self) -> Option<bool> {
        Some(false)
    }

    fn reference_c(&self) -> f64 {
        self.sensor.reference_c
    }

    fn load(&self, inputs: &Inputs) -> Option<Vec<f64>> {
        self.stack.load(inputs)
    }

    /// Response of each row; stages are left out, as [`Simulator::lacks`] says. A row beyond the tables counts as a gap that closes.
    fn respond(&self, values: &[f64], inputs: &Inputs, _stages: &[&dyn Stage]) -> Result<Vec<f64>, SimulationError> {
        let missing = || SimulationError::MissingColumn { model: self.name().to_owned(), role: Role::Force };
        let force = inputs.force_n.as_ref().ok_or_else(missing)?;
        let outside = || SimulationError::NotFinite { row: 0, value: f64::NAN, parameters: values.to_vec() };
        let pieces = Pieces::new(&self.stack.calibrated(values)).map_err(|_| outside())?;
        let row = |(row, &force_n): (usize, &f64)| {
            let temperature = inputs.temperature_c.as_ref().map_or(self.sensor.reference_c, |t| t[row]);
            let beyond = |_| SimulationError::GapCloses { row, load_si: force_n, strain: make::GREATEST_STRAIN };
            pieces.capacitance_pf(force_n, temperature).map_err(beyond)
        };
        force.iter().enumerate().map(row).collect()
    }
}
