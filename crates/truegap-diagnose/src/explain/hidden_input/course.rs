//! Recovers the slow course of an input that was not recorded, from what the calibrated base model leaves over.
//!
//! Limits: one course, through the zero or through the gain of the reading; Gaussian, about one calibration.

use crate::{
    explain::hidden_input::knots::{Hat, Knots},
    explain::tuning::{COURSE_SCALES, COURSE_STEPS},
    fit::laplace::log_determinant,
    selection::candidates::{Search, Tried},
};
use nalgebra::{Cholesky, DMatrix, DVector, Dyn};
use std::ops::Range;
use truegap_core::{Drive, Inputs, Readout, SimulationError, Stage};

/// How the course reaches the reading.
#[derive(Clone, Copy, Debug, PartialEq, Eq, serde::Serialize)]
#[serde(rename_all = "snake_case")]
pub enum Through {
    /// added to the reading
    Zero,
    /// relative change of what stands above the reading at rest
    Gain,
}

/// A course that was recovered.
pub struct Course {
    /// how it reaches the reading
    pub through: Through,
    /// its knots
    pub knots: Knots,
    /// level at each knot: response unit, or relative
    pub levels: Vec<f64>,
    /// standard deviation of each level about the mean of the course: its height is the base model's to know
    pub sd: Vec<f64>,
    /// base parameters beside it, prior-whitened
    pub z: Vec<f64>,
    /// log evidence, comparable with that of the models of the search; scales and ways that were tried are paid for
    pub log_evidence: f64,
}

/// The course as a stage, a value a row.
struct Slow {
    through: Through,
    course: Vec<f64>,
    runs: Vec<Range<usize>>,
}

impl Stage for Slow {
    fn after_runs(&self, runs: usize) -> Option<Box<dyn Stage>> {
        let first = self.runs.get(runs).map_or(0, |r| r.start);
        Some(Box::new(Self { through: self.through, course: self.course[first..].to_vec(), runs: Vec::new() }))
    }

    fn readout(&self, _: &Drive<'_>, readout: &Readout, value: &mut [f64]) {
        for (value, course) in value.iter_mut().zip(&self.course) {
            *value += match self.through {
                Through::Zero => *course,
                Through::Gain => course * (*value - readout.zero),
            };
        }
    }
}

/// Level of the course at each row.
pub fn along(hats: &[Hat], levels: &[f64]) -> Vec<f64> {
    hats.iter().map(|hat| hat.iter().map(|(k, w)| w * levels[*k]).sum()).collect()
}

/// Response of rows `inputs` with base parameters `z` and a course.
pub fn respond(
    search: &Search<'_>,
    inputs: &Inputs,
    z: &[f64],
    through: Through,
    course: Vec<f64>,
) -> Result<Vec<f64>, SimulationError> {
    let values = search.model(&[]).values(z);
    search.problem.simulator.respond(&values, inputs, &[&Slow { through, course, runs: inputs.runs() }])
}

/// The likeliest course; `None` where the model has no answer beside one.
pub fn recover(search: &Search<'_>, base: &Tried) -> Option<Course> {
    let inputs = search.problem.inputs;
    let recordings: Vec<Range<usize>> = match search.problem.simulator.joined() {
        Some(joined) => (0..joined.count()).map(|k| joined.rows(k, inputs)).collect(),
        None => std::iter::once(0..inputs.len()).collect(),
    };
    let knots = Knots::new(inputs, &recordings);
    let hats = knots.hats(inputs);
    let ways = [Through::Zero, Through::Gain].into_iter().filter_map(|through| {
        let fitter = Fitter { search, knots: &knots, hats: &hats, through };
        let here = fitter.linearised(&base.fit.z, &vec![0.0; knots.count()])?;
        let unit = if through == Through::Zero { search.context.response_span.abs() } else { 1.0 };
        let tried = COURSE_SCALES.iter().filter_map(|s| here.solve(&knots, s * unit).map(|solved| (s * unit, solved)));
        let (scale, solved) = tried.max_by(|a, b| a.1.log_evidence.total_cmp(&b.1.log_evidence))?;
        fitter.relinearised(solved, scale)
    });
    let (through, solved) = ways.max_by(|a, b| a.1.log_evidence.total_cmp(&b.1.log_evidence))?;
    let paid = (2.0 * COURSE_SCALES.len() as f64).ln();
    let p = solved.z.len();
    let n = p + solved.levels.len();
    let sd = about_its_mean(&solved.factor.inverse().view_range(p..n, p..n).into_owned());
    let log_evidence = solved.log_evidence - paid;
    Some(Course { through, knots, levels: solved.levels, sd, z: solved.z, log_evidence })
}

/// Standard deviations of levels about their own mean, the well-known ones weighing most.
fn about_its_mean(covariance: &DMatrix<f64>) -> Vec<f64> {
    let n = covariance.nrows();
    let mut weight = DVector::from_element(n, 1.0 / n as f64);
    let mut variance = vec![0.0; n];
    for _ in 0..3 {
        let with_mean = covariance * &weight;
        let of_mean = weight.dot(&with_mean);
        (0..n).for_each(|k| variance[k] = (covariance[(k, k)] - 2.0 * with_mean[k] + of_mean).max(f64::MIN_POSITIVE));
        let total: f64 = variance.iter().map(|v| 1.0 / v).sum();
        (0..n).for_each(|k| weight[k] = 1.0 / (variance[k] * total));
    }
    variance.into_iter().map(f64::sqrt).collect()
}

