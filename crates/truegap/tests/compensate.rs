//! Readings corrected by model files that are written by hand: what the sensor should have read is known by closed form.

#![allow(clippy::unwrap_used)]

#[path = "common/noise.rs"]
mod common;
#[path = "common/late.rs"]
mod late;

use common::noise;
use late::late;
use std::path::Path;
use truegap::core::recording::BaseSpec;
use truegap::core::{Driver, Inputs, Recording};
use truegap::diagnose::compensation::Stopped;
use truegap::diagnosis::compensate::{CompensateError, Compensated, SCHEMA, Wanted, compensate_with};
use truegap::models::{MODEL_SCHEMA, ModelFile, Programs};

const ROWS: usize = 900;
const SD: f64 = 0.02;
const SCALE: &str =
    r#"{ unit = "mm", centre = 8.5, range = 15.0, at_rest = 1.0, span = 15.0, gaps_m = [0.0, 0.0], response_times_gap = 1.0 }"#;
const TEMPERATURE: &str = "[[effect]]\nid = \"temperature_coefficient\"\nparameters = [{ name = \"per_kelvin\", unit = \"mm/K\", value = 0.1, sd = 0.01 }, { name = \"bend\", unit = \"1/K\", value = 0.0, sd = 0.01 }]\n";
const LAG: &str = "[[effect]]\nid = \"readout_lag\"\nparameters = [{ name = \"tau\", unit = \"s\", value = 8.0, sd = 0.1 }]\n";
const LATE: &str = "[[effect]]\nid = \"time_offset\"\nparameters = [{ name = \"late\", unit = \"s\", value = 5.0, sd = 0.1 }]\n";

/// A base, its numbers and effects as a file; `moved` is what moved when it was fitted.
fn model(base: &str, parameters: &[(&str, f64)], moved: &str, effects: &str) -> ModelFile {
    ModelFile::parse(&text(base, parameters, moved, effects), Path::new("augmented.toml")).unwrap()
}

/// The text of that file.
fn text(base: &str, parameters: &[(&str, f64)], moved: &str, effects: &str) -> String {
    let number =
        |(name, value): &(&str, f64)| format!("[[parameter]]\nname = \"{name}\"\nunit = \"mm\"\nvalue = {value}\nsd = 0.1\n");
    let parameters: String = parameters.iter().map(number).collect();
    format!(
        "schema = \"{MODEL_SCHEMA}\"\nmade_by = \"test\"\nrecording = \"a\"\nsha256 = \"b\"\nverdict = \"explained\"\nunit = \"mm\"\n{}{}\
         [base]\n{base}\nscale = {SCALE}\nreference_c = 20.0\n\
         [scales]\nlongest_run_s = 899.0\nshortest_step_s = 1.0\nduration_s = 899.0\nresponse_span = 15.0\nnoise_sd = {SD}\nruns = 1\n\
         moved = {{ {moved} }}\n{parameters}{effects}",
        if effects.is_empty() { "effect = []\n" } else { "" },
        if parameters.is_empty() { "parameter = []\n" } else { "" },
    )
}

/// Reads `1 + 1.5 F`, F up to 10 N.
fn line(effects: &str) -> ModelFile {
    let base = "model = \"linear\"\norder = 1\ndriver = { role = \"force\", zero = 0.0, width = 10.0 }";
    model(base, &[("offset", 1.0), ("slope", 15.0)], MOVED, effects)
}

const MOVED: &str = "temperature_k = 16.0, load = 1.0, gap = false, simulated = false, drivers = []";

fn force() -> Vec<f64> {
    (0..ROWS).map(|row| 5.0 + 3.0 * (row as f64 / 40.0).sin() + 1.5 * (row as f64 / 17.0).sin()).collect()
}

fn heat() -> Vec<f64> {
    (0..ROWS).map(|row| 20.0 + 8.0 * (row as f64 / 150.0).sin()).collect()
}

fn with_noise(column: &[f64]) -> Vec<f64> {
    let mut noise = noise(5);
    column.iter().map(|value| value + SD * noise()).collect()
}

/// A recording of a sensor in use: a clock, a thermometer and what was read.
fn in_use(response: &[f64]) -> Recording {
    let inputs = Inputs {
        time_s: Some((0..ROWS).map(|row| row as f64).collect()),
        run: vec![1; ROWS],
        temperature_c: Some(heat()),
        ..Inputs::default()
    };
    Recording::new(inputs, with_noise(response), "mm", BaseSpec::default()).unwrap()
}

