//! What another recording says of effects that the first one could not tell apart: each model that holds a rival predicts it as the augmented model does.
//!
//! The model that leaves least is compared with each of the others. Those that predict worse, at a level that all comparisons share (Bonferroni), are excluded.
//!
//! Limits: the rivals with the numbers that the first recording gave them; that the best of several leaves least is by chance in part, which the shared level counts and the errors do not.

use super::judged::{Free, Judged, judged_model};
use crate::models::{ModelFile, ModelFileError, Programs};
use truegap_core::Recording;
use truegap_diagnose::Library;
use truegap_diagnose::answer::{AmongRivals, Errors, RivalErrors, RivalModel};
use truegap_diagnose::confirmation::{Compared, Judgement, LEVEL, compared_at};
use truegap_diagnose::other_clock::OtherClock;
use truegap_diagnose::text::{listed, significant, spoken, spoken_list};

/// Most rivals that are told by name where nothing excludes them; more stand in the table.
const MOST_TOLD: usize = 3;

/// A model by its prediction and its errors.
struct Predicted {
    column: Vec<f64>,
    errors: Errors,
}

/// The rivals of a model file on a recording, beside the augmented model that was `judged` there; `None` where the file has none.
pub(super) fn among_rivals(
    (written, named): (&ModelFile, &[String]),
    judged: &Judged,
    recording: &Recording,
    free: Free,
    programs: &Programs,
) -> Option<AmongRivals> {
    if written.rivals.is_empty() {
        return None;
    }
    let asked = |rival: &RivalModel| -> Result<Predicted, String> {
        let model = written.with_rival(rival).build_with(programs).map_err(in_words)?;
        let (model, left_out) = model.elsewhere(&Library::default(), &recording.inputs);
        if let Some(left_out) = left_out.iter().find(|left_out| left_out.effect == rival.id) {
            return Err(left_out.why.into());
        }
        let predict = |clock: &OtherClock| model.respond_by(clock, &recording.inputs);
        let (column, errors) = judged_model(recording, free, &predict).map_err(in_words)?;
        Ok(Predicted { column, errors })
    };
    let (mut known, mut refused) = (Vec::new(), Vec::new());
    for rival in &written.rivals {
        match asked(rival) {
            Ok(predicted) => known.push((rival, predicted)),
            Err(why) => refused.push(format!("{}: {why}", spoken(&rival.id))),
        }
    }
    // the augmented model is the first of all
    let augmented = (&judged.columns[1], &judged.errors[1]);
    let all: Vec<_> = std::iter::once(augmented).chain(known.iter().map(|(_, one)| (&one.column, &one.errors))).collect();
    let best = (0..all.len()).min_by(|a, b| all[*a].1.rmse.total_cmp(&all[*b].1.rmse))?;
    let level = LEVEL / known.len().max(1) as f64;
    let runs = recording.inputs.runs();
    let behind = |one: usize| (one != best).then(|| compared_at(level, [all[one].0, all[best].0], &recording.response, &runs));
    let rival = |(index, (rival, predicted)): (usize, &(&RivalModel, Predicted))| RivalErrors {
        instead_of: rival.instead_of.clone(),
        id: rival.id.clone(),
        errors: predicted.errors.clone(),
        behind_the_best: behind(index + 1),
    };
    let judged: Vec<RivalErrors> = known.iter().enumerate().map(rival).collect();
    let augmented_behind_the_best = behind(0);
    let says = says(named, augmented.1, augmented_behind_the_best.as_ref(), &judged, &written.unit);
    Some(AmongRivals { judged, refused, augmented_behind_the_best, level, says })
}

/// An error as it is told beside a name.
fn in_words(error: ModelFileError) -> String {
    error.to_string()
}

/// What came of it in a sentence; `named` are the effects of the augmented model.
fn says(named: &[String], augmented: &Errors, behind: Option<&Compared>, rivals: &[RivalErrors], unit: &str) -> String {
    if rivals.is_empty() {
        return "None of what the diagnosis could not tell apart can be judged here.".into();
    }
    let as_told = |rival: &RivalErrors| format!("{} in the place of {}", spoken(&rival.id), spoken(&rival.instead_of));
    let error = |errors: &Errors| format!("{} {unit}", significant(errors.rmse, 3));
    let named = (format!("{} as named", spoken_list(named, "and")), augmented, behind);
    let all: Vec<(String, &Errors, Option<&Compared>)> = std::iter::once(named)
        .chain(rivals.iter().map(|rival| (as_told(rival), &rival.errors, rival.behind_the_best.as_ref())))
        .collect();
    let told = |judgement: Option<Judgement>| {
        let those = all.iter().filter(move |(_, _, test)| test.map(|test| test.judgement) == judgement);
        those.map(|(name, errors, _)| format!("{name} ({})", error(errors))).collect::<Vec<_>>()
    };
    let (best, out, open) = (told(None), told(Some(Judgement::Confirmed)), told(Some(Judgement::CannotTell)));
    let first =
        format!("Of what the diagnosis could not tell apart, the smallest error here is that of {}", listed(&best, "and"));
    let worse = (!out.is_empty()).then(|| format!("worse, and so excluded: {}", listed(&out, "and")));
    let open = match open.len() {
        0 => None,
        few if few <= MOST_TOLD => Some(format!("still open: {}", listed(&open, "and"))),
        many => Some(format!("still open: the {many} others")),
    };
    [Some(first), worse, open].into_iter().flatten().collect::<Vec<_>>().join("; ") + "."
}