/// One way of a course to the reading.
struct Fitter<'a> {
    search: &'a Search<'a>,
    knots: &'a Knots,
    hats: &'a [Hat],
    through: Through,
}

/// The whitened model made straight about a point.
struct Linear {
    /// base parameters and levels of the point
    at: DVector<f64>,
    /// base parameters, number
    base: usize,
    /// whitened residual there
    residual: DVector<f64>,
    /// change of the response with parameters and levels, whitened
    gram: DMatrix<f64>,
    gradient: DVector<f64>,
}

/// An optimum.
struct Solved {
    z: Vec<f64>,
    levels: Vec<f64>,
    log_evidence: f64,
    factor: Cholesky<f64, Dyn>,
}

impl Fitter<'_> {
    fn read(&self, z: &[f64], levels: &[f64]) -> Option<Vec<f64>> {
        respond(self.search, self.search.problem.inputs, z, self.through, along(self.hats, levels)).ok()
    }

    fn whitened(&self, mut column: Vec<f64>) -> Vec<f64> {
        self.search.whitener.apply(&mut column);
        column
    }

    fn linearised(&self, z: &[f64], levels: &[f64]) -> Option<Linear> {
        let here = self.read(z, levels)?;
        let difference = |there: &[f64], step: f64| self.whitened(there.iter().zip(&here).map(|(a, b)| (a - b) / step).collect());
        let (p, k) = (z.len(), levels.len());
        let mut design = DMatrix::zeros(here.len(), p + k);
        for index in 0..p {
            let mut moved = z.to_vec();
            moved[index] += 1e-3;
            design.column_mut(index).copy_from_slice(&difference(&self.read(&moved, levels)?, 1e-3));
        }
        // the reading is straight in the course: one row's weight is its change per unit of level there
        let raised: Vec<f64> = levels.iter().map(|l| l + 1.0).collect();
        let there = self.read(z, &raised)?;
        let weight: Vec<f64> = there.iter().zip(&here).map(|(a, b)| a - b).collect();
        let mut columns = vec![vec![0.0; here.len()]; k];
        for (row, hat) in self.hats.iter().enumerate() {
            hat.iter().for_each(|(knot, w)| columns[*knot][row] += w * weight[row]);
        }
        for (index, column) in columns.into_iter().enumerate() {
            design.column_mut(p + index).copy_from_slice(&self.whitened(column));
        }
        let residual = self.search.problem.response.iter().zip(&here).map(|(y, r)| y - r).collect();
        let residual = DVector::from_vec(self.whitened(residual));
        let at = DVector::from_iterator(p + k, z.iter().chain(levels).copied());
        Some(Linear { gram: design.tr_mul(&design), gradient: design.tr_mul(&residual), at, base: p, residual })
    }

    /// The optimum at one scale, the model made straight again a few times.
    fn relinearised(&self, start: Solved, scale: f64) -> Option<(Through, Solved)> {
        let mut best = start;
        for _ in 0..COURSE_STEPS {
            let Some(here) = self.linearised(&best.z, &best.levels) else { break };
            let Some(next) = here.solve(self.knots, scale) else { break };
            best = next;
        }
        // at the last point the model is taken as it is, not as it was straightened
        let here = self.linearised(&best.z, &best.levels)?;
        best.log_evidence = here.log_evidence_here(self.knots, scale)?;
        Some((self.through, best))
    }
}

impl Linear {
    /// Prior precision of parameters and levels, and the logarithm of its determinant.
    fn prior(&self, knots: &Knots, scale: f64) -> (DMatrix<f64>, f64) {
        let (walk, log_determinant) = knots.precision(scale);
        let n = self.at.len();
        let mut precision = DMatrix::identity(n, n);
        precision.view_mut((self.base, self.base), (n - self.base, n - self.base)).copy_from(&walk);
        (precision, log_determinant)
    }

    fn solve(&self, knots: &Knots, scale: f64) -> Option<Solved> {
        let (prior, log_prior) = self.prior(knots, scale);
        let factor = Cholesky::new(&self.gram + &prior)?;
        let step = factor.solve(&(&self.gradient - &prior * &self.at));
        let there = &self.at + &step;
        let chi2 = self.residual.norm_squared() - 2.0 * step.dot(&self.gradient) + step.dot(&(&self.gram * &step));
        let objective = chi2 + there.dot(&(&prior * &there));
        Some(Solved {
            z: there.rows(0, self.base).iter().copied().collect(),
            levels: there.rows(self.base, there.len() - self.base).iter().copied().collect(),
            log_evidence: -0.5 * (objective + log_determinant(&factor) - log_prior),
            factor,
        })
    }

    fn log_evidence_here(&self, knots: &Knots, scale: f64) -> Option<f64> {
        let (prior, log_prior) = self.prior(knots, scale);
        let factor = Cholesky::new(&self.gram + &prior)?;
        let objective = self.residual.norm_squared() + self.at.dot(&(&prior * &self.at));
        Some(-0.5 * (objective + log_determinant(&factor) - log_prior))
    }
}
