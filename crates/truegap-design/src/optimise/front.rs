//! Fronts by Latin hypercube starts and local searches that learn from their neighbours.
//!
//! Limits: a fixed number of evaluations, no claim of optimality; the same seed gives the same front for any number of threads.

use super::{directions::directions, latin::latin_hypercube, pareto::nondominated};
use crate::sample::mix;
use rand::{RngExt, SeedableRng};
use rand_chacha::ChaCha8Rng;
use rayon::prelude::*;
use serde::{Deserialize, Serialize};

/// What a design is worth.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Evaluation<const M: usize> {
    /// all minimised; anything where the design breaks a constraint
    pub objectives: [f64; M],
    /// 0 for a feasible design, larger the further it is from that
    pub violation: f64,
}

/// How long to search.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Serialize, Deserialize)]
pub struct SearchOptions {
    /// points of the Latin hypercube
    pub starts: usize,
    /// local searches, each towards its own part of the front
    pub directions: usize,
    /// moves of each local search
    pub sweeps: usize,
    /// seed
    pub seed: u64,
}

impl Default for SearchOptions {
    fn default() -> Self {
        Self { starts: 2000, directions: 100, sweeps: 180, seed: 1 }
    }
}

/// A design that no other of the search beats: point of the unit cube and objectives.
#[derive(Clone, Debug, PartialEq)]
pub struct FrontPoint<const M: usize> {
    /// point of the unit cube
    pub unit: Vec<f64>,
    /// objectives
    pub objectives: [f64; M],
}

/// Result of a search; empty where nothing was feasible.
#[derive(Clone, Debug, PartialEq)]
pub struct Front<const M: usize> {
    /// sorted by the first objective
    pub points: Vec<FrontPoint<M>>,
    /// evaluations spent
    pub evaluations: usize,
}

/// Neighbours that a local search learns from and hands its finds to.
const NEIGHBOURS: usize = 15;
/// Neighbours that one find may replace, so that the front stays wide.
const HANDED_ON: usize = 2;

struct Search<const M: usize> {
    weights: Vec<[f64; M]>,
    neighbours: Vec<Vec<usize>>,
    incumbents: Vec<(Vec<f64>, Evaluation<M>)>,
    /// every feasible design that was met
    met: Vec<([f64; M], Vec<f64>)>,
    /// best value of each objective so far
    ideal: [f64; M],
}

/// Searches the unit cube for the front of `function`.
///
/// Latin hypercube starts; then each direction moves its incumbent by half the difference of two neighbours' incumbents and small polynomial mutations, and keeps what
/// lowers its weighted Chebyshev distance to the best value of each objective. Feasible beats infeasible.
///
/// **Source:** the decomposition of Zhang and Li (2007) with the differential moves of Li and Zhang (2009), on Latin hypercube starts.
pub fn front<const M: usize>(
    function: impl Fn(&[f64]) -> Evaluation<M> + Sync,
    dimensions: usize,
    options: SearchOptions,
) -> Front<M> {
    let weights = directions::<M>(options.directions);
    let starts = latin_hypercube(options.starts.max(weights.len()), dimensions, options.seed);
    let mut evaluations = starts.len();
    let found: Vec<_> = starts
        .into_par_iter()
        .map(|u| {
            let e = function(&u);
            (u, e)
        })
        .collect();
    let mut search = Search::new(weights, found);
    for sweep in 0..options.sweeps {
        let trials: Vec<_> = (0..search.weights.len())
            .into_par_iter()
            .map(|i| {
                let mut rng = ChaCha8Rng::seed_from_u64(mix(mix(options.seed ^ ((sweep as u64) << 32)) ^ i as u64));
                let unit = search.moved(i, &mut rng);
                let evaluation = function(&unit);
                (unit, evaluation)
            })
            .collect();
        evaluations += trials.len();
        let scale = search.scale();
        for (i, (unit, evaluation)) in trials.into_iter().enumerate() {
            search.hand_on(i, unit, evaluation, scale);
        }
    }
    Front { points: search.front(), evaluations }
}

impl<const M: usize> Search<M> {
    fn new(weights: Vec<[f64; M]>, found: Vec<(Vec<f64>, Evaluation<M>)>) -> Self {
        let far = |a: &[f64; M], b: &[f64; M]| a.iter().zip(b).map(|(a, b)| (a - b).powi(2)).sum::<f64>();
        let near = |w: &[f64; M]| {
            let mut order: Vec<usize> = (0..weights.len()).collect();
            order.sort_by(|&a, &b| far(w, &weights[a]).total_cmp(&far(w, &weights[b])));
            order.truncate(NEIGHBOURS);
            order
        };
        let neighbours = weights.iter().map(near).collect();
        let mut search = Self { weights, neighbours, incumbents: Vec::new(), met: Vec::new(), ideal: [f64::INFINITY; M] };
        found.iter().for_each(|(unit, e)| search.meet(unit, e));
        let (ideal, scale) = (search.finite_ideal(), search.scale());
        let best = |w: &[f64; M]| found.iter().min_by(|a, b| rank(&a.1, w, ideal, scale).total_cmp(&rank(&b.1, w, ideal, scale)));
        search.incumbents = search.weights.iter().filter_map(|w| best(w).cloned()).collect();
        search
    }

