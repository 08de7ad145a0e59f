//! Two plates on a solid or foam dielectric, (2): any load in, any reading out.
//!
//! Limits: the size of the plates is unknown, so a field outside of them cannot be told from gain and offset.

use super::{ResponseScale, Start, check_finite, shape::flat, stiffening};
use crate::equations::load::{BeadLaw, compressive_strain};
use crate::stack::shape_factor;
use serde::{Deserialize, Serialize};
use truegap_core::{
    Dielectric, Drive, Geometry, Inputs, Parameter, Readout, Role, SimulationError, Simulator, Stage, simulator::StageName,
};

/// What loads the plates.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Serialize, Deserialize)]
#[serde(rename_all = "snake_case")]
pub enum Load {
    /// N
    Force,
    /// Pa
    Pressure,
}

impl Load {
    /// Role of the column.
    pub fn role(self) -> Role {
        match self {
            Self::Force => Role::Force,
            Self::Pressure => Role::Pressure,
        }
    }

    /// Column of the load.
    pub fn column(self, inputs: &Inputs) -> Option<&[f64]> {
        match self {
            Self::Force => inputs.force_n.as_deref(),
            Self::Pressure => inputs.pressure_pa.as_deref(),
        }
    }
}

/// Response `offset + gain C / C0` with `C / C0 = 1 / (1 - load / modulus)`.
#[derive(Clone, Debug)]
pub struct ParallelPlate {
    load: Load,
    needs: [Role; 1],
    full_load: f64,
    unit: String,
    reference_c: f64,
    parameters: Vec<Parameter>,
}

/// Strain at full load about which the prior of the modulus is centred; 0.2 with a factor of e either way covers foams and rubbers in use.
const TYPICAL_STRAIN: f64 = 0.2;

impl ParallelPlate {
    /// Plates under a load; priors scale with the response.
    pub fn new(load: Load, full_load: f64, scale: &ResponseScale, reference_c: f64) -> Self {
        // C / C0 - 1 at full load and typical strain is strain / (1 - strain)
        let gain = scale.span * (1.0 - TYPICAL_STRAIN) / TYPICAL_STRAIN;
        let weak = 5.0 * gain.abs().max(scale.range);
        let parameters = vec![
            Parameter::normal("offset", &scale.unit, scale.at_rest - gain, weak, "response that no capacitance makes"),
            Parameter::normal("gain", &scale.unit, gain, weak, "response per unloaded capacitance"),
            Parameter {
                bounds: (1.01, 1e6),
                ..Parameter::log_normal(
                    "modulus",
                    "full loads",
                    1.0 / TYPICAL_STRAIN,
                    1.0,
                    "load that would close the gap of a linear dielectric",
                )
            },
        ];
        Self { load, needs: [load.role()], full_load, unit: scale.unit.clone(), reference_c, parameters }
    }

    fn loads(&self, inputs: &Inputs) -> Result<Vec<f64>, SimulationError> {
        let missing = || SimulationError::MissingColumn { model: self.name().to_owned(), role: self.load.role() };
        Ok(self.load.column(inputs).ok_or_else(missing)?.iter().map(|load| load / self.full_load).collect())
    }

    fn strains(
        &self,
        modulus: f64,
        drive: &Drive<'_>,
        stages: &[&dyn Stage],
        values: &[f64],
    ) -> Result<Vec<f64>, SimulationError> {
        let mut factor = vec![1.0; drive.load.len()];
        stages.iter().for_each(|stage| stage.modulus(drive, &mut factor));
        let law = BeadLaw { poisson: 0.0, stiffening: stiffening(stages) };
        let strain = |(row, factor): (usize, f64)| {
            let load = drive.load[row];
            let strain = compressive_strain(load / (modulus * factor), law);
            strain.filter(|s| s.is_finite()).ok_or_else(|| {
                if load > 0.0 && factor > 0.0 {
                    SimulationError::GapCloses { row, load_si: load * self.full_load, strain: 1.0 }
                } else {
                    SimulationError::NotFinite { row, value: f64::NAN, parameters: values.to_vec() }
                }
            })
        };
        let mut strain = factor.into_iter().enumerate().map(strain).collect::<Result<Vec<_>, _>>()?;
        stages.iter().for_each(|stage| stage.strain(drive, &mut strain));
        Ok(strain)
    }
}

/// Unloaded capacitances: strain, extra gap, shape and permittivity of one row; `None` where the plates touch.
fn relative_capacitance(geometry: &Geometry<'_>, factors: &Dielectric, row: usize) -> Option<f64> {
    let solid = 1.0 - geometry.strain[row];
    let gap = solid / factors.beads[row] + geometry.gap[row];
    let shape = shape_factor(geometry.tilt[row], geometry.sag[row] / solid)?;
    (solid > 0.0 && gap > 0.0).then(|| shape / gap)
}

impl Simulator for ParallelPlate {
    fn name(&self) -> &str {
        "parallel-plate"
    }

    fn unit(&self) -> &str {
        &self.unit
    }

    fn parameters(&self) -> &[Parameter] {
        &self.parameters
    }

    fn needs(&self) -> &[Role] {
        &self.needs
    }

    fn lacks(&self, stage: StageName) -> Option<&'static str> {
        (stage == StageName::Field)
            .then_some("the size of the plates is unknown, and a free gain and offset take up any field outside of them")
    }

    fn full_load(&self) -> Option<f64> {
        Some(self.full_load)
    }

    fn reference_c(&self) -> f64 {
        self.reference_c
    }

    fn load(&self, inputs: &Inputs) -> Option<Vec<f64>> {
        self.loads(inputs).ok()
    }

    fn respond(&self, values: &[f64], inputs: &Inputs, stages: &[&dyn Stage]) -> Result<Vec<f64>, SimulationError> {
        let &[offset, gain, modulus] = values else {
            return Err(SimulationError::NotFinite { row: 0, value: f64::NAN, parameters: values.to_vec() });
        };
        let start = Start::new(inputs, stages, self.reference_c, self.full_load, |inputs| self.loads(inputs))?;
        let drive = start.drive();
        let rows = drive.load.len();
        let strain = self.strains(modulus, &drive, stages, values)?;
        let mut geometry = flat(&strain, &drive);
        stages.iter().for_each(|stage| stage.geometry(&drive, &mut geometry));
        let mut factors = Dielectric { beads: vec![1.0; rows], insulator: vec![1.0; rows] };
        stages.iter().for_each(|stage| stage.dielectric(&drive, &mut factors));
        let response = |row: usize| {
            let closed = || SimulationError::GapCloses { row, load_si: drive.load[row] * self.full_load, strain: strain[row] };
            Ok(offset + gain * relative_capacitance(&geometry, &factors, row).ok_or_else(closed)?)
        };
        let mut value = (0..rows).map(response).collect::<Result<Vec<_>, _>>()?;
        let readout = Readout { zero: offset + gain, span: gain / (modulus - 1.0) };
        stages.iter().for_each(|stage| stage.readout(&drive, &readout, &mut value));
        check_finite(value, values)
    }
}
