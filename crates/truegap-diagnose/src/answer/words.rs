//! The verdict as a sentence.
//!
//! Limits: decides nothing.

use crate::{
    answer::tuning::{CLEAR_LINE, NEARLY},
    answer::{
        alternatives::{named_sets, says_of},
        diagnosis::Finding,
        found::Found,
    },
    effects::memory::elapsed_s,
    selection::{
        tuning::DETECTED,
        verdict::{Decision, Verdict},
    },
    text::{percent, share_left},
};

/// Said first among the doubts where the search was stopped.
pub(crate) const STOPPED: &str =
    "the search was stopped before its end: verdict and probabilities are among what had been tried by then";

/// Said where something is missing that has no name.
const UNEXPLAINED: &str = "something real is missing that nothing in the library explains";

/// The verdict as a sentence with its reasons; with what the model carries beside the findings.
pub(crate) fn says(found: &Found<'_>, (findings, order): (&[Finding], &[usize]), carried: &[Finding]) -> String {
    let mut verdict = verdict_says(found, (findings, order));
    let own = found.interference.tone.steady && !findings.is_empty();
    let faint = found.decision.verdict == Verdict::Agrees;
    if let Some(tone) = tone(found).filter(|_| found.reserved.is_none() && (own || faint)) {
        verdict.push_str(&format!("; {}the reading holds {tone}", if own { "beside it " } else { "" }));
    }
    if carried.is_empty() {
        return verdict;
    }
    let names = carried.iter().map(|f| f.effect.as_str()).collect::<Vec<_>>().join(" and ");
    format!(
        "{verdict}; smaller parts of the misfit follow {names}, which is not claimed as a cause: an equation that is slightly off leaves as much"
    )
}

fn verdict_says(found: &Found<'_>, (findings, order): (&[Finding], &[usize])) -> String {
    if let Some(reserved) = &found.reserved {
        return reserved.says.clone();
    }
    let decision = found.decision;
    if let Some(says) = composed(found, (findings, order)) {
        return says;
    }
    if let Some(followed) = &found.smoothed {
        let what = match decision.verdict {
            Verdict::Agrees => "no cause that rows left out bear out",
            _ => UNEXPLAINED,
        };
        return format!("{what}; the reading does not show what is quick in {followed}, which may be noise of its own");
    }
    let names = findings.iter().map(name_as_sure).collect::<Vec<_>>().join(" and ");
    match decision.verdict {
        Verdict::Agrees if found.before.fires() => {
            let why = found.noise.does_as_much();
            format!("no mismatch that rows left out bear out; tests see a difference, but {why}")
        }
        Verdict::Agrees => "no mismatch found between recording and calibrated model".into(),
        Verdict::Explained if found.leaves_something() => {
            format!("missing from the model: {names}; {} of the misfit is left beside it", share_left(decision.removed))
        }
        Verdict::Explained => format!("missing from the model: {names}"),
        Verdict::Ambiguous => {
            let place =
                |names: Vec<String>| if names.len() > 1 { format!("one of {}", names.join(" or ")) } else { names.concat() };
            let sets = named_sets(found, order).into_iter().map(place).collect::<Vec<_>>().join("; and ");
            format!("missing from the model: {sets}; this recording cannot tell them apart")
        }
        Verdict::WrongForm => format!(
            "missing from the model: {names}; the family is clear, but its equation leaves {} of the misfit",
            share_left(decision.removed * decision.claimed)
        ),
        Verdict::Unexplained => unexplained(found, decision),
        Verdict::Undecided if found.interrupted => "stopped before the search was finished: causes are not decided".into(),
        Verdict::Undecided if found.selection.probability_none() >= DETECTED => open(found),
        Verdict::Undecided => "there is a mismatch, but its cause cannot be decided from this recording".into(),
    }
}

