//! Scatter of batches, yield, and what tightening one tolerance does.
//!
//! Limits: distributions as shares below a value, from 21 quantiles.

use super::{number, spoken};
use crate::study::StudyError;
use crate::study::answer::tolerance::{BatchAnswer, ToleranceAnswer};
use truegap_design::tolerance::PROBABILITIES;
use truegap_design::{METRICS, Metric};
use truegap_diagnose::text::significant;
use truegap_scene::figure::{Bars, Figure, FigureError};
use truegap_scene::page::{Page, Table, Tone};

/// A figure a metric, and the tolerances.
pub(in crate::study) fn figures(answer: &ToleranceAnswer) -> Result<Vec<(String, String)>, StudyError> {
    let mut files = Vec::new();
    for metric in METRICS.into_iter().filter(|m| answer.sensors.iter().any(|b| has(b, *m))) {
        files.push((format!("{metric}.svg"), shares(answer, metric)?));
    }
    if !answer.tighten.is_empty() {
        files.push(("tighten.svg".to_owned(), tightened(answer)?));
    }
    Ok(files)
}

fn has(batch: &BatchAnswer, metric: Metric) -> bool {
    batch.scatter.iter().any(|s| s.metric == metric)
}

fn shares(answer: &ToleranceAnswer, metric: Metric) -> Result<String, FigureError> {
    let percent = PROBABILITIES.map(|p| 100.0 * p);
    let mut figure = Figure::new("").x(spoken(metric), metric.unit()).y("sensors below", "%").height(240.0);
    for batch in &answer.sensors {
        for scatter in batch.scatter.iter().filter(|s| s.metric == metric) {
            figure = figure.line(&batch.sensor, &scatter.quantiles, &percent);
        }
    }
    for limit in answer.specification.limits.iter().filter(|l| l.metric == metric) {
        for (end, name) in [(limit.low, "least"), (limit.high, "greatest")].into_iter().filter(|(end, _)| end.is_finite()) {
            figure = figure.mark_x(end, name);
        }
    }
    figure.to_svg()
}

/// Yield gained where there is a specification, mean fall of the scatter where there is none.
fn tightened(answer: &ToleranceAnswer) -> Result<String, FigureError> {
    let labels: Vec<&str> = answer.tighten.iter().map(|t| t.quantity.symbol()).collect();
    if answer.specification.limits.is_empty() {
        let mean = |falls: &[f64; METRICS.len()]| falls.iter().sum::<f64>() / falls.len() as f64;
        let falls: Vec<f64> = answer.tighten.iter().map(|t| mean(&t.scatter_falls_pct)).collect();
        return Bars::new("", &labels)
            .x("standard deviations fall by, mean of all metrics", "%")
            .series("halved", &falls)
            .to_svg();
    }
    let gains: Vec<f64> = answer.tighten.iter().map(|t| 100.0 * t.gain).collect();
    Bars::new("", &labels).x("yield gained", "points").series("halved", &gains).to_svg()
}

/// The page.
pub(in crate::study) fn html(answer: &ToleranceAnswer) -> Result<String, StudyError> {
    let names: Vec<&str> = answer.sensors.iter().map(|b| b.sensor.as_str()).collect();
    let mut page = Page::new(&format!("Tolerances of {}", names.join(" and ")));
    if !answer.complete {
        page = page.callout(Tone::Watch, "Stopped before all sensors were drawn; this is what was done by then.");
    }
    if !answer.specification.limits.is_empty() {
        page = yields(page, answer);
    }
    page = page.section("Scatter").table(&scatter(answer));
    for metric in METRICS.into_iter().filter(|m| answer.sensors.iter().any(|b| has(b, *m))) {
        page = page.figure(&shares(answer, metric)?, &format!("Share of sensors below a {}.", spoken(metric)));
    }
    if let Some(first) = answer.tighten.first() {
        let told = format!("Halving the tolerance of {} (the {}) helps most.", first.quantity.symbol(), first.quantity.says());
        page = page.section("Which tolerance to tighten first").text(&told);
        page = page.figure(
            &tightened(answer)?,
            &format!("{} with one tolerance halved, same random numbers.", answer.sensors.first().map_or("", |b| &b.sensor)),
        );
        page = page.table(&tighten_table(answer));
    }
    Ok(drawn(page, answer).to_html())
}

fn yields(page: Page, answer: &ToleranceAnswer) -> Page {
    let mut page = page.section("Yield");
    for batch in &answer.sensors {
        let good = &batch.good;
        let tone = if good.share > 0.99 {
            Tone::Good
        } else if good.share > 0.0 {
            Tone::Watch
        } else {
            Tone::Bad
        };
        let error =
            good.standard_error.map_or_else(String::new, |e| format!(" ± {} (standard error)", significant(100.0 * e, 2)));
        page = page.callout(
            tone,
            &format!("{}: {:.3} %{error} of the sensors keep the specification.", batch.sensor, 100.0 * good.share),
        );
        let header = ["limit", "excludes", "excludes alone"];
        let rows = answer.specification.limits.iter().zip(good.excluded.iter().zip(&good.excluded_alone));
        page = page.table(&rows.fold(Table::new(&header), |table, (limit, (all, alone))| {
            let end = |value: f64| if value.is_finite() { number(value) } else { "any".to_owned() };
            let told = format!("{} from {} to {} {}", spoken(limit.metric), end(limit.low), end(limit.high), limit.metric.unit());
            table.row(&[told, format!("{:.3} %", 100.0 * all), format!("{:.3} %", 100.0 * alone)])
        }));
    }
    page
}

fn scatter(answer: &ToleranceAnswer) -> Table {
    let mut table =
        Table::new(&["number", "unit", "sensor", "mean", "standard deviation", "% of mean", "2.5 %", "50 %", "97.5 %"]);
    for metric in METRICS {
        for batch in &answer.sensors {
            for s in batch.scatter.iter().filter(|s| s.metric == metric) {
                let quantile = |p: f64| s.quantile(p).map_or_else(String::new, number);
                let numbers = [number(s.mean), number(s.sd), number(s.sd_pct), quantile(0.025), quantile(0.5), quantile(0.975)];
                let names = [spoken(metric), metric.unit(), &batch.sensor].map(str::to_owned);
                table = table.row(&names.into_iter().chain(numbers).collect::<Vec<_>>());
            }
        }
    }
    table
}

fn tighten_table(answer: &ToleranceAnswer) -> Table {
    let falls: Vec<String> = METRICS.iter().map(|m| format!("sd of {} falls by, %", spoken(*m))).collect();
    let header: Vec<&str> = ["tolerance", "yield gained, points"].into_iter().chain(falls.iter().map(String::as_str)).collect();
    answer.tighten.iter().fold(Table::new(&header), |table, t| {
        let falls = t.scatter_falls_pct.iter().map(|v| format!("{v:.1}"));
        table
            .row(&[t.quantity.symbol().to_owned(), format!("{:.3}", 100.0 * t.gain)].into_iter().chain(falls).collect::<Vec<_>>())
    })
}

fn drawn(page: Page, answer: &ToleranceAnswer) -> Page {
    let counts: Vec<String> = answer
        .sensors
        .iter()
        .map(|b| format!("{} of {}, of which {:.3} % have plates that touch", b.samples, b.sensor, 100.0 * b.good.touching))
        .collect();
    page.section("How they were drawn").text(&format!(
        "Sensors: {}. Independent normal tolerances with the standard deviations of the sensor files, by scrambled Sobol points in independent parts of 65 536; seed {}. \
         Quantiles are means over the parts.",
        counts.join("; "),
        answer.seed
    ))
}
