//! Which column a straight line follows, where nobody has said it and another one could be meant.
//!
//! Limits: the base model `linear`; time, which always moves, is none that could be meant.

use crate::models::Base;
use truegap_core::{Recording, Role, ends};
use truegap_diagnose::text::listed;
use truegap_model::{BaseModel, DRIVERS, Followed};

/// A sentence for the reader; `None` where the column was named or is the only one that moves.
pub(super) fn says(base: &Base, recording: &Recording) -> Option<String> {
    let BaseModel::Linear { driver, .. } = &base.spec else { return None };
    if recording.base.further.contains_key("driver") {
        return None;
    }
    let followed = match driver {
        Followed::Column(driver) => driver.role.key(),
        Followed::Named(driver) => &driver.name,
    };
    let inputs = &recording.inputs;
    let roles = DRIVERS.into_iter().filter(|role| *role != Role::Time);
    let roles = roles.filter_map(|role| Some((role.key(), inputs.column(role)?)));
    let drivers = inputs.drivers.iter().map(|driver| (driver.name.as_str(), driver.values.as_slice()));
    let moves = |values: &[f64]| {
        let (low, high) = ends(values.iter().copied());
        low < high
    };
    let others: Vec<String> = roles
        .chain(drivers)
        .filter(|(name, values)| *name != followed && moves(values))
        .map(|(name, _)| name.to_owned())
        .collect();
    let first = others.first()?;
    Some(format!(
        "the straight line follows {followed}; to have it follow {}, write driver = \"{first}\" under [base] of a TOML",
        listed(&others, "or")
    ))
}