/// What is said where it is open whether anything is missing: how likely that is, and what it would be first of all.
fn open(found: &Found<'_>) -> String {
    let likeliest = found.selection.likeliest_named().map(|model| &found.selection.models[model].effects);
    let names = likeliest.map(|effects| effects.iter().map(|e| found.id(*e)).collect::<Vec<_>>().join(" with "));
    format!(
        "something may be missing (probability {}): this recording is not enough to decide it{}",
        percent(1.0 - found.selection.probability_agrees()),
        names.map_or_else(String::new, |names| format!("; likeliest would be {names}"))
    )
}

/// A name, with "perhaps" where what is stated of it is below one half.
fn name_as_sure(finding: &Finding) -> String {
    if finding.is_doubtful() { format!("perhaps {}", finding.effect) } else { finding.effect.clone() }
}

/// What is said where mechanisms from outside the library are named: what they do, and how sure each word is.
fn composed(found: &Found<'_>, (findings, order): (&[Finding], &[usize])) -> Option<String> {
    let first = found.search.library.len() - found.mechanisms.len();
    let chosen = &found.chosen().effects;
    let named = |effect: &usize| effect.checked_sub(first).and_then(|k| found.mechanisms.get(k));
    let sentence = |(effect, finding): (&usize, &Finding)| {
        named(effect).map_or_else(|| finding.effect.clone(), |m| format!("{} [{}]", finding.says, m.words.says()))
    };
    order.iter().any(|place| named(&chosen[*place]).is_some()).then(|| {
        let each = order.iter().map(|place| &chosen[*place]).zip(findings).map(sentence).collect::<Vec<_>>().join("; and ");
        let left = match found.leaves_something() {
            true => format!("; {} of the misfit is left beside it", share_left(found.decision.removed)),
            false => String::new(),
        };
        format!("missing from the model, and in no library: {each}{left}")
    })
}

fn unexplained(found: &Found<'_>, decision: &Decision) -> String {
    if let Some(cause) = &decision.unmodelled {
        return format!("something real is missing that is not in the library: {}", says_of(found, cause));
    }
    if found.is_about_interference() {
        return format!("something is in the reading that is not in the library: {}", interference(found).unwrap_or_default());
    }
    if !found.before.fires() {
        return UNEXPLAINED.into();
    }
    let removes = match found.left_out.is_empty() {
        true => format!("the likeliest effect removes {:.0} % of the misfit", 100.0 * decision.removed),
        false => "what would fit is not borne out by rows left out".into(),
    };
    format!("{UNEXPLAINED} ({removes}){}{}", line(found), nearest_unmodelled(found))
}

/// The strongest line in the spectrum of what the likeliest model leaves, where it is clear.
fn line(found: &Found<'_>) -> String {
    let after = &found.after;
    if after.line_p_value >= CLEAR_LINE {
        return String::new();
    }
    format!("; run {} holds a line at {:.4} cycles a row", after.line_at.0 + 1, after.line_at.1)
}

/// The tone, or else the loudest burst, of what the model stood behind leaves, in words; `None` where there is neither.
fn interference(found: &Found<'_>) -> Option<String> {
    let (burst, inputs) = (found.interference.burst, found.all.problem.inputs);
    let bursts = || {
        let (run, time) = (inputs.run[burst.row], elapsed_s(inputs, burst.row));
        let loudness = burst.loudness;
        format!("short bursts, the loudest in run {run} near {time:.0} s with {loudness:.1} times the scatter of the noise")
    };
    tone(found).or_else(|| burst.is_significant().then(bursts))
}

/// The tone in what the model stood behind leaves.
fn tone(found: &Found<'_>) -> Option<String> {
    let tone = found.interference.tone;
    tone.is_significant().then(|| tone.says())
}

/// The unmodelled cause that comes nearest, where the library explains too little and no such cause is likelier.
fn nearest_unmodelled(found: &Found<'_>) -> String {
    let nearest = found.selection.unmodelled.first().filter(|(u, _)| u.gain > NEARLY);
    nearest.map_or_else(String::new, |(u, _)| format!("; of what lies outside it, nearest is that {}", says_of(found, u)))
}
