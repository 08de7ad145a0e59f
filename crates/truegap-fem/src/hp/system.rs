//! From element matrices and prescribed values to the energy products of the solutions.
//!
//! Unknowns that one element has for itself are eliminated from its matrix before it meets the others: at the degree 6 three in five.
//! Nothing loads them, so that the reduced matrices hold the whole energy and the eliminated values are never needed. Prescribed values
//! become right-hand sides in the same way, element by element.

use super::dense::{BadPivot, eliminate, multiply};
use super::fronts::{Factor, Part};
use super::order::Order;
use crate::algebra::{ALLOWED_PROBE_ERROR, ALLOWED_RESIDUAL, SolveError, for_each_element, largest};
use crate::mesh::NONE;
use crate::space::ElementDofs;
use nalgebra::DMatrix;
use std::time::Instant;

/// Cubes of unknowns an element, summed, below which one thread is as fast as several: some milliseconds.
const FEW_OPERATIONS: usize = 20_000_000;

/// Energy products `a(u_i, u_j)` of solutions, and what they cost.
#[derive(Debug, Clone, PartialEq)]
pub(crate) struct Gram {
    pub products: DMatrix<f64>,
    /// Free unknowns, the eliminated ones included.
    pub unknowns: usize,
    /// Bound of the largest normwise backward error of the solves.
    pub residual: f64,
    /// Wall-clock seconds of ordering, factorising and solving.
    pub seconds: f64,
}

/// Solves without loads for every vector of `prescribed` (values of the unknowns that are `fixed`, zero elsewhere).
///
/// `element` gives the matrix of an element, full, column by column; its lower triangle is read.
///
/// # Errors
/// Those of the solver: `NotPositiveDefinite` or `Singular` where a part of the body is not held.
pub(crate) fn gram(
    dofs: &ElementDofs,
    fixed: &[bool],
    prescribed: &[Vec<f64>],
    element: impl Fn(usize) -> Vec<f64> + Sync,
) -> Result<Gram, SolveError> {
    let begin = Instant::now();
    let own = own(dofs, fixed);
    let order = Order::new(dofs, &fixed.iter().zip(&own).map(|(f, o)| !(*f || *o)).collect::<Vec<_>>());
    let mut seconds = begin.elapsed().as_secs_f64();
    let unknowns = fixed.iter().filter(|f| !**f).count();
    let split = Split { numbers: &order.numbers, own, prescribed };
    let mut parts = Vec::with_capacity(dofs.elements());
    let mut failed = None;
    let part = |e: usize| split.reduced(dofs.of(e), &element(e));
    let mut take = |e, part| match part {
        Ok(part) => parts.push(part),
        Err(bad) => failed = failed.or(Some(BadPivot { column: e, ..bad })),
    };
    let operations: usize = (0..dofs.elements()).map(|e| dofs.of(e).len().pow(3)).sum();
    if operations < FEW_OPERATIONS {
        (0..dofs.elements()).for_each(|e| take(e, part(e)));
    } else {
        for_each_element(dofs.elements(), part, take);
    }
    if let Some(bad) = failed {
        return Err(unsolvable(bad, unknowns));
    }
    let begin = Instant::now();
    let mut system = System { order: &order, parts, fields: prescribed.len(), scale: Vec::new() };
    let (products, residual) = system.solve()?;
    seconds += begin.elapsed().as_secs_f64();
    Ok(Gram { products, unknowns, residual, seconds })
}

/// Free unknowns that one element alone has.
fn own(dofs: &ElementDofs, fixed: &[bool]) -> Vec<bool> {
    let mut elements = vec![0u8; dofs.count];
    (0..dofs.elements()).flat_map(|e| dofs.of(e)).for_each(|&d| elements[d as usize] = elements[d as usize].saturating_add(1));
    elements.iter().zip(fixed).map(|(n, fixed)| *n == 1 && !fixed).collect()
}

fn unsolvable(bad: BadPivot, size: usize) -> SolveError {
    if bad.value.is_finite() {
        SolveError::NotPositiveDefinite { pivot: bad.column, size }
    } else {
        SolveError::NotFinite { column: bad.column }
    }
}

