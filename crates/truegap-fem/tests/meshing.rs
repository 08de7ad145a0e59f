//! Meshes of drawings: areas, angles, labels, curved edges, and drawings that must be refused.

#![allow(clippy::unwrap_used)]

use truegap_fem::mesh::*;

fn area(mesh: &Mesh, region: u16) -> f64 {
    (0..mesh.triangles.len())
        .filter(|&t| mesh.triangle_regions[t] == region)
        .map(|t| {
            let [a, b, c] = mesh.corners(t);
            0.5 * plane::twice_area(a, b, c)
        })
        .sum()
}

/// Area enclosed by quadratic edges, by the element Jacobians.
fn curved_area(mesh: &Mesh, region: u16) -> f64 {
    let topology = Topology::new(mesh);
    let nodes = truegap_fem::space::Nodes::new(mesh, &topology);
    let table = truegap_fem::space::P2::table(&truegap_fem::space::triangle_rule(4));
    (0..mesh.triangles.len())
        .filter(|&t| mesh.triangle_regions[t] == region)
        .map(|t| table.iter().map(|q| q.weight * nodes.element(t).map(q).jacobian).sum::<f64>())
        .sum()
}

#[test]
fn a_later_region_cuts_an_earlier_one() {
    let drawing = Geometry::default()
        .region("plate", Outline::rectangle([0.0, 0.0], [4.0, 2.0]))
        .region("hole", Outline::rectangle([3.0, 1.0], [5.0, 3.0]))
        .boundary("cut", &[[0.0, 1.0], [3.0, 1.0]]);
    let mesh = mesh_geometry(&drawing, &MeshOptions::default()).unwrap();
    assert!((area(&mesh, 0) - 7.0).abs() < 1e-12);
    assert!((area(&mesh, 1) - 4.0).abs() < 1e-12);
    assert!(mesh.quality().least_angle_degrees >= 25.0, "{:?}", mesh.quality());
    let length: f64 = mesh.edges_of(0).map(|[a, b]| plane::distance(mesh.points[a as usize], mesh.points[b as usize])).sum();
    assert!((length - 3.0).abs() < 1e-12);
}

#[test]
fn thin_layers_under_rotation_keep_their_angles() {
    // 5 um of tin on 17 um of copper, 7.5 mm long, turned so that no edge is parallel to an axis.
    for turn in [0.0, 0.1, 0.7, 1.3, 2.9] {
        let (s, c) = f64::sin_cos(turn);
        let at = |x: f64, y: f64| [c * x - s * y, s * x + c * y];
        let layer = |y0: f64, y1: f64| Outline::polygon(&[at(0.0, y0), at(7.5e-3, y0), at(7.5e-3, y1), at(0.0, y1)]);
        let drawing = Geometry::default()
            .region("copper", layer(0.0, 17e-6))
            .region("tin", layer(17e-6, 22e-6))
            .region("rubber", layer(22e-6, 0.3e-3));
        let mesh = mesh_geometry(&drawing, &MeshOptions::default()).unwrap();
        assert!((area(&mesh, 1) / (7.5e-3 * 5e-6) - 1.0).abs() < 1e-9);
        assert!(mesh.quality().least_angle_degrees >= 25.0, "turn {turn}: {:?}", mesh.quality());
    }
}

