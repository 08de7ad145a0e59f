//! Layers of the deformed stack with the values of every field at their points.
//!
//! Limits: corners of the mesh; air is no layer, so that the beads can be seen.

use super::colour::Colour;
use std::collections::BTreeMap;
use truegap_audit::disc::{Coupled, von_mises};
use truegap_core::Sensor;
use truegap_scene::colour::{ColourMap, Rgb};
use truegap_scene::glb::Field;
use truegap_scene::solid::Layer;

/// Values at the points of a region, by point of the section.
type Values = BTreeMap<u32, f64>;

/// Name, unit and colours of a field.
pub(super) fn legend(colour: Colour) -> Field {
    let (name, unit) = match colour {
        Colour::Temperature => ("temperature", "°C"),
        Colour::Displacement => ("displacement", "µm"),
        Colour::VonMises => ("von Mises stress", "MPa"),
        Colour::Potential => ("potential", "V"),
        Colour::Field => ("field strength", "kV/m"),
    };
    Field { name: name.into(), unit: unit.into(), map: ColourMap::Sequential, range: None }
}

/// The layers from the shield upwards, each with the fields in `order`.
pub(super) fn layers(coupled: &Coupled, sensor: &Sensor, order: &[Colour]) -> Vec<Layer> {
    let parts = [
        ("facing", "insulator on the shield", sensor.insulator.material.name.as_str()),
        ("ring", "beads", sensor.dielectric.layer.material.name.as_str()),
        ("plating", "plating", sensor.plating.as_ref().map_or("", |l| l.material.name.as_str())),
        ("conductor", "conductor", sensor.conductor.material.name.as_str()),
        ("backing", "insulator behind the electrode", sensor.insulator.material.name.as_str()),
    ];
    parts.iter().filter_map(|(region, says, material)| layer(coupled, sensor, (region, says, material), order)).collect()
}

fn layer(coupled: &Coupled, sensor: &Sensor, (region, says, material): (&str, &str, &str), order: &[Colour]) -> Option<Layer> {
    let solution = &coupled.carried.solution;
    let mesh = &solution.body().problem.mesh;
    let belongs = |name: &str| name == region || name.starts_with(&format!("{region} "));
    let mine: Vec<usize> =
        (0..mesh.triangles.len()).filter(|&t| belongs(&mesh.region_names[mesh.triangle_regions[t] as usize])).collect();
    if mine.is_empty() {
        return None;
    }
    let mut number = BTreeMap::new();
    for &p in mine.iter().flat_map(|&t| &mesh.triangles[t]) {
        let next = number.len();
        number.entry(p).or_insert(next);
    }
    let mut points: Vec<u32> = vec![0; number.len()];
    number.iter().for_each(|(&p, &i)| points[i] = p);
    let listed = |values: Option<Values>| values.map_or(Vec::new(), |v| points.iter().map(|p| v[p]).collect());
    let field = |colour: &Colour| listed(values(coupled, sensor, *colour, region, &mine));
    Some(Layer {
        name: format!("{says} ({material})"),
        colour: swatch(material),
        points: points.iter().map(|&p| mesh.points[p as usize]).collect(),
        triangles: mine.iter().map(|&t| mesh.triangles[t].map(|p| number[&p])).collect(),
        displacement: points.iter().map(|&p| solution.nodal(p as usize)).collect(),
        fields: order.iter().map(field).collect(),
    })
}

fn swatch(material: &str) -> Rgb {
    Rgb::hex(match material {
        "copper" => 0xB87333,
        "tin" => 0xC8CCD0,
        "polyimide" => 0xC58B2A,
        "silicone" => 0x8FB8C9,
        _ => 0x9AA0A6,
    })
}

fn values(coupled: &Coupled, sensor: &Sensor, colour: Colour, region: &str, mine: &[usize]) -> Option<Values> {
    let solution = &coupled.carried.solution;
    let mesh = &solution.body().problem.mesh;
    let metal = region == "plating" || region == "conductor";
    let everywhere =
        |value: &dyn Fn(u32) -> f64| -> Values { mine.iter().flat_map(|&t| mesh.triangles[t]).map(|p| (p, value(p))).collect() };
    Some(match colour {
        Colour::Temperature => everywhere(&|_| sensor.reference_c + coupled.kelvin),
        Colour::Displacement => everywhere(&|p| {
            let [u, w] = solution.nodal(p as usize);
            1e6 * u.hypot(w)
        }),
        Colour::VonMises => averaged(mine.iter().map(|&t| (mesh.triangles[t], von_mises(solution, t).map(|s| 1e-6 * s)))),
        Colour::Potential if metal => everywhere(&|_| 1.0),
        Colour::Field if metal => return None,
        Colour::Potential => averaged(of_field(coupled, mine, |t| {
            coupled.field.nodes.triangles[t][..3].iter().map(|&n| coupled.field.potential[n as usize]).collect()
        })),
        Colour::Field => averaged(of_field(coupled, mine, |t| coupled.field.strength(t).iter().map(|e| 1e-3 * e).collect())),
    })
}

/// Corners in the section and values of the triangles of the field's mesh that belong to the layer.
fn of_field<'a>(
    coupled: &'a Coupled,
    mine: &'a [usize],
    value: impl Fn(usize) -> Vec<f64> + 'a,
) -> impl Iterator<Item = ([u32; 3], [f64; 3])> + 'a {
    let (part, mesh) = (&coupled.field.part, &coupled.deformed);
    let wanted: std::collections::BTreeSet<[u32; 3]> = mine.iter().map(|&t| mesh.triangles[t]).collect();
    (0..part.mesh.triangles.len()).filter_map(move |t| {
        let corners = part.mesh.triangles[t].map(|p| part.origin[p as usize]);
        let v = value(t);
        wanted.contains(&corners).then(|| (corners, [v[0], v[1], v[2]]))
    })
}

/// Mean over the triangles at each point.
fn averaged(triangles: impl Iterator<Item = ([u32; 3], [f64; 3])>) -> Values {
    let mut sums: BTreeMap<u32, (f64, f64)> = BTreeMap::new();
    for (corners, values) in triangles {
        for (p, v) in corners.into_iter().zip(values) {
            let sum = sums.entry(p).or_default();
            *sum = (sum.0 + v, sum.1 + 1.0);
        }
    }
    sums.into_iter().map(|(p, (sum, count))| (p, sum / count)).collect()
}