fn corrected(file: &ModelFile, recording: Recording, of_the_clock: bool) -> Result<Compensated, CompensateError> {
    corrected_as(file, recording, Wanted { of_the_clock, ..Wanted::default() })
}

fn corrected_as(file: &ModelFile, recording: Recording, wanted: Wanted) -> Result<Compensated, CompensateError> {
    compensate_with(file, Path::new("augmented.toml"), recording, None, wanted, &Programs::default())
}

fn column(found: &Compensated, name: &str) -> Vec<f64> {
    found.table().into_iter().find(|(n, _)| n == name).unwrap().1
}

fn error(found: &Compensated, name: &str, truth: &[f64]) -> f64 {
    let squares: f64 = column(found, name).iter().zip(truth).map(|(a, b)| (a - b).powi(2)).sum();
    (squares / ROWS as f64).sqrt()
}

fn true_reading() -> Vec<f64> {
    force().iter().map(|f| 1.0 + 1.5 * f).collect()
}

#[test]
fn a_line_with_a_temperature_coefficient_reads_as_the_line() {
    let truth = true_reading();
    let read: Vec<f64> = truth.iter().zip(heat()).map(|(y, t)| y + 0.1 * (t - 20.0)).collect();
    let found = corrected(&line(TEMPERATURE), in_use(&read), false).unwrap();
    assert!(error(&found, "reading", &truth) > 20.0 * SD);
    // nothing but the noise is left, of which no part was added
    assert!(error(&found, "corrected", &truth) < 1.1 * SD, "{}", found.document.says);
    let document = &found.document;
    assert_eq!((document.schema, document.passes, document.stopped), (SCHEMA, 1, Stopped::AtNoise));
    assert!(document.error.is_none() && (document.noise_growth - 1.0).abs() < 1e-9, "{}", document.says);
    assert_eq!(document.estimated.as_ref().unwrap().input, "force");
    assert!(error(&found, "estimated_force_n", &force()) < 1.1 * SD / 1.5);
    assert_eq!(found.csv().lines().next(), Some("run,time_s,reading,corrected,estimated_force_n"));
    assert_eq!(found.csv().lines().count(), ROWS + 1);
}

#[test]
fn a_late_simulation_is_caught_up_and_the_gain_is_told_where_the_truth_is_there() {
    let file =
        model("model = \"external\"", &[], "temperature_k = 0.0, load = 0.0, gap = false, simulated = true, drivers = []", LAG);
    let truth = true_reading();
    let mut recording = in_use(&late(&truth, 8.0));
    recording.inputs.simulated = Some(truth.clone());
    let found = corrected(&file, recording, false).unwrap();
    let (before, after) = (error(&found, "reading", &truth), error(&found, "corrected", &truth));
    assert!(before > 20.0 * SD && after < 6.0 * SD && after < before / 8.0, "{after} of {before}: {}", found.document.says);
    let told = found.document.error.as_ref().unwrap();
    approx::assert_relative_eq!(told.before, before, max_relative = 1e-9);
    approx::assert_relative_eq!(told.after, after, max_relative = 1e-9);
    assert!(found.document.noise_growth <= 1.0 + found.document.passes as f64 && found.document.explains());
}

/// A bent base is inverted, and heat and a lag go together.
#[test]
fn a_bent_base_with_heat_and_a_lag_comes_back() {
    let base = "model = \"linear\"\norder = 2\ndriver = { role = \"force\", zero = 0.0, width = 10.0 }";
    let file = model(base, &[("offset", 1.0), ("slope", 15.0), ("order_2", -4.0)], MOVED, &format!("{TEMPERATURE}{LAG}"));
    let truth: Vec<f64> = force().iter().map(|f| 1.0 + 1.5 * f - 0.04 * f * f).collect();
    let warm: Vec<f64> = truth.iter().zip(heat()).map(|(y, t)| y + 0.1 * (t - 20.0)).collect();
    let found = corrected(&file, in_use(&late(&warm, 8.0)), false).unwrap();
    let (before, after) = (error(&found, "reading", &truth), error(&found, "corrected", &truth));
    assert!(before > 30.0 * SD && after < 6.0 * SD, "{after} of {before}: {}", found.document.says);
    // 1.5 - 0.08 F is the slope, 0.74 at the greatest force
    assert!(error(&found, "estimated_force_n", &force()) < 6.0 * SD / 0.7);
}

