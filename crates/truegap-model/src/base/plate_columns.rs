//! Physics of two plates on a dielectric of unknown size: strains and unloaded capacitances, column by column.
//!
//! Limits: no field outside of the plates.

use crate::equations::load::{BeadLaw, compressive_strain, compressive_strains};
use crate::wedge::shape_factor;
use truegap_core::{
    Dielectric, Drive, Geometry, PlateColumns, Readings, Readout, Refusal, RefusedRow, SimulationError, Simulator, named_values,
};

/// The plates with parameter values filled in.
#[derive(Clone, Copy)]
pub(super) struct Filled {
    pub offset: f64,
    pub gain: f64,
    pub modulus: f64,
}

impl Filled {
    /// The values of a simulator of such plates, by their names.
    pub fn of(simulator: &dyn Simulator, values: &[f64]) -> Result<Self, SimulationError> {
        let [offset, gain, modulus] = named_values(simulator, values)?;
        Ok(Self { offset, gain, modulus })
    }

    /// What is read of unloaded capacitances.
    pub fn readings_of(&self, relative: &[f64]) -> Readings {
        Readings { value: relative.iter().map(|relative| self.offset + self.gain * relative).collect(), gap: None }
    }
}

impl PlateColumns for Filled {
    fn strains(&self, drive: &Drive<'_>, modulus: &[f64], stiffening: [f64; 2]) -> Result<Vec<f64>, RefusedRow> {
        let law = BeadLaw { poisson: 0.0, stiffening };
        let reduced: Vec<f64> = drive.load.iter().zip(modulus).map(|(load, modulus)| load / (self.modulus * modulus)).collect();
        let strains = compressive_strains(&reduced, law);
        if strains.iter().fold(true, |all, strain| all & strain.is_finite()) {
            return Ok(strains);
        }
        let refused = |row: &usize| compressive_strain(reduced[*row], law).is_none_or(|strain| !strain.is_finite());
        let first = (0..reduced.len()).find(refused).unwrap_or(0);
        let closes = drive.load[first] > 0.0 && modulus[first] > 0.0;
        Err((first, if closes { Refusal::Touches { strain: 1.0 } } else { Refusal::NoAnswer }))
    }

    fn readings(&self, _: &Drive<'_>, geometry: &Geometry<'_>, factors: &Dielectric) -> Result<Readings, RefusedRow> {
        Ok(self.readings_of(&relative_capacitances(geometry, factors)?))
    }

    fn readout(&self) -> Result<Readout, SimulationError> {
        Ok(Readout { zero: self.offset + self.gain, span: self.gain / (self.modulus - 1.0) })
    }
}

/// Unloaded capacitances: strain, extra gap, shape and permittivity of each row.
pub(super) fn relative_capacitances(geometry: &Geometry<'_>, factors: &Dielectric) -> Result<Vec<f64>, RefusedRow> {
    let rows = 0..geometry.strain.len();
    let gap = |row: usize| (1.0 - geometry.strain[row]) / factors.beads[row] + geometry.gap[row];
    let none = |column: &[f64]| column.iter().fold(true, |all, value| all & (*value == 0.0));
    let apart = |row: usize| (1.0 - geometry.strain[row] > 0.0) & (gap(row) > 0.0);
    // flat plates that touch nowhere need no row by itself
    if none(&geometry.tilt) && none(&geometry.sag) && rows.clone().fold(true, |all, row| all & apart(row)) {
        return Ok(rows.map(|row| 1.0 / gap(row)).collect());
    }
    let mut relative = Vec::with_capacity(rows.len());
    for row in rows {
        let shape = shape_factor(geometry.tilt[row], geometry.sag[row] / (1.0 - geometry.strain[row])).filter(|_| apart(row));
        relative.push(shape.ok_or((row, Refusal::Touches { strain: geometry.strain[row] }))? / gap(row));
    }
    Ok(relative)
}
