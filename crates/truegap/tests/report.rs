//! What a reader of a report must find in it, and what must not be there.

#![allow(clippy::unwrap_used)]

#[path = "report/fixture.rs"]
mod fixture;

use truegap::diagnosis::report::{html, terminal, wording};
use truegap_diagnose::answer::{Confirmation, Confirmed, Conflict, Errors, ModelFacts, NotTestable, OtherFacts, Verdict};
use truegap_diagnose::confirmation::{Compared, Judgement, NoiseFloor, Reading};

/// The page with plain spaces where a number is kept on one line with its sign.
fn breakable(page: &str) -> String {
    page.replace('\u{a0}', " ")
}

#[test]
fn a_report_says_first_what_is_missing_with_size_unit_and_certainty() {
    let fixture = fixture::thermal_lag();
    let page = breakable(&html(&fixture.subject()));
    std::fs::write(concat!(env!("CARGO_TARGET_TMPDIR"), "/report.html"), &page).unwrap();
    let top = &page[page.find("<h1>").unwrap()..page.find("<h2>").unwrap()];
    for expected in [
        "Missing from the model: thermal lag.",
        "120 s (sd 6)",
        "98 %",
        "d = 31.0",
        "Calibration had concealed it",
        "4.7 prior sd",
    ] {
        assert!(top.contains(expected), "{expected} is not at the top");
    }
    assert!(top.contains("<svg"), "no figure at a glance");
}

#[test]
fn a_report_holds_every_part_of_the_answer() {
    let fixture = fixture::thermal_lag();
    let page = html(&fixture.subject());
    let parts = [
        "12 rows repeat the value before them",
        "lag first-order, tau = (1 - s) q + s r q",
        "Incropera",
        "readout lag",
        "the reading is behind while the temperature moves",
        "820.0 ± 6.0 kPa|821.0 ± 6.0 kPa",
        "1.0620 ± 0.0070 MPa",
        "-4.7 !",
        "No humidity column",
        "0.0021",
        "Heat at two rates under constant load",
        "--profile thermal-steps",
        "4 fF from 60 rows at rest",
        "2026-01-02 03:04 UTC",
        &"ab".repeat(32),
        "each run in turn",
        "97 %",
        "lack of fit, smooth directions",
        "\\begin{tabular}",
        "A recording of",
    ];
    for part in parts {
        assert!(part.split('|').any(|p| page.contains(p)), "{part} is missing");
    }
    assert!(!page.contains("A figure is left out"), "a figure was not drawn");
}

/// Sentences and terminal tell the whole deviation alone; so do tables where that of the fit reads the same.
#[test]
fn tables_tell_the_deviation_of_the_fit_where_it_is_another() {
    let mut fixture = fixture::thermal_lag();
    let (alone, why) = ("(of the fit alone: ", "what noise and prior leave open");
    let page = breakable(&html(&fixture.subject()));
    assert!(!page.contains(alone) && !page.contains(why));
    let before = terminal::summary(&fixture.diagnosis);
    for number in [&mut fixture.diagnosis.findings[0].parameters[0], &mut fixture.diagnosis.base.parameters_after[0]] {
        number.sd_of_fit = 0.01 * number.sd;
    }
    let page = breakable(&html(&fixture.subject()));
    assert_eq!([page.matches(alone).count(), page.matches(why).count()], [2, 2]);
    assert_eq!(terminal::summary(&fixture.diagnosis), before);
}

#[test]
fn a_report_loads_nothing_from_elsewhere_and_keeps_markup_of_names_out() {
    let mut fixture = fixture::thermal_lag();
    fixture.diagnosis.recording.source = "<script>alert(1)</script>.csv".into();
    fixture.diagnosis.findings[0].says = "<img src=x>".into();
    let page = html(&fixture.subject());
    assert!(!page.contains("<script>alert") && !page.contains("<img"));
    assert_eq!(page.matches("<script").count(), 1, "the page's own, for its figures");
    assert!(!page.contains("aria-label=\"\""), "a figure has no name");
    let outside = page.replace("http://www.w3.org/2000/svg", "");
    assert!(!outside.contains("http://") && !outside.contains("https://") && !outside.contains("url(h"));
}

