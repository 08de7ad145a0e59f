use super::*;
use nalgebra::DVector;

#[test]
fn the_filter_equals_the_dense_covariance() {
    let noise = Noise { white_sd: 0.7, ar_sd: 1.3, ar_correlation: 0.8 };
    let extra: Vec<f64> = (0..12).map(|i| 0.05 * f64::from(i)).collect();
    let x: Vec<f64> = (0..12).map(|i| f64::from(i).sin()).collect();
    let covariance = DMatrix::from_fn(12, 12, |i, j| {
        let same_run = (i < 5) == (j < 5);
        let lag = (i as f64 - j as f64).abs();
        let ar = if same_run { 1.69 * 0.8f64.powf(lag) } else { 0.0 };
        ar + if i == j { 0.49 + extra[i] } else { 0.0 }
    });
    let dense = covariance.clone().cholesky().unwrap();
    let v = DVector::from_column_slice(&x);
    let quadratic = v.dot(&dense.solve(&v));
    let filter = Whitener::new(&noise, &InputError::white(extra), None, &[0..5, 5..12], None);
    let mut w = x;
    filter.apply(&mut w);
    approx::assert_relative_eq!(w.iter().map(|a| a * a).sum::<f64>(), quadratic, max_relative = 1e-12);
    approx::assert_relative_eq!(filter.log_determinant, covariance.determinant().ln(), max_relative = 1e-10);
}

/// Unit lines over 30 rows with independent errors of their means, as smoothing leaves them: the filter must find the mean of all rows as uncertain as the
/// dense covariance of a moving average does, within what an autoregression can copy of it.
#[test]
fn the_error_of_smoothed_inputs_weighs_in_the_mean_like_the_noise_as_recorded() {
    let (n, window) = (600usize, 30usize);
    let noise = Noise { white_sd: 0.5, ar_sd: 0.0, ar_correlation: 0.0 };
    let covariance = DMatrix::from_fn(n, n, |i, j| {
        let shared = (window as f64 - i.abs_diff(j) as f64).max(0.0) / (window * window) as f64;
        shared + if i == j { 0.25 } else { 0.0 }
    });
    let ones = DVector::from_element(n, 1.0);
    let dense = ones.dot(&covariance.cholesky().unwrap().solve(&ones));
    let smoothed = InputError { variance: vec![1.0 / window as f64; n], level: vec![1.0; n], ..InputError::default() };
    let information = |input: &InputError| {
        let mut one = vec![1.0; n];
        Whitener::new(&noise, input, None, &[0..n], None).apply(&mut one);
        one.iter().map(|v| v * v).sum::<f64>()
    };
    approx::assert_relative_eq!(information(&smoothed), dense, max_relative = 0.05);
    // taken as independent, it would promise four times as much
    assert!(information(&InputError::white(smoothed.variance.clone())) > 4.0 * dense);
}

#[test]
fn noise_that_was_coloured_is_whitened_again() {
    let noise = Noise { white_sd: 0.7, ar_sd: 1.3, ar_correlation: 0.8 };
    let filter = Whitener::new(&noise, &InputError::white(vec![0.1; 9]), Some(&[3.0; 9]), &[0..4, 4..9], None);
    let white: Vec<f64> = (0..9).map(|i| (1.7 * f64::from(i)).cos()).collect();
    let mut column = white.clone();
    filter.colour(&mut column);
    assert!(column.iter().zip(&white).any(|(a, b)| (a - b).abs() > 0.1));
    filter.apply(&mut column);
    column.iter().zip(&white).for_each(|(a, b)| approx::assert_relative_eq!(a, b, max_relative = 1e-12));
}

