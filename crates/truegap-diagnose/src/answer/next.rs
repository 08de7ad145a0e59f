//! What to measure next: by what is wrong with the recording, by the rivals that are left, or by the number that is least sure.
//!
//! Limits: decides nothing; causes outside the library cannot be played, so no run is weighed against them.

use crate::{
    answer::{
        found::Found,
        numbers::fitted,
        tuning::{MOST_RIVALS, NOT_EXCLUDED},
    },
    data::context::Context,
    discovery::discover::widened,
    effects::effect::{Effect, FittedParameter},
    explain::{
        narrowing::{LeastSure, least_sure, narrowing},
        next_experiment::{NextExperiment, next_experiment, settling},
    },
    selection::{candidates::Tried, verdict::Verdict},
};

/// Standard deviations from which a part of a law is seen.
const PART_SEEN: f64 = 2.0;

/// Standard deviation of a number, in that of its prior, from which on the recording has told nothing of it.
const AS_BEFORE: f64 = 0.9;

/// What to do where a tone or bursts are in the reading.
const LISTEN: &str = "record again at another sampling rate, with leads shielded and what switches nearby turned off: \
    interference moves to another frequency or goes, what the sensor makes stays";

/// What to do where the recording may not be trusted.
const REPAIR_IT: &str = "repair what the notices name, and diagnose the recording again";

/// What to do where an input is missing.
const RECORD_IT: &str =
    "record what moves slowly beside the sensor: temperature, humidity, supply voltage, the state of the fixture";

/// What to do where all agrees.
const WIDEN_IT: &str =
    "nothing is missing that this recording could show; widen the range of load, temperature and time to see more";

/// What to do where tests see a difference that a noise does as well which nobody measured.
const LET_IT_REST: &str = "record again and begin with a while in which nothing is moved: that shows how the reading wanders by itself, and what is seen here is noise or is not";

/// What to do where the search was stopped: what this recording could show is not known.
const LET_IT_END: &str = "diagnose the recording again and let the search end: what is missing was not looked for to the end";

/// What to do where the reading does not show what is quick in the column that it follows.
fn let_it_stand(followed: &str) -> String {
    format!(
        "let {followed} stand still for a while and then go up and down at once, and record both: what is quick in it while it stands is noise of its own, and after a step a lag comes late where a mean does not"
    )
}

/// What to do where nothing of the library explains what is there.
const VARY_IT: &str =
    "no cause of the library explains it; change one input at a time, slow and fast, and look which one the mismatch follows";

/// What to measure next.
pub(crate) fn next(found: &Found<'_>) -> NextExperiment {
    let only = |says: &str| NextExperiment { says: says.into(), ..NextExperiment::default() };
    match &found.reserved {
        Some(reserved) if reserved.input_missing => return only(RECORD_IT),
        Some(reserved) if reserved.withheld => return only(REPAIR_IT),
        None if found.is_about_interference() => return only(LISTEN),
        _ if found.interrupted => return only(LET_IT_END),
        _ => {}
    }
    if let Some(followed) = &found.smoothed {
        return only(&let_it_stand(followed));
    }
    let models = &found.selection.models;
    let named = Some(found.decision.model).filter(|model| !models[*model].effects.is_empty());
    if found.decision.verdict == Verdict::Unexplained {
        return only(VARY_IT);
    }
    let best = found.selection.named_or_likeliest(found.decision.model).filter(|_| found.decision.verdict != Verdict::Agrees);
    let seen = found.before.fires() && !found.noise.measured;
    let Some(best) = best else { return only(if seen { LET_IT_REST } else { WIDEN_IT }) };
    if let Some(another_place) = named.and_then(|named| of_words(found, &models[named])) {
        return another_place;
    }
    let rivals: Vec<&Tried> = rivals(&found.selection.probability, best).into_iter().map(|rival| &models[rival]).collect();
    match (rivals.as_slice(), named) {
        ([], Some(_)) => narrowing(found.search, &models[best], least_sure(numbers(found, found.told(&models[best])))),
        ([], None) => only(VARY_IT),
        (rivals, _) => next_experiment(found.search, &models[best], rivals),
    }
}

/// What settles the least sure word of a mechanism that is named.
fn of_words(found: &Found<'_>, best: &Tried) -> Option<NextExperiment> {
    let behind = found.search.library.len();
    let first = behind - found.mechanisms.len();
    // a rival was fitted beside what came before it: that of the last mechanism stands beside all the others
    let index = found.mechanisms.len().checked_sub(1).filter(|index| best.effects.contains(&(first + index)))?;
    let rival = found.mechanisms[index].rival.as_ref()?;
    let wider = widened(found.search, &rival.effect);
    // beside what it was fitted, it had the place of the mechanism found
    let of_rival = |effect: &usize| if *effect == first + index { behind } else { *effect };
    let effects = rival.tried.effects.iter().map(of_rival).collect();
    let other = Tried { effects, fit: rival.tried.fit.clone() };
    Some(settling(&wider, best, &other, rival.word, &rival.values))
}

