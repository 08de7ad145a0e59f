//! The rows of a recording through the chain: without stages in one pass, with stages a column at a time.
//!
//! Limits: an error names the first row that has no answer.

use super::{
    device::{Device, Squeeze},
    refused,
};
use crate::base::{check_finite, stiffening};
use truegap_core::{Dielectric, Drive, FieldView, Geometry, Readout, SimulationError, Stage};

/// Picofarad in a farad.
const PICO: f64 = 1e12;

/// Response of each row, pF, nothing plugged in.
pub(super) fn plain(
    device: &Device,
    force: &[f64],
    temperature: Option<&[f64]>,
    values: &[f64],
) -> Result<Vec<f64>, SimulationError> {
    let mut warm = device.at(device.reference_c);
    let mut at = device.reference_c;
    let mut response = Vec::with_capacity(force.len());
    for (row, &force) in force.iter().enumerate() {
        let now = temperature.map_or(device.reference_c, |t| t[row]);
        if now != at {
            (warm, at) = (device.at(now), now);
        }
        let parts =
            device.strain(&warm, force, 1.0, [0.0; 2]).and_then(|e| device.capacitances(&warm, &device.plain(&warm, force, e)));
        let parts = parts.map_err(|refusal| refused(refusal, row, force, values))?;
        response.push(device.total(parts.shares) * PICO);
    }
    check_finite(response, values)
}

/// Response of each row, pF, stages plugged in.
pub(super) fn staged(
    device: &Device,
    drive: &Drive<'_>,
    stages: &[&dyn Stage],
    values: &[f64],
) -> Result<Vec<f64>, SimulationError> {
    let strain = strains(device, drive, stages, values)?;
    let rows = drive.load.len();
    let warp_kelvin = drive.temperature_c.iter().map(|t| t - drive.reference_c).collect();
    let mut geometry = Geometry {
        strain: &strain,
        gap: vec![0.0; rows],
        warp_kelvin,
        warp_factor: device.warp_factor(),
        tilt: vec![0.0; rows],
        sag: vec![0.0; rows],
    };
    stages.iter().for_each(|stage| stage.geometry(drive, &mut geometry));
    let mut factors = Dielectric { beads: vec![1.0; rows], insulator: vec![1.0; rows] };
    stages.iter().for_each(|stage| stage.dielectric(drive, &mut factors));

    let (mut plates, mut value, mut aspect) = (Vec::with_capacity(rows), Vec::with_capacity(rows), Vec::with_capacity(rows));
    for (row, &strain) in strain.iter().enumerate() {
        let force_n = drive.load[row] * drive.full_load;
        let squeeze = Squeeze {
            force_n,
            strain,
            warp_kelvin: geometry.warp_kelvin[row],
            warp_factor: geometry.warp_factor,
            gap: geometry.gap[row],
            tilt: geometry.tilt[row],
            sag: geometry.sag[row],
            beads: factors.beads[row],
            insulator: factors.insulator[row],
        };
        let warm = device.at(drive.temperature_c[row]);
        let parts = device.capacitances(&warm, &squeeze).map_err(|refusal| refused(refusal, row, force_n, values))?;
        plates.push(parts.shares.main * PICO);
        value.push(device.total(parts.shares) * PICO);
        aspect.push(parts.aspect);
    }
    let view = FieldView { aspect: &aspect, strain: &strain, plates: &plates };
    let mut extra = vec![0.0; rows];
    stages.iter().for_each(|stage| stage.field(drive, &view, &mut extra));
    value.iter_mut().zip(&extra).for_each(|(value, extra)| *value += extra);
    let readout = readout(device, values)?;
    stages.iter().for_each(|stage| stage.readout(drive, &readout, &mut value));
    check_finite(value, values)
}

/// Strain of the beads, history included.
fn strains(device: &Device, drive: &Drive<'_>, stages: &[&dyn Stage], values: &[f64]) -> Result<Vec<f64>, SimulationError> {
    let mut modulus = vec![1.0; drive.load.len()];
    stages.iter().for_each(|stage| stage.modulus(drive, &mut modulus));
    let stiffening = stiffening(stages);
    let elastic = |(row, &factor): (usize, &f64)| {
        let force = drive.load[row] * drive.full_load;
        let warm = device.at(drive.temperature_c[row]);
        device.strain(&warm, force, factor, stiffening).map_err(|refusal| refused(refusal, row, force, values))
    };
    let mut strain = modulus.iter().enumerate().map(elastic).collect::<Result<Vec<_>, _>>()?;
    stages.iter().for_each(|stage| stage.strain(drive, &mut strain));
    Ok(strain)
}

/// Zero and span of the sensor itself at these parameter values.
fn readout(device: &Device, values: &[f64]) -> Result<Readout, SimulationError> {
    let ends = plain(device, &[0.0, device.full_scale], None, values)?;
    Ok(Readout { zero: ends[0], span: ends[1] - ends[0] })
}
