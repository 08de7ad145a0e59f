//! An effect whose size is foreseen, and which cannot be absent.

use super::{World, effects::Term};
use crate::{About, Context, Effect, Family, FittedParameter};
use rand::SeedableRng;
use rand_chacha::ChaCha8Rng;
use std::sync::Mutex;
use truegap_core::{EffectId, Parameter, Stage, StageName};

/// A term of a share of 1, known to 0.15 and between 0.5 and 1.5; it keeps the shares that it was asked for.
struct Foreseen {
    term: Term,
    asked: Mutex<Vec<f64>>,
}

impl Effect for Foreseen {
    fn id(&self) -> EffectId {
        self.term.id()
    }
    fn stage(&self) -> StageName {
        self.term.stage()
    }
    fn family(&self) -> Family {
        self.term.family()
    }
    fn about(&self) -> About {
        self.term.about()
    }
    fn parameters(&self, _: &Context<'_>) -> Vec<Parameter> {
        vec![Parameter::normal("share", "1", 1.0, 0.15, "share of what was computed").within(0.5, 1.5)]
    }
    fn foreseen(&self) -> bool {
        true
    }
    fn testable(&self, _: &Context<'_>) -> Result<(), String> {
        Ok(())
    }
    fn with(&self, values: &[f64], _: &Context<'_>) -> Box<dyn Stage> {
        self.asked.lock().unwrap().push(values[0]);
        self.term.stage_of(values[0])
    }
    fn says(&self, fitted: &[FittedParameter]) -> String {
        self.term.says(fitted)
    }
}

/// None of it lies 6.7 standard deviations off, and no start may: a share of a thousandth is another physics.
#[test]
fn a_share_that_is_foreseen_is_tried_where_it_may_be() {
    let world = World::new(2, 12, &[1.0]);
    let effect = Foreseen { term: world.terms[0].clone(), asked: Mutex::default() };
    let y = world.drawn(&[0], &[1.1], &mut ChaCha8Rng::seed_from_u64(2));
    let share = world.search(&y, |search, _| {
        let search = crate::selection::candidates::Search { library: vec![&effect], ..*search };
        let tried = search.add_each(&search.base().unwrap(), &[0], 1, "test").pop().unwrap();
        search.model(&[0]).values(&tried.fit.z)[0]
    });
    let column: Vec<f64> = world.terms[0].column.to_vec();
    // a mean of what the rows say and of what is known, by their weights
    let (told, known) = (column.iter().map(|c| c * c).sum::<f64>(), 0.15f64.powi(-2));
    let exact = (column.iter().zip(&y).map(|(c, y)| c * y).sum::<f64>() + known) / (told + known);
    approx::assert_relative_eq!(share, exact.clamp(0.5, 1.5), max_relative = super::FITTED);
    let asked = effect.asked.lock().unwrap();
    assert!(!asked.is_empty() && asked.iter().all(|share| (0.5..=1.5).contains(share)), "{asked:?}");
}
