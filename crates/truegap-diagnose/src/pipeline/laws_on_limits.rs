//! A law whose number has run to its limit does not hold there: where all else would be explained, its family is clear and its form is not.
//!
//! Limits: effects of the library beside a base model without plates; what describes a curve is no law.

use crate::{
    selection::{
        candidates::{Search, Tried},
        verdict::{Decision, Verdict},
    },
    text::spoken,
};
use truegap_core::Parameter;

/// The decision for a model, told as a wrong form where a law of what it claims lies on a limit that is no plain special case; with what a reader is told of that.
pub(crate) fn laws_on_limits(search: &Search<'_>, tried: &Tried, decision: Decision) -> (Decision, Vec<String>) {
    if decision.verdict != Verdict::Explained || search.context.has_plates() {
        return (decision, Vec::new());
    }
    let says = on_limits(search, tried, &decision.carried);
    let verdict = if says.is_empty() { decision.verdict } else { Verdict::WrongForm };
    (Decision { verdict, ..decision }, says)
}

/// Whether a law of what a decision claims lies on such a limit.
pub(crate) fn lies_on_limits(search: &Search<'_>, tried: &Tried, decision: &Decision) -> bool {
    decision.verdict == Verdict::Explained
        && !search.context.has_plates()
        && !on_limits(search, tried, &decision.carried).is_empty()
}

/// What a reader is told of each number that lies on its limit; a law that is `carried` is not claimed.
fn on_limits(search: &Search<'_>, tried: &Tried, carried: &[usize]) -> Vec<String> {
    if tried.effects.iter().any(|effect| *effect >= search.library.len()) {
        return Vec::new();
    }
    let parameters = search.model(&tried.effects).parameters;
    let is_law = |index: &usize| {
        let effect = tried.effects[*index];
        !search.library[effect].describes() && !carried.contains(&effect)
    };
    let says = |index: usize| {
        let id = search.library[tried.effects[index]].id();
        let says = |place: usize| {
            let (number, law) = (&parameters[place].name, spoken(id.0));
            // what is held at nothing is another law, and what describes a share of which nothing is seen says nothing
            let open = !search.context.holds(id, number) && !describes_nothing(search, tried, (index, place));
            open.then(|| format!("`{number}` of the {law} lies on its limit: there its law does not hold"))
        };
        search.on_limits(tried, index).into_iter().filter_map(says).collect::<Vec<_>>()
    };
    (0..tried.effects.len()).filter(is_law).flat_map(says).collect()
}

/// Size of a number from which on it is told from nothing, in its standard deviations.
const TOLD_FROM_NOTHING: f64 = 2.0;

/// Whether a number at `z`, which is known to `sd`, both in deviations of its prior, may be nothing.
pub(crate) fn may_be_nothing(number: &Parameter, z: f64, sd: f64) -> bool {
    number.prior.at(z).abs() < TOLD_FROM_NOTHING * number.prior.slope(z) * sd
}

/// Whether the number at a place describes a share of the law of which nothing is seen.
fn describes_nothing(search: &Search<'_>, tried: &Tried, (index, place): (usize, usize)) -> bool {
    let model = search.model(&tried.effects);
    let Some(share) = model.effects[index].share_of(&model.parameters[place].name) else { return false };
    let mut shares = model.range_of(index).filter(|i| model.parameters[*i].name == share);
    shares.any(|i| may_be_nothing(&model.parameters[i], tried.fit.z[i], tried.fit.sd[i]))
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::{
        Options, Problem,
        common::{Plate, without_rest},
        noise::several::measured,
        pipeline::prepare::Prepared,
    };
    use std::sync::atomic::AtomicBool;
    use truegap_core::Simulator;

    const ROWS: usize = 400;

    /// A zero that grows `growth` times by itself, as a drift has it: `exp(growth t)` from 0 to 1, with a ripple of a thousandth in place of noise.
    fn told(growth: f64) -> Vec<String> {
        let inputs = without_rest(ROWS);
        let plate = Plate::new(Some(false));
        let mut response = plate.respond(&plate.centre(), &inputs, &[]).unwrap();
        response.iter_mut().enumerate().for_each(|(row, value)| {
            let grown = (growth * row as f64 / ROWS as f64).exp_m1() / growth.exp_m1();
            *value += grown + 1e-3 * (2.1 * (row * row) as f64).sin();
        });
        let problem = Problem { inputs: &inputs, response: &response, simulator: &plate };
        let (_, noise) = measured(&problem).unwrap();
        let options = Options { effects: vec!["offset_drift".into()], ..Options::default() };
        let prepared = Prepared::new(&problem, noise, &options).unwrap();
        let (searched, stop) = (prepared.searched(), AtomicBool::new(false));
        let search = prepared.search(&searched, &|_| (), &stop);
        let drift = search.add_each(&search.base().unwrap(), &[0], 1, "test").pop().unwrap();
        assert!(on_limits(&search, &drift, &[0]).is_empty(), "what is carried is not claimed");
        on_limits(&search, &drift, &[])
    }

    /// A drift may grow 1.5 times its exponent over the recording: one that grows five times runs to that limit.
    #[test]
    fn a_drift_that_grows_too_fast_lies_on_its_limit() {
        assert!(told(0.5).is_empty());
        let says = told(5.0);
        assert!(says.len() == 1 && says[0].contains("`fading`"), "{says:?}");
    }
}
