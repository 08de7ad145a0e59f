//! An effect that belongs to a recording and not to the sensor: numbers of its own for each of several recordings.
//!
//! Limits: of one recording, the effect itself.

use crate::{
    data::{context::Context, problem::Problem},
    effects::composed::words::InWords,
    effects::effect::{About, Effect, Family, FittedParameter, Separation, ZeroCourse},
    text::listed,
};
use truegap_core::{EffectId, Parameter, Stage, simulator::StageName};

/// An effect of clocks and the like; in a joint fit each recording has its own size (a multiple of the common one) and its own shape.
pub struct EachRecording<E> {
    /// the effect of one recording
    pub inner: E,
    /// its stage, from its values
    pub make: fn(&[f64]) -> Box<dyn Stage>,
}

/// The stage of every recording, by the runs before it.
struct Each {
    make: fn(&[f64]) -> Box<dyn Stage>,
    values: Vec<(usize, Vec<f64>)>,
}

impl Stage for Each {
    fn after_runs(&self, runs: usize) -> Option<Box<dyn Stage>> {
        let own = self.values.iter().rev().find(|(before, _)| *before <= runs);
        own.map(|(_, values)| (self.make)(values))
    }
}

/// Runs before each recording; empty where there is one.
fn runs_before(context: &Context<'_>) -> Vec<usize> {
    let Some(joined) = context.simulator.joined().filter(|joined| joined.count() > 1) else { return Vec::new() };
    let runs = context.inputs.runs();
    let before = |k: usize| {
        let first = joined.rows(k, context.inputs).start;
        runs.iter().filter(|run| run.end <= first).count()
    };
    (0..joined.count()).map(before).collect()
}

/// Values of the effect for each of `count` recordings, from those of all.
fn apart(values: &[f64], count: usize) -> Vec<Vec<f64>> {
    let own = (values.len() - 1) / count;
    let of = |own: &[f64]| [values[0] * own[0]].into_iter().chain(own[1..].iter().copied()).collect();
    values[1..].chunks(own.max(1)).map(of).collect()
}

impl<E: Effect> EachRecording<E> {
    /// The numbers of recording `k` (from 0), of which each has `own`, under the names that one recording alone would give them.
    fn of(&self, fitted: &[FittedParameter], k: usize, own: usize) -> Vec<FittedParameter> {
        let mut numbers = fitted[1 + k * own..1 + (k + 1) * own].to_vec();
        let (size, factor) = (&fitted[0], &numbers[0]);
        let at_limit = factor.at_limit || size.at_limit;
        numbers[0] = FittedParameter {
            value: size.value * factor.value,
            sd: size.value.abs() * factor.sd,
            sd_of_fit: size.value.abs() * factor.sd_of_fit,
            at_limit,
            ..size.clone()
        };
        let suffix = format!("_{}", k + 1);
        for number in &mut numbers[1..] {
            number.parameter.name = number.parameter.name.trim_end_matches(&suffix).to_owned();
        }
        numbers
    }
}

