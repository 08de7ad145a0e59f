//! From a path, or from texts, to a recording.
//!
//! Limits: one pass over the file, two where the vendor's tool logged several sensors.

use super::{
    assumed_base::assumed_base,
    columnar,
    columns::{self, Column},
    data::{Recording, Sensors},
    date_order::order,
    degrees,
    driver_columns::bind_drivers,
    error::RecordingError,
    manifest::{BaseSpec, Manifest, Named},
    map::each_once,
    note::Note,
    number::number,
    packed::{open_csv, unread},
    rows::Rows,
    singletact, spans,
    spare::Spare,
    table::Table,
    told::Told,
};
use crate::inputs::Role;
use std::collections::BTreeMap;
use std::io::{Cursor, Read, Seek};
use std::path::{Path, PathBuf};

/// Where a recording's words come from, for messages.
struct Origin<'a> {
    csv: &'a Path,
    toml: Option<&'a Path>,
    /// what is told beside them
    told: &'a Told,
}

impl Recording {
    /// Reads a recording: a TOML that names a CSV, a bare CSV with the default names, the SingleTact tool's CSV, or a folder with a `recording.toml`. A CSV may be
    /// packed by gzip; `-` is one on standard input.
    ///
    /// # Errors
    /// [`RecordingError`] names file, line and value, and says what to do.
    pub fn open(path: impl AsRef<Path>) -> Result<Self, RecordingError> {
        Self::open_told(path, &Told::default())
    }

    /// As [`Recording::open`], with what is told beside it; that goes before what the TOML says.
    ///
    /// # Errors
    /// As [`Recording::open`].
    pub fn open_told(path: impl AsRef<Path>, told: &Told) -> Result<Self, RecordingError> {
        let path = path.as_ref();
        if path.is_dir() {
            return Self::open_told(path.join("recording.toml"), told);
        }
        if path.extension().is_some_and(|e| e.eq_ignore_ascii_case("toml")) {
            return Self::open_manifest(path, told);
        }
        let opened = opened(&Origin { csv: path, toml: None, told }, Manifest::default());
        let beside = path.with_extension("toml");
        if !beside.is_file() {
            return opened;
        }
        let note = Note::ManifestNotRead { file: beside.display().to_string() };
        match opened {
            Ok(mut recording) => {
                recording.notes.push(note);
                Ok(recording)
            }
            Err(source) => Err(RecordingError::BesideManifest { source: Box::new(source), note }),
        }
    }

    /// As [`Recording::open`] of a table, with the text of a TOML that stands in no file; its `file` is not looked for.
    ///
    /// # Errors
    /// As [`Recording::open`].
    pub fn open_table(path: impl AsRef<Path>, toml: &str) -> Result<Self, RecordingError> {
        let path = path.as_ref();
        let manifest = Manifest::parse(path, toml)?;
        opened(&Origin { csv: path, toml: None, told: &Told::default() }, manifest)
    }

    fn open_manifest(path: &Path, told: &Told) -> Result<Self, RecordingError> {
        let text = truegap_limits::read_text(path).map_err(|source| unread(path, source))?;
        let manifest = Manifest::parse(path, &text)?;
        let csv = path.parent().unwrap_or(Path::new("")).join(&manifest.file);
        opened(&Origin { csv: &csv, toml: Some(path), told }, manifest)
    }

    /// Reads a recording from the text of its TOML and of its CSV; `name` stands for the files in messages.
    ///
    /// # Errors
    /// As [`Recording::open`].
    pub fn from_text(name: &str, toml: &str, csv: &str) -> Result<Self, RecordingError> {
        Self::from_text_told(name, toml, csv, &Told::default())
    }

    /// As [`Recording::from_text`], with what is told beside the texts; that goes before what the TOML says.
    ///
    /// # Errors
    /// As [`Recording::open`].
    pub fn from_text_told(name: &str, toml: &str, csv: &str, told: &Told) -> Result<Self, RecordingError> {
        let path = PathBuf::from(format!("{name}.toml"));
        let manifest = Manifest::parse(&path, toml)?;
        let csv_path = PathBuf::from(&manifest.file);
        each_once(&told.map, &csv_path)?;
        read(Cursor::new(csv.as_bytes()), &Origin { csv: &csv_path, toml: Some(&path), told }, manifest)
    }
}

/// The recording in a table, whatever kind of file that is.
fn opened(origin: &Origin<'_>, manifest: Manifest) -> Result<Recording, RecordingError> {
    each_once(&origin.told.map, origin.csv)?;
    match columnar::read(origin.csv)? {
        None => read(open_csv(origin.csv)?, origin, manifest),
        Some(mut frame) => {
            let manifest = manifest.told(origin.told, &frame.header());
            frame.read_dates(origin.csv, &manifest)?;
            frame.holds_numbers(origin.csv, &manifest)?;
            let mut recording = Recording::of_frame(origin.csv, origin.toml, manifest, &frame.columns, &frame.left_out_names())?;
            recording.sha256 = frame.sha256;
            recording.path = origin.toml.unwrap_or(origin.csv).to_owned();
            Ok(recording)
        }
    }
}

