//! UNIFORM-TEMPERATURE: one temperature through the sensor against heat that flows from a warm anvil to the air.
//!
//! Limits: steady; the anvil has the stated temperature, the far face loses heat to air at the cold temperature by free convection.

use super::beads::needs_beads;
use crate::{
    assumption::Assumption,
    cell::{Cell, Filled, Profile, cell_capacitance},
    error::AuditError,
    finding::{Finding, Measure},
    measured::Measured,
    study::Study,
    swap::Swap,
};
use truegap_core::{Sensor, VACUUM_PERMITTIVITY};

/// See the module.
pub(super) struct UniformTemperature;

/// Thermal conductivities, W/(m K): silicone rubber and air from Incropera & DeWitt, polyimide from DuPont's Kapton HN data sheet.
const CONDUCTIVITY: Filled = Filled { bead: 0.2, air: 0.0263, film: 0.12 };
/// Free convection and radiation from a small warm face to air, W/(m² K); Incropera & DeWitt give 2 to 25 for gases.
const TO_AIR: f64 = 10.0;
/// Biot number up to which a body has one temperature to 1 %.
const LIMIT: f64 = 0.01;

impl Assumption for UniformTemperature {
    fn id(&self) -> &'static str {
        "UNIFORM-TEMPERATURE"
    }

    fn says(&self) -> &'static str {
        "the whole sensor has the temperature of the anvil"
    }

    fn source(&self) -> &'static str {
        "Hampson & Dobie, section VI; against conduction through the bead cell (the field's own equation) and 10 W/(m2 K) to air at the cold temperature"
    }

    fn applies(&self, sensor: &Sensor) -> Result<(), String> {
        needs_beads(sensor)
    }

    fn examine(&self, study: &Study<'_>) -> Result<Finding, AuditError> {
        let cell = Cell::of(study.sensor)?;
        let rest = Profile::cylinder(0.0, cell.poisson);
        // heat conduction is electrostatics with conductivity for permittivity
        let solved = cell_capacitance(&cell, &rest, CONDUCTIVITY, study.options.target)?;
        let area = std::f64::consts::PI * cell.outer * cell.outer;
        let conductance = solved.capacitance / VACUUM_PERMITTIVITY / area;
        let biot = TO_AIR / conductance;
        let (cold, hot) = (study.options.cold_c, study.options.hot_c);
        let across = (hot - cold) * biot / (1.0 + biot);
        let reference = study.sensor.reference_c;
        let device = &study.device;
        let swap = Swap::none().warm(move |warm| {
            let above_air = warm.kelvin + reference - cold;
            let beads = device.warmed_by(warm.kelvin - 0.5 * above_air * biot / (1.0 + biot));
            warm.young = beads.young;
            warm.layers.beads = beads.layers.beads;
            warm.areas.solid = beads.areas.solid;
            Ok(())
        });
        Ok(Measured {
            unit: "degC",
            analytic: hot,
            fem: hot - 0.5 * across,
            error_estimate: 0.5 * across * solved.error_estimate / solved.capacitance,
            measure: Measure { name: "Biot number of the bead layer".into(), value: biot, limit: LIMIT },
            effect_on: study.effect(swap)?,
            figure: None,
        }
        .finding(self))
    }
}