#[test]
fn columns_side_by_side_come_out_as_each_by_itself() {
    let noise = Noise { white_sd: 0.7, ar_sd: 1.3, ar_correlation: 0.8 };
    let lasting = Lasting { variance: vec![0.4; 9], memory: vec![0.9; 9], of_reading: false };
    let of = |row: usize, k: usize| (1.7 * row as f64 + k as f64).cos();
    for input in [InputError::white(vec![0.1; 9]), InputError { lasting: vec![lasting], ..InputError::white(vec![0.1; 9]) }] {
        let input = InputError { shapes: vec![(0..9).map(|i| i as f64).collect()], ..input };
        let filter =
            Whitener::new(&noise, &input, None, &[0..4, 4..9], Some(&[true, true, true, false, true, true, true, true, true]));
        for count in [1, 4, 6] {
            let columns: Vec<Vec<f64>> = (0..count).map(|k| (0..9).map(|row| of(row, k)).collect()).collect();
            let mut together = columns.clone();
            filter.apply_each(&mut together);
            for (mut alone, found) in columns.into_iter().zip(together) {
                filter.apply(&mut alone);
                assert_eq!(alone, found);
            }
        }
    }
}

/// Noise without a memory is divided by its deviation; of the parts of lasting noise one has any size, and the other route is the dense covariance.
#[test]
fn a_part_of_the_noise_that_is_nothing_takes_no_state() {
    let noise = Noise { white_sd: 0.7, ar_sd: 0.0, ar_correlation: 0.0 };
    let lasting = Lasting { variance: vec![0.4; 6], memory: vec![0.9; 6], of_reading: false };
    let white = Whitener::new(&noise, &InputError::white(vec![0.0; 6]), None, &[0..6], None);
    let lasts = InputError { lasting: vec![lasting], ..InputError::white(vec![0.0; 6]) };
    let lasts = Whitener::new(&noise, &lasts, None, &[0..6], None);
    assert_eq!([white.states, lasts.states], [0, 1]);
    let x: Vec<f64> = (0..6).map(|i| f64::from(i).sin()).collect();
    let mut plain = x.clone();
    white.apply(&mut plain);
    plain.iter().zip(&x).for_each(|(found, x)| approx::assert_relative_eq!(*found, x / 0.7, max_relative = 1e-14));
    let covariance = DMatrix::from_fn(6, 6, |i, j| {
        let lag = (i as f64 - j as f64).abs();
        0.4 * 0.9f64.powf(lag) + if i == j { 0.49 } else { 0.0 }
    });
    let v = DVector::from_column_slice(&x);
    let mut found = x.clone();
    lasts.apply(&mut found);
    approx::assert_relative_eq!(squared(&found), v.dot(&covariance.cholesky().unwrap().solve(&v)), max_relative = 1e-12);
}

/// Slow noise of a very long recording, of a reading and two inputs that are written in steps: eleven parts that last.
#[test]
fn every_part_of_the_noise_counts_however_many_there_are() {
    let noise = Noise { white_sd: 0.7, ar_sd: 0.0, ar_correlation: 0.0 };
    let memory = |k: usize| 0.3 + 0.06 * k as f64;
    let part = |k: usize| Lasting { variance: vec![0.4; 14], memory: vec![memory(k); 14], of_reading: true };
    let input = InputError { lasting: (0..11).map(part).collect(), ..InputError::white(vec![0.0; 14]) };
    let covariance = DMatrix::from_fn(14, 14, |i, j| {
        let lasting = (0..11).map(|k| 0.4 * memory(k).powi(i.abs_diff(j) as i32)).sum::<f64>();
        if (i < 6) == (j < 6) { lasting + if i == j { 0.49 } else { 0.0 } } else { 0.0 }
    });
    let filter = Whitener::new(&noise, &input, None, &[0..6, 6..14], None);
    is_the_dense_covariance(&filter, &covariance);
    let columns: Vec<Vec<f64>> = (0..5).map(|k| (0..14).map(|row| ((row + k) as f64).cos()).collect()).collect();
    let mut together = columns.clone();
    filter.apply_each(&mut together);
    for (mut alone, found) in columns.into_iter().zip(together) {
        filter.apply(&mut alone);
        assert_eq!(alone, found);
    }
}

#[test]
fn a_row_left_out_carries_no_weight() {
    let noise = Noise { white_sd: 0.7, ar_sd: 1.3, ar_correlation: 0.8 };
    let keep = [true, true, false, true];
    let filter = Whitener::new(&noise, &InputError::white(vec![0.0; 4]), None, &[0..4], Some(&keep));
    let (mut a, mut b) = (vec![1.0, 2.0, 3.0, 4.0], vec![1.0, 2.0, -50.0, 4.0]);
    filter.apply(&mut a);
    filter.apply(&mut b);
    assert_eq!(a, b);
    assert_eq!(a[2], 0.0);
}

