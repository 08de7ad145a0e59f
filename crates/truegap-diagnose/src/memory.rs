//! Exact recursions for physics that remembers, on uneven time steps, restarted with each run.
//!
//! Limits: inputs are taken as linear between rows (lags) or as given at rows (plays, running maxima).

use truegap_core::Inputs;

/// First-order lag `tau y' + y = x`, exact for `x` linear between rows; each run starts at rest at `start(x of its first row)`.
pub fn first_order_lag(inputs: &Inputs, tau_s: f64, x: &mut [f64], start: impl Fn(f64) -> f64) {
    let steps = inputs.steps_s();
    for run in inputs.runs() {
        let mut before = x[run.start];
        let mut state = start(before);
        x[run.start] = state;
        for row in run.start + 1..run.end {
            let (now, step) = (x[row], steps[row]);
            state = lag_step(state, before, now, step / tau_s);
            before = now;
            x[row] = state;
        }
    }
}

/// One exact step of a lag: state, input before, input now, step over time constant.
pub fn lag_step(state: f64, before: f64, now: f64, ratio: f64) -> f64 {
    if ratio <= 0.0 {
        return state;
    }
    let decay = (-ratio).exp();
    let mean = -(-ratio).exp_m1() / ratio;
    state * decay + before * (mean - decay) + now * (1.0 - mean)
}

/// Play operator of half width `width`: the output stays until the input pushes it; each run starts at `start(x of its first row)`.
pub fn play(inputs: &Inputs, width: f64, x: &[f64], start: impl Fn(f64) -> f64) -> Vec<f64> {
    let mut out = vec![0.0; x.len()];
    for run in inputs.runs() {
        let mut state = start(x[run.start]);
        for row in run {
            state = state.clamp(x[row] - width, x[row] + width);
            out[row] = state;
        }
    }
    out
}

/// Greatest value so far, carried on from run to run.
pub fn running_maximum(x: &[f64]) -> Vec<f64> {
    let mut greatest = f64::NEG_INFINITY;
    x.iter()
        .map(|&v| {
            greatest = greatest.max(v);
            greatest
        })
        .collect()
}

#[cfg(test)]
mod tests {
    use super::*;

    fn one_run(times: &[f64]) -> Inputs {
        Inputs { time_s: Some(times.to_vec()), run: vec![1; times.len()], ..Inputs::default() }
    }

    #[test]
    fn a_lag_of_a_ramp_is_the_ramp_less_tau_with_a_decaying_start() {
        let times: Vec<f64> = (0..60).map(|i| 0.3 * f64::from(i) + 0.1 * f64::from(i % 3)).collect();
        let (tau, slope) = (2.5, 0.7);
        let mut x: Vec<f64> = times.iter().map(|t| slope * t).collect();
        first_order_lag(&one_run(&times), tau, &mut x, |first| first);
        for (t, y) in times.iter().zip(&x) {
            let exact = slope * (t - tau + tau * (-t / tau).exp());
            approx::assert_abs_diff_eq!(*y, exact, epsilon = 1e-12);
        }
    }

    #[test]
    fn a_play_follows_only_when_it_is_pushed() {
        let inputs = one_run(&[0.0, 1.0, 2.0, 3.0, 4.0]);
        assert_eq!(play(&inputs, 1.0, &[0.0, 0.5, 3.0, 2.5, 0.0], |x| x), vec![0.0, 0.0, 2.0, 2.0, 1.0]);
    }

    #[test]
    fn memory_starts_afresh_with_each_run() {
        let inputs = Inputs { time_s: Some(vec![0.0, 1.0, 2.0, 3.0]), run: vec![1, 1, 2, 2], ..Inputs::default() };
        let mut x = vec![0.0, 1.0, 5.0, 5.0];
        first_order_lag(&inputs, 10.0, &mut x, |first| first);
        assert_eq!(&x[2..], &[5.0, 5.0]);
    }
}
