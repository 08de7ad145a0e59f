//! What is made of a recording before anything is fitted: block averages, whitened noise, directions of the tests.
//!
//! Limits: one noise model at a time.

use crate::{
    adequacy::{
        directions::{Direction, directions},
        lack_of_fit::LackOfFitTests,
    },
    answer::NotTestable,
    data::{context::Context, error::DiagnoseError, problem::Problem},
    effects::effect::Effect,
    fit::model::Model,
    fit::tuning::LOOSE,
    noise::{
        block_average::{BlockAverages, block_averages},
        off_at_rest::at_work,
        scout::Scout,
        several::with_wild_rows,
    },
    pipeline::{asked::Asked, options::Options},
    selection::{
        candidates::{Progress, Search, Tried},
        examine::Examined,
        tuning::LOUD_REST,
        verdict::Verdict,
    },
    text::spoken,
    validation::{
        all_rows::AllRows,
        cross_validation::{HeldOutFit, held_out},
    },
    whitening::{noise_model::NoiseModel, whitener::Whitener},
};
use std::sync::atomic::AtomicBool;
use truegap_core::Inputs;

/// Rows that are searched; longer recordings are searched on means of their quiet rows (see [`crate::noise::block_average`]) and predicted row by row.
const SEARCHED_ROWS: usize = 2500;

/// A longer recording is searched on more rows, so that its features stay apart, but never on more than these.
const MOST_SEARCHED_ROWS: usize = 8000;

/// Rows of a recording for each row that is searched, between the two numbers above.
const ROWS_FOR_ONE: usize = 50;

/// Squares of the noise, over all means, by which they may differ from what a model makes of them: what a number of one standard deviation is.
const FELT_BY_MEANS: f64 = 1.0;

/// A recording made ready under one noise model.
pub(crate) struct Prepared<'a> {
    /// every row
    pub problem: &'a Problem<'a>,
    /// noise of every row
    pub noise: NoiseModel,
    /// facts for the effects
    pub context: Context<'a>,
    /// effects that the recording could show
    pub testable: Vec<&'a dyn Effect>,
    /// effects that it could not show or that may not be tried
    pub not_testable: Vec<NotTestable>,
    /// fewer rows with the same information; absent where every row is searched
    pub averages: Option<BlockAverages>,
    /// noise of the rows that are searched
    pub searched_noise: NoiseModel,
    /// filter of that noise
    pub whitener: Whitener,
    /// filter of the same noise, many times larger
    pub loose: Whitener,
    /// few rows, on which a calibration of the base model begins; absent where every row is searched
    pub scout: Option<Scout>,
    /// directions along which a mismatch may lie
    pub directions: Vec<Direction>,
    /// the tests along them
    pub lack_of_fit: LackOfFitTests,
    /// what models foretell of rows left out, as far as that was asked
    pub asked: Asked,
}

impl<'a> Prepared<'a> {
    /// Makes a recording ready under `noise`.
    ///
    /// # Errors
    /// Those of the simulator at the centre of its prior.
    pub fn new(problem: &'a Problem<'a>, noise: NoiseModel, options: &'a Options) -> Result<Self, DiagnoseError> {
        let mut context = problem.context(problem.span(), noise.floor());
        let (testable, not_testable) = part(&context, options);
        // richer laws wait for rows left out that bear them out
        let has = |effect: &dyn Effect, name: &str| effect.parameters(&context).iter().any(|number| number.name == name);
        let more = testable.iter().flat_map(|effect| effect.held_at_first().into_iter().map(|name| (*effect, name)));
        let held = more.filter(|(effect, name)| has(*effect, name)).map(|(effect, name)| (effect.id(), name)).collect();
        context.held = held;
        let averages = block_averages(problem, &noise, searched_rows(problem.response.len()))?;
        let scout = Scout::of(problem, &noise)?;
        let inputs = averages.as_ref().map_or(problem.inputs, |t| &t.inputs);
        let runs = inputs.runs();
        let searched_noise = averages.as_ref().map_or_else(|| noise.clone(), |t| t.noise(&noise));
        let whitener = searched_noise.whitener(&runs, None);
        let loose = searched_noise.scaled(LOOSE).whitener(&runs, None);
        let directions = directions(inputs, problem.simulator);
        let response = averages.as_ref().map_or(problem.response, |t| t.response.as_slice());
        let searched = Problem { inputs, response, simulator: problem.simulator };
        let lack_of_fit = LackOfFitTests::of(&searched, &searched_noise, &whitener, &directions, None);
        Ok(Self {
            problem,
            context,
            testable,
            not_testable,
            averages,
            scout,
            searched_noise,
            whitener,
            loose,
            directions,
            lack_of_fit,
            noise,
            asked: Asked::default(),
        })
    }