/// What becomes of the unknowns of an element.
struct Split<'a> {
    /// Of those that are solved for with all others.
    numbers: &'a [u32],
    /// Those that leave at once.
    own: Vec<bool>,
    prescribed: &'a [Vec<f64>],
}

impl Split<'_> {
    /// An element without its own unknowns; its right-hand sides are the prescribed vectors, and one more that is left empty.
    fn reduced(&self, of: &[u32], matrix: &[f64]) -> Result<Part, BadPivot> {
        let (m, sides) = (of.len(), self.prescribed.len() + 1);
        let at = |i: usize, j: usize| matrix[i.min(j) * m + i.max(j)];
        let number = |i: usize| self.numbers[of[i] as usize];
        let is_own = |i: &usize| self.own[of[*i] as usize];
        let mut free: Vec<usize> = (0..m).filter(is_own).collect();
        let inner = free.len();
        free.extend((0..m).filter(|&i| number(i) != NONE));
        free[inner..].sort_unstable_by_key(|&i| number(i));
        let (n, shared) = (free.len() + sides, free.len() - inner);
        let below = n - inner;
        let value = |field: usize, i: usize| self.prescribed[field][of[i] as usize];
        let moves = |&i: &usize| number(i) == NONE && !is_own(&i) && (0..sides - 1).any(|f| value(f, i) != 0.0);
        let held: Vec<usize> = (0..m).filter(moves).collect();
        let force = |field: usize, i: usize| held.iter().map(|&h| at(h, i) * value(field, h)).sum::<f64>();
        let (mut panel, mut rest) = (vec![0.0; inner * n], vec![0.0; below * below]);
        for (q, &j) in free.iter().enumerate() {
            let column = match q.checked_sub(inner) {
                None => &mut panel[q * n + q..(q + 1) * n],
                Some(q) => &mut rest[q * below + q..(q + 1) * below],
            };
            column.iter_mut().zip(&free[q..]).for_each(|(x, &i)| *x = at(i, j));
            if !held.is_empty() {
                column[free.len() - q..].iter_mut().enumerate().take(sides - 1).for_each(|(f, x)| *x = force(f, j));
            }
        }
        for (f, g) in (0..sides - 1).flat_map(|f| (0..=f).map(move |g| (f, g))).filter(|_| !held.is_empty()) {
            rest[(shared + g) * below + shared + f] = held.iter().map(|&h| force(f, h) * value(g, h)).sum();
        }
        eliminate(&mut panel, n, &mut rest)?;
        let magnitude = |f: usize, i: usize| held.iter().map(|&h| (at(h, i) * value(f, h)).abs()).sum::<f64>();
        let fields = if held.is_empty() { 0..0 } else { 0..sides - 1 };
        let loads = fields.flat_map(|f| free[inner..].iter().map(move |&i| (f, i))).map(|(f, i)| magnitude(f, i)).collect();
        Ok(Part { rows: free[inner..].iter().map(|&i| number(i)).collect(), matrix: rest, loads })
    }
}

/// All elements, to be solved for some fields.
struct System<'a> {
    order: &'a Order,
    parts: Vec<Part>,
    fields: usize,
    /// What makes the diagonal one.
    scale: Vec<f64>,
}