/// The filter weighs a column, knows its determinant and colours white noise as the covariance itself does.
fn is_the_dense_covariance(filter: &Whitener, covariance: &DMatrix<f64>) {
    let x: Vec<f64> = (0..covariance.nrows()).map(|i| (1.3 * i as f64).sin()).collect();
    let mut white = x.clone();
    filter.apply(&mut white);
    let dense = covariance.clone().cholesky().unwrap();
    let column = DVector::from_column_slice(&x);
    approx::assert_relative_eq!(squared(&white), column.dot(&dense.solve(&column)), max_relative = 1e-10);
    approx::assert_relative_eq!(filter.log_determinant, covariance.determinant().ln(), max_relative = 1e-10);
    filter.colour(&mut white);
    approx::assert_relative_eq!(white.as_slice(), x.as_slice(), epsilon = 1e-12, max_relative = 1e-10);
}

/// Two columns in steps: each error is one number a value, whatever the row.
#[test]
fn errors_that_last_equal_the_dense_covariance() {
    let n = 9;
    let noise = Noise { white_sd: 0.6, ar_sd: 0.9, ar_correlation: 0.5 };
    let held = |starts: &[usize], variance: f64| Lasting {
        variance: vec![variance; n],
        memory: (0..n).map(|i| if starts.contains(&i) { 0.0 } else { 1.0 }).collect(),
        of_reading: false,
    };
    let lasting = vec![held(&[0, 4], 0.7), held(&[0, 2, 6], 0.2)];
    let louder: Vec<f64> = (0..n).map(|i| if i == 5 { 3.0 } else { 0.0 }).collect();
    let input = InputError { lasting, louder: louder.clone(), ..InputError::white(vec![0.1; n]) };
    let filter = Whitener::new(&noise, &input, None, &[0..n], None);
    let alike = |i: usize, j: usize, starts: &[usize]| starts.iter().all(|s| (i < *s) == (j < *s));
    let covariance = DMatrix::from_fn(n, n, |i, j| {
        let own = if i == j { noise.white_sd.powi(2) + 0.1 + louder[i] } else { 0.0 };
        let held = if alike(i, j, &[4]) { 0.7 } else { 0.0 } + if alike(i, j, &[2, 6]) { 0.2 } else { 0.0 };
        own + held + noise.ar_sd.powi(2) * noise.ar_correlation.powi(i.abs_diff(j) as i32)
    });
    is_the_dense_covariance(&filter, &covariance);
}

#[test]
fn shapes_of_unknown_weight_equal_the_dense_covariance() {
    let n = 9;
    let noise = Noise { white_sd: 0.6, ar_sd: 0.9, ar_correlation: 0.5 };
    let shapes: Vec<Vec<f64>> = vec![(0..n).map(|i| (i as f64).cos()).collect(), (0..n).map(|i| 0.3 * i as f64).collect()];
    let input = InputError { shapes: shapes.clone(), ..InputError::white(vec![0.1; n]) };
    let filter = Whitener::new(&noise, &input, None, &[0..n], None);
    let covariance = DMatrix::from_fn(n, n, |i, j| {
        let apart = i.abs_diff(j) as i32;
        let own = if i == j { noise.white_sd.powi(2) + 0.1 } else { 0.0 };
        own + noise.ar_sd.powi(2) * noise.ar_correlation.powi(apart) + shapes.iter().map(|s| s[i] * s[j]).sum::<f64>()
    });
    is_the_dense_covariance(&filter, &covariance);
}

/// White noise in means of several rows, some of them louder beforehand.
#[test]
fn a_mean_of_rows_has_the_noise_of_a_mean() {
    let weights = [1.0, 4.0, 9.0, 2.0, 5.0];
    let noise = Noise { white_sd: 0.6, ar_sd: 0.0, ar_correlation: 0.0 };
    let filter = Whitener::new(&noise, &InputError::white(vec![0.0; 5]), Some(&weights), &[0..5], None);
    is_the_dense_covariance(&filter, &DMatrix::from_diagonal(&DVector::from_fn(5, |i, _| 0.36 / weights[i])));
}