/// Whoever reads "97 % removed" must see what a line through the inputs does, on the page and on the terminal.
#[test]
fn a_straight_line_and_a_smooth_curve_stand_beside_the_models() {
    let mut fixture = fixture::thermal_lag();
    let page = html(&fixture.subject());
    assert!(page.contains("straight line") && page.contains("21.3 fF") && page.contains("24.1 fF"));
    assert!(page.contains("smooth curve") && page.contains("18.7 fF") && page.contains("30.5 fF"));
    let text = terminal::summary(&fixture.diagnosis);
    assert!(text.contains("in force and temperature: straight line 21.3 fF (24.1 fF held out), smooth curve 18.7 fF"), "{text}");
    assert!(!page.contains("nearer than"));
    fixture.diagnosis.reference_says = Some("a straight line is nearer than the calibrated base model".into());
    assert!(html(&fixture.subject()).contains("A straight line is nearer than the calibrated base model."));
    assert!(terminal::summary(&fixture.diagnosis).contains("A straight line is nearer than"));
}

/// By what is missing, so that a reader sees at once what another recording would have to hold.
#[test]
fn what_could_not_be_tested_is_told_by_what_is_missing() {
    let mut fixture = fixture::thermal_lag();
    let not = |effect: &str, says: &str| NotTestable { effect: effect.into(), says: says.into() };
    let clockless = ["readout_lag", "viscoelastic_creep", "ageing", "time_offset", "offset_drift"];
    let list = &mut fixture.diagnosis.not_testable;
    list.extend(clockless.map(|effect| not(effect, "no time column")));
    list.push(not("gain_drift", "no temperature column"));
    list.push(not("friction", "the base model has a place for friction of its own (hysteresis of the strain)"));
    let page = html(&fixture.subject());
    let section = &page[page.find("What this recording could not show").unwrap()..];
    let (clock, humidity) = (section.find("No time column").unwrap(), section.find("No humidity column").unwrap());
    assert!(clock < humidity, "what leaves most untried comes first");
    assert!(section.contains("readout lag, viscoelastic creep, ageing, time offset, offset drift"));
    assert!(section.find("What this base model has no place for").unwrap() > humidity);
    assert!(page.contains("What tau means") || page.contains("what tau means"), "a name alone says nothing");
    let text = terminal::summary(&fixture.diagnosis);
    let line = text.lines().find(|line| line.starts_with("Could not be tested: ")).unwrap();
    assert_eq!(
        line,
        "Could not be tested: no time column (readout lag, viscoelastic creep, ageing and 2 more); no humidity column (humidity uptake); \
         no temperature column (gain drift)"
    );
}

#[test]
fn weak_evidence_is_worded_weakly() {
    let mut fixture = fixture::thermal_lag();
    fixture.diagnosis.findings[0].detectability = Some(7.0);
    assert!(wording::headline(&fixture.diagnosis).contains("most consistent with thermal lag"));
    fixture.diagnosis.verdict = Verdict::Ambiguous;
    fixture.diagnosis.ambiguity = vec![vec!["thermal_lag".into(), "viscoelastic_creep".into()]];
    let says = wording::headline(&fixture.diagnosis);
    assert!(says.contains("thermal lag or viscoelastic creep") && says.contains("cannot tell which"));
    let page = html(&fixture.subject());
    assert!(page.contains("straight in the logarithm of dwell"), "what separates them is not said");
}

#[test]
fn what_is_certain_is_said_apart_from_what_cannot_be_told() {
    let mut fixture = fixture::thermal_lag();
    fixture.diagnosis.verdict = Verdict::Ambiguous;
    let set = "ageing dead_gap saturation fringing_field plate_bending offset_drift";
    fixture.diagnosis.ambiguity = vec![set.split(' ').map(String::from).collect()];
    let says = wording::headline(&fixture.diagnosis);
    assert!(says.starts_with("Missing from the model: thermal lag; beside it one of ageing, dead gap"), "{says}");
    assert!(says.contains("or 2 more"), "{says}");
}

#[test]
fn a_report_without_findings_shows_one_residual_and_claims_nothing() {
    let mut fixture = fixture::thermal_lag();
    let diagnosis = &mut fixture.diagnosis;
    (diagnosis.verdict, diagnosis.concealed) = (Verdict::Agrees, false);
    diagnosis.findings.clear();
    diagnosis.conflicts.clear();
    diagnosis.mismatch.clear();
    let page = html(&fixture.subject());
    assert!(page.contains("Recording and model agree") && !page.contains("what was missing"));
    assert!(!page.contains("Missing from the model") && !page.contains("A figure is left out"));
}

#[test]
fn columns_that_do_not_fit_cost_a_figure_and_not_the_report() {
    let mut fixture = fixture::thermal_lag();
    fixture.traces.held_out_before.clear();
    fixture.traces.held_out_after.clear();
    fixture.traces.noise_sd.clear();
    let page = html(&fixture.subject());
    assert!(page.contains("No row has a prediction") && page.contains("Missing from the model: thermal lag."));
}