/// A tenth of the slope stands in a mechanism that the model only carries: taken out, every reading was a tenth too low, and the error that was told was against a line of nine tenths.
#[test]
fn what_is_only_carried_stays_in_the_reading_unless_it_is_asked_for() {
    let carried = "[[effect]]\nid = \"discovered\"\ncarried = true\nparameters = [{ name = \"size\", unit = \"mm\", value = 1.5, sd = 0.1 }]\n\
        [effect.mechanism]\nquantity = \"reading\"\naction = \"adds\"\ndriver = \"load\"\nkinetics = \"static\"\nform = \"linear\"\neven = false\nbelow = false\npassing = false\n";
    let base = "model = \"linear\"\norder = 1\ndriver = { role = \"force\", zero = 0.0, width = 10.0 }";
    let of = |effects: &str| model(base, &[("offset", 1.0), ("slope", 13.5)], MOVED, effects);
    let file = of(&format!("{TEMPERATURE}{carried}"));
    let truth = true_reading();
    let read: Vec<f64> = truth.iter().zip(heat()).map(|(y, t)| y + 0.1 * (t - 20.0)).collect();
    let mut recording = in_use(&read);
    recording.inputs.force_n = Some(force());
    let found = corrected(&file, recording.clone(), false).unwrap();
    assert_eq!(found.document.corrected_for, ["temperature_coefficient"]);
    assert!(error(&found, "corrected", &truth) < 1.1 * SD, "{}", found.document.says);
    assert!(error(&found, "estimated_force_n", &force()) < 1.1 * SD / 1.5);
    assert!(found.document.error.as_ref().unwrap().after < 1.1 * SD, "{}", found.document.says);
    assert!(found.document.notes.iter().any(|note| note.contains("--carried")), "{:?}", found.document.notes);
    let all = corrected_as(&file, recording, Wanted { carried: true, ..Wanted::default() }).unwrap();
    assert_eq!(all.document.corrected_for, ["temperature_coefficient", "discovered"]);
    let nine_tenths: Vec<f64> = force().iter().map(|f| 1.0 + 1.35 * f).collect();
    assert!(error(&all, "corrected", &nine_tenths) < 1.1 * SD, "{}", all.document.says);
    let nothing = corrected(&of(carried), in_use(&read), false).err().unwrap();
    assert!(matches!(nothing, CompensateError::NothingLeft { .. }), "{nothing}");
}

#[test]
fn what_belongs_to_one_recording_is_left_out_and_named() {
    let drift = "[[effect]]\nid = \"settling\"\nparameters = [{ name = \"per_decade\", unit = \"mm\", value = 0.3, sd = 0.1 }, { name = \"knee\", unit = \"s\", value = 10.0, sd = 1.0 }]\n";
    let file = line(&format!("{LATE}{TEMPERATURE}{drift}"));
    let told = |found: Compensated| (found.document.corrected_for.clone(), found.document.notes.join("; "));
    let (names, notes) = told(corrected(&file, in_use(&true_reading()), false).unwrap());
    assert_eq!(names, ["temperature_coefficient"]);
    assert!(notes.contains("time offset: it is a clock") && notes.contains("settling: it follows the time"), "{notes}");
    let (names, _) = told(corrected(&file, in_use(&true_reading()), true).unwrap());
    assert_eq!(names, ["temperature_coefficient", "settling"]);
    let same = Recording { sha256: "b".into(), ..in_use(&true_reading()) };
    assert_eq!(told(corrected(&file, same, false).unwrap()).0, ["temperature_coefficient", "settling"]);
    let refused = corrected(&line(LATE), in_use(&true_reading()), true).err().unwrap();
    assert!(matches!(refused, CompensateError::NothingLeft { .. }) && refused.to_string().contains("clock"), "{refused}");
}