/// Models that the recording has not excluded beside model `best`: those with at least [`NOT_EXCLUDED`] of its probability, the likeliest few.
fn rivals(probability: &[f64], best: usize) -> Vec<usize> {
    let held = |model: &usize| *model != best && probability[*model] > NOT_EXCLUDED * probability[best];
    let mut list: Vec<usize> = (0..probability.len()).filter(held).collect();
    list.sort_by(|a, b| probability[*b].total_cmp(&probability[*a]));
    list.truncate(MOST_RIVALS);
    list
}

/// The numbers of the effects of a model that another recording could narrow.
fn numbers<'a>(found: &'a Found<'_>, best: &'a Tried) -> impl Iterator<Item = LeastSure> {
    let model = found.search.model(&best.effects);
    let of = move |(place, effect): (usize, &'a usize)| {
        let range = model.range_of(place);
        let named = move |(index, number)| LeastSure { index, number, effect: found.id(*effect) };
        let (law, context) = (found.search.library[*effect], found.search.context);
        let open = move |least: &LeastSure| {
            let name = &least.number.parameter.name;
            let sd = best.fit.sd.get(least.index).copied().unwrap_or(1.0);
            !context.holds(law.id(), name) && can_be_narrowed(law, context, &least.number, sd)
        };
        range.clone().zip(fitted(found, best, range)).map(named).filter(open)
    };
    best.effects.iter().enumerate().flat_map(of)
}

/// Whether another recording could narrow a number of an effect; `sd` is its standard deviation in that of its prior. Those of a clock, or of how a recording began, belong to the one recording; of a part of the
/// law that is not seen, and of what this part would be like, there is nothing to narrow.
fn can_be_narrowed(law: &dyn Effect, context: &Context<'_>, number: &FittedParameter, sd: f64) -> bool {
    let among = |names: &[&str]| names.contains(&number.parameter.name.as_str());
    let seen = number.value.abs() > PART_SEEN * number.sd;
    let of_one_recording = law.of_recorder() || among(law.of_start(context));
    !of_one_recording && (seen || !among(law.may_be_nothing())) && sd < AS_BEFORE
}

#[cfg(test)]
mod tests {
    use super::{can_be_narrowed, rivals};
    use crate::{
        Context, FittedParameter,
        common::{Plate, recording},
        library,
    };
    use truegap_core::{EffectId, Parameter};

    #[test]
    fn what_another_recording_could_not_narrow_is_not_suggested() {
        let (plate, inputs) = (Plate::new(Some(true)), recording());
        let context = Context::new(&inputs, &plate, 2.0, 60.0);
        // value and error, and the error in that of the prior
        let library = library();
        let can = |law: &'static str, name: &str, (value, sd, of_prior): (f64, f64, f64)| {
            let law = library.iter().find(|effect| effect.id() == EffectId(law)).unwrap().as_ref();
            let parameter = Parameter::normal(name, "1", 0.0, 1.0, "");
            can_be_narrowed(law, &context, &FittedParameter { parameter, value, sd, sd_of_fit: sd, at_limit: false }, of_prior)
        };
        assert!(can("slow_response", "tau", (1.0, 0.5, 0.5)));
        // how this recording began; a share that is not seen, and one that is; a ratio of which nothing was learned
        assert!(!can("slow_response", "before", (1.0, 0.5, 0.5)));
        assert!(!can("slow_response", "slow_share", (0.001, 0.002, 0.1)) && can("slow_response", "slow_share", (0.2, 0.05, 0.1)));
        assert!(!can("slow_response", "slower", (10.0, 7.0, 0.99)));
        // the clocks of another recording are others
        assert!(!can("clock_rate", "rate", (0.02, 0.01, 0.1)));
    }

    #[test]
    fn what_the_posterior_has_excluded_is_no_rival() {
        assert_eq!(rivals(&[0.9995, 4e-4, 1e-4], 0), Vec::<usize>::new());
        assert_eq!(rivals(&[0.6, 0.28, 0.1, 0.02], 0), [1, 2]);
        // a model that is stated although a larger one is likelier has that one for a rival
        assert_eq!(rivals(&[0.5, 0.4, 0.03, 0.03, 0.03, 0.01], 1), [0, 2, 3]);
    }
}