#[test]
fn the_terminal_gets_verdict_sizes_errors_and_what_next() {
    let fixture = fixture::thermal_lag();
    let text = terminal::summary(&fixture.diagnosis);
    for expected in
        ["Missing from the model: thermal lag.", "120 s", "RMSE held out", "97 %", "Next: heat at two rates", "4.7 prior sd"]
    {
        assert!(text.contains(expected), "{expected} is missing in\n{text}");
    }
}

#[test]
fn a_flexible_term_is_told_with_its_error_on_unseen_rows_and_names_no_cause() {
    let mut fixture = fixture::thermal_lag();
    fixture.without_cause();
    let page = breakable(&html(&fixture.subject()));
    for expected in ["What can be predicted all the same", "no cause is claimed", "like thermal lag", "64 %", "what is left here"]
    {
        assert!(page.contains(expected), "{expected} is missing");
    }
    assert!(!page.contains("A figure is left out"), "a figure was not drawn");
    assert!(terminal::summary(&fixture.diagnosis).contains("without a claim about the cause"));
    fixture.diagnosis.prediction_only = None;
    assert!(!html(&fixture.subject()).contains("What can be predicted all the same"));
}

#[test]
fn where_a_wrong_form_leaves_misfit_is_told_and_drawn() {
    let mut fixture = fixture::thermal_lag();
    assert!(!html(&fixture.subject()).contains("Where misfit remains"));
    fixture.diagnosis.verdict = Verdict::WrongForm;
    fixture.diagnosis.remains = fixture.diagnosis.mismatch.clone();
    let page = html(&fixture.subject());
    let part = &page[page.find("Where misfit remains").unwrap()..];
    assert!(part.contains("the reading is behind while the temperature moves") && part.contains("on a scale of its own"));
}

fn confirmation() -> Confirmation {
    let errors = |rmse| Errors { rmse, reading: Reading { gain: 1.0, offset: 0.0 }, clock: None };
    let facts = |text: &str| text.to_owned();
    Confirmation {
        schema: "truegap.confirmation/1",
        made_by: facts("truegap"),
        model: ModelFacts {
            file: facts("augmented.toml"),
            recording: facts("bench.csv"),
            sha256: facts("0"),
            verdict: facts("explained"),
            effects: vec![facts("thermal_lag")],
            base_is_known: true,
        },
        recording: OtherFacts { source: facts("other.csv"), sha256: facts("1"), rows: 500, runs: 2 },
        unit: facts("pF"),
        free: Vec::new(),
        base: errors(0.0312),
        augmented: errors(0.0051),
        noise: NoiseFloor { rmse: 0.004, measured: true, says: facts("from rest") },
        level: 0.01,
        verdict: Judgement::Confirmed,
        test: Compared { blocks: 20, better_in: 19, difference: 0.1, p_value: 1e-6, judgement: Judgement::Confirmed },
        verdict_if_gain_and_offset_are_free: Judgement::Confirmed,
        says: facts("better in 19 of 20 blocks"),
        rivals: None,
        notes: Vec::new(),
    }
}

/// The strongest thing that can be said of a finding stood far below the first screen.
#[test]
fn a_confirmation_stands_among_the_numbers_at_the_top() {
    let mut fixture = fixture::thermal_lag();
    fixture.diagnosis.confirmation = Some(Confirmed::Judged(Box::new(confirmation())));
    let page = breakable(&html(&fixture.subject()));
    let top = &page[page.find("<h1>").unwrap()..page.find("<h2>").unwrap()];
    assert!(top.contains("<strong>confirmed</strong>") && top.contains("took no part: 0.0312 → 0.00510 pF"), "{top}");
    fixture.diagnosis.confirmation = Some(Confirmed::Refused { source: "other.csv".into(), refused: "no load".into() });
    assert!(html(&fixture.subject()).contains("<strong>not judged</strong>"));
}

/// An error below the noise removes "112 % of the reproducible misfit", which is no limit of anything.
#[test]
fn no_check_has_a_share_above_a_hundred_per_cent() {
    let mut fixture = fixture::thermal_lag();
    fixture.diagnosis.fit.held_out.misfit_removed = Some(1.12);
    let page = breakable(&html(&fixture.subject()));
    let row = &page[page.find("removed by a permuted history").unwrap()..];
    let row = &row[..row.find("</tr>").unwrap()];
    assert!(row.contains("≤ 100") && !row.contains("112"), "{row}");
}

/// One cell at 2700 noises left all others white.
#[test]
fn one_outlier_does_not_set_the_scale_of_the_map() {
    let mut fixture = fixture::thermal_lag();
    fixture.traces.map_before.as_mut().unwrap().values[0][0] = 2700.0;
    let page = html(&fixture.subject());
    assert!(page.contains("▲ beyond, to 2700") && page.contains("logarithmic beyond"));
}