impl System<'_> {
    /// Energy products of the solutions and a bound of the backward errors; both are checked, and so is that the matrix is not singular.
    fn solve(&mut self) -> Result<(DMatrix<f64>, f64), SolveError> {
        let size = self.order.count;
        self.scale = self.diagonal().into_iter().map(|d| if d > 0.0 { 1.0 / d.sqrt() } else { 1.0 }).collect();
        let known = self.probe();
        let factor = Factor::new(self.order, &self.parts, self.fields + 1).map_err(|bad| unsolvable(bad, size))?;
        let found = factor.solution(self.fields);
        let off: Vec<f64> = found.iter().zip(&known).zip(&self.scale).map(|((f, k), s)| (f - k) / s).collect();
        if !(largest(&off) <= ALLOWED_PROBE_ERROR) {
            return Err(SolveError::Singular { error: largest(&off), size });
        }
        let solutions: Vec<Vec<f64>> = (0..self.fields).map(|f| factor.solution(f)).collect();
        let (products, left) = self.products(&solutions);
        let loads = self.loads();
        let error = |f: usize| self.backward_error(&left[f], &solutions[f], &loads[f]);
        let errors: Vec<f64> = (0..self.fields).map(error).collect();
        let residual = largest(&errors);
        if !(residual <= ALLOWED_RESIDUAL) {
            return Err(SolveError::Residual { residual, allowed: ALLOWED_RESIDUAL, size });
        }
        Ok((products, residual))
    }

    fn diagonal(&self) -> Vec<f64> {
        let mut out = vec![0.0; self.order.count];
        for p in &self.parts {
            let n = p.rows.len() + self.fields + 1;
            p.rows.iter().enumerate().for_each(|(i, &u)| out[u as usize] += p.matrix[i * n + i]);
        }
        out
    }

    /// Makes the last right-hand side that of a known solution, which is returned.
    fn probe(&mut self) -> Vec<f64> {
        // Uneven entries, so that no kernel is orthogonal to them by symmetry.
        let entry = |(i, s): (usize, &f64)| s * (1.0 + 0.5 * (i as f64 * 0.754_877_666).fract());
        let known: Vec<f64> = self.scale.iter().enumerate().map(entry).collect();
        for p in &mut self.parts {
            let rows = p.rows.len();
            let n = rows + self.fields + 1;
            let values: Vec<f64> = p.rows.iter().map(|&u| known[u as usize]).collect();
            let mut product = vec![0.0; rows];
            multiply(&p.matrix, n, &values, &mut product);
            product.iter().enumerate().for_each(|(c, x)| p.matrix[c * n + n - 1] = -x);
        }
        known
    }

    /// `u_i K u_j`, summed element by element, which keeps the digits that the sum of stiff neighbours costs, and what every solution
    /// leaves of its equations.
    fn products(&self, solutions: &[Vec<f64>]) -> (DMatrix<f64>, Vec<Vec<f64>>) {
        let mut out = DMatrix::zeros(self.fields, self.fields);
        let mut left = vec![vec![0.0; self.order.count]; self.fields];
        for p in &self.parts {
            let (rows, size) = (p.rows.len(), p.rows.len() + self.fields);
            let mut local = vec![0.0; size * self.fields];
            for (f, values) in local.chunks_exact_mut(size).enumerate() {
                values.iter_mut().zip(&p.rows).for_each(|(v, &u)| *v = solutions[f][u as usize]);
                values[rows + f] = 1.0;
            }
            let mut product = vec![0.0; size];
            for (f, values) in local.chunks_exact(size).enumerate() {
                product.fill(0.0);
                multiply(&p.matrix, size + 1, values, &mut product);
                p.rows.iter().zip(&product).for_each(|(&u, x)| left[f][u as usize] += x);
                for (g, other) in local.chunks_exact(size).enumerate() {
                    out[(g, f)] += other.iter().zip(&product).map(|(a, b)| a * b).sum::<f64>();
                }
            }
        }
        (out, left)
    }

    /// Magnitudes of what prescribed values load the equations with.
    fn loads(&self) -> Vec<Vec<f64>> {
        let mut out = vec![vec![0.0; self.order.count]; self.fields];
        for p in &self.parts {
            for (load, sizes) in out.iter_mut().zip(p.loads.chunks_exact(p.rows.len().max(1))) {
                p.rows.iter().zip(sizes).for_each(|(&u, x)| load[u as usize] += x);
            }
        }
        out
    }

    /// Normwise backward error of the scaled system in maximum norms, that of the matrix taken for 1, which it is at least. Loads count with
    /// their magnitudes: where they cancel, as those of a uniform potential do, there is nothing else that rounding could be compared with.
    fn backward_error(&self, left: &[f64], x: &[f64], load: &[f64]) -> f64 {
        let scaled = |v: &[f64]| largest(&v.iter().zip(&self.scale).map(|(v, s)| v * s).collect::<Vec<_>>());
        let x: Vec<f64> = x.iter().zip(&self.scale).map(|(x, s)| x / s).collect();
        let below = largest(&x) + scaled(load);
        if below == 0.0 { scaled(left) } else { scaled(left) / below }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    /// A chain of springs between 0 and 1, one of them with a free unknown of its own in the middle.
    #[test]
    fn eliminated_unknowns_leave_the_energy_as_it_is() {
        let mut dofs = ElementDofs::empty(4);
        dofs.push(&[0, 1]);
        dofs.push(&[1, 3, 2]);
        let springs = |e: usize| match e {
            0 => vec![2.0, -2.0, -2.0, 2.0],
            // 1 - 3 and 3 - 2, of 4 and 6
            _ => vec![4.0, -4.0, 0.0, -4.0, 10.0, -6.0, 0.0, -6.0, 6.0],
        };
        let found = gram(&dofs, &[true, false, true, false], &[vec![0.0, 0.0, 1.0, 0.0]], springs).expect("held at both ends");
        assert_eq!(found.unknowns, 2);
        let stiffness = 1.0 / (1.0 / 2.0 + 1.0 / 4.0 + 1.0 / 6.0);
        assert!((found.products[(0, 0)] - stiffness).abs() < 1e-14);
    }

    /// A chain of `n` springs of uneven stiffness, its ends moved by 1 in turn.
    #[test]
    fn a_chain_has_the_stiffness_of_its_springs_in_series() {
        let n = 40;
        let mut dofs = ElementDofs::empty(n + 1);
        (0..n as u32).for_each(|e| dofs.push(&[e, e + 1]));
        let stiffness = |e: usize| 1.0 + (e as f64 * 0.37).fract();
        let spring = |e: usize| [1.0, -1.0, -1.0, 1.0].map(|k| k * stiffness(e)).to_vec();
        let held = |i: usize| i == 0 || i == n;
        let fixed: Vec<bool> = (0..=n).map(held).collect();
        let moved = |end: usize| (0..=n).map(|i| f64::from(u8::from(i == end))).collect::<Vec<_>>();
        let found = gram(&dofs, &fixed, &[moved(0), moved(n)], spring).expect("held at both ends");
        let series = 1.0 / (0..n).map(|e| 1.0 / stiffness(e)).sum::<f64>();
        for (i, j, expected) in [(0, 0, series), (0, 1, -series), (1, 0, -series), (1, 1, series)] {
            assert!((found.products[(i, j)] - expected).abs() < 1e-14, "{found:?}");
        }
        assert!(found.residual < 1e-14);
    }

    /// Two elements that share a bubble, their corners moved together: 0.1 + 0.2 - 0.3 is a rounding error, and so is all that follows.
    #[test]
    fn prescribed_values_that_cancel_leave_nothing() {
        let mut dofs = ElementDofs::empty(5);
        dofs.push(&[0, 1, 2, 3, 4]);
        dofs.push(&[0, 1, 2, 3, 4]);
        let bubbles = |_| {
            let couple = [0.1, 0.2, -0.3];
            let at = |i: usize, j: usize| match (i.min(j), i.max(j)) {
                (i, j) if i == j => 1.0,
                (i, j) if i < 3 && j >= 3 => couple[i] * (j - 2) as f64,
                _ => 0.1,
            };
            (0..25).map(|k| at(k / 5, k % 5)).collect()
        };
        let fixed = [true, true, true, false, false];
        let found = gram(&dofs, &fixed, &[vec![1.0, 1.0, 1.0, 0.0, 0.0]], bubbles).expect("all corners are held");
        assert!(found.residual < 1e-15 && (found.products[(0, 0)] - 7.2).abs() < 1e-14, "{found:?}");
    }

    #[test]
    fn a_part_that_nothing_holds_is_told() {
        let mut dofs = ElementDofs::empty(7);
        [[0, 1], [1, 2], [3, 4], [4, 5], [5, 6]].iter().for_each(|e| dofs.push(e));
        let fixed = [true, false, true, false, false, false, false];
        let soft = |_| vec![0.3, -0.3, -0.3, 0.3];
        let found = gram(&dofs, &fixed, &[vec![1.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0]], soft);
        assert!(matches!(found, Err(SolveError::NotPositiveDefinite { .. } | SolveError::Singular { .. })), "{found:?}");
        let broken = gram(&dofs, &[true; 7].map(|f| f), &[vec![1.0; 7]], soft).expect("all is held");
        assert!(broken.products[(0, 0)].abs() < 1e-15);
        let infinite = gram(&dofs, &[true, false, true, true, true, true, true], &[vec![0.0; 7]], |_| vec![f64::NAN; 4]);
        assert!(matches!(infinite, Err(SolveError::NotFinite { .. })), "{infinite:?}");
    }
}
