//! Turned solids against the volumes, areas and normals that geometry gives.

#![allow(clippy::unwrap_used)]

use std::collections::HashMap;
use std::f64::consts::{PI, TAU};
use truegap_scene::colour::Rgb;
use truegap_scene::solid::{Layer, Shape, SolidError, Surface, Sweep, revolve};

/// A rectangle r0..r1, z0..z1 in `nr` by `nz` cells, each cut in two (second triangle in the other orientation).
fn rectangle([r0, r1]: [f64; 2], [z0, z1]: [f64; 2], nr: usize, nz: usize) -> Layer {
    let at = |low: f64, high: f64, i: usize, n: usize| low + (high - low) * i as f64 / n as f64;
    let points: Vec<[f64; 2]> = (0..=nz).flat_map(|j| (0..=nr).map(move |i| [at(r0, r1, i, nr), at(z0, z1, j, nz)])).collect();
    let triangles = (0..nz)
        .flat_map(|j| (0..nr).map(move |i| j * (nr + 1) + i))
        .flat_map(|a| [[a, a + 1, a + nr + 1], [a + 1, a + nr + 1, a + nr + 2]])
        .collect();
    Layer { name: "part".into(), colour: Rgb::hex(0xB87333), points, triangles, displacement: vec![], fields: vec![] }
}

/// Half a disc of radius one: turned, a ball.
fn half_disc(n: usize) -> Layer {
    let mut points = vec![[0.0, 0.0]];
    points.extend((0..=n).map(|i| PI * i as f64 / n as f64 - PI / 2.0).map(|a| [a.cos().max(0.0), a.sin()]));
    points[1][0] = 0.0;
    points[n + 1][0] = 0.0;
    let triangles = (1..=n).map(|i| [0, i, i + 1]).collect();
    Layer { name: "ball".into(), colour: Rgb::hex(0), points, triangles, displacement: vec![], fields: vec![] }
}

fn minus(a: [f64; 3], b: [f64; 3]) -> [f64; 3] {
    [a[0] - b[0], a[1] - b[1], a[2] - b[2]]
}

fn cross(a: [f64; 3], b: [f64; 3]) -> [f64; 3] {
    [a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]]
}

fn dot(a: [f64; 3], b: [f64; 3]) -> f64 {
    a[0] * b[0] + a[1] * b[1] + a[2] * b[2]
}

/// Enclosed volume by the divergence theorem.
fn volume(surface: &Surface, shape: &Shape) -> f64 {
    let corner = |i: u32| shape.positions[i as usize];
    surface.triangles.iter().map(|&[a, b, c]| dot(corner(a), cross(corner(b), corner(c))) / 6.0).sum()
}

/// Every edge, with vertices told apart by position only, is run through once each way.
fn is_closed(surface: &Surface, shape: &Shape) -> bool {
    let key = |i: u32| shape.positions[i as usize].map(|x| (x * 1e9).round() as i64);
    let mut edges: HashMap<[[i64; 3]; 2], i64> = HashMap::new();
    for t in &surface.triangles {
        for (a, b) in [(t[0], t[1]), (t[1], t[2]), (t[2], t[0])] {
            let (a, b) = (key(a), key(b));
            *edges.entry([a.min(b), a.max(b)]).or_default() += if a < b { 1 } else { -1 };
        }
    }
    edges.values().all(|n| *n == 0)
}

/// A regular polygon in place of the circle has this share of its area.
fn polygon_share(segments: usize) -> f64 {
    let step = TAU / segments as f64;
    step.sin() / step
}

#[test]
fn a_ring_has_the_volume_that_pappus_gives_full_and_cut() {
    let mut ring = rectangle([2.0, 5.0], [1.0, 2.5], 3, 2);
    ring.displacement = ring.points.iter().map(|p| [0.1 * p[0], 0.2 * p[1]]).collect();
    for (sweep, share) in [(Sweep::FULL, 1.0), (Sweep::CUT_AWAY, 0.75)] {
        let surface = revolve(&ring, &[1.0, 3.0], sweep).expect("a solid");
        let exact = share * PI * (25.0 - 4.0) * 1.5 * polygon_share(sweep.segments);
        // Rounding of a sum over some thousand triangles.
        for (shape, growth) in surface.shapes.iter().zip([1.0, 1.21 * 1.2, 1.69 * 1.6]) {
            assert!((volume(&surface, shape) / (exact * growth) - 1.0).abs() < 1e-12);
            assert!(is_closed(&surface, shape));
        }
    }
}

