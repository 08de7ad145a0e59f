//! Rows with nearly the same inputs, where no clock says which rows follow one another.
//!
//! Without a clock the order of rows means little: a table of set points may be written in any. What rows at neighbouring inputs differ by, a parabola in one
//! input or a plane in several taken out, is noise. Rows that were reached from below and from above are kept apart, since a loop is no noise.
//!
//! **Source:** Gasser, Sroka & Jennen-Steinmetz, Biometrika 73 (1986) 625 (residual variance from neighbouring rows).
//!
//! Limits: a law that bends within a few rows counts as noise; white noise only.

use crate::{
    noise::reml::Block,
    noise::tuning::{NEIGHBOURS_OF_EACH, OWN_NEIGHBOURS, ROWS_APART},
    stats::{median, spread},
};
use truegap_core::Inputs;

/// Groups of rows that are neighbours in all inputs that move; `load` is the load where the base model knows one.
pub fn neighbours(inputs: &Inputs, load: Option<&[f64]>) -> Vec<Block> {
    let moving = moving(inputs, load);
    if moving.is_empty() {
        return Vec::new();
    }
    let leaf = if moving.len() == 1 { 2 * NEIGHBOURS_OF_EACH } else { NEIGHBOURS_OF_EACH * (moving.len() + 1) };
    alike(inputs, &moving[0])
        .into_iter()
        .flat_map(|rows| leaves(&moving, rows, leaf))
        .filter_map(|rows| block(&moving, rows))
        .collect()
}

/// Whether rows at neighbouring inputs lie apart in the file, as where the same inputs are passed again and again: noise that lasts from row to row can then be told
/// from a curve over the inputs.
pub fn lie_apart(blocks: &[Block]) -> bool {
    let nearest = |block: &Block| {
        let mut rows = block.rows.clone();
        rows.sort_unstable();
        rows.windows(2).map(|pair| (pair[1] - pair[0]) as f64).collect::<Vec<_>>()
    };
    let apart: Vec<f64> = blocks.iter().flat_map(nearest).collect();
    !apart.is_empty() && median(&apart) >= ROWS_APART
}

/// The inputs that move, each over its range.
fn moving(inputs: &Inputs, load: Option<&[f64]>) -> Vec<Vec<f64>> {
    let others = [&inputs.gap_m, &inputs.simulated, &inputs.temperature_c, &inputs.humidity_pct];
    let drivers = inputs.drivers.iter().map(|driver| driver.values.as_slice());
    // a load that is made of the gap is the gap
    let load = load.filter(|_| inputs.gap_m.is_none());
    let columns = load.into_iter().chain(others.into_iter().filter_map(|column| column.as_deref())).chain(drivers);
    let moves = columns.filter(|column| !column.is_empty() && spread(column) > 0.0);
    moves.map(|column| column.iter().map(|value| value / spread(column)).collect()).collect()
}

/// Rows of one run, or of all where runs are short, reached from one side.
fn alike(inputs: &Inputs, column: &[f64]) -> Vec<Vec<usize>> {
    let mut groups: std::collections::BTreeMap<(usize, bool), Vec<usize>> = std::collections::BTreeMap::new();
    for (index, run) in inputs.runs().into_iter().enumerate() {
        let own = if run.len() >= OWN_NEIGHBOURS { index } else { usize::MAX };
        for row in run.clone() {
            // the first row of a run belongs with the second
            let later = row.max(run.start + 1).min(run.end - 1);
            let falls = later > run.start && column[later] < column[later - 1];
            groups.entry((own, falls)).or_default().push(row);
        }
    }
    groups.into_values().collect()
}

/// Halves rows along the input that moves most among them, until there are at most `leaf` of them.
fn leaves(moving: &[Vec<f64>], mut rows: Vec<usize>, leaf: usize) -> Vec<Vec<usize>> {
    if rows.len() <= leaf {
        return vec![rows];
    }
    let of = |column: &[f64]| rows.iter().map(|row| column[*row]).collect::<Vec<f64>>();
    let widest = moving.iter().max_by(|a, b| spread(&of(a)).total_cmp(&spread(&of(b))));
    let Some(widest) = widest else { return vec![rows] };
    rows.sort_by(|a, b| widest[*a].total_cmp(&widest[*b]));
    let above = rows.split_off(rows.len() / 2);
    let mut all = leaves(moving, rows, leaf);
    all.extend(leaves(moving, above, leaf));
    all
}

