//! Every reader with its corpus, and mutated inputs for it: whatever the bytes, an answer that is sound or an error, never a panic.
//!
//! Limits: mutations of the corpus, not of the grammar; the same seed gives the same inputs, so a run that held holds again.

mod compensate;

use compensate::compensate;
use proptest::prelude::*;
use proptest::test_runner::{Config, RngAlgorithm, TestRng, TestRunner};
use std::cell::Cell;
use std::fs;
use std::path::{Path, PathBuf};
use std::time::{Duration, Instant};
use truegap::models::ModelFile;
use truegap::study::audit::SpaceFile;
use truegap_core::{Dimension, Measure, Recording, Sensor};
use truegap_diagnose::mechanism::MechanismFile;
use truegap_fem::case::read_case;
use truegap_fem::io::read_msh;
use truegap_sweep::{Sweep, describe};

/// A reader.
pub struct Reader {
    /// its name, and that of its folder of the corpus
    pub name: &'static str,
    /// further folders with inputs, below the workspace's
    shared: &'static [&'static str],
    read: Read,
}

/// Reads an input: whether it is taken, or what is unsound in the answer.
enum Read {
    Text(fn(&str) -> Result<bool, String>),
    Bytes(fn(&[u8]) -> Result<bool, String>),
}

impl Reader {
    /// Whether it is taken, and how long that took to say.
    fn read(&self, bytes: &[u8]) -> Result<(bool, Duration), String> {
        let (is_taken, took) = self.timed(bytes)?;
        // a machine that stood still for that long does not do so twice
        let took = if took > LONGEST { took.min(self.timed(bytes)?.1) } else { took };
        if took > LONGEST { Err(format!("took {:.0} s", took.as_secs_f64())) } else { Ok((is_taken, took)) }
    }

    fn timed(&self, bytes: &[u8]) -> Result<(bool, Duration), String> {
        let begin = Instant::now();
        let is_taken = match self.read {
            Read::Text(read) => read(&String::from_utf8_lossy(bytes)),
            Read::Bytes(read) => read(bytes),
        };
        Ok((is_taken?, begin.elapsed()))
    }
}

/// Every byte of the seed from which the changes are drawn.
pub const SEED: u8 = 7;

/// Inputs after which a count is told.
const TOLD: u32 = 10_000;

/// Longest time that a small input may take, on a busy machine as well.
const LONGEST: Duration = Duration::from_secs(20);

/// Longest time in which a failure is made shorter, ms.
const SHORTENED_MS: u32 = 60_000;

/// What came of the inputs of a reader.
pub struct Fed {
    /// how many were taken, and sound
    pub taken: u32,
    /// the longest that one took
    pub slowest: Duration,
}

/// Every reader.
pub fn all() -> Vec<Reader> {
    let reader = |name, shared, read| Reader { name, shared, read: Read::Text(read) };
    vec![
        reader("csv", &[], csv),
        Reader { name: "packed", shared: &[], read: Read::Bytes(packed) },
        reader("recording", &[], recording),
        reader("sensor", &["meshes/sensors"], sensor),
        reader("case", &["meshes/cases"], case),
        reader("mechanism", &[], mechanism),
        reader("model", &[], model),
        reader("compensate", &[], compensate),
        reader("msh", &[], msh),
        reader("shard", &[], shard),
        reader("space", &["meshes/spaces"], space),
        reader("quantity", &[], quantity),
    ]
}