#[test]
fn curves_that_lie_on_one_another_are_said_to() {
    let mut fixture = fixture::thermal_lag();
    let lie = "The curves lie on one another";
    assert!(html(&fixture.subject()).contains(lie), "a lag of 0.15 pF beside a range of 14 pF");
    fixture.traces.before = fixture.response.iter().map(|r| r + 1.0).collect();
    assert!(!html(&fixture.subject()).contains(lie));
}

/// In the figure of what remains the fuller model had the colour of the base model.
#[test]
fn a_model_has_one_colour_in_all_figures() {
    let mut fixture = fixture::thermal_lag();
    fixture.diagnosis.verdict = Verdict::WrongForm;
    fixture.diagnosis.remains = fixture.diagnosis.mismatch.clone();
    let page = html(&fixture.subject());
    let part = &page[page.find("Where misfit remains").unwrap()..];
    let end = part.find("<title>with what was missing</title>").unwrap();
    let path = &part[part[..end].rfind("<path").unwrap()..end];
    assert!(path.contains("#D55E00") || path.contains("#d55e00"), "{}", &path[path.len() - 200..]);
}

/// What a pointer reads comes from the drawing; the page must hold both parts of it.
#[test]
fn every_panel_says_its_axes_and_the_page_has_the_script_that_reads_them() {
    let fixture = fixture::thermal_lag();
    let page = html(&fixture.subject());
    let panels = page.matches("class=\"tg-panel\"").count();
    assert!(panels > 6 && page.matches("data-y-unit=").count() == panels && page.contains("tg-values"));
    assert!(page.matches("data-cells=").count() == 2, "both maps");
}

/// Parameters that two parts of a recording tell differently stood as at odds with what was known, beside a line that said that none was.
#[test]
fn what_differs_between_parts_of_a_recording_has_a_heading_of_its_own() {
    let mut fixture = fixture::thermal_lag();
    fixture.diagnosis.concealed = false;
    let apart = || Conflict {
        says: "the gain would be 1.00 at small loads but 1.02 at large loads, 6.2 standard deviations apart".into(),
        parameter: "gain".into(),
        z: 6.2,
        between_parts: true,
    };
    fixture.diagnosis.conflicts.push(apart());
    let text = terminal::summary(&fixture.diagnosis);
    let at = |part: &str| text.find(part).unwrap_or_else(|| panic!("{part} is missing in\n{text}"));
    let order =
        ["At odds with what was known beforehand", "4.7 prior sd", "Differs between parts of the recording", "6.2 standard"]
            .map(at);
    assert!(order.is_sorted(), "{text}");
    fixture.diagnosis.conflicts = vec![apart()];
    assert!(!terminal::summary(&fixture.diagnosis).contains("At odds"));
    let page = html(&fixture.subject());
    assert!(page.contains("Differs between parts of the recording") && page.contains("6.2 standard deviations apart"));
}

/// One column may order five mismatches: its size, its speed, its way, how long it has been held, its greatest value.
#[test]
fn the_table_of_mismatches_says_what_of_a_column_orders_them() {
    let page = html(&fixture::thermal_lag().subject());
    assert!(page.contains("<td>with the time since the temperature changed</td>"), "the quantity is missing");
}

/// The page named the first file for both.
#[test]
fn each_mechanism_is_told_with_its_own_file() {
    let mut fixture = fixture::thermal_lag();
    fixture.diagnosis.discovered = vec![fixture::mechanism(), fixture::mechanism()];
    let page = html(&fixture.subject());
    for file in ["discovered.toml", "discovered_second.toml"] {
        assert!(
            page.contains(&format!("{file} beside this page holds it: ")) && page.contains(&format!("--effect {file}")),
            "{file}"
        );
    }
}

/// A mechanism that the model carries beside a name is no second answer that "comes nearest".
#[test]
fn a_mechanism_that_is_carried_is_told_as_such() {
    let mut fixture = fixture::thermal_lag();
    let clause = "the reading follows the rate".to_owned();
    fixture.diagnosis.discovered =
        vec![truegap_diagnose::answer::DiscoveredFacts { named: false, carried: true, clause, ..fixture::mechanism() }];
    let text = terminal::summary(&fixture.diagnosis);
    assert!(text.contains("Of what it carries: the reading follows the rate") && !text.contains("nearest is"), "{text}");
    let page = html(&fixture.subject());
    assert!(page.contains("beside what is named") && page.contains("The model carries it."), "the page does not say so");
}
