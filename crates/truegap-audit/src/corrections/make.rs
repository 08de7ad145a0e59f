//! How the tables are computed, and how their accuracy is measured: finite elements at the nodes, and again at points between them.
//!
//! Limits: minutes of work; the results are committed, so only a change of a method needs it.

use super::{
    range::{GREATEST_STRAIN, HEAT, PERMITTIVITIES, POISSON, halton},
    table::{Axis, Table},
};
use crate::{
    assumptions::cell::{Section, edge_factor, mixed_capacitance},
    cell::{Bonding, Cell, Law, Layered, Profile, cell_capacitance, heated_and_squeezed, held_expansion, press},
    error::AuditError,
};
use rayon::prelude::*;
use truegap_core::VACUUM_PERMITTIVITY;

/// Computes a table.
pub type Maker = fn() -> Result<Table, AuditError>;

/// Every table by the name of its file.
pub const MAKERS: [(&str, Maker); 6] = [
    ("tail_edge", tail_edge),
    ("held_expansion", heat),
    ("heated_field", heated_field),
    ("cell_field", cell_field),
    ("rim_field", rim_field),
    ("bead_load", bead_load),
];

/// Shape factors: beads of 300 to 760 um, 150 to 210 um high.
fn shape_factors(count: usize) -> Axis {
    Axis::linear("shape factor S, bead diameter / (4 height)", 0.34, 1.3, count)
}

fn compressibility(count: usize) -> Axis {
    Axis::logarithmic("1 - 2 nu of the bead", 2e-3, 0.1, count)
}

fn strains(count: usize) -> Axis {
    Axis::linear("compressive strain", 0.0, GREATEST_STRAIN, count)
}

fn bead(shape_factor: f64, compressibility: f64) -> Cell {
    Cell { bead: 2.0 * shape_factor, height: 1.0, outer: 4.0, film: 0.1, poisson: 0.5 * (1.0 - compressibility) }
}

/// Points between the nodes: the Halton sequence, the same every time.
pub(super) fn between(axes: &[Axis], count: usize) -> Vec<Vec<f64>> {
    let point =
        |i: usize| axes.iter().zip([2, 3, 5, 7, 11]).map(|(axis, base)| axis.expanded(2.0 * halton(i + 1, base) - 1.0)).collect();
    (0..count).map(point).collect()
}

/// A table through the values of `compute` at all nodes, its accuracy measured at `checks` points between them.
fn tabulated(
    id: &str,
    says: &str,
    axes: Vec<Axis>,
    checks: usize,
    compute: impl Fn(&[f64]) -> Result<f64, AuditError> + Sync,
) -> Result<Table, AuditError> {
    let values = Table::nodes(&axes).par_iter().map(|p| compute(p)).collect::<Result<Vec<_>, _>>()?;
    let mut table = Table::interpolating(id, says, axes, values);
    let off = |p: &Vec<f64>| Ok::<f64, AuditError>((table.at(p)? / compute(p)? - 1.0).abs());
    let errors = between(&table.axes, checks).par_iter().map(off).collect::<Result<Vec<_>, _>>()?;
    table.accuracy = errors.iter().copied().fold(0.0, f64::max);
    table.checked_at = checks;
    Ok(table)
}

/// Secant stiffness of a bonded bead.
///
/// # Errors
/// [`AuditError::Fem`].
fn bead_load() -> Result<Table, AuditError> {
    let axes = vec![shape_factors(7), compressibility(6), strains(6)];
    let says = "secant stiffness k of a bonded neo-Hookean bead: F = E A e k, with A the face and e the compressive strain";
    // one squeeze gives all strains
    let laws = |points: &[(f64, f64)]| -> Result<Vec<Law>, AuditError> {
        points.par_iter().map(|&(s, c)| Law::unjudged(&bead(s, c), Bonding::Bonded, GREATEST_STRAIN)).collect()
    };
    let pairs: Vec<(f64, f64)> = Table::nodes(&axes[..2]).iter().map(|p| (p[0], p[1])).collect();
    let secant = |law: &Law, e: f64| Ok::<f64, AuditError>(law.reduced_load(e)? / e);
    let mut values = Vec::new();
    for law in laws(&pairs)? {
        for e in axes[2].nodes() {
            values.push(secant(&law, e)?);
        }
    }
    let mut table = Table::interpolating("bead_load", says, axes, values);
    let others: Vec<(f64, f64)> = between(&table.axes[..2], 8).iter().map(|p| (p[0], p[1])).collect();
    table.accuracy = 0.0;
    for (law, &(s, c)) in laws(&others)?.iter().zip(&others) {
        for i in 1..=6 {
            let e = GREATEST_STRAIN * f64::from(i) / 6.0;
            table.accuracy = table.accuracy.max((table.at(&[s, c, e])? / secant(law, e)? - 1.0).abs());
            table.checked_at += 1;
        }
    }
    Ok(table)
}

