//! Where the search for a model begins: with an effect's numbers as they are foreseen, and as a smaller model has found them.

use crate::{
    Context, Effect, FittedParameter, Problem,
    adequacy::lack_of_fit::LackOfFitTests,
    calibration::{InputError, Noise, Whitener},
    common::Plate,
    selection::candidates::{Search, Tried},
};
use rand::SeedableRng;
use rand_chacha::ChaCha8Rng;
use rand_distr::{Distribution, StandardNormal};
use std::{f64::consts::TAU, sync::atomic::AtomicBool};
use truegap_core::{Drive, EffectId, Inputs, Parameter, Readout, Simulator, Stage};

pub(crate) const ROWS: usize = 300;

/// Waves that act, pF and rows, and periods that are foreseen: the second one is far off.
pub(crate) const ACTING: [(f64, f64); 2] = [(3.0, 60.0), (4.0, 41.0)];
pub(crate) const FORESEEN: [f64; 2] = [60.0, 23.0];

/// A wave of the reading: its size and its period in rows. A straight step from a period that is far off promises next to nothing.
struct Wave {
    id: EffectId,
    /// period that is foreseen, rows
    foreseen: f64,
}

struct Waving(f64, f64);

impl Stage for Waving {
    fn readout(&self, _: &Drive<'_>, _: &Readout, value: &mut [f64]) {
        value.iter_mut().enumerate().for_each(|(row, v)| *v += self.0 * (TAU * row as f64 / self.1).cos());
    }
}

impl Effect for Wave {
    crate::tests::of_the_reading!();
    fn parameters(&self, _: &Context<'_>) -> Vec<Parameter> {
        let period = Parameter::normal("period", "rows", self.foreseen, 20.0, "its period").within(10.0, 200.0);
        vec![Parameter::normal("size", "pF", 0.0, 3.0, "size of the wave"), period]
    }
    fn starts(&self, _: &Context<'_>) -> Vec<Vec<f64>> {
        vec![vec![self.foreseen]]
    }
    fn with(&self, values: &[f64], _: &Context<'_>) -> Box<dyn Stage> {
        Box::new(Waving(values[0], values[1]))
    }
    fn says(&self, fitted: &[FittedParameter]) -> String {
        format!("a wave of {:.3} pF", fitted[0].value)
    }
}

/// Searches a reading of a plate under a steady load that has waves of these sizes (pF) and periods (rows), by effects that foresee others.
pub(crate) fn searched<T>(waves: &[(f64, f64)], foreseen: &[f64], then: impl FnOnce(&Search<'_>, &LackOfFitTests) -> T) -> T {
    let plate = Plate::new(Some(false));
    let inputs = Inputs {
        run: vec![1; ROWS],
        time_s: Some((0..ROWS).map(|row| row as f64).collect()),
        force_n: Some((0..ROWS).map(|row| 1.0 + (row / 50) as f64).collect()),
        temperature_c: Some(vec![25.0; ROWS]),
        ..Inputs::default()
    };
    let acting: Vec<Waving> = waves.iter().map(|(size, period)| Waving(*size, *period)).collect();
    let stages: Vec<&dyn Stage> = acting.iter().map(|wave| wave as _).collect();
    let mut response = plate.respond(&plate.centre(), &inputs, &stages).unwrap();
    let random = &mut ChaCha8Rng::seed_from_u64(5);
    response.iter_mut().for_each(|value| *value += <StandardNormal as Distribution<f64>>::sample(&StandardNormal, random));
    let problem = Problem { inputs: &inputs, response: &response, simulator: &plate };
    let context = Context::new(&inputs, &plate, problem.span(), 1.0);
    let whitener = |louder: f64| {
        let noise = Noise { white_sd: louder, ar_sd: 0.0, ar_correlation: 0.0 };
        Whitener::new(&noise, &InputError::white(vec![0.0; ROWS]), None, &inputs.runs(), None)
    };
    let (measured, loose) = (whitener(1.0), whitener(30.0));
    let effects: Vec<Wave> =
        foreseen.iter().zip(["wave_a", "wave_b"]).map(|(foreseen, id)| Wave { id: EffectId(id), foreseen: *foreseen }).collect();
    let search = Search {
        problem: &problem,
        context: &context,
        library: effects.iter().map(|wave| wave as _).collect(),
        whitener: &measured,
        loose: &loose,
        scout: None,
        progress: &|_| (),
        stop: &AtomicBool::new(false),
    };
    then(&search, &LackOfFitTests::new(&[], &measured, inputs.runs(), 0.0))
}

/// Coordinates of the second wave near where it acts, as a fit of it may have found them.
pub(crate) fn second_as_found(search: &Search<'_>) -> Vec<f64> {
    let model = search.model(&[1]);
    [4.2, 40.5].iter().zip(&model.parameters[model.range_of(0)]).map(|(v, p)| p.prior.z(*v)).collect()
}

/// The first wave, and the second beside it from where it is foreseen.
pub(crate) fn as_foreseen(search: &Search<'_>) -> [Tried; 2] {
    let one = search.polished(&search.add_each(&search.base().unwrap(), &[0], 1, "test").pop().unwrap()).unwrap();
    let both = search.polished(&search.add_each(&one, &[1], 1, "test").pop().unwrap()).unwrap();
    [one, both]
}

/// From where it is foreseen, a wave of another period is not found beside another one. From the numbers that a smaller model has found it is, and nothing but noise is left.
#[test]
fn an_effect_is_tried_with_the_numbers_that_a_smaller_model_found() {
    searched(&ACTING, &FORESEEN, |search, _| {
        let [one, foreseen] = as_foreseen(search);
        let numbers = second_as_found(search);
        let left = |found: Option<Tried>| search.polished(&found.unwrap()).unwrap().fit.chi2 / ROWS as f64;
        let found = [(1, vec![numbers.clone()])].into();
        let as_found = left(search.add_each_as_found(&one, &[1], 1, "test", &found).pop());
        assert!(foreseen.fit.chi2 / ROWS as f64 > 4.0 && as_found < 1.2, "{} {as_found}", foreseen.fit.chi2);
        // asked for by itself: where it leaves less than what is known already, and not where that leaves less
        let otherwise = |squares_a_row: f64| search.otherwise(&one, 1, &numbers, 0.5 * squares_a_row * ROWS as f64);
        assert!(left(otherwise(4.0)) < 1.2);
        assert!(otherwise(0.5).is_none());
    });
}
