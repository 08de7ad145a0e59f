//! The sparsity pattern of the free unknowns, and the scatter map of the element entries into it.

use super::error::SolveError;
use crate::mesh::NONE;
use crate::space::{ElementDofs, Numbering};
use nalgebra_sparse::CscMatrix;
use rayon::prelude::*;
use std::ops::Range;

/// Elements whose matrices are computed before any is added: keeps the buffers in the cache and the threads busy.
const BATCH: usize = 8192;

/// Lower triangle of a symmetric system over the free unknowns, and where each element entry goes.
#[derive(Debug, Clone)]
pub struct Pattern {
    /// The matrix before anything is added: it holds the pattern.
    zeros: CscMatrix<f64>,
    scatter: ScatterMap,
}

/// Scatter map: where each element entry goes in the values of a matrix.
#[derive(Debug, Clone)]
pub struct ScatterMap {
    /// For every element, the positions of its lower entries (row >= column, column by column); `NONE` if fixed.
    positions: Vec<u32>,
    offsets: Vec<usize>,
    sizes: Vec<u8>,
}

impl Pattern {
    /// Finds the pattern of the free unknowns of all elements.
    ///
    /// # Errors
    /// `WrongNumbering` where `numbering` is not one of the unknowns of `dofs`; `ElementTooLarge` for more than 255
    /// unknowns an element; `TooManyEntries` where an entry has no 32-bit position.
    pub fn new(dofs: &ElementDofs, numbering: &Numbering) -> Result<Pattern, SolveError> {
        check(dofs, numbering)?;
        let n = numbering.free.len();
        let (starts, columns) = touching(dofs, numbering, n);
        let parts: Vec<Part> = (0..n)
            .into_par_iter()
            .step_by(BATCH)
            .map(|first| part(dofs, numbering, (&starts, &columns), first..n.min(first + BATCH)))
            .collect();
        let mut offsets = Vec::with_capacity(n + 1);
        offsets.push(0);
        let mut rows = Vec::with_capacity(parts.iter().map(|p| p.rows.len()).sum());
        for part in parts {
            offsets.extend(part.ends.iter().map(|end| rows.len() + end));
            rows.extend(part.rows);
        }
        if rows.len() >= NONE as usize {
            return Err(SolveError::TooManyEntries { entries: rows.len(), size: n });
        }
        let scatter = ScatterMap::new(dofs, numbering, &offsets, &rows)?;
        let values = vec![0.0; rows.len()];
        let zeros = CscMatrix::try_from_csc_data(n, n, offsets, rows, values)
            .map_err(|e| SolveError::Analysis { size: n, reason: e.to_string() })?;
        Ok(Pattern { zeros, scatter })
    }

    /// Number of free unknowns.
    pub fn size(&self) -> usize {
        self.zeros.ncols()
    }

    /// A matrix of zeros with this pattern.
    pub fn matrix(&self) -> CscMatrix<f64> {
        self.zeros.clone()
    }

    /// Overwrites `matrix` as [`ScatterMap::assemble`] does.
    pub fn assemble(&self, matrix: &mut CscMatrix<f64>, element: impl Fn(usize, &mut [f64]) + Sync) {
        self.scatter.assemble(matrix, element);
    }

    /// A matrix of zeros that takes the pattern over, and its scatter map: the pattern is then held once, not twice.
    pub fn into_matrix(self) -> (CscMatrix<f64>, ScatterMap) {
        (self.zeros, self.scatter)
    }
}

/// Checks what [`Pattern::new`] indexes with.
fn check(dofs: &ElementDofs, numbering: &Numbering) -> Result<(), SolveError> {
    let n = numbering.free.len();
    let known = |row: &u32| *row == NONE || (*row as usize) < n;
    let largest = (0..dofs.elements()).flat_map(|e| dofs.of(e)).max().map_or(0, |&d| d as usize + 1);
    if numbering.rows.len() < largest.max(dofs.count) || !numbering.rows.iter().all(known) {
        return Err(SolveError::WrongNumbering { unknowns: largest.max(dofs.count), numbered: numbering.rows.len(), free: n });
    }
    Ok(())
}

