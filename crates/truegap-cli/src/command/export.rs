//! `truegap export`: the deformed stack for 3D viewers, as a page, or as a section for ParaView.
//!
//! Limits: reads, calls, prints.

use super::run::{Outcome, Run};
use super::typed::command_line;
use super::wait::waiting;
use crate::console::Console;
use crate::table::digits;
use anyhow::bail;
use serde::Serialize;
use std::path::PathBuf;
use truegap::audit::disc::{CoupledOptions, Press};
use truegap::core::Dimension;
use truegap::predict::{DEFAULT_SENSOR, axis, find_sensor};
use truegap::verify::export::{self, BeadModel, Format, Request};

/// Write the deformed stack under load and heat: glTF (.glb), a page that shows it (.html) or its section (.vtu)
#[derive(Debug, clap::Args)]
pub struct Export {
    /// Built-in sensor or path of a sensor's TOML
    #[arg(long, default_value = DEFAULT_SENSOR)]
    sensor: String,
    /// Load, as "4.5 N"
    #[arg(long)]
    load: String,
    /// Temperature, as "50 degC"; the sensor's reference temperature where none is given
    #[arg(long, allow_hyphen_values = true)]
    temperature: Option<String>,
    /// File to write; its ending says the format: .glb, .html or .vtu
    #[arg(long, short, value_name = "FILE")]
    output: PathBuf,
    /// Field that colours the file; a viewer page offers all of them
    #[arg(long, value_enum, visible_alias = "color", default_value = "displacement")]
    colour: Colour,
    /// Cut a quarter out, as a page has it anyway
    #[arg(long)]
    wedge: bool,
    /// Leave the disc whole in a page, too
    #[arg(long, conflicts_with = "wedge")]
    whole: bool,
    /// How the beads behave
    #[arg(long, value_enum, default_value = "bonded")]
    beads: Beads,
    /// Spread the load evenly instead of pressing with a rigid plate
    #[arg(long)]
    even: bool,
}

/// Fields to colour by.
#[derive(Clone, Copy, Debug, clap::ValueEnum)]
enum Colour {
    /// degrees Celsius
    Temperature,
    /// how far a point has moved, um
    Displacement,
    /// von Mises stress, MPa
    VonMises,
    /// electric potential, V
    Potential,
    /// electric field strength, kV/m
    Field,
}

/// Behaviour of the beads.
#[derive(Clone, Copy, Debug, clap::ValueEnum)]
enum Beads {
    /// stick to both plates, finite elements
    Bonded,
    /// spread freely, the paper's (11) and (12)
    Free,
}

#[derive(Serialize)]
struct Answer {
    file: String,
    force_n: f64,
    temperature_c: f64,
    c_main_pf: f64,
    c_backing_pf: f64,
    c_tail_pf: f64,
    c_total_pf: f64,
    error_estimate_pf: f64,
    largest_displacement_um: f64,
    triangles: usize,
}

impl Run for Export {
    fn run(&self, console: &Console) -> anyhow::Result<Outcome> {
        let format = Format::of(&self.output)?; // before the work
        let sensor = find_sensor(&self.sensor, None)?;
        let force_n = one("--load", &self.load, Dimension::Force)?;
        let temperature_c = match &self.temperature {
            Some(text) => one("--temperature", text, Dimension::Temperature)?,
            None => sensor.reference_c,
        };
        let press = if self.even { Press::Even } else { Press::RigidPlate };
        let solved = waiting(console, "solving the disc", || {
            export::solve(Request {
                sensor: &sensor,
                force_n,
                temperature_c,
                colour: self.colour.into(),
                // uncut, a page opens on a disc of one colour
                wedge: self.wedge || (format == Format::Page && !self.whole),
                beads: self.beads.into(),
                options: CoupledOptions { press, ..CoupledOptions::default() },
                command: command_line(),
            })
        })?;
        solved.write(&self.output)?;
        let charged = solved.charged();
        let solution = &solved.coupled.carried.solution;
        let moved = (0..solved.coupled.deformed.points.len()).map(|n| solution.nodal(n)).map(|[u, w]| u.hypot(w));
        let answer = Answer {
            file: self.output.display().to_string(),
            force_n,
            temperature_c,
            c_main_pf: 1e12 * charged.main,
            c_backing_pf: 1e12 * charged.backing,
            c_tail_pf: 1e12 * charged.tail,
            c_total_pf: 1e12 * charged.total(),
            error_estimate_pf: 1e12 * charged.error_estimate,
            largest_displacement_um: 1e6 * moved.fold(0.0, f64::max),
            triangles: solved.coupled.deformed.triangles.len(),
        };
        if console.json { console.print_json(&answer) } else { print(console, &answer) }.map(|()| Outcome::Fine)
    }
}

fn print(console: &Console, answer: &Answer) -> anyhow::Result<()> {
    let [total, main, backing, tail] =
        [answer.c_total_pf, answer.c_main_pf, answer.c_backing_pf, answer.c_tail_pf].map(|c| format!("{c:.4}"));
    console.print(format!(
        "{}: {total} pF (gap {main}, behind the electrode {backing}, tail {tail}), mesh error {} pF; largest displacement {} um; {} triangles",
        answer.file,
        digits(answer.error_estimate_pf, 2),
        digits(answer.largest_displacement_um, 4),
        answer.triangles
    ))
}

fn one(flag: &str, text: &str, dimension: Dimension) -> anyhow::Result<f64> {
    match axis::values(text, dimension)?.as_slice() {
        [value] => Ok(*value),
        _ => bail!("{flag} {text}: one value is needed here, as a file shows one state; export once for each"),
    }
}

impl From<Colour> for export::Colour {
    fn from(colour: Colour) -> Self {
        match colour {
            Colour::Temperature => Self::Temperature,
            Colour::Displacement => Self::Displacement,
            Colour::VonMises => Self::VonMises,
            Colour::Potential => Self::Potential,
            Colour::Field => Self::Field,
        }
    }
}

impl From<Beads> for BeadModel {
    fn from(beads: Beads) -> Self {
        match beads {
            Beads::Bonded => Self::Bonded,
            Beads::Free => Self::Free,
        }
    }
}
