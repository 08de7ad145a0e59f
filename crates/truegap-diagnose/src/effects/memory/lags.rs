//! First-order lags, one or many of one input, exact for an input that is linear between rows.
//!
//! Limits: an input that is linear between rows.

/// Below this ratio of step to time constant the weights of a lag come from their series.
const SERIES_BELOW: f64 = 0.1;

/// `1 / (k + 2)!`, k from 0: nine terms leave 0.1^9 / 11! = 3e-17.
const SERIES: [f64; 9] =
    [1.0 / 2.0, 1.0 / 6.0, 1.0 / 24.0, 1.0 / 120.0, 1.0 / 720.0, 1.0 / 5040.0, 1.0 / 40320.0, 1.0 / 362_880.0, 1.0 / 3_628_800.0];

/// Steps that differ by less than this share are one step: a clock in tenths of a second has steps that differ in their last digits.
const SAME_STEP: f64 = 1e-9;

/// Most steps whose weights are kept.
const STEPS_KEPT: usize = 8;

/// What lags of one input need for a step, kept for steps that come again: an even clock and means of few rows have a handful, and each spares an exponential a lag.
#[derive(Clone, Debug, Default)]
struct Steps<W> {
    /// a step, and what the lags make of it
    known: Vec<(f64, W)>,
    last: usize,
    oldest: usize,
}

impl<W: Default> Steps<W> {
    /// What the lags make of a step; `learn` computes it for a step that is not known.
    #[inline]
    fn weights(&mut self, step_s: f64, learn: impl FnOnce(&mut W)) -> &W {
        let is_it = |known: &(f64, W)| (known.0 - step_s).abs() <= SAME_STEP * step_s;
        if !self.known.get(self.last).is_some_and(is_it) {
            self.last = self.known.iter().position(is_it).unwrap_or_else(|| {
                let place = self.place();
                let (known, of) = &mut self.known[place];
                *known = step_s;
                learn(of);
                place
            });
        }
        &self.known[self.last].1
    }

    /// Place of a step that is not known, in place of the one that has been known longest.
    fn place(&mut self) -> usize {
        let mut place = self.known.len();
        if place < STEPS_KEPT {
            self.known.push((0.0, W::default()));
        } else {
            place = self.oldest;
            self.oldest = (place + 1) % STEPS_KEPT;
        }
        place
    }
}

/// Weights of the old output, of the input before and of the input now, each a column over the lags, so that lags are stepped two at a time.
#[derive(Clone, Debug, Default)]
struct Weights {
    old: Vec<f64>,
    before: Vec<f64>,
    now: Vec<f64>,
}

impl Weights {
    /// Those of a step. An uneven clock has a step of its own in most rows: what is forgotten leaves its room.
    fn learn(&mut self, step_s: f64, taus_s: &[f64]) {
        [&mut self.old, &mut self.before, &mut self.now].into_iter().for_each(|column| column.resize(taus_s.len(), 0.0));
        let columns = self.old.iter_mut().zip(&mut self.before).zip(&mut self.now);
        for (((old, before), now), tau) in columns.zip(taus_s) {
            [*old, *before, *now] = weights(step_s / tau);
        }
    }
}

/// First-order lag `tau y' + y = x`, exact for `x` linear between rows, on any sequence of steps.
#[derive(Clone, Debug)]
pub struct Lag {
    tau_s: f64,
    steps: Steps<[f64; 3]>,
    /// output at the last row
    pub state: f64,
    before: f64,
}

impl Lag {
    /// A lag with time constant `tau_s` > 0, s.
    pub fn new(tau_s: f64) -> Self {
        Self { tau_s, steps: Steps::default(), state: 0.0, before: 0.0 }
    }

    /// Starts a run with input `x` and output `state`.
    pub fn start(&mut self, x: f64, state: f64) -> f64 {
        self.before = x;
        self.state = state;
        state
    }

    /// Output `step_s` seconds later, where the input is `x`.
    #[inline]
    pub fn next(&mut self, x: f64, step_s: f64) -> f64 {
        let [old, before, now] = *self.steps.weights(step_s, |of| *of = weights(step_s / self.tau_s));
        self.state = old * self.state + before * self.before + now * x;
        self.before = x;
        self.state
    }
}