impl ScatterMap {
    fn new(
        dofs: &ElementDofs,
        numbering: &Numbering,
        csc_offsets: &[usize],
        csc_rows: &[usize],
    ) -> Result<ScatterMap, SolveError> {
        let elements = dofs.elements();
        let size = |e: usize| {
            let unknowns = dofs.of(e).len();
            u8::try_from(unknowns).map_err(|_| SolveError::ElementTooLarge { element: e, unknowns, most: u8::MAX.into() })
        };
        let sizes: Vec<u8> = (0..elements).map(size).collect::<Result<_, _>>()?;
        let mut offsets = vec![0usize; elements + 1];
        for e in 0..elements {
            let m = sizes[e] as usize;
            offsets[e + 1] = offsets[e] + m * (m + 1) / 2;
        }
        let mut positions = vec![NONE; offsets[elements]];
        let mut slices: Vec<&mut [u32]> = Vec::with_capacity(elements);
        let mut rest = positions.as_mut_slice();
        for e in 0..elements {
            let (head, tail) = rest.split_at_mut(offsets[e + 1] - offsets[e]);
            slices.push(head);
            rest = tail;
        }
        slices.par_iter_mut().enumerate().for_each(|(e, slots)| {
            let dofs = dofs.of(e);
            let mut k = 0;
            for (j, &b) in dofs.iter().enumerate() {
                for &a in &dofs[j..] {
                    let (p, q) = (numbering.rows[a as usize], numbering.rows[b as usize]);
                    if p != NONE && q != NONE {
                        let (row, column) = (p.max(q) as usize, p.min(q) as usize);
                        let lane = &csc_rows[csc_offsets[column]..csc_offsets[column + 1]];
                        slots[k] = (csc_offsets[column] + lane.partition_point(|&r| r < row)) as u32;
                    }
                    k += 1;
                }
            }
        });
        Ok(ScatterMap { positions, offsets, sizes })
    }

    /// Overwrites `matrix` with the sum of the element matrices that `element(e, out)` writes.
    ///
    /// `out` is full, column by column (`out[j * m + i]` for m unknowns) and zero on entry; only its lower triangle
    /// is read. Computed in parallel, added in element order: the result does not depend on the number of threads.
    pub fn assemble(&self, matrix: &mut CscMatrix<f64>, element: impl Fn(usize, &mut [f64]) + Sync) {
        let values = matrix.values_mut();
        values.fill(0.0);
        let elements = self.sizes.len();
        let widest = self.sizes.iter().copied().max().unwrap_or(0) as usize;
        let stride = widest * widest;
        let mut buffer = vec![0.0; stride * BATCH.min(elements)];
        for first in (0..elements).step_by(BATCH) {
            let count = BATCH.min(elements - first);
            buffer[..stride * count].par_chunks_mut(stride).with_min_len(64).enumerate().for_each(|(k, out)| {
                let m = self.sizes[first + k] as usize;
                out[..m * m].fill(0.0);
                element(first + k, &mut out[..m * m]);
            });
            for k in 0..count {
                self.add(first + k, &buffer[stride * k..], values);
            }
        }
    }

    #[inline]
    fn add(&self, e: usize, local: &[f64], values: &mut [f64]) {
        let m = self.sizes[e] as usize;
        let positions = &self.positions[self.offsets[e]..self.offsets[e + 1]];
        let mut k = 0;
        for j in 0..m {
            for i in j..m {
                if positions[k] != NONE {
                    values[positions[k] as usize] += local[j * m + i];
                }
                k += 1;
            }
        }
    }
}

/// Elements that touch each free unknown, as offsets and a flat list.
fn touching(dofs: &ElementDofs, numbering: &Numbering, n: usize) -> (Vec<usize>, Vec<u32>) {
    let mut starts = vec![0usize; n + 1];
    let rows = |e: usize| dofs.of(e).iter().map(|&d| numbering.rows[d as usize]).filter(|&r| r != NONE);
    for e in 0..dofs.elements() {
        rows(e).for_each(|r| starts[r as usize + 1] += 1);
    }
    for i in 0..n {
        starts[i + 1] += starts[i];
    }
    let mut cursor = starts.clone();
    let mut list = vec![0u32; starts[n]];
    for e in 0..dofs.elements() {
        for r in rows(e) {
            list[cursor[r as usize]] = e as u32;
            cursor[r as usize] += 1;
        }
    }
    (starts, list)
}

/// Lanes of some columns, one after the other, and where each ends.
struct Part {
    rows: Vec<usize>,
    ends: Vec<usize>,
}

fn part(dofs: &ElementDofs, numbering: &Numbering, (starts, elements): (&[usize], &[u32]), columns: Range<usize>) -> Part {
    let mut out = Part { rows: Vec::with_capacity(16 * columns.len()), ends: Vec::with_capacity(columns.len()) };
    let mut lane = Vec::with_capacity(64);
    for column in columns {
        fill_lane(dofs, numbering, &elements[starts[column]..starts[column + 1]], column as u32, &mut lane);
        out.rows.extend_from_slice(&lane);
        out.ends.push(out.rows.len());
    }
    out
}

fn fill_lane(dofs: &ElementDofs, numbering: &Numbering, elements: &[u32], column: u32, rows: &mut Vec<usize>) {
    rows.clear();
    // The diagonal is always there, so that unknowns without stiffness are found by the factorisation.
    rows.push(column as usize);
    for &e in elements {
        let of = dofs.of(e as usize).iter().map(|&d| numbering.rows[d as usize]);
        rows.extend(of.filter(|&r| r != NONE && r >= column).map(|r| r as usize));
    }
    rows.sort_unstable();
    rows.dedup();
}
