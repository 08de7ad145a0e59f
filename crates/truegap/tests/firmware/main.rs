//! Firmware in C: compiled, run along readings, and compared with closed forms and with the correction on a computer.

#![allow(clippy::unwrap_used)]

mod bench;
#[path = "../common/late.rs"]
mod late;

use bench::*;
use late::late;
use std::path::Path;
use truegap::core::recording::BaseSpec;
use truegap::core::{Inputs, Recording};
use truegap::diagnosis::compensate::firmware::{Asked, FirmwareError, firmware_of};
use truegap::diagnosis::compensate::{CompensateError, Wanted, compensate_with};
use truegap::models::{ModelFile, Programs};

/// The corrected column of `truegap compensate`.
fn on_a_computer(file: &ModelFile, read: &[f64]) -> Vec<f64> {
    let time_s = Some((0..ROWS).map(|row| row as f64).collect());
    let inputs = Inputs { time_s, run: vec![1; ROWS], temperature_c: Some(heat()), ..Inputs::default() };
    let recording = Recording::new(inputs, read.to_vec(), "mm", BaseSpec::default()).unwrap();
    let found =
        compensate_with(file, Path::new("augmented.toml"), recording, None, Wanted::default(), &Programs::default()).unwrap();
    found.table().into_iter().find(|(name, _)| name == "corrected").unwrap().1
}

#[test]
fn a_bent_temperature_coefficient_is_taken_out_within_the_stated_error() {
    let file = model(LINE, MOVED, &heat_coefficient());
    let made = made(&file).unwrap();
    let facts = &made.document;
    // what heat adds does not depend on the reading
    assert_eq!((facts.reading_nodes, facts.readings, facts.state_bytes), (1, None, 8));
    assert!(facts.error > 0.0 && facts.error <= 0.1 * SD && facts.is_exact(), "{}", facts.says);
    // straight lines over steps h of a parabola are off by its bend, 0.001 mm/K^2, times h^2 / 8
    let argument = &facts.arguments[0];
    let step = (argument.high - argument.low) / (argument.nodes - 1) as f64;
    approx::assert_relative_eq!(facts.error, 0.001 * step * step / 8.0, max_relative = 1e-6);
    assert_eq!(facts.table_bytes, 4 * facts.arguments[0].nodes);
    if !there_is_a_compiler() {
        return;
    }
    let truth = each([&force()], |[f]| straight(f));
    let read = each([&truth, &heat()], |[y, t]| y + warmth(t));
    let (found, outside) = run(&made, &[&second(), &read, &heat()]);
    // a float has 24 bits: 1e-6 of 16 mm
    assert!(largest(&found, &truth) <= facts.error + 3e-6 && outside == 0, "{} of {}", largest(&found, &truth), facts.error);
    assert!(largest(&found, &on_a_computer(&file, &read)) <= facts.error + 3e-6);
}

/// Without the ends of the temperature a table went as far to both sides of the reference as it had moved in all: twice too wide.
#[test]
fn a_table_goes_as_far_as_the_temperature_went() {
    let of = |moved: &str| {
        let argument = made(&model(LINE, moved, &heat_coefficient())).unwrap().document.arguments[0].clone();
        [argument.low, argument.high]
    };
    let near = |found: [f64; 2], exact: [f64; 2]| {
        found.iter().zip(exact).for_each(|(found, exact)| approx::assert_relative_eq!(*found, exact, max_relative = 1e-12));
    };
    near(of(&format!("temperature_c = [14.0, 30.0], {MOVED}")), [14.0 - 1.6, 30.0 + 1.6]);
    near(of(MOVED), [20.0 - 17.6, 20.0 + 17.6]);
}

