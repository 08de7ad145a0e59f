//! Sensor files: what is read, and that each mistake is named with its line, its value and a remedy.
#![allow(clippy::unwrap_used)]

use truegap_core::{
    Sensor,
    sensor::{Filling, Layout, SensorProblem, builtin_sensor, builtin_sensors},
};

/// The default sensor's file with one piece of text changed.
fn with(old: &str, new: &str) -> Result<Sensor, truegap_core::sensor::SensorError> {
    let text = builtin_sensors()[0].toml;
    assert!(text.contains(old), "the default sensor has no `{old}`");
    Sensor::from_toml(&text.replacen(old, new, 1), "mine.toml")
}

/// The message of a mistake, which must name the file, the line of the changed text, and what else is asked for.
fn message(old: &str, new: &str, parts: &[&str]) -> String {
    let error = with(old, new).unwrap_err();
    let message = error.to_string();
    let before = builtin_sensors()[0].toml.split(old).next().unwrap();
    let line = 1 + before.matches('\n').count();
    for part in parts.iter().copied().chain(["mine.toml", format!("line {line}").as_str()]) {
        assert!(message.contains(part), "`{part}` is not in: {message}");
    }
    message
}

#[test]
fn every_built_in_sensor_is_sound_and_carries_its_own_name() {
    assert_eq!(builtin_sensors().len(), 6);
    for built_in in builtin_sensors() {
        let sensor = built_in.sensor().unwrap();
        assert_eq!(sensor.name, built_in.name);
        assert!(sensor.description.len() > 40 && sensor.stray.sd > 0.0);
        assert_eq!(builtin_sensor(built_in.name).unwrap().unwrap(), sensor);
    }
    assert!(builtin_sensor("no-such-sensor").is_none());
}

#[test]
fn the_default_sensor_is_the_one_of_the_conventions() {
    let s = builtin_sensors()[0].sensor().unwrap();
    let Filling::Beads { count, diameter } = s.dielectric.filling else { panic!("beads") };
    let rubber = &s.dielectric.layer;
    assert_eq!((count, s.layout, s.full_scale, s.reference_c), (65, Layout::Shielded, 4.5, 20.0));
    let near = |a: f64, b: f64| approx::assert_relative_eq!(a, b, max_relative = 1e-14);
    near(diameter.value, 700e-6);
    near(diameter.sd, 14e-6);
    near(rubber.material.young.value, 1.075e6);
    near(rubber.material.young.sd, 0.05 * 1.075e6);
    near(rubber.material.softening.value, -7600.0);
    near(rubber.material.softening.sd, 1140.0);
    near(rubber.thickness.sd, 5e-6);
    near(s.insulator.thickness.sd, 0.03 * 25e-6);
    near(s.conductor.material.young.value, 117e9);
    near(s.plating.unwrap().material.expansion, 22.4e-6);
    near(rubber.material.poisson, 0.49);
    near(s.stray.sd, 0.3e-12);
    near(s.tail.1, 1e-4);
}

#[test]
fn examples_show_the_other_kinds() {
    let get = |name: &str| builtin_sensor(name).unwrap().unwrap();
    assert_eq!(get("foam-s15").dielectric.filling, Filling::Solid { coverage: 1.0 });
    assert!(get("single-metal-s15").plating.is_none());
    assert_eq!(get("mutual-s10").layout, Layout::Mutual);
    assert_eq!(get("mutual-s10").insulator.material.name, "ptfe");
}

#[test]
fn a_negative_thickness_is_named_with_its_value_and_line() {
    message(
        "conductor = { material = \"copper\", thickness = \"34 um +- 5 %\"",
        "conductor = { material = \"copper\", thickness = \"-34 um\"",
        &["electrode.conductor.thickness", "-34 um", "greater than 0"],
    );
}

#[test]
fn beads_that_cover_more_than_the_electrode_are_refused() {
    // 400 beads of 700 um are 153.9 mm2 of 176.7 mm2, 460 are 177.0 mm2
    assert!(matches!(
        with("count = 65", "count = 460").unwrap_err().problem,
        SensorProblem::BeadsCoverElectrode { count: 460, .. }
    ));
    message("beads = { count = 65", "beads = { count = 460", &["177.03 mm2", "176.71 mm2", "fewer or smaller beads"]);
    assert!(with("count = 65", "count = 400").is_ok());
}

