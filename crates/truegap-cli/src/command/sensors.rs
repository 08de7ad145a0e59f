//! `truegap sensors`: what is built in.

use super::run::{Outcome, Run};
use crate::console::Console;
use crate::table::{digits, table};
use serde::Serialize;
use truegap::Sensor;
use truegap::core::sensor::{Filling, builtin_sensors};

/// List the built-in sensors
#[derive(Debug, clap::Args)]
pub struct Sensors {}

#[derive(Serialize)]
struct Listed {
    name: &'static str,
    description: String,
    full_scale_n: f64,
    diameter_mm: f64,
    dielectric_um: f64,
    filling: String,
}

impl Run for Sensors {
    fn run(&self, console: &Console) -> anyhow::Result<Outcome> {
        let listed = builtin_sensors().iter().map(|b| Ok(listed(b.name, &b.sensor()?))).collect::<anyhow::Result<Vec<_>>>()?;
        if console.json {
            console.print_json(&listed)?;
            return Ok(Outcome::Fine);
        }
        let rows = listed.iter().map(|l| {
            let [full, diameter, height] = [l.full_scale_n, l.diameter_mm, l.dielectric_um].map(|v| digits(v, 3));
            vec![l.name.to_owned(), full, diameter, height, l.filling.clone()]
        });
        console.print(table(&["sensor", "full scale\nN", "diameter\nmm", "dielectric\num", "filling"], rows))?;
        if !console.quiet {
            for l in &listed {
                console.print(format!("\n{}\n  {}", l.name, l.description.replace('\n', "\n  ")))?;
            }
        }
        Ok(Outcome::Fine)
    }
}

fn listed(name: &'static str, sensor: &Sensor) -> Listed {
    let filling = match &sensor.dielectric.filling {
        Filling::Beads { count, diameter } => format!("{count} beads of {} um", digits(diameter.value * 1e6, 3)),
        Filling::Solid { coverage } => format!("solid, {} %", digits(coverage * 100.0, 3)),
    };
    Listed {
        name,
        description: sensor.description.trim().to_owned(),
        full_scale_n: sensor.full_scale,
        diameter_mm: sensor.diameter.value * 1e3,
        dielectric_um: sensor.dielectric.layer.thickness.value * 1e6,
        filling,
    }
}
