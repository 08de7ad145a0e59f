//! Designs with smaller temperature coefficients: three fronts of two, the front of all three, and the minimisation vector.
//!
//! Limits: several searches a front, each with its own seed, united; at most about 400 designs a front are told.

use super::answer::optimise::{FRONTS, FrontAnswer, OptimiseAnswer};
use super::work::{check_memory, merged, write};
use super::{Finished, SensorText, StudyError, Work, page};
use serde::{Deserialize, Serialize};
use std::path::Path;
use truegap_design::optimise::{
    Axis, DesignProblem, OBJECTIVES, SearchOptions, Searched, Space, Useful, hypervolume_2d, hypervolume_3d, search, thin, unite,
};
use truegap_design::{DesignError, MetricOptions};
use truegap_sweep::Sweep;

/// Name of the study in a sweep's folder.
pub const STUDY: &str = concat!("truegap.optimise/1 of ", env!("CARGO_PKG_VERSION"));

/// Designs of a front that are told.
const TOLD: usize = 400;

/// Memory of a search, bytes: the designs of its front (measured: 9.4 MB for 40 searches).
const MEMORY_OF_A_SEARCH: f64 = 2.5e5;

/// What is asked.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
pub struct OptimiseRequest {
    /// starting design
    pub sensor: SensorText,
    /// what may be chosen
    pub axes: Vec<Axis>,
    /// how useful the sensor must stay
    pub useful: Useful,
    /// each search; the k-th of a front has seed + k
    pub search: SearchOptions,
    /// searches for each front
    pub searches: u64,
}

/// A case: one search.
#[derive(Clone, Copy, Debug, Serialize)]
struct Case {
    front: usize,
    seed: u64,
}

struct Checked {
    problem: DesignProblem,
    sweep: Sweep<Case>,
}

impl OptimiseRequest {
    /// Computes the work's share; writes the results where it is the whole and has a folder.
    ///
    /// # Errors
    /// [`StudyError`]; a space without a design says which constraint excludes how much.
    pub fn run(&self, work: Work<'_>) -> Result<Finished<OptimiseAnswer>, StudyError> {
        let checked = self.checked()?;
        let (ran, answers) = work.answers(&checked.sweep, |case| self.solve(&checked, case))?;
        let answer = answers.map(|answers| self.answer(&checked, answers));
        if let (Some(answer), Some(folder)) = (&answer, work.folder) {
            answer.write(folder)?;
        }
        Ok(Finished { ran, answer })
    }

    pub(super) fn merge(&self, folder: &Path, partial: bool) -> Result<OptimiseAnswer, StudyError> {
        let checked = self.checked()?;
        let answers = merged(&checked.sweep, folder, partial)?;
        Ok(self.answer(&checked, answers))
    }

    fn checked(&self) -> Result<Checked, StudyError> {
        let searches = self.searches as f64 * FRONTS.len() as f64;
        check_memory("--searches", searches, "searches of all fronts", MEMORY_OF_A_SEARCH)?;
        let space = Space::new(self.sensor.sensor()?, self.axes.clone())?;
        let problem = DesignProblem::new(space, self.useful, MetricOptions::default())?;
        let seeds = |front: usize| (0..self.searches).map(move |k| Case { front, seed: self.search.seed.wrapping_add(k) });
        let sweep = Sweep::new(STUDY, self, (0..FRONTS.len()).flat_map(seeds).collect())?;
        Ok(Checked { problem, sweep })
    }

    fn solve(&self, checked: &Checked, case: &Case) -> Result<Searched, DesignError> {
        search(&checked.problem, FRONTS[case.front], SearchOptions { seed: case.seed, ..self.search })
    }

    fn answer(&self, checked: &Checked, answers: Vec<Option<Searched>>) -> OptimiseAnswer {
        let problem = &checked.problem;
        let complete = answers.iter().all(Option::is_some);
        let there: Vec<(usize, Searched)> =
            checked.sweep.cases().iter().zip(answers).filter_map(|(c, a)| Some((c.front, a?))).collect();
        let searches =
            |front: usize| -> Vec<Searched> { there.iter().filter(|(f, _)| *f == front).map(|(_, s)| s.clone()).collect() };
        let three = unite(&searches(FRONTS.len() - 1), &[0, 1, 2]);
        let vector = problem.along_vector(&three).map(|(unit, _)| problem.candidate(&unit));
        let (exclusions, feasible) = problem.exclusions(self.search.starts, self.search.seed);
        OptimiseAnswer {
            schema: "truegap.optimise/1",
            sensor: self.sensor.name.clone(),
            base: *problem.base(),
            search: self.search,
            complete,
            axes: self.axes.clone(),
            useful: self.useful,
            feasible,
            exclusions,
            vector,
            fronts: (0..FRONTS.len()).map(|f| front(problem, FRONTS[f], &searches(f))).filter(|f| f.searches > 0).collect(),
        }
    }
}

fn front(problem: &DesignProblem, places: &'static [usize], searches: &[Searched]) -> FrontAnswer {
    let united = unite(searches, places);
    let hypervolume = match *places {
        [a, b] => hypervolume_2d(&united.iter().map(|d| [d.ratios[a], d.ratios[b]]).collect::<Vec<_>>(), [1.0; 2]),
        _ => hypervolume_3d(&united.iter().map(|d| d.ratios).collect::<Vec<_>>(), [1.0; 3]),
    };
    FrontAnswer {
        objectives: places.iter().map(|&o| OBJECTIVES[o].name()).collect(),
        places,
        searches: searches.len(),
        evaluations: searches.iter().map(|s| s.evaluations).sum(),
        hypervolume,
        designs: thin(united, places, TOLD).iter().map(|d| problem.candidate(&d.unit)).collect(),
    }
}

impl OptimiseAnswer {
    /// Writes `optimise.json`, `fronts.csv`, figures and `report.html`.
    ///
    /// # Errors
    /// [`StudyError::Sweep`] where the disk refuses.
    pub fn write(&self, folder: &Path) -> Result<(), StudyError> {
        let mut files =
            vec![("optimise.json".to_owned(), serde_json::to_string_pretty(self)? + "\n"), ("fronts.csv".to_owned(), self.csv())];
        files.extend(page::optimise::figures(self)?);
        files.push(("report.html".to_owned(), page::optimise::html(self)?));
        write(folder, &files)
    }
}