#[test]
fn a_column_that_an_effect_needs_is_asked_for_by_name() {
    let mut cold = in_use(&true_reading());
    cold.inputs.temperature_c = None;
    let refused = corrected(&line(TEMPERATURE), cold, false).err().unwrap().to_string();
    for part in ["no column for temperature", "`temperature_coefficient`", "--map temperature=COLUMN"] {
        assert!(refused.contains(part), "{refused}");
    }
    let mut timeless = in_use(&true_reading());
    timeless.inputs.time_s = None;
    let refused = corrected(&line(LAG), timeless.clone(), false).err().unwrap().to_string();
    assert!(refused.contains("no column for time") && refused.contains("`readout_lag`"), "{refused}");
    // what does not follow the clock needs none
    assert!(corrected(&line(TEMPERATURE), timeless, false).is_ok());
    let moved = "temperature_k = 0.0, load = 1.0, gap = false, simulated = false, drivers = [\"supply\"], ranges = { supply = [11.0, 13.0] }";
    let supply = "[[effect]]\nid = \"driver_coefficient\"\nparameters = [{ name = \"per_unit\", unit = \"mm/V\", value = 0.4, sd = 0.1 }, { name = \"bend\", unit = \"1/V\", value = 0.0, sd = 0.1 }]\n";
    let base = "model = \"linear\"\norder = 1\ndriver = { role = \"force\", zero = 0.0, width = 10.0 }";
    let file = model(base, &[("offset", 1.0), ("slope", 15.0)], moved, supply);
    let refused = corrected(&file, in_use(&true_reading()), false).err().unwrap().to_string();
    assert!(refused.contains("no column for supply") && refused.contains("--map driver.supply=COLUMN:UNIT"), "{refused}");
    let mut whole = in_use(&true_reading());
    whole.inputs.drivers = vec![Driver { name: "supply".into(), unit: "V".into(), values: vec![12.0; ROWS] }];
    assert!(corrected(&file, whole, false).is_ok());
}

#[test]
fn what_does_not_belong_together_is_refused() {
    let counts = Recording { response_unit: "counts".into(), ..in_use(&true_reading()) };
    assert!(matches!(corrected(&line(TEMPERATURE), counts, false).err(), Some(CompensateError::Unit { .. })));
    assert!(matches!(corrected(&line(""), in_use(&true_reading()), false).err(), Some(CompensateError::NothingAdded { .. })));
    let base = "model = \"linear\"\norder = 1\ndriver = { role = \"force\", zero = 0.0, width = 10.0 }";
    let flat = model(base, &[("offset", 1.0), ("slope", 0.0)], MOVED, TEMPERATURE);
    assert!(matches!(corrected(&flat, in_use(&true_reading()), false).err(), Some(CompensateError::StandsStill { .. })));
    // a slope that what was added has taken away: the input that the line needs is thousands of newtons
    let nearly = model(base, &[("offset", 1.0), ("slope", 1e-3)], MOVED, TEMPERATURE);
    let refused = corrected(&nearly, in_use(&true_reading()), false).err().unwrap();
    assert!(
        matches!(refused, CompensateError::HardlyMoves { .. }) && refused.to_string().contains("hardly moves with force"),
        "{refused}"
    );
}

/// Reads `1 + 1.5 F - 0.04 F^2`, F up to 10 N: with a tenth below and a fifth above, -0.54 to 13.24 mm.
fn bent() -> ModelFile {
    let base = "model = \"linear\"\norder = 2\ndriver = { role = \"force\", zero = 0.0, width = 10.0 }";
    model(base, &[("offset", 1.0), ("slope", 15.0), ("order_2", -4.0)], MOVED, TEMPERATURE)
}

