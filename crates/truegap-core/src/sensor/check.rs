//! Whether a sensor can exist: positive dimensions, beads within the electrode, a gap that full load leaves open.
//!
//! Limits: at the reference temperature; the loads that cover the electrode or close the gap follow from the bead law (11), (12) without solving it.

use super::{
    description::{Filling, Layer, Sensor},
    error::{SensorError, SensorProblem},
};
use crate::units::{ABSOLUTE_ZERO_C, Measure, readable, twelve_digits};
use std::f64::consts::PI;

impl Sensor {
    /// Checks what the type cannot: positive dimensions, beads within the electrode also at full load, a load that leaves the gap open.
    ///
    /// # Errors
    /// [`SensorError`] without a line, with `file` as the name of the place where the sensor comes from.
    pub fn check(&self, file: &str) -> Result<(), SensorError> {
        check(self).map_err(|(key, problem)| SensorError { file: file.to_owned(), line: None, key, problem })
    }
}

/// A dotted key and what is wrong with it.
type Finding = (String, SensorProblem);

/// The first thing that is wrong with a sensor.
pub(super) fn check(sensor: &Sensor) -> Result<(), Finding> {
    let rubber = &sensor.dielectric;
    named(&sensor.name)?;
    positive("full_scale", sensor.full_scale, "N", 1.0)?;
    reference(sensor.reference_c)?;
    length("electrode.diameter", sensor.diameter)?;
    layer("electrode.conductor", &sensor.conductor, "thickness")?;
    if let Some(plating) = &sensor.plating {
        layer("electrode.plating", plating, "thickness")?;
    }
    layer("insulator", &sensor.insulator, "thickness")?;
    layer("dielectric", &rubber.layer, "height")?;
    at_least_one("dielectric.surrounding_permittivity", rubber.surrounding_permittivity)?;
    at_least_one(&format!("materials.{}.permittivity", rubber.layer.material.name), rubber.layer.material.permittivity)?;
    at_least_one(&format!("materials.{}.permittivity", sensor.insulator.material.name), sensor.insulator.material.permittivity)?;
    not_negative("tail.length", sensor.tail.0)?;
    not_negative("tail.width", sensor.tail.1)?;
    match rubber.filling {
        Filling::Beads { count, diameter } => beads(sensor, count, diameter),
        Filling::Solid { coverage } => solid(sensor, coverage),
    }
}

/// Longest name of a sensor, characters.
const LONGEST_NAME: usize = 200;

/// A name is one line that can be shown: it stands in tables, in pages and on terminals.
fn named(name: &str) -> Result<(), Finding> {
    let shown = !name.trim().is_empty() && name.chars().count() <= LONGEST_NAME && !name.chars().any(char::is_control);
    let value = || format!("`{}`", name.escape_debug().to_string().chars().take(LONGEST_NAME).collect::<String>());
    shown.then_some(()).ok_or_else(|| {
        out_of_range("name", value(), "a name is one line of 1 to 200 characters, none of them a control character")
    })
}

/// A temperature at which dimensions can hold.
fn reference(reference_c: f64) -> Result<(), Finding> {
    let possible = (ABSOLUTE_ZERO_C..=1000.0).contains(&reference_c);
    let value = || format!("{} degC", readable(reference_c));
    possible
        .then_some(())
        .ok_or_else(|| out_of_range("reference_temperature", value(), "it lies between absolute zero and 1000 degC"))
}

fn out_of_range(key: &str, value: String, rule: &'static str) -> Finding {
    (key.to_owned(), SensorProblem::OutOfRange { value, rule })
}

fn positive(key: &str, value: f64, unit: &str, scale: f64) -> Result<(), Finding> {
    let possible = value.is_finite() && value > 0.0;
    possible
        .then_some(())
        .ok_or_else(|| out_of_range(key, format!("{} {unit}", twelve_digits(value * scale)), "it must be greater than 0"))
}

fn not_negative(key: &str, value: f64) -> Result<(), Finding> {
    let possible = value.is_finite() && value >= 0.0;
    possible
        .then_some(())
        .ok_or_else(|| out_of_range(key, format!("{} mm", twelve_digits(value * 1e3)), "it must be 0 or greater"))
}