/// `y = c (1 + k (T - 20))` about the reading of no load, 1 mm, on a parabola.
#[test]
fn a_gain_that_drifts_on_a_bent_base_is_taken_out_within_the_stated_error() {
    let file = model(BENT, MOVED, &effect("gain_drift", &[("per_kelvin", "1/K", 0.004)]));
    let made = made(&file).unwrap();
    let facts = &made.document;
    assert!(facts.reading_nodes > 1 && facts.arguments[0].nodes > 1 && facts.is_exact(), "{}", facts.says);
    assert!(facts.table_bytes <= 16_384, "{}", facts.table_bytes);
    if !there_is_a_compiler() {
        return;
    }
    let truth = each([&force()], |[f]| bent(f));
    let read = each([&truth, &heat()], |[y, t]| 1.0 + (y - 1.0) * (1.0 + 0.004 * (t - 20.0)));
    assert!(rms(&read, &truth) > 3.0 * SD);
    let (found, outside) = run(&made, &[&second(), &read, &heat()]);
    let worst = largest(&found, &truth);
    assert!(worst <= facts.error + 5e-6 && outside == 0, "{worst} of {}", facts.error);
    // passes on a computer end where what is left is noise
    assert!(rms(&found, &on_a_computer(&file, &read)) < SD);
}

#[test]
fn a_late_reading_is_caught_up_as_far_as_the_noise_may_grow() {
    let file = model(LINE, MOVED, &format!("{}{}", heat_coefficient(), lag()));
    let made = made(&file).unwrap();
    let undone = made.document.undone.as_ref().unwrap();
    assert_eq!((undone.tau_s, undone.most_growth), (8.0, 10.0));
    assert!(undone.growth.unwrap() <= 10.0 && undone.left_s < 1.25, "{undone:?}");
    if !there_is_a_compiler() {
        return;
    }
    let truth = each([&force()], |[f]| straight(f));
    let warm = each([&truth, &heat()], |[y, t]| y + warmth(t));
    let read = late(&warm, 8.0);
    let (found, _) = run(&made, &[&second(), &read, &heat()]);
    // 1.2 s are left of 8 s
    let (before, after) = (rms(&late(&truth, 8.0), &truth), rms(&found, &truth));
    assert!(before > 20.0 * SD && after < 0.2 * before, "{after} of {before}");
    assert!(rms(&found, &on_a_computer(&file, &read)) < 0.2 * before);
    // noise alone: by a two-valued column without an order it grows as is stated
    let rest = vec![straight(5.0); ROWS];
    let noise: Vec<f64> = (0..ROWS).map(|row| if (row * row / 7 + row / 3) % 2 == 0 { SD } else { -SD }).collect();
    let cold = vec![20.0; ROWS];
    let (still, _) = run(&made, &[&second(), &each([&rest, &noise], |[y, e]| y + e), &cold]);
    let grown = rms(&still[100..], &rest[100..]) / SD;
    assert!(grown < 10.0, "{grown}");
}

/// A lag alone has nothing for a table, and less noise where less is asked for.
#[test]
fn a_lag_alone_is_undone_with_the_noise_that_is_asked_for() {
    let asked = Asked { noise_growth: 3.0, ..Asked::default() };
    let made = firmware_of(&model(LINE, MOVED, &lag()), Path::new("augmented.toml"), &asked).unwrap();
    let undone = made.document.undone.as_ref().unwrap();
    assert_eq!((made.document.table_bytes, made.document.error, made.document.state_bytes), (4, 0.0, 16));
    // (1 + u)^2 + u^2 = 9 at u = 1.56
    approx::assert_relative_eq!(undone.left_s, 8.0 / 1.5616, max_relative = 1e-4);
    if !there_is_a_compiler() {
        return;
    }
    // behind a ramp what is left of the lag is a delay
    let ramp = column(|t| 0.1 * t);
    let (found, outside) = run(&made, &[&second(), &late(&ramp, 8.0)]);
    let behind = (ramp[ROWS - 1] - found[ROWS - 1]) / 0.1;
    assert!((behind - (undone.left_s - 1.0)).abs() < 1e-3 && outside == 0, "{behind}");
}

