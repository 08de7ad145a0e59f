//! The sensor file, `truegap.sensor/1`.
//!
//! Limits: reads what is written; whether such a sensor can exist is for [`Sensor::check`].

use super::{
    check::check,
    description::{CompressibleDielectric, Filling, Layer, Layout, Sensor},
    error::{SCHEMA, SensorError, SensorProblem},
    materials::Materials,
    table::{Source, Table},
};
use crate::units::{Dimension, Measure};
use toml::de::DeTable;

impl Sensor {
    /// Reads a sensor file (`truegap.sensor/1`, see `docs/sensor-files.md`) and checks it; `file` is named in errors.
    ///
    /// # Errors
    /// [`SensorError`] with file, line, key, value and a remedy: an unknown key, a missing or wrong unit, a number that no sensor can have.
    pub fn from_toml(text: &str, file: &str) -> Result<Self, SensorError> {
        let sensor = read(text, file)?;
        check(&sensor.value).map_err(|(key, problem)| SensorError {
            file: file.to_owned(),
            line: sensor.line_of(&key),
            key,
            problem,
        })?;
        Ok(sensor.value)
    }
}

/// A sensor and the text it came from, to say later where a number stands.
struct Read<'a> {
    value: Sensor,
    text: &'a str,
}

impl Read<'_> {
    /// Line of a dotted key.
    fn line_of(&self, key: &str) -> Option<usize> {
        let root = DeTable::parse(self.text).ok()?;
        let source = Source { file: "", text: self.text };
        let (mut table, mut line) = (root.get_ref(), None);
        for part in key.split('.') {
            let (name, value) = table.iter().find(|(name, _)| name.get_ref() == part)?;
            line = Some(source.line(name.span().start));
            match value.get_ref().as_table() {
                Some(below) => table = below,
                None => break,
            }
        }
        line
    }
}

/// Reads a sensor file.
fn read<'a>(text: &'a str, file: &str) -> Result<Read<'a>, SensorError> {
    let syntax = |error: toml::de::Error| SensorError {
        file: file.to_owned(),
        line: error.span().map(|span| Source { file, text }.line(span.start)),
        key: String::new(),
        problem: SensorProblem::Syntax { message: error.message().to_owned() },
    };
    let root = DeTable::parse(text).map_err(syntax)?;
    let table = Table::new(Source { file, text }, String::new(), 0, root.get_ref());
    let value = sensor(&table)?;
    Ok(Read { value, text })
}

fn sensor(root: &Table<'_>) -> Result<Sensor, SensorError> {
    let (schema, at) = root.needed_text("schema", "\"truegap.sensor/1\"")?;
    if schema != SCHEMA {
        return Err(root.source.error(at, "schema", SensorProblem::Schema { found: schema.to_owned() }));
    }
    let name = root.needed_text("name", "\"my-sensor\"")?.0.to_owned();
    let description = root.text("description")?.map_or("", |(text, _)| text).trim().to_owned();
    let layout = layout(root)?;
    let full_scale = root.needed_exact("full_scale", Dimension::Force, "\"4.5 N\"")?;
    let reference_c = root.measure("reference_temperature", Dimension::Temperature)?.map_or(20.0, |m| m.value);
    let electrode =
        root.needed_table("electrode", "{ diameter = \"15 mm\", conductor = { material = \"copper\", thickness = \"34 um\" } }")?;
    let insulator = root.needed_table("insulator", "{ material = \"polyimide\", thickness = \"25 um\" }")?;
    let dielectric = root.needed_table("dielectric", "{ material = \"silicone\", height = \"162 um\" }")?;
    let (tail, stray) = (tail(root)?, stray(root)?);
    let materials = Materials::new(root.table("materials")?)?;
    root.finish()?;

    let conductor = electrode.needed_table("conductor", "{ material = \"copper\", thickness = \"34 um\" }")?;
    let plating = electrode.table("plating")?.map(|table| layer(&table, &materials)).transpose()?;
    let sensor = Sensor {
        name,
        description,
        layout,
        full_scale,
        reference_c,
        diameter: electrode.needed_measure("diameter", Dimension::Length, "\"15 mm +- 25 um\"")?,
        conductor: layer(&conductor, &materials)?,
        plating,
        insulator: layer(&insulator, &materials)?,
        dielectric: compressible(&dielectric, &materials)?,
        tail,
        stray,
    };
    electrode.finish()?;
    Ok(sensor)
}

