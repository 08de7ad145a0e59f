//! Two plates at a recorded separation, (1).
//!
//! Limits: one permittivity between the plates; the widest recorded gap is the unloaded one.

use super::{ResponseScale, Start, check_finite, shape::flat};
use crate::equations::plates::plate_capacitance;
use crate::stack::shape_factor;
use truegap_core::{
    Dielectric, Drive, FieldView, Geometry, Inputs, Parameter, Readout, Role, SimulationError, Simulator, Stage,
    VACUUM_PERMITTIVITY, simulator::StageName,
};

/// Response `area_permittivity / gap`, in the unit of the recording.
#[derive(Clone, Debug)]
pub struct GapPlate {
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

    fn gaps<'a>(&self, inputs: &'a Inputs) -> Result<&'a [f64], SimulationError> {
        let missing = || SimulationError::MissingColumn { model: self.name().to_owned(), role: Role::Gap };
        inputs.gap_m.as_deref().ok_or_else(missing)
    }

    /// Mean separation of a row, m.
    fn separation(&self, geometry: &Geometry<'_>, row: usize) -> f64 {
        (1.0 - geometry.strain[row] + geometry.gap[row]) * self.widest_m
    }

    /// Reading between the plates of a row; `None` where they touch.
    fn plates(&self, area_permittivity: f64, geometry: &Geometry<'_>, factors: &Dielectric, row: usize) -> Option<f64> {
        let gap = self.separation(geometry, row);
        let shape = shape_factor(geometry.tilt[row], geometry.sag[row] * self.widest_m / gap)?;
        // plate_capacitance takes permittivity and area; only their product is known here
        (gap > 0.0).then(|| plate_capacitance(area_permittivity, shape * factors.beads[row], gap))
    }

    /// Adds the field outside the plates.
    fn with_field(
        &self,
        area_permittivity: f64,
        geometry: &Geometry<'_>,
        plates: Vec<f64>,
        drive: &Drive<'_>,
        stages: &[&dyn Stage],
    ) -> Vec<f64> {
        let radius = radius_m(area_permittivity, &self.unit);
        let aspect: Vec<f64> = (0..plates.len()).map(|row| self.separation(geometry, row) / radius).collect();
        let mut extra = vec![0.0; plates.len()];
        let view = FieldView { aspect: &aspect, strain: geometry.strain, plates: &plates };
        stages.iter().for_each(|stage| stage.field(drive, &view, &mut extra));
        plates.iter().zip(&extra).map(|(plates, extra)| plates + extra).collect()
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

    fn load(&self, _inputs: &Inputs) -> Option<Vec<f64>> {
        None
    }

    fn respond(&self, values: &[f64], inputs: &Inputs, stages: &[&dyn Stage]) -> Result<Vec<f64>, SimulationError> {
        let &[area_permittivity] = values else {
            return Err(SimulationError::NotFinite { row: 0, value: f64::NAN, parameters: values.to_vec() });
        };
        let start = Start::new(inputs, stages, self.reference_c, 1.0, |inputs| Ok(vec![0.0; inputs.len()]))?;
        let drive = start.drive();
        let mut strain: Vec<f64> = self.gaps(start.inputs())?.iter().map(|gap| 1.0 - gap / self.widest_m).collect();
        stages.iter().for_each(|stage| stage.strain(&drive, &mut strain));
        let mut geometry = flat(&strain, &drive);
        stages.iter().for_each(|stage| stage.geometry(&drive, &mut geometry));
        let mut factors = Dielectric { beads: vec![1.0; strain.len()], insulator: vec![1.0; strain.len()] };
        stages.iter().for_each(|stage| stage.dielectric(&drive, &mut factors));
        let closed = |row: usize| SimulationError::GapCloses { row, load_si: drive.load[row], strain: strain[row] };
        let plates = |row: usize| self.plates(area_permittivity, &geometry, &factors, row).ok_or_else(|| closed(row));
        let plates = (0..strain.len()).map(plates).collect::<Result<Vec<_>, _>>()?;
        let mut value = self.with_field(area_permittivity, &geometry, plates, &drive, stages);
        let zero = area_permittivity / self.widest_m;
        let readout = Readout { zero, span: area_permittivity / self.narrowest_m - zero };
        stages.iter().for_each(|stage| stage.readout(&drive, &readout, &mut value));
        check_finite(value, values)
    }
}
