//! The sentences that say what was found, as strong as the evidence and no stronger.
//!
//! Limits: below a detectability of [`SURE`] nothing is called missing, only "most consistent with".

use super::subject::error_scale;
use super::text::{capitalised, detectability, listed, measured, percent, spoken, spoken_list};
use truegap_diagnose::answer::{Diagnosis, DiscoveredFacts, Finding, ParameterFacts, SelectedAgain, Verdict};

/// Detectability from which an effect is called missing without a reserve.
pub const SURE: f64 = 10.0;
/// Sets larger than this are not spelled out in a sentence.
const MANY: usize = 5;

/// Heading of parameters that differ between parts of a recording.
pub(super) const BETWEEN_PARTS: &str = "Differs between parts of the recording";

/// What the model carries beside the findings.
pub(super) const CARRIED: &str =
    "smaller parts of the misfit, which are not claimed as causes: an equation that is slightly off leaves as much";

/// The headline where mechanisms of words are named; `None` where none is.
fn beyond_the_library(diagnosis: &Diagnosis) -> Option<String> {
    let named: Vec<&DiscoveredFacts> = diagnosis.discovered.iter().filter(|m| m.named).collect();
    let clauses: Vec<String> = named.iter().map(|m| m.clause.clone()).collect();
    let of_library = diagnosis.findings.iter().filter(|f| !f.effect.starts_with("discovered"));
    let beside = spoken_list(of_library.map(|f| &f.effect), "and");
    let beside = if beside.is_empty() { String::new() } else { format!(" beside {beside}") };
    let reserve = match diagnosis.verdict {
        Verdict::Explained => "",
        Verdict::WrongForm => "; its law is not adequate, misfit remains",
        _ => "; not all of its words are sure",
    };
    let says = || format!("Missing from the model, and in no library{beside}: {}{reserve}.", listed(&clauses, "and"));
    (!named.is_empty()).then(says)
}

/// A tone in the reading beside an answer that nothing is missing, as the end of a sentence; empty where there is none.
fn faint_tone(diagnosis: &Diagnosis) -> String {
    let tone = diagnosis.adequacy.tone.filter(|tone| tone.is_significant());
    tone.map_or_else(String::new, |tone| format!("; the reading holds {}", tone.says()))
}

/// The verdict in one plain sentence.
pub fn headline(diagnosis: &Diagnosis) -> String {
    let names = || all_of(diagnosis.findings.iter());
    let sure = diagnosis.findings.iter().all(|f| f.detectability.is_some_and(|d| d >= SURE));
    let no_finding = diagnosis.findings.is_empty();
    if diagnosis.notices.iter().any(|n| n.withholds) {
        return "Something is wrong with this recording, so no physics is named.".into();
    }
    if let Some(says) = beyond_the_library(diagnosis) {
        return says;
    }
    match diagnosis.verdict {
        Verdict::Agrees if diagnosis.adequacy.before.is_some_and(|before| before.fires()) => {
            let noise = if diagnosis.noise.measured { "" } else { ", and the noise was not measured" };
            format!(
                "Recording and model agree: no cause that was tried is borne out by rows left out{noise}{}.",
                faint_tone(diagnosis)
            )
        }
        Verdict::Agrees => {
            let (tone, noise) = (faint_tone(diagnosis), error(diagnosis, diagnosis.fit.noise_floor));
            let beside = if tone.is_empty() { "" } else { "else " };
            format!("Recording and model agree: nothing {beside}stands out of the noise of {noise}{tone}.")
        }
        Verdict::Explained if no_finding => diagnosis.says.clone(),
        Verdict::Explained if sure => format!("Missing from the model: {}.", names()),
        Verdict::Explained => format!("The recording is most consistent with {} missing from the model.", names()),
        Verdict::Ambiguous => ambiguous(diagnosis),
        Verdict::WrongForm if no_finding => {
            "The kind of physics is clear, the equation tried for it is not adequate: misfit remains.".into()
        }
        Verdict::WrongForm if !diagnosis.carried.is_empty() && diagnosis.adequacy.after.is_some_and(|after| !after.fires()) => {
            format!(
                "Missing from the model is something like {}, but its equation alone is not adequate: other terms, which are not claimed as causes, follow what it leaves.",
                names()
            )
        }
        Verdict::WrongForm => {
            format!("Missing from the model is something like {}, but its equation is not adequate: misfit remains.", names())
        }
        Verdict::Unexplained if diagnosis.adequacy.interference => {
            "Something is in the reading that neither the model nor anything in the library makes.".into()
        }
        Verdict::Unexplained => "Something real is missing from the model that nothing in the library explains.".into(),
        Verdict::Undecided if diagnosis.is_open() => {
            "Something may be missing from the model; this recording is not enough to decide it.".into()
        }
        Verdict::Undecided => "Recording and model differ; the cause is not decided.".into(),
    }
}