/// Rows with the columns that are taken out of them, orthonormal; `None` where nothing is left to be noise.
fn block(moving: &[Vec<f64>], rows: Vec<usize>) -> Option<Block> {
    let of = |column: &Vec<f64>| {
        let values: Vec<f64> = rows.iter().map(|row| column[*row]).collect();
        let mean = values.iter().sum::<f64>() / values.len() as f64;
        values.into_iter().map(|value| value - mean).collect::<Vec<f64>>()
    };
    let mut wanted = vec![vec![1.0; rows.len()]];
    wanted.extend(moving.iter().map(of));
    if let [column] = moving {
        wanted.push(of(column).into_iter().map(|x| x * x).collect());
    }
    let mut course: Vec<Vec<f64>> = Vec::new();
    for mut column in wanted {
        let length = |column: &[f64]| column.iter().map(|x| x * x).sum::<f64>().sqrt();
        let before = length(&column);
        for other in &course {
            let along: f64 = column.iter().zip(other).map(|(a, b)| a * b).sum();
            column.iter_mut().zip(other).for_each(|(a, b)| *a -= along * b);
        }
        let after = length(&column);
        // inputs that repeat leave fewer columns
        if after > 1e-6 * before && after > 0.0 {
            course.push(column.into_iter().map(|x| x / after).collect());
        }
    }
    (rows.len() > course.len()).then(|| Block::unordered(rows, course))
}

#[cfg(test)]
#[allow(clippy::unwrap_used)]
mod tests {
    use super::*;
    use crate::noise::reml::estimate;
    use rand::{SeedableRng, seq::SliceRandom};
    use rand_distr::Distribution;

    fn noisy(law: impl Fn(usize) -> f64, rows: usize, seed: u64) -> Vec<f64> {
        let mut random = rand_chacha::ChaCha8Rng::seed_from_u64(seed);
        let normal = rand_distr::Normal::new(0.0, 0.02).unwrap();
        (0..rows).map(|row| law(row) + normal.sample(&mut random)).collect()
    }

    fn set_points(force: Vec<f64>) -> Inputs {
        Inputs { run: vec![1; force.len()], force_n: Some(force), ..Inputs::default() }
    }

    #[test]
    fn a_bent_law_at_set_points_in_any_order_leaves_its_noise() {
        let mut force: Vec<f64> = (0..200).map(|row| 0.01 * f64::from(row)).collect();
        force.shuffle(&mut rand_chacha::ChaCha8Rng::seed_from_u64(3));
        let inputs = set_points(force.clone());
        let response = noisy(|row| 5.0 * (1.5 * force[row]).exp(), 200, 4);
        let (noise, uncertainty) = estimate(&response, &neighbours(&inputs, Some(&force)));
        // 200 rows, 3 of each 8 (or fewer) taken out: about 100 left, so 7 % at one standard deviation
        approx::assert_relative_eq!(noise.white_sd, 0.02, max_relative = 0.25);
        assert!(noise.ar_sd == 0.0 && uncertainty < 0.25, "{noise:?} {uncertainty}");
    }

    #[test]
    fn a_loop_is_no_noise() {
        let force: Vec<f64> = (0..240).map(|row| if row < 120 { f64::from(row) } else { f64::from(240 - row) }).collect();
        let inputs = set_points(force.clone());
        let response = noisy(|row| 0.1 * force[row] + if row <= 120 { 0.0 } else { 1.0 }, 240, 5);
        let (noise, _) = estimate(&response, &neighbours(&inputs, Some(&force)));
        approx::assert_relative_eq!(noise.white_sd, 0.02, max_relative = 0.25);
    }

    #[test]
    fn rows_at_one_input_lie_apart_where_it_is_passed_again_and_again() {
        let sorted: Vec<f64> = (0..200).map(|row| 0.01 * f64::from(row)).collect();
        let swept: Vec<f64> = (0..200).map(|row| f64::from(row % 5)).collect();
        assert!(!lie_apart(&neighbours(&set_points(sorted.clone()), Some(&sorted))));
        assert!(lie_apart(&neighbours(&set_points(swept.clone()), Some(&swept))));
    }

    #[test]
    fn two_inputs_are_followed_by_planes() {
        let mut random = rand_chacha::ChaCha8Rng::seed_from_u64(6);
        let uniform = rand_distr::Uniform::new(0.0, 1.0).unwrap();
        let mut column = || (0..400).map(|_| uniform.sample(&mut random)).collect::<Vec<f64>>();
        let (force, warm) = (column(), column());
        let inputs = Inputs { temperature_c: Some(warm.clone()), ..set_points(force.clone()) };
        let response = noisy(|row| 0.3 * force[row] + 0.2 * warm[row] + 0.1 * force[row] * warm[row], 400, 7);
        let (noise, _) = estimate(&response, &neighbours(&inputs, Some(&force)));
        approx::assert_relative_eq!(noise.white_sd, 0.02, max_relative = 0.2);
    }

    #[test]
    fn rows_at_the_same_inputs_are_replicates() {
        let force: Vec<f64> = (0..60).map(|row| f64::from(row / 6)).collect();
        let inputs = set_points(force.clone());
        let response = noisy(|row| force[row].powi(3), 60, 8);
        let rows: usize = neighbours(&inputs, Some(&force)).iter().map(|block| block.rows.len()).sum();
        assert_eq!(rows, 60);
        // fifty degrees of freedom tell a deviation to a tenth
        approx::assert_relative_eq!(estimate(&response, &neighbours(&inputs, Some(&force))).0.white_sd, 0.02, max_relative = 0.3);
    }
}
