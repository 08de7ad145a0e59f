//! The paper's studies on any [`Model`]: leaders one at a time, the minimisation vector, a batch.
//!
//! Limits: smaller searches and batches than the commands', because the corrected model takes longer.

use crate::model::Model;
use truegap::core::Sensor;
use truegap::design::optimise::{
    Axis, CONSTRAINTS, Choice, Evaluation, OBJECTIVES, SearchOptions, Space, Useful, descend, front,
};
use truegap::design::sensitivity::PAPER_QUANTITIES;
use truegap::design::tolerance::{normal_quantile, tolerances, uniform};
use truegap::design::{DesignError, Metric, Metrics, Quantity};

/// Quantities in the order in which 10 % of them moves a metric, the first the most.
pub fn leaders(model: Model, sensor: &Sensor, metric: Metric) -> Option<Vec<Quantity>> {
    let base = model.metrics(sensor)?.of(metric);
    let size = |quantity: Quantity| -> Option<f64> {
        let value = quantity.of(sensor)?.value;
        let moved = |factor: f64| {
            let mut sensor = sensor.clone();
            quantity.set(&mut sensor, value * factor);
            model.metrics(&sensor).map_or(f64::NAN, |m| (m.of(metric) - base).abs())
        };
        Some(moved(0.9).max(moved(1.1)))
    };
    let mut sizes: Vec<(Quantity, f64)> = PAPER_QUANTITIES.into_iter().filter_map(|q| Some((q, size(q)?))).collect();
    sizes.sort_by(|a, b| b.1.total_cmp(&a.1));
    Some(sizes.into_iter().map(|(quantity, _)| quantity).collect())
}

/// Design along the minimisation vector: values of the axes, ratios of the three coefficients, and the share of all starts that met the constraints.
pub struct Along {
    /// axes
    pub axes: Vec<Axis>,
    /// values, SI
    pub values: Vec<f64>,
    /// sizes of the coefficients over the starting design's
    pub ratios: [f64; 3],
}

/// The minimisation vector within the paper's space.
pub fn along(model: Model, sensor: &Sensor) -> Result<Option<Along>, DesignError> {
    let space = Space::paper(sensor.clone())?;
    let Some(base) = model.metrics(sensor) else { return Ok(None) };
    let judged = |unit: &[f64]| {
        let sensor = space.sensor(&space.values(unit));
        let found = model.metrics(&sensor);
        let ratio = |metric: Metric| found.map_or(f64::INFINITY, |m: Metrics| (m.of(metric) / base.of(metric)).abs());
        let violations: [f64; CONSTRAINTS.len()] = Useful::default().violations(&sensor, found.as_ref(), &base);
        Evaluation { objectives: OBJECTIVES.map(ratio), violation: violations.iter().sum() }
    };
    let worst = |e: &Evaluation<3>| {
        if e.violation > 0.0 { f64::INFINITY } else { e.objectives.iter().copied().fold(0.0, f64::max) }
    };
    let found = front(judged, space.axes().len(), SearchOptions { starts: 1000, directions: 45, sweeps: 50, seed: 1 });
    let size = |ratios: &[f64; 3]| ratios.iter().copied().fold(0.0, f64::max);
    let Some(start) = found.points.iter().min_by(|a, b| size(&a.objectives).total_cmp(&size(&b.objectives))) else {
        return Ok(None);
    };
    let (unit, _, _) = descend(|unit| worst(&judged(unit)), &start.unit, 800);
    Ok(Some(Along { axes: space.axes().to_vec(), values: space.values(&unit), ratios: judged(&unit).objectives }))
}

impl Along {
    /// The design in words.
    pub fn says(&self) -> String {
        let part = |(axis, value): (&Axis, &f64)| {
            let (unit, factor) = axis.quantity.unit();
            let digits = if matches!(axis.choice, Choice::Whole(..)) { 0 } else { 2 };
            format!("{} {:.digits$} {unit}", axis.quantity.symbol(), value * factor)
        };
        self.axes.iter().zip(&self.values).map(part).collect::<Vec<_>>().join(", ")
    }
}

/// Standard deviation of a metric in a batch, and that relative to the mean in per cent, for each metric; sensors without an answer are left out.
pub fn scatter(model: Model, sensor: &Sensor, samples: usize) -> Vec<(f64, f64)> {
    let spread: Vec<_> = tolerances(sensor).into_iter().filter_map(|q| Some((q, q.of(sensor)?))).collect();
    let one = |point: usize| {
        let mut mine = sensor.clone();
        for (dimension, (quantity, measure)) in spread.iter().enumerate() {
            quantity.set(&mut mine, measure.value + measure.sd * normal_quantile(uniform(1, point, dimension)));
        }
        model.metrics(&mine)
    };
    let all: Vec<Metrics> = (0..samples).filter_map(one).collect();
    let count = all.len() as f64;
    let of = |m: usize| {
        let mean = all.iter().map(|s| s.0[m]).sum::<f64>() / count;
        let sd = (all.iter().map(|s| (s.0[m] - mean).powi(2)).sum::<f64>() / count).sqrt();
        (sd, 100.0 * sd / mean.abs())
    };
    (0..7).map(of).collect()
}
