//! Every stage acts at its place, and what bends the plates acts together.

use super::{
    named,
    plug::{Plug, at, respond},
    stack,
};
use approx::assert_relative_eq;
use truegap_core::{Simulator, VACUUM_PERMITTIVITY};
use truegap_model::{Point, SeriesOrder, Stack, StackOptions, cases::default_sensor, states};

#[test]
fn each_stage_acts_at_its_place() {
    let model = stack();
    let base = respond(&model, Plug::default());
    let state = |force_n, temperature_c| {
        states(&default_sensor().unwrap(), StackOptions::default(), &[Point { force_n, temperature_c }]).unwrap()[0]
    };
    let s = state(2.0, 40.0);
    assert_relative_eq!(base, s.c_total_pf, max_relative = 1e-15);
    // load path and thermal path: the state of another point
    assert_relative_eq!(
        respond(&model, Plug { load: 1.0 / 4.5, ..Plug::default() }),
        state(3.0, 40.0).c_total_pf,
        max_relative = 1e-14
    );
    assert_relative_eq!(
        respond(&model, Plug { hotter: -10.0, ..Plug::default() }),
        state(2.0, 30.0).c_total_pf,
        max_relative = 1e-14
    );
    // field and readout add
    assert_relative_eq!(respond(&model, Plug { field_pf: 0.5, ..Plug::default() }) - base, 0.5, max_relative = 1e-12);
    let span = state(4.5, 20.0).c_total_pf - state(0.0, 20.0).c_total_pf;
    assert_relative_eq!(respond(&model, Plug { readout_span: 0.1, ..Plug::default() }) - base, 0.1 * span, max_relative = 1e-11);
    // extra air gap and wedge over the dome of a warm sensor: factors on the bead layer by quadrature, in series with the insulator
    let radius = 7.5e-3 * (1.0 + 16.7e-6 * 20.0);
    // what is added does not grow with the silicone
    let cold = 162e-6;
    let mean = cold * (1.0 + 200e-6 * 20.0) * (1.0 + s.strain);
    let sag = s.curvature_per_m * radius * radius / 2.0 / mean;
    let rest = base - s.c_main_pf;
    let with_beads = |beads: f64| rest + beads * s.c_polyimide_pf / (beads + s.c_polyimide_pf);
    let relative = s.c_rtv_pf * 1e-12 * mean
        / (VACUUM_PERMITTIVITY * std::f64::consts::PI * radius * radius * mean_reciprocal(0.0, sag, 0.0));
    let air = 0.02 * cold * relative / mean;
    let factor = |tilt: f64, extra: f64| mean_reciprocal(tilt, sag, extra) / mean_reciprocal(0.0, sag, 0.0);
    let expected = with_beads(s.c_rtv_pf * factor(0.0, air));
    assert_relative_eq!(respond(&model, Plug { gap: 0.02, ..Plug::default() }), expected, max_relative = 1e-8);
    let expected = with_beads(s.c_rtv_pf * factor(0.5, 0.0));
    assert_relative_eq!(respond(&model, Plug { tilt: 0.5, ..Plug::default() }), expected, max_relative = 1e-8);
    // insulator: series, backing and tail
    let thicker = s.c_polyimide_pf * 1.1;
    let expected = s.c_rtv_pf * thicker / (s.c_rtv_pf + thicker) + 1.1 * (s.c_backing_pf + s.c_tail_pf);
    assert_relative_eq!(respond(&model, Plug { insulator: 0.1, ..Plug::default() }), expected, max_relative = 1e-13);
}

/// Mean of the reciprocal gap over a disc, where the gap is 1, a dome of this sag, a wedge of this tilt and something more: midpoint rules in the square of the
/// radius and in the angle.
fn mean_reciprocal(tilt: f64, sag: f64, more: f64) -> f64 {
    let (rings, angles) = (4000, 64);
    let ring = |ring: i32| {
        let u = (f64::from(ring) + 0.5) / f64::from(rings);
        let gap = |i: i32| {
            let turn = std::f64::consts::TAU * (f64::from(i) + 0.5) / f64::from(angles);
            1.0 + more + sag * (u - 0.5) + tilt * u.sqrt() * turn.cos()
        };
        (0..angles).map(|i| 1.0 / gap(i)).sum::<f64>() / f64::from(angles)
    };
    (0..rings).map(ring).sum::<f64>() / f64::from(rings)
}

