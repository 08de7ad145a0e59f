//! All that the stages before this one found, as an answer is put together from it.
//!
//! Limits: plain data.

use crate::{
    adequacy::{
        directions::Direction,
        interference::every_row::Interference,
        lack_of_fit::{Adequacy, LackOfFitTests},
    },
    answer::permuted_searches::PermutedSearches,
    discovery::discover::Discovery,
    explain::hidden_input::slow_input::{Hidden, SlowInput},
    selection::{
        candidates::{Search, Tried},
        posterior::Selection,
        verdict::{Decision, Verdict},
    },
    validation::{all_rows::AllRows, recovery::confusion::Bank, selected_again::ChosenWithout, veto::Unseen},
    whitening::noise_model::NoiseModel,
};

/// All that was found.
pub struct Found<'a> {
    /// problem, context, library, noise filter
    pub search: &'a Search<'a>,
    /// noise of every row
    pub noise: &'a NoiseModel,
    /// noise of the rows that are searched
    pub searched_noise: &'a NoiseModel,
    /// every row
    pub all: AllRows<'a>,
    /// models and probabilities
    pub selection: &'a Selection,
    /// verdict
    pub decision: &'a Decision,
    /// recovery bank, where it was run
    pub bank: Option<&'a Bank>,
    /// adequacy of the base model
    pub before: Adequacy,
    /// adequacy of the likeliest model
    pub after: Adequacy,
    /// the base model calibrated by itself; that of `selection` where it is as near to the recording
    pub(crate) base_alone: &'a Tried,
    /// effects that are not claimed because the others predict rows left out better without them, for a reader
    pub(crate) left_out: Vec<String>,
    /// bursts and a tone in what the model stood behind leaves
    pub interference: Interference,
    /// directions, whitened
    pub lack_of_fit: &'a LackOfFitTests,
    /// directions
    pub directions: &'a [Direction],
    /// predictions of rows left out
    pub(crate) unseen: Unseen,
    /// why no physics is named whatever the models say; absent where the models decide
    pub reserved: Option<Reserved>,
    /// the slow course in place of a column that was hidden on purpose, and that column
    pub slow: Option<(&'a SlowInput, &'a Hidden)>,
    /// the column whose quick motion the reading does not show, where a mean to both sides foretells as well as any cause
    pub smoothed: Option<String>,
    /// mechanisms from outside the library, whether they are named or not
    pub mechanisms: &'a [Discovery],
    /// whether they only put into words what the library has explained
    pub in_other_words: bool,
    /// log odds of their model against the library and all unmodelled causes together
    pub log_odds_of_mechanisms: f64,
    /// what is chosen without each part of the recording, where that was asked for
    pub(crate) selected_again: Option<Vec<ChosenWithout>>,
    /// the whole search on permuted histories, where that was asked for
    pub(crate) permuted_searches: Option<PermutedSearches>,
    /// the model stood behind calibrated by least squares, where it predicts rows left out better so
    pub(crate) by_squares: Option<Tried>,
    /// models with a rival in the place of an effect that is named, calibrated as that one is
    pub(crate) rivals: Vec<Rival>,
    /// standard deviations of the coordinates of the models that numbers are told of, with what is not named counted in
    pub(crate) widened: Vec<(&'a Tried, Vec<f64>)>,
    /// whether the search was stopped before its end
    pub interrupted: bool,
}

/// A model with a rival in the place of a named effect.
pub(crate) struct Rival {
    /// the named effect
    pub instead_of: usize,
    /// the effect in its place
    pub effect: usize,
    /// the model that holds it
    pub tried: Tried,
}

/// Why no physics is named whatever the models say.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Reserved {
    /// the reason, for a reader
    pub says: String,
    /// whether the recording may not be trusted
    pub withheld: bool,
    /// whether an input is missing that was hidden on purpose
    pub input_missing: bool,
}

impl Found<'_> {
    /// A model as its numbers are told: the base model calibrated by itself in place of the base model, the model stood behind as it predicts rows left out.
    pub(crate) fn told<'t>(&'t self, tried: &'t Tried) -> &'t Tried {
        match &self.by_squares {
            _ if tried.effects.is_empty() => self.base_alone,
            Some(squares) if squares.effects == tried.effects => squares,
            _ => tried,
        }
    }

    /// The model stood behind.
    pub fn chosen(&self) -> &Tried {
        &self.selection.models[self.decision.model]
    }

    /// Whether the model stood behind only carries an effect, without a claim to its name.
    pub fn carries(&self, effect: usize) -> bool {
        self.decision.carried.contains(&effect)
    }

    /// Standard deviations of the coordinates of a model, with what is not named counted in where that was computed.
    pub fn sd<'t>(&'t self, tried: &'t Tried) -> &'t [f64] {
        let own = self.widened.iter().find(|(known, _)| known.effects == tried.effects);
        own.map_or(&tried.fit.sd, |(_, sd)| sd)
    }

    /// Indices of the effects that the answer was chosen from: other words for what is explained were not among them.
    pub fn weighed(&self) -> std::ops::Range<usize> {
        0..self.search.library.len() - if self.in_other_words { self.mechanisms.len() } else { 0 }
    }

    /// Name of an effect of the library searched.
    pub fn id(&self, effect: usize) -> String {
        self.search.library[effect].id().to_string()
    }

    /// Whether something is left beside what is named, to be said where.
    pub fn leaves_something(&self) -> bool {
        match self.decision.verdict {
            Verdict::WrongForm => true,
            Verdict::Explained => self.after.fires(),
            _ => false,
        }
    }

    /// Whether a tone or bursts are what there is to say, and nothing that is missing.
    pub fn is_about_interference(&self) -> bool {
        let nothing_missing = self.decision.verdict == Verdict::Unexplained && self.decision.unmodelled.is_none();
        self.reserved.is_none() && nothing_missing && self.interference.is_the_matter(&self.before)
    }
}