    /// Keeps a feasible design for the front.
    fn meet(&mut self, unit: &[f64], e: &Evaluation<M>) {
        if e.violation == 0.0 {
            self.ideal = std::array::from_fn(|m| self.ideal[m].min(e.objectives[m]));
            self.met.push((e.objectives, unit.to_vec()));
        }
    }

    /// What was met and nothing else beats.
    fn front(self) -> Vec<FrontPoint<M>> {
        let objectives: Vec<[f64; M]> = self.met.iter().map(|(objectives, _)| *objectives).collect();
        let point = |i: usize| FrontPoint { unit: self.met[i].1.clone(), objectives: objectives[i] };
        nondominated(&objectives).into_iter().map(point).collect()
    }

    fn finite_ideal(&self) -> [f64; M] {
        self.ideal.map(|i| if i.is_finite() { i } else { 0.0 })
    }

    /// Width of the front: of the incumbents, before there are any of all designs met.
    fn scale(&self) -> [f64; M] {
        let feasible = self.incumbents.iter().filter(|(_, e)| e.violation == 0.0).map(|(_, e)| e.objectives);
        let mut points: Vec<[f64; M]> = feasible.collect();
        if self.incumbents.is_empty() {
            points = self.met.iter().map(|(objectives, _)| *objectives).collect();
        }
        let front = nondominated(&points);
        let nadir = |m: usize| front.iter().map(|&i| points[i][m]).fold(f64::NEG_INFINITY, f64::max);
        std::array::from_fn(|m| if nadir(m) > self.ideal[m] { nadir(m) - self.ideal[m] } else { 1.0 })
    }

    /// A trial of one direction.
    fn moved(&self, i: usize, rng: &mut ChaCha8Rng) -> Vec<f64> {
        let wide = rng.random::<f64>() < 0.1;
        let mut pick = || {
            let near = &self.neighbours[i];
            if wide { rng.random_range(0..self.incumbents.len()) } else { near[rng.random_range(0..near.len())] }
        };
        let (a, b) = (pick(), pick());
        let (a, b, here) = (&self.incumbents[a].0, &self.incumbents[b].0, &self.incumbents[i].0);
        let share = 1.0 / here.len() as f64;
        let mut unit = Vec::with_capacity(here.len());
        for d in 0..here.len() {
            let mut u = here[d] + 0.5 * (a[d] - b[d]);
            if rng.random::<f64>() < share {
                u += polynomial(rng.random::<f64>());
            }
            unit.push(u.clamp(0.0, 1.0)); // the edge of the space is part of it, and often the answer
        }
        unit
    }

    /// Gives a trial to the neighbours that it serves better than what they have.
    fn hand_on(&mut self, i: usize, unit: Vec<f64>, evaluation: Evaluation<M>, scale: [f64; M]) {
        self.meet(&unit, &evaluation);
        let (mut given, ideal) = (0, self.finite_ideal());
        for &k in &self.neighbours[i] {
            let rank = |e: &Evaluation<M>| rank(e, &self.weights[k], ideal, scale);
            if given < HANDED_ON && rank(&evaluation) < rank(&self.incumbents[k].1) {
                self.incumbents[k] = (unit.clone(), evaluation);
                given += 1;
            }
        }
    }
}

/// Smaller is better: infeasible designs by their violation, above all feasible ones.
fn rank<const M: usize>(e: &Evaluation<M>, weights: &[f64; M], ideal: [f64; M], scale: [f64; M]) -> f64 {
    if e.violation > 0.0 {
        return 1e12 * (1.0 + e.violation);
    }
    let distance = |m: usize| (e.objectives[m] - ideal[m]) / (scale[m] * weights[m]);
    (0..M).map(distance).fold(f64::NEG_INFINITY, f64::max)
}

/// A step of the polynomial mutation with index 20 (Deb and Agrawal 1995) from a number between 0 and 1.
fn polynomial(u: f64) -> f64 {
    if u < 0.5 { (2.0 * u).powf(1.0 / 21.0) - 1.0 } else { 1.0 - (2.0 * (1.0 - u)).powf(1.0 / 21.0) }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_design_that_breaks_a_limit_ranks_behind_all_that_do_not() {
        let at = |objectives: [f64; 2], violation: f64| {
            rank(&Evaluation { objectives, violation }, &[0.5, 0.5], [0.0, 0.0], [1.0, 4.0])
        };
        // the larger of 3 / 0.5 and 4 / (4 x 0.5)
        assert_eq!(at([3.0, 4.0], 0.0), 6.0);
        assert!(at([0.0, 0.0], 1e-3) > at([1e6, 1e6], 0.0));
        assert!(at([9.0, 9.0], 0.1) < at([0.0, 0.0], 0.2));
    }
}