/// Whether the diagnosis's own sentence says more than [`headline`].
pub(super) fn adds(diagnosis: &Diagnosis) -> bool {
    match diagnosis.verdict {
        Verdict::Ambiguous => false,
        Verdict::Agrees | Verdict::Explained => diagnosis.says.contains(';'),
        Verdict::WrongForm | Verdict::Unexplained | Verdict::Undecided => true,
    }
}

/// Findings in a sentence, doubtful ones with "perhaps".
fn all_of<'a>(findings: impl Iterator<Item = &'a Finding>) -> String {
    let name = |f: &Finding| if f.is_doubtful() { format!("perhaps {}", spoken(&f.effect)) } else { spoken(&f.effect) };
    listed(&findings.map(name).collect::<Vec<_>>(), "and")
}

/// What is certain, then what it may be beside.
fn ambiguous(diagnosis: &Diagnosis) -> String {
    let open = |f: &&Finding| diagnosis.ambiguity.iter().any(|set| set.contains(&f.effect));
    let certain = all_of(diagnosis.findings.iter().filter(|f| !open(f)));
    let sets: Vec<String> = diagnosis.ambiguity.iter().map(|set| one_of(set)).collect();
    let choice = if sets.is_empty() {
        spoken_list(diagnosis.findings.iter().map(|f| &f.effect), "or")
    } else {
        sets.join("; and one of ")
    };
    if certain.is_empty() {
        format!("Missing from the model is one of {choice}. This recording cannot tell which.")
    } else {
        format!("Missing from the model: {certain}; beside it one of {choice}, and this recording cannot tell which.")
    }
}

/// The members of a set; of a large one the first few and how many more.
pub(super) fn one_of(set: &[String]) -> String {
    let names: Vec<String> = set.iter().map(|m| spoken(m)).collect();
    if names.len() <= MANY {
        return listed(&names, "or");
    }
    format!("{} or {} more", names[..MANY - 1].join(", "), names.len() + 1 - MANY)
}

/// An error of the response with its unit.
pub(super) fn error(diagnosis: &Diagnosis, value: f64) -> String {
    error_scale(diagnosis).text(value)
}

/// The same of an error that there may be none of: no row was predicted.
pub(super) fn error_if_any(diagnosis: &Diagnosis, value: Option<f64>) -> String {
    value.map_or_else(|| "–".to_owned(), |value| error(diagnosis, value))
}

/// What the two deviations of a number are, for a page on which some number has two.
pub(super) const TWO_DEVIATIONS: &str = "The error beside a number counts in what effects too weak to be named, and errors of the equations, may have done to it. \
     That of the fit alone is what noise and prior leave open where the model is right in every respect.";

/// A fitted number with its whole deviation.
pub(super) fn number(parameter: &ParameterFacts) -> String {
    measured(parameter.value, parameter.sd, &parameter.unit)
}

/// The same number with the deviation of the fit alone, in brackets; nothing where that reads no otherwise.
pub(super) fn of_fit_alone(parameter: &ParameterFacts) -> String {
    let alone = measured(parameter.value, parameter.sd_of_fit, &parameter.unit);
    let differs = parameter.sd_of_fit.is_finite() && parameter.sd_of_fit > 0.0 && alone != number(parameter);
    if differs { format!(" (of the fit alone: {alone})") } else { String::new() }
}

