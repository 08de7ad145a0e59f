//! Model files, histories of a sensor in closed form, and a program in C that is given them.

use std::io::Write as _;
use std::path::Path;
use std::process::{Command, Stdio};
use truegap::diagnosis::compensate::firmware::{Asked, Firmware, FirmwareError, firmware_of};
use truegap::models::{MODEL_SCHEMA, ModelFile};

pub const ROWS: usize = 900;
pub const SD: f64 = 0.02;
pub const SCALE: &str =
    r#"{ unit = "mm", centre = 8.5, range = 15.0, at_rest = 1.0, span = 15.0, gaps_m = [0.0, 0.0], response_times_gap = 1.0 }"#;
pub const LINE: &str = "model = \"linear\"\norder = 1\ndriver = { role = \"force\", zero = 0.0, width = 10.0 }";
pub const BENT: &str = "model = \"linear\"\norder = 2\ndriver = { role = \"force\", zero = 0.0, width = 10.0 }";
pub const MOVED: &str = "temperature_k = 16.0, load = 1.0, gap = false, simulated = false, drivers = []";

/// An effect with its numbers.
pub fn effect(id: &str, numbers: &[(&str, &str, f64)]) -> String {
    let number = |(name, unit, value): &(&str, &str, f64)| {
        format!("{{ name = \"{name}\", unit = \"{unit}\", value = {value:?}, sd = 0.01 }}")
    };
    let numbers: Vec<String> = numbers.iter().map(number).collect();
    format!("[[effect]]\nid = \"{id}\"\nparameters = [{}]\n", numbers.join(", "))
}

/// 0.1 mm/K that grows by a hundredth with each kelvin.
pub fn heat_coefficient() -> String {
    effect("temperature_coefficient", &[("per_kelvin", "mm/K", 0.1), ("bend", "1/K", 0.01)])
}

pub fn play() -> String {
    effect("friction", &[("force", "mm", 0.3), ("width", "full loads", 0.05), ("gradual", "", 0.0)])
}

pub fn lag() -> String {
    effect("readout_lag", &[("tau", "s", 8.0)])
}

/// `1 + 1.5 F`, or `1 + 1.5 F - 0.04 F^2`; the rest as a diagnosis writes it.
pub fn model(base: &str, moved: &str, effects: &str) -> ModelFile {
    let numbers: &[(&str, f64)] = if base.contains("constant") {
        &[("level", 8.5)]
    } else if base == BENT {
        &[("offset", 1.0), ("slope", 15.0), ("order_2", -4.0)]
    } else {
        &[("offset", 1.0), ("slope", 15.0)]
    };
    let number =
        |(name, value): &(&str, f64)| format!("[[parameter]]\nname = \"{name}\"\nunit = \"mm\"\nvalue = {value}\nsd = 0.1\n");
    let parameters: String = numbers.iter().map(number).collect();
    let scaled = if base.contains("command") { String::new() } else { format!("scale = {SCALE}\nreference_c = 20.0\n") };
    let effects = if effects.is_empty() { "effect = []\n".to_owned() } else { effects.to_owned() };
    let (first, last) = if effects.starts_with("effect") { (effects.as_str(), "") } else { ("", effects.as_str()) };
    let text = format!(
        "schema = \"{MODEL_SCHEMA}\"\nmade_by = \"test\"\nrecording = \"bench */ of.csv\"\nsha256 = \"b\"\nverdict = \"explained\"\nunit = \"mm\"\n{first}\
         [base]\n{base}\n{scaled}[scales]\nlongest_run_s = 899.0\nshortest_step_s = 1.0\nduration_s = 899.0\nresponse_span = 15.0\nnoise_sd = {SD}\nruns = 1\n\
         moved = {{ {moved} }}\n{parameters}{last}"
    );
    ModelFile::parse(&text, Path::new("augmented.toml")).unwrap()
}

pub fn made(file: &ModelFile) -> Result<Firmware, FirmwareError> {
    firmware_of(file, Path::new("augmented.toml"), &Asked::default())
}

pub fn force() -> Vec<f64> {
    column(|t| 5.0 + 3.0 * (t / 40.0).sin() + 1.5 * (t / 17.0).sin())
}

