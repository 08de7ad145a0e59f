//! A law whose only difference from a simpler one is not seen stands in one set with that: an influence that comes late by 0.7 ms (sd 0.6) may be there at once.
//!
//! The likelihood tells the two apart by the noise. Where equations only describe, what they leave is more than the noise, and the deviation that is told of a number counts that.
//!
//! Limits: effects that name the law they come down to, and the number that is 0 in it; which of the two is likelier is left as it is.

use crate::{
    pipeline::laws_on_limits::may_be_nothing,
    selection::{
        candidates::{Search, Tried},
        verdict::Decision,
    },
};

/// The decision for a model, with the simpler law in the set of each claimed effect that is not told from it; `sd` are the deviations that are told of its numbers, in those of the prior.
pub(crate) fn laws_not_told_apart(search: &Search<'_>, tried: &Tried, sd: &[f64], decision: Decision) -> Decision {
    let model = search.model(&tried.effects);
    let simpler = |(index, effect): (usize, &usize)| {
        let law = search.library[*effect];
        let (simple, apart) = (law.comes_down_to()?, law.apart_by()?);
        let simple = search.library.iter().position(|other| other.id() == simple)?;
        let claimed = !decision.carried.contains(effect) && !tried.effects.contains(&simple);
        let number = model.range_of(index).find(|i| model.parameters[*i].name == apart)?;
        let unseen = may_be_nothing(&model.parameters[number], tried.fit.z[number], sd[number]);
        (claimed && unseen).then_some((*effect, simple))
    };
    let pairs: Vec<(usize, usize)> = tried.effects.iter().enumerate().filter_map(simpler).collect();
    pairs.into_iter().fold(decision, Decision::with_rival)
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::{
        Options, Problem,
        common::{Plate, without_rest},
        noise::several::measured,
        pipeline::prepare::Prepared,
        selection::verdict::Verdict,
    };
    use std::sync::atomic::AtomicBool;
    use truegap_core::{Driver, Simulator};

    const ROWS: usize = 400;

    /// A heater that moves the reading late by 20 rows, as a law that may come late has it, told with deviations `times` as large as the lateness itself; the sets that are told.
    fn sets(times: f64, carried: bool) -> (Verdict, Vec<Vec<&'static str>>) {
        let values: Vec<f64> = (0..ROWS).map(|row| f64::from(u8::from(row / 60 % 2 == 1))).collect();
        let mut inputs = without_rest(ROWS);
        let plate = Plate::new(Some(false));
        let mut response = plate.respond(&plate.centre(), &inputs, &[]).unwrap();
        let step = inputs.time_s.as_ref().map_or(1.0, |time| time[1] - time[0]);
        let mut late = 0.0;
        for (row, value) in response.iter_mut().enumerate() {
            late += (values[row] - late) / 20.0;
            *value += 0.5 * late + 1e-3 * (2.1 * (row * row) as f64).sin();
        }
        inputs.drivers = vec![Driver { name: "heater".into(), unit: "W".into(), values }];
        let problem = Problem { inputs: &inputs, response: &response, simulator: &plate };
        let (_, noise) = measured(&problem).unwrap();
        let options = Options { effects: vec!["late_driver".into(), "driver_coefficient".into()], ..Options::default() };
        let prepared = Prepared::new(&problem, noise, &options).unwrap();
        let (searched, stop) = (prepared.searched(), AtomicBool::new(false));
        let search = prepared.search(&searched, &|_| (), &stop);
        let own = search.library.iter().position(|effect| effect.id().0 == "late_driver").unwrap();
        let tried = search.add_each(&search.base().unwrap(), &[own], 1, "test").pop().unwrap();
        let model = search.model(&tried.effects);
        let tau = model.parameters.len() - 1;
        let prior = &model.parameters[tau].prior;
        let found = prior.at(tried.fit.z[tau]);
        assert!((found / (20.0 * step) - 1.0).abs() < 0.2, "{found} s of rows of {step} s");
        let mut sd = tried.fit.sd.clone();
        sd[tau] = times * found / prior.slope(tried.fit.z[tau]);
        let carried = if carried { vec![own] } else { Vec::new() };
        let decision = Decision { sets: vec![vec![own]], carried, ..Decision::nothing(Verdict::Explained, 0) };
        let decision = laws_not_told_apart(&search, &tried, &sd, decision);
        (decision.verdict, decision.sets.iter().map(|set| set.iter().map(|e| search.library[*e].id().0).collect()).collect())
    }

    /// A lateness of three of its deviations is seen; one of one deviation may be none.
    #[test]
    fn an_influence_that_may_act_at_once_stands_in_a_set_with_one_that_does() {
        assert_eq!(sets(1.0 / 3.0, false), (Verdict::Explained, vec![vec!["late_driver"]]));
        assert_eq!(sets(1.0, false), (Verdict::Ambiguous, vec![vec!["late_driver", "driver_coefficient"]]));
        assert_eq!(sets(1.0, true), (Verdict::Explained, vec![vec!["late_driver"]]), "what is carried is not claimed");
    }
}
