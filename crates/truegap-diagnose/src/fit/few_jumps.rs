//! Evidence of jumps of which a few may be all there are: a plug that was pulled once moves one zero of ten.
//!
//! With a jump before every run, each as large as the others, a recording in which one run jumped pays for ten numbers, and a straight drift of two passes for it. So half of the prior is
//! that any run may jump, as it was fitted, and half that one, two or three did, and the rest not at all.
//!
//! Limits: straight about the fit; jumps are normal, of one unknown width.
//!
//! **Source:** a spike at nothing and a slab: Mitchell & Beauchamp, J. Am. Stat. Assoc. 83 (1988) 1023.

use crate::{
    fit::tuning::{FEW_JUMPS, SIZE_SCALES},
    stats::log_mean_exp,
};
use nalgebra::{Cholesky, DMatrix, DVector};
use std::ops::Range;

/// What a recording tells of jumps, all other numbers integrated out: their log likelihood is `told' u - u' precision u / 2`.
struct Told {
    precision: DMatrix<f64>,
    told: DVector<f64>,
}

impl Told {
    /// From the curvature of a fit at its optimum `z`, which has the prior in it; the numbers `held` are not free. `None` where the curvature has no inverse.
    fn of(hessian: &DMatrix<f64>, z: &[f64], jumps: &Range<usize>, held: impl Fn(usize) -> bool) -> Option<Self> {
        let own: Vec<usize> = jumps.clone().collect();
        let others: Vec<usize> = (0..z.len()).filter(|i| !jumps.contains(i) && !held(*i)).collect();
        let block = |rows: &[usize], columns: &[usize]| hessian.select_rows(rows).select_columns(columns);
        let across = block(&others, &own);
        let taken = across.tr_mul(&Cholesky::new(block(&others, &others))?.solve(&across));
        let curvature = block(&own, &own) - taken;
        let told = &curvature * DVector::from_iterator(own.len(), own.iter().map(|i| z[*i]));
        Some(Self { precision: curvature - DMatrix::identity(own.len(), own.len()), told })
    }

    /// The same where the noise has so many times the variance.
    fn louder(self, times: f64) -> Self {
        Self { precision: self.precision / times, told: self.told / times }
    }

    /// Log evidence of these jumps with a normal prior of this width, over that of none.
    fn log_evidence(&self, jumps: &[usize], width: f64) -> f64 {
        let (n, prior) = (jumps.len(), width * width);
        let precision = self.precision.select_rows(jumps).select_columns(jumps);
        let Some(factor) = Cholesky::new(precision * prior + DMatrix::identity(n, n)) else { return f64::NEG_INFINITY };
        let told = DVector::from_iterator(n, jumps.iter().map(|jump| self.told[*jump]));
        0.5 * prior * told.dot(&factor.solve(&told)) - 0.5 * factor.ln_determinant()
    }

    /// The same with a width of which no more than its order of magnitude is known.
    fn of_any_width(&self, jumps: &[usize], widths: &[f64]) -> f64 {
        log_mean_exp(&widths.iter().map(|width| self.log_evidence(jumps, *width)).collect::<Vec<_>>())
    }
}

/// Log evidence that jumps gain where a few of them may be all, at noise of `louder` times the variance. `steps` are the numbers of the effect in `z`: the size, then the jumps in sizes.
pub(crate) fn few_jumps(hessian: &DMatrix<f64>, z: &[f64], steps: &Range<usize>, at_limit: &[bool], louder: f64) -> f64 {
    let (size, jumps) = (steps.start, steps.start + 1..steps.end);
    if z[size] == 0.0 || jumps.is_empty() {
        return 0.0;
    }
    // what a jump is in the unit of the reading is its size times its number, so that with both free one would be told twice
    let Some(told) = Told::of(hessian, z, &jumps, |i| i == size || at_limit[i]) else { return 0.0 };
    let told = told.louder(louder);
    let widths = SIZE_SCALES.map(|scale| scale / z[size].abs());
    let every: Vec<usize> = (0..jumps.len()).collect();
    let all = told.of_any_width(&every, &widths);
    let numbers = 1..=FEW_JUMPS.min(jumps.len());
    let of_number =
        |count| log_mean_exp(&chosen(count, jumps.len()).iter().map(|few| told.of_any_width(few, &widths)).collect::<Vec<_>>());
    let few = log_mean_exp(&numbers.map(of_number).collect::<Vec<_>>());
    let gain = log_mean_exp(&[0.0, few - all]);
    if gain.is_finite() { gain } else { 0.0 }
}

/// Every way to choose so many of `of`.
fn chosen(count: usize, of: usize) -> Vec<Vec<usize>> {
    let one_more = |sets: Vec<Vec<usize>>| {
        let after = |set: &Vec<usize>| set.last().map_or(0, |last| last + 1);
        sets.iter().flat_map(|set| (after(set)..of).map(|next| [set.as_slice(), &[next]].concat())).collect()
    };
    (0..count).fold(vec![Vec::new()], |sets, _| one_more(sets))
}

#[cfg(test)]
mod tests {
    use super::*;

