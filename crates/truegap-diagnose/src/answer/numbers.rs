//! Numbers as they stand in `diagnosis.json` and in the model file: parameters, noise.
//!
//! Limits: copies and converts; computes nothing but a parameter's value from its coordinate.

use crate::{
    answer::{
        augmented::{AddedEffect, Augmented, NamedValue, RivalModel, Scales},
        diagnosis::{NoiseFacts, RecordingNoiseFacts},
        found::{Found, Rival},
        parameter_facts::ParameterFacts,
    },
    data::moved::Moved,
    effects::{course::Course, effect::FittedParameter},
    selection::candidates::Tried,
    whitening::noise_model::{NoiseModel, RecordingNoise},
};
use std::ops::Range;

/// Parameters of a fitted model.
pub(crate) fn fitted(found: &Found<'_>, tried: &Tried, range: Range<usize>) -> Vec<FittedParameter> {
    let model = found.search.model(&tried.effects);
    let sd = found.sd(tried);
    let held = |i: usize| {
        let own = (0..tried.effects.len()).find(|index| model.range_of(*index).contains(&i));
        own.is_some_and(|index| found.search.context.holds(model.effects[index].id(), &model.parameters[i].name))
    };
    range
        .map(|i| {
            let parameter = model.parameters[i].clone();
            // a number that is held is held at nothing, whatever the fit made of its last digits
            let free = if held(i) { 0.0 } else { 1.0 };
            let (z, slope) = (tried.fit.z[i], free * parameter.prior.slope(tried.fit.z[i]));
            FittedParameter {
                value: free * parameter.prior.at(z),
                sd: slope * sd[i],
                sd_of_fit: slope * tried.fit.sd[i],
                at_limit: tried.fit.at_limit[i],
                parameter,
            }
        })
        .collect()
}

/// The same for the record.
pub(crate) fn parameters(found: &Found<'_>, tried: &Tried, range: Range<usize>) -> Vec<ParameterFacts> {
    fitted(found, tried, range).into_iter().map(facts).collect()
}

/// A number for the record.
pub(crate) fn facts(f: FittedParameter) -> ParameterFacts {
    ParameterFacts {
        name: f.parameter.name.clone(),
        unit: f.parameter.unit.clone(),
        prior: [f.parameter.centre(), f.parameter.sd()],
        value: f.value,
        sd: f.sd,
        sd_of_fit: f.sd_of_fit,
        at_limit: f.at_limit,
        meaning: f.parameter.meaning,
    }
}

/// A number for the model file.
pub(crate) fn named(f: FittedParameter) -> NamedValue {
    NamedValue { name: f.parameter.name, unit: f.parameter.unit, value: f.value, sd: f.sd }
}

/// The numbers of the base model in `tried`; of several recordings those of the first one's sensor.
fn of_base(found: &Found<'_>, tried: &Tried) -> Vec<NamedValue> {
    let count = found.search.model(&[]).base_count();
    let joined = found.search.problem.simulator.joined();
    let own: Vec<usize> = joined.map_or_else(|| (0..count).collect(), |joined| joined.places(0).to_vec());
    let all = fitted(found, tried, 0..count);
    own.iter().map(|i| named(all[*i].clone())).collect()
}

/// The effects of `tried` with their numbers.
fn added(found: &Found<'_>, tried: &Tried) -> Vec<AddedEffect> {
    let model = found.search.model(&tried.effects);
    let effect = |(index, effect): (usize, &usize)| {
        let law = found.search.library[*effect];
        let numbers = law.of_first(fitted(found, tried, model.range_of(index)), found.search.context);
        let parameters = numbers.into_iter().map(named).collect();
        AddedEffect { id: found.id(*effect), parameters, mechanism: law.words(), carried: found.carries(*effect) }
    };
    tried.effects.iter().enumerate().map(effect).collect()
}

/// The model that the diagnosis ends with.
pub(crate) fn augmented(found: &Found<'_>) -> Augmented {
    let told = found.told(found.chosen());
    let context = found.search.context;
    let rival = |Rival { instead_of, effect, tried }: &Rival| RivalModel {
        instead_of: found.id(*instead_of),
        id: found.id(*effect),
        parameters: of_base(found, tried),
        effects: added(found, tried),
    };
    Augmented {
        parameters: of_base(found, told),
        base_alone: of_base(found, found.base_alone),
        effects: added(found, told),
        scales: Scales {
            longest_run_s: context.longest_run_s,
            shortest_step_s: context.shortest_step_s.unwrap_or(0.0),
            duration_s: context.duration_s,
            response_span: context.response_span,
            noise_sd: context.noise_sd,
            runs: Some(context.runs),
            moved: Some(Moved { followed: Some(Course::followed(context)), ..context.moved.clone() }),
        },
        rivals: found.rivals.iter().map(rival).collect(),
    }
}

/// What is said of rows at the ends of runs that were left out.
fn rows_beyond(noise: &NoiseModel) -> String {
    match noise.untold.iter().map(ExactSizeIterator::len).sum::<usize>() {
        0 => String::new(),
        rows => format!(
            "; {rows} rows at the ends, for which nothing was recorded on the clock of the response, are left out of all errors"
        ),
    }
}

/// The noise, for the record.
pub(crate) fn noise(found: &Found<'_>) -> NoiseFacts {
    let n = found.noise;
    let of_recording = |(k, r): (usize, &RecordingNoise)| RecordingNoiseFacts {
        recording: k + 1,
        says: r.says.clone(),
        white_sd: r.response.white_sd,
        ar_sd: r.response.ar_sd,
        ar_correlation: r.response.ar_correlation,
    };
    NoiseFacts {
        says: n.says.clone() + &rows_beyond(n),
        white_sd: n.response.white_sd,
        ar_sd: n.response.ar_sd,
        ar_correlation: n.response.ar_correlation,
        lasting_sd: n.lasting_sd(),
        load_sd: n.inputs.load * found.search.problem.simulator.full_load().unwrap_or(0.0),
        temperature_sd: n.inputs.temperature,
        measured: n.measured,
        recordings: n.recordings.iter().enumerate().map(of_recording).collect(),
    }
}
