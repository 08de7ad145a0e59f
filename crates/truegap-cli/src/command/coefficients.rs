//! `truegap coefficients`: what a data sheet would say.

use super::run::{Outcome, Run};
use super::simulate::Series;
use crate::console::Console;
use crate::table::{digits, table};
use serde::Serialize;
use truegap::core::units::readable;
use truegap::model::{CoefficientOptions, Coefficients as Numbers, StackOptions};
use truegap::predict::{DEFAULT_SENSOR, Planes, Strains, find_sensor, planes, strains};

/// Temperature coefficients and linearity of a sensor, between 20 and 50 degC
#[derive(Debug, clap::Args)]
pub struct Coefficients {
    /// Built-in sensor or path of a sensor's TOML
    #[arg(long, default_value = DEFAULT_SENSOR)]
    sensor: String,
    /// Order of (19) and (21): as printed, or exact for a bent gap
    #[arg(long, value_enum, default_value = "printed")]
    series: Series,
    /// Leave out the warp of the electrode
    #[arg(long)]
    no_warp: bool,
    /// Also print what (12) and (17) give as the paper prints them, beside the corrected forms
    #[arg(long)]
    as_printed: bool,
}

#[derive(Serialize)]
struct Answer {
    #[serde(flatten)]
    coefficients: Numbers,
    #[serde(skip_serializing_if = "Option::is_none")]
    as_printed: Option<AsPrinted>,
}

#[derive(Serialize)]
struct AsPrinted {
    equation_12: Vec<Strains>,
    equation_17: Vec<Planes>,
}

impl Run for Coefficients {
    fn run(&self, console: &Console) -> anyhow::Result<Outcome> {
        let sensor = find_sensor(&self.sensor, None)?;
        let stack = StackOptions { warp: !self.no_warp, series: self.series.into() };
        let coefficients = truegap::predict::coefficients(&sensor, CoefficientOptions { stack, ..Default::default() })?;
        let as_printed = self.as_printed.then(|| AsPrinted { equation_12: strains(&sensor), equation_17: planes() });
        let answer = Answer { coefficients, as_printed };
        if console.json {
            console.print_json(&answer)?;
            return Ok(Outcome::Fine);
        }
        let warp = if self.no_warp { "without warp" } else { "with warp" };
        console.print(format!("{}, {warp}, 20 to 50 degC, up to {} N", sensor.name, readable(sensor.full_scale)))?;
        console.print(numbers(&answer.coefficients))?;
        if let Some(printed) = &answer.as_printed {
            console.print(format!("\nStrain of the beads by (12)\n{}", strain_table(&printed.equation_12)))?;
            console.print("The printed root is positive: a load would open the gap.")?;
            console.print(format!("\nSettled plane of a bent electrode by (17)\n{}", plane_table(&printed.equation_17)))?;
            console.print("The printed cubic stays above zero between the cap's rim and its top: it has no root there.")?;
        }
        Ok(Outcome::Fine)
    }
}

fn numbers(c: &Numbers) -> comfy_table::Table {
    let rows = [
        ("baseline capacitance", c.baseline_pf, "pF"),
        ("span to full load", c.span_pf, "pF"),
        ("K_baseline", c.k_baseline_pf_per_k, "pF/K"),
        ("K_baseline", c.k_baseline_pct_fsr_per_k, "% of span/K"),
        ("K_sensitivity", c.k_sensitivity_pct_per_k, "%/K"),
        ("linearity", c.linearity_pct, "% of span"),
        ("K_linearity", c.k_linearity_pct_per_k, "%/K"),
    ];
    let rows = rows.map(|(name, value, unit)| vec![name.to_owned(), digits(value, 6), unit.to_owned()]);
    table(&["quantity", "value", "unit"], rows)
}

fn strain_table(strains: &[Strains]) -> comfy_table::Table {
    let optional = |value: Option<f64>, significant| value.map_or_else(|| "none".to_owned(), |v| digits(v, significant));
    let rows = strains.iter().map(|s| {
        vec![digits(s.force_n, 3), optional(s.corrected, 6), optional(s.printed, 6), optional(s.size_difference_pct, 3)]
    });
    table(&["force\nN", "corrected", "as printed", "larger in size by\n%"], rows)
}

fn plane_table(planes: &[Planes]) -> comfy_table::Table {
    let rows = planes.iter().map(|p| vec![digits(p.half_angle_rad, 2), digits(p.corrected, 8), digits(p.printed_least, 3)]);
    table(&["half-angle\nrad", "corrected\nalpha / R", "least of the printed cubic\n/ R^3"], rows)
}