/// 440 beads of 700 um: they meet at a strain of (sqrt(176.71 / 169.33) - 1) / 0.49 = 0.04402, that is at 169.33e-6 x 1.075e6 x e (1 + nu e)^2 = 8.36 N.
#[test]
fn beads_that_meet_before_full_load_are_refused() {
    let text = builtin_sensors()[0].toml.replacen("count = 65", "count = 440", 1);
    assert!(Sensor::from_toml(&text, "mine.toml").is_ok());
    let error = Sensor::from_toml(&text.replacen("4.5 N\"\n", "9 N\"\n", 1), "mine.toml").unwrap_err();
    assert!(matches!(error.problem, SensorProblem::BeadsMeet { limit_n, .. } if (limit_n - 8.361).abs() < 0.01), "{error}");
    assert!(error.to_string().contains("line 7"), "{error}");
}

/// 65 beads close at A E (1 + nu)^2 = 25.015e-6 x 1.075e6 x 2.2201 = 59.70 N.
#[test]
fn a_full_load_that_closes_the_gap_is_refused() {
    message("full_scale = \"4.5 N\"", "full_scale = \"60 N\"", &["full_scale", "60 N", "59.70", "lower full_scale"]);
    assert!(with("full_scale = \"4.5 N\"", "full_scale = \"45 N\"").is_ok());
}

#[test]
fn a_poisson_ratio_of_one_half_is_refused() {
    message("young = \"1.075 MPa", "poisson = 0.5\nyoung = \"1.075 MPa", &["materials.silicone.poisson", "0.5", "0.49"]);
}

#[test]
fn keys_that_mean_nothing_are_refused_with_those_that_do() {
    message("width = \"0.1 mm\"", "widht = \"0.1 mm\"\nwidth = \"0.1 mm\"", &["tail.widht", "length, width"]);
    message("softening = ", "sofening = ", &["materials.silicone.sofening", "young, softening, poisson"]);
    message("full_scale = ", "colour = \"red\"\nfull_scale = ", &["`colour`", "layout"]);
}

#[test]
fn wrong_units_words_and_types_are_named() {
    message("height = \"162 um", "height = \"162", &["dielectric.height", "no unit"]);
    message("height = \"162 um", "height = \"162 N", &["dielectric.height", "Length"]);
    message("layout = \"shielded\"", "layout = \"shield\"", &["layout", "shielded, mutual"]);
    message("count = 65", "count = 65.5", &["dielectric.beads.count", "whole number"]);
    message("length = \"40 mm\"", "length = 40", &["tail.length", "unit"]);
    message("material = \"polyimide\"", "material = \"kapton\"", &["kapton", "polyimide", "[materials.kapton]"]);
    message("schema = \"truegap.sensor/1\"", "schema = \"truegap.sensor/9\"", &["truegap.sensor/9", "truegap.sensor/1"]);
}

#[test]
fn what_is_missing_is_named_with_an_example() {
    for (line, key) in [
        ("full_scale = \"4.5 N\"", "full_scale"),
        ("width = \"0.1 mm\"", "tail.width"),
        ("thickness = \"25 um +- 3 %\"", "insulator.thickness"),
    ] {
        let error = with(line, "").unwrap_err();
        assert!(matches!(error.problem, SensorProblem::Missing { .. }) && error.key == key, "{error}");
    }
    let error = with("young = \"1.075 MPa +- 5 %\"", "").unwrap_err();
    assert!(error.to_string().contains("materials.silicone.young"), "{error}");
}

#[test]
fn text_that_is_not_toml_is_named_with_its_line() {
    message("full_scale = \"4.5 N\"", "full_scale = 4.5 N", &["not TOML"]);
    assert!(Sensor::from_toml("", "empty.toml").unwrap_err().to_string().contains("schema"));
}

#[test]
fn a_file_may_override_a_material_and_add_its_own() {
    let copper = with("young = \"1.075 MPa", "young = \"1.2 MPa").unwrap();
    assert_eq!(copper.dielectric.layer.material.young.value, 1.2e6);
    let text = builtin_sensors()[0].toml.replace("material = \"copper\"", "material = \"brass\"");
    let brass = "\n[materials.brass]\nyoung = \"100 GPa\"\npoisson = 0.35\nexpansion = \"19 ppm/K\"\n";
    let sensor = Sensor::from_toml(&format!("{text}{brass}"), "mine.toml").unwrap();
    assert_eq!(sensor.conductor.material.young.value, 100e9);
    assert_eq!(sensor.conductor.material.name, "brass");
}
