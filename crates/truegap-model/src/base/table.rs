//! A curve C(x) or C(F, T) that was measured or computed elsewhere, as a base model.
//!
//! Limits: straight between the values of the table; nothing inside it can be changed but what drives it.

use super::driver::{deformation, is_load};
use super::external::{ExternalOptions, GainAndOffset};
use super::grid::{Axis, Grid};
use super::scale::ResponseScale;
use truegap_core::{Drive, Inputs, Parameter, Readout, Role, SimulationError, Simulator, Stage, StageName, walk_without_plates};

/// Response `offset + gain x table`.
#[derive(Clone, Debug)]
pub struct Table {
    grid: Grid,
    needs: Vec<Role>,
    reference_c: f64,
    adjusted: GainAndOffset,
}

impl Table {
    /// A table; `options` say what may be adjusted.
    pub fn new(grid: Grid, scale: &ResponseScale, reference_c: f64, options: ExternalOptions) -> Self {
        let needs = grid.axes.iter().map(|axis| axis.role).collect();
        Self { grid, needs, reference_c, adjusted: GainAndOffset::new(scale, options, "the table") }
    }

    fn loaded(&self) -> Option<(Role, f64)> {
        let axis = self.grid.axis(is_load)?;
        let (low, high) = axis.ends();
        Some((axis.role, high.max(-low)))
    }

    fn loads(&self, inputs: &Inputs) -> Option<Vec<f64>> {
        let (role, full) = self.loaded()?;
        Some(inputs.column(role)?.iter().map(|load| load / full).collect())
    }

    /// What arrives at each axis, after all that is plugged in.
    fn arrived(&self, drive: &Drive<'_>, stages: &[&dyn Stage]) -> Result<Vec<Vec<f64>>, SimulationError> {
        let column = |role: &Role| match role {
            role if is_load(*role) => {
                Ok(deformation(drive.load, drive, stages)?.iter().map(|load| load * drive.full_load).collect())
            }
            Role::Temperature => Ok(drive.temperature_c.to_vec()),
            role => {
                let missing = || SimulationError::MissingColumn { model: self.name().to_owned(), role: *role };
                drive.inputs.column(*role).map(<[f64]>::to_vec).ok_or_else(missing)
            }
        };
        self.needs.iter().map(column).collect()
    }

    /// The table where nothing is done, and where the load is full.
    fn ends(&self) -> (f64, f64) {
        let at = |full: bool| -> Vec<f64> {
            let place = |axis: &Axis| match axis.role {
                role if is_load(role) => {
                    if full {
                        self.loaded().map_or(0.0, |(_, load)| load)
                    } else {
                        0.0
                    }
                }
                Role::Temperature if self.grid.axes.len() > 1 => self.reference_c,
                _ => {
                    if full {
                        axis.ends().1
                    } else {
                        axis.ends().0
                    }
                }
            };
            self.grid.axes.iter().map(place).collect()
        };
        (self.grid.at(&at(false)), self.grid.at(&at(true)))
    }
}

impl Simulator for Table {
    fn name(&self) -> &str {
        "table"
    }

    fn unit(&self) -> &str {
        &self.grid.unit
    }

    fn parameters(&self) -> &[Parameter] {
        &self.adjusted.parameters
    }

    fn needs(&self) -> &[Role] {
        &self.needs
    }

    fn lacks(&self, stage: StageName) -> Option<&'static str> {
        let loaded = self.loaded().is_some();
        match stage {
            StageName::Inputs if !loaded && !self.needs.contains(&Role::Gap) => Some("the table is not driven by a load"),
            StageName::LoadPath | StageName::Beads if !loaded => Some("the table is not driven by a load"),
            StageName::Geometry | StageName::Dielectric | StageName::Field => Some("a table has no plates"),
            _ => None,
        }
    }

    fn full_load(&self) -> Option<f64> {
        self.loaded().map(|(_, full)| full)
    }

    fn reference_c(&self) -> f64 {
        self.reference_c
    }

    fn load(&self, inputs: &Inputs) -> Option<Vec<f64>> {
        self.loads(inputs)
    }

    fn row_by_row(&self) -> bool {
        true
    }

    fn respond(&self, values: &[f64], inputs: &Inputs, stages: &[&dyn Stage]) -> Result<Vec<f64>, SimulationError> {
        self.check(values, inputs)?;
        self.grid.holds(inputs)?;
        let (gain, offset) = self.adjusted.line(values);
        walk_without_plates(self, values, inputs, stages, |drive| {
            let columns = self.arrived(drive, stages)?;
            let row = |row: usize| offset + gain * self.grid.at(&columns.iter().map(|column| column[row]).collect::<Vec<_>>());
            let (rest, full) = self.ends();
            let readout = Readout { zero: offset + gain * rest, span: gain * (full - rest) };
            Ok(((0..inputs.len()).map(row).collect(), readout))
        })
    }
}