/// Growth of the height of a bonded bead.
///
/// # Errors
/// [`AuditError::Fem`].
fn heat() -> Result<Table, AuditError> {
    let says = "held expansion m of a bonded bead's height: alpha_height = alpha_plate + m (alpha_bead - alpha_plate)";
    tabulated("held_expansion", says, vec![shape_factors(8), compressibility(5)], 16, |p| {
        Ok(held_expansion(&bead(p[0], p[1]))?.value)
    })
}

/// Field of the cell of a bonded bead over the mixture.
///
/// # Errors
/// [`AuditError::Fem`].
fn cell_field() -> Result<Table, AuditError> {
    let axes = vec![
        shape_factors(6),
        Axis::linear("coverage, bead area / electrode area", 0.03, 0.5, 5),
        Axis::logarithmic("insulator / bead height", 0.045, 0.5, 6),
        strains(6),
    ];
    let says = "capacitance of the cell of a squeezed bonded bead over that by (11), (20) and (21) at the same strain; nu = 0.49, permittivities 3.4, 1 and 3.4";
    let shapes =
        |factors: &[f64], strains: &[f64]| factors.par_iter().map(|&s| profiles(s, strains)).collect::<Result<Vec<_>, _>>();
    let (factors, squeezes) = (axes[0].nodes(), axes[3].nodes());
    let at_nodes = shapes(&factors, &squeezes)?;
    let value = |shapes: &[Vec<Profile>], factors: &[f64], squeezes: &[f64], p: &[f64]| {
        let index = |list: &[f64], x: f64| list.iter().position(|y| *y == x).unwrap_or(0);
        field_factor(p, &shapes[index(factors, p[0])][index(squeezes, p[3])])
    };
    let nodes = Table::nodes(&axes);
    let values = nodes.par_iter().map(|p| value(&at_nodes, &factors, &squeezes, p)).collect::<Result<Vec<_>, _>>()?;
    let mut table = Table::interpolating("cell_field", says, axes, values);
    let checks = between(&table.axes, 24);
    let off = |p: &Vec<f64>| {
        let shape = profiles(p[0], &[p[3]])?;
        Ok::<f64, AuditError>((table.at(p)? / field_factor(p, &shape[0])? - 1.0).abs())
    };
    table.accuracy = checks.par_iter().map(off).collect::<Result<Vec<_>, _>>()?.into_iter().fold(0.0, f64::max);
    table.checked_at = checks.len();
    Ok(table)
}

/// Sides of a bonded bead at each of `strains`, in their order.
fn profiles(shape_factor: f64, strains: &[f64]) -> Result<Vec<Profile>, AuditError> {
    let mut rising: Vec<(usize, f64)> = strains.iter().copied().enumerate().collect();
    rising.sort_by(|a, b| a.1.total_cmp(&b.1));
    let sorted: Vec<f64> = rising.iter().map(|r| r.1).collect();
    let pressed = press(&bead(shape_factor, 1.0 - 2.0 * POISSON), Bonding::Bonded, &sorted)?;
    let mut back: Vec<(usize, Profile)> = rising.iter().zip(pressed.steps).map(|(r, step)| (r.0, step.profile)).collect();
    back.sort_by_key(|b| b.0);
    Ok(back.into_iter().map(|b| b.1).collect())
}

