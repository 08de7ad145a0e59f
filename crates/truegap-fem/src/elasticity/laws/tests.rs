//! Energy, stress and tangent of every law against each other by differences, and against closed forms.

use super::*;

fn state() -> Tensor {
    Tensor::new(0.11, -0.07, 0.03, 0.05, -0.13, 0.02, -0.04, 0.06, 0.09)
}

fn direction() -> Tensor {
    Tensor::new(0.3, 0.7, -0.5, -0.2, 0.4, 0.6, 0.9, -0.8, 0.1)
}

/// Central differences of fourth order: error about step^4 against rounding / step.
fn difference(f: impl Fn(f64) -> f64) -> f64 {
    let s = 1e-3;
    (8.0 * (f(s) - f(-s)) - (f(2.0 * s) - f(-2.0 * s))) / (12.0 * s)
}

fn energy_stress_and_tangent_agree<L: Law>() {
    let (h, d) = (state(), direction());
    let law = L::at(&h);
    let along = |t: f64| L::at(&(h + d * t));
    let slope = difference(|t| along(t).shear_energy());
    // 1e-10: truncation s^4 f^(5) / 30 with s = 1e-3 and derivatives of order ten to a hundred.
    assert!((law.shear_stress().dot(&d) - slope).abs() < 1e-10);
    assert!(slope.abs() > 0.01);
    let slope = difference(|t| along(t).volume());
    assert!((law.volume_slope().dot(&d) - slope).abs() < 1e-10);
    assert!(slope.abs() > 0.01);
    for k in 0..9 {
        let stress = difference(|t| along(t).shear_stress()[k]);
        assert!((law.shear_tangent(&d)[k] - stress).abs() < 1e-10, "shear {k}");
        let cofactor = difference(|t| along(t).volume_slope()[k]);
        assert!((law.volume_curvature(&d)[k] - cofactor).abs() < 1e-10, "volume {k}");
    }
}

#[test]
fn stress_is_the_slope_of_energy_and_tangent_the_slope_of_stress() {
    energy_stress_and_tangent_agree::<Linear>();
    energy_stress_and_tangent_agree::<SaintVenantKirchhoff>();
    energy_stress_and_tangent_agree::<NeoHookean>();
}

fn agrees_with_hooke_at_small_strain<L: Law>() {
    let h = state() * 1e-7;
    let (law, hooke) = (L::at(&h), Linear::at(&h));
    // The laws differ by terms of relative order |H| = 1e-8 ... 1e-7.
    assert!((law.shear_stress() - hooke.shear_stress()).norm() < 1e-6 * hooke.shear_stress().norm());
    assert!((law.volume() - hooke.volume()).abs() < 1e-6 * hooke.volume().abs());
    let d = direction();
    assert!((law.shear_tangent(&d) - hooke.shear_tangent(&d)).norm() < 1e-6);
}

#[test]
fn finite_laws_become_hooke_at_small_strain() {
    agrees_with_hooke_at_small_strain::<SaintVenantKirchhoff>();
    agrees_with_hooke_at_small_strain::<NeoHookean>();
}

#[test]
fn finite_laws_do_not_feel_a_rotation() {
    let q = nalgebra::Rotation3::from_euler_angles(0.7, -0.4, 1.1).into_inner();
    let h = q - Tensor::identity();
    for stress in [SaintVenantKirchhoff::at(&h).shear_stress(), NeoHookean::at(&h).shear_stress()] {
        assert!(stress.norm() < 1e-14);
    }
    assert!(Linear::at(&h).shear_stress().norm() > 0.1);
    assert!(NeoHookean::at(&h).volume().abs() < 1e-15);
}

#[test]
fn neo_hookean_uniaxial_shear_stress_is_stretch_minus_its_inverse() {
    let law = NeoHookean::at(&Tensor::from_diagonal(&[1.0, 0.0, -0.2].into()));
    let p = law.shear_stress();
    assert!((p[(0, 0)] - 1.5).abs() < 1e-15 && (p[(2, 2)] + 0.45).abs() < 1e-15);
    assert!((law.volume() - 0.6).abs() < 1e-15);
}

#[test]
fn a_body_turned_inside_out_has_no_energy() {
    assert!(NeoHookean::at(&Tensor::from_diagonal(&[-1.5, 0.0, 0.0].into())).shear_energy().is_nan());
}
