//! A ceiling that the reading has and the model has not, put into an answer: rows on it were left out of every fit, so that no fit could name it.
//!
//! Limits: decides nothing; [`crate::validation::ceiling`] does.

use crate::{
    answer::{
        augmented::AddedEffect,
        diagnosis::Finding,
        fit_facts::BeforeAfterUnit,
        numbers::{facts, named},
        outcome::Outcome,
    },
    discovery::marginals::WordProbabilities,
    effects::{
        collection::Library,
        effect::{Effect, FittedParameter},
        saturation::Saturation,
    },
    selection::verdict::Verdict,
    text::rounded,
    validation::ceiling::Ceiling,
};

impl Outcome {
    /// The effects of the model with a ceiling `knee` spans above the zero, which loses all of the slope: `saturation` stands where the chain has it.
    pub fn effects_with_ceiling(&self, knee: f64) -> Vec<AddedEffect> {
        self.effects_and(&Saturation::hard([knee, 0.0], 0.0))
    }

    /// The answer with a ceiling that was found in rows which took no part in the fits; as it is where it names a saturation already.
    pub fn with_ceiling(&mut self, ceiling: &Ceiling) {
        let id = Saturation.id().0;
        let told = self.diagnosis.findings.iter().chain(&self.diagnosis.carried).any(|finding| finding.effect == id);
        if told {
            return;
        }
        let numbers = Saturation::hard(ceiling.knee, ceiling.lost_sd);
        self.augmented.effects = self.effects_and(&numbers);
        let answer = &mut self.diagnosis;
        let stops = rounded(ceiling.at, &answer.fit.unit);
        let noise = answer.noise.white_sd.hypot(answer.noise.ar_sd);
        answer.findings.push(Finding {
            effect: id.into(),
            probability: ceiling.probability(),
            probability_among_models: ceiling.probability(),
            says: format!(
                "the reading has a ceiling: it stops at {stops}, in {} rows, and the model goes beyond it in {} of them",
                ceiling.rows, ceiling.beyond
            ),
            // of readings that are as far off as the model is elsewhere: its rest is no noise
            detectability: Some(ceiling.rmse[0] / noise.max(ceiling.elsewhere) * (ceiling.rows as f64).sqrt()),
            parameters: numbers.into_iter().map(facts).collect(),
            held_out: BeforeAfterUnit {
                rmse_before: Some(ceiling.rmse[0]),
                rmse_after: Some(ceiling.rmse[1]),
                unit: answer.fit.unit.clone(),
            },
            rivals: Vec::new(),
            words: WordProbabilities::of_effects(&[(Some(Saturation::words()), 1.0)]),
        });
        answer.probability_agrees *= 1.0 - ceiling.probability();
        if answer.verdict == Verdict::Agrees {
            answer.verdict = Verdict::Explained;
            answer.says = format!("missing from the model: {id}; the reading stops at {stops}");
            answer.next_experiment.says =
                format!("record again with a range that goes beyond {stops}: what the instrument does there is not known");
        } else {
            answer.says.push_str(&format!("; beside it the reading has a ceiling ({id}): it stops at {stops}"));
        }
    }

    fn effects_and(&self, numbers: &[FittedParameter]) -> Vec<AddedEffect> {
        let library = Library::default();
        let place = |id: &str| library.ids().iter().position(|known| *known == id);
        let own = place(Saturation.id().0);
        let added = AddedEffect {
            id: Saturation.id().0.into(),
            parameters: numbers.iter().cloned().map(named).collect(),
            mechanism: None,
            carried: false,
        };
        let mut effects = self.augmented.effects.clone();
        let before = effects.iter().position(|effect| place(&effect.id) > own).unwrap_or(effects.len());
        effects.insert(before, added);
        effects
    }
}
