//! The page of an audited space: how often each assumption holds, and where in the space it does not.
//!
//! Limits: one axis at a time; which axes act together is not asked.

use super::number;
use crate::study::answer::audit::{Audited, Row, SpaceAuditAnswer};
use crate::study::{
    StudyError,
    where_broken::{Where, wheres},
};
use crate::verify::{MOVED, short_percent, word};
use truegap_audit::{EffectOn, Verdict};
use truegap_design::optimise::{Axis, Choice};
use truegap_scene::figure::{Bars, Figure, Matrix};
use truegap_scene::page::{Page, Table, Tone};

/// The page.
pub(in crate::study) fn html(answer: &SpaceAuditAnswer) -> Result<String, StudyError> {
    let page = Page::new(&format!("Audit of {} designs around {}", answer.audited + answer.refused, answer.sensor));
    let page = summary(page, answer);
    let page = shares(page, answer)?;
    let page = effects(page, answer)?;
    let page = places(page, answer)?;
    let page = refused(page, answer);
    Ok(provenance(page, answer).to_html())
}

fn summary(page: Page, answer: &SpaceAuditAnswer) -> Page {
    let everywhere = answer.shares.iter().filter(|s| s.broken == 1.0).count();
    let nowhere = answer.shares.iter().filter(|s| s.broken == 0.0).count();
    let told = format!(
        "{} designs audited, {} refused. Of {} assumptions, {everywhere} are broken in every design and {nowhere} in none.",
        answer.audited,
        answer.refused,
        answer.shares.len()
    );
    let page = page.callout(if everywhere > 0 { Tone::Bad } else { Tone::Watch }, &told);
    let page = if answer.complete {
        page
    } else {
        page.callout(Tone::Watch, "Some cases are missing; this page knows those that are there.")
    };
    page.text(
        "Each design is audited as a sensor is: one piece of the analytic chain is replaced by what finite elements find. An assumption holds where no \
         coefficient moves by 1 %, is strained from 1 % or outside of the range in which its equation is known to be good, and is broken from 10 %. \
         K_b, K_s and K_l are the drifts of baseline, sensitivity and linearity; effects are medians over the designs.",
    )
}

fn shares(page: Page, answer: &SpaceAuditAnswer) -> Result<Page, StudyError> {
    let own = ["assumption", "designs", "holds %", "strained %", "broken %"];
    let head = Table::new(&[&own[..], &MOVED].concat());
    let percent = |share: f64| format!("{:.0}", 100.0 * share);
    let table = answer.shares.iter().fold(head.dense(), |table, share| {
        let mut row = vec![
            share.id.clone(),
            share.designs.to_string(),
            percent(share.holds),
            percent(share.strained),
            percent(share.broken),
        ];
        row.push(share.median_relative_error.map_or("–".into(), |e| short_percent(100.0 * e)));
        row.extend(EffectOn::NAMES.map(|name| short_percent(quartiles(answer, &share.id, name)[1])));
        table.row(&row)
    });
    if answer.shares.is_empty() {
        return Ok(page.section("How often").text("No design has an answer of the analytic model and of the finite elements."));
    }
    let names: Vec<&str> = answer.shares.iter().map(|s| s.id.as_str()).collect();
    let values: Vec<f64> = answer.shares.iter().flat_map(|s| [s.holds, s.strained, s.broken].map(|v| 100.0 * v)).collect();
    let drawn = Matrix::new("", &names, &["holds", "strained", "broken"], &values)
        .axes("assumption", "share of designs, %")
        .decimals(0)
        .to_svg()?;
    let page = page.section("How often").table(&table);
    Ok(page.figure(&drawn, "Share of the designs, in per cent, for which each assumption holds, is strained, is broken."))
}

fn effects(page: Page, answer: &SpaceAuditAnswer) -> Result<Page, StudyError> {
    let mut page = page.section("What it does");
    for name in EffectOn::NAMES {
        let found: Vec<(&str, [f64; 3])> = answer
            .shares
            .iter()
            .map(|s| (s.id.as_str(), quartiles(answer, &s.id, name)))
            .filter(|(_, q)| q.iter().any(|v| v.abs() >= 0.1))
            .collect();
        if found.is_empty() {
            page = page.text(&format!("{name}: no assumption moves it by a tenth of a per cent."));
            continue;
        }
        let labels: Vec<&str> = found.iter().map(|f| f.0).collect();
        let [low, middle, high] = [0, 1, 2].map(|k| found.iter().map(|f| f.1[k]).collect::<Vec<f64>>());
        let drawn = Bars::new("", &labels)
            .x(&format!("change of {name}"), "%")
            .series_with_interval("median and quartiles", &middle, &low, &high)
            .ranked()
            .to_svg()?;
        page = page.figure(&drawn, &format!("Change of {name} when finite elements replace one assumption: median of the designs, and the middle half of them."));
    }
    Ok(page)
}

/// Quartiles of an assumption's effect on a coefficient, %.
fn quartiles(answer: &SpaceAuditAnswer, id: &str, name: &str) -> [f64; 3] {
    let mut values: Vec<f64> = rows(answer, id).map(|(_, row)| row.effect_pct.get(name).copied().unwrap_or(0.0)).collect();
    values.sort_by(f64::total_cmp);
    let at =
        |share: f64| values.get((share * (values.len().saturating_sub(1)) as f64).round() as usize).copied().unwrap_or(f64::NAN);
    [at(0.25), at(0.5), at(0.75)]
}