/// Field over mixture at (shape factor, coverage, film / height, strain).
fn field_factor(p: &[f64], profile: &Profile) -> Result<f64, AuditError> {
    let radius = 2.0 * p[0];
    let cell = Cell { bead: radius, height: 1.0, outer: radius / p[1].sqrt(), film: p[2], poisson: POISSON };
    let field = cell_capacitance(&cell, profile, PERMITTIVITIES, 1e-5)?;
    Ok(field.capacitance / mixed_capacitance(&cell, p[3], PERMITTIVITIES))
}

/// What heat does to the field of a bonded bead beyond its height and its mean area.
///
/// # Errors
/// [`AuditError::Fem`].
fn heated_field() -> Result<Table, AuditError> {
    let axes = vec![
        shape_factors(3),
        Axis::linear("coverage, bead area / electrode area", 0.03, 0.5, 3),
        Axis::logarithmic("insulator / bead height", 0.045, 0.5, 3),
        strains(3),
    ];
    let says = "factor on `cell_field` for a heated bead whose height and mean area are put into it, as 1 + (the table - 1) t / 0.0055, with t the thermal \
                strain of the bead over that of the plates";
    tabulated("heated_field", says, axes, 12, |p| {
        let cold = Cell { outer: 2.0 * p[0] / p[1].sqrt(), film: p[2], poisson: POISSON, ..bead(p[0], 1.0 - 2.0 * POISSON) };
        let height = held_expansion(&cold)?.value;
        let volume = 3.0 - (1.0 - 2.0 * POISSON) / POISSON * (height - 1.0);
        let (taller, wider) = (1.0 + height * HEAT, 1.0 + (volume - height) * HEAT);
        let hot = heated_and_squeezed(&cold, HEAT, 1.0 - taller * (1.0 - p[3]))?;
        let exact = cell_capacitance(&cold, &hot.profile, PERMITTIVITIES, 1e-5)?.capacitance;
        // the same height and mean area as a cold bead
        let same = Cell { bead: cold.bead * wider.sqrt(), height: taller, ..cold };
        let alike = [0.5 * same.bead / taller, p[1] * wider, p[2] / taller, p[3]];
        let squeezed = profiles(alike[0], &[p[3]])?;
        Ok(exact / (mixed_capacitance(&same, p[3], PERMITTIVITIES) * field_factor(&alike, &squeezed[0])?))
    })
}

/// Capacitance of the rim.
///
/// # Errors
/// [`AuditError::Fem`].
fn rim_field() -> Result<Table, AuditError> {
    let axes = vec![
        Axis::logarithmic("insulator / radius", 1.3e-3, 2.5e-2, 7),
        Axis::logarithmic("electrode / radius", 1.3e-3, 1.5e-2, 4),
        Axis::linear("mean relative permittivity of beads and air", 1.0, 2.4, 4),
        Axis::logarithmic("bead gap / radius", 1.2e-2, 7.1e-2, 5),
    ];
    let says = "capacitance at the rim of a shielded sensor over eps0 x radius; shields of the electrode's radius, insulators of relative permittivity 3.4";
    tabulated("rim_field", says, axes, 32, |p| {
        let layered = Layered {
            radius: 1.0,
            backing: Some(p[0]),
            electrode: p[1],
            film: p[0],
            beads: p[3],
            film_permittivity: VACUUM_PERMITTIVITY * PERMITTIVITIES.film,
            bead_permittivity: VACUUM_PERMITTIVITY * p[2],
        };
        Ok(layered.rim(2e-6)?.value / VACUUM_PERMITTIVITY)
    })
}

/// Edge field of the tail.
///
/// # Errors
/// [`AuditError::Fem`].
fn tail_edge() -> Result<Table, AuditError> {
    let axes = vec![
        Axis::logarithmic("trace width / insulator thickness", 1.2, 12.0, 8),
        Axis::logarithmic("trace thickness / insulator thickness", 0.12, 4.0, 8),
    ];
    let says = "capacitance of the tail over (22)";
    tabulated("tail_edge", says, axes, 24, |p| {
        Ok(edge_factor(Section { width: p[0], distance: 1.0, thickness: p[1] }, 2e-6)?.value)
    })
}