/// A weighted sum of lags of one input, each as [`Lag`]; a column over the lags a quantity.
#[derive(Clone, Debug)]
pub struct LagSum {
    taus_s: Vec<f64>,
    weights: Vec<f64>,
    /// outputs at the last row
    states: Vec<f64>,
    steps: Steps<Weights>,
    before: f64,
}

impl LagSum {
    /// Lags with these time constants, s, and weights.
    pub fn new(weights: &[(f64, f64)]) -> Self {
        let (taus_s, weights): (Vec<f64>, Vec<f64>) = weights.iter().copied().unzip();
        Self { states: vec![0.0; taus_s.len()], taus_s, weights, steps: Steps::default(), before: 0.0 }
    }

    /// Starts a run with input `x` and every output 0.
    pub fn start(&mut self, x: f64) -> f64 {
        self.before = x;
        self.states.fill(0.0);
        0.0
    }

    /// The sum `step_s` seconds later, where the input is `x`.
    #[inline]
    pub fn next(&mut self, x: f64, step_s: f64) -> f64 {
        let Weights { old, before, now } = self.steps.weights(step_s, |of| of.learn(step_s, &self.taus_s));
        for (((state, old), before), now) in self.states.iter_mut().zip(old).zip(before).zip(now) {
            *state = old * *state + before * self.before + now * x;
        }
        self.before = x;
        self.weights.iter().zip(&self.states).fold(0.0, |sum, (weight, state)| sum + weight * state)
    }
}

/// Weights of the old output, the input before and the input now, for step over time constant `ratio`.
///
/// Short steps take the series of `1 - (1 - exp(-r)) / r`, from which the other weights follow without cancellation: no exponential, and no digit lost.
#[inline]
fn weights(ratio: f64) -> [f64; 3] {
    if ratio <= 0.0 {
        return [1.0, 0.0, 0.0];
    }
    if ratio < SERIES_BELOW {
        let mut sum = 0.0;
        for factor in SERIES.iter().rev() {
            sum = factor - ratio * sum;
        }
        let now = sum * ratio;
        let risen = ratio - ratio * now;
        return [1.0 - risen, risen - now, now];
    }
    let decay = (-ratio).exp();
    let mean = (1.0 - decay) / ratio;
    [decay, mean - decay, 1.0 - mean]
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_sum_of_lags_is_the_sum_of_each_by_itself_on_more_steps_than_are_kept() {
        let elements = [(0.3, 0.5), (4.0, -0.2), (90.0, 1.5)];
        let mut sum = LagSum::new(&elements);
        let mut each = elements.map(|(tau, _)| Lag::new(tau));
        sum.start(0.4);
        each.iter_mut().for_each(|lag| {
            lag.start(0.4, 0.0);
        });
        for row in 0..90u32 {
            let (x, step) = ((1.3 * f64::from(row)).sin(), 0.1 * f64::from(1 + row % 11));
            let found = sum.next(x, step);
            let expected: f64 = each.iter_mut().zip(elements).map(|(lag, (_, weight))| weight * lag.next(x, step)).sum();
            approx::assert_relative_eq!(found, expected, max_relative = 1e-13);
            // and each lag is that of a step nobody has seen
            let fresh = weights(step / 4.0);
            let mut one = Lag { state: 0.7, before: 0.2, ..Lag::new(4.0) };
            approx::assert_relative_eq!(one.next(x, step), fresh[0] * 0.7 + fresh[1] * 0.2 + fresh[2] * x, max_relative = 1e-15);
        }
    }

    #[test]
    fn the_series_of_the_weights_meets_the_closed_form_where_they_change_over() {
        let (below, above) = (weights(SERIES_BELOW.next_down()), weights(SERIES_BELOW));
        for (b, a) in below.iter().zip(above) {
            // rounding of 1 - mean at a ratio of 0.1
            approx::assert_abs_diff_eq!(*b, a, epsilon = 1e-14);
        }
        approx::assert_abs_diff_eq!(below.iter().sum::<f64>(), 1.0, epsilon = 1e-15);
    }
}