/// Heat that takes 60 s to arrive, beside a coefficient of what has arrived.
#[test]
fn an_input_that_comes_late_is_stepped_exactly() {
    let lag = effect(
        "thermal_lag",
        &[("tau", "s", 60.0), ("slow_share", "1", 0.0), ("slower", "1", 10.0), ("before", "K/s", 0.0), ("first_stage", "1", 0.0)],
    );
    let file = model(LINE, MOVED, &format!("{lag}{}", heat_coefficient()));
    let made = made(&file).unwrap();
    assert_eq!(made.document.corrected_for, ["thermal_lag", "temperature_coefficient"]);
    assert_eq!(made.document.state_bytes, 20);
    if !there_is_a_compiler() {
        return;
    }
    let truth = each([&force()], |[f]| straight(f));
    let read = each([&truth, &late(&heat(), 60.0)], |[y, t]| y + warmth(t));
    let (found, outside) = run(&made, &[&second(), &read, &heat()]);
    let worst = largest(&found, &truth);
    assert!(worst <= made.document.error + 5e-6 && outside == 0, "{worst}");
    // a thousand times as many steps of a thousandth: nothing is lost by rounding
    let (times, rows) = (200, 300);
    let fine = |column: &[f64]| -> Vec<f64> {
        let between = |row: usize| (1..=times).map(move |k| (row, k as f64 / f64::from(times)));
        std::iter::once(column[0])
            .chain((0..rows).flat_map(between).map(|(row, s)| column[row] + s * (column[row + 1] - column[row])))
            .collect()
    };
    let (dt, heat) = (vec![1.0 / f64::from(times); rows * times as usize + 1], fine(&heat()));
    let (found, _) = run(&made, &[&dt, &vec![5.0; heat.len()], &heat]);
    let slow = each([&late(&self::heat(), 60.0)], |[t]| 5.0 - warmth(t));
    let at_rows: Vec<f64> = found.iter().step_by(times as usize).copied().collect();
    let worst = largest(&at_rows, &slow[..=rows]);
    assert!(worst <= made.document.error + 1e-5, "{worst}");
}

/// A first stage of 30 s, then a quick part of 20 s and a part of 80 s, a half of each: the mean of both is 50 s.
#[test]
fn heat_that_comes_by_two_ways_behind_a_first_stage_is_stepped_as_well() {
    let lag = effect(
        "thermal_lag",
        &[("tau", "s", 50.0), ("slow_share", "1", 0.5), ("slower", "1", 4.0), ("before", "K/s", 0.0), ("first_stage", "1", 0.6)],
    );
    let made = made(&model(LINE, MOVED, &format!("{lag}{}", heat_coefficient()))).unwrap();
    assert_eq!(made.document.state_bytes, 8 + 3 * 12);
    if !there_is_a_compiler() {
        return;
    }
    let first = late(&heat(), 30.0);
    let arrived = each([&late(&first, 20.0), &late(&first, 80.0)], |[quick, slow]| 0.5 * (quick + slow));
    let truth = each([&force()], |[f]| straight(f));
    let read = each([&truth, &arrived], |[y, t]| y + warmth(t));
    let (found, _) = run(&made, &[&second(), &read, &heat()]);
    let worst = largest(&found, &truth);
    assert!(worst <= made.document.error + 5e-6, "{worst}");
}