pub fn heat() -> Vec<f64> {
    column(|t| 20.0 + 8.0 * (t / 150.0).sin())
}

pub fn column(of: impl Fn(f64) -> f64) -> Vec<f64> {
    (0..ROWS).map(|row| of(row as f64)).collect()
}

pub fn straight(f: f64) -> f64 {
    1.0 + 1.5 * f
}

pub fn bent(f: f64) -> f64 {
    1.0 + 1.5 * f - 0.04 * f * f
}

/// What the coefficient adds.
pub fn warmth(t: f64) -> f64 {
    0.1 * ((t - 20.0) + 0.5 * 0.01 * (t - 20.0).powi(2))
}

pub fn each<const N: usize>(columns: [&[f64]; N], of: impl Fn([f64; N]) -> f64) -> Vec<f64> {
    (0..ROWS).map(|row| of(std::array::from_fn(|k| columns[k][row]))).collect()
}

pub fn rms(a: &[f64], b: &[f64]) -> f64 {
    (a.iter().zip(b).map(|(a, b)| (a - b).powi(2)).sum::<f64>() / a.len() as f64).sqrt()
}

pub fn largest(a: &[f64], b: &[f64]) -> f64 {
    a.iter().zip(b).map(|(a, b)| (a - b).abs()).fold(0.0, f64::max)
}

pub fn there_is_a_compiler() -> bool {
    let there = Command::new("cc").arg("--version").output().is_ok();
    if !there {
        eprintln!("NOT TESTED: there is no `cc` on this machine, so no firmware was run");
    }
    there
}

/// Compiles the firmware without a warning and gives it rows: seconds since the row before, and its other arguments; the last line counts calls outside of the table.
pub fn run(made: &Firmware, columns: &[&[f64]]) -> (Vec<f64>, usize) {
    let folder = tempfile::tempdir().unwrap();
    let file = folder.path().join("correction.c");
    made.write(&file).unwrap();
    let arguments = columns.len();
    let given: Vec<String> = (0..arguments).map(|k| format!("x[{k}]")).collect();
    let main = format!(
        "#define TRUEGAP_DECLARATIONS_ONLY\n#include \"correction.c\"\n#include <stdio.h>\nint main(void) {{\n    truegap_state state;\n    float x[{arguments}];\n    \
         truegap_begin(&state);\n    for (;;) {{\n        for (int k = 0; k < {arguments}; k++) if (scanf(\"%f\", &x[k]) != 1) {{ printf(\"%lu\\n\", (unsigned long)state.outside); return 0; }}\n        \
         printf(\"%.9g\\n\", (double)truegap_correct(&state, {}));\n    }}\n}}\n",
        given.join(", ")
    );
    std::fs::write(folder.path().join("main.c"), main).unwrap();
    let strict = [
        "-std=c99",
        "-O2",
        "-Wall",
        "-Wextra",
        "-Wpedantic",
        "-Wconversion",
        "-Wdouble-promotion",
        "-Wmissing-prototypes",
        "-Werror",
    ];
    let built = Command::new("cc")
        .args(strict)
        .args(["main.c", "correction.c", "-o", "run"])
        .current_dir(folder.path())
        .output()
        .unwrap();
    assert!(built.status.success(), "{}\n{}", String::from_utf8_lossy(&built.stderr), made.source);
    let mut child = Command::new(folder.path().join("run")).stdin(Stdio::piped()).stdout(Stdio::piped()).spawn().unwrap();
    let rows: String = (0..columns[0].len())
        .map(|row| columns.iter().map(|column| format!("{} ", column[row])).collect::<String>() + "\n")
        .collect();
    let mut pipe = child.stdin.take().unwrap();
    let writer = std::thread::spawn(move || pipe.write_all(rows.as_bytes()));
    let said = String::from_utf8(child.wait_with_output().unwrap().stdout).unwrap();
    writer.join().unwrap().unwrap();
    let mut numbers: Vec<f64> = said.lines().map(|line| line.parse().unwrap()).collect();
    let outside = numbers.pop().unwrap();
    (numbers, outside as usize)
}

pub fn second() -> Vec<f64> {
    vec![1.0; ROWS]
}