/// Gives `count` mutated inputs to a reader; how many of them it took, and how long the slowest was looked at.
///
/// # Errors
/// The first input that made it panic or answer unsoundly, made as short as possible, and what happened.
pub fn feed(reader: &Reader, count: u32) -> Result<Fed, String> {
    let corpus = corpus(reader)?;
    for (file, bytes) in &corpus {
        let (is_taken, _) = reader.read(bytes).map_err(|what| format!("{}: {what}", file.display()))?;
        if !is_taken {
            return Err(format!("{}: sound, and refused", file.display()));
        }
    }
    let seeds: Vec<Vec<u8>> = corpus.into_iter().map(|(_, bytes)| bytes).collect();
    let config = Config {
        cases: count,
        failure_persistence: None,
        max_shrink_iters: 2000,
        max_shrink_time: SHORTENED_MS,
        ..Config::default()
    };
    let mut runner = TestRunner::new_with_rng(config, TestRng::from_seed(RngAlgorithm::ChaCha, &[SEED; 32]));
    let strategy = (0..seeds.len(), prop::collection::vec(change(), 1..6));
    let (taken, given, slowest) = (Cell::new(0), Cell::new(0), Cell::new(Duration::ZERO));
    let fed = runner.run(&strategy, |(which, changes)| {
        let bytes = changes.iter().fold(seeds[which].clone(), |bytes, change| change.of(bytes, &seeds));
        let shown = String::from_utf8_lossy(&bytes);
        let read = reader.read(&bytes).map_err(|what| TestCaseError::fail(format!("{what}; the input was {shown:?}")));
        let (is_taken, took) = read?;
        slowest.set(slowest.get().max(took));
        taken.set(taken.get() + u32::from(is_taken));
        given.set(given.get() + 1);
        // what a run that is broken off has held is no less true
        if given.get() % TOLD == 0 {
            println!("{}: {} inputs so far, {} taken and sound", reader.name, given.get(), taken.get());
        }
        Ok(())
    });
    fed.map(|()| Fed { taken: taken.get(), slowest: slowest.get() }).map_err(|error| error.to_string())
}

/// Inputs to begin with, in the order of their names.
fn corpus(reader: &Reader) -> Result<Vec<(PathBuf, Vec<u8>)>, String> {
    let here = Path::new(env!("CARGO_MANIFEST_DIR"));
    let own = here.join("corpus").join(reader.name);
    let folders = std::iter::once(own).chain(reader.shared.iter().map(|folder| here.join("../..").join(folder)));
    let mut files: Vec<PathBuf> = folders
        .filter_map(|folder| fs::read_dir(folder).ok())
        .flat_map(|entries| entries.filter_map(|e| e.ok().map(|e| e.path())))
        .filter(|path| path.is_file())
        .collect();
    files.sort();
    let read = |file: PathBuf| match fs::read(&file) {
        Ok(bytes) => Ok((file, bytes)),
        Err(error) => Err(format!("{}: {error}", file.display())),
    };
    let corpus: Vec<_> = files.into_iter().map(read).collect::<Result<_, _>>()?;
    if corpus.is_empty() { Err(format!("{}: no corpus", reader.name)) } else { Ok(corpus) }
}

/// One change of an input; places are shares of its length.
#[derive(Clone, Debug)]
enum Change {
    Byte(f64, u8),
    Cut(f64, f64),
    Twice(f64, f64),
    Word(f64, usize),
    Number(f64, usize),
    End(f64),
    Graft(f64, usize, f64, f64),
}

/// What breaks readers.
const WORDS: [&str; 44] = [
    "nan",
    "inf",
    "-inf",
    "1e999",
    "-1e308",
    "1e308",
    "1e-308",
    "0",
    "-0",
    "-1",
    "9223372036854775807",
    "18446744073709551616",
    "4294967296",
    "0x10",
    "1_000",
    "\0",
    "\"",
    "\"\"\"",
    "'",
    "[",
    "]",
    "]]",
    "[[",
    "{",
    "}",
    "=",
    "\n",
    "\r",
    "\t",
    ",",
    ",,,,,,,,",
    ";",
    "\u{feff}",
    "é",
    "µ",
    "\u{1b}[31m",
    "+- ",
    " %",
    " um",
    " K",
    "#",
    "true",
    "../../",
    "\u{202e}",
];

