//! Two plates near one point: the columns that are as they were there are not computed again.
//!
//! Limits: what it answers is what the plates answer, to the last bit; a column is taken over whole or not at all.

use super::plate_columns::{Filled, relative_capacitances};
use std::cell::RefCell;
use truegap_core::{
    Beside, Dielectric, Drive, Geometry, Inputs, PlateColumns, Readings, Readout, RefusedRow, SimulationError, Simulator, Stage,
    same_column, walk,
};

/// Columns of the plates at a point.
#[derive(Default)]
struct Columns {
    load: Vec<f64>,
    modulus: Vec<f64>,
    stiffening: [f64; 2],
    elastic: Vec<f64>,
    strain: Vec<f64>,
    gap: Vec<f64>,
    tilt: Vec<f64>,
    sag: Vec<f64>,
    beads: Vec<f64>,
    relative: Vec<f64>,
}

/// Plates whose columns are kept.
pub(super) struct Near<'s> {
    plates: &'s dyn Simulator,
    inputs: &'s Inputs,
    modulus: f64,
    columns: Columns,
}

impl<'s> Near<'s> {
    /// The point itself, with `stages` plugged in.
    pub fn at(
        plates: &'s dyn Simulator,
        values: &[f64],
        inputs: &'s Inputs,
        stages: &[&dyn Stage],
    ) -> Result<Self, SimulationError> {
        let kept = Kept { here: Filled::of(plates, values)?, columns: RefCell::default() };
        walk(plates, &kept, values, inputs, stages)?;
        Ok(Self { plates, inputs, modulus: kept.here.modulus, columns: kept.columns.into_inner() })
    }
}

impl Beside for Near<'_> {
    fn respond(&self, values: &[f64], stages: &[&dyn Stage]) -> Result<Vec<f64>, SimulationError> {
        let moved = Moved { near: self, there: Filled::of(self.plates, values)? };
        walk(self.plates, &moved, values, self.inputs, stages)
    }
}

/// Computes every column, and keeps it.
struct Kept {
    here: Filled,
    columns: RefCell<Columns>,
}

impl PlateColumns for Kept {
    fn strains(&self, drive: &Drive<'_>, modulus: &[f64], stiffening: [f64; 2]) -> Result<Vec<f64>, RefusedRow> {
        let elastic = self.here.strains(drive, modulus, stiffening)?;
        let mut columns = self.columns.borrow_mut();
        (columns.load, columns.modulus) = (drive.load.to_vec(), modulus.to_vec());
        (columns.stiffening, columns.elastic) = (stiffening, elastic.clone());
        Ok(elastic)
    }

    fn readings(&self, _: &Drive<'_>, geometry: &Geometry<'_>, factors: &Dielectric) -> Result<Readings, RefusedRow> {
        let mut columns = self.columns.borrow_mut();
        columns.relative = relative_capacitances(geometry, factors)?;
        (columns.strain, columns.gap) = (geometry.strain.to_vec(), geometry.gap.clone());
        (columns.tilt, columns.sag, columns.beads) = (geometry.tilt.clone(), geometry.sag.clone(), factors.beads.clone());
        Ok(self.here.readings_of(&columns.relative))
    }

    fn readout(&self) -> Result<Readout, SimulationError> {
        self.here.readout()
    }
}

/// Plates and stages near the point.
struct Moved<'a> {
    near: &'a Near<'a>,
    there: Filled,
}

impl PlateColumns for Moved<'_> {
    fn strains(&self, drive: &Drive<'_>, modulus: &[f64], stiffening: [f64; 2]) -> Result<Vec<f64>, RefusedRow> {
        let columns = &self.near.columns;
        let same = self.there.modulus == self.near.modulus && stiffening == columns.stiffening;
        if same && same_column(drive.load, &columns.load) && same_column(modulus, &columns.modulus) {
            return Ok(columns.elastic.clone());
        }
        self.there.strains(drive, modulus, stiffening)
    }

    fn readings(&self, drive: &Drive<'_>, geometry: &Geometry<'_>, factors: &Dielectric) -> Result<Readings, RefusedRow> {
        let columns = &self.near.columns;
        let same = same_column(geometry.strain, &columns.strain)
            && same_column(&geometry.gap, &columns.gap)
            && same_column(&geometry.tilt, &columns.tilt)
            && same_column(&geometry.sag, &columns.sag)
            && same_column(&factors.beads, &columns.beads);
        if same { Ok(self.there.readings_of(&columns.relative)) } else { self.there.readings(drive, geometry, factors) }
    }

    fn readout(&self) -> Result<Readout, SimulationError> {
        self.there.readout()
    }
}
