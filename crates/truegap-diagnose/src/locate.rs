//! Where recording and calibrated base model differ: along which physical direction, in which interval, in which runs.
//!
//! Limits: what calibration absorbs is not located here but by [`crate::conflicts`].

use crate::context::load_column;
use crate::{
    diagnosis::{Map, Mismatch},
    directions::{Direction, Driver},
    fit::Fit,
    gate::Gate,
    problem::Problem,
};
use std::collections::BTreeMap;

/// Level below which a direction is reported.
const LEVEL: f64 = 1e-3;

/// Directions along which the fit is wrong, largest share first.
pub fn locate(problem: &Problem<'_>, fit: &Fit, gate: &Gate, directions: &[Direction]) -> Vec<Mismatch> {
    let scores = gate.scores(fit);
    let total = scores.joint().excess().max(1.0);
    let mut groups: BTreeMap<Driver, Vec<usize>> = BTreeMap::new();
    directions.iter().enumerate().for_each(|(i, d)| groups.entry(d.driver).or_default().push(i));
    let tests = groups.len() as f64;
    let mut found: Vec<Mismatch> = Vec::new();
    for (driver, columns) in &groups {
        let test = scores.subset(columns);
        let p_value = (test.p_value * tests).min(1.0);
        if p_value < LEVEL {
            found.push(mismatch(problem, fit, *driver, test.excess() / total, p_value));
        }
    }
    found.sort_by(|a, b| b.share.total_cmp(&a.share));
    found
}

fn mismatch(problem: &Problem<'_>, fit: &Fit, driver: Driver, share: f64, p_value: f64) -> Mismatch {
    let column = driver_column(problem, driver);
    let interval = interval(&column, &fit.residual);
    let runs = runs(problem, fit);
    let where_ = if interval[0] < interval[1] {
        format!(", most of it for {} between {:.4} and {:.4}", label(problem, driver), interval[0], interval[1])
    } else {
        String::new()
    };
    let says = format!("recording and calibrated model differ {}{where_}", driver.says());
    Mismatch { says, driver: driver.column().into(), interval, runs, share: share.clamp(0.0, 1.0), p_value }
}

fn label(problem: &Problem<'_>, driver: Driver) -> &'static str {
    match driver.column() {
        "load" if problem.inputs.force_n.is_some() => "a force in N",
        "load" if problem.inputs.pressure_pa.is_some() => "a pressure in Pa",
        "load" if problem.inputs.gap_m.is_some() => "a gap in m",
        "load" => "a share of the full load",
        "temperature_c" => "temperatures in degC",
        "time_s" => "times in s",
        "humidity_pct" => "humidities in %",
        _ => "runs",
    }
}

/// Column in SI that a reader knows.
fn driver_column(problem: &Problem<'_>, driver: Driver) -> Vec<f64> {
    let inputs = problem.inputs;
    let or_empty = |c: &Option<Vec<f64>>| c.clone().unwrap_or_default();
    match driver.column() {
        "load" => inputs
            .force_n
            .clone()
            .or_else(|| inputs.pressure_pa.clone())
            .or_else(|| load_column(inputs, problem.simulator))
            .unwrap_or_default(),
        "temperature_c" => or_empty(&inputs.temperature_c),
        "time_s" => or_empty(&inputs.time_s),
        "humidity_pct" => or_empty(&inputs.humidity_pct),
        _ => inputs.run.iter().map(|r| f64::from(*r)).collect(),
    }
}

/// Shortest stretch of ten equally filled bins that holds 60 % of the squared bin means.
fn interval(column: &[f64], residual: &[f64]) -> [f64; 2] {
    const BINS: usize = 10;
    if column.len() != residual.len() || column.len() < 4 * BINS {
        return [0.0, 0.0];
    }
    let mut order: Vec<usize> = (0..column.len()).collect();
    order.sort_by(|a, b| column[*a].total_cmp(&column[*b]));
    let bins: Vec<&[usize]> = order.chunks(column.len().div_ceil(BINS)).collect();
    let weight: Vec<f64> = bins.iter().map(|b| b.iter().map(|r| residual[*r]).sum::<f64>().powi(2) / b.len() as f64).collect();
    let total: f64 = weight.iter().sum();
    let mut best = (0, bins.len() - 1);
    for first in 0..bins.len() {
        for last in first..bins.len() {
            if weight[first..=last].iter().sum::<f64>() >= 0.6 * total && last - first < best.1 - best.0 {
                best = (first, last);
            }
        }
    }
    let (first, last) = (bins[best.0], bins[best.1]);
    [column[first[0]], column[last[last.len() - 1]]]
}

/// Runs whose residual is larger than noise.
fn runs(problem: &Problem<'_>, fit: &Fit) -> Vec<u32> {
    let excess = |run: &std::ops::Range<usize>| {
        let n = run.len() as f64;
        let squares: f64 = fit.residual[run.clone()].iter().map(|r| r * r).sum();
        let mean: f64 = fit.residual[run.clone()].iter().sum();
        ((squares - n) / (2.0 * n).sqrt()).max(mean.abs() / n.sqrt())
    };
    problem.runs().iter().filter(|r| excess(r) > 4.0).map(|r| problem.inputs.run[r.start]).collect()
}

/// Mean whitened residual in cells of load against temperature, or against order where one of them does not change.
pub fn map(problem: &Problem<'_>, residual: &[f64]) -> Option<Map> {
    let inputs = problem.inputs;
    let moving = |c: Option<Vec<f64>>| c.filter(|c| crate::directions::spread(c) > 1e-9);
    let load = moving(inputs.force_n.clone())
        .map(|c| ("force / N", c))
        .or_else(|| moving(inputs.pressure_pa.clone()).map(|c| ("pressure / Pa", c)))
        .or_else(|| moving(inputs.gap_m.clone()).map(|c| ("gap / m", c)));
    let temperature = moving(inputs.temperature_c.clone()).map(|c| ("temperature / degC", c));
    let clock = moving(inputs.time_s.clone())
        .map(|c| ("time / s", c))
        .or_else(|| moving(Some(inputs.run.iter().map(|r| f64::from(*r)).collect())).map(|c| ("run", c)));
    let mut axes = [load, temperature, clock].into_iter().flatten();
    let ((x_label, x), (y_label, y)) = (axes.next()?, axes.next()?);
    let (x_edges, y_edges) = (edges(&x, 10), edges(&y, 8));
    let mut sums = vec![vec![(0.0, 0usize); 10]; 8];
    for row in 0..residual.len() {
        let cell = &mut sums[bin(&y_edges, y[row])][bin(&x_edges, x[row])];
        *cell = (cell.0 + residual[row], cell.1 + 1);
    }
    let mean = |(sum, count): (f64, usize)| if count == 0 { f64::NAN } else { sum / (count as f64).sqrt() };
    let values = sums.into_iter().map(|line| line.into_iter().map(mean).collect()).collect();
    Some(Map { x_label: x_label.into(), y_label: y_label.into(), x_edges, y_edges, values })
}

fn edges(column: &[f64], bins: usize) -> Vec<f64> {
    let (low, high) = column.iter().fold((f64::INFINITY, f64::NEG_INFINITY), |(l, h), v| (l.min(*v), h.max(*v)));
    (0..=bins).map(|i| low + (high - low) * i as f64 / bins as f64).collect()
}

fn bin(edges: &[f64], value: f64) -> usize {
    let width = edges[1] - edges[0];
    (((value - edges[0]) / width) as usize).min(edges.len() - 2)
}
