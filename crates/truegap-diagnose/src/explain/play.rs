//! A fitted model played on inputs that nobody has recorded yet.
//!
//! Limits: linear about the fit; the noise of a row is that of the recording, white.

use crate::selection::candidates::{Search, Tried};
use nalgebra::{Cholesky, DMatrix, DVector};
use truegap_core::{Inputs, Role, Stage};

/// Step of a difference quotient, in standard deviations of the fit.
const STEP: f64 = 0.02;

/// A column of load that this base model would take.
pub(crate) fn load_role(search: &Search<'_>) -> Role {
    let inputs = search.problem.inputs;
    if inputs.pressure_pa.is_some() && inputs.force_n.is_none() { Role::Pressure } else { Role::Force }
}

/// The response on `inputs`, in standard deviations of the noise; `None` where the model has no answer.
pub(crate) fn play(search: &Search<'_>, tried: &Tried, z: &[f64], inputs: &Inputs) -> Option<DVector<f64>> {
    let model = search.model(&tried.effects);
    let stages = model.stages(z);
    let borrowed: Vec<&dyn Stage> = stages.iter().map(AsRef::as_ref).collect();
    let response = search.problem.simulator.respond(&model.values(z)[..model.base_count()], inputs, &borrowed).ok()?;
    Some(DVector::from_vec(response) / search.context.noise_sd)
}

/// Change of that response per unit of each prior-whitened coordinate, at the fit.
pub(crate) fn jacobian(search: &Search<'_>, tried: &Tried, inputs: &Inputs) -> Option<DMatrix<f64>> {
    let here = play(search, tried, &tried.fit.z, inputs)?;
    let mut jacobian = DMatrix::zeros(here.len(), tried.fit.z.len());
    for index in 0..tried.fit.z.len() {
        let mut z = tried.fit.z.clone();
        let step = STEP * tried.fit.sd[index];
        z[index] += step;
        jacobian.set_column(index, &((play(search, tried, &z, inputs)? - &here) / step));
    }
    Some(jacobian)
}

/// Standard deviations between two fitted models on `inputs`, the rival's parameters free again within their posterior.
pub(crate) fn separation(search: &Search<'_>, inputs: &Inputs, best: &Tried, rival: &Tried) -> Option<f64> {
    let difference = play(search, best, &best.fit.z, inputs)? - play(search, rival, &rival.fit.z, inputs)?;
    let jacobian = jacobian(search, rival, inputs)?;
    let hessian = jacobian.tr_mul(&jacobian) + &rival.fit.hessian;
    let cross = jacobian.tr_mul(&difference);
    let absorbed = Cholesky::new(hessian).map_or(0.0, |f| cross.dot(&f.solve(&cross)));
    Some((difference.norm_squared() - absorbed).max(0.0).sqrt())
}

/// Share of the standard deviation of coordinate `index` that is left once `inputs` have been recorded as well.
pub(crate) fn left_of(search: &Search<'_>, inputs: &Inputs, tried: &Tried, index: usize) -> Option<f64> {
    let jacobian = jacobian(search, tried, inputs)?;
    let variance = |hessian: DMatrix<f64>| {
        let mut unit = DVector::zeros(hessian.nrows());
        unit[index] = 1.0;
        Cholesky::new(hessian).map(|f| f.solve(&unit)[index])
    };
    let after = variance(jacobian.tr_mul(&jacobian) + &tried.fit.hessian)?;
    Some((after / variance(tried.fit.hessian.clone())?).max(0.0).sqrt())
}
