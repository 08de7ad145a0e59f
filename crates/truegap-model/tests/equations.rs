//! Each equation against numbers worked out by hand, the printed forms against the corrected ones, and all of them under a change of base units.
#![allow(clippy::unwrap_used)]

use approx::assert_relative_eq;
use truegap_model::equations::{
    coefficients::*, curvature::*, electrodes::*, integral::BentPlates, load::*, plates::*, thermal::*, warp::*,
};

const EPS0: f64 = 8.854e-12;

#[test]
fn plates_follow_1_and_2() {
    // 8.854e-12 x 3 x 2e-4 / 1e-3
    assert_relative_eq!(plate_capacitance(3.0 * EPS0, 2e-4, 1e-3), 5.3124e-12, max_relative = 1e-14);
    // a tenth of the modulus closes a tenth of the gap
    let squeezed = spring_plate_capacitance(3.0 * EPS0, 2e-4, 1e-3, Compression { pressure: 1e5, young: 1e6 });
    assert_relative_eq!(squeezed, 5.3124e-12 / 0.9, max_relative = 1e-14);
}

#[test]
fn temperature_follows_3_to_7() {
    assert_relative_eq!(expanded_length(162e-6, 200e-6, 30.0), 162.972e-6, max_relative = 1e-14);
    assert_relative_eq!(expanded_area(1e-6, 200e-6, -30.0), 0.988_036e-6, max_relative = 1e-14);
    assert_relative_eq!(total_bead_area(65, 0.4e-6), 26e-6, max_relative = 1e-14);
    assert_relative_eq!(air_area(Areas { electrode: 176e-6, solid: 26e-6 }), 150e-6, max_relative = 1e-14);
    assert_relative_eq!(young_at(1.075e6, -7600.0, 30.0), 847e3, max_relative = 1e-14);
}

fn electrode() -> Bimetal {
    Bimetal { first: Lamina { young: 41.6e9, thickness: 5e-6 }, second: Lamina { young: 117e9, thickness: 34e-6 } }
}

#[test]
fn the_curvature_follows_8_to_10() {
    let mismatch = mismatch_strain(ExpansionPair { first: 22.4e-6, second: 16.7e-6 }, 30.0);
    assert_relative_eq!(mismatch, 1.71e-4, max_relative = 1e-13);
    // equal layers, equal moduli: 1/R = 3 mismatch / (2 h) of the whole thickness h (Timoshenko 1925)
    let layer = Lamina { young: 100e9, thickness: 20e-6 };
    let equal = bimetal_curvature(Bimetal { first: layer, second: layer }, 1e-4);
    assert_relative_eq!(equal, 1.5 * 1e-4 / 40e-6, max_relative = 1e-14);
    // a thin film: 1/R = 6 n m mismatch / h (Stoney), to first order in m
    let film = Bimetal { first: Lamina { young: 50e9, thickness: 1e-10 }, second: Lamina { young: 100e9, thickness: 1e-4 } };
    assert_relative_eq!(bimetal_curvature(film, 1e-3), 6.0 * 0.5 * 1e-6 * 1e-3 / 1e-4, max_relative = 1e-5);
    let [outer, inner] = surface_curvatures(0.5, 0.4);
    assert_relative_eq!(1.0 / outer, 2.2, max_relative = 1e-14);
    assert_relative_eq!(1.0 / inner, 1.8, max_relative = 1e-14);
}

#[test]
fn curvature_is_the_inverse_of_the_printed_radius() {
    for mismatch in [1.71e-4, -3e-5] {
        assert_relative_eq!(
            bimetal_curvature(electrode(), mismatch) * bimetal_radius_as_printed(electrode(), mismatch),
            1.0,
            max_relative = 1e-14
        );
    }
    assert_eq!(bimetal_curvature(electrode(), 0.0), 0.0);
    assert!(bimetal_radius_as_printed(electrode(), 0.0).is_infinite());
}

#[test]
fn layers_under_load_follow_11_and_13_to_15() {
    assert_relative_eq!(spread_area(2e-6, 0.5, 0.2), 2.42e-6, max_relative = 1e-14);
    let layers = Layers {
        beads: loaded_height(200e-6, 0.1),
        insulator: loaded_thickness(25e-6, Compression { pressure: 27e6, young: 2.7e9 }),
    };
    assert_relative_eq!(layers.insulator, 24.75e-6, max_relative = 1e-14);
    assert_relative_eq!(mean_separation(layers), 204.75e-6, max_relative = 1e-14);
}

/// The other route: the load that makes a chosen strain, put back in. Conditioned by e q'(e) / q, between 1 and 3.
#[test]
fn the_strain_solves_its_equation() {
    for poisson in [0.0, 0.3, 0.49] {
        for stiffening in [[0.0, 0.0], [2.0, 0.0], [0.0, 30.0], [-0.5, 4.0]] {
            let law = BeadLaw { poisson, stiffening };
            for i in -20..=95 {
                let strain = f64::from(i) / 100.0;
                let found = compressive_strain(reduced_load(law, strain), law).unwrap();
                assert_relative_eq!(found, strain, max_relative = 4e-15, epsilon = 1e-300);
            }
            for strain in [1e-12, -1e-9, 1e-300] {
                let found = compressive_strain(reduced_load(law, strain), law).unwrap();
                assert_relative_eq!(found, strain, max_relative = 4e-15, epsilon = 0.0);
            }
        }
    }
}

