//! A straight line, or a polynomial, in one recorded column or named driver: the base for whoever has no other.
//!
//! Limits: one driver; the coefficients say nothing about what is inside.

use super::driver::Followed;
use super::scale::ResponseScale;
use truegap_core::{Inputs, Parameter, Readout, Role, SimulationError, Simulator, Stage, StageName, walk_without_plates};

/// Highest order of a polynomial base; beyond it a table describes a curve better.
pub const HIGHEST_ORDER: usize = 6;

/// Response `offset + slope u + order_2 u^2 + ...`, u the driver over its range.
#[derive(Clone, Debug)]
pub struct Linear {
    driver: Followed,
    needs: Vec<Role>,
    unit: String,
    reference_c: f64,
    parameters: Vec<Parameter>,
}

impl Linear {
    /// A polynomial of `order` in `driver`; priors scale with the response.
    pub fn new(driver: Followed, order: usize, scale: &ResponseScale, reference_c: f64) -> Self {
        let weak = 10.0 * scale.range;
        let mut parameters = vec![
            Parameter::normal("offset", &scale.unit, scale.at_rest, weak, "reading where the driver is 0"),
            Parameter::normal(
                "slope",
                &scale.unit,
                scale.span,
                weak,
                "change of the reading over the driver's range, straight part",
            ),
        ];
        for power in 2..=order {
            let meaning = "change of the reading over the driver's range, part of this order";
            parameters.push(Parameter::normal(&format!("order_{power}"), &scale.unit, 0.0, weak, meaning));
        }
        Self { needs: driver.role().into_iter().collect(), driver, unit: scale.unit.clone(), reference_c, parameters }
    }

    fn is_loaded(&self) -> bool {
        self.driver.full_load().is_some()
    }
}

impl Simulator for Linear {
    fn name(&self) -> &str {
        "linear"
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
        match stage {
            StageName::Inputs if !self.is_loaded() && !matches!(self.driver.role(), None | Some(Role::Gap)) => {
                Some("the base model is driven by no column that has a clock of its own")
            }
            StageName::LoadPath | StageName::Beads if !self.is_loaded() => Some("the base model is not driven by a load"),
            StageName::Geometry | StageName::Dielectric | StageName::Field => Some("a curve has no plates"),
            _ => None,
        }
    }

    fn full_load(&self) -> Option<f64> {
        self.driver.full_load()
    }

    fn reference_c(&self) -> f64 {
        self.reference_c
    }

    fn row_by_row(&self) -> bool {
        true
    }

    fn respond(&self, values: &[f64], inputs: &Inputs, stages: &[&dyn Stage]) -> Result<Vec<f64>, SimulationError> {
        let polynomial = |u: &f64| values.iter().rev().fold(0.0, |sum, coefficient| sum * u + coefficient);
        walk_without_plates(self, values, inputs, stages, |drive| {
            let value = self.driver.arrived(drive, stages, self.name())?.iter().map(polynomial).collect();
            Ok((value, Readout { zero: polynomial(&0.0), span: polynomial(&1.0) - polynomial(&0.0) }))
        })
    }
}