#[test]
fn a_solid_on_the_axis_is_closed_full_and_cut() {
    for sweep in [Sweep::FULL, Sweep::CUT_AWAY, Sweep { degrees: 30.0, segments: 96 }] {
        let disc = revolve(&rectangle([0.0, 5.0], [0.0, 0.1], 4, 1), &[], sweep).expect("a disc");
        let ball = revolve(&half_disc(40), &[], sweep).expect("a ball");
        for surface in [&disc, &ball] {
            assert!(is_closed(surface, &surface.shapes[0]));
        }
        let exact = sweep.degrees / 360.0 * PI * 25.0 * 0.1 * polygon_share(sweep.segments);
        assert!((volume(&disc, &disc.shapes[0]) / exact - 1.0).abs() < 1e-12);
    }
}

#[test]
fn normals_of_a_ball_point_away_from_its_centre_at_rest_and_grown() {
    let mut ball = half_disc(60);
    ball.displacement = ball.points.iter().map(|p| [0.5 * p[0], 0.5 * p[1]]).collect();
    let surface = revolve(&ball, &[1.0], Sweep::FULL).expect("a ball");
    for (shape, radius) in surface.shapes.iter().zip([1.0, 1.5]) {
        for (p, n) in shape.positions.iter().zip(&shape.normals) {
            // Neighbouring edges have the same length, so their mean normal is the radius; rounding only.
            assert!((dot(*p, *n) / radius - 1.0).abs() < 1e-12, "{p:?} {n:?}");
        }
    }
}

#[test]
fn vertex_normals_lie_on_the_outer_side_of_their_triangles_in_every_state() {
    let mut disc = rectangle([0.0, 5.0], [0.0, 0.5], 8, 2);
    // Bent to a bowl, with a rim that turns outward.
    disc.displacement = disc.points.iter().map(|p| [-0.1 * p[0] * p[1], 0.05 * p[0] * p[0]]).collect();
    for sweep in [Sweep::FULL, Sweep::CUT_AWAY] {
        let surface = revolve(&disc, &[1.0, 2.0], sweep).expect("a bowl");
        for shape in &surface.shapes {
            for t in &surface.triangles {
                let [a, b, c] = t.map(|i| shape.positions[i as usize]);
                let face = cross(minus(b, a), minus(c, a));
                let size = dot(face, face).sqrt();
                for i in t {
                    let n = shape.normals[*i as usize];
                    assert!((dot(n, n) - 1.0).abs() < 1e-12);
                    // Gentle bends are smoothed (up to 40 degrees at rest), creases are not.
                    assert!(dot(face, n) > 0.75 * size);
                }
            }
        }
    }
}

#[test]
fn a_crease_keeps_two_normals_and_a_flat_side_one() {
    let surface = revolve(&rectangle([1.0, 2.0], [0.0, 1.0], 2, 2), &[], Sweep::FULL).expect("a ring");
    let shape = &surface.shapes[0];
    let normals_at = |target: [f64; 2]| {
        let here = |p: &[f64; 3]| (p[0].hypot(p[2]) - target[0]).abs() < 1e-9 && (p[1] - target[1]).abs() < 1e-9;
        shape.positions.iter().filter(|p| here(p)).count() / Sweep::FULL.segments
    };
    assert_eq!((normals_at([2.0, 1.0]), normals_at([2.0, 0.5])), (2, 1));
}

#[test]
fn layers_that_are_no_solids_are_typed_errors() {
    let good = rectangle([1.0, 2.0], [0.0, 1.0], 1, 1);
    let broken = |change: &dyn Fn(&mut Layer)| {
        let mut layer = good.clone();
        change(&mut layer);
        revolve(&layer, &[1.0, 10.0], Sweep::FULL).expect_err("no solid")
    };
    assert!(matches!(broken(&|l| l.triangles.clear()), SolidError::EmptyLayer { .. }));
    assert!(matches!(broken(&|l| l.triangles[0][1] = 9), SolidError::NoSuchPoint { point: 9, .. }));
    assert!(matches!(broken(&|l| l.points[2][1] = f64::NAN), SolidError::NotFinite { what: "position", point: 2, .. }));
    assert!(matches!(broken(&|l| l.fields = vec![vec![1.0, 2.0]]), SolidError::Lengths { what: "field", .. }));
    assert!(matches!(
        broken(&|l| l.fields = vec![vec![], vec![1.0, 2.0, f64::NAN, 0.0]]),
        SolidError::NotFinite { what: "field", .. }
    ));
    assert!(matches!(broken(&|l| l.points[0][0] = -1.0), SolidError::BehindAxis { state: "at rest", .. }));
    let crosses = broken(&|l| l.displacement = vec![[-0.2, 0.0]; 4]);
    assert!(matches!(crosses, SolidError::BehindAxis { state: "deformed", .. }) && crosses.to_string().contains("smaller"));
    assert!(matches!(broken(&|l| l.triangles[0] = [0, 1, 1]), SolidError::FlatTriangle { .. }));
    assert!(matches!(broken(&|l| l.triangles.push([0, 1, 3])), SolidError::Overlap { .. }));
    assert!(matches!(revolve(&good, &[], Sweep { degrees: 400.0, segments: 96 }), Err(SolidError::Sweep { .. })));
}
