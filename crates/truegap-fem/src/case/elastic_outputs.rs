//! Outputs of elastic cases: from words to goals.
//!
//! What belongs to a plate is in `contact`.

use super::description::{Case, Output, OutputKind};
use super::error::CaseError;
use crate::elasticity::{Component, Goal, Quantity};
use crate::symmetry::Symmetry;

/// The goal of an output of any elastic body.
pub(super) fn quantity(case: &Case, output: &Output) -> Result<Quantity, CaseError> {
    let at = output.at.unwrap_or([f64::NAN; 2]);
    let tensor = || output.component.clone().unwrap_or_default();
    let goal = match output.kind {
        OutputKind::Energy => Goal::Energy,
        OutputKind::Reaction => {
            Goal::Reaction { boundary: output.boundary.clone().unwrap_or_default(), component: component(case, output)? }
        }
        OutputKind::Displacement => Goal::Displacement { at, component: component(case, output)? },
        OutputKind::Stress => Goal::Stress { at, component: tensor() },
        OutputKind::Strain => Goal::Strain { at, component: tensor() },
        _ => {
            return Err(CaseError::UnknownWord {
                file: case.file.clone(),
                place: format!("output `{}` of an elastic case, kind", output.name),
                found: format!("{:?}", output.kind).to_lowercase(),
                known: "energy, reaction, displacement, stress, strain; where the boundary has a plate also contact_force, contact_radius, peak_pressure, plate_travel".into(),
            });
        }
    };
    Ok(Quantity { name: output.name.clone(), goal })
}

fn component(case: &Case, output: &Output) -> Result<Component, CaseError> {
    let names = match case.symmetry {
        Symmetry::Axisymmetric => ["r", "z"],
        Symmetry::Planar => ["x", "y"],
    };
    match output.component.as_deref().unwrap_or("(none)") {
        found if found == names[0] => Ok(Component::First),
        found if found == names[1] => Ok(Component::Second),
        found => Err(CaseError::UnknownWord {
            file: case.file.clone(),
            place: format!("output `{}`, component", output.name),
            found: found.into(),
            known: names.join(", "),
        }),
    }
}
