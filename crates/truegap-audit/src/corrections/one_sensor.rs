//! Tables with one sensor's numbers put in.
//!
//! Limits: the paper's permittivities; temperatures within [`KELVIN`] of the reference.

use super::{
    library::Library,
    range,
    table::{Axis, Table},
};
use crate::{
    cell::{Cell, Growth, filled},
    error::AuditError,
    fit::Chebyshev,
};
use truegap_core::Sensor;
use truegap_model::stack::Device;

/// Temperatures above the reference that the corrected model covers, K.
pub(super) const KELVIN: [f64; 2] = [-30.0, 40.0];

/// Field over mixture of a sensor over (temperature above the reference, strain): the bead as heat has left it, by its mean area and its height.
pub(super) fn field(tables: &Library, device: &Device, growth: Growth, cell: &Cell) -> Result<Table, AuditError> {
    let table = &tables.cell_field;
    let heat_per_kelvin = (growth.free - growth.plates) / range::HEAT;
    let strains =
        table.axes.last().cloned().unwrap_or_else(|| Axis::linear("compressive strain", 0.0, range::GREATEST_STRAIN, 1));
    let axes = vec![Axis::linear("temperature above the reference (K)", KELVIN[0], KELVIN[1], 3), strains];
    let cold_area = device.warmed_by(0.0).areas.solid;
    let factor = |p: &Vec<f64>| -> Result<f64, AuditError> {
        let mut warm = device.warmed_by(p[0]);
        growth.apply(&mut warm);
        let wider = (warm.areas.solid / cold_area).sqrt();
        let shape = cell.shape_factor() * wider * cell.height / warm.layers.beads;
        let coverage = warm.areas.solid / warm.areas.electrode;
        let film = warm.layers.insulator / warm.layers.beads;
        let heated = tables.heated_field.at(&[cell.shape_factor(), cell.coverage(), cell.film / cell.height, p[1]])?;
        Ok(table.at(&[shape, coverage, film, p[1]])? * (1.0 + (heated - 1.0) * heat_per_kelvin * p[0]))
    };
    let values = Table::nodes(&axes).iter().map(factor).collect::<Result<Vec<_>, _>>()?;
    Ok(Table::interpolating(&table.id, &table.says, axes, values))
}

/// A table of one argument as a curve.
pub(super) fn curve(table: &Table) -> Chebyshev {
    let (low, high) = table.axes.first().map_or((0.0, 0.0), |axis| (axis.low, axis.high));
    Chebyshev { low, high, coefficients: table.coefficients.clone() }
}

pub(super) fn check_permittivities(sensor: &Sensor) -> Result<(), AuditError> {
    let (has, wants) = (filled(sensor), range::PERMITTIVITIES);
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