fn change() -> impl Strategy<Value = Change> {
    let share = || 0.0..1.0f64;
    prop_oneof![
        1 => (share(), any::<u8>()).prop_map(|(at, byte)| Change::Byte(at, byte)),
        1 => (share(), 0.0..0.2f64).prop_map(|(at, length)| Change::Cut(at, length)),
        1 => (share(), 0.0..0.2f64).prop_map(|(at, length)| Change::Twice(at, length)),
        1 => (share(), 0..WORDS.len()).prop_map(|(at, word)| Change::Word(at, word)),
        3 => (share(), 0..WORDS.len()).prop_map(|(at, word)| Change::Number(at, word)),
        1 => share().prop_map(Change::End),
        1 => (share(), any::<usize>(), share(), 0.0..0.3f64).prop_map(|(at, other, from, length)| Change::Graft(at, other, from, length)),
    ]
}

impl Change {
    fn of(&self, mut bytes: Vec<u8>, others: &[Vec<u8>]) -> Vec<u8> {
        let place = |share: f64, length: usize| ((share * length as f64) as usize).min(length);
        let range = |at: f64, length: f64, of: usize| place(at, of)..place((at + length).min(1.0), of);
        let all = bytes.len();
        match *self {
            Self::Byte(at, byte) => {
                if let Some(there) = bytes.get_mut(place(at, all)) {
                    *there = byte;
                }
            }
            Self::Cut(at, length) => drop(bytes.drain(range(at, length, all))),
            Self::Twice(at, length) => {
                let again = bytes[range(at, length, all)].to_vec();
                bytes.splice(place(at, all)..place(at, all), again);
            }
            Self::Word(at, word) => drop(bytes.splice(place(at, all)..place(at, all), WORDS[word].bytes())),
            Self::Number(at, word) => {
                let digit = |b: &u8| b.is_ascii_digit() || matches!(b, b'.' | b'-' | b'+');
                let from = place(at, all);
                let Some(start) = bytes[from..].iter().position(digit).map(|k| from + k) else { return bytes };
                let end = bytes[start..].iter().position(|b| !digit(b)).map_or(all, |k| start + k);
                bytes.splice(start..end, WORDS[word].bytes());
            }
            Self::End(at) => bytes.truncate(place(at, all)),
            Self::Graft(at, other, from, length) => {
                let other = &others[other % others.len()];
                let graft = other[range(from, length, other.len())].to_vec();
                bytes.splice(place(at, all)..place(at, all), graft);
            }
        }
        bytes
    }
}

const CSV: &str = "time_s,force_n,temperature_c,humidity_pct,capacitance_pf,run,position_mm\n0,0,20,40,75,1,0\n1,1,20.5,41,77,1,2\n0,0,21,40,75,2,1\n";
const TOML: &str = "schema = \"truegap.recording/1\"\nfile = \"r.csv\"\n";

fn sound(recording: &Recording) -> Result<bool, String> {
    let columns = recording.quantities();
    let rows = recording.len();
    match columns.iter().find(|(_, column)| column.len() != rows || column.iter().any(|v| !v.is_finite())) {
        Some((role, _)) => Err(format!("column {role:?} is not {rows} finite numbers")),
        None if recording.inputs.run.len() != rows || rows == 0 => Err("runs and rows differ".into()),
        None => Ok(true),
    }
}

fn csv(text: &str) -> Result<bool, String> {
    Recording::from_text("r", TOML, text).map_or(Ok(false), |recording| sound(&recording))
}

/// A CSV packed by gzip, or what is left of one.
fn packed(bytes: &[u8]) -> Result<bool, String> {
    let folder = tempfile::tempdir().map_err(|error| error.to_string())?;
    let path = folder.path().join("r.csv.gz");
    fs::write(&path, bytes).map_err(|error| error.to_string())?;
    Recording::open(&path).map_or(Ok(false), |recording| sound(&recording))
}

fn recording(text: &str) -> Result<bool, String> {
    Recording::from_text("r", text, CSV).map_or(Ok(false), |recording| sound(&recording))
}

