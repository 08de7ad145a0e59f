//! The physics of the stack, row by row, as the walk asks for it.
//!
//! Limits: an error names the first row that has no answer.

use super::device::{Device, Squeeze};
use truegap_core::{
    Dielectric, Drive, GapReading, Geometry, PlateReading, Plates, Readout, Refusal, SimulationError, Stiffness, check_finite,
};

/// Picofarad in a farad.
pub(super) const PICO: f64 = 1e12;

/// A device and the parameter values that made it, asked row by row.
#[derive(Clone, Copy)]
pub(super) struct Rows<'a> {
    pub device: &'a Device,
    pub values: &'a [f64],
}

impl Plates for Rows<'_> {
    #[inline]
    fn strain(&self, drive: &Drive<'_>, row: usize, stiffness: Stiffness) -> Result<f64, Refusal> {
        let warm = self.device.at(drive.temperature_c[row]);
        self.device.strain(&warm, force_n(drive, row), stiffness.modulus, stiffness.stiffening)
    }

    fn warp_factor(&self) -> f64 {
        self.device.warp_factor()
    }

    #[inline]
    fn reading(
        &self,
        drive: &Drive<'_>,
        row: usize,
        geometry: &Geometry<'_>,
        factors: &Dielectric,
    ) -> Result<PlateReading, Refusal> {
        let squeeze = Squeeze {
            force_n: force_n(drive, row),
            strain: geometry.strain[row],
            warp_kelvin: geometry.warp_kelvin[row],
            warp_factor: geometry.warp_factor,
            gap: geometry.gap[row],
            tilt: geometry.tilt[row],
            sag: geometry.sag[row],
            beads: factors.beads[row],
            insulator: factors.insulator[row],
        };
        let parts = self.device.capacitances(&self.device.at(drive.temperature_c[row]), &squeeze)?;
        let gap = GapReading { aspect: parts.aspect, plates: parts.shares.main * PICO };
        Ok(PlateReading { value: self.device.total(parts.shares) * PICO, gap: Some(gap) })
    }

    fn readout(&self) -> Result<Readout, SimulationError> {
        ends(self.device, self.values)
    }
}

/// Force on the dielectric, N.
pub(super) fn force_n(drive: &Drive<'_>, row: usize) -> f64 {
    drive.load[row] * drive.full_load
}

/// Zero and span of a device.
pub(super) fn ends(device: &Device, values: &[f64]) -> Result<Readout, SimulationError> {
    let warm = device.at(device.reference_c);
    let at = |(row, force): (usize, f64)| {
        let strain = device.strain(&warm, force, 1.0, [0.0; 2]);
        let parts = strain.and_then(|strain| device.capacitances(&warm, &device.plain(&warm, force, strain)));
        parts.map(|parts| device.total(parts.shares) * PICO).map_err(|refusal| refusal.at(row, force, values))
    };
    let ends = [0.0, device.full_scale].into_iter().enumerate().map(at).collect::<Result<Vec<_>, _>>()?;
    let ends = check_finite(ends, values)?;
    Ok(Readout { zero: ends[0], span: ends[1] - ends[0] })
}