    /// Rows of five runs: a jump before each but the first stays, beside a line through all of them whose slope is known to be of the order of 1.
    fn columns(rows: usize) -> (DMatrix<f64>, DVector<f64>) {
        let run = |row: usize| 5 * row / rows;
        let jumps = DMatrix::from_fn(rows, 4, |row, jump| f64::from(u8::from(run(row) > jump)));
        (jumps, DVector::from_fn(rows, |row, _| row as f64 / rows as f64))
    }

    /// Log density of rows with unit noise and these columns with normal numbers: the other route, by the covariance of the rows.
    fn log_density(rows: &DVector<f64>, columns: &[(DVector<f64>, f64)]) -> f64 {
        let mut covariance = DMatrix::identity(rows.len(), rows.len());
        columns.iter().for_each(|(column, width)| covariance += column * column.transpose() * (width * width));
        let factor = Cholesky::new(covariance).unwrap();
        -0.5 * rows.dot(&factor.solve(rows)) - 0.5 * factor.ln_determinant()
    }

    /// The fit of the line and all jumps in units of a size of `size`, as a search would leave it.
    fn fitted(rows: &DVector<f64>, size: f64) -> (DMatrix<f64>, Vec<f64>) {
        let (jumps, line) = columns(rows.len());
        let mut jacobian = DMatrix::zeros(rows.len(), 6);
        jacobian.set_column(0, &line);
        (0..4).for_each(|jump| jacobian.set_column(2 + jump, &(jumps.column(jump) * size)));
        let known = DMatrix::identity(6, 6);
        let optimum = Cholesky::new(jacobian.tr_mul(&jacobian) + &known).unwrap().solve(&jacobian.tr_mul(rows));
        let z: Vec<f64> = (0..6).map(|i| if i == 1 { size } else { optimum[i] }).collect();
        jacobian.set_column(1, &(&jumps * optimum.rows(2, 4)));
        (jacobian.tr_mul(&jacobian) + known, z)
    }

    #[test]
    fn a_few_jumps_are_weighed_as_the_density_of_the_rows_says() {
        let (jumps, line) = columns(60);
        let wobble = |row: usize| ((row * 7919) % 101) as f64 / 50.0 - 1.0;
        for (jump, slope) in [([3.0, 0.0, 0.0, 0.0], 0.4), ([0.5, -0.7, 0.6, 0.9], -1.0), ([0.0; 4], 0.0)] {
            let rows = &jumps * DVector::from_column_slice(&jump) + &line * slope + DVector::from_fn(60, |row, _| wobble(row));
            let size = 0.8;
            let (hessian, z) = fitted(&rows, size);
            let with = |few: &[usize], width: f64| {
                let own = few.iter().map(|jump| (jumps.column(*jump).into_owned(), width));
                log_density(&rows, &own.chain([(line.clone(), 1.0)]).collect::<Vec<_>>())
            };
            let any = |few: &[usize]| log_mean_exp(&SIZE_SCALES.map(|width| with(few, width)));
            let number = |count| log_mean_exp(&chosen(count, 4).iter().map(|few| any(few)).collect::<Vec<_>>());
            let few = log_mean_exp(&[number(1), number(2), number(3)]);
            let exact = log_mean_exp(&[0.0, few - any(&[0, 1, 2, 3])]);
            let found = few_jumps(&hessian, &z, &(1..6), &[false; 6], 1.0);
            approx::assert_relative_eq!(found, exact, max_relative = 1e-9);
        }
    }

    /// One jump of twelve gains what eleven numbers cost, less what it costs to say which; where all jump, at most half the prior is lost.
    #[test]
    fn one_jump_gains_and_many_lose_little() {
        let of = |jumps: &[f64]| {
            let n = jumps.len();
            // each jump is told by itself, to a tenth of the size
            let precision = DMatrix::from_diagonal_element(n + 1, n + 1, 101.0);
            let z: Vec<f64> = std::iter::once(1.0).chain(jumps.iter().map(|jump| jump * 100.0 / 101.0)).collect();
            few_jumps(&precision, &z, &(0..n + 1), &vec![false; n + 1], 1.0)
        };
        let mut one = [0.0; 12];
        one[4] = 1.5;
        assert!(of(&one) > 3.0, "{}", of(&one));
        let all = [1.0, -1.2, 0.7, 0.9, -0.8, 1.4, -0.6, 1.1, -1.3, 0.9, 0.8, -1.0];
        approx::assert_relative_eq!(of(&all), 0.5_f64.ln(), max_relative = 1e-9);
        // no size, no jumps
        assert_eq!(few_jumps(&DMatrix::identity(3, 3), &[0.0, 1.0, 1.0], &(0..3), &[false; 3], 1.0), 0.0);
    }

    #[test]
    fn every_choice_is_made_once() {
        assert_eq!(chosen(2, 4), [[0, 1], [0, 2], [0, 3], [1, 2], [1, 3], [2, 3]]);
        assert_eq!((chosen(3, 23).len(), chosen(1, 2).len()), (1771, 2));
    }
}
