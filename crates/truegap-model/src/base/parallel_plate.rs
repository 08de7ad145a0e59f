//! Two plates on a solid or foam dielectric, (2): any load in, any reading out.
//!
//! Limits: the size of the plates is unknown, so a field outside of them cannot be told from gain and offset.

use super::{plate_beside::Near, plate_columns::Filled, scale::ResponseScale};
use serde::{Deserialize, Serialize};
use truegap_core::{Beside, Inputs, Parameter, Role, SimulationError, Simulator, Stage, StageName, walk};

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
        walk(self, &Filled::of(self, values)?, values, inputs, stages)
    }

    fn beside<'s>(
        &'s self,
        values: &[f64],
        inputs: &'s Inputs,
        stages: &[&dyn Stage],
    ) -> Result<Option<Box<dyn Beside + 's>>, SimulationError> {
        Ok(Some(Box::new(Near::at(self, values, inputs, stages)?)))
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use truegap_core::{Dielectric, Drive, Geometry, Readout};

    /// Acts where a size says.
    struct At(&'static str, f64);

    impl Stage for At {
        fn modulus(&self, drive: &Drive<'_>, factor: &mut [f64]) {
            if self.0 == "modulus" {
                factor.iter_mut().zip(drive.load).for_each(|(factor, load)| *factor += self.1 * load);
            }
        }
        fn stiffening(&self) -> [f64; 2] {
            if self.0 == "stiffening" { [self.1, 0.0] } else { [0.0; 2] }
        }
        fn geometry(&self, drive: &Drive<'_>, geometry: &mut Geometry<'_>) {
            let column = match self.0 {
                "gap" => &mut geometry.gap,
                "tilt" => &mut geometry.tilt,
                "sag" => &mut geometry.sag,
                _ => return,
            };
            column.iter_mut().zip(drive.load).for_each(|(value, load)| *value += self.1 * load);
        }
        fn dielectric(&self, _: &Drive<'_>, factors: &mut Dielectric) {
            if self.0 == "dielectric" {
                factors.beads.iter_mut().for_each(|beads| *beads += self.1);
            }
        }
        fn readout(&self, _: &Drive<'_>, readout: &Readout, value: &mut [f64]) {
            if self.0 == "readout" {
                value.iter_mut().for_each(|value| *value += self.1 * readout.span);
            }
        }
    }

    #[test]
    fn whatever_has_moved_the_answer_is_that_of_the_whole_response_to_the_last_bit() {
        let inputs = Inputs {
            run: vec![1; 40],
            force_n: Some((0..40).map(|row| f64::from(row) * 0.1 - 0.05).collect()),
            ..Inputs::default()
        };
        let plates = ParallelPlate::new(Load::Force, 4.0, &ResponseScale::default(), 20.0);
        let here = [100.0, 50.0, 4.0];
        for place in ["modulus", "stiffening", "gap", "tilt", "sag", "dielectric", "readout"] {
            let near = plates.beside(&here, &inputs, &[&At(place, 0.2)]).unwrap().unwrap();
            for values in [here, [101.0, 50.0, 4.0], [100.0, 51.0, 4.0], [100.0, 50.0, 4.1]] {
                for size in [0.2, 0.21] {
                    let stages = [&At(place, size) as &dyn Stage];
                    let whole = plates.respond(&values, &inputs, &stages).unwrap();
                    assert_eq!(near.respond(&values, &stages).unwrap(), whole, "{place}");
                }
            }
        }
    }
}