/// Gain by heat on a parabola, and a driver beside it: a table over three axes.
#[test]
fn a_gain_and_a_driver_are_taken_out_by_one_table_of_three_axes() {
    let moved = "temperature_k = 16.0, load = 1.0, gap = false, simulated = false, drivers = [\"supply\"], ranges = { supply = [0.0, 2.0] }";
    let both = effect("gain_drift", &[("per_kelvin", "1/K", 0.004)])
        + &effect("driver_coefficient", &[("per_unit", "mm/V", 0.4), ("bend", "1/V", 0.2)]);
    let made = made(&model(BENT, moved, &both)).unwrap();
    let facts = &made.document;
    assert!(facts.is_exact() && facts.reading_nodes > 1 && facts.arguments.iter().all(|a| a.nodes > 1), "{}", facts.says);
    if !there_is_a_compiler() {
        return;
    }
    let driver = column(|t| 1.0 + (t / 23.0).sin());
    let truth = each([&force()], |[f]| bent(f));
    let read =
        each([&truth, &heat(), &driver], |[y, t, x]| 1.0 + (y - 1.0) * (1.0 + 0.004 * (t - 20.0)) + 0.4 * x * (1.0 + 0.1 * x));
    let (found, outside) = run(&made, &[&second(), &read, &heat(), &driver]);
    let worst = largest(&found, &truth);
    assert!(worst <= facts.error + 5e-6 && outside == 0, "{worst} of {}", facts.error);
}

#[test]
fn beyond_the_table_its_edge_holds_and_is_counted_and_no_number_changes_nothing() {
    if !there_is_a_compiler() {
        return;
    }
    let made = made(&model(LINE, MOVED, &heat_coefficient())).unwrap();
    let (found, outside) = run(&made, &[&[1.0; 4], &[7.0, 7.0, f64::NAN, 7.0], &[20.0, 90.0, 20.0, f64::INFINITY]]);
    // 16 K and a tenth of that to either side of 20 degC
    approx::assert_abs_diff_eq!(found[0], 7.0, epsilon = made.document.error + 1e-6);
    approx::assert_abs_diff_eq!(found[1], 7.0 - warmth(37.6), epsilon = 1e-6);
    assert!(found[2].is_nan() && found[3].is_nan() && outside == 1, "{found:?} {outside}");
}

/// A wind that acts at once on one way and 40 s late on another: the same column twice.
#[test]
fn a_driver_that_acts_at_once_and_late_is_followed_twice() {
    let moved = "temperature_k = 0.0, load = 1.0, gap = false, simulated = false, drivers = [\"switch\"], ranges = { switch = [0.0, 2.0] }";
    let both = effect("driver_coefficient", &[("per_unit", "mm/V", 0.4), ("bend", "1/V", 0.2)])
        + &effect("late_driver", &[("per_unit", "mm/V", 0.3), ("tau", "s", 40.0)]);
    let made = made(&model(LINE, moved, &both)).unwrap();
    let argument = &made.document.arguments[0];
    // a word of C is no name of an argument
    assert_eq!((argument.name.as_str(), argument.late_nodes), ("switch_", Some(2)));
    assert!(argument.nodes > 2 && made.document.is_exact(), "{}", made.document.says);
    if !there_is_a_compiler() {
        return;
    }
    let driver = column(|t| 1.0 + (t / 23.0).sin());
    let truth = each([&force()], |[f]| straight(f));
    let read = each([&truth, &driver, &late(&driver, 40.0)], |[y, x, slow]| y + 0.4 * x * (1.0 + 0.1 * x) + 0.3 * slow);
    let (found, _) = run(&made, &[&second(), &read, &driver]);
    let worst = largest(&found, &truth);
    assert!(worst <= made.document.error + 5e-6, "{worst}");
}