fn layout(root: &Table<'_>) -> Result<Layout, SensorError> {
    match root.text("layout")? {
        None | Some(("shielded", _)) => Ok(Layout::Shielded),
        Some(("mutual", _)) => Ok(Layout::Mutual),
        Some((other, at)) => {
            let problem = SensorProblem::UnknownWord { found: other.to_owned(), known: "shielded, mutual".to_owned() };
            Err(root.source.error(at, "layout", problem))
        }
    }
}

/// Length and width of the tail; none where the file has no tail.
fn tail(root: &Table<'_>) -> Result<(f64, f64), SensorError> {
    let Some(table) = root.table("tail")? else { return Ok((0.0, 0.0)) };
    let length = table.needed_exact("length", Dimension::Length, "\"40 mm\"")?;
    let width = table.needed_exact("width", Dimension::Length, "\"0.1 mm\"")?;
    table.finish()?;
    Ok((length, width))
}

fn stray(root: &Table<'_>) -> Result<Measure, SensorError> {
    let Some(table) = root.table("stray")? else { return Ok(Measure::exact(0.0)) };
    let stray = table.needed_measure("capacitance", Dimension::Capacitance, "\"0 pF +- 0.3 pF\"")?;
    table.finish()?;
    Ok(stray)
}

fn layer(table: &Table<'_>, materials: &Materials<'_>) -> Result<Layer, SensorError> {
    let (name, at) = table.needed_text("material", "\"copper\"")?;
    let thickness = table.needed_measure("thickness", Dimension::Length, "\"34 um +- 5 %\"")?;
    table.finish()?;
    Ok(Layer { material: materials.get(name, table, at)?, thickness })
}

fn compressible(table: &Table<'_>, materials: &Materials<'_>) -> Result<CompressibleDielectric, SensorError> {
    let (name, at) = table.needed_text("material", "\"silicone\"")?;
    let thickness = table.needed_measure("height", Dimension::Length, "\"162 um +- 5 um\"")?;
    let surrounding_permittivity = table.number("surrounding_permittivity", Dimension::Ratio)?.unwrap_or(1.0);
    let filling = filling(table)?;
    table.finish()?;
    Ok(CompressibleDielectric {
        layer: Layer { material: materials.get(name, table, at)?, thickness },
        filling,
        surrounding_permittivity,
    })
}

fn filling(table: &Table<'_>) -> Result<Filling, SensorError> {
    let example = "{ count = 65, diameter = \"700 um +- 2 %\" }, or solid = { coverage = \"100 %\" }";
    match (table.table("beads")?, table.table("solid")?) {
        (Some(beads), None) => {
            let count = beads.needed_count("count", "65")?;
            let diameter = beads.needed_measure("diameter", Dimension::Length, "\"700 um +- 2 %\"")?;
            beads.finish()?;
            Ok(Filling::Beads { count, diameter })
        }
        (None, Some(solid)) => {
            let coverage = solid.needed_number("coverage", "\"100 %\"")?;
            solid.finish()?;
            Ok(Filling::Solid { coverage })
        }
        (None, None) => Err(table.error("beads", SensorProblem::Missing { example: format!("beads = {example}") })),
        (Some(_), Some(_)) => {
            let problem = SensorProblem::UnknownKey { known: "beads or solid, not both".to_owned() };
            Err(table.error("solid", problem))
        }
    }
}
