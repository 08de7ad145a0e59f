//! Several searches for one front, and their union.
//!
//! Limits: a search hands on at most [`KEPT`] designs, spread evenly over its front.

use super::{design::Design, front::SearchOptions, pareto::nondominated, problem::DesignProblem};
use crate::error::DesignError;
use serde::{Deserialize, Serialize};
use std::collections::HashSet;

/// Designs that one search hands on.
pub(super) const KEPT: usize = 1000;

/// Result of one search.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
pub struct Searched {
    /// designs that no other of the search beats
    pub designs: Vec<Design>,
    /// evaluations spent
    pub evaluations: usize,
}

/// Searches for the front of two or all three coefficients, given by their places in [`OBJECTIVES`](super::OBJECTIVES).
///
/// # Errors
/// As [`DesignProblem::front`].
pub fn search(problem: &DesignProblem, objectives: &[usize], options: SearchOptions) -> Result<Searched, DesignError> {
    let (units, evaluations) = match *objectives {
        [a, b] => units(problem, [a, b], options)?,
        _ => units(problem, [0, 1, 2], options)?,
    };
    let designs = units.into_iter().map(|unit| Design { ratios: problem.candidate(&unit).ratios, unit }).collect();
    Ok(Searched { designs: thin(designs, objectives, KEPT), evaluations })
}

fn units<const M: usize>(
    problem: &DesignProblem,
    objectives: [usize; M],
    options: SearchOptions,
) -> Result<(Vec<Vec<f64>>, usize), DesignError> {
    let front = problem.front(objectives, options)?;
    Ok((front.points.into_iter().map(|p| p.unit).collect(), front.evaluations))
}

/// Designs of several searches that none of the others beats, sorted by the first objective.
pub fn unite(searches: &[Searched], objectives: &[usize]) -> Vec<Design> {
    let all: Vec<&Design> = searches.iter().flat_map(|s| &s.designs).collect();
    let points: Vec<[f64; 3]> = all.iter().map(|d| wanted(d, objectives)).collect();
    let mut designs: Vec<Design> = nondominated(&points).into_iter().map(|i| all[i].clone()).collect();
    sort(&mut designs, objectives);
    designs
}

/// The objectives that count, the others 0.
fn wanted(design: &Design, objectives: &[usize]) -> [f64; 3] {
    std::array::from_fn(|m| if objectives.contains(&m) { design.ratios[m] } else { 0.0 })
}

fn sort(designs: &mut [Design], objectives: &[usize]) {
    let key = |design: &Design, m: usize| design.ratios[m];
    designs.sort_by(|a, b| {
        objectives
            .iter()
            .map(|&m| key(a, m).total_cmp(&key(b, m)))
            .find(|order| order.is_ne())
            .unwrap_or(std::cmp::Ordering::Equal)
    });
}

/// At most about `most` designs: one a cell of an even grid over the front, and the best in each objective.
pub fn thin(mut designs: Vec<Design>, objectives: &[usize], most: usize) -> Vec<Design> {
    sort(&mut designs, objectives);
    if designs.len() <= most {
        return designs;
    }
    let range =
        |m: usize| designs.iter().map(|d| d.ratios[m]).fold((f64::INFINITY, 0.0), |(l, h): (f64, f64), v| (l.min(v), h.max(v)));
    let ranges: Vec<(usize, (f64, f64))> = objectives.iter().map(|&m| (m, range(m))).collect();
    let cell = |design: &Design, count: usize| -> Vec<usize> {
        let place = |&(m, (low, high)): &(usize, (f64, f64))| {
            ((design.ratios[m] - low) / (high - low).max(1e-300) * count as f64) as usize
        };
        ranges.iter().map(place).collect()
    };
    let cells = |count: usize| designs.iter().map(|d| cell(d, count)).collect::<HashSet<_>>().len();
    let (mut low, mut high) = (1, 2 * most);
    while low + 1 < high {
        let middle = low.midpoint(high);
        if cells(middle) <= most { low = middle } else { high = middle }
    }
    let best: Vec<Option<f64>> = ranges.iter().map(|&(_, (low, _))| Some(low)).collect();
    let mut seen = HashSet::new();
    let mut kept = |design: &Design| {
        let extreme = ranges.iter().zip(&best).any(|(&(m, _), best)| *best == Some(design.ratios[m]));
        seen.insert(cell(design, low)) || extreme
    };
    designs.iter().filter(|d| kept(d)).cloned().collect()
}

#[cfg(test)]
mod tests {
    use super::*;

    fn arc(count: usize, shift: f64) -> Vec<Design> {
        let at = |i: usize| (i as f64 + shift) / count as f64 * std::f64::consts::FRAC_PI_2;
        (0..count).map(|i| Design { unit: vec![i as f64], ratios: [1.0 - at(i).sin(), 1.0 - at(i).cos(), 7.0] }).collect()
    }

    #[test]
    fn a_thinned_front_keeps_its_ends_and_its_shape() {
        let thinned = thin(arc(5000, 0.5), &[0, 1], 100);
        assert!((60..=102).contains(&thinned.len()), "{}", thinned.len());
        let gap = |p: &[Design]| (p[0].ratios[0] - p[1].ratios[0]).hypot(p[0].ratios[1] - p[1].ratios[1]);
        assert!(thinned.windows(2).all(|p| gap(p) < 0.06), "no hole in an arc of length 1.57");
        let whole = arc(5000, 0.5);
        assert!(thinned.contains(&whole[0]) && thinned.contains(&whole[4999]));
    }

    #[test]
    fn the_union_holds_what_no_search_beats() {
        let mut worse = arc(50, 0.5);
        worse.iter_mut().for_each(|d| d.ratios[0] += 0.2);
        let parts = [arc(50, 0.0), worse, arc(50, 0.5)].map(|designs| Searched { designs, evaluations: 50 });
        let united = unite(&parts, &[0, 1]);
        assert_eq!(united.len(), 100);
        assert!(united.windows(2).all(|p| p[0].ratios[0] < p[1].ratios[0] && p[0].ratios[1] > p[1].ratios[1]));
    }
}
