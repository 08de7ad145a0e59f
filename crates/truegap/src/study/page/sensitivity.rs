//! Ranked bars of a sensitivity study.
//!
//! Limits: bars show the changes one at a time; the tables hold the rest.

use super::{header, row, spoken};
use crate::study::StudyError;
use crate::study::answer::sensitivity::{SensitivityAnswer, SensorSensitivity};
use crate::study::work::file_stem;
use truegap_design::sensitivity::{QuantityIndices, ToleranceIndices, ranked};
use truegap_design::{METRICS, Metric};
use truegap_scene::figure::{Bars, FigureError};
use truegap_scene::page::{Page, Table};

/// One figure a sensor and metric.
pub(in crate::study) fn figures(answer: &SensitivityAnswer) -> Result<Vec<(String, String)>, StudyError> {
    let mut files = Vec::new();
    for (number, of) in answer.sensors.iter().enumerate() {
        let stem = file_stem(&of.sensor);
        let is_taken = answer.sensors[..number].iter().any(|other| file_stem(&other.sensor) == stem);
        let stem = if is_taken { format!("{stem}-{}", number + 1) } else { stem };
        for metric in METRICS {
            files.push((format!("{stem}_{metric}.svg"), bars(of, metric, answer.change_pct)?));
        }
    }
    Ok(files)
}

fn bars(of: &SensorSensitivity, metric: Metric, change: f64) -> Result<String, FigureError> {
    let labels: Vec<&str> = of.one_at_a_time.iter().map(|r| r.quantity.symbol()).collect();
    let [down, up] = [false, true].map(|up| -> Vec<f64> {
        of.one_at_a_time.iter().map(|r| if up { r.up[metric as usize] } else { r.down[metric as usize] }).collect()
    });
    Bars::new(&format!("{} of {}", spoken(metric), of.sensor), &labels)
        .x(&format!("change of the {}", spoken(metric)), metric.unit())
        .series(&format!("−{change} %"), &down)
        .series(&format!("+{change} %"), &up)
        .ranked()
        .overlaid()
        .to_svg()
}

/// The page.
pub(in crate::study) fn html(answer: &SensitivityAnswer) -> Result<String, StudyError> {
    let names: Vec<&str> = answer.sensors.iter().map(|s| s.sensor.as_str()).collect();
    let mut page = Page::new(&format!("Sensitivity of {}", names.join(" and "))).text(&format!(
        "What each number of the data sheet does when one quantity goes down or up by {} % and all others stay, as in figures 7 and 9 of Hampson and Dobie; \
         then derivatives; then Sobol indices over the tolerances, which say how much of the scatter of a batch each tolerance causes.",
        answer.change_pct
    ));
    for metric in METRICS {
        page = page.section(&capitalised(spoken(metric)));
        for of in &answer.sensors {
            let order: Vec<&str> = ranked(&of.one_at_a_time, metric).iter().map(|(q, _)| q.symbol()).collect();
            let caption = format!("{}: largest first {}.", of.sensor, order.join(", "));
            page = page.figure(&bars(of, metric, answer.change_pct)?, &caption);
        }
    }
    for of in &answer.sensors {
        page = tables(page, of);
    }
    Ok(page.to_html())
}

fn tables(page: Page, of: &SensorSensitivity) -> Page {
    let header = header("quantity");
    let header: Vec<&str> = header.iter().map(String::as_str).collect();
    let slopes = of.local.iter().fold(Table::new(&header), |t, r| t.row(&row(r.quantity.symbol(), &r.per_percent)));
    let page = page
        .section(&format!("Numbers of {}", of.sensor))
        .subsection("Change for 1 % of the quantity, to first order")
        .table(&slopes);
    match &of.sobol {
        None => page.text("The sensor has no tolerances, so there are no Sobol indices."),
        Some(indices) => sobol(page, indices, &header),
    }
}

fn sobol(page: Page, indices: &ToleranceIndices, header: &[&str]) -> Page {
    let table = |pick: fn(&QuantityIndices) -> &Vec<truegap_design::sensitivity::Index>| {
        indices.quantities.iter().fold(Table::new(header), |table, of| {
            let cells = pick(of).iter().map(|i| format!("{:.3} ({:.3} to {:.3})", i.value, i.low, i.high));
            table.row(&std::iter::once(of.quantity.symbol().to_owned()).chain(cells).collect::<Vec<_>>())
        })
    };
    page.subsection("Share of the batch's variance that goes when the quantity is held exactly (first-order Sobol index)")
        .text(&format!("{} rows, seed {}; 95 % intervals.", indices.rows, indices.seed))
        .table(&table(|of| &of.first))
        .subsection("Share that stays when only this quantity scatters, interactions included (total Sobol index)")
        .table(&table(|of| &of.total))
}

fn capitalised(text: &str) -> String {
    let mut letters = text.chars();
    letters.next().map_or_else(String::new, |first| first.to_uppercase().chain(letters).collect())
}
