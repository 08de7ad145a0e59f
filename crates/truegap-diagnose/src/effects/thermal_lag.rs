//! The sensor follows the thermometer with a time constant.

use crate::{
    context::Context,
    effect::{About, Effect, Family, FittedParameter},
    memory::first_order_lag,
};
use truegap_core::{EffectId, Inputs, Parameter, Stage, simulator::StageName};

/// First-order thermal lag.
pub struct ThermalLag;

struct Lag {
    tau_s: f64,
}

impl Stage for Lag {
    fn thermal(&self, inputs: &Inputs, temperature_c: &mut [f64]) {
        first_order_lag(inputs, self.tau_s, temperature_c, |first| first);
    }
}

/// Sibling: the mean temperature of a slab heated on one face, the first modes of Fourier's series.
struct Slab(Lag);

impl Stage for Slab {
    fn thermal(&self, inputs: &Inputs, temperature_c: &mut [f64]) {
        const MODES: [f64; 4] = [1.0, 3.0, 5.0, 7.0];
        let all: f64 = MODES.iter().map(|n| (n * n).recip()).sum();
        let given = temperature_c.to_vec();
        temperature_c.fill(0.0);
        for n in MODES {
            let mut mode = given.clone();
            first_order_lag(inputs, 1.1 * self.0.tau_s / (n * n), &mut mode, |first| first);
            temperature_c.iter_mut().zip(&mode).for_each(|(sum, mode)| *sum += mode / (n * n * all));
        }
    }
}

impl Effect for ThermalLag {
    fn id(&self) -> EffectId {
        EffectId("thermal_lag")
    }
    fn stage(&self) -> StageName {
        StageName::ThermalPath
    }
    fn family(&self) -> Family {
        Family::Thermal
    }
    fn about(&self) -> About {
        About {
            physics: "heat takes time to reach the dielectric, so the sensor is behind the thermometer",
            equation: "tau dT_s/dt = T - T_s",
            excitation: "temperature that changes faster than the sensor can follow, with a clock",
            impostors: &["thermal_hysteresis", "offset_drift", "readout_lag"],
            separates: "the loop over temperature grows with the rate of heating and closes in a hold",
            source: "lumped heat capacity, Incropera, Fundamentals of Heat and Mass Transfer, ch. 5",
        }
    }
    fn parameters(&self, context: &Context<'_>) -> Vec<Parameter> {
        let scale = (0.2 * context.longest_run_s).max(1.0);
        vec![
            Parameter::normal("tau", "s", 0.0, scale, "time constant of the thermal path")
                .within(0.0, 2.0 * context.longest_run_s),
        ]
    }
    fn testable(&self, context: &Context<'_>) -> Result<(), String> {
        context.has(StageName::ThermalPath)?;
        context.needs_clock()?;
        context.needs_temperature(1.0)
    }
    fn with(&self, values: &[f64], _: &Context<'_>) -> Box<dyn Stage> {
        Box::new(Lag { tau_s: values[0] })
    }
    fn sibling(&self, values: &[f64], _: &Context<'_>) -> Option<Box<dyn Stage>> {
        Some(Box::new(Slab(Lag { tau_s: values[0] })))
    }
    fn says(&self, fitted: &[FittedParameter]) -> String {
        format!("the sensor follows the thermometer with a time constant of {:.2} s (sd {:.2})", fitted[0].value, fitted[0].sd)
    }
}
