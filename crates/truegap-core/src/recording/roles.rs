//! The roles that a column may play.
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
