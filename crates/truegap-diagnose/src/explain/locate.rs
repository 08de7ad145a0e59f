//! Where recording and calibrated base model differ: along which physical direction, in which interval, in which runs.
//!
//! Limits: what calibration absorbs is not located here but by [`crate::explain::conflicts`].

use crate::{
    adequacy::{
        directions::{Direction, Driver},
        lack_of_fit::LackOfFitTests,
    },
    data::{context::load_column, problem::Problem},
    explain::tuning::{LOUD_RUN, PLACE_LEVEL},
    fit::optimum::Fit,
    text::Scale,
};
use serde::Serialize;
use std::collections::BTreeMap;
use truegap_core::ends;

/// A place where recording and calibrated base model differ.
#[derive(Clone, Debug, Serialize)]
pub struct Mismatch {
    /// sentence with units
    pub says: String,
    /// column that orders it
    pub driver: String,
    /// what of it, in words: `with the speed of the load`
    pub along: String,
    /// interval of that column where most of it lies
    pub interval: [f64; 2],
    /// runs concerned, by their number in the recording
    pub runs: Vec<u32>,
    /// share of the mismatch along this direction
    pub share: f64,
    /// family-wise p-value
    pub p_value: f64,
}

/// Mean residual over noise in cells of load and temperature (or time, where one of them does not change).
#[derive(Clone, Debug)]
pub struct Map {
    /// label of the horizontal axis with unit
    pub x_label: String,
    /// label of the vertical axis with unit
    pub y_label: String,
    /// cell edges
    pub x_edges: Vec<f64>,
    /// cell edges
    pub y_edges: Vec<f64>,
    /// `values[y][x]`, mean residual times sqrt(rows) over noise; NaN where no row fell
    pub values: Vec<Vec<f64>>,
}

/// Directions along which the fit is wrong, largest share first.
pub fn locate(problem: &Problem<'_>, fit: &Fit, lack_of_fit: &LackOfFitTests, directions: &[Direction]) -> Vec<Mismatch> {
    let scores = lack_of_fit.scores(fit);
    let total = scores.joint().excess().max(1.0);
    let mut groups: BTreeMap<Driver, Vec<usize>> = BTreeMap::new();
    directions.iter().enumerate().for_each(|(i, d)| groups.entry(d.driver).or_default().push(i));
    let tests = groups.len() as f64;
    let mut found: Vec<Mismatch> = Vec::new();
    for (driver, columns) in &groups {
        let test = scores.subset(columns);
        let p_value = (test.p_value * tests).min(1.0);
        if p_value < PLACE_LEVEL {
            found.push(mismatch(problem, fit, *driver, test.excess() / total, p_value));
        }
    }
    found.sort_by(|a, b| b.share.total_cmp(&a.share));
    found
}

fn mismatch(problem: &Problem<'_>, fit: &Fit, driver: Driver, share: f64, p_value: f64) -> Mismatch {
    let quantity = quantity(problem, driver);
    let interval = interval(&quantity.column, &fit.residual);
    let runs = runs(problem, fit);
    let where_ = if interval[0] < interval[1] { format!(", most of it {}", quantity.between(interval)) } else { String::new() };
    let along = driver.says(problem.inputs);
    let says = format!("recording and calibrated model differ {along}{where_}");
    let column = driver.column(problem.inputs).into_owned();
    Mismatch { says, driver: column, along, interval, runs, share: share.clamp(0.0, 1.0), p_value }
}

/// A column that orders a mismatch, with the words before its interval and its unit.
struct Quantity {
    at: String,
    unit: String,
    column: Vec<f64>,
}

impl Quantity {
    /// Where it lies, in words: `at forces from 1.20 to 3.40 N`, `in runs 2 to 5`.
    fn between(&self, [low, high]: [f64; 2]) -> String {
        match self.unit.as_str() {
            "" => format!("{} {low:.0} to {high:.0}", self.at),
            unit => format!("{} {}", self.at, crate::text::interval(low, high, unit)),
        }
    }
}

