//! A fit that does not depend on where it began: from several starts, until the lowest optimum is found again.
//!
//! Limits: starts lie at the centre of what is known, on the way there under larger noise, and to both sides along the sloppiest directions.

use crate::{
    fit::tuning::{SAME_OPTIMUM, START_DIRECTIONS},
    fit::{levenberg_marquardt::FitOptions, maximum_a_posteriori::fit, model::Model, optimum::Fit},
    whitening::whitener::Whitener,
};
use nalgebra::SymmetricEigen;
use truegap_core::SimulationError;

/// The fit with the lowest objective; `loose` is the same noise, [`LOOSE`] times larger.
///
/// A calibration that is driven far from what is known has curved sloppy directions in which a descent can stop; the true optimum is one that another start finds again.
///
/// # Errors
/// Those of the simulator at the centre of the prior.
pub(crate) fn lowest(model: &Model<'_>, whitener: &Whitener, loose: &Whitener) -> Result<Fit, SimulationError> {
    let centre = vec![0.0; model.parameters.len()];
    let options = FitOptions::default();
    let mut best = fit(model, whitener, &centre, &options)?;
    if centre.is_empty() {
        return Ok(best);
    }
    let near = fit(model, loose, &centre, &options).and_then(|near| fit(model, whitener, &near.z, &options));
    if let Ok(near) = near {
        if (near.objective() - best.objective()).abs() < SAME_OPTIMUM {
            return Ok(lower(best, near));
        }
        best = lower(best, near);
    }
    for start in beside(&best) {
        let Ok(found) = fit(model, whitener, &start, &options) else { continue };
        let again = (found.objective() - best.objective()).abs() < SAME_OPTIMUM;
        best = lower(best, found);
        if again {
            break;
        }
    }
    Ok(best)
}

fn lower(a: Fit, b: Fit) -> Fit {
    if b.objective() < a.objective() { b } else { a }
}

/// Points to both sides of a fit along its sloppiest directions.
fn beside(fit: &Fit) -> Vec<Vec<f64>> {
    let eigen = SymmetricEigen::new(fit.hessian.clone());
    let mut order: Vec<usize> = (0..fit.z.len()).collect();
    order.sort_by(|a, b| eigen.eigenvalues[*a].total_cmp(&eigen.eigenvalues[*b]));
    let of = |direction: &usize| {
        let reach = START_DIRECTIONS.1 / eigen.eigenvalues[*direction].max(1e-3).sqrt();
        let column = eigen.eigenvectors.column(*direction);
        [reach, -reach].map(|reach| fit.z.iter().zip(column.iter()).map(|(z, c)| z + reach * c).collect::<Vec<f64>>())
    };
    order.iter().take(START_DIRECTIONS.0).flat_map(of).collect()
}
