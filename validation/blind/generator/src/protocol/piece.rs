//! Pieces of a protocol: rest, staircase, triangles, thermal sweep, wandering.
//!
//! Limits: one piece is one run; times start at zero.

use crate::draws::Draws;
use crate::history::History;

/// Fills a run of `rows` samples `dt` apart from load and temperature by row.
pub(super) fn run(rows: usize, dt: f64, force: impl Fn(usize) -> f64, temperature: impl Fn(usize) -> f64) -> History {
    History {
        run: vec![1; rows],
        time: (0..rows).map(|row| row as f64 * dt).collect(),
        force: (0..rows).map(force).collect(),
        temperature: (0..rows).map(temperature).collect(),
        humidity: Vec::new(),
    }
}

/// Nothing is done.
pub fn rest(rows: usize, dt: f64, temperature: f64) -> History {
    run(rows, dt, |_| 0.0, |_| temperature)
}

/// Loads `levels` (N), each held for `hold` rows.
pub fn staircase(levels: &[f64], hold: usize, dt: f64, temperature: f64) -> History {
    run(levels.len() * hold, dt, |row| levels[row / hold], |_| temperature)
}

/// Triangles from zero to each of `peaks` (N) and back, `period` rows each.
pub fn triangles(peaks: &[f64], period: usize, dt: f64, temperature: f64) -> History {
    let height = |row: usize| 1.0 - (2.0 * (row % period) as f64 / period as f64 - 1.0).abs();
    run(peaks.len() * period, dt, |row| peaks[row / period] * height(row), |_| temperature)
}

/// Temperature from `low` to `high` and back at constant load: 40 % up, 10 % held, 40 % down, 10 % held.
pub fn sweep(rows: usize, dt: f64, force: f64, low: f64, high: f64) -> History {
    let place = move |row: usize| {
        let x = row as f64 / rows as f64;
        let share = (x / 0.4).min(1.0) - ((x - 0.5) / 0.4).clamp(0.0, 1.0);
        low + (high - low) * share
    };
    run(rows, dt, |_| force, place)
}

/// Load and temperature as smooth random walks within the range of the sensor, reflected at its ends.
pub fn worn(rows: usize, dt: f64, draws: &mut Draws) -> History {
    let (mut force, mut speed, mut temperature) = (0.0, 0.0, draws.between(22.0, 28.0));
    let aim = draws.between(30.0, 36.0);
    let (mut forces, mut temperatures) = (Vec::with_capacity(rows), Vec::with_capacity(rows));
    for _ in 0..rows {
        forces.push(force);
        temperatures.push(temperature);
        speed = 0.95 * speed + 0.02 * draws.normal();
        force = reflected(force + speed, 4.5);
        temperature += 0.002 * (aim - temperature) + 0.01 * draws.normal();
    }
    run(rows, dt, |row| forces[row], |row| temperatures[row])
}

/// `x` folded back into 0..`top`.
fn reflected(x: f64, top: f64) -> f64 {
    let folded = x.abs();
    if folded > top { (2.0 * top - folded).max(0.0) } else { folded }
}

/// The same run looked at on random moments: every row moves by up to 0.4 of a step, some stretches are lost.
pub fn uneven(mut history: History, draws: &mut Draws) -> History {
    let dt = history.time[1] - history.time[0];
    history.time.iter_mut().skip(1).for_each(|t| *t += dt * draws.between(-0.4, 0.4));
    let rows = history.rows();
    let (start, length) = (rows / 4 + draws.index(rows / 2), rows / 12);
    let keep: Vec<usize> = (0..rows).filter(|row| !(start..start + length).contains(row)).collect();
    let pick = |values: &[f64]| keep.iter().map(|&row| values[row]).collect::<Vec<f64>>();
    History {
        run: vec![1; keep.len()],
        time: pick(&history.time),
        force: pick(&history.force),
        temperature: pick(&history.temperature),
        humidity: Vec::new(),
    }
}