fn sensor(text: &str) -> Result<bool, String> {
    let Ok(sensor) = Sensor::from_toml(text, "s.toml") else { return Ok(false) };
    let lengths = [sensor.diameter, sensor.conductor.thickness, sensor.insulator.thickness, sensor.dielectric.layer.thickness];
    let possible = |m: &Measure| m.value.is_finite() && m.value > 0.0 && m.sd.is_finite() && m.sd >= 0.0;
    if !lengths.iter().all(possible) || !sensor.reference_c.is_finite() {
        return Err(format!("a sensor that cannot be: {sensor:?}"));
    }
    // whatever passed the check has coefficients or a reason why not
    drop(truegap::predict::coefficients(&sensor, Default::default()));
    Ok(true)
}

fn case(text: &str) -> Result<bool, String> {
    let Ok(case) = read_case(text, "c.toml") else { return Ok(false) };
    let size = case.mesh.max_edge.unwrap_or(1.0);
    if size.is_nan() || size <= 0.0 || case.outputs.is_empty() {
        return Err(format!("a case that cannot be: {:?}", case.mesh));
    }
    Ok(true)
}

fn mechanism(text: &str) -> Result<bool, String> {
    let Ok(file) = toml::from_str::<MechanismFile>(text) else { return Ok(false) };
    match file.effect() {
        Ok(_) if !(file.size.sd.is_finite() && file.size.sd > 0.0) => {
            Err(format!("an effect whose size has sd {}", file.size.sd))
        }
        effect => Ok(effect.is_ok()),
    }
}

fn model(text: &str) -> Result<bool, String> {
    let Ok(model) = ModelFile::parse(text, Path::new("m.toml")).and_then(|file| file.build()) else { return Ok(false) };
    match truegap::models::at_points(&model, &[0.0, 1.0], &[20.0]) {
        Ok(answers) if answers.iter().any(|a| !a.response.is_finite()) => Err("a response that is not finite".into()),
        _ => Ok(true),
    }
}

fn msh(text: &str) -> Result<bool, String> {
    let Ok(mesh) = read_msh(text, "m.msh") else { return Ok(false) };
    mesh.check().map(|()| true).map_err(|error| error.to_string())
}

/// The first line is `sweep.json`, the rest the file of the only case.
fn shard(text: &str) -> Result<bool, String> {
    let folder = tempfile::tempdir().map_err(|error| error.to_string())?;
    let sweep = Sweep::new("test/1", &"context", vec!["case"]).map_err(|error| error.to_string())?;
    let (described, case) = text.split_once('\n').unwrap_or((text, ""));
    let put = |name: String, text: &str| fs::write(folder.path().join(name), text);
    fs::create_dir(folder.path().join("cases"))
        .and_then(|()| put("sweep.json".into(), described))
        .and_then(|()| put(format!("cases/{}.json", sweep.hashes()[0]), case))
        .map_err(|error| error.to_string())?;
    drop(describe(folder.path()));
    match sweep.merge::<f64>(folder.path()) {
        Ok(merged) if merged.answers.len() + merged.missing.len() != 1 => Err("not one case".into()),
        merged => Ok(merged.is_ok_and(|merged| merged.missing.is_empty())),
    }
}

fn space(text: &str) -> Result<bool, String> {
    match SpaceFile::from_toml(text) {
        Ok(space) if space.designs == 0 => Err("no design".into()),
        space => Ok(space.is_ok()),
    }
}

/// Quantities of every dimension, and lists of values.
fn quantity(text: &str) -> Result<bool, String> {
    for dimension in [Dimension::Length, Dimension::Force, Dimension::Temperature, Dimension::Ratio, Dimension::PerKelvin] {
        for line in text.lines() {
            let measure = Measure::parse(line, dimension);
            if measure.is_ok_and(|m| !m.value.is_finite() || m.sd.is_nan() || m.sd < 0.0) {
                return Err(format!("`{line}` is no {dimension:?}"));
            }
            let values = truegap::predict::axis::values(line, dimension);
            if values.is_ok_and(|values| values.iter().any(|v| !v.is_finite())) {
                return Err(format!("`{line}` is no list of {dimension:?}"));
            }
        }
    }
    Ok(true)
}
