//! Files that attacks begin with: sound ones, to be spoilt in one place each.

use std::f64::consts::TAU;
use std::fmt::Write;
use truegap_core::sensor::builtin_sensors;

/// Name of the sensor that attacks are about.
pub const SENSOR: &str = "singletact-s15-4.5n";

/// The built-in sensor's file with one piece of it changed.
pub fn sensor(from: &str, to: &str) -> String {
    let text = builtin_sensors()[0].toml;
    assert!(text.contains(from), "the built-in sensor no longer says `{from}`");
    text.replace(from, to)
}

/// The built-in sensor under another name, as it stands in TOML.
pub fn sensor_named(name: &str) -> String {
    sensor(&format!("name = \"{SENSOR}\""), &format!("name = {}", quoted(name)))
}

/// A text as TOML writes it.
pub fn quoted(text: &str) -> String {
    toml::Value::from(text).to_string()
}

/// Two hundred rows that look like the sensor's, under a header.
pub fn csv(header: &str) -> String {
    let mut text = format!("{header}\n");
    for row in 0..200 {
        let t = f64::from(row);
        let force = 2.25 * (1.0 - (TAU * t / 50.0).cos());
        let noise = 0.01 * ((t * 12.9898).sin() * 43_758.545_3).fract();
        // a String takes everything
        let _ = writeln!(text, "{t},{force:.6},{:.6},{:.6}", 20.0 + 5.0 * (t / 40.0).sin(), 234.6 + 4.0 * force + noise);
    }
    text
}

/// Header of [`csv`].
pub const HEADER: &str = "time_s,force_n,temperature_c,capacitance_pf";

/// An electrostatic case between two sides of a square; `regions` and `mesh` are put in.
pub fn case(regions: &str, mesh: &str) -> String {
    let head = "schema = \"truegap.case/1\"\nphysics = \"electrostatics\"\nsymmetry = \"planar\"\nlength_unit = \"mm\"\n[material.air]\nrelative_permittivity = 1.0\n";
    let sides = "[[boundary]]\nname = \"low\"\npath = [[0, 0], [1, 0]]\npotential = \"0 V\"\n[[boundary]]\nname = \"high\"\npath = [[0, 1], [1, 1]]\npotential = \"1 V\"\n";
    format!("{head}{regions}{sides}[mesh]\n{mesh}\n[[output]]\nname = \"C\"\nkind = \"capacitance\"\nboundary = \"high\"\n")
}

/// A region of a case.
pub fn region(name: &str, polygon: &str) -> String {
    format!("[[region]]\nname = {}\nmaterial = \"air\"\npolygon = {polygon}\n", quoted(name))
}

/// The square between the sides.
pub const SQUARE: &str = "[[0, 0], [1, 0], [1, 1], [0, 1]]";

/// A case without a fault.
pub fn square() -> String {
    case(&region("space", SQUARE), "max_edge = \"0.3 mm\"")
}

/// A polygon of many corners around the square.
pub fn polygon(corners: usize) -> String {
    let corner = |k: usize| {
        let angle = TAU * k as f64 / corners as f64;
        format!("[{}, {}]", 0.5 + angle.cos(), 0.5 + angle.sin())
    };
    format!("[{}]", (0..corners).map(corner).collect::<Vec<_>>().join(", "))
}