fn rows<'a>(answer: &'a SpaceAuditAnswer, id: &'a str) -> impl Iterator<Item = (&'a Audited, &'a Row)> {
    answer.designs.iter().flat_map(|d| d.rows.iter().map(move |r| (d, r))).filter(move |(_, r)| r.id == id)
}

fn places(page: Page, answer: &SpaceAuditAnswer) -> Result<Page, StudyError> {
    let found = wheres(answer);
    let page = page.section("Where in the space").text(
        "For each assumption whose verdict is not the same everywhere, with three designs or more on either side: the quantity of a design that tells best on which side it lies. The share is that of \
         pairs, one design from each side, that this quantity alone puts in the right order: 50 % is chance.",
    );
    if found.is_empty() {
        return Ok(page.text("No verdict differs between enough designs."));
    }
    let head = Table::new(&[
        "assumption",
        "verdict",
        "designs",
        "quantity",
        "right order %",
        "median where so",
        "median elsewhere",
        "unit",
    ])
    .dense();
    let table = found.iter().fold(head, |table, w| {
        let (unit, factor) = w.axis.quantity.unit();
        let cells = [w.id.as_str(), word(w.verdict), &w.designs.to_string(), w.axis.quantity.symbol()].map(String::from).to_vec();
        let right = format!("{:.0}", 100.0 * w.right);
        table.row(&[cells, vec![right, number(factor * w.inside), number(factor * w.outside), unit.into()]].concat())
    });
    let mut page = page.table(&table);
    for one in found.iter().filter(|w| w.right >= 0.8) {
        page = page.figure(&scatter(answer, one)?, &format!("{}: its measure over {}.", one.id, one.axis.quantity));
    }
    Ok(page)
}

fn scatter(answer: &SpaceAuditAnswer, at: &Where) -> Result<String, StudyError> {
    let (unit, factor) = at.axis.quantity.unit();
    let measure = rows(answer, &at.id).map(|(_, row)| row.measure_name.clone()).next().unwrap_or_default();
    let mut figure = Figure::new("").x(at.axis.quantity.symbol(), unit).y(&measure, "");
    let positive = rows(answer, &at.id).all(|(_, row)| row.measure > 0.0);
    if positive {
        figure = figure.log_y();
    }
    for verdict in [Verdict::Holds, Verdict::Strained, Verdict::Broken] {
        let points: Vec<(f64, f64)> = rows(answer, &at.id)
            .filter(|(_, row)| row.verdict == verdict)
            .map(|(d, row)| (factor * d.values[at.place], row.measure))
            .collect();
        let (x, y): (Vec<f64>, Vec<f64>) = points.into_iter().unzip();
        if !x.is_empty() {
            figure = figure.points(word(verdict), &x, &y);
        }
    }
    if let Some((_, row)) = rows(answer, &at.id).next() {
        figure = figure.mark_y(row.limit, "limit");
    }
    Ok(figure.to_svg()?)
}

fn refused(page: Page, answer: &SpaceAuditAnswer) -> Page {
    let designs: Vec<String> =
        answer.designs.iter().filter_map(|d| Some(format!("design {}: {}", d.design, d.refused.as_ref()?))).collect();
    let rows: Vec<String> = answer
        .designs
        .iter()
        .flat_map(|d| d.failed.iter().map(|(id, why)| format!("design {}, {id}: {why}", d.design)))
        .collect();
    let told = |page: Page, what: &str, lines: Vec<String>| {
        if lines.is_empty() { page } else { page.details(&format!("{} {what}", lines.len())).list(&lines).end_details() }
    };
    if designs.is_empty() && rows.is_empty() {
        return page;
    }
    let page = told(page.section("Without an answer"), "designs without rows", designs);
    told(page, "rows that are missing in designs with others", rows)
}

fn provenance(page: Page, answer: &SpaceAuditAnswer) -> Page {
    let list =
        |values: &[f64], factor: f64, unit: &str| values.iter().map(|v| text(factor * v, unit)).collect::<Vec<_>>().join(",");
    let line = |axis: &Axis| {
        let (unit, factor) = axis.quantity.unit();
        let choice = match &axis.choice {
            Choice::Continuous(low, high) => format!("{}:{}", text(factor * low, unit), text(factor * high, unit)),
            Choice::Levels(levels) => list(levels, factor, unit),
            Choice::Whole(low, high) => format!("{low}:{high}"),
        };
        format!("{} = \"{choice}\"\n", axis.quantity)
    };
    let axes: String = answer.space.iter().map(line).collect();
    let only = if answer.only.is_empty() { String::new() } else { format!("only = {:?}\n", answer.only) };
    let toml = format!(
        "schema = \"truegap.space/1\"\nsensor = \"{}\"\ndesigns = {}\nseed = {}\n{only}[axes]\n{axes}",
        answer.sensor, answer.count, answer.seed
    );
    page.section("How to make this page again")
        .text("With this file as space.toml: truegap audit --space space.toml -o DIR")
        .code(&toml)
}

/// A value with its unit, without the rounding of the factor.
fn text(value: f64, unit: &str) -> String {
    format!("{} {unit}", (value * 1e9).round() / 1e9).trim_end().to_owned()
}
