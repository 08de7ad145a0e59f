//! An instrument whose reading is an equation of its load: the shortest way to a simulator of one's own.
//!
//! Limits: no plates and no memory; each row is read by itself. What needs more implements [`Simulator`].

use crate::{
    chain::{Readout, Stage, StageName},
    inputs::{Inputs, Role},
    parameter::Parameter,
    simulation_error::SimulationError,
    simulator::{Simulator, named_values},
    walk::walk_without_plates,
};

/// An instrument with `N` free numbers.
///
/// ```
/// use truegap_core::{Inputs, Instrument, Parameter, Role, Simulator};
///
/// let scale = Instrument {
///     name: "spring-scale",
///     unit: "mm",
///     load: Role::Force,
///     full_load: 20.0, // N
///     parameters: [Parameter::normal("travel", "mm", 40.0, 1.0, "travel at 20 N")],
///     reading: |[travel], share| travel * share,
/// };
/// let inputs = Inputs { run: vec![1, 1], force_n: Some(vec![5.0, 10.0]), ..Inputs::default() };
/// assert_eq!(scale.respond(&[40.0], &inputs, &[])?, [10.0, 20.0]);
/// # Ok::<(), truegap_core::SimulationError>(())
/// ```
#[derive(Clone, Debug)]
pub struct Instrument<const N: usize> {
    /// name for reports
    pub name: &'static str,
    /// unit of the reading
    pub unit: &'static str,
    /// the load: [`Role::Force`] or [`Role::Pressure`]
    pub load: Role,
    /// greatest load that the instrument is made for, N or Pa
    pub full_load: f64,
    /// its free numbers, with what is known of them
    pub parameters: [Parameter; N],
    /// the reading, from the free numbers and the load as a share of full load
    pub reading: fn([f64; N], f64) -> f64,
}

impl<const N: usize> Simulator for Instrument<N> {
    fn name(&self) -> &str {
        self.name
    }

    fn unit(&self) -> &str {
        self.unit
    }

    fn parameters(&self) -> &[Parameter] {
        &self.parameters
    }

    fn needs(&self) -> &[Role] {
        std::slice::from_ref(&self.load)
    }

    fn lacks(&self, stage: StageName) -> Option<&'static str> {
        let plates = [StageName::Beads, StageName::Geometry, StageName::Dielectric, StageName::Field];
        plates.contains(&stage).then_some("the instrument has no plates")
    }

    fn full_load(&self) -> Option<f64> {
        Some(self.full_load)
    }

    fn respond(&self, values: &[f64], inputs: &Inputs, stages: &[&dyn Stage]) -> Result<Vec<f64>, SimulationError> {
        let numbers: [f64; N] = named_values(self, values)?;
        let reading = |share: f64| (self.reading)(numbers, share);
        let zero = reading(0.0);
        walk_without_plates(self, values, inputs, stages, |drive| {
            let readings = drive.load.iter().map(|share| reading(*share)).collect();
            Ok((readings, Readout { zero, span: reading(1.0) - zero }))
        })
    }
}
