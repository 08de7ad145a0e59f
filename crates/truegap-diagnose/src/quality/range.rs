//! Inputs beyond what the sensor is made for, where its model is no longer known to hold.
//!
//! Limits: base models with plates; full scale is the sensor file's; temperatures are those that silicone, polyimide and solder bear with straight material laws.

use crate::{
    data::problem::Problem,
    quality::tuning::{HIGHEST_LOAD, LOWEST_LOAD, TEMPERATURES_C},
    quality::{
        notice::{Notice, NoticeKind},
        rows::Rows,
    },
    text::Scale,
};
use truegap_core::{Role, simulator::StageName};

/// Notices for loads and temperatures out of range.
pub fn out_of_range(problem: &Problem<'_>, rows: &Rows<'_>) -> Vec<Notice> {
    let mut list = Vec::new();
    if problem.simulator.lacks(StageName::Geometry).is_some() {
        // a curve, a column or a constant has neither a full scale nor materials
        return list;
    }
    list.extend(loads(problem, rows));
    list.extend(temperatures(problem, rows));
    list
}

fn loads(problem: &Problem<'_>, rows: &Rows<'_>) -> Option<Notice> {
    let full = problem.simulator.full_load()?;
    let load = problem.simulator.load(problem.inputs)?;
    let out: Vec<usize> = (0..load.len()).filter(|row| !(LOWEST_LOAD..=HIGHEST_LOAD).contains(&load[*row])).collect();
    let worst = *out.iter().max_by(|a, b| (load[**a] - 0.5).abs().total_cmp(&(load[**b] - 0.5).abs()))?;
    let role = if problem.simulator.needs().contains(&Role::Pressure) { Role::Pressure } else { Role::Force };
    let (name, unit) = (role.key(), role.unit());
    let text = |share: f64| Scale::of(unit, (share * full).abs()).text(share * full);
    let fix = if load[worst] > 0.0 {
        "leave these rows out, or name a sensor of a larger range with --sensor"
    } else {
        "a pull that the sensor cannot bear: check the sign and the tare of the column, or leave these rows out"
    };
    let says = format!(
        "the {name} goes outside the sensor's range of 0 to {}: {} in {}, {} rows in all; {fix}",
        text(1.0),
        text(load[worst]),
        rows.place(worst),
        out.len()
    );
    Some(Notice { kind: NoticeKind::OutOfRange, says, rows: rows.numbers_of(&out), withholds: true })
}

fn temperatures(problem: &Problem<'_>, rows: &Rows<'_>) -> Option<Notice> {
    let temperature = problem.inputs.temperature_c.as_ref()?;
    let (low, high) = TEMPERATURES_C;
    let out: Vec<usize> = (0..temperature.len()).filter(|row| !(low..=high).contains(&temperature[*row])).collect();
    let worst = *out.iter().max_by(|a, b| (temperature[**a] - 40.0).abs().total_cmp(&(temperature[**b] - 40.0).abs()))?;
    let says = format!(
        "the temperature leaves the range of {low:.0} to {high:.0} °C in which the materials are known: {:.4} °C in {}, {} rows in all; check the unit \
         of the column and the thermometer, or leave these rows out",
        temperature[worst],
        rows.place(worst),
        out.len()
    );
    Some(Notice { kind: NoticeKind::OutOfRange, says, rows: rows.numbers_of(&out), withholds: true })
}
