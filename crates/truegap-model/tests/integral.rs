//! The closed form of the capacitance integral against two routes that share no code with it.
#![allow(clippy::unwrap_used)]

use approx::assert_relative_eq;
use std::f64::consts::PI;
use truegap_model::cases::bent_plates;
use truegap_model::equations::{
    electrodes::{SeriesLayer, series_then_integrated},
    integral::BentPlates,
    quadrature::{Interval, adaptive, plate_integral_by_quadrature},
    warp::{Cap, Dome, local_gap, mean_sag, rim_sag, sag, settling_cubic_as_printed, settling_cubic_minimum, settling_plane},
};

/// Largest relative error of the closed form over a table made in 50-digit arithmetic by `tests/data/integral_values.py`.
#[test]
fn the_closed_form_is_right_from_flat_to_nearly_touching() {
    let table = include_str!("data/integral_values.csv");
    let mut worst = 0f64;
    for row in table.lines().skip(1) {
        let n: Vec<f64> = row.split(',').map(|field| field.parse().unwrap()).collect();
        let plates = BentPlates { dome: Dome { curvature: n[0], radius: n[1] }, centre_gap: n[2] };
        let error = (plates.integral() / n[3] - 1.0).abs();
        assert!(error <= 1e-13, "{row}: {} is off by {error:.1e}", plates.integral());
        worst = worst.max(error);
    }
    assert_eq!(table.lines().count(), 95);
    println!("closed form: largest relative error {worst:.1e}");
}

/// Tolerance: the quadrature is asked for 1e-12 and its noise is some thousand roundings.
#[test]
fn the_closed_form_agrees_with_the_papers_double_integral() {
    for (name, plates) in bent_plates() {
        let slow = plate_integral_by_quadrature(plates, 1e-12);
        println!("{name}: {:.1e}", plates.integral() / slow - 1.0);
        assert_relative_eq!(plates.integral(), slow, max_relative = 1e-11);
    }
}

#[test]
fn flat_plates_have_the_integral_of_flat_plates() {
    let (radius, gap) = (7.5e-3, 162e-6);
    let plates = BentPlates::settled(gap, Dome { curvature: 0.0, radius });
    assert_relative_eq!(plates.integral(), PI * radius * radius / gap, max_relative = 4e-16);
}

/// Nothing jumps where the series takes over: neighbours on both sides differ by what the slope says, to 1e-15 of the value.
#[test]
fn the_series_and_the_logarithm_meet_without_a_step() {
    let (radius, gap) = (7.5e-3, 162e-6);
    let at = |x: f64| {
        let s = x * gap;
        let curvature = 2.0 * s / (radius * radius + s * s);
        BentPlates { dome: Dome { curvature, radius }, centre_gap: gap }.integral()
    };
    for x in [0.01, -0.01] {
        let h = 1e-9;
        let slope = (at(x + 1e-4) - at(x - 1e-4)) / 2e-4;
        let step = at(x + h) - at(x - h) - 2.0 * h * slope;
        assert!(step.abs() < 4e-15 * at(x), "a step of {:.1e} at x = {x}", step / at(x));
    }
}

#[test]
fn plates_that_touch_are_seen_to_touch() {
    let dome = |curvature| Dome { curvature, radius: 7.5e-3 };
    assert!(BentPlates::settled(162e-6, dome(11.5)).apart());
    assert!(BentPlates::settled(162e-6, dome(-11.45)).apart());
    assert!(!BentPlates::settled(162e-6, dome(11.6)).apart());
    assert!(!BentPlates::settled(162e-6, dome(-11.6)).apart());
}

/// Near the reference temperature the printed order of (18) leaves no digit right; the rewritten form is exact to rounding.
#[test]
fn the_sag_keeps_its_digits_where_the_printed_form_loses_them() {
    // k = 4.8e-5 /m, rho = 5 mm: 50-digit value of R - sqrt(R^2 - rho^2)
    let dome = Dome { curvature: 4.8e-5, radius: 7.5e-3 };
    let exact = 6.000_000_000_000_087e-10;
    let printed = 1.0 / 4.8e-5 - ((1.0f64 / 4.8e-5).powi(2) - 25e-6).sqrt();
    assert_relative_eq!(sag(dome, 5e-3), exact, max_relative = 1e-15);
    assert!((printed / exact - 1.0).abs() > 1e-4, "the printed form is off by {}", printed / exact - 1.0);
}

