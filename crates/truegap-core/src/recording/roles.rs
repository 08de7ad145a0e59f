//! The roles that a column may play, and their names in a TOML.
//!
//! Limits: one column a role.

use crate::inputs::Role;

/// Every role, in the order in which columns are written.
pub(super) const ROLES: [Role; 10] = [
    Role::Run,
    Role::Sensor,
    Role::Time,
    Role::Force,
    Role::Pressure,
    Role::Gap,
    Role::Temperature,
    Role::Humidity,
    Role::Simulated,
    Role::Response,
];

/// Name of a role in a TOML.
pub(super) fn key(role: Role) -> &'static str {
    match role {
        Role::Time => "time",
        Role::Force => "force",
        Role::Pressure => "pressure",
        Role::Gap => "gap",
        Role::Temperature => "temperature",
        Role::Humidity => "humidity",
        Role::Response => "response",
        Role::Simulated => "simulated",
        Role::Run => "run",
        Role::Sensor => "sensor",
    }
}