/// Rows beyond what a model gives get what was added at its end. Of another sensor most are, and the answer was given with exit code 0.
#[test]
fn readings_of_another_sensor_are_refused_and_a_few_rows_beyond_are_counted() {
    let read = |beyond: usize, far: f64| -> Vec<f64> {
        let row = |row: usize| if row < beyond { far } else { 6.0 };
        (0..ROWS).map(row).zip(heat()).map(|(y, t)| y + 0.1 * (t - 20.0)).collect()
    };
    // a tenth of the range of 13.78 mm may be a zero that has moved
    let found = corrected(&bent(), in_use(&read(ROWS, 14.4)), false).unwrap();
    assert_eq!(found.document.estimated.as_ref().unwrap().rows_outside, ROWS);
    let found = corrected(&bent(), in_use(&read(ROWS / 2, 40.0)), false).unwrap();
    assert_eq!(found.document.estimated.as_ref().unwrap().rows_outside, ROWS / 2);
    assert!(
        found.document.notes.iter().any(|note| note.starts_with("in 450 of 900 rows no force")),
        "{:?}",
        found.document.notes
    );
    let refused = corrected(&bent(), in_use(&read(ROWS / 2 + 1, 40.0)), false).err().unwrap();
    assert!(matches!(refused, CompensateError::Outside { outside: 451, rows: ROWS, .. }), "{refused}");
    let told = refused.to_string();
    for part in ["in 451 of 900 rows no force", "augmented.toml", "the base model gives -0.54", "13.24 mm", "--map response="] {
        assert!(told.contains(part), "`{part}` is missing in: {told}");
    }
}

const LINE: &str = "model = \"linear\"\norder = 1\ndriver = { role = \"force\", zero = 0.0, width = 10.0 }";
const TABLE: &str = "model = \"table\"\noptions = { offset = false }\ngrid = { unit = \"mm\", axes = [{ role = \"force\", at = [0.0, 10.0] }, { role = \"temperature\", at = [0.0, 40.0] }], values = [1.0, 1.0, 16.0, 16.0] }";
const STEPS: &str =
    "[[effect]]\nid = \"offset_steps\"\nparameters = [{ name = \"size\", unit = \"mm\", value = 0.3, sd = 0.1 }]\n";

/// Why a model is not run in which `from` has become `to`.
fn refused(base: &str, numbers: &[(&str, f64)], effects: &str, from: &str, to: &str) -> String {
    let whole = text(base, numbers, MOVED, effects);
    let changed = whole.replacen(from, to, 1);
    assert_ne!(changed, whole, "there is no {from}");
    // a program has its own reference, and nothing to be scaled
    let scaled = format!("scale = {SCALE}\nreference_c = 20.0\n");
    let changed = if to.contains("model = \"command\"") { changed.replace(&scaled, "") } else { changed };
    let file = ModelFile::parse(&changed, Path::new("augmented.toml")).unwrap();
    corrected(&file, in_use(&true_reading()), false).err().unwrap().to_string()
}

/// Of these some ended in a panic or not at all, others were answered, or refused in words that mislead.
#[test]
fn numbers_that_cannot_be_are_refused_by_their_name() {
    let numbers = [("offset", 1.0), ("slope", 15.0)];
    let line = |from: &str, to: &str| refused(LINE, &numbers, &format!("{TEMPERATURE}{LAG}{STEPS}"), from, to);
    for (from, to, part) in [
        ("order = 1", "order = 4294967296", "from 1 to 6, not 4294967296"),
        ("width = 10.0", "width = 0.0", "width = 0; write a finite number above 0"),
        ("width = 10.0", "width = nan", "width = NaN"),
        ("range = 15.0", "range = inf", "range = inf"),
        ("noise_sd = 0.02", "noise_sd = nan", "noise_sd under [scales] is NaN"),
        ("noise_sd = 0.02", "noise_sd = -1.0", "noise_sd under [scales] is -1"),
        ("longest_run_s = 899.0", "longest_run_s = inf", "longest_run_s under [scales] is inf"),
        ("temperature_k = 16.0", "temperature_k = nan", "temperature_k under [scales] is NaN"),
        ("value = 15", "value = nan", "`slope` of [[parameter]] is NaN"),
        ("value = 8.0", "value = inf", "`tau` of readout_lag is inf; write a finite number"),
        ("value = 8.0", "value = -8.0", "`tau` of readout_lag is -8; write a number from 0 on"),
        (
            "runs = 1",
            "runs = 9223372036854775807",
            "the effect `offset_steps` gives no value for `jump_2`; add { name = \"jump_2\", unit = \"sizes\"",
        ),
    ] {
        let says = line(from, to);
        assert!(says.contains(part), "{to}: {says}");
    }
    for (from, to, part) in [
        (", 16.0]", "]", "3 numbers for 4 combinations"),
        ("at = [0.0, 40.0]", "at = [0.0]", "at of the axis temperature = [0.0]; write two numbers or more"),
        ("at = [0.0, 40.0]", "at = [40.0, 0.0]", "each above the one before"),
        (
            "[{ role = \"force\", at = [0.0, 10.0] }, ",
            "[{ role = \"gap\", at = [0.0, 1.0] }, { role = \"force\", at = [0.0, 10.0] }, ",
            "one axis or two",
        ),
    ] {
        let says = refused(TABLE, &[], TEMPERATURE, from, to);
        assert!(says.contains(part), "{to}: {says}");
    }
    let late = "timeout_s = -1.0\nsimulator = { unit = \"mm\", reference_c = 20.0, parameters = [] }";
    let command = format!("model = \"command\"\nrun = [\"true\"]\nfolder = \".\"\n{late}");
    let says = refused(LINE, &numbers, TEMPERATURE, LINE, &command);
    assert!(says.contains("timeout_s = -1; write a finite number above 0"), "{says}");
}

