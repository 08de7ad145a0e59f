//! Causes against what their equations say in closed form, or must not do.

use truegap_generator::causes::LIBRARY;
use truegap_generator::chain::{Act, simulate};
use truegap_generator::draws::Draws;
use truegap_generator::history::History;
use truegap_generator::mechanism::Mechanism;
use truegap_generator::sensor::Sensor;
use truegap_generator::state::Scene;

fn cause(id: &str) -> Box<dyn Mechanism> {
    LIBRARY.iter().find(|(name, _)| *name == id).expect("known").1(&mut Draws::of(1, id))
}

/// One run from load and temperature against time.
fn run(rows: usize, dt: f64, force: impl Fn(f64) -> f64, temperature: impl Fn(f64) -> f64) -> History {
    let time: Vec<f64> = (0..rows).map(|row| row as f64 * dt).collect();
    History {
        run: vec![1; rows],
        force: time.iter().map(|t| force(*t)).collect(),
        temperature: time.iter().map(|t| temperature(*t)).collect(),
        humidity: vec![50.0; rows],
        time,
    }
}

/// Readings with `id` at `size` (and its drawn shape), and of the base model.
fn readings(history: &History, id: &str, size: f64) -> [Vec<f64>; 2] {
    let sensor = Sensor::singletact_s15();
    let scene = Scene { sensor: &sensor, history };
    let act = Act { mechanism: cause(id), size };
    [vec![act], vec![]].map(|acts| simulate(scene, true, &acts).expect("open plates"))
}

/// Late in a ramp of 0.01 K/s a slab's mean is behind by pi^2/12 of its slowest time; the 12 modes kept leave 1e-5 of it.
#[test]
fn a_slab_in_a_steady_ramp_is_late_by_its_closed_form() {
    let history = run(3000, 1.0, |_| 0.0, |t| 20.0 + 0.01 * t);
    let late = 40.0 * std::f64::consts::PI.powi(2) / 12.0;
    let earlier = run(3000, 1.0, |_| 0.0, |t| 20.0 + 0.01 * (t - late));
    let [lagged, base] = readings(&history, "thermal_lag", 40.0);
    let [_, wanted] = readings(&earlier, "thermal_lag", 40.0);
    let (error, effect) = ((lagged[2999] - wanted[2999]).abs(), (lagged[2999] - base[2999]).abs());
    assert!(error < 1e-4 * effect, "{error} of {effect}");
}

/// In a ramp, a delay and a shifted clock are the same; the reading bends with the load, by 1e-3 of the delay's effect.
#[test]
fn in_a_ramp_a_delay_and_a_late_clock_read_alike() {
    let history = run(400, 0.05, |t| 0.2 * t, |_| 25.0);
    let (time_offset, size) = (cause("time_offset"), 0.02);
    let late = time_offset.numbers(size)["response_late_s"].as_f64().expect("number");
    let [lagged, base] = readings(&history, "readout_lag", size);
    let [shifted, _] = readings(&history, "time_offset", size);
    for row in [100, 399] {
        let (lag, shift) = (lagged[row] - base[row], (shifted[row] - base[row]) * late.signum());
        assert!((lag / shift - 1.0).abs() < 0.01 && lag < 0.0, "row {row}: {lag} against {shift}");
    }
}

#[test]
fn trapped_air_resists_at_first_and_leaves_nothing_once_it_has_leaked() {
    let history = run(4000, 1.0, |t| if t < 1.0 { 0.0 } else { 3.0 }, |_| 25.0);
    let [with_air, base] = readings(&history, "trapped_air_stiffness", 0.1);
    let first = with_air[1] - base[1];
    assert!(first < -1e-3, "{first} pF");
    // Sixty leak times at the longest draw: e^-60 is nothing beside rounding.
    assert!((with_air[3999] - base[3999]).abs() < 1e-9);
}

#[test]
fn friction_does_not_care_how_fast_it_goes_and_creep_does() {
    let triangle = |period: f64| move |t: f64| 4.5 * (1.0 - (2.0 * (t / period).fract() - 1.0).abs());
    let [slow, fast] = [2.0, 0.02].map(|dt| run(400, dt, triangle(200.0 * dt), |_| 25.0));
    let apart = |id: &str, size: f64| {
        let [a, b] = [&slow, &fast].map(|history| readings(history, id, size)[0].clone());
        a.iter().zip(&b).map(|(a, b)| (a - b).abs()).fold(0.0, f64::max)
    };
    assert!(apart("rate_independent_hysteresis", 0.1) < 1e-9);
    assert!(apart("viscoelastic_creep", 0.01) > 1e-3);
}

#[test]
fn damage_shows_on_unloading_and_never_on_first_loading() {
    let history = run(200, 0.5, |t| if t < 50.0 { 0.09 * t } else { 0.09 * (99.5 - t) }, |_| 25.0);
    let [softened, base] = readings(&history, "mullins_softening", 0.1);
    assert!((0..=100).all(|row| (softened[row] - base[row]).abs() < 1e-12));
    assert!(softened[150] - base[150] > 1e-3, "{} pF", softened[150] - base[150]);
}

/// Creep under a step: the compression grows by c t^n; small strain, so the reading grows nearly as the power.
#[test]
fn creep_after_a_step_follows_its_power() {
    let history = run(4000, 0.5, |_| 0.5, |_| 20.0);
    let mechanism = cause("viscoelastic_creep");
    let power = mechanism.numbers(1e-3)["power"].as_f64().expect("number");
    let [crept, base] = readings(&history, "viscoelastic_creep", 1e-3);
    let grown = |row: usize| crept[row] - base[row];
    let found = (grown(3200) / grown(200)).ln() / 16.0_f64.ln();
    // The first microsecond that counts as elastic shifts the power by 2 % at these times, the bend of the reading by as much.
    assert!((found / power - 1.0).abs() < 0.04, "{found} against {power}");
}