/// A tenth of the slope stands in a mechanism that the model only carries: it stays in the reading.
#[test]
fn what_is_only_carried_stays_in_the_reading_unless_it_is_asked_for() {
    let carried = "[[effect]]\nid = \"discovered\"\ncarried = true\nparameters = [{ name = \"size\", unit = \"mm\", value = 1.5, sd = 0.1 }]\n\
        [effect.mechanism]\nquantity = \"reading\"\naction = \"adds\"\ndriver = \"load\"\nkinetics = \"static\"\nform = \"linear\"\neven = false\nbelow = false\npassing = false\n";
    let file = model(LINE, MOVED, &format!("{}{carried}", heat_coefficient()));
    let left = made(&file).unwrap();
    assert_eq!(
        (left.document.corrected_for.as_slice(), left.document.reading_nodes),
        (&["temperature_coefficient".to_owned()][..], 1)
    );
    let all = firmware_of(&file, Path::new("augmented.toml"), &Asked { carried: true, ..Asked::default() }).unwrap();
    assert_eq!(all.document.corrected_for, ["temperature_coefficient", "discovered"]);
    assert!(made(&model(LINE, MOVED, carried)).err().unwrap().to_string().contains("carries it without a claim"));
    if !there_is_a_compiler() {
        return;
    }
    // the reading of the whole model, 1 + 1.65 F and heat
    let whole = each([&force()], |[f]| 1.0 + 1.65 * f);
    let read = each([&whole, &heat()], |[y, t]| y + warmth(t));
    let [stays, goes] = [&left, &all].map(|made| run(made, &[&second(), &read, &heat()]).0);
    let truth = each([&force()], |[f]| straight(f));
    let (kept, taken) = (largest(&stays, &whole), largest(&goes, &truth));
    assert!(kept <= left.document.error + 5e-6 && taken <= all.document.error + 5e-6, "{kept} {taken}");
}

/// A base that is a value alone has no input: what heat adds is all there is to take out.
#[test]
fn a_value_that_should_stand_still_is_freed_of_its_heat() {
    let base = "model = \"constant\"";
    let text = model(base, MOVED, &heat_coefficient());
    let made = made(&text).unwrap();
    assert_eq!(made.document.reading_nodes, 1);
}

fn refused(base: &str, moved: &str, effects: &str) -> String {
    made(&model(base, moved, effects)).err().unwrap().to_string()
}

#[test]
fn what_no_firmware_can_do_is_refused_with_its_reason() {
    let nothing = made(&model(LINE, MOVED, "")).err().unwrap();
    assert!(matches!(nothing, FirmwareError::Compensate(CompensateError::NothingAdded { .. })), "{nothing}");
    let says = refused(LINE, MOVED, &play());
    assert!(says.contains("it depends on what came before") && says.contains("nothing else was added"), "{says}");
    let drift = effect("settling", &[("per_decade", "mm", 0.3), ("knee", "s", 10.0)]);
    let says = refused(LINE, MOVED, &drift);
    assert!(says.contains("it follows the time since the first row"), "{says}");
    let command = "model = \"command\"\nrun = [\"true\"]\nfolder = \".\"\ntimeout_s = 1.0\nsimulator = { unit = \"mm\", reference_c = 20.0, parameters = [] }";
    let says = refused(command, MOVED, &heat_coefficient());
    assert!(says.contains("`command` may answer a row by the rows before it"), "{says}");
    let moved = "temperature_k = 16.0, load = 1.0, gap = false, simulated = false, drivers = [\"flow\", \"supply\"], ranges = { flow = [0.0, 2.0], supply = [11.0, 13.0] }";
    let driver = |id: &str| effect(id, &[("per_unit", "mm/V", 0.4), ("bend", "1/V", 0.1)]);
    let three = format!("{}{}{}", heat_coefficient(), driver("driver_coefficient"), driver("second_driver_coefficient"));
    let says = refused(LINE, moved, &three);
    assert!(says.contains("follows 3 columns besides the reading (temperature, flow and supply)"), "{says}");
}

/// Above a ceiling readings say nothing, and below it nothing was added.
#[test]
fn a_hard_limit_is_no_correction() {
    let clipped = |lost: f64| effect("saturation", &[("lost", "1", lost), ("knee", "spans", 0.7)]);
    let says = refused(LINE, MOVED, &clipped(1.0));
    assert!(says.contains("what was added for saturation moves no reading"), "{says}");
    // where a tenth of the slope is left, ten times the noise is
    let made = made(&model(LINE, MOVED, &clipped(0.9))).unwrap();
    assert!(made.document.is_exact() && (9.5..=10.0).contains(&made.document.table_growth), "{}", made.document.says);
}