/// The first of two was taken, and nothing said of the second.
#[test]
fn a_number_or_an_effect_that_is_given_twice_is_refused() {
    let numbers = [("offset", 1.0), ("slope", 15.0)];
    let named = |from: &str, to: &str| refused(LINE, &numbers, &format!("{TEMPERATURE}{LAG}"), from, to);
    let number = |list: &str, value: f64| format!("[[{list}]]\nname = \"offset\"\nunit = \"mm\"\nvalue = {value}\nsd = 0.1\n");
    let says = named("[[parameter]]", &format!("{}[[parameter]]", number("parameter", 2.5)));
    assert!(says.contains("[[parameter]] gives `offset` twice, as 2.5 and as 1; leave one of them out"), "{says}");
    let alone = format!("{}{}[[parameter]]", number("base_alone", 1.5), number("base_alone", 2.0));
    assert!(named("[[parameter]]", &alone).contains("[[base_alone]] gives `offset` twice, as 1.5 and as 2"));
    let tau = "{ name = \"tau\", unit = \"s\", value = 8.0, sd = 0.1 }";
    assert!(named(tau, &format!("{tau}, {tau}")).contains("readout_lag gives `tau` twice, as 8 and as 8"));
    let says = named(LAG, &format!("{LAG}{LAG}"));
    assert!(says.contains("[[effect]] adds `readout_lag` twice; leave one of them out"), "{says}");
}

/// What is too large for its square is told as it is; what is too large itself is refused, by its row.
#[test]
fn no_answer_holds_a_number_that_is_none() {
    let file = line(TEMPERATURE);
    let mut recording = in_use(&true_reading());
    recording.inputs.force_n = Some(vec![1e200; ROWS]);
    let error = corrected(&file, recording, false).unwrap().document.error.unwrap();
    approx::assert_relative_eq!(error.before, 1.5e200, max_relative = 1e-9);
    let mut wide = in_use(&true_reading());
    (wide.response[0], wide.response[1]) = (-1e308, 1e308);
    let refused = corrected(&file, wide, false).err().unwrap();
    assert!(
        matches!(refused, CompensateError::Range { .. }) && refused.to_string().contains("from -1e308 to 1e308 mm"),
        "{refused}"
    );
}

/// Rows are counted from 1, as in every other message.
#[test]
fn a_row_without_an_answer_is_told_by_its_number() {
    let mut hot = in_use(&true_reading());
    hot.inputs.temperature_c.as_mut().unwrap()[4] = 90.0;
    let says = corrected(&model(TABLE, &[], MOVED, TEMPERATURE), hot, false).err().unwrap().to_string();
    assert!(says.starts_with("recording, row 5: temperature is 90"), "{says}");
}

/// A file of the user's is not written over; an earlier result is.
#[test]
fn rows_are_written_where_nothing_is_lost() {
    let folder = tempfile::tempdir().unwrap();
    let found = corrected(&line(TEMPERATURE), in_use(&true_reading()), false).unwrap();
    let (mine, out) = (folder.path().join("mine.csv"), folder.path().join("out.csv"));
    std::fs::write(&mine, "time_s,reading\n1,2\n").unwrap();
    assert!(matches!(found.write(&mine), Err(CompensateError::WouldBeLost { .. })));
    (0..2).for_each(|_| found.write(&out).unwrap());
    assert_eq!(std::fs::read_to_string(&out).unwrap(), found.csv());
    assert_eq!(std::fs::read_dir(folder.path()).unwrap().count(), 2);
}
