//! Load vectors and residuals, element by element.

use crate::space::ElementDofs;
use rayon::prelude::*;

/// Sum over all unknowns of the element vectors that `element(e, out)` writes; `out` is zero on entry.
///
/// Computed in parallel, added in element order.
pub fn assemble_vector(dofs: &ElementDofs, element: impl Fn(usize, &mut [f64]) + Sync) -> Vec<f64> {
    let mut sum = vec![0.0; dofs.count];
    for_each_element(
        dofs.elements(),
        |e| {
            let mut out = vec![0.0; dofs.of(e).len()];
            element(e, &mut out);
            out
        },
        |e, out: Vec<f64>| dofs.of(e).iter().zip(out).for_each(|(&d, x)| sum[d as usize] += x),
    );
    sum
}

/// Residual `K u` over all unknowns, fixed ones included, from element matrices (as `Pattern::assemble` takes them).
///
/// On fixed unknowns it is the reaction: charge, or force. Products are formed per element, which keeps the digits
/// that cancellation between stiff neighbours costs an assembled matrix.
pub fn element_residual(dofs: &ElementDofs, u: &[f64], matrix: impl Fn(usize, &mut [f64]) + Sync) -> Vec<f64> {
    assemble_vector(dofs, |e, out| {
        let of = dofs.of(e);
        let m = of.len();
        let mut local = vec![0.0; m * m];
        matrix(e, &mut local);
        for i in 0..m {
            out[i] = (0..m).map(|j| local[i.min(j) * m + i.max(j)] * u[of[j] as usize]).sum();
        }
    })
}

/// Computes `work(e)` for all elements in parallel batches and hands the results to `take` in order.
///
/// Few elements, and those of a single thread, are computed here: to hand them to another thread and wait for it costs more than they do.
pub(crate) fn for_each_element<T: Send>(elements: usize, work: impl Fn(usize) -> T + Sync, mut take: impl FnMut(usize, T)) {
    const BATCH: usize = 16384;
    const FEW: usize = 64;
    if elements <= FEW || rayon::current_num_threads() == 1 {
        return (0..elements).for_each(|e| take(e, work(e)));
    }
    for first in (0..elements).step_by(BATCH) {
        let last = elements.min(first + BATCH);
        let batch: Vec<T> = (first..last).into_par_iter().with_min_len(64).map(&work).collect();
        batch.into_iter().enumerate().for_each(|(k, t)| take(first + k, t));
    }
}