impl<E: Effect> Effect for EachRecording<E> {
    fn id(&self) -> EffectId {
        self.inner.id()
    }
    fn stage(&self) -> StageName {
        self.inner.stage()
    }
    fn family(&self) -> Family {
        self.inner.family()
    }
    fn in_words(&self, context: &Context<'_>) -> Option<InWords> {
        self.inner.in_words(context)
    }
    fn about(&self) -> About {
        self.inner.about()
    }
    fn far_sizes(&self, context: &Context<'_>, searched: &Problem<'_>) -> Vec<f64> {
        self.inner.far_sizes(context, searched)
    }
    fn touches(&self) -> Vec<StageName> {
        self.inner.touches()
    }
    fn separations(&self) -> &'static [Separation] {
        self.inner.separations()
    }
    fn zero_course(&self) -> ZeroCourse {
        self.inner.zero_course()
    }
    fn of_recorder(&self) -> bool {
        true
    }
    fn of_start(&self, context: &Context<'_>) -> &'static [&'static str] {
        self.inner.of_start(context)
    }
    fn of_first(&self, fitted: Vec<FittedParameter>, context: &Context<'_>) -> Vec<FittedParameter> {
        let count = runs_before(context).len();
        match (fitted.len() - 1).checked_div(count) {
            None => fitted,
            Some(own) => self.of(&fitted, 0, own),
        }
    }
    fn parameters(&self, context: &Context<'_>) -> Vec<Parameter> {
        let own = self.inner.parameters(context);
        let count = runs_before(context).len();
        if count == 0 {
            return own;
        }
        let mut list = vec![own[0].clone()];
        for k in 1..=count {
            let meaning = format!("{} of recording {k} over the common one", own[0].name);
            list.push(Parameter::normal(&format!("{}_{k}", own[0].name), "sizes", 0.0, 1.0, &meaning));
            let numbered = |p: &Parameter| Parameter { name: format!("{}_{k}", p.name), ..p.clone() };
            list.extend(own[1..].iter().map(numbered));
        }
        list
    }
    fn starts(&self, context: &Context<'_>) -> Vec<Vec<f64>> {
        let own = self.inner.starts(context);
        let count = runs_before(context).len();
        if count == 0 {
            return own;
        }
        // all recordings alike, and each one alone; a size with all its multiples at 0 says nothing of which way to go
        let alone = (0..count).map(|only| (0..count).map(|k| f64::from(u8::from(k == only))).collect());
        let factors: Vec<Vec<f64>> = std::iter::once(vec![1.0; count]).chain(alone).collect();
        let with = |shape: &Vec<f64>, factors: &Vec<f64>| {
            factors.iter().flat_map(|f| std::iter::once(*f).chain(shape.iter().copied())).collect::<Vec<f64>>()
        };
        own.iter().flat_map(|shape| factors.iter().map(|f| with(shape, f)).collect::<Vec<_>>()).collect()
    }
    fn came_later(&self) -> Vec<&'static str> {
        self.inner.came_later()
    }
    fn may_be_nothing(&self) -> &'static [&'static str] {
        self.inner.may_be_nothing()
    }
    fn at_once(&self) -> &'static [&'static str] {
        self.inner.at_once()
    }
    fn smooths(&self) -> bool {
        self.inner.smooths()
    }
    fn testable(&self, context: &Context<'_>) -> Result<(), String> {
        self.inner.testable(context)
    }
    fn with(&self, values: &[f64], context: &Context<'_>) -> Box<dyn Stage> {
        let before = runs_before(context);
        if before.is_empty() {
            return self.inner.with(values, context);
        }
        let values = before.iter().copied().zip(apart(values, before.len())).collect();
        Box::new(Each { make: self.make, values })
    }
    fn sibling(&self, values: &[f64], context: &Context<'_>) -> Option<Box<dyn Stage>> {
        if runs_before(context).is_empty() { self.inner.sibling(values, context) } else { None }
    }
    fn says(&self, fitted: &[FittedParameter]) -> String {
        self.inner.says(fitted)
    }
    fn told(&self, fitted: &[FittedParameter], context: &Context<'_>, beside: &[(EffectId, Vec<FittedParameter>)]) -> String {
        let count = runs_before(context).len();
        if count == 0 {
            return self.inner.told(fitted, context, beside);
        }
        let own = (fitted.len() - 1) / count;
        let of = |k: usize| format!("in recording {}, {}", k + 1, self.inner.says(&self.of(fitted, k, own)));
        let said: Vec<String> = (0..count).map(of).collect();
        listed(&said, "and")
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    struct Late(f64);
    impl Stage for Late {
        fn late_s(&self, elapsed_s: f64) -> f64 {
            self.0 + elapsed_s
        }
    }

    #[test]
    fn each_recording_has_a_size_and_a_shape_of_its_own() {
        // size 2; of recording 1 once and shape 7, of recording 2 half of it the other way and shape 9
        let values = apart(&[2.0, 1.0, 7.0, -0.5, 9.0], 2);
        assert_eq!(values, [[2.0, 7.0], [-1.0, 9.0]]);
        let each = Each { make: |v| Box::new(Late(v[0])), values: [0, 3].into_iter().zip(values).collect() };
        let late = |runs: usize| each.after_runs(runs).map(|stage| stage.late_s(0.0));
        assert_eq!([late(0), late(2), late(3)], [Some(2.0), Some(2.0), Some(-1.0)]);
    }
}