/// The column in SI that a reader knows.
fn quantity(problem: &Problem<'_>, driver: Driver) -> Quantity {
    let inputs = problem.inputs;
    let recorded = |column: &Option<Vec<f64>>, at: &str, unit: &str| {
        column.clone().map(|column| Quantity { at: at.into(), unit: unit.into(), column })
    };
    if let Driver::Recorded(index, _) = driver
        && let Some(d) = inputs.drivers.get(index)
    {
        return Quantity { at: format!("at {} from", d.name), unit: d.unit.clone(), column: d.values.clone() };
    }
    let found = match driver.column(inputs).as_ref() {
        "simulated" => recorded(&inputs.simulated, "at simulated values from", problem.simulator.simulated_unit()),
        "load" => recorded(&inputs.force_n, "at forces from", "N")
            .or_else(|| recorded(&inputs.pressure_pa, "at pressures from", "Pa"))
            .or_else(|| recorded(&inputs.gap_m, "at gaps from", "m"))
            .or_else(|| recorded(&load_column(inputs, problem.simulator), "at shares of the full load from", "1")),
        "temperature_c" => recorded(&inputs.temperature_c, "at temperatures from", "°C"),
        "time_s" => recorded(&inputs.time_s, "at times from", "s"),
        "humidity_pct" => recorded(&inputs.humidity_pct, "at humidities from", "%"),
        _ => None,
    };
    let runs = || inputs.run.iter().map(|r| f64::from(*r)).collect();
    found.unwrap_or_else(|| Quantity { at: "in runs".into(), unit: String::new(), column: runs() })
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
    problem.runs().iter().filter(|r| excess(r) > LOUD_RUN).map(|r| problem.inputs.run[r.start]).collect()
}

/// Mean whitened residual in cells of load against temperature, or against order where one of them does not change.
pub fn map(problem: &Problem<'_>, residual: &[f64]) -> Option<Map> {
    let inputs = problem.inputs;
    let moving = |c: Option<Vec<f64>>| c.filter(|c| crate::stats::spread(c) > 1e-9);
    let axis = |name: &str, unit: &str, column: &Option<Vec<f64>>| {
        let column = moving(column.clone())?;
        let scale = Scale::of(unit, column.iter().fold(0.0, |m: f64, v| m.max(v.abs())));
        let label = if scale.unit.is_empty() { name.to_owned() } else { format!("{name} ({})", scale.unit) };
        Some((label, scale.column(&column)))
    };
    let load = axis("force", "N", &inputs.force_n)
        .or_else(|| axis("pressure", "Pa", &inputs.pressure_pa))
        .or_else(|| axis("gap", "m", &inputs.gap_m))
        .or_else(|| inputs.drivers.iter().find_map(|d| axis(&d.name, &d.unit, &Some(d.values.clone()))));
    let temperature = axis("temperature", "°C", &inputs.temperature_c);
    let runs = Some(inputs.run.iter().map(|r| f64::from(*r)).collect());
    let clock = axis("time", "s", &inputs.time_s).or_else(|| axis("run", "", &runs));
    let mut axes = [load, temperature, clock].into_iter().flatten();
    let ((x_label, x), (y_label, y)) = (axes.next()?, axes.next()?);
    let (x_edges, y_edges) = (edges(&x, 10), edges(&y, 8));
    let mut sums = vec![vec![(0.0, 0usize); 10]; 8];
    for row in 0..residual.len() {
        let cell = &mut sums[bin(&y_edges, y[row])][bin(&x_edges, x[row])];
        *cell = (cell.0 + residual[row], cell.1 + 1);
    }
    // a cell of the map without rows has no value: NaN, which JSON writes as null
    let mean = |(sum, count): (f64, usize)| if count == 0 { f64::NAN } else { sum / (count as f64).sqrt() };
    let values = sums.into_iter().map(|line| line.into_iter().map(mean).collect()).collect();
    Some(Map { x_label, y_label, x_edges, y_edges, values })
}

fn edges(column: &[f64], bins: usize) -> Vec<f64> {
    let (low, high) = ends(column.iter().copied());
    (0..=bins).map(|i| low + (high - low) * i as f64 / bins as f64).collect()
}

fn bin(edges: &[f64], value: f64) -> usize {
    let width = edges[1] - edges[0];
    (((value - edges[0]) / width) as usize).min(edges.len() - 2)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_place_is_told_in_the_units_of_a_bench() {
        let at =
            |at: &str, unit: &str, interval| Quantity { at: at.into(), unit: unit.into(), column: Vec::new() }.between(interval);
        assert_eq!(at("at gaps from", "m", [0.0005, 0.00725]), "at gaps from 0.50 to 7.25 mm");
        assert_eq!(at("at times from", "s", [60.0, 5400.0]), "at times from 1.0 to 90.0 min");
        assert_eq!(at("at pressures from", "Pa", [5562.0, 121_000.0]), "at pressures from 6 to 121 kPa");
        assert_eq!(at("in runs", "", [2.0, 5.0]), "in runs 2 to 5");
    }
}
