//! Protocols that nobody planned: presses by hand, grasps, days on a shelf, an oven, a shaker, a technician's table.
//!
//! Limits: load between 0 and 4.5 N, temperature between 5 and 60 degC; what is drawn is drawn anew in each recording, nothing is repeated on purpose.

use super::kind::Kind;
use super::piece::run;
use crate::draws::Draws;
use crate::history::History;
use crate::physics::memory::relax;
use std::f64::consts::TAU;

/// Most load, N.
const MOST: f64 = 4.5;

/// The runs of `kind`; none for a kind that is planned.
pub(super) fn plan(kind: Kind, draws: &mut Draws) -> Vec<History> {
    match kind {
        Kind::Hand => (0..3).map(|_| hand(draws)).collect(),
        Kind::Grasps => (0..3).map(|_| grasps(draws)).collect(),
        Kind::Shelf => vec![shelf(draws)],
        Kind::Oven => (0..3).map(|_| oven(draws)).collect(),
        Kind::Shaker => (0..4).map(|_| shaker(draws)).collect(),
        Kind::Table => (0..3).map(|_| table(draws)).collect(),
        _ => Vec::new(),
    }
}

fn of(dt: f64, load: &[f64], temperature: &[f64]) -> History {
    run(load.len(), dt, |row| load[row].clamp(0.0, MOST), |row| temperature[row])
}

/// A room whose temperature wanders, one entry a row: a slow tone and a drift.
fn room(rows: usize, dt: f64, draws: &mut Draws) -> Vec<f64> {
    let (mean, high, period, phase) =
        (draws.between(20.0, 27.0), draws.between(0.3, 1.5), draws.log_between(300.0, 2000.0), draws.between(0.0, TAU));
    let drift = draws.between(-2.0, 4.0) / (rows as f64 * dt);
    (0..rows).map(|row| row as f64 * dt).map(|t| mean + high * (TAU * t / period + phase).sin() + drift * t).collect()
}

/// Presses by hand: every one of another height, speed and length, with a tremor; the hand warms the sensor.
fn hand(draws: &mut Draws) -> History {
    let (rows, dt) = (1500, 0.05);
    let mut load: Vec<f64> = Vec::with_capacity(rows);
    while load.len() < rows {
        load.extend(std::iter::repeat_n(0.0, draws.index(60)));
        let (peak, up, down) = (draws.log_between(0.4, 4.4), 3 + draws.index(30), 3 + draws.index(20));
        let ease = |x: f64| 0.5 - 0.5 * (0.5 * TAU * x).cos();
        load.extend((0..up).map(|k| peak * ease(k as f64 / up as f64)));
        let (hold, pace) = (5 + draws.index(120), draws.between(0.25, 0.6));
        load.extend((0..hold).map(|k| peak * (1.0 + 0.02 * (TAU * pace * k as f64).sin() - 0.0008 * k as f64)));
        let end = load.last().copied().unwrap_or(peak);
        load.extend((0..down).map(|k| end * ease(1.0 - k as f64 / down as f64)));
    }
    load.truncate(rows);
    let warm = draws.between(1.0, 5.0);
    let mut skin = 0.0;
    let air = room(rows, dt, draws);
    let temperature: Vec<f64> = (0..rows)
        .map(|row| {
            let touched = if load[row] > 0.05 { warm } else { 0.0 };
            skin = relax(skin, touched, touched, dt, 15.0);
            air[row] + skin
        })
        .collect();
    of(dt, &load, &temperature)
}

/// Grasps of a gripper: quick, held while the object is carried, corrected when it slips.
fn grasps(draws: &mut Draws) -> History {
    let (rows, dt) = (1400, 0.1);
    let mut load: Vec<f64> = Vec::with_capacity(rows);
    let mut now = 0.0;
    while load.len() < rows {
        let aim = draws.between(0.8, 4.0);
        let (hold, pause, swing) = (30 + draws.index(120), 5 + draws.index(40), draws.between(0.0, 0.15));
        let slip = draws.index(hold);
        for k in 0..hold {
            let asked = aim * (if k > slip { 1.15 } else { 1.0 }) + swing * (TAU * k as f64 * dt / 2.5).sin();
            now += 0.45 * (asked - now);
            load.push(now);
        }
        for _ in 0..pause {
            now *= 0.4;
            load.push(now);
        }
    }
    load.truncate(rows);
    of(dt, &load, &room(rows, dt, draws))
}