    /// The rows that are searched.
    pub fn searched(&self) -> Problem<'_> {
        let (inputs, response) =
            self.averages.as_ref().map_or((self.problem.inputs, self.problem.response), |t| (&t.inputs, t.response.as_slice()));
        Problem { inputs, response, simulator: self.problem.simulator }
    }

    /// Every row, and which of them each searched row begins with.
    pub fn all_rows(&self) -> AllRows<'_> {
        AllRows { problem: self.problem, first: self.averages.as_ref().map(|t| t.first.as_slice()), untold: &self.noise.untold }
    }

    /// Whether rows that are searched are means within which inputs move.
    pub fn inputs_move_within_means(&self) -> bool {
        self.averages.as_ref().is_some_and(|averages| averages.moved)
    }

    /// Makes the means by what a model of the library responds to rows and to means, where that differs by more than [`FELT_BY_MEANS`] from what they were made by; whether it did. A model that has no
    /// answer for a row, as where the load of one row closes the gap and that of no mean does, makes none.
    pub fn averaged_by(&mut self, model: &Tried) -> bool {
        let Some(averages) = &mut self.averages else { return false };
        let effects: Vec<_> = model.effects.iter().map(|e| self.testable[*e]).collect();
        let responds = |inputs: &Inputs| {
            let problem = Problem { inputs, ..*self.problem };
            Model::new(&problem, &self.context, effects.clone()).respond(&model.fit.z)
        };
        let Ok(response) = averages.response_by(self.problem.inputs, responds) else { return false };
        let mut change: Vec<f64> = response.iter().zip(&averages.response).map(|(new, old)| new - old).collect();
        self.whitener.apply(&mut change);
        if change.iter().map(|v| v * v).sum::<f64>() <= FELT_BY_MEANS {
            return false;
        }
        averages.response = response;
        let searched = Problem { inputs: &averages.inputs, response: &averages.response, ..*self.problem };
        self.lack_of_fit = LackOfFitTests::of(&searched, &self.searched_noise, &self.whitener, &self.directions, None);
        self.asked = Asked::default();
        true
    }

    /// What a model foretells of rows left out, calibrated under the noise.
    pub fn foretold(&self, search: &Search<'_>, tried: &Tried) -> HeldOutFit {
        self.answered(search, tried, false, || held_out(search, &self.searched_noise, tried, self.all_rows()))
    }

    /// What a model foretells of rows left out, by least squares or under the noise: asked once, where no mechanism composed of words is in it.
    pub fn answered(&self, search: &Search<'_>, tried: &Tried, squares: bool, ask: impl FnOnce() -> HeldOutFit) -> HeldOutFit {
        let of_library = tried.effects.iter().all(|effect| *effect < self.testable.len());
        if of_library { self.asked.answer(search, tried, squares, ask) } else { ask() }
    }

    /// Effects for a reader; what is behind those of the library was composed of words.
    pub fn names(&self, effects: &[usize]) -> String {
        let name =
            |e: &usize| self.testable.get(*e).map_or_else(|| "a composed mechanism".to_owned(), |effect| spoken(effect.id().0));
        effects.iter().map(name).collect::<Vec<_>>().join(" and ")
    }

    /// Whether the noise was measured apart from the mismatch, with a clock that says how it lasts.
    pub fn noise_is_known(&self) -> bool {
        self.noise.measured && self.problem.inputs.time_s.is_some()
    }

    /// The search through models of these rows.
    pub fn search<'s>(
        &'s self,
        searched: &'s Problem<'s>,
        progress: &'s (dyn Fn(Progress) + Sync),
        stop: &'s AtomicBool,
    ) -> Search<'s> {
        Search {
            problem: searched,
            context: &self.context,
            library: self.testable.clone(),
            whitener: &self.whitener,
            loose: &self.loose,
            scout: self.scout.as_ref(),
            progress,
            stop,
        }
    }

    /// The noise with rows that are wild beside the model that leaves least, where the base model hides them.
    ///
    /// # Errors
    /// Those of the simulator.
    pub fn with_wild_rows(&self, examined: &Examined) -> Result<Option<NoiseModel>, DiagnoseError> {
        let Some(best) = examined.selection.least() else { return Ok(None) };
        Ok(with_wild_rows(self.problem, &self.misfit(best)?, &self.noise))
    }

    /// The noise at work, where it was measured while the instrument was off and nothing could be named beside so little of it.
    ///
    /// # Errors
    /// Those of the simulator.
    pub fn at_work(&self, examined: &Examined) -> Result<Option<NoiseModel>, DiagnoseError> {
        let loud = examined.decision.verdict == Verdict::Unexplained && examined.after.left_over_noise > LOUD_REST;
        let Some(best) = examined.selection.least().filter(|_| loud) else { return Ok(None) };
        Ok(at_work(self.problem, &self.misfit(best)?, &self.noise))
    }

    /// What a model of the library leaves of every row.
    pub(crate) fn misfit(&self, tried: &Tried) -> Result<Vec<f64>, DiagnoseError> {
        Ok(self.model(tried).misfit(&tried.fit.z)?)
    }

    /// A model of the library over every row.
    pub fn model(&self, tried: &Tried) -> Model<'_> {
        self.model_of(self.problem, tried)
    }

    /// A model of the library over the rows of `problem`.
    pub fn model_of<'m>(&'m self, problem: &'m Problem<'m>, tried: &Tried) -> Model<'m> {
        Model::new(problem, &self.context, tried.effects.iter().map(|e| self.testable[*e]).collect())
    }
}

fn searched_rows(rows: usize) -> usize {
    (rows / ROWS_FOR_ONE).clamp(SEARCHED_ROWS, MOST_SEARCHED_ROWS)
}

/// Effects that the recording could show, and those that it could not, with the reason.
fn part<'a>(context: &Context<'_>, options: &'a Options) -> (Vec<&'a dyn Effect>, Vec<NotTestable>) {
    let (mut testable, mut not) = (Vec::new(), Vec::new());
    for effect in options.library.iter() {
        match allowed(effect, context, options) {
            Ok(()) => testable.push(effect),
            Err(says) => not.push(NotTestable { effect: effect.id().to_string(), says }),
        }
    }
    (testable, not)
}

/// Whether an effect may be tried, or why not.
fn allowed(effect: &dyn Effect, context: &Context<'_>, options: &Options) -> Result<(), String> {
    if !options.effects.is_empty() && !options.effects.iter().any(|id| id == effect.id().0) {
        return Err("left out on request".into());
    }
    match options.restricted.filter(|restriction| !(restriction.only)(effect)) {
        Some(restriction) => Err(restriction.why.into()),
        None => effect.testable(context),
    }
}