#[test]
fn stacks_at_any_angle_with_any_layers_are_meshed() {
    // A small generator of numbers in [0, 1): what the drawing is does not matter, that it varies does.
    let mut state = 12345u64;
    let mut next = move || {
        state = state.wrapping_mul(6364136223846793005).wrapping_add(1442695040888963407);
        (state >> 33) as f64 / (1u64 << 31) as f64
    };
    for case in 0..120 {
        let (s, c) = f64::sin_cos(6.3 * next());
        let scale = 10f64.powf(-6.0 * next());
        let mut drawing = Geometry::default();
        let (mut y, width) = (0.0, 1.0 + next());
        for layer in 0..1 + (4.0 * next()) as usize {
            let (top, inset) = (y + 10f64.powf(-2.5 * next()), if next() < 0.5 { 0.0 } else { 0.3 * next() });
            let at = |x: f64, y: f64| [scale * (c * x - s * y), scale * (s * x + c * y)];
            let corners = [at(inset, y), at(width - inset, y), at(width - inset, top), at(inset, top)];
            drawing = drawing.region(&format!("{layer}"), Outline::polygon(&corners));
            y = top;
        }
        let max_edge = if next() < 0.5 { f64::INFINITY } else { 0.3 * scale };
        let mesh = mesh_geometry(&drawing, &MeshOptions { size: SizeField::uniform(max_edge), ..Default::default() }).unwrap();
        let q = mesh.quality();
        assert!(q.least_angle_degrees >= 25.0, "case {case}: {q:?}, {} triangles", mesh.triangles.len());
        // The size field asks for circumradii; single edges beside a boundary come out up to twice as long.
        assert!(q.longest_edge <= 2.0 * max_edge, "case {case}: {q:?}, wanted {max_edge}");
    }
}

#[test]
fn the_size_field_is_followed() {
    let size = SizeField { max_edge: 0.2, growth: 0.3, sources: vec![SizeSource { at: [0.5, 0.5], size: 1e-3 }] };
    let drawing = Geometry::default().region("square", Outline::rectangle([0.0, 0.0], [1.0, 1.0]));
    let mesh = mesh_geometry(&drawing, &MeshOptions { size: size.clone(), ..Default::default() }).unwrap();
    assert!(mesh.quality().least_angle_degrees >= 25.0);
    let ratios: Vec<f64> = (0..mesh.triangles.len())
        .map(|t| {
            let c = mesh.corners(t);
            let longest = (0..3).map(|k| plane::distance(c[k], c[(k + 1) % 3])).fold(0.0, f64::max);
            longest / size.at([(c[0][0] + c[1][0] + c[2][0]) / 3.0, (c[0][1] + c[1][1] + c[2][1]) / 3.0])
        })
        .collect();
    let largest = ratios.iter().copied().fold(0.0, f64::max);
    let mean = ratios.iter().sum::<f64>() / ratios.len() as f64;
    assert!(largest < 1.9 && mean > 0.5, "largest {largest}, mean {mean}, {} triangles", ratios.len());
}

#[test]
fn quadratic_edges_follow_arcs() {
    let half = |r: f64| Outline { start: [0.0, -r], steps: vec![Step::Arc { via: [r, 0.0], to: [0.0, r] }] };
    let drawing = Geometry::default().region("outer", half(2.0)).region("inner", half(1.0)).boundary_of("shell", "inner");
    let mesh = mesh_geometry(&drawing, &MeshOptions::default()).unwrap();
    // A parabola through three points of a 10 degree arc encloses less by angle^4 / 480 of the disc's area, in the
    // leading order; chords by angle^2 / 6.
    let half_disc = 0.5 * std::f64::consts::PI;
    let step = 10f64.to_radians();
    assert!((1.0 - area(&mesh, 1) / half_disc) / (step.powi(2) / 6.0) > 0.9);
    for (region, exact) in [(1, half_disc), (0, 3.0 * half_disc)] {
        let ratio = (1.0 - curved_area(&mesh, region) / exact) / (step.powi(4) / 480.0);
        assert!((ratio - 1.0).abs() < 0.01, "{ratio}");
    }
    for [a, b] in mesh.edges_of(0) {
        for p in [a, b].map(|i| mesh.points[i as usize]) {
            assert!((p[0].hypot(p[1]) - 1.0).abs() < 1e-14 || p[0] == 0.0);
        }
    }
}