/// The choice made again without each part, with its error.
pub(super) fn chosen_again(diagnosis: &Diagnosis, again: &SelectedAgain) -> String {
    format!("{}; error on those parts {}", again.says, error_if_any(diagnosis, again.rmse))
}

/// How sure a finding is, in words with the two numbers.
pub fn how_sure(finding: &Finding) -> String {
    let [stated, among_models] = [finding.probability, finding.probability_among_models].map(percent);
    let beside = match stated == among_models {
        true => String::new(),
        false => format!(", as often as such names were right ({among_models} among the models)"),
    };
    let probability = format!("probability {stated}{beside}");
    let Some(d) = finding.detectability else { return probability };
    let strength = match d {
        d if d >= 16.0 => "stands far out of the noise",
        d if d >= SURE => "stands clear of the noise",
        d if d >= 5.0 => "visible, not beyond doubt",
        d if d >= 1.0 => "barely visible",
        _ => "not visible",
    };
    let d = detectability(d);
    format!("{probability}, detectability d = {d} ({strength})")
}

/// What calibration did to hide it, where it did.
pub fn concealed(diagnosis: &Diagnosis) -> Option<String> {
    if !diagnosis.concealed {
        return None;
    }
    let conflicts: String = diagnosis.conflicts.iter().map(|c| format!(" {}.", capitalised(&c.says))).collect();
    Some(format!(
        "Calibration had concealed it: what the calibrated model leaves is within twice the noise, because its parameters took up what is missing.{conflicts}"
    ))
}

/// Share of the reproducible misfit that the findings remove on rows left out.
pub fn misfit_removed(diagnosis: &Diagnosis) -> Option<String> {
    diagnosis.fit.held_out.misfit_removed.filter(|share| share.is_finite()).map(|share| match share {
        s if s < 0.0 => "none: the added physics predicts worse than the base model".into(),
        s if s >= 0.995 => "more than 99 %".into(),
        s => format!("{:.0} %", 100.0 * s),
    })
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_number_has_two_deviations_where_they_read_otherwise() {
        let number = |sd: f64, sd_of_fit: f64| {
            let facts = ParameterFacts {
                name: "tau".into(),
                unit: "s".into(),
                prior: [0.0, 1.0],
                value: 2.0016,
                sd,
                sd_of_fit,
                at_limit: false,
                meaning: String::new(),
            };
            number(&facts) + &of_fit_alone(&facts)
        };
        assert_eq!(number(0.07, 0.0005), "2.002 ± 0.070 s (of the fit alone: 2.00160 ± 0.00050 s)");
        assert_eq!(number(0.07, 0.0699), "2.002 ± 0.070 s");
        assert_eq!([number(0.07, f64::NAN), number(0.07, 0.0)], ["2.002 ± 0.070 s"; 2]);
    }

    fn finding(detectability: Option<f64>) -> Finding {
        Finding {
            effect: "thermal_lag".into(),
            probability: 0.91,
            probability_among_models: 0.97,
            says: String::new(),
            detectability,
            parameters: Vec::new(),
            held_out: truegap_diagnose::answer::BeforeAfterUnit {
                rmse_before: Some(1.0),
                rmse_after: Some(0.1),
                unit: "pF".into(),
            },
            rivals: Vec::new(),
            words: Default::default(),
        }
    }

    #[test]
    fn a_doubtful_name_is_told_with_perhaps() {
        let doubtful = Finding { effect: "regime_change".into(), probability: 0.42, ..finding(None) };
        assert_eq!(all_of([finding(None), doubtful].iter()), "thermal lag and perhaps regime change");
    }

    #[test]
    fn how_sure_a_finding_is_follows_its_detectability() {
        assert!(how_sure(&finding(Some(31.0))).contains("far out of the noise"));
        assert!(how_sure(&finding(Some(7.0))).contains("not beyond doubt"));
        assert!(how_sure(&finding(Some(3.0))).contains("barely"));
        assert!(how_sure(&finding(Some(0.0))).contains("(not visible)"));
        assert_eq!(how_sure(&finding(None)), "probability 91 %, as often as such names were right (97 % among the models)");
        assert!(how_sure(&finding(Some(1_159_754.8))).contains("d = over 1000"));
    }
}