fn read<R: Read + Seek>(source: R, origin: &Origin<'_>, manifest: Manifest) -> Result<Recording, RecordingError> {
    let mut table = Table::open(origin.csv, source)?;
    let manifest = manifest.told(origin.told, &table.header).with_roles_of_drivers(origin.csv, origin.toml, &table.header)?;
    let sensors = vendor_sensors(&table, &manifest);
    let several = sensors.len() > 1;
    let mut rows = Rows::default();
    let (mut sha256, mut notes, mut bound) = (String::new(), Vec::new(), Vec::<Column>::new());
    for pass in 0..sensors.len().max(1) {
        let sensor = sensors.get(pass);
        let (columns, assumed) = columns::bind(origin.csv, origin.toml, &table.header, &with_response(&manifest, sensor))?;
        rows.clock.lenient = table.singletact;
        rows.clock.renumber = several || columns.iter().any(|c| c.role == Role::Sensor);
        let drivers = bind_drivers(origin.csv, origin.toml, &table.header, &manifest, &columns)?;
        let mut ordered = false;
        if let Some(clock) = columns.iter().find(|c| c.dated && table.header[c.index].unordered) {
            rows.order = order(&mut table, clock.index, manifest.dayfirst)?;
            table = Table::open(origin.csv, table.finish().1)?;
            ordered = true;
        }
        let (mut grouped, idle) = (None, manifest.dayfirst.filter(|_| !ordered));
        if table.decimal_comma {
            grouped = rows.find_thousands(&mut table, &columns, &drivers)?;
            table = Table::open(origin.csv, table.finish().1)?;
        }
        let numeric = numbers_ahead(&table);
        rows.take(&mut table, &columns, &drivers, sensor.filter(|_| several).map(String::as_str))?;
        if pass == 0 {
            table.tell_left_out()?;
            notes = std::mem::take(&mut table.notes);
            notes.extend(assumed);
            notes.extend(rows.first_date.take());
            notes.extend(idle.map(|_| Note::OrderNotAsked));
            notes.extend(rows.commas.then_some(Note::DecimalCommas));
            notes.extend(grouped);
            if !table.singletact {
                let (header, bare) = (table.header.as_slice(), origin.toml.is_none());
                let spare = Spare { header, columns: &columns, drivers: &drivers, numeric: &numeric, left_out: &[], bare };
                notes.extend(spare.note());
            }
            bound = columns;
        } else {
            same_unit(origin.csv, &bound, &columns)?;
        }
        let (hash, source) = table.finish();
        sha256 = hash;
        table = Table::open(origin.csv, source)?;
    }
    assemble(rows, &bound, notes, sha256, origin, manifest.base)
}

/// Whether a number stands under each heading, in the first row.
fn numbers_ahead<R: Read + Seek>(table: &Table<R>) -> Vec<bool> {
    let is_number = |index: usize| table.row().get(index).is_some_and(|cell| number(cell, table.decimal_comma).is_ok());
    (0..table.header.len()).map(is_number).collect()
}

/// Columns of the vendor's tool that are each read as a sensor's response; none where the response is named, or in any other CSV.
fn vendor_sensors<R: Read + Seek>(table: &Table<R>, manifest: &Manifest) -> Vec<String> {
    if table.singletact && !manifest.columns.contains_key(&Role::Response) {
        singletact::sensors(&table.header.iter().map(|heading| heading.name.clone()).collect::<Vec<_>>())
    } else {
        Vec::new()
    }
}

fn with_response(manifest: &Manifest, sensor: Option<&String>) -> Manifest {
    let mut with = manifest.clone();
    if let Some(sensor) = sensor {
        with.columns.insert(Role::Response, Named { text: sensor.clone(), line: 1 });
    }
    with
}

fn same_unit(file: &Path, first: &[Column], other: &[Column]) -> Result<(), RecordingError> {
    let unit = |columns: &[Column]| columns.iter().find(|c| c.role == Role::Response).map(|c| (c.name.clone(), c.unit.clone()));
    match (unit(first), unit(other)) {
        (Some((_, response)), Some((column, unit))) if unit != response => {
            Err(RecordingError::SensorsDiffer { file: file.to_owned(), column, unit, response })
        }
        _ => Ok(()),
    }
}

fn assemble(
    mut rows: Rows,
    columns: &[Column],
    mut notes: Vec<Note>,
    sha256: String,
    origin: &Origin<'_>,
    base: Option<BaseSpec>,
) -> Result<Recording, RecordingError> {
    let renumbered = rows.clock.renumber;
    let (of_row, names) = (std::mem::take(&mut rows.sensors), std::mem::take(&mut rows.names));
    let (inputs, response, found) = rows.finish();
    notes.extend(found);
    if inputs.is_empty() {
        return Err(RecordingError::NoRows { file: origin.csv.to_owned() });
    }
    if renumbered {
        notes.push(Note::RunsRenumbered { runs: inputs.run.last().copied().unwrap_or(0) });
    }
    let unit = |role: Role| columns.iter().find(|c| c.role == role).map(|c| c.unit.clone());
    let response_unit = unit(Role::Response).unwrap_or_default();
    let simulated_unit = unit(Role::Simulated).filter(|unit| !response.is_empty() && *unit != response_unit);
    let own = simulated_unit.clone().map(|unit| Note::SimulatedUnit { unit, response: response_unit.clone() });
    notes.extend(own);
    let base = base.unwrap_or_else(|| assumed_base(columns, &mut notes));
    let path = origin.toml.unwrap_or(origin.csv).to_owned();
    let sensors = renumbered.then_some(Sensors { of_row, names });
    let names: BTreeMap<Role, String> = columns.iter().map(|c| (c.role, c.name.clone())).collect();
    let mut recording =
        Recording { inputs, response, response_unit, simulated_unit, base, sensors, columns: names, sha256, path, notes };
    spans::check(origin.csv, &recording, columns)?;
    recording.notes.extend(recording.constants());
    recording.notes.extend(degrees::doubt(&recording, columns));
    Ok(recording)
}