#[test]
fn the_mean_sag_is_the_mean_of_the_sag() {
    for curvature in [1.4, -11.0, 120.0] {
        let dome = Dome { curvature, radius: 7.5e-3 };
        let ring = |rho: f64| 2.0 * rho * sag(dome, rho) / (dome.radius * dome.radius);
        let mean = adaptive(&ring, Interval { from: 0.0, to: dome.radius }, 1e-13);
        assert_relative_eq!(mean_sag(dome), mean, max_relative = 1e-12);
    }
}

/// (18) with the corrected alpha, as printed, at a curvature where R is small enough to keep its digits.
#[test]
fn the_local_gap_is_the_printed_one_where_that_has_digits_left() {
    let dome = Dome { curvature: 60.0, radius: 7.5e-3 };
    let sphere_radius = 1.0 / dome.curvature;
    let alpha = settling_plane(Cap { sphere_radius, half_angle: (dome.radius / sphere_radius).asin() });
    for rho in [0.0, 2e-3, 5e-3, 7.5e-3] {
        let printed = 162e-6 + alpha - (sphere_radius * sphere_radius - rho * rho).sqrt();
        assert_relative_eq!(local_gap(162e-6, dome, rho), printed, epsilon = 1e-17, max_relative = 1e-10);
    }
}

/// The plane leaves as much volume of the cap above it as is missing below it.
#[test]
fn the_corrected_plane_halves_the_volume() {
    for half_angle in [0.01f64, 0.3, 1.2] {
        let sphere_radius = 2.0;
        let alpha = settling_plane(Cap { sphere_radius, half_angle });
        let rim = sphere_radius * half_angle.sin();
        let above = |rho: f64| 2.0 * PI * rho * ((sphere_radius * sphere_radius - rho * rho).sqrt() - alpha);
        let balance = adaptive(&above, Interval { from: 0.0, to: rim }, 1e-13);
        let volume = PI * rim * rim * rim_sag(Dome { curvature: 1.0 / sphere_radius, radius: rim });
        assert!(balance.abs() < 1e-11 * volume, "{half_angle}: {balance} of {volume}");
    }
}

/// (17) as printed is (4/3)[(1 + c^3)/2 - ((1 + c^2)/2)^(3/2)] at its lowest, and a cubic mean is never below a quadratic one.
#[test]
fn the_printed_cubic_has_no_root_where_the_plane_must_be() {
    for half_angle in [0.02f64, 0.1, 0.5, 1.0, 1.5] {
        let c = half_angle.cos();
        let lowest = settling_cubic_minimum(half_angle);
        assert!(lowest > 0.0, "{half_angle}: {lowest}");
        for i in 0..=1000 {
            let a = c + (1.0 - c) * f64::from(i) / 1000.0;
            assert!(settling_cubic_as_printed(half_angle, a) >= lowest * (1.0 - 1e-6));
        }
        let means = 4.0 / 3.0 * ((1.0 + c.powi(3)) / 2.0 - ((1.0 + c * c) / 2.0).powf(1.5));
        assert_relative_eq!(lowest, means, epsilon = 1e-15, max_relative = 1e-9);
    }
}

#[test]
fn series_before_the_integral_is_the_quadrature_of_both_layers() {
    let (beads, insulator) = (1.34 * 8.854e-12, 3.4 * 8.854e-12);
    for (_, plates) in bent_plates() {
        let layer = SeriesLayer { thickness: 25e-6, permittivity: insulator };
        let ring = |rho: f64| 2.0 * PI * rho / ((plates.centre_gap + sag(plates.dome, rho)) / beads + 25e-6 / insulator);
        let slow = adaptive(&ring, Interval { from: 0.0, to: plates.dome.radius }, 1e-13);
        assert_relative_eq!(series_then_integrated(beads, plates, layer), slow, max_relative = 1e-12);
    }
}

#[test]
fn the_kronrod_rule_is_exact_for_polynomials() {
    for power in [0, 2, 6, 13, 22] {
        let value = adaptive(&|x| x.powi(power), Interval { from: 0.0, to: 2.0 }, f64::INFINITY);
        let exact = 2f64.powi(power + 1) / f64::from(power + 1);
        assert_relative_eq!(value, exact, max_relative = 1e-14);
    }
}