/// Three days on a shelf under a weight that is changed three times; day, night and a heating that switches.
fn shelf(draws: &mut Draws) -> History {
    let (rows, dt) = (4320, 60.0);
    let weights: Vec<f64> = (0..4).map(|_| draws.between(0.0, 3.5)).collect();
    let mut changes: Vec<usize> = (0..3).map(|_| draws.index(rows)).collect();
    changes.sort_unstable();
    let load: Vec<f64> = (0..rows).map(|row| weights[changes.iter().filter(|c| **c <= row).count()]).collect();
    let (mean, day, heating) = (draws.between(17.0, 22.0), draws.between(1.5, 4.0), draws.between(0.5, 2.0));
    let (mut warm, mut on) = (0.0, false);
    let temperature: Vec<f64> = (0..rows)
        .map(|row| {
            let outside = mean + day * (TAU * row as f64 / 1440.0).sin();
            on = if on { outside + warm < mean + 0.5 } else { outside + warm < mean - 0.8 };
            warm = relax(warm, if on { 4.0 * heating } else { 0.0 }, if on { 4.0 * heating } else { 0.0 }, dt, 2400.0);
            outside + warm
        })
        .collect();
    of(dt, &load, &temperature)
}

/// An oven that is set to several temperatures, each neared with the oven's own lag; the sensor is loaded now and then.
fn oven(draws: &mut Draws) -> History {
    let (rows, dt) = (1500, 3.0);
    let (mut load, mut temperature) = (Vec::with_capacity(rows), Vec::with_capacity(rows));
    let (mut now, mut force, tau) = (draws.between(21.0, 25.0), 0.0, draws.between(120.0, 400.0));
    let mut aim = now;
    for row in 0..rows {
        if row % 300 == 60 {
            aim = draws.between(18.0, 56.0);
        }
        if draws.chance(0.02) {
            force = if draws.chance(0.3) { 0.0 } else { draws.between(0.3, 4.4) };
        }
        now = relax(now, aim, aim, dt, tau);
        load.push(force);
        temperature.push(now);
    }
    of(dt, &load, &temperature)
}

/// A shaker: a mean load and a sine whose frequency is swept, at the temperature of the day.
fn shaker(draws: &mut Draws) -> History {
    let (rows, dt) = (1200, 0.04);
    let (mean, low, high) = (draws.between(1.6, 2.6), draws.log_between(0.02, 0.1), draws.log_between(0.5, 2.5));
    let swing = draws.between(0.5, 1.0) * mean.min(MOST - mean);
    let (warm, step) = (draws.between(20.0, 34.0), draws.between(0.0, 1.0));
    let mut phase = 0.0;
    let load: Vec<f64> = (0..rows)
        .map(|row| {
            phase += TAU * dt * low * (high / low).powf(row as f64 / rows as f64);
            mean + swing * phase.sin()
        })
        .collect();
    let temperature: Vec<f64> = (0..rows).map(|row| warm + step * row as f64 / rows as f64).collect();
    of(dt, &load, &temperature)
}

/// A technician's table: points in no order, a few rows each, at unequal times; the thermostat is moved between two of them.
fn table(draws: &mut Draws) -> History {
    let mut history = History::default();
    let (mut clock, mut warm) = (0.0, draws.between(18.0, 30.0));
    for _ in 0..60 {
        let (force, rows, step) = (draws.index(10) as f64 * 0.5, 4 + draws.index(8), draws.between(1.0, 3.0));
        if draws.chance(0.15) {
            warm = draws.between(15.0, 50.0);
        }
        for _ in 0..rows {
            history.run.push(1);
            history.time.push(clock);
            history.force.push(force.min(MOST));
            history.temperature.push(warm);
            clock += step;
        }
        clock += draws.between(5.0, 60.0);
    }
    history
}