#[test]
fn a_thin_disc_in_a_box_has_no_flat_triangles() {
    // The drawing that gave another mesher triangles of zero area: two embedded lines, d / a = 1.
    let drawing = Geometry::default()
        .region("air", Outline::rectangle([0.0, -5.0], [5.0, 5.0]))
        .boundary("upper", &[[0.0, 0.5], [1.0, 0.5]])
        .boundary("lower", &[[0.0, -0.5], [1.0, -0.5]]);
    let mesh = mesh_geometry(&drawing, &MeshOptions::default()).unwrap();
    assert!(mesh.quality().least_angle_degrees >= 25.0);
    assert!((area(&mesh, 0) - 50.0).abs() < 1e-10);
    assert!(mesh.edges_of(0).count() > 0 && mesh.edges_of(1).count() > 0);
}

#[test]
fn drawings_without_sense_are_refused_with_their_place() {
    let square = || Outline::rectangle([0.0, 0.0], [1.0, 1.0]);
    let mesh = |g: Geometry| mesh_geometry(&g, &MeshOptions::default()).unwrap_err();
    let bow = Outline::polygon(&[[0.0, 0.0], [1.0, 1.0], [1.0, 0.0], [0.0, 1.0]]);
    assert!(matches!(mesh(Geometry::default().region("bow", bow)), MeshError::CrossingOutline { at, .. } if at == [0.5, 0.5]));
    let line = Outline::polygon(&[[0.0, 0.0], [1.0, 0.0], [2.0, 0.0]]);
    assert!(matches!(mesh(Geometry::default().region("line", line)), MeshError::OpenOutline { .. }));
    assert!(matches!(mesh(Geometry::default()), MeshError::NoRegion));
    let far = Geometry::default().region("a", square()).boundary("far", &[[2.0, 0.0], [2.0, 1.0]]);
    assert!(matches!(mesh(far), MeshError::BoundaryOnNothing { .. }));
    let out = Geometry::default().region("a", square()).boundary("out", &[[0.5, 0.5], [1.5, 0.5]]);
    assert!(matches!(mesh(out), MeshError::BoundaryOnNothing { .. }));
    let gone = Geometry::default().region("a", square()).region("b", Outline::rectangle([-1.0, -1.0], [2.0, 2.0]));
    assert!(matches!(mesh(gone), MeshError::RegionVanished { region } if region == "a"));
    let nan = Outline::polygon(&[[0.0, 0.0], [1.0, f64::NAN], [1.0, 1.0]]);
    assert!(matches!(mesh(Geometry::default().region("n", nan)), MeshError::NotFinite { .. }));
    let unknown = Geometry::default().region("a", square()).boundary_of("b", "c");
    assert!(matches!(mesh(unknown), MeshError::UnknownRegion { .. }));
}

/// Spheres on the axis in a cylinder, drawn by an arc from pole to pole: no rounding of the arc reaches beyond the axis, whatever height and radius.
#[test]
fn spheres_on_the_axis_do_not_reach_beyond_it() {
    let mut beyond = Vec::new();
    for k in 0..40 {
        let (height, radius) = (0.7 + 0.05 * f64::from(k % 8), 0.2 + 0.1 * f64::from(k / 8));
        let sphere = Outline {
            start: [0.0, height],
            steps: vec![Step::Arc { via: [radius, height + radius], to: [0.0, height + 2.0 * radius] }],
        };
        let drawing = Geometry::default()
            .region("outside", Outline::rectangle([0.0, 0.0], [3.0, 3.0]))
            .region("sphere", sphere)
            .boundary_of("surface", "sphere");
        let mesh = mesh_geometry(&drawing, &MeshOptions { arc_step_degrees: 10.0, ..MeshOptions::default() }).unwrap();
        let least = mesh.points.iter().map(|p| p[0]).fold(f64::INFINITY, f64::min);
        if least < 0.0 {
            beyond.push((height, radius, least));
        }
    }
    assert!(beyond.is_empty(), "{beyond:?}");
}
