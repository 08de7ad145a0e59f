//! Exported stacks: every layer with its fields, values at known places, files by their ending.

#![allow(clippy::unwrap_used)]

use std::path::Path;
use truegap::audit::disc::{CoupledOptions, Fineness, Press};
use truegap::core::sensor::builtin_sensor;
use truegap::verify::export::{BeadModel, Colour, Request, Solved, solve};
use truegap_core::Sensor;

fn sensor() -> Sensor {
    builtin_sensor("singletact-s8-optimised").unwrap().unwrap()
}

fn solved(sensor: &Sensor) -> Solved<'_> {
    let options = CoupledOptions { press: Press::RigidPlate, fineness: Fineness { columns: 24, rows: 1 }, target: 1e-3 };
    let command = "truegap export".to_owned();
    let (force_n, temperature_c, beads) = (4.5, 50.0, BeadModel::Free);
    solve(Request { sensor, force_n, temperature_c, colour: Colour::Potential, wedge: true, beads, options, command }).unwrap()
}

#[test]
fn a_stack_has_its_layers_with_their_fields_and_moves_as_it_was_pressed() {
    let sensor = sensor();
    let solved = solved(&sensor);
    let scene = solved.scene();
    let names: Vec<&str> = scene.layers.iter().map(|l| l.name.as_str()).collect();
    assert_eq!(
        names,
        [
            "insulator on the shield (polyimide)",
            "beads (silicone)",
            "plating (tin)",
            "conductor (copper)",
            "insulator behind the electrode (polyimide)"
        ]
    );
    assert_eq!(scene.fields[0].name, "potential");
    assert_eq!(scene.fields.len(), 5);
    for layer in &scene.layers {
        let metal = layer.name.starts_with("plating") || layer.name.starts_with("conductor");
        for (field, values) in scene.fields.iter().zip(&layer.fields) {
            let wanted = if metal && field.name == "field strength" { 0 } else { layer.points.len() };
            assert_eq!(values.len(), wanted, "{} {}", layer.name, field.name);
        }
        assert_eq!(layer.displacement.len(), layer.points.len());
    }
    // The film between shield and gap: 0 V below, on its top the share of the film in series with the gap.
    let film = &scene.layers[0];
    let lowest = film.points.iter().zip(&film.fields[0]).filter(|(p, _)| p[1] == 0.0).map(|(_, v)| v.abs()).fold(0.0, f64::max);
    let highest = film.fields[0].iter().copied().fold(0.0, f64::max);
    assert!(lowest < 1e-12 && highest > 0.02 && highest < 0.3, "{lowest} {highest}");
    // Free beads give way by some 14 % of 198 um and grow by 1.2 um.
    let top = scene.layers[4].displacement.iter().map(|u| -u[1]).fold(0.0, f64::max);
    assert!(top > 15e-6 && top < 40e-6, "{top}");
    let glb = scene.to_glb().unwrap();
    assert_eq!(&glb[..4], b"glTF");
    assert!(glb.len() > 100_000);
}

#[test]
fn the_section_is_a_file_of_vtk_with_the_same_fields() {
    let sensor = sensor();
    let text = solved(&sensor).vtu().unwrap();
    for name in
        ["displacement (m)", "temperature (degC)", "potential (V)", "von Mises stress (Pa)", "field strength (V/m)", "region"]
    {
        assert!(text.contains(&format!("Name=\"{name}\"")), "{name}");
    }
    assert!(text.contains("UnstructuredGrid") && text.contains("Name=\"region: air\""));
    assert!(!text.contains("String"), "meshio reads no text arrays");
}

#[test]
fn an_ending_that_is_no_format_is_refused_before_the_disk_is_touched() {
    let told = truegap::verify::export::Format::of(Path::new("stack.stl")).unwrap_err().to_string();
    assert!(told.contains("stl") && told.contains(".glb") && told.contains(".vtu"), "{told}");
}
