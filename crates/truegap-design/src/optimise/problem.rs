//! A space with constraints, and the three temperature coefficients relative to those of the starting design.
//!
//! Limits: coefficients count by their size, so a coefficient that changes its sign may pass through 0.

use super::{
    constraint::{CONSTRAINTS, Constraint, Useful},
    design::Design,
    front::{Evaluation, Front, SearchOptions, front},
    latin::latin_hypercube,
    space::Space,
    vector::descend,
};
use crate::{
    error::DesignError,
    metric::{Metric, Metrics},
    metrics::{MetricOptions, metrics},
};
use rayon::prelude::*;
use serde::Serialize;

/// What is minimised, in size: the three temperature coefficients of \[hampson2023\].
pub const OBJECTIVES: [Metric; 3] = [Metric::KBaseline, Metric::KSensitivity, Metric::KLinearity];

/// A space, constraints and the starting design's metrics.
#[derive(Clone, Debug)]
pub struct DesignProblem {
    space: Space,
    useful: Useful,
    options: MetricOptions,
    base: Metrics,
}

/// A design with all its numbers.
#[derive(Clone, Debug, PartialEq, Serialize)]
pub struct Candidate {
    /// values of the axes, SI
    pub values: Vec<f64>,
    /// metrics; `None` where the plates touch
    pub metrics: Option<Metrics>,
    /// sizes of the coefficients over those of the starting design, infinite where the plates touch
    pub ratios: [f64; 3],
    /// violations in the order of [`CONSTRAINTS`]
    pub violations: [f64; CONSTRAINTS.len()],
}

/// Share of the space that a constraint excludes.
#[derive(Clone, Copy, Debug, PartialEq, Serialize)]
pub struct Exclusion {
    /// the constraint
    pub constraint: Constraint,
    /// share of all designs that break it
    pub share: f64,
    /// share of all designs that break it and no other
    pub alone: f64,
}

impl DesignProblem {
    /// A problem around the space's own sensor.
    ///
    /// # Errors
    /// As [`metrics`] for the starting design; [`DesignError::NoSuchLimit`].
    pub fn new(space: Space, useful: Useful, options: MetricOptions) -> Result<Self, DesignError> {
        useful.check()?;
        let base = metrics(space.base(), options)?;
        Ok(Self { space, useful, options, base })
    }

    /// The space.
    pub fn space(&self) -> &Space {
        &self.space
    }

    /// Metrics of the starting design.
    pub fn base(&self) -> &Metrics {
        &self.base
    }

    /// A design with all its numbers.
    pub fn candidate(&self, unit: &[f64]) -> Candidate {
        let values = self.space.values(unit);
        let sensor = self.space.sensor(&values);
        let found = metrics(&sensor, self.options).ok();
        let ratio = |metric: Metric| found.map_or(f64::INFINITY, |m| (m.of(metric) / self.base.of(metric)).abs());
        let violations = self.useful.violations(&sensor, found.as_ref(), &self.base);
        Candidate { values, metrics: found, ratios: OBJECTIVES.map(ratio), violations }
    }

    /// What each constraint excludes, on `tried` Latin hypercube points, and the share of designs that meet all.
    pub fn exclusions(&self, tried: usize, seed: u64) -> (Vec<Exclusion>, f64) {
        let points = latin_hypercube(tried, self.space.axes().len(), seed);
        let broken: Vec<_> = points.par_iter().map(|unit| self.candidate(unit).violations.map(|v| v > 0.0)).collect();
        let share =
            |test: &dyn Fn(&[bool; CONSTRAINTS.len()]) -> bool| broken.iter().filter(|b| test(b)).count() as f64 / tried as f64;
        let count = |b: &[bool; CONSTRAINTS.len()]| b.iter().filter(|&&b| b).count();
        let row = |(i, &constraint): (usize, &Constraint)| Exclusion {
            constraint,
            share: share(&|b| b[i]),
            alone: share(&|b| b[i] && count(b) == 1),
        };
        (CONSTRAINTS.iter().enumerate().map(row).collect(), share(&|b| count(b) == 0))
    }

    /// Front of some of the three coefficients, given by their places in [`OBJECTIVES`].
    ///
    /// # Errors
    /// [`DesignError::Infeasible`] names which constraint excludes how much.
    pub fn front<const M: usize>(&self, objectives: [usize; M], search: SearchOptions) -> Result<Front<M>, DesignError> {
        let function = |unit: &[f64]| {
            let candidate = self.candidate(unit);
            Evaluation { objectives: objectives.map(|o| candidate.ratios[o]), violation: candidate.violations.iter().sum() }
        };
        let found = front(function, self.space.axes().len(), search);
        if found.points.is_empty() { Err(self.infeasible(search)) } else { Ok(found) }
    }

    /// Why there is no design: which constraint excludes how much.
    fn infeasible(&self, search: SearchOptions) -> DesignError {
        let (mut rows, _) = self.exclusions(search.starts, search.seed);
        rows.sort_by(|a, b| b.share.total_cmp(&a.share));
        let told =
            rows.iter().filter(|r| r.share > 0.0).map(|r| format!("{:.1} % break \"{}\"", 100.0 * r.share, r.constraint.says()));
        DesignError::Infeasible { tried: search.starts, excluded: told.collect::<Vec<_>>().join(", ") }
    }

    /// The minimisation vector: from the best of a front, the design whose worst coefficient, relative to the starting design, is smallest. Returns its point of the
    /// unit cube and the evaluations spent; `None` for an empty front.
    pub fn along_vector(&self, front: &[Design]) -> Option<(Vec<f64>, usize)> {
        let worst = |ratios: &[f64; 3]| ratios.iter().copied().fold(0.0, f64::max);
        let start = front.iter().min_by(|a, b| worst(&a.ratios).total_cmp(&worst(&b.ratios)))?;
        let value = |unit: &[f64]| {
            let candidate = self.candidate(unit);
            if candidate.violations.iter().all(|&v| v == 0.0) { worst(&candidate.ratios) } else { f64::INFINITY }
        };
        let (unit, _, evaluations) = descend(value, &start.unit, 5000);
        Some((unit, evaluations))
    }
}
