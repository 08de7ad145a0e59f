//! A table of corrections, as fine as the noise asks for, and straight between its nodes.
//!
//! Limits: even steps along each axis; the error is measured at the middles of cells and of their edges, and is that of readings which the model gives.

use super::FirmwareError;
use super::points::{Corrections, Points};
use truegap_core::ends;

/// Places along an axis where it is looked at whether the correction follows it at all.
const PLACES: usize = 9;
/// Part of the wanted error by which a correction that follows an axis moves along it.
const FLAT: f64 = 0.05;
/// Part of the wanted error that each axis may have, so that the sum of three is below it.
const OF_AN_AXIS: f64 = 0.4;
/// Most by which the steps of an axis become finer at a time.
const FINER: f64 = 4.0;
/// Places at which an error is looked at on the way to a table; all of them in the end.
const THIN: usize = 1500;
/// Bytes of a number.
pub(super) const FLOAT: usize = 4;

/// A table of corrections over the reading and the axes.
#[derive(Clone, Debug)]
pub(super) struct Grid {
    /// least and greatest number along each axis, that of the reading first
    pub ends: Vec<[f64; 2]>,
    /// nodes along each; 1 where the correction does not follow it
    pub nodes: Vec<usize>,
    /// corrections, the last axis running fastest
    pub values: Vec<f64>,
    /// largest error at a reading that the model gives, between nodes
    pub error: f64,
    /// most that the passes leave at a node whose reading the model gives
    pub left: f64,
}

impl Grid {
    /// One cell, between the ends of all axes that the correction follows: by more than a part of the error that is wanted.
    pub fn coarsest(points: &Points<'_>, ends: Vec<[f64; 2]>, wanted: f64) -> Result<Self, FirmwareError> {
        let flat = flat(points, &ends, FLAT * wanted)?;
        let nodes = flat.iter().map(|flat| if *flat { 1 } else { 2 }).collect();
        Ok(Self { ends, nodes, values: Vec::new(), error: f64::INFINITY, left: 0.0 })
    }

    /// The coarsest of a few whose error is below `wanted`, or the finest that `most` numbers hold.
    pub fn refined(self, points: &Points<'_>, wanted: f64, most: usize) -> Result<Self, FirmwareError> {
        let mut grid = self;
        loop {
            let found = points.corrections(&grid.places(|_| 0.0, |n| n))?;
            grid.left =
                found.left.iter().zip(&found.given).filter(|(_, given)| **given).map(|(left, _)| *left).fold(0.0, f64::max);
            grid.values = found.added;
            let (along, error) = grid.errors(points, THIN)?;
            let finer = grid.finer(&along, OF_AN_AXIS * wanted, most);
            if error <= wanted || finer.is_none() {
                let (along, error) = grid.errors(points, usize::MAX)?;
                grid.error = error;
                let finer = grid.finer(&along, OF_AN_AXIS * wanted, most);
                match finer {
                    Some(nodes) if error > wanted => grid.nodes = nodes,
                    _ => return Ok(grid),
                }
            } else if let Some(nodes) = finer {
                grid.nodes = nodes;
            }
        }
    }

    /// Largest errors in the middle of edges along each axis, and of these and the middles of cells, at `most` places each.
    fn errors(&self, points: &Points<'_>, most: usize) -> Result<(Vec<f64>, f64), FirmwareError> {
        let axes = 0..self.nodes.len();
        let along = axes.map(|axis| self.error(points, |k| k == axis, most)).collect::<Result<Vec<_>, _>>()?;
        let among = self.error(points, |_| true, most)?;
        let worst = along.iter().copied().fold(among, f64::max);
        Ok((along, worst))
    }

    /// More nodes along the axis of the largest error, `along` each, as far as there is room for `most`; `None` where there is none.
    fn finer(&self, along: &[f64], wanted: f64, most: usize) -> Option<Vec<usize>> {
        let axes = (0..self.nodes.len()).filter(|axis| self.nodes[*axis] > 1);
        let axis = axes.max_by(|a, b| along[*a].total_cmp(&along[*b]))?;
        let mut nodes = self.nodes.clone();
        // the error of straight lines goes with the square of the step
        let finer = (along[axis] / wanted).sqrt().clamp(1.2, FINER);
        let others = nodes.iter().product::<usize>() / nodes[axis];
        nodes[axis] = (1 + ((nodes[axis] - 1) as f64 * finer).ceil() as usize).min(most / others);
        (nodes[axis] > self.nodes[axis]).then_some(nodes)
    }

    fn place(&self, axis: usize, at: f64) -> f64 {
        let [low, high] = self.ends[axis];
        match self.nodes[axis] {
            1 => 0.5 * (low + high),
            nodes => low + (high - low) * at / (nodes - 1) as f64,
        }
    }

