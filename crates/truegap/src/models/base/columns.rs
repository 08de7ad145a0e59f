//! What was done to a sensor, as a simulator of somebody else is given it: names with units, one column a name.
//!
//! Limits: in SI (temperature in degrees Celsius, humidity in per cent); drivers in their own unit under their own name.

use std::borrow::Cow;
use truegap_core::{INPUT_ROLES, Inputs};

/// The columns that were recorded: the run first, then the roles, then the drivers.
pub fn columns(inputs: &Inputs) -> Vec<(&str, Cow<'_, [f64]>)> {
    let run = ("run", Cow::Owned(inputs.run.iter().map(|run| f64::from(*run)).collect()));
    let roles = INPUT_ROLES.into_iter().filter_map(|role| Some((role.column_name(), Cow::Borrowed(inputs.column(role)?))));
    let drivers = inputs.drivers.iter().map(|driver| (driver.name.as_str(), Cow::Borrowed(driver.values.as_slice())));
    std::iter::once(run).chain(roles).chain(drivers).collect()
}
