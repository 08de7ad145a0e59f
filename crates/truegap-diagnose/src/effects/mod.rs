//! The library of omitted physics: one file an effect, one line in [`library`].
//!
//! Limits: an effect sees the inputs and the chain, never the recorded response.

use crate::effect::Effect;

mod contact_toe_in;
mod dead_gap;
mod eccentric_load;
mod electrode_warp;
mod gain_drift;
mod humidity_uptake;
mod mullins_softening;
mod offset_drift;
mod parasitic_capacitance;
mod permittivity_temperature;
mod rate_independent_hysteresis;
mod readout_lag;
mod scale;
mod strain_stiffening;
mod thermal_hysteresis;
mod thermal_lag;
mod viscoelastic_creep;

/// Every effect that a diagnosis tries, in the order of the chain.
pub fn library() -> Vec<Box<dyn Effect>> {
    vec![
        Box::new(contact_toe_in::ContactToeIn),
        Box::new(eccentric_load::EccentricLoad),
        Box::new(thermal_lag::ThermalLag),
        Box::new(viscoelastic_creep::ViscoelasticCreep),
        Box::new(rate_independent_hysteresis::RateIndependentHysteresis),
        Box::new(mullins_softening::MullinsSoftening),
        Box::new(strain_stiffening::StrainStiffening),
        Box::new(electrode_warp::ElectrodeWarp),
        Box::new(thermal_hysteresis::ThermalHysteresis),
        Box::new(dead_gap::DeadGap),
        Box::new(permittivity_temperature::PermittivityTemperature),
        Box::new(humidity_uptake::HumidityUptake),
        Box::new(parasitic_capacitance::ParasiticCapacitance),
        Box::new(readout_lag::ReadoutLag),
        Box::new(gain_drift::GainDrift),
        Box::new(offset_drift::OffsetDrift),
    ]
}
