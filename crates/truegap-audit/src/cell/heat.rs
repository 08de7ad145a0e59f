//! A bead that sticks to two plates while it is heated: its faces cannot spread, so its height grows more than that of a free bead.
//!
//! Limits: rigid plates; heights and stiffness, not the shape of the side.

use super::{
    geometry::Cell,
    press::{Bonding, half_mesh, silicone},
};
use crate::error::AuditError;
use truegap_fem::{
    FemError, Symmetry,
    elasticity::{Component, Condition, Goal, LawKind, Material, Order, Problem, Quantity, Temperature, solve_goals},
};

/// A number and its estimated error.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Estimated {
    /// the number
    pub value: f64,
    /// estimated magnitude of its error
    pub error_estimate: f64,
}

/// Edge at the bonded rim, over the height.
const RIM: f64 = 2e-3;

/// Growth of the height of a bonded bead over that of a free one, per difference of expansion between bead and plates.
///
/// Between 1 (slender) and (1 + ν) / (1 - ν) (flat). **Accuracy:** both ends in `held_expansion_lies_between_its_closed_forms`.
///
/// # Errors
/// [`AuditError::Fem`].
pub fn held_expansion(cell: &Cell) -> Result<Estimated, AuditError> {
    let failed = || AuditError::fem::<FemError>("heated bead");
    // small numbers: the law is linear
    let (heat, press) = (1e-3, 1e-3);
    let hot = pushed(cell, LawKind::Linear, heat, 0.0).map_err(failed())?;
    let cold = pushed(cell, LawKind::Linear, 0.0, press).map_err(failed())?;
    let value = hot.value / cold.value * press / heat;
    let relative = hot.error_estimate / hot.value.abs() + cold.error_estimate / cold.value.abs();
    Ok(Estimated { value, error_estimate: value * relative })
}

/// Secant stiffness of a bonded bead at a strain when it has been heated by a thermal strain, over that of the cold bead, its modulus unchanged.
///
/// # Errors
/// [`AuditError::Fem`].
pub(crate) fn heated_stiffness(cell: &Cell, thermal_strain: f64, strain: f64) -> Result<Estimated, AuditError> {
    let failed = || AuditError::fem::<FemError>("heated bead");
    let grown = held_expansion(cell)?.value * thermal_strain;
    let law = LawKind::NeoHookean;
    let push = |heat, press| pushed(cell, law, heat, press).map_err(failed());
    let secant = |loaded: Estimated, free: Estimated, height: f64| (loaded.value - free.value) / height;
    let cold = secant(push(0.0, strain)?, Estimated { value: 0.0, error_estimate: 0.0 }, strain);
    let squeezed = strain * (1.0 + grown) - grown;
    let loaded = push(thermal_strain, squeezed)?;
    // the squeeze is a share of the hot height, as strain is in the model
    let hot = secant(loaded, push(thermal_strain, -grown)?, strain);
    Ok(Estimated {
        value: hot / cold,
        error_estimate: 2.0 * loaded.error_estimate / loaded.value.abs() * (hot / cold - 1.0).abs(),
    })
}

/// Compressive force over modulus and face of a bead of unit height, heated and squeezed.
fn pushed(cell: &Cell, law: LawKind, thermal_strain: f64, squeeze: f64) -> Result<Estimated, FemError> {
    let radius = cell.bead / cell.height;
    use Component::{First, Second};
    let problem = Problem {
        mesh: half_mesh(radius, Bonding::Bonded, if law == LawKind::Linear { RIM } else { 10.0 * RIM })?,
        symmetry: Symmetry::Axisymmetric,
        materials: vec![Material { law, ..silicone(cell.poisson) }],
        conditions: vec![
            Condition::fix("face", First),
            Condition::fix("face", Second),
            Condition::displace("middle", Second, -0.5 * squeeze),
        ],
        temperature: Temperature::uniform(thermal_strain),
        body_force: None,
        order: Order::Quadratic,
    };
    let goal = Quantity { name: "F".into(), goal: Goal::Reaction { boundary: "middle".into(), component: Second } };
    let answer = &solve_goals(&problem, &[goal])?.answers[0];
    let face = std::f64::consts::PI * radius * radius;
    Ok(Estimated { value: -answer.value / face, error_estimate: answer.error_estimate / face })
}
