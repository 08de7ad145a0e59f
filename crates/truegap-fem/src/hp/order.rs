//! In which order unknowns are eliminated, and what each elimination couples.
//!
//! Unknowns that the same elements share (those of an edge, the components at a corner) leave together, so that the search goes through
//! groups: a few hundred where there are thousands of unknowns. The group with the fewest neighbours comes first. Eliminating it joins
//! the elements it belongs to into one, and takes every other group along that only these have.
//!
//! **Source:** minimum degree on a quotient graph: George & Liu, SIAM Review 31 (1989) 1.

use crate::mesh::NONE;
use crate::space::ElementDofs;
use std::cmp::Reverse;
use std::collections::BinaryHeap;
use std::ops::Range;

/// Unknowns that leave together, and what they are coupled to by then; unknowns are numbered in the order in which they leave.
#[derive(Debug, Clone, PartialEq, Eq)]
pub(super) struct Step {
    pub pivots: Range<u32>,
    /// Those that leave later, ascending.
    pub boundary: Vec<u32>,
    /// What is joined: elements, then steps before this one, counted after the last element.
    pub joined: Vec<u32>,
}

/// The numbers of the unknowns in the order in which they leave, `NONE` for those that take no part, and the steps.
#[derive(Debug, Clone, PartialEq, Eq)]
pub(super) struct Order {
    pub numbers: Vec<u32>,
    /// How many have a number.
    pub count: usize,
    pub steps: Vec<Step>,
}

impl Order {
    /// An order of the unknowns of `dofs` that are marked in `take`.
    pub fn new(dofs: &ElementDofs, take: &[bool]) -> Order {
        let groups = Groups::new(dofs, take);
        let steps = joins(&groups.sizes, groups.of_elements(dofs));
        let mut first = vec![0; groups.sizes.len()];
        let mut next = 0;
        for &g in steps.iter().flat_map(|s| &s.leave) {
            first[g as usize] = next;
            next += groups.sizes[g as usize];
        }
        let mut numbers = vec![NONE; dofs.count];
        let mut within = first.clone();
        for (number, &g) in numbers.iter_mut().zip(&groups.of).filter(|(_, g)| **g != NONE) {
            *number = within[g as usize];
            within[g as usize] += 1;
        }
        let mut at = 0;
        let step = |join: Join| {
            let begin = at;
            at += join.leave.iter().map(|&g| groups.sizes[g as usize]).sum::<u32>();
            let mut stay: Vec<Range<u32>> =
                join.stay.iter().map(|&g| first[g as usize]..first[g as usize] + groups.sizes[g as usize]).collect();
            stay.sort_unstable_by_key(|r| r.start);
            let mut boundary = Vec::with_capacity(stay.iter().map(|r| r.len()).sum());
            stay.into_iter().for_each(|r| boundary.extend(r));
            Step { pivots: begin..at, boundary, joined: join.joined }
        };
        let steps = steps.into_iter().map(step).collect();
        Order { numbers, count: next as usize, steps }
    }
}

/// Unknowns with neighbouring numbers that the same elements have.
struct Groups {
    /// Group of every unknown, `NONE` for those that take no part.
    of: Vec<u32>,
    sizes: Vec<u32>,
}

impl Groups {
    fn new(dofs: &ElementDofs, take: &[bool]) -> Groups {
        let mut starts = vec![0usize; dofs.count + 1];
        (0..dofs.elements()).flat_map(|e| dofs.of(e)).for_each(|&d| starts[d as usize + 1] += 1);
        (0..dofs.count).for_each(|d| starts[d + 1] += starts[d]);
        let mut next = starts.clone();
        let mut elements = vec![0u32; starts[dofs.count]];
        for e in 0..dofs.elements() {
            for &d in dofs.of(e) {
                elements[next[d as usize]] = e as u32;
                next[d as usize] += 1;
            }
        }
        let having = |d: usize| &elements[starts[d]..starts[d + 1]];
        let mut groups = Groups { of: vec![NONE; dofs.count], sizes: Vec::new() };
        for d in (0..dofs.count).filter(|&d| take[d] && !having(d).is_empty()) {
            if d == 0 || groups.of[d - 1] == NONE || having(d - 1) != having(d) {
                groups.sizes.push(0);
            }
            groups.of[d] = groups.sizes.len() as u32 - 1;
            groups.sizes[groups.of[d] as usize] += 1;
        }
        groups
    }

    fn of_elements(&self, dofs: &ElementDofs) -> Vec<Vec<u32>> {
        let of = |e: usize| {
            let mut out: Vec<u32> = dofs.of(e).iter().map(|&d| self.of[d as usize]).filter(|&g| g != NONE).collect();
            out.dedup();
            out.sort_unstable();
            out.dedup();
            out
        };
        (0..dofs.elements()).map(of).collect()
    }
}

