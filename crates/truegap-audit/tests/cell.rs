//! The bead cell against values of other programs and closed forms.

#![allow(clippy::unwrap_used)]

use truegap_audit::cell::*;
use truegap_core::VACUUM_PERMITTIVITY;

/// The bead of the optimised sensor in its cell.
fn reference_cell(poisson: f64) -> Cell {
    Cell { bead: 291.5e-6, height: 198e-6, outer: 426.401433e-6, film: 25e-6, poisson }
}

#[test]
fn the_field_of_a_bead_cell_is_that_of_other_programs() {
    let filled = Filled { bead: 3.4, air: 1.0, film: 3.4 };
    let rest = Profile::cylinder(0.0, 0.49);
    let charged = cell_capacitance(&reference_cell(0.49), &rest, filled, 1e-5).unwrap();
    // Three other programs on one mesh agree to ten digits.
    let exact = 5570.7317299e-6 * VACUUM_PERMITTIVITY;
    assert!((charged.capacitance / exact - 1.0).abs() < 1e-5, "{charged:?}");
}

#[test]
fn a_bead_that_nobody_can_see_is_two_layers_in_series() {
    let cell = Cell { outer: 300e-6, bead: 250e-6, ..reference_cell(0.49) };
    let filled = Filled { bead: 2.0, air: 2.0, film: 5.0 };
    let charged = cell_capacitance(&cell, &Profile::cylinder(0.0, 0.49), filled, 1e-5).unwrap();
    let exact = VACUUM_PERMITTIVITY * std::f64::consts::PI * cell.outer.powi(2) / (cell.height / 2.0 + cell.film / 5.0);
    assert!((charged.capacitance / exact - 1.0).abs() < 1e-10, "{charged:?}");
}

#[test]
fn a_bonded_bead_is_as_stiff_as_other_programs_say() {
    // Converged apparent moduli of a disc of diameter 583 um and height 198 um, bonded to rigid plates.
    for (poisson, exact) in [(0.49, 1.96621337023), (0.4999, 2.08689811082)] {
        let cell = reference_cell(poisson);
        let pressed = press(&cell, Bonding::Bonded, &[0.05, 0.1, 0.2, 0.3]).unwrap();
        println!(
            "nu {poisson}: stiffness off by {:.2e}, rim {}, {} unknowns",
            pressed.stiffness / exact - 1.0,
            pressed.rim,
            pressed.unknowns
        );
        for step in &pressed.steps {
            let p = &step.profile;
            println!(
                "  {:.2} {:.6} belly {:.4} volume {:.5}, {} points",
                step.strain,
                step.reduced_load,
                p.belly(),
                p.volume(),
                p.points.len()
            );
            // Nearly incompressible: the bead spreads as much as it loses height, less its compression under the mean pressure.
            let mean_pressure = step.reduced_load;
            let bulk = 1.0 / (3.0 * (1.0 - 2.0 * poisson));
            assert!((p.volume() - 1.0).abs() < 1.5 * mean_pressure / bulk + 2e-3, "{}", p.volume());
        }
        // The mesh leaves 4e-4; the strain of 1e-4 at which it is taken adds half as much.
        assert!((pressed.stiffness / exact - 1.0).abs() < 8e-4);
    }
}

#[test]
fn a_smooth_bead_follows_the_closed_form_of_uniaxial_compression() {
    let cell = reference_cell(0.49);
    let pressed = press(&cell, Bonding::Smooth, &[0.1, 0.3]).unwrap();
    let (mu, lambda) = (1.0 / (2.0 * 1.49), 0.49 / (1.49 * 0.02));
    for step in &pressed.steps {
        let axial = 1.0 - step.strain;
        let side = |s: f64| mu * (s - 1.0 / s) + lambda * (s * s * axial - 1.0) * s * axial;
        let (mut low, mut high) = (0.5, 3.0);
        for _ in 0..100 {
            let middle = 0.5 * (low + high);
            if side(middle) > 0.0 { high = middle } else { low = middle }
        }
        let stress = mu * (axial - 1.0 / axial) + lambda * (low * low * axial - 1.0) * low * low;
        assert!((step.reduced_load / -stress - 1.0).abs() < 1e-7, "{} {stress}", step.reduced_load);
        assert!((step.profile.belly() - low).abs() < 1e-7);
        assert!((step.profile.volume() - low * low * axial).abs() < 1e-7);
    }
}

#[test]
fn held_expansion_lies_between_its_closed_forms() {
    let nu: f64 = 0.49;
    let slender = held_expansion(&Cell { bead: 10e-6, ..reference_cell(nu) }).unwrap();
    // Saint-Venant: two ends, each a bead radius long, are held.
    assert!(slender.value > 1.0 && slender.value < 1.1, "{slender:?}");
    let flat = held_expansion(&Cell { bead: 198e-6 * 40.0, ..reference_cell(nu) }).unwrap();
    let limit = (1.0 + nu) / (1.0 - nu);
    // The free side relieves an edge about as wide as sqrt(bulk / shear) heights: 1 / (1 - 2 nu) = 50.
    assert!(flat.value < limit && flat.value > 0.6 * limit, "{flat:?} {limit}");
    let bead = held_expansion(&reference_cell(nu)).unwrap();
    assert!(bead.value > 1.3 && bead.value < 2.2 && bead.error_estimate < 0.02, "{bead:?}");
    // Without lateral contraction a squeezed bead has axial stress only, so by Betti's theorem holding the faces changes no height.
    let cork = held_expansion(&reference_cell(0.0)).unwrap();
    assert!((cork.value - 1.0).abs() < 1e-9, "{cork:?}");
}

#[test]
fn a_held_bead_grows_in_volume_as_its_height_tells() {
    // The bead's own volume under heat with its faces held: finite elements of the side against the closed relation of volume and height.
    let cell = reference_cell(0.49);
    let (heat, held) = (5.5e-3, held_expansion(&cell).unwrap().value);
    let bead = heated_and_loaded(&cell, heat, 0.0, -2.0 * heat).unwrap();
    assert!((-bead.strain / heat / held - 1.0).abs() < 0.01, "{} {held}", bead.strain);
    let volume = bead.profile.volume() - 1.0;
    let squeezed = (1.0 - 2.0 * 0.49) / 0.49 * (held - 1.0);
    // Second order in the heat leaves 3 heat: 1.6 %.
    assert!((volume / ((3.0 - squeezed) * heat) - 1.0).abs() < 0.02, "{volume}");
    assert!((volume / (3.0 * heat) - 1.0).abs() > 1e-4);
}