#[test]
fn a_play_is_left_out_by_name_beside_what_can_be_corrected() {
    let made = made(&model(LINE, MOVED, &format!("{}{}", play(), heat_coefficient()))).unwrap();
    assert_eq!(made.document.corrected_for, ["temperature_coefficient"]);
    assert!(made.source.contains("Not corrected for friction: it depends on what came before"), "{}", made.source);
}

/// Two ways of the reading, a quick and a slow one, are no lag by one time constant.
#[test]
fn a_lag_of_two_time_constants_is_left_out() {
    let slow =
        effect("slow_response", &[("tau", "s", 8.0), ("slow_share", "1", 0.4), ("slower", "1", 10.0), ("before", "mm/s", 0.0)]);
    let both = made(&model(LINE, MOVED, &format!("{}{slow}", heat_coefficient()))).unwrap();
    assert!(
        both.document.undone.is_none() && both.document.left_out[0].why.contains("no lag of the whole reading"),
        "{:?}",
        both.document.left_out
    );
    let quick = slow.replace("value = 0.4", "value = 0.0");
    let one = made(&model(LINE, MOVED, &format!("{}{quick}", heat_coefficient()))).unwrap();
    assert_eq!(one.document.undone.unwrap().tau_s, 8.0);
}

#[test]
fn a_file_of_somebody_is_not_written_over_and_an_earlier_result_is() {
    let folder = tempfile::tempdir().unwrap();
    let made = made(&model(LINE, MOVED, &heat_coefficient())).unwrap();
    let (mine, out) = (folder.path().join("mine.c"), folder.path().join("correction.c"));
    std::fs::write(&mine, "/* mine */\n").unwrap();
    assert!(matches!(made.write(&mine), Err(FirmwareError::WouldBeLost { .. })));
    (0..2).for_each(|_| made.write(&out).unwrap());
    assert_eq!(std::fs::read_to_string(&out).unwrap(), made.source);
    assert!(matches!(made.write(&mine.join("correction.c")), Err(FirmwareError::Write(_))));
}

#[test]
fn ranges_and_limits_are_as_asked() {
    let file = model(LINE, MOVED, &heat_coefficient());
    let with = |asked: &Asked| firmware_of(&file, Path::new("augmented.toml"), asked);
    let mut wide = Asked::default();
    wide.add_range("temperature=-10:60").unwrap();
    let made = with(&wide).unwrap();
    assert_eq!((made.document.arguments[0].low, made.document.arguments[0].high), (-10.0, 60.0));
    assert!(made.document.notes[0].contains("beyond the 2.40 to 37.6 that the model file knows"), "{:?}", made.document.notes);
    for (text, why) in
        [("temperature", "no `=`"), ("temperature=5", "no `:`"), ("temperature=5:x", "no number"), ("temperature=5:5", "go up")]
    {
        let says = Asked::default().add_range(text).unwrap_err().to_string();
        assert!(says.contains(why) && says.contains("NAME=LOW:HIGH"), "{says}");
    }
    let mut wrong = Asked::default();
    wrong.add_range("warmth=1:2").unwrap();
    assert!(with(&wrong).err().unwrap().to_string().contains("it follows reading and temperature"));
    let mut wider = Asked { bytes: 32, ..Asked::default() };
    wider.add_range("temperature=-60:140").unwrap();
    let says = with(&wider).err().unwrap().to_string();
    assert!(says.contains("at most 32 bytes") && says.contains("--bytes"), "{says}");
    // between a tenth of the noise and the noise it is written, and told
    let coarse = with(&Asked { bytes: 32, ..wide }).unwrap().document;
    assert!(!coarse.is_exact() && coarse.notes[0].contains("more than the"), "{:?}", coarse.notes);
    assert!(matches!(with(&Asked { noise_growth: 2.0, ..Asked::default() }), Err(FirmwareError::Option { .. })));
}