#[test]
fn a_load_that_the_beads_cannot_carry_has_no_strain() {
    let beads = BeadLaw { poisson: 0.49, stiffening: [0.0; 2] };
    // tension is greatest at e = -1 / (3 nu): q = -4 / (27 nu)
    let most = -4.0 / (27.0 * 0.49);
    assert!(compressive_strain(0.99 * most, beads).is_some());
    assert_eq!(compressive_strain(1.01 * most, beads), None);
    // stress e - e^2 has its top, 1/4, at e = 1/2
    let softening = BeadLaw { poisson: 0.0, stiffening: [-1.0, 0.0] };
    assert_relative_eq!(compressive_strain(0.24, softening).unwrap(), 0.4, max_relative = 1e-14);
    assert_eq!(compressive_strain(0.26, softening), None);
    assert_eq!(compressive_strain(f64::NAN, beads), None);
    assert_eq!(compressive_strain(f64::INFINITY, beads), None);
    // beyond closing, the strain is still said
    assert!(compressive_strain(3.0, beads).unwrap() > 1.0);
}

/// (12) as printed: a load opens the gap. The other route is the linearised difference of the two cubics, 2 nu^2 e^2 / (1 + 4 nu e - 3 nu^2 e^2), whose own
/// neglected square is 1 % of it at 0.3; rounded to a digit the numbers are those of the errata.
#[test]
fn the_printed_strain_is_off_by_a_tenth_of_a_per_cent_at_5_and_3_per_cent_at_30() {
    let (nu, law) = (0.49, BeadLaw { poisson: 0.49, stiffening: [0.0; 2] });
    for (strain, per_cent) in [(0.05, "0.1"), (0.13, "0.7"), (0.3, "3")] {
        let load = reduced_load(law, strain);
        let printed = strain_as_printed(load, nu).unwrap();
        assert!(printed > 0.0, "positive means tension");
        assert!(load_cubic_as_printed(printed, load, nu).abs() < 1e-15);
        let off = 100.0 * (printed / strain - 1.0);
        let linear = 200.0 * (nu * strain).powi(2) / (1.0 + 4.0 * nu * strain - 3.0 * (nu * strain).powi(2));
        println!("e = {strain}: the printed root is off by {off:.3} %");
        assert_relative_eq!(off, linear, max_relative = 0.01);
        let digits = per_cent.len().saturating_sub(2);
        assert_eq!(format!("{off:.digits$}"), per_cent);
    }
}

#[test]
fn capacitances_follow_20_to_23() {
    let mixed = mean_permittivity(Fillings { solid: 3.4, surrounding: 1.0 }, Areas { electrode: 200.0, solid: 50.0 });
    assert_relative_eq!(mixed, 1.6, max_relative = 1e-14);
    assert_relative_eq!(series([3e-12, 6e-12]), 2e-12, max_relative = 1e-14);
    // 2 x 3.4 x 8.854e-12 x 40e-3 x 0.1e-3 / 25e-6
    let tail = tail_capacitance(3.4 * EPS0, Trace { length: 40e-3, width: 0.1e-3 }, 25e-6);
    assert_relative_eq!(tail, 9.633_152e-12, max_relative = 1e-14);
    assert_relative_eq!(total_capacitance(Shares { main: 12.0, backing: 212.0, tail: 9.6 }), 233.6, max_relative = 1e-14);
}

#[test]
fn coefficients_follow_24_to_28() {
    let baseline = Pair { cold: 234.0, hot: 234.3 };
    assert_relative_eq!(baseline_drift(baseline, 30.0), 0.01, max_relative = 1e-11);
    assert_relative_eq!(baseline_coefficient(baseline, 30.0, 5.0), 0.2, max_relative = 1e-11);
    let range = Range { unloaded: 234.0, loaded: 237.6 };
    assert_relative_eq!(sensitivity(range, 4.5), 0.8, max_relative = 1e-13);
    assert_relative_eq!(sensitivity_coefficient(Pair { cold: 0.8, hot: 1.04 }, 30.0), 1.0, max_relative = 1e-13);
    // y = x^2 lies 1/4 below its chord at x = 1/2; sign does not matter
    let parabola = (0..=4).map(|i| (f64::from(i) / 4.0, f64::from(i * i) / 16.0));
    assert_relative_eq!(linearity(Range { unloaded: 0.0, loaded: 1.0 }, parabola), 25.0, max_relative = 1e-14);
    assert_relative_eq!(linearity_coefficient(Pair { cold: 1.0, hot: 0.4 }, 30.0), -0.02, max_relative = 1e-13);
}

