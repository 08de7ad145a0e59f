//! The plan of each kind of protocol, as a list of runs.
//!
//! Limits: the unvaried plans of the first three kinds were read off the columns of the open recordings.

use super::kind::Kind;
use super::piece::{rest, staircase, sweep, triangles, uneven, worn};
use super::unplanned;
use crate::draws::Draws;
use crate::history::History;

/// Loads up and down the rated range, N.
const STAIRS: [f64; 9] = [0.0, 1.0, 2.0, 3.0, 4.5, 3.0, 2.0, 1.0, 0.0];

/// The runs of `kind`.
pub fn plan(kind: Kind, vary: bool, draws: &mut Draws) -> Vec<History> {
    let mut tune = Tune { vary, draws };
    match kind {
        Kind::Full => full(&mut tune),
        Kind::Thermal => thermal(&mut tune),
        Kind::Mechanical => mechanical(&mut tune),
        Kind::Short => short(&mut tune),
        Kind::Bench => bench(&mut tune),
        Kind::Uneven => random_moments(&mut tune),
        Kind::Worn => wearing(&mut tune),
        Kind::Hand | Kind::Grasps | Kind::Shelf | Kind::Oven | Kind::Shaker | Kind::Table => unplanned::plan(kind, tune.draws),
    }
}

/// Values that stay as given or are drawn about it.
struct Tune<'a> {
    vary: bool,
    draws: &'a mut Draws,
}

impl Tune<'_> {
    fn about(&mut self, value: f64, spread: f64) -> f64 {
        if self.vary { value + self.draws.between(-spread, spread) } else { value }
    }
    fn rows(&mut self, rows: usize) -> usize {
        self.about(rows as f64, 0.15 * rows as f64).round() as usize
    }
    fn step(&mut self, dt: f64) -> f64 {
        if self.vary { (dt * self.draws.log_between(0.7, 1.5) / 0.005).round() * 0.005 } else { dt }
    }
    fn stairs(&mut self) -> Vec<f64> {
        if !self.vary {
            return STAIRS.to_vec();
        }
        let inner: Vec<f64> = [1.0, 2.0, 3.0].iter().map(|level| self.about(*level, 0.3)).collect();
        let top = 4.5 - if self.draws.chance(0.5) { 0.0 } else { self.draws.between(0.0, 0.5) };
        vec![0.0, inner[0], inner[1], inner[2], top, inner[2], inner[1], inner[0], 0.0]
    }
}

fn full(tune: &mut Tune) -> Vec<History> {
    let (stairs, hold, dt) = (tune.stairs(), tune.rows(80), tune.step(0.5));
    let temperatures = [20.0, 35.0, 50.0].map(|t| tune.about(t, 3.0));
    let (fast, slow) = (tune.step(0.05), tune.step(0.3));
    let room = tune.about(25.0, 2.0);
    let (sweep_rows, sweep_step, half) = (tune.rows(540), tune.step(4.0), tune.about(2.25, 0.6));
    let growing: Vec<f64> = (1..=5).map(|k| 0.9 * f64::from(k)).collect();
    let mut runs = vec![rest(tune.rows(600), dt, tune.about(22.0, 1.0))];
    runs.extend(temperatures.map(|t| staircase(&stairs, hold, dt, t)));
    runs.push(triangles(&[4.5; 4], 40, fast, room));
    runs.push(triangles(&[4.5; 4], 200, fast, room));
    runs.push(triangles(&[4.5; 4], 200, slow, room));
    runs.push(triangles(&growing, 160, fast, room));
    let [cold, _, hot] = temperatures;
    runs.push(sweep(sweep_rows, sweep_step, 0.0, cold, hot));
    runs.push(sweep(sweep_rows, sweep_step, half, cold, hot));
    runs.push(staircase(&stairs, hold, dt, cold));
    runs
}

fn thermal(tune: &mut Tune) -> Vec<History> {
    let (stairs, hold, dt, step) = (tune.stairs(), tune.rows(40), tune.step(0.5), tune.step(4.0));
    let (cold, hot, half) = (tune.about(20.0, 3.0), tune.about(50.0, 4.0), tune.about(2.25, 0.6));
    let rows = tune.rows(600);
    vec![
        rest(tune.rows(600), dt, tune.about(22.0, 1.0)),
        sweep(rows, step, 0.0, cold, hot),
        sweep(2 * rows, step, half, cold, hot),
        sweep(rows, step, 4.5, cold, hot),
        staircase(&stairs, hold, dt, cold),
        staircase(&stairs, hold, dt, hot),
        staircase(&stairs, 2 * hold, dt, cold),
    ]
}

fn mechanical(tune: &mut Tune) -> Vec<History> {
    let (stairs, hold, dt) = (tune.stairs(), tune.rows(80), tune.step(0.5));
    let (fast, slow, room) = (tune.step(0.05), tune.step(0.15), tune.about(22.0, 3.0));
    let growing: Vec<f64> = (1..=6).map(|k| 0.75 * f64::from(k)).collect();
    vec![
        rest(tune.rows(600), dt, room),
        staircase(&stairs, hold + hold / 2, dt, room),
        triangles(&[4.5; 6], 80, fast, room),
        triangles(&[4.5; 4], 200, slow, room),
        triangles(&growing, 120, fast, room),
        staircase(&stairs, hold, dt, room),
    ]
}

fn short(tune: &mut Tune) -> Vec<History> {
    let (stairs, hold, dt, room) = (tune.stairs(), tune.rows(12), tune.step(1.0), tune.about(25.0, 4.0));
    vec![staircase(&stairs, hold, dt, room), triangles(&[4.5, 4.5], 48, tune.step(0.1), room)]
}

fn bench(tune: &mut Tune) -> Vec<History> {
    let (stairs, hold, dt) = (tune.stairs(), tune.rows(60), tune.step(0.5));
    let (cold, hot) = (tune.about(22.0, 2.0), tune.about(42.0, 5.0));
    vec![staircase(&stairs, hold, dt, cold), staircase(&stairs, hold, dt, hot), triangles(&[4.5; 4], 100, tune.step(0.1), cold)]
}

fn random_moments(tune: &mut Tune) -> Vec<History> {
    let (stairs, hold, dt) = (tune.stairs(), tune.rows(40), tune.step(0.5));
    let (cold, hot) = (tune.about(20.0, 2.0), tune.about(48.0, 4.0));
    let runs = vec![
        rest(tune.rows(240), dt, cold),
        staircase(&stairs, hold, dt, cold),
        staircase(&stairs, hold, dt, hot),
        triangles(&[4.5; 4], 160, tune.step(0.1), cold),
        sweep(tune.rows(400), tune.step(5.0), tune.about(2.25, 0.6), cold, hot),
        staircase(&stairs, hold, dt, cold),
    ];
    runs.into_iter().map(|run| uneven(run, tune.draws)).collect()
}

fn wearing(tune: &mut Tune) -> Vec<History> {
    let rows = [tune.rows(1000), tune.rows(1000), tune.rows(600)];
    let dt = tune.step(0.25);
    rows.map(|rows| worn(rows, dt, tune.draws)).into()
}
