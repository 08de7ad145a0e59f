//! Two plates at a recorded separation, (1).
//!
//! Limits: one permittivity between the plates; the widest recorded gap is the unloaded one.

use super::scale::ResponseScale;
use crate::equations::plates::plate_capacitance;
use crate::wedge::shape_factor;
use truegap_core::{
    Dielectric, Drive, GapReading, Geometry, Inputs, Parameter, PlateReading, Plates, Readout, Refusal, Role, SimulationError,
    Simulator, Stage, StageName, Stiffness, VACUUM_PERMITTIVITY, named_values, walk,
};

/// Response `area_permittivity / gap`, in the unit of the recording.
#[derive(Clone, Debug)]
pub(super) struct GapPlate {
    unit: String,
    widest_m: f64,
    narrowest_m: f64,
    reference_c: f64,
    parameters: Vec<Parameter>,
}

impl GapPlate {
    /// Plates whose separation runs from `scale.gaps_m.0` to `scale.gaps_m.1`; the prior scales with response times gap.
    pub fn new(scale: &ResponseScale, reference_c: f64) -> Self {
        let (narrowest_m, widest_m) = scale.gaps_m;
        let unit = format!("{} m", scale.unit);
        let meaning = "permittivity times area of the plates";
        let parameters = vec![Parameter::log_normal("area_permittivity", &unit, scale.response_times_gap, 1.0, meaning)];
        Self { unit: scale.unit.clone(), widest_m, narrowest_m, reference_c, parameters }
    }
}

/// The plates with parameter values filled in.
struct Filled {
    area_permittivity: f64,
    widest_m: f64,
    narrowest_m: f64,
    radius_m: f64,
}

impl Plates for Filled {
    /// The closing of the recorded gap, whatever closes it.
    #[inline]
    fn strain(&self, drive: &Drive<'_>, row: usize, _: Stiffness) -> Result<f64, Refusal> {
        let gaps = drive.inputs.gap_m.as_ref().ok_or(Refusal::NoAnswer)?;
        Ok(1.0 - gaps[row] / self.widest_m)
    }

    #[inline]
    fn reading(&self, _: &Drive<'_>, row: usize, geometry: &Geometry<'_>, factors: &Dielectric) -> Result<PlateReading, Refusal> {
        let touches = Refusal::Touches { strain: geometry.strain[row] };
        let gap = (1.0 - geometry.strain[row] + geometry.gap[row]) * self.widest_m;
        let shape = shape_factor(geometry.tilt[row], geometry.sag[row] * self.widest_m / gap).ok_or(touches)?;
        if gap.is_nan() || gap <= 0.0 {
            return Err(touches);
        }
        // plate_capacitance takes permittivity and area; only their product is known here
        let plates = plate_capacitance(self.area_permittivity, shape * factors.beads[row], gap);
        Ok(PlateReading { value: plates, gap: Some(GapReading { aspect: gap / self.radius_m, plates }) })
    }

    fn readout(&self) -> Result<Readout, SimulationError> {
        let zero = self.area_permittivity / self.widest_m;
        Ok(Readout { zero, span: self.area_permittivity / self.narrowest_m - zero })
    }
}

/// Radius of the disc in vacuum that has this permittivity times area, m.
fn radius_m(area_permittivity: f64, unit: &str) -> f64 {
    let farad = truegap_core::Dimension::Capacitance.to_si(1.0, unit).unwrap_or(1e-12);
    (area_permittivity * farad / (VACUUM_PERMITTIVITY * std::f64::consts::PI)).sqrt()
}

impl Simulator for GapPlate {
    fn name(&self) -> &str {
        "gap-plate"
    }

    fn unit(&self) -> &str {
        &self.unit
    }

    fn parameters(&self) -> &[Parameter] {
        &self.parameters
    }

    fn needs(&self) -> &[Role] {
        &[Role::Gap]
    }

    fn lacks(&self, stage: StageName) -> Option<&'static str> {
        (stage == StageName::LoadPath).then_some("the gap is given, so the way of the load to it plays no part")
    }

    fn full_load(&self) -> Option<f64> {
        None
    }

    fn reference_c(&self) -> f64 {
        self.reference_c
    }

    fn row_by_row(&self) -> bool {
        true
    }

    fn respond(&self, values: &[f64], inputs: &Inputs, stages: &[&dyn Stage]) -> Result<Vec<f64>, SimulationError> {
        let [area_permittivity] = named_values(self, values)?;
        let radius_m = radius_m(area_permittivity, &self.unit);
        let plates = Filled { area_permittivity, widest_m: self.widest_m, narrowest_m: self.narrowest_m, radius_m };
        walk(self, &plates, values, inputs, stages)
    }
}
