//! From a decision to the words and numbers of `diagnosis.json`.
//!
//! Limits: decides nothing; what is stated here was decided in [`crate::selection::verdict`].

use crate::{
    adequacy::{
        directions::Direction,
        interference::heard::Heard,
        lack_of_fit::{Adequacy, Gate},
    },
    answer::{
        augmented::{AddedEffect, Augmented, NamedValue, Scales},
        diagnosis::*,
        fit_facts::{BeforeAfter, FitFacts, HeldOut, RecordingError},
        outcome::Outcome,
        traces::Traces,
    },
    effects::effect::FittedParameter,
    explain::{
        conflicts::{Conflict, conflicts},
        locate::map,
        next_experiment::{NextExperiment, next_experiment},
    },
    quality::preconditions::doubts,
    selection::{
        candidates::{Search, Tried},
        detectability::detectability,
        posterior::Selection,
        verdict::{Decision, Verdict},
    },
    stats::rmse_of,
    validation::{
        cross_validation::{AllRows, HeldOutFit, held_out, misfit_removed},
        permutation::shuffled,
        recovery::confusion::Bank,
    },
    whitening::noise_model::NoiseModel,
};
/// What to do where a tone or bursts are in the reading.
const LISTEN: &str = "record again at another sampling rate, with leads shielded and what switches nearby turned off: \
    interference moves to another frequency or goes, what the sensor makes stays";

/// All that was found.
pub struct Answer<'a> {
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
    /// bursts and a tone in what the model stood behind leaves
    pub heard: Heard,
    /// directions, whitened
    pub gate: &'a Gate,
    /// directions
    pub directions: &'a [Direction],
}

