//! The analytic model of a capacitive tactile sensor, one function per equation, and the base models that a recording is compared with.
//!
//! Limits: steady state; everything with a memory, and everything outside the plates, is left to the stages that plug into the chain.
//!
//! # Capacitance and coefficients of a built-in sensor
//!
//! ```
//! use truegap_core::sensor::builtin_sensors;
//! use truegap_model::{CoefficientOptions, Point, StackOptions, coefficients, states};
//!
//! let sensor = builtin_sensors()[0].sensor()?;
//! let loads = [0.0, 2.0, 4.5].map(|force_n| Point { force_n, temperature_c: 20.0 });
//! let states = states(&sensor, StackOptions::default(), &loads)?;
//! // the reading rises with the load, and the beads are compressed
//! assert!(states[0].c_total_pf < states[1].c_total_pf && states[1].c_total_pf < states[2].c_total_pf);
//! assert!(states[2].strain < 0.0);
//!
//! let sheet = coefficients(&sensor, CoefficientOptions::default())?;
//! assert_eq!(sheet.baseline_pf, states[0].c_total_pf);
//! assert!((sheet.span_pf - (states[2].c_total_pf - states[0].c_total_pf)).abs() < 1e-12);
//! # Ok::<(), Box<dyn std::error::Error>>(())
//! ```
//!
//! # A model of your own
//!
//! A [`Simulator`](truegap_core::Simulator) gives names, units and parameters; its physics is a [`Plates`](truegap_core::Plates), one method a place of the
//! chain, and [`walk`](truegap_core::walk) plugs omitted physics in between. Here a foam with one modulus
//! at any strain (`stiffness.stiffening` is left out):
//!
//! ```
//! use truegap_core::{
//!     Dielectric, Drive, Geometry, Inputs, Parameter, PlateReading, Plates, Readout, Refusal, Role, SimulationError, Simulator,
//!     Stage, StageName, Stiffness, named_values, walk,
//! };
//!
//! /// Plates of `capacitance` pF on a foam that `modulus` full loads would close.
//! struct Foam([Parameter; 2]);
//!
//! /// The same with numbers filled in.
//! struct Filled { capacitance: f64, modulus: f64 }
//!
//! impl Plates for Filled {
//!     fn strain(&self, drive: &Drive<'_>, row: usize, stiffness: Stiffness) -> Result<f64, Refusal> {
//!         let strain = drive.load[row] / (self.modulus * stiffness.modulus);
//!         if strain < 1.0 { Ok(strain) } else { Err(Refusal::Touches { strain }) }
//!     }
//!     fn reading(&self, _: &Drive<'_>, row: usize, geometry: &Geometry<'_>, factors: &Dielectric) -> Result<PlateReading, Refusal> {
//!         let gap = 1.0 - geometry.strain[row] + geometry.gap[row];
//!         Ok(PlateReading { value: self.capacitance * factors.beads[row] / gap, gap: None })
//!     }
//!     fn readout(&self) -> Result<Readout, SimulationError> {
//!         Ok(Readout { zero: self.capacitance, span: self.capacitance / (self.modulus - 1.0) })
//!     }
//! }
//!
//! impl Simulator for Foam {
//!     fn name(&self) -> &str { "foam" }
//!     fn unit(&self) -> &str { "pF" }
//!     fn parameters(&self) -> &[Parameter] { &self.0 }
//!     fn needs(&self) -> &[Role] { &[Role::Force] }
//!     fn lacks(&self, stage: StageName) -> Option<&'static str> {
//!         (stage == StageName::Field).then_some("the size of the plates is unknown")
//!     }
//!     fn full_load(&self) -> Option<f64> { Some(10.0) }
//!     fn respond(&self, values: &[f64], inputs: &Inputs, stages: &[&dyn Stage]) -> Result<Vec<f64>, SimulationError> {
//!         let [capacitance, modulus] = named_values(self, values)?;
//!         walk(self, &Filled { capacitance, modulus }, values, inputs, stages)
//!     }
//! }
//!
//! let foam = Foam([
//!     Parameter::normal("capacitance", "pF", 12.0, 0.5, "reading without load"),
//!     Parameter::log_normal("modulus", "full loads", 4.0, 0.5, "load that would close the gap"),
//! ]);
//! let inputs = Inputs { run: vec![1; 2], force_n: Some(vec![0.0, 10.0]), ..Inputs::default() };
//! assert_eq!(foam.respond(&foam.centre(), &inputs, &[])?, [12.0, 16.0]);
//! # Ok::<(), SimulationError>(())
//! ```

mod base;
pub mod cases;
pub mod equations;
mod errata;
pub mod stack;
mod wedge;

pub use base::{
    Asked, Axis, BASE_MODELS, BaseError, BaseModel, BaseOptions, BlackBox, BlackBoxFacts, DRIVERS, Driver, External,
    ExternalOptions, Followed, GAIN_SD, Grid, GridError, HIGHEST_ORDER, Load, NamedDriver, Recorded, Responder, ResponseScale,
    Surface, Who, base_model,
};
pub use errata::errata_table;
pub use stack::{CoefficientOptions, Coefficients, Point, SeriesOrder, Stack, StackOptions, State, coefficients, states};