/// Base units of length, mass, time, temperature and current, each a power of two, so that a homogeneous formula keeps every bit.
struct Units {
    m: f64,
    kg: f64,
    s: f64,
    k: f64,
    a: f64,
}

impl Units {
    fn pressure(&self) -> f64 {
        self.kg / (self.m * self.s * self.s)
    }
    fn force(&self) -> f64 {
        self.kg * self.m / (self.s * self.s)
    }
    fn farad(&self) -> f64 {
        self.a * self.a * self.s.powi(4) / (self.kg * self.m * self.m)
    }
}

/// Every dimensional formula with all arguments in scaled units; returns results scaled back to SI.
fn all_in(u: &Units) -> Vec<f64> {
    let permittivity = 3.4 * EPS0 * u.farad() / u.m;
    let area = u.m * u.m;
    let per_k = 1.0 / u.k;
    let lamina = |young: f64, thickness: f64| Lamina { young: young * u.pressure(), thickness: thickness * u.m };
    let layers = Bimetal { first: lamina(41.6e9, 5e-6), second: lamina(117e9, 34e-6) };
    let dome = Dome { curvature: 1.4 / u.m, radius: 7.5e-3 * u.m };
    let cold = Dome { curvature: -1.4 / u.m, ..dome };
    let plates = BentPlates::settled(162e-6 * u.m, dome);
    let stressed = Compression { pressure: 25e3 * u.pressure(), young: 1e6 * u.pressure() };
    let reduced = 4.5 * u.force() / (25e-6 * area * 1.075e6 * u.pressure());
    let layer = SeriesLayer { thickness: 25e-6 * u.m, permittivity };
    vec![
        plate_capacitance(permittivity, 1e-4 * area, 1e-4 * u.m) / u.farad(),
        spring_plate_capacitance(permittivity, 1e-4 * area, 1e-4 * u.m, stressed) / u.farad(),
        expanded_length(1e-4 * u.m, 200e-6 * per_k, 30.0 * u.k) / u.m,
        expanded_area(1e-6 * area, 200e-6 * per_k, 30.0 * u.k) / area,
        young_at(1e6 * u.pressure(), -7600.0 * u.pressure() / u.k, 30.0 * u.k) / u.pressure(),
        bimetal_curvature(layers, 1.7e-4) * u.m,
        bimetal_radius_as_printed(layers, 1.7e-4) / u.m,
        surface_curvatures(1.4 / u.m, 39e-6 * u.m)[0] * u.m,
        rim_sag(dome) / u.m,
        mean_sag(cold) / u.m,
        local_gap(162e-6 * u.m, dome, 3e-3 * u.m) / u.m,
        Dome::from_rim_sag(RimSag { sag: 3e-5 * u.m, radius: 7.5e-3 * u.m }).curvature * u.m,
        settling_plane(Cap { sphere_radius: 0.7 * u.m, half_angle: 0.01 }) / u.m,
        compressive_strain(reduced, BeadLaw { poisson: 0.49, stiffening: [0.0; 2] }).unwrap(),
        loaded_thickness(25e-6 * u.m, stressed) / u.m,
        plates.integral() / u.m,
        BentPlates::settled(162e-6 * u.m, cold).integral() / u.m,
        series([3e-12 * u.farad(), 6e-12 * u.farad()]) / u.farad(),
        series_then_integrated(permittivity, plates, layer) / u.farad(),
        tail_capacitance(permittivity, Trace { length: 0.04 * u.m, width: 1e-4 * u.m }, 25e-6 * u.m) / u.farad(),
    ]
}

/// A constant of nature or a length hidden in a formula would show: bits change under a change of base units.
#[test]
fn no_formula_depends_on_the_base_units() {
    let si = all_in(&Units { m: 1.0, kg: 1.0, s: 1.0, k: 1.0, a: 1.0 });
    assert!(si.iter().all(|v| v.is_finite() && *v != 0.0));
    let rescaled = [
        Units { m: 1024.0, kg: 1.0, s: 1.0, k: 1.0, a: 1.0 },
        Units { m: 1.0, kg: 4096.0, s: 1.0, k: 1.0, a: 1.0 },
        Units { m: 1.0, kg: 1.0, s: 1.0 / 64.0, k: 1.0, a: 1.0 },
        Units { m: 1.0, kg: 1.0, s: 1.0, k: 32.0, a: 1.0 },
        Units { m: 1.0 / 128.0, kg: 8.0, s: 16.0, k: 0.5, a: 256.0 },
    ];
    for units in rescaled {
        for (i, (there, here)) in all_in(&units).iter().zip(&si).enumerate() {
            assert_eq!(there, here, "formula {i} of the list changes with the base units");
        }
    }
}

/// A line from 3 to 7 with a bump of a tenth in the middle: a fortieth of the span.
#[test]
fn linearity_is_about_the_line_through_the_ends() {
    let range = Range { unloaded: 3.0, loaded: 7.0 };
    let responses = [(0.0, 3.0), (0.25, 4.0), (0.5, 5.1), (1.0, 7.0)];
    assert_relative_eq!(linearity(range, responses), 2.5, max_relative = 1e-12);
}
