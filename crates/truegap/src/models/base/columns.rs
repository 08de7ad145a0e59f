//! What was done to a sensor, as a simulator of somebody else is given it: names with units, one column a name.
//!
//! Limits: in SI (temperature in degrees Celsius, humidity in per cent); drivers in their own unit under their own name.

use std::borrow::Cow;
use truegap_core::{Inputs, Role};

/// Roles that a simulator is given, with their names.
const GIVEN: [(Role, &str); 7] = [
    (Role::Time, "time_s"),
    (Role::Force, "force_n"),
    (Role::Pressure, "pressure_pa"),
    (Role::Gap, "gap_m"),
    (Role::Temperature, "temperature_c"),
    (Role::Humidity, "humidity_pct"),
    (Role::Simulated, "simulated"),
];

/// The columns that were recorded: the run first, then the roles, then the drivers.
pub fn columns(inputs: &Inputs) -> Vec<(&str, Cow<'_, [f64]>)> {
    let run = ("run", Cow::Owned(inputs.run.iter().map(|run| f64::from(*run)).collect()));
    let roles = GIVEN.into_iter().filter_map(|(role, name)| inputs.column(role).map(|c| (name, Cow::Borrowed(c))));
    let drivers = inputs.drivers.iter().map(|driver| (driver.name.as_str(), Cow::Borrowed(driver.values.as_slice())));
    std::iter::once(run).chain(roles).chain(drivers).collect()
}
