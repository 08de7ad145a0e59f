//! Von Mises stress at the corners of triangles, for pictures.
//!
//! From the shapes' own gradients, not recovered ones: first order at corners. Hydrostatic stress does not enter, so pressures are not needed.

use truegap_fem::Symmetry;
use truegap_fem::elasticity::kinematics::displacement_gradient;
use truegap_fem::elasticity::laws::Tensor;
use truegap_fem::elasticity::{LawKind, Solution};
use truegap_fem::space::{P2, Shape};

/// Von Mises equivalent of the Cauchy stress at the corners of a triangle, Pa.
///
/// $$ \sigma_v = \sqrt{\tfrac32\, s : s}, \qquad s = 2\mu\,\mathrm{dev}\,E \;\text{(metals, insulator)}, \quad s = \frac{\mu}{J}\,\mathrm{dev}\,b \;\text{(rubber)} $$
///
/// **Source:** Holzapfel, Nonlinear Solid Mechanics, 6.2, 6.5. Thermal strains are equal in all directions and drop out of both to first order.
pub fn von_mises(solution: &Solution, triangle: usize) -> [f64; 3] {
    let body = solution.body();
    let material = body.problem.materials[body.problem.mesh.triangle_regions[triangle] as usize];
    let mu = material.lame().mu;
    [[0.0, 0.0], [1.0, 0.0], [0.0, 1.0]].map(|reference| {
        let h = gradient(solution, triangle, reference);
        let deviator = |t: Tensor| t - Tensor::identity() * (t.trace() / 3.0);
        let stress = match material.law {
            LawKind::Linear => deviator(h + h.transpose()) * mu,
            LawKind::SaintVenantKirchhoff => deviator(h + h.transpose() + h.tr_mul(&h)) * mu,
            LawKind::NeoHookean => {
                let f = Tensor::identity() + h;
                deviator(f * f.transpose()) * (mu / f.determinant())
            }
        };
        (1.5 * stress.dot(&stress)).sqrt()
    })
}

fn gradient(solution: &Solution, triangle: usize, reference: [f64; 2]) -> Tensor {
    let body = solution.body();
    let map = body.nodes.element(triangle).map_at(reference);
    let (value, slope) = P2::at(reference);
    let shapes: [Shape; 6] = std::array::from_fn(|i| Shape { value: value[i], gradient: map.gradient(slope[i]) });
    let of: Vec<f64> = body.nodes.triangles[triangle].iter().flat_map(|&n| solution.nodal(n as usize)).collect();
    let mut h = displacement_gradient(Symmetry::Axisymmetric, map.at[0], &shapes, &of);
    if map.at[0] <= 1e-12 {
        // On the axis the hoop strain is the radial one.
        h[(2, 2)] = h[(0, 0)];
    }
    h
}