/// A step in groups.
struct Join {
    leave: Vec<u32>,
    stay: Vec<u32>,
    joined: Vec<u32>,
}

/// Lists of groups as sets: which were seen since the last list began.
struct Seen {
    by: Vec<u32>,
    now: u32,
}

impl Seen {
    fn first_time(&mut self, group: u32) -> bool {
        std::mem::replace(&mut self.by[group as usize], self.now) != self.now
    }
}

/// Joins elements, given by their groups, until every group has left.
fn joins(sizes: &[u32], mut parts: Vec<Vec<u32>>) -> Vec<Join> {
    let mut holders: Vec<Vec<u32>> = vec![Vec::new(); sizes.len()];
    for (p, groups) in parts.iter().enumerate() {
        groups.iter().for_each(|&g| holders[g as usize].push(p as u32));
    }
    let mut seen = Seen { by: vec![0; sizes.len()], now: 0 };
    let neighbours = |seen: &mut Seen, parts: &[Vec<u32>], of: &[u32]| -> u32 {
        seen.now += 1;
        of.iter().flat_map(|&p| &parts[p as usize]).filter(|&&g| seen.first_time(g)).map(|&g| sizes[g as usize]).sum()
    };
    let mut next: BinaryHeap<_> =
        holders.iter().enumerate().map(|(g, h)| Reverse((neighbours(&mut seen, &parts, h), g as u32))).collect();
    // neighbours are counted anew when it is the turn of a group: most counts are never asked for
    let mut changed = vec![false; sizes.len()];
    let mut out = Vec::new();
    while let Some(Reverse((degree, group))) = next.pop() {
        if holders[group as usize].is_empty() {
            continue;
        }
        if std::mem::take(&mut changed[group as usize]) {
            let now = neighbours(&mut seen, &parts, &holders[group as usize]);
            if now > degree {
                next.push(Reverse((now, group)));
                continue;
            }
        }
        let joined = std::mem::take(&mut holders[group as usize]);
        seen.now += 1;
        let mut all: Vec<u32> = joined.iter().flat_map(|&p| std::mem::take(&mut parts[p as usize])).collect();
        all.retain(|&g| seen.first_time(g));
        let part = parts.len() as u32;
        let (mut leave, mut stay) = (Vec::new(), Vec::new());
        for g in all {
            let holders = &mut holders[g as usize];
            holders.retain(|p| !joined.contains(p));
            if holders.is_empty() {
                leave.push(g);
            } else {
                holders.push(part);
                stay.push(g);
            }
        }
        parts.push(stay.clone());
        stay.iter().for_each(|&g| changed[g as usize] = true);
        out.push(Join { leave, stay, joined });
    }
    out
}

#[cfg(test)]
mod tests {
    use super::*;

    /// A row of elements, each with an unknown of its own kind at both ends and two in between: 0 1 2 3 4 ...
    fn row(elements: u32) -> ElementDofs {
        let mut dofs = ElementDofs::empty(3 * elements as usize + 1);
        (0..elements).for_each(|e| dofs.push(&[3 * e, 3 * e + 1, 3 * e + 2, 3 * e + 3]));
        dofs
    }

    #[test]
    fn every_unknown_leaves_once_and_only_after_what_it_is_coupled_to_was_joined() {
        let dofs = row(9);
        let mut take = vec![true; dofs.count];
        take[0] = false;
        let order = Order::new(&dofs, &take);
        let mut numbers: Vec<u32> = order.numbers.iter().copied().filter(|&n| n != NONE).collect();
        numbers.sort_unstable();
        assert_eq!(numbers, (0..27).collect::<Vec<_>>());
        assert_eq!((order.numbers[0], order.count), (NONE, 27));
        // what an element or a step hands on is what its joining step has
        let mut parts: Vec<Vec<u32>> = (0..dofs.elements())
            .map(|e| dofs.of(e).iter().map(|&d| order.numbers[d as usize]).filter(|&n| n != NONE).collect())
            .collect();
        let mut next = 0;
        for step in &order.steps {
            assert_eq!(step.pivots.start, next);
            next = step.pivots.end;
            let known: Vec<u32> = step.pivots.clone().chain(step.boundary.iter().copied()).collect();
            assert!(known.is_sorted());
            for &p in &step.joined {
                assert!(!parts[p as usize].is_empty() && parts[p as usize].iter().all(|n| known.contains(n)));
                parts[p as usize].clear();
            }
            parts.push(step.boundary.clone());
        }
        assert!(parts.iter().all(Vec::is_empty));
    }

    #[test]
    fn a_row_is_eliminated_without_fill() {
        let dofs = row(50);
        let order = Order::new(&dofs, &vec![true; dofs.count]);
        assert!(order.steps.iter().all(|s| s.boundary.len() <= 2), "{order:?}");
    }
}
