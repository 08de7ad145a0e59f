//! The library of omitted physics: one file an effect, one line in [`library`].
//!
//! Limits: an effect sees the inputs and the chain, never the recorded response.

use effect::Effect;

pub(crate) mod collection;
pub(crate) mod composed;
pub(crate) mod effect;
pub(crate) mod memory;
pub(crate) mod numbers;
pub(crate) mod sentence;

mod ageing;
mod between_rows;
mod bonded_layers;
pub(crate) mod clock_rate;
mod contact_toe_in;
pub(crate) mod course;
pub(crate) mod cycle;
mod dead_gap;
mod delay;
mod driver_coefficient;
mod driver_gain;
mod each_recording;
mod eccentric_load;
mod electrode_warp;
mod foreseen;
mod friction;
mod friction_of_speed;
mod fringing_field;
mod gain_ageing;
mod gain_drift;
mod gain_error;
mod held_warp;
mod humidity_uptake;
mod inner_stiffening;
mod late_driver;
mod load_cell_error;
pub(crate) mod mean_to_both_sides;
mod most_alike;
mod mullins_softening;
mod nonlinearity;
mod offset_drift;
mod offset_steps;
mod parasitic_capacitance;
mod permanent_set;
mod permittivity_temperature;
mod plate_bending;
mod rate_independent_hysteresis;
mod rate_limit;
mod readout_lag;
mod regime_change;
mod rim_field;
mod saturating_loop;
pub(crate) mod saturation;
mod scale;
mod settling;
mod slow_response;
mod strain_stiffening;
mod stress_relaxation;
mod temperature_coefficient;
mod thermal_hysteresis;
mod thermal_lag;
pub(crate) mod time_offset;
mod trapped_air_stiffness;
mod viscoelastic_creep;

/// Every effect that a diagnosis tries, in the order of the chain, in which their stages are to be plugged in.
pub fn library() -> Vec<Box<dyn Effect>> {
    vec![
        Box::new(time_offset::of_each_recording()),
        Box::new(clock_rate::of_each_recording()),
        Box::new(load_cell_error::LoadCellError),
        Box::new(contact_toe_in::ContactToeIn),
        Box::new(eccentric_load::EccentricLoad),
        Box::new(inner_stiffening::InnerStiffening),
        Box::new(thermal_lag::ThermalLag),
        Box::new(trapped_air_stiffness::TrappedAirStiffness),
        Box::new(rate_independent_hysteresis::RateIndependentHysteresis),
        Box::new(mullins_softening::MullinsSoftening),
        Box::new(ageing::Ageing),
        Box::new(strain_stiffening::StrainStiffening),
        Box::new(bonded_layers::BondedLayers),
        Box::new(viscoelastic_creep::ViscoelasticCreep),
        Box::new(plate_bending::PlateBending),
        Box::new(electrode_warp::ElectrodeWarp),
        Box::new(held_warp::HeldWarp),
        Box::new(thermal_hysteresis::ThermalHysteresis),
        Box::new(dead_gap::DeadGap),
        Box::new(permittivity_temperature::PermittivityTemperature),
        Box::new(humidity_uptake::HumidityUptake),
        Box::new(fringing_field::FringingField),
        Box::new(rim_field::RimField),
        Box::new(parasitic_capacitance::ParasiticCapacitance),
        Box::new(gain_drift::GainDrift),
        Box::new(gain_error::GainError),
        Box::new(gain_ageing::GainAgeing),
        Box::new(driver_gain::DriverGain(0)),
        Box::new(driver_gain::DriverGain(1)),
        Box::new(friction::Friction(0)),
        Box::new(friction::Friction(1)),
        Box::new(saturating_loop::SaturatingLoop),
        Box::new(nonlinearity::Nonlinearity),
        Box::new(permanent_set::PermanentSet),
        Box::new(temperature_coefficient::TemperatureCoefficient),
        Box::new(driver_coefficient::DriverCoefficient(0)),
        Box::new(driver_coefficient::DriverCoefficient(1)),
        Box::new(late_driver::LateDriver(0)),
        Box::new(late_driver::LateDriver(1)),
        Box::new(stress_relaxation::StressRelaxation),
        Box::new(slow_response::SlowResponse),
        Box::new(rate_limit::RateLimit),
        Box::new(regime_change::RegimeChange::OfWhatMoves),
        Box::new(regime_change::RegimeChange::OfTheGain),
        Box::new(saturation::Saturation),
        Box::new(readout_lag::ReadoutLag),
        Box::new(offset_drift::OffsetDrift),
        Box::new(settling::Settling),
        Box::new(offset_steps::OffsetSteps),
        Box::new(cycle::Cycle::Daily),
        Box::new(cycle::Cycle::Yearly),
    ]
}