/// Stress of stiffened beads is E e (1 + nu e)^2 (1 + a e + b e^2): at the strain e of the plain sensor it takes (1 + a e + b e^2) times the load.
#[test]
fn stiffening_multiplies_the_stress_and_a_modulus_factor_divides_the_strain() {
    let model = stack();
    let s =
        states(&default_sensor().unwrap(), StackOptions::default(), &[Point { force_n: 2.0, temperature_c: 20.0 }]).unwrap()[0];
    let e = -s.strain;
    let plug = Plug { stiffening: [2.0, 5.0], ..Plug::default() };
    let force = 2.0 * (1.0 + 2.0 * e + 5.0 * e * e);
    let stiff = at(&model, force, 20.0, &plug).unwrap();
    let softer = at(&model, 1.0, 20.0, &Plug { modulus: -0.5, ..Plug::default() }).unwrap();
    // beads at the same strain; what is left is the insulator's own compression under another force, below 1e-4 pF
    assert_relative_eq!(stiff, s.c_total_pf, epsilon = 2e-3);
    assert_relative_eq!(softer, s.c_total_pf, epsilon = 2e-3);
    assert!((at(&model, force, 20.0, &Plug::default()).unwrap() - s.c_total_pf).abs() > 0.1);
}

#[test]
fn a_base_without_warp_can_be_given_it_back() {
    let sensor = default_sensor().unwrap();
    let flat = Stack::new(&sensor, StackOptions { warp: false, ..StackOptions::default() });
    let bent = respond(&flat, Plug { warp: Some(1.0), ..Plug::default() });
    assert_relative_eq!(bent, respond(&stack(), Plug::default()), max_relative = 1e-15);
    assert!((bent - respond(&flat, Plug::default())).abs() > 0.01);
    assert_eq!((flat.warps(), stack().warps()), (Some(false), Some(true)));
    let single = Stack::new(&named("single-metal-s15"), StackOptions::default());
    assert_eq!(single.warps(), None);
    assert_eq!(respond(&single, Plug { warp: Some(1.0), ..Plug::default() }), respond(&single, Plug::default()));
}

/// A rim sag given as load sag is the same dome as one given as warp.
#[test]
fn load_sag_and_warp_make_the_same_dome() {
    let sensor = default_sensor().unwrap();
    let flat = Stack::new(&sensor, StackOptions { warp: false, ..StackOptions::default() });
    let k = states(&sensor, StackOptions::default(), &[Point { force_n: 2.0, temperature_c: 40.0 }]).unwrap()[0].curvature_per_m;
    let radius = 7.5e-3 * (1.0 + 16.7e-6 * 20.0);
    let rim = (1.0 - (1.0 - k * k * radius * radius).sqrt()) / k;
    let sag = rim / 162e-6;
    assert!(sag > 0.05);
    // the rim was computed with the printed, cancelling form: 1e-16 / (k r)^2 is 2e-12 of it
    assert_relative_eq!(
        respond(&flat, Plug { sag, ..Plug::default() }),
        respond(&stack(), Plug::default()),
        max_relative = 1e-11
    );
}

/// A wedge with the insulator added point by point: the mean over the disc of 1 / ((1 + t x / r) / C_beads + 1 / C_insulator), by the midpoint rule in the angle.
#[test]
fn a_wedge_in_the_exact_order_is_the_mean_over_the_disc() {
    let sensor = default_sensor().unwrap();
    let exact = Stack::new(&sensor, StackOptions { series: SeriesOrder::SeriesThenIntegrate, ..StackOptions::default() });
    let s = states(&sensor, StackOptions::default(), &[Point { force_n: 2.0, temperature_c: 20.0 }]).unwrap()[0];
    let (tilt, strips) = (0.6, 4000);
    let strip = |i: i32| {
        let angle = std::f64::consts::PI * (f64::from(i) + 0.5) / f64::from(strips);
        2.0 * angle.sin().powi(2) / ((1.0 + tilt * angle.cos()) / s.c_rtv_pf + 1.0 / s.c_polyimide_pf)
    };
    let main = (0..strips).map(strip).sum::<f64>() / f64::from(strips);
    let expected = s.c_total_pf - s.c_main_pf + main;
    assert!(main / s.c_main_pf > 1.05);
    assert_relative_eq!(at(&exact, 2.0, 20.0, &Plug { tilt, ..Plug::default() }).unwrap(), expected, max_relative = 1e-13);
}