/// A length above zero, by more than its own spread allows to doubt.
fn length(key: &str, length: Measure) -> Result<(), Finding> {
    positive(key, length.value, "um", 1e6)?;
    let certain = length.sd < 0.5 * length.value;
    let value = || format!("{} um +- {} um", twelve_digits(length.value * 1e6), twelve_digits(length.sd * 1e6));
    certain.then_some(()).ok_or_else(|| out_of_range(key, value(), "the spread must be below half of the value"))
}

fn at_least_one(key: &str, value: f64) -> Result<(), Finding> {
    let possible = value.is_finite() && value >= 1.0;
    possible.then_some(()).ok_or_else(|| out_of_range(key, format!("{value}"), "a relative permittivity is 1 or greater"))
}

fn layer(key: &str, layer: &Layer, thickness: &str) -> Result<(), Finding> {
    length(&format!("{key}.{thickness}"), layer.thickness)?;
    let material = &layer.material;
    let name = &material.name;
    positive(&format!("materials.{name}.young"), material.young.value, "MPa", 1e-6)?;
    let nu = material.poisson;
    if !(nu > -1.0 && nu < 0.5) {
        return Err(out_of_range(
            &format!("materials.{name}.poisson"),
            format!("{nu}"),
            "Poisson's ratio lies between -1 and 0.5, and 0.49 is usual for rubber",
        ));
    }
    let expansion = material.expansion;
    let possible = expansion.abs() < 0.01;
    let value = format!("{} ppm/K", twelve_digits(expansion * 1e6));
    possible
        .then_some(())
        .ok_or_else(|| out_of_range(&format!("materials.{name}.expansion"), value, "it must lie within 1 % a kelvin"))
}

fn electrode_area(sensor: &Sensor) -> f64 {
    0.25 * PI * sensor.diameter.value * sensor.diameter.value
}

fn beads(sensor: &Sensor, count: u32, diameter: Measure) -> Result<(), Finding> {
    if count == 0 {
        return Err(out_of_range("dielectric.beads.count", "0".to_owned(), "without a bead nothing carries the load"));
    }
    length("dielectric.beads.diameter", diameter)?;
    let electrode = electrode_area(sensor);
    let area = f64::from(count) * 0.25 * PI * diameter.value * diameter.value;
    if area >= electrode {
        let problem = SensorProblem::BeadsCoverElectrode {
            count,
            diameter_um: diameter.value * 1e6,
            covered_mm2: area * 1e6,
            electrode_mm2: electrode * 1e6,
        };
        return Err(("dielectric.beads".to_owned(), problem));
    }
    let material = &sensor.dielectric.layer.material;
    let nu = material.poisson;
    let load = |strain: f64| area * material.young.value * strain * (1.0 + nu * strain).powi(2);
    closes(sensor, load(1.0))?;
    // area (1 + nu e)^2 = electrode
    let covered = ((electrode / area).sqrt() - 1.0) / nu;
    if nu > 0.0 && covered < 1.0 && load(covered) <= sensor.full_scale {
        let problem = SensorProblem::BeadsMeet { full_scale_n: twelve_digits(sensor.full_scale), limit_n: load(covered) };
        return Err(("full_scale".to_owned(), problem));
    }
    Ok(())
}

fn solid(sensor: &Sensor, coverage: f64) -> Result<(), Finding> {
    if !(coverage > 0.0 && coverage <= 1.0) {
        return Err(out_of_range(
            "dielectric.solid.coverage",
            format!("{} %", twelve_digits(coverage * 100.0)),
            "it lies above 0 % and up to 100 %",
        ));
    }
    closes(sensor, coverage * electrode_area(sensor) * sensor.dielectric.layer.material.young.value)
}

fn closes(sensor: &Sensor, limit_n: f64) -> Result<(), Finding> {
    let open = sensor.full_scale < limit_n;
    let problem = SensorProblem::GapCloses { full_scale_n: twelve_digits(sensor.full_scale), limit_n };
    open.then_some(()).ok_or_else(|| ("full_scale".to_owned(), problem))
}