    /// Points of all combinations: `count(nodes)` places along each axis, from `shift(axis)` steps behind its first node on.
    fn places(&self, shift: impl Fn(usize) -> f64, count: impl Fn(usize) -> usize + Copy) -> Vec<Vec<f64>> {
        let mut places = vec![Vec::new()];
        for (axis, nodes) in self.nodes.iter().enumerate() {
            let shifted = if *nodes > 1 { shift(axis) } else { 0.0 };
            let count = if shifted > 0.0 { nodes - 1 } else { count(*nodes) };
            let along: Vec<f64> = (0..count).map(|node| self.place(axis, node as f64 + shifted)).collect();
            places = places.iter().flat_map(|place| along.iter().map(move |at| [&place[..], &[*at]].concat())).collect();
        }
        places
    }

    /// Largest error in the middle between nodes along the axes that `shifts` names, at nodes along the others; at about `most` places.
    fn error(&self, points: &Points<'_>, shifts: impl Fn(usize) -> bool, most: usize) -> Result<f64, FirmwareError> {
        if !(0..self.nodes.len()).any(|axis| shifts(axis) && self.nodes[axis] > 1) {
            return Ok(0.0);
        }
        let mut places = self.places(|axis| if shifts(axis) { 0.5 } else { 0.0 }, |nodes| nodes);
        if places.len() > most {
            // an odd stride meets all places of an axis in turn
            places = places.into_iter().step_by(places_apart(most, self.nodes.iter().product())).collect();
        }
        let Corrections { added, given, .. } = points.corrections(&places)?;
        let of = |p: usize| if given[p] { (self.at(&places[p]) - added[p]).abs() } else { 0.0 };
        Ok((0..places.len()).map(of).fold(0.0, f64::max))
    }

    /// The table at a point, straight between nodes and held at the edges.
    pub fn at(&self, point: &[f64]) -> f64 {
        let mut corners = vec![(0, 1.0)];
        for (axis, nodes) in self.nodes.iter().enumerate() {
            let [low, high] = self.ends[axis];
            let at = if *nodes > 1 { (point[axis] - low) / (high - low) * (nodes - 1) as f64 } else { 0.0 };
            let at = at.clamp(0.0, (nodes - 1) as f64);
            let cell = (at as usize).min(nodes.saturating_sub(2));
            let share = at - cell as f64;
            let sides: &[(usize, f64)] = if *nodes > 1 { &[(cell, 1.0 - share), (cell + 1, share)] } else { &[(0, 1.0)] };
            corners = corners
                .iter()
                .flat_map(|(index, weight)| sides.iter().map(move |(node, part)| (index * nodes + node, weight * part)))
                .collect();
        }
        corners.iter().map(|(index, weight)| self.values[*index] * weight).sum()
    }

    /// Greatest change of the corrected reading by one of the reading: by so much the noise grows.
    pub fn steepest(&self) -> f64 {
        let nodes = self.nodes[0];
        if nodes == 1 {
            return 1.0;
        }
        let (rest, step) = (self.values.len() / nodes, (self.ends[0][1] - self.ends[0][0]) / (nodes - 1) as f64);
        let slopes = (0..self.values.len() - rest).map(|k| (1.0 + (self.values[k + rest] - self.values[k]) / step).abs());
        slopes.fold(0.0, f64::max)
    }

    /// Bytes of the table.
    pub fn bytes(&self) -> usize {
        FLOAT * self.values.len()
    }
}

/// How far apart places are looked at where there are so many and `most` are wanted.
fn places_apart(most: usize, places: usize) -> usize {
    (places / most) | 1
}

/// The axes along which the correction does not move by more than `near`, that of the reading first.
fn flat(points: &Points<'_>, ends_of: &[[f64; 2]], near: f64) -> Result<Vec<bool>, FirmwareError> {
    let at = |axis: usize, share: f64| ends_of[axis][0] + share * (ends_of[axis][1] - ends_of[axis][0]);
    let mut flat = Vec::new();
    for axis in 0..ends_of.len() {
        let mut lines = vec![Vec::new()];
        for other in 0..ends_of.len() {
            let shares: &[f64] = if other == axis { &[0.0] } else { &[0.1, 0.5, 0.9] };
            lines = lines.iter().flat_map(|line| shares.iter().map(move |s| [&line[..], &[at(other, *s)]].concat())).collect();
        }
        let along = |line: &Vec<f64>, k: usize| {
            let mut point = line.clone();
            point[axis] = at(axis, k as f64 / (PLACES - 1) as f64);
            point
        };
        let places: Vec<Vec<f64>> = lines.iter().flat_map(|line| (0..PLACES).map(move |k| along(line, k))).collect();
        let Corrections { added, given, .. } = points.corrections(&places)?;
        let moves = |line: usize| {
            let here = (line * PLACES..(line + 1) * PLACES).filter(|p| given[*p]).map(|p| added[p]);
            let (low, high) = ends(here);
            high - low > near
        };
        flat.push(ends_of[axis][0] >= ends_of[axis][1] || !(0..lines.len()).any(moves));
    }
    Ok(flat)
}
