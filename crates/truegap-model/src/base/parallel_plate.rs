//! Two plates on a solid or foam dielectric, (2): any load in, any reading out.
//!
//! Limits: the size of the plates is unknown, so a field outside of them cannot be told from gain and offset.

use super::scale::ResponseScale;
use crate::equations::load::{BeadLaw, compressive_strain};
use crate::wedge::shape_factor;
use serde::{Deserialize, Serialize};
use truegap_core::{
    Dielectric, Drive, Geometry, Inputs, Parameter, PlateReading, Plates, Readout, Refusal, Role, SimulationError, Simulator,
    Stage, StageName, Stiffness, named_values, walk,
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
        inputs.column(self.role())
    }
}

/// Response `offset + gain C / C0` with `C / C0 = 1 / (1 - load / modulus)`.
#[derive(Clone, Debug)]
pub(super) struct ParallelPlate {
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
        Self { needs: [load.role()], full_load, unit: scale.unit.clone(), reference_c, parameters }
    }
}

/// The plates with parameter values filled in.
struct Filled {
    offset: f64,
    gain: f64,
    modulus: f64,
}

impl Plates for Filled {
    #[inline]
    fn strain(&self, drive: &Drive<'_>, row: usize, stiffness: Stiffness) -> Result<f64, Refusal> {
        let load = drive.load[row];
        let law = BeadLaw { poisson: 0.0, stiffening: stiffness.stiffening };
        let strain = compressive_strain(load / (self.modulus * stiffness.modulus), law).filter(|s| s.is_finite());
        let closes = load > 0.0 && stiffness.modulus > 0.0;
        strain.ok_or(if closes { Refusal::Touches { strain: 1.0 } } else { Refusal::NoAnswer })
    }

    #[inline]
    fn reading(&self, _: &Drive<'_>, row: usize, geometry: &Geometry<'_>, factors: &Dielectric) -> Result<PlateReading, Refusal> {
        let touches = Refusal::Touches { strain: geometry.strain[row] };
        let value = self.offset + self.gain * relative_capacitance(geometry, factors, row).ok_or(touches)?;
        Ok(PlateReading { value, gap: None })
    }

    fn readout(&self) -> Result<Readout, SimulationError> {
        Ok(Readout { zero: self.offset + self.gain, span: self.gain / (self.modulus - 1.0) })
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

    fn row_by_row(&self) -> bool {
        true
    }

    fn respond(&self, values: &[f64], inputs: &Inputs, stages: &[&dyn Stage]) -> Result<Vec<f64>, SimulationError> {
        let [offset, gain, modulus] = named_values(self, values)?;
        walk(self, &Filled { offset, gain, modulus }, values, inputs, stages)
    }
}