impl Answer<'_> {
    pub(crate) fn chosen(&self) -> &Tried {
        &self.selection.models[self.decision.model]
    }

    pub(crate) fn id(&self, effect: usize) -> String {
        self.search.library[effect].id().to_string()
    }

    /// Puts the answer together.
    pub fn outcome(&self, recording: RecordingFacts, not_testable: Vec<(String, String)>) -> Outcome {
        let base = self.selection.base();
        let chosen = self.chosen();
        let held_before = held_out(self.search, self.searched_noise, base, self.all);
        let held_after =
            if chosen.effects.is_empty() { None } else { Some(held_out(self.search, self.searched_noise, chosen, self.all)) };
        let after = held_after.as_ref().unwrap_or(&held_before);
        let conflicts = conflicts(self.search, base);
        let findings = self.findings(&held_before, after);
        let mismatch = if self.decision.verdict == Verdict::Agrees { Vec::new() } else { self.located(base) };
        let remains = if self.decision.verdict == Verdict::WrongForm { self.remains(chosen) } else { Vec::new() };
        let mut traces = self.traces(base, chosen, &held_before, after);
        let flexible = self.flexible(&traces.before, &held_before);
        let unit = self.search.problem.simulator.unit().to_owned();
        let fit = self.fit_facts(&traces, &held_before, after, unit);
        let concealed = self.concealed(&conflicts, &fit);
        let prediction_only = flexible.map(|flexible| {
            (traces.flexible, traces.held_out_flexible) = (flexible.prediction, flexible.held_out);
            flexible.facts
        });
        let diagnosis = Diagnosis {
            schema: SCHEMA,
            version: env!("CARGO_PKG_VERSION"),
            recording,
            base: BaseFacts {
                model: self.search.problem.simulator.name().into(),
                sensor: None,
                parameters: self.parameters(base, 0..base.fit.z.len()),
                parameters_after: self.parameters(chosen, 0..base.fit.z.len()),
            },
            noise: self.noise_facts(),
            verdict: self.decision.verdict,
            probability_agrees: self.selection.probability_none(),
            says: self.says(&findings),
            concealed,
            conflicts,
            mismatch,
            remains,
            findings,
            candidates: self.candidates(),
            unlisted: self.unlisted(),
            ambiguity: self.ambiguity(),
            fit,
            prediction_only,
            not_testable: not_testable.into_iter().map(|(effect, says)| NotTestable { effect, says }).collect(),
            smallest_visible: self.smallest_visible(),
            next_experiment: self.next(),
            bank: self.bank.map(|bank| self.bank_facts(bank)),
            adequacy: AdequacyFacts {
                before: Some(self.before),
                after: Some(self.after),
                burst: Some(self.heard.burst),
                tone: Some(self.heard.tone),
                heard: self.is_about_what_is_heard(),
                removed: self.decision.removed,
            },
            evidence_check: self.selection.check,
            notices: Vec::new(),
            concealed_column: None,
            recording_issues: doubts(self.all.problem),
            seconds: 0.0,
        };
        Outcome { diagnosis, traces, augmented: self.augmented(chosen) }
    }

    pub(crate) fn fitted(&self, tried: &Tried, range: std::ops::Range<usize>) -> Vec<FittedParameter> {
        let model = self.search.model(&tried.effects);
        range
            .map(|i| {
                let parameter = model.parameters[i].clone();
                let (z, sd) = (tried.fit.z[i], tried.fit.sd[i]);
                FittedParameter {
                    value: parameter.prior.at(z),
                    sd: parameter.prior.slope(z) * sd,
                    at_limit: tried.fit.at_limit[i],
                    parameter,
                }
            })
            .collect()
    }

    pub(crate) fn parameters(&self, tried: &Tried, range: std::ops::Range<usize>) -> Vec<ParameterFacts> {
        let facts = |f: FittedParameter| ParameterFacts {
            name: f.parameter.name.clone(),
            unit: f.parameter.unit.clone(),
            prior: [f.parameter.centre(), f.parameter.sd()],
            value: f.value,
            sd: f.sd,
            at_limit: f.at_limit,
        };
        self.fitted(tried, range).into_iter().map(facts).collect()
    }

    fn findings(&self, before: &HeldOutFit, after: &HeldOutFit) -> Vec<Finding> {
        let chosen = self.chosen();
        let model = self.search.model(&chosen.effects);
        let unit = self.search.problem.simulator.unit();
        let mut found: Vec<Finding> = Vec::new();
        let of =
            |(index, effect): (usize, &usize)| (self.search.library[*effect].id(), self.fitted(chosen, model.range_of(index)));
        let beside: Vec<_> = chosen.effects.iter().enumerate().map(of).collect();
        for (index, effect) in chosen.effects.iter().enumerate() {
            let d = detectability(self.search, chosen, index);
            let fitted = self.fitted(chosen, model.range_of(index));
            let sentence = self.search.library[*effect].told(&fitted, self.search.context, &beside);
            let rivals = self
                .decision
                .sets
                .get(index)
                .map(|s| s.iter().filter(|e| *e != effect).map(|e| self.id(*e)).collect())
                .unwrap_or_default();
            found.push(Finding {
                effect: self.id(*effect),
                probability: self.selection.effect_probability[*effect],
                says: if d < 10.0 { format!("most consistent with: {sentence} (detectability {d:.1})") } else { sentence },
                detectability: d,
                parameters: self.parameters(chosen, model.range_of(index)),
                held_out: BeforeAfterUnit {
                    rmse_before: self.held_out_without(chosen, index).unwrap_or(before.rmse),
                    rmse_after: after.rmse,
                    unit: unit.into(),
                },
                rivals,
            });
        }
        found
    }

    /// Held-out error with all findings but one; `None` where it was the only one.
    fn held_out_without(&self, chosen: &Tried, index: usize) -> Option<f64> {
        let others: Vec<usize> = chosen.effects.iter().enumerate().filter(|(i, _)| *i != index).map(|(_, e)| *e).collect();
        let tried = self.selection.with(&others).filter(|t| !t.effects.is_empty())?;
        Some(held_out(self.search, self.searched_noise, tried, self.all).rmse)
    }

    fn traces(&self, base: &Tried, chosen: &Tried, held_before: &HeldOutFit, held_after: &HeldOutFit) -> Traces {
        let problem = self.search.problem;
        Traces {
            before: self.respond(base),
            after: self.respond(chosen),
            noise_sd: (0..self.all.problem.response.len()).map(|row| self.noise.row_sd(row)).collect(),
            held_out_before: held_before.prediction.clone(),
            held_out_after: held_after.prediction.clone(),
            flexible: Vec::new(),
            held_out_flexible: Vec::new(),
            map_before: map(problem, &base.fit.residual),
            map_after: map(problem, &chosen.fit.residual),
            course: None,
        }
    }

    fn fit_facts(&self, traces: &Traces, before: &HeldOutFit, after: &HeldOutFit, unit: String) -> FitFacts {
        let floor = self.noise.floor();
        let parts = before.parts.iter().zip(&after.parts).map(|(b, a)| (b.0.clone(), b.1, a.1)).collect();
        let named = !self.chosen().effects.is_empty();
        FitFacts {
            in_sample: BeforeAfter { rmse_before: self.rmse(&traces.before), rmse_after: self.rmse(&traces.after) },
            held_out: HeldOut {
                how: before.how.clone(),
                rmse_before: before.rmse,
                rmse_after: after.rmse,
                misfit_removed: if named { misfit_removed(before.rmse, after.rmse, floor, self.noise.rows) } else { None },
                shuffled_control: if named { self.shuffled(self.chosen()) } else { None },
                parts,
                recordings: self.errors_by_recording(before, after),
            },
            noise_floor: floor,
            unit,
        }
    }

    /// Errors on rows left out, of each of several recordings.
    fn errors_by_recording(&self, before: &HeldOutFit, after: &HeldOutFit) -> Vec<RecordingError> {
        let problem = self.all.problem;
        let Some(joined) = problem.simulator.joined() else { return Vec::new() };
        let error = |k: usize| {
            let rows = joined.rows(k, problem.inputs);
            RecordingError {
                recording: k + 1,
                rmse_before: rmse_of(&before.prediction, problem.response, rows.clone()),
                rmse_after: rmse_of(&after.prediction, problem.response, rows.clone()),
                noise_floor: self.noise.floor_of(rows),
            }
        };
        (0..joined.count()).map(error).collect()
    }

    /// Calibration hid the effect: most of its raw size is gone from the residual, or parameters are pushed away.
    fn concealed(&self, conflicts: &[Conflict], fit: &FitFacts) -> bool {
        let clean = fit.in_sample.rmse_before < 2.0 * fit.noise_floor;
        let mismatch = self.decision.verdict != Verdict::Agrees;
        clean && (!conflicts.is_empty() || (mismatch && self.hidden_share() > 0.9))
    }

    /// Share of the raw effect that the base parameters absorb.
    fn hidden_share(&self) -> f64 {
        let chosen = self.chosen();
        if chosen.effects.is_empty() {
            return 0.0;
        }
        let model = self.search.model(&chosen.effects);
        let mut without = chosen.fit.z.clone();
        (0..chosen.effects.len()).for_each(|i| without[model.first_of(i)] = crate::selection::candidates::zero_size(&model, i));
        let Ok(there) = model.residual(&without, self.search.whitener) else { return 0.0 };
        let raw: f64 = there.iter().zip(&chosen.fit.residual).map(|(a, b)| (a - b).powi(2)).sum();
        let left = (self.selection.base().fit.chi2 - chosen.fit.chi2).max(0.0);
        if raw > 0.0 { 1.0 - (left / raw).sqrt().min(1.0) } else { 0.0 }
    }

    /// What an added term of equal freedom removes when its history is shuffled.
    pub(crate) fn shuffled(&self, tried: &Tried) -> Option<f64> {
        let problem = self.search.problem;
        shuffled(&self.selection.base().fit, &tried.fit, &problem.runs(), &problem.inputs.run)
    }

    /// Whether a tone or bursts are what there is to say, and nothing that is missing.
    fn is_about_what_is_heard(&self) -> bool {
        let nothing_missing = self.decision.verdict == Verdict::Unexplained && self.decision.outside.is_none();
        nothing_missing && self.heard.is_the_matter(&self.before)
    }

    fn next(&self) -> NextExperiment {
        if self.is_about_what_is_heard() {
            return NextExperiment { says: LISTEN.into(), ..NextExperiment::default() };
        }
        let best = self.selection.models.iter().find(|m| !m.effects.is_empty());
        let Some(best) = best.filter(|_| self.decision.verdict != Verdict::Agrees) else {
            return NextExperiment {
                says:
                    "nothing is missing that this recording could show; widen the range of load, temperature and time to see more"
                        .into(),
                ..NextExperiment::default()
            };
        };
        let rivals: Vec<&Tried> = self
            .selection
            .models
            .iter()
            .filter(|m| m.key() != best.key() && m.effects.len() <= best.effects.len())
            .take(3)
            .collect();
        next_experiment(self.search, best, &rivals)
    }

    fn augmented(&self, chosen: &Tried) -> Augmented {
        let named = |f: FittedParameter| NamedValue { name: f.parameter.name, unit: f.parameter.unit, value: f.value, sd: f.sd };
        let model = self.search.model(&chosen.effects);
        let effect = |(index, effect): (usize, &usize)| AddedEffect {
            id: self.id(*effect),
            parameters: self.fitted(chosen, model.range_of(index)).into_iter().map(named).collect(),
        };
        let context = self.search.context;
        let base = self.fitted(chosen, 0..model.base_count());
        // of several recordings, the model of the first one's sensor
        let own: Vec<usize> =
            self.search.problem.simulator.joined().map_or_else(|| (0..base.len()).collect(), |joined| joined.places(0).to_vec());
        Augmented {
            parameters: own.into_iter().map(|i| named(base[i].clone())).collect(),
            effects: chosen.effects.iter().enumerate().map(effect).collect(),
            scales: Scales {
                longest_run_s: context.longest_run_s,
                shortest_step_s: context.shortest_step_s.unwrap_or(0.0),
                duration_s: context.duration_s,
                response_span: context.response_span,
                noise_sd: context.noise_sd,
                runs: Some(context.runs),
            },
        }
    }

    fn noise_facts(&self) -> NoiseFacts {
        let n = self.noise;
        let of_recording = |(k, r): (usize, &crate::whitening::noise_model::RecordingNoise)| RecordingNoiseFacts {
            recording: k + 1,
            says: r.says.clone(),
            white_sd: r.response.white_sd,
            ar_sd: r.response.ar_sd,
            ar_correlation: r.response.ar_correlation,
        };
        NoiseFacts {
            says: n.says.clone(),
            white_sd: n.response.white_sd,
            ar_sd: n.response.ar_sd,
            ar_correlation: n.response.ar_correlation,
            load_sd: n.inputs.load * self.search.problem.simulator.full_load().unwrap_or(0.0),
            temperature_sd: n.inputs.temperature,
            measured: n.measured,
            recordings: n.recordings.iter().enumerate().map(of_recording).collect(),
        }
    }

    fn says(&self, findings: &[Finding]) -> String {
        let names = findings.iter().map(|f| f.effect.as_str()).collect::<Vec<_>>().join(" and ");
        let sets = self.ambiguity().iter().map(|s| s.join(" or ")).collect::<Vec<_>>().join("; and one of ");
        let line = if self.after.line_p_value < 1e-6 {
            format!("; run {} holds a line at {:.4} cycles a row", self.after.line_at.0 + 1, self.after.line_at.1)
        } else {
            String::new()
        };
        match self.decision.verdict {
            Verdict::Agrees => "no mismatch found between recording and calibrated model".into(),
            Verdict::Explained => format!("missing from the model: {names}"),
            Verdict::Ambiguous => format!("missing from the model: one of {sets}; this recording cannot tell them apart"),
            Verdict::WrongForm => format!(
                "missing from the model: {names}; the family is clear, but its equation leaves {} of the misfit",
                crate::text::share_left(self.decision.removed)
            ),
            Verdict::Unexplained => match &self.decision.outside {
                Some(cause) => format!("something real is missing that is not in the library: {}", self.says_of(cause)),
                None if self.is_about_what_is_heard() => {
                    format!("something is in the reading that is not in the library: {}", self.heard_says().unwrap_or_default())
                }
                None if !self.before.fires() => "something real is missing that nothing in the library explains".into(),
                None => format!(
                    "something real is missing that nothing in the library explains (the likeliest effect removes {:.0} % of the misfit){line}{}",
                    100.0 * self.decision.removed,
                    self.nearest_outside()
                ),
            },
            Verdict::Undecided if self.search.stop.load(std::sync::atomic::Ordering::Relaxed) => {
                "stopped before the search was finished: causes are not decided".into()
            }
            Verdict::Undecided => "there is a mismatch, but its cause cannot be decided from this recording".into(),
        }
    }
}
