//! Somebody else's simulation, given as a column of the recording.
//!
//! Limits: nothing inside it can be changed; it is moved along the surface on which it follows load and temperature, where these were recorded.

use super::driver::deformation;
use super::scale::ResponseScale;
use super::surface::Surface;
use serde::{Deserialize, Serialize};
use truegap_core::{Drive, Inputs, Parameter, Readout, Role, SimulationError, Simulator, Stage, StageName, walk_without_plates};

/// What of an external simulation or a table may be adjusted; nothing unless asked for.
#[derive(Clone, Debug, Default, PartialEq, Serialize, Deserialize)]
pub struct ExternalOptions {
    /// standard deviation of a gain about 1, of a gain about 0 where the simulation has a unit of its own
    pub gain_sd: Option<f64>,
    /// whether an offset is free
    pub offset: bool,
    /// unit of the simulation, where it is another than the response's: the gain is then a ratio of which nothing but the size is known
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub own_unit: Option<String>,
}

/// Standard deviation of a gain that is free, where none is given: simulations of dielectrics and foams are right to some ten per cent.
pub const GAIN_SD: f64 = 0.3;

/// A gain about 1 and an offset about 0, as far as they are free.
#[derive(Clone, Debug)]
pub(crate) struct GainAndOffset {
    pub(crate) parameters: Vec<Parameter>,
    options: ExternalOptions,
}

impl GainAndOffset {
    /// Priors scaled by the response; `what` is adjusted.
    pub(crate) fn new(scale: &ResponseScale, options: ExternalOptions, what: &str) -> Self {
        let (expected, unit) = match &options.own_unit {
            Some(own) => (0.0, format!("{} per {own}", scale.unit)),
            None => (1.0, String::new()),
        };
        let gain = options.gain_sd.map(|sd| Parameter::normal("gain", &unit, expected, sd, &format!("factor on {what}")));
        let offset = || Parameter::normal("offset", &scale.unit, 0.0, 10.0 * scale.range, &format!("zero beside {what}"));
        Self { parameters: gain.into_iter().chain(options.offset.then(offset)).collect(), options }
    }

    /// Gain and offset of a set of parameter values.
    pub(crate) fn line(&self, values: &[f64]) -> (f64, f64) {
        let mut values = values.iter().copied();
        let gain = self.options.gain_sd.and_then(|_| values.next()).unwrap_or(1.0);
        let offset = if self.options.offset { values.next().unwrap_or(0.0) } else { 0.0 };
        (gain, offset)
    }
}

/// Response `offset + gain x simulated`.
#[derive(Clone, Debug)]
pub struct External {
    unit: String,
    reference_c: f64,
    adjusted: GainAndOffset,
    /// where the reading begins and how far it goes, in the recording that the model is scaled by: the same in any other
    readout: Readout,
    surface: Option<Surface>,
}

impl External {
    /// A simulated column; `options` say what may be adjusted.
    pub fn new(scale: &ResponseScale, reference_c: f64, options: ExternalOptions) -> Self {
        let adjusted = GainAndOffset::new(scale, options, "the simulation");
        let readout = Readout { zero: scale.centre - 0.5 * scale.range, span: scale.range };
        Self { unit: scale.unit.clone(), reference_c, adjusted, readout, surface: None }
    }

    /// The same simulation, which follows load and temperature along a surface.
    #[must_use]
    pub fn following(self, surface: Option<Surface>) -> Self {
        Self { surface, ..self }
    }

    fn loads(&self, inputs: &Inputs) -> Option<Vec<f64>> {
        self.surface.as_ref()?.load?.recorded(inputs, self.name()).ok()
    }

    /// The simulation moved along its surface by what load path and thermal path changed, and along its deflection by what deforms.
    fn moved(&self, simulated: &[f64], drive: &Drive<'_>, stages: &[&dyn Stage]) -> Result<Vec<f64>, SimulationError> {
        let Some(surface) = self.surface.as_ref().filter(|_| !stages.is_empty()) else { return Ok(simulated.to_vec()) };
        let rows = simulated.len();
        let loads = self.loads(drive.inputs).unwrap_or_else(|| vec![0.0; rows]);
        let warmth = |column: &[f64], row: usize| surface.temperature.map_or(0.0, |t| (column[row] - t.zero) / t.width);
        let recorded = drive.inputs.temperature_c.as_deref().unwrap_or(drive.temperature_c);
        let shift = |row: usize| {
            let (before, after) = (warmth(recorded, row), warmth(drive.temperature_c, row));
            let arrived = if surface.load.is_some() { drive.load[row] } else { 0.0 };
            if arrived == loads[row] && before == after {
                0.0
            } else {
                surface.at(arrived, after) - surface.at(loads[row], before)
            }
        };
        let mut value: Vec<f64> = (0..rows).map(|row| simulated[row] + shift(row)).collect();
        if surface.load.is_some() {
            let rest: Vec<f64> = (0..rows).map(|row| surface.at(0.0, warmth(drive.temperature_c, row))).collect();
            let full = surface.at(1.0, 0.0) - surface.at(0.0, 0.0);
            let elastic: Vec<f64> = value.iter().zip(&rest).map(|(value, rest)| (value - rest) / full).collect();
            let deformed = deformation(&elastic, drive, stages)?;
            value
                .iter_mut()
                .zip(deformed.iter().zip(&elastic))
                .for_each(|(value, (after, before))| *value += full * (after - before));
        }
        Ok(value)
    }
}

impl Simulator for External {
    fn name(&self) -> &str {
        "external"
    }

    fn unit(&self) -> &str {
        &self.unit
    }

    fn simulated_unit(&self) -> &str {
        self.adjusted.options.own_unit.as_deref().unwrap_or(&self.unit)
    }

    fn parameters(&self) -> &[Parameter] {
        &self.adjusted.parameters
    }

    fn needs(&self) -> &[Role] {
        &[Role::Simulated]
    }

    fn lacks(&self, stage: StageName) -> Option<&'static str> {
        let follows_load = self.surface.as_ref().is_some_and(|surface| surface.load.is_some());
        match stage {
            StageName::LoadPath | StageName::Beads if !follows_load => {
                Some("the simulation is given as a column, and no load was recorded that it follows")
            }
            StageName::Geometry | StageName::Dielectric | StageName::Field => {
                Some("the simulation is given as a column; its plates are not known")
            }
            _ => None,
        }
    }

    fn full_load(&self) -> Option<f64> {
        Some(self.surface.as_ref()?.load?.width)
    }

    fn reference_c(&self) -> f64 {
        self.reference_c
    }

    fn load(&self, inputs: &Inputs) -> Option<Vec<f64>> {
        self.loads(inputs)
    }

    fn respond(&self, values: &[f64], inputs: &Inputs, stages: &[&dyn Stage]) -> Result<Vec<f64>, SimulationError> {
        let (gain, offset) = self.adjusted.line(values);
        walk_without_plates(self, values, inputs, stages, |drive| {
            let simulated = self.column(drive.inputs, Role::Simulated)?;
            let value: Vec<f64> = self.moved(simulated, drive, stages)?.iter().map(|value| offset + gain * value).collect();
            Ok((value, self.readout))
        })
    }
}
