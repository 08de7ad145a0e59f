//! Planted errors in the form: a field with every strain component must be in balance for the right form, and for no
//! other.

use super::bodies::*;
use truegap_fem::Symmetry;
use truegap_fem::algebra::{assemble_vector, element_residual};
use truegap_fem::elasticity::kinematics::{R, T, Z, trial_gradient, work};
use truegap_fem::elasticity::laws::{Law, Linear, Tensor};
use truegap_fem::mesh::*;
use truegap_fem::space::*;

/// What can be wrong: the gradient of a trial function, the stress of a gradient, the work on a test function, 2 pi r.
#[derive(Clone, Copy)]
struct Form {
    gradient: fn(f64, Shape, usize) -> Tensor,
    stress: fn(&Tensor) -> Tensor,
    work: fn(f64, &Tensor, Shape) -> [f64; 2],
    weight: fn(f64) -> f64,
}

const MU: f64 = 1.3;
const LAMBDA: f64 = 2.1;

fn hooke(h: &Tensor) -> Tensor {
    let law = Linear::at(h);
    law.shear_stress() * MU + law.volume_slope() * (LAMBDA * law.volume())
}

const RIGHT: Form = Form {
    gradient: |r, s, c| trial_gradient(Symmetry::Axisymmetric, r, s, c),
    stress: hooke,
    work: |r, p, s| work(Symmetry::Axisymmetric, r, p, s),
    weight: |r| std::f64::consts::TAU * r,
};

/// Largest out-of-balance force of u = (r z, r^2) inside a distorted square, over the largest force.
fn imbalance(form: Form) -> f64 {
    let (low, high) = ([0.2, 0.0], [1.2, 1.0]);
    let mut mesh = rectangle(low, high, SizeField::uniform(0.3));
    distort(&mut mesh, low, high);
    let topology = Topology::new(&mesh);
    let nodes = Nodes::new(&mesh, &topology);
    let dofs = ElementDofs::quadratic_vector(&nodes);
    let table = P2::table(&triangle_rule(5));
    let u: Vec<f64> = nodes.points.iter().flat_map(|p| [p[0] * p[1], p[0] * p[0]]).collect();
    let inner = element_residual(&dofs, &u, |e, out| {
        for q in &table {
            let map = nodes.element(e).map(q);
            let (r, w) = (map.at[0], q.weight * map.jacobian * (form.weight)(map.at[0]));
            let shapes = map.shapes(q);
            for (j, trial) in (0..12).map(|j| (j, shapes[j / 2])) {
                let stress = (form.stress)(&(form.gradient)(r, trial, j % 2)) * w;
                for i in 0..6 {
                    let f = (form.work)(r, &stress, shapes[i]);
                    out[12 * j + 2 * i] += f[0];
                    out[12 * j + 2 * i + 1] += f[1];
                }
            }
        }
    });
    // The body force of the exact field, with the right weight: b = (0, -(6 mu + 2 lambda)).
    let outer = assemble_vector(&dofs, |e, out| {
        for q in &table {
            let map = nodes.element(e).map(q);
            let w = q.weight * map.jacobian * std::f64::consts::TAU * map.at[0];
            (0..6).for_each(|i| out[2 * i + 1] -= w * q.value[i] * (6.0 * MU + 2.0 * LAMBDA));
        }
    });
    let rim = mesh.boundary("rim").unwrap();
    let mut fixed = vec![false; nodes.points.len()];
    mesh.edges_of(rim).flat_map(|e| nodes.edge(&topology, e).unwrap()).for_each(|n| fixed[n as usize] = true);
    let size = inner.iter().fold(0.0f64, |m, f| m.max(f.abs()));
    (0..dofs.count).filter(|&i| !fixed[i / 2]).map(|i| (inner[i] - outer[i]).abs()).fold(0.0, f64::max) / size
}

/// The right gradient with one entry changed by a factor.
macro_rules! scaled {
    ($entry:expr, $factor:expr) => {
        |r, s, c| {
            let mut h = (RIGHT.gradient)(r, s, c);
            h[$entry] *= $factor;
            h
        }
    };
}

/// The right stress with one entry changed by a factor.
macro_rules! stressed {
    ($entry:expr, $factor:expr) => {
        |h| {
            let mut s = hooke(h);
            s[$entry] *= $factor;
            s
        }
    };
}

#[test]
fn planted_errors_in_the_form_are_noticed() {
    let right = imbalance(RIGHT);
    assert!(right < 1e-13, "{right}");
    let mutants: [(&str, Form); 16] = [
        ("no hoop strain", Form { gradient: scaled!((T, T), 0.0), ..RIGHT }),
        ("hoop strain with the wrong sign", Form { gradient: scaled!((T, T), -1.0), ..RIGHT }),
        ("hoop strain doubled", Form { gradient: scaled!((T, T), 2.0), ..RIGHT }),
        ("no radial strain", Form { gradient: scaled!((R, R), 0.0), ..RIGHT }),
        ("radial strain off by a percent", Form { gradient: scaled!((R, R), 1.01), ..RIGHT }),
        ("axial strain off by a percent", Form { gradient: scaled!((Z, Z), 1.01), ..RIGHT }),
        ("half of the shear", Form { gradient: scaled!((R, Z), 0.0), ..RIGHT }),
        ("other half of the shear", Form { gradient: scaled!((Z, R), 0.0), ..RIGHT }),
        ("shear stress halved", Form { stress: stressed!((R, Z), 0.5), ..RIGHT }),
        ("radial stress off by a percent", Form { stress: stressed!((R, R), 1.01), ..RIGHT }),
        ("hoop stress off by a percent", Form { stress: stressed!((T, T), 1.01), ..RIGHT }),
        ("axial stress off by a percent", Form { stress: stressed!((Z, Z), 1.01), ..RIGHT }),
        ("shear modulus doubled", Form { stress: |h| hooke(h) + Linear::at(h).shear_stress() * MU, ..RIGHT }),
        ("no volume", Form { stress: |h| Linear::at(h).shear_stress() * MU, ..RIGHT }),
        ("no hoop work", Form { work: |r, p, s| work(Symmetry::Planar, r, p, s), ..RIGHT }),
        ("no 2 pi r", Form { weight: |_| 1.0, ..RIGHT }),
    ];
    for (name, form) in mutants {
        let off = imbalance(form);
        println!("{name}: {off:.1e}");
        assert!(off > 1e-4, "{name} passes: {off:.1e}");
    }
}
