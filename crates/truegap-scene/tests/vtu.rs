//! VTU files read back by a reader written from the format's description, not from the writer.

#![allow(clippy::unwrap_used)]

use base64::Engine;
use truegap_scene::vtu::{Cells, Data, Grid, VtuError};

/// Payload of the data array called `name`, without its length block.
fn payload(vtu: &str, name: &str) -> Vec<u8> {
    let start = vtu.find(&format!("Name=\"{name}\"")).expect("the array is there");
    let text = &vtu[start + vtu[start..].find('>').expect("tag ends") + 1..];
    let text = &text[..text.find('<').expect("text ends")];
    let bytes = base64::engine::general_purpose::STANDARD.decode(text.trim()).expect("base64");
    let length = u64::from_le_bytes(bytes[..8].try_into().expect("eight bytes"));
    assert_eq!(length as usize, bytes.len() - 8);
    bytes[8..].to_vec()
}

fn floats(vtu: &str, name: &str) -> Vec<f64> {
    payload(vtu, name).chunks(8).map(|b| f64::from_le_bytes(b.try_into().expect("eight bytes"))).collect()
}

fn integers(vtu: &str, name: &str) -> Vec<i64> {
    payload(vtu, name).chunks(8).map(|b| i64::from_le_bytes(b.try_into().expect("eight bytes"))).collect()
}

fn square() -> Grid {
    let points = vec![[0.0, 0.0], [1.0 / 3.0, 0.0], [1.0 / 3.0, 1e-300], [0.0, 0.7]];
    Grid::new(points, Cells::Triangles(vec![[0, 1, 2], [0, 2, 3]]))
}

#[test]
fn every_number_comes_back_to_the_last_bit() {
    let vtu = square()
        .on_points("temperature (K)", Data::Scalar(vec![0.1, -0.0, f64::MIN_POSITIVE, 1e300]))
        .on_points("displacement [m]", Data::Vector(vec![[1.0, 2.0], [3.0, 4.0], [5.0, 6.0], [7.0, 8.0]]))
        .on_cells("stress [Pa]", Data::Tensor(vec![[1.0, 2.0, 3.0, 4.0], [5.0, 6.0, 7.0, 8.0]]))
        .on_cells("region", Data::Label(vec![7, -1]))
        .to_vtu()
        .expect("a grid");
    assert_eq!(floats(&vtu, "Points"), [0.0, 0.0, 0.0, 1.0 / 3.0, 0.0, 0.0, 1.0 / 3.0, 1e-300, 0.0, 0.0, 0.7, 0.0]);
    let temperature = floats(&vtu, "temperature (K)");
    assert_eq!(temperature, [0.1, 0.0, f64::MIN_POSITIVE, 1e300]);
    assert!(temperature[1].is_sign_negative());
    assert_eq!(floats(&vtu, "displacement [m]")[3..6], [3.0, 4.0, 0.0]);
    assert_eq!(floats(&vtu, "stress [Pa]")[6..], [5.0, 6.0, 7.0, 8.0, 0.0, 0.0]);
    assert_eq!(payload(&vtu, "region"), [7, 0, 0, 0, 255, 255, 255, 255]);
    assert_eq!(integers(&vtu, "connectivity"), [0, 1, 2, 0, 2, 3]);
    assert_eq!((integers(&vtu, "offsets"), payload(&vtu, "types")), (vec![3, 6], vec![5, 5]));
}

#[test]
fn quadratic_triangles_have_six_points_and_their_own_type() {
    let points = vec![[0.0, 0.0], [2.0, 0.0], [0.0, 2.0], [1.0, 0.0], [1.0, 1.0], [0.0, 1.0]];
    let vtu = Grid::new(points, Cells::QuadraticTriangles(vec![[0, 1, 2, 3, 4, 5]])).to_vtu().expect("a grid");
    assert_eq!((integers(&vtu, "offsets"), payload(&vtu, "types")), (vec![6], vec![22]));
}

#[test]
fn notes_keep_their_text_even_where_it_looks_like_markup() {
    let vtu = square().note("command", "solve --case <a> ü").to_vtu().expect("a grid");
    assert!(!vtu.contains("--case") && vtu.contains("Name=\"command\" NumberOfTuples=\"19\""));
    assert_eq!(payload(&vtu, "command"), "solve --case <a> ü".as_bytes());
}

/// meshio 5.3.5 refuses the whole file otherwise: "Illegal data type 'String'".
#[test]
fn no_array_holds_text_and_regions_have_their_names() {
    let names = ["air".to_owned(), "silicone & tin".to_owned()];
    let grid = square().on_cells("region", Data::Label(vec![0, 1])).legend("region", &names).note("command", "solve");
    let vtu = grid.to_vtu().expect("a grid");
    assert!(!vtu.contains("String"));
    assert_eq!(payload(&vtu, "region: air"), 0i32.to_le_bytes());
    assert_eq!(payload(&vtu, "region: silicone &amp; tin"), 1i32.to_le_bytes());
}

#[test]
fn grids_that_do_not_fit_are_typed_errors() {
    let nothing = Grid::new(vec![[0.0, 0.0]], Cells::Triangles(vec![])).to_vtu();
    assert_eq!(nothing, Err(VtuError::Empty));
    let index = Grid::new(vec![[0.0, 0.0]; 3], Cells::Triangles(vec![[0, 1, 2], [0, 1, 3]])).to_vtu();
    assert_eq!(index, Err(VtuError::NoSuchPoint { cell: 1, point: 3, points: 3 }));
    let place = Grid::new(vec![[0.0, 0.0], [f64::NAN, 0.0], [0.0, 1.0]], Cells::Triangles(vec![[0, 1, 2]])).to_vtu();
    assert_eq!(place, Err(VtuError::NotFinite { point: 1 }));
    let short = square().on_cells("a", Data::Scalar(vec![1.0])).to_vtu();
    assert!(matches!(short, Err(VtuError::Lengths { found: 1, wanted: 2, of: "cells", .. })));
    let twice = square().on_cells("a", Data::Label(vec![1, 2])).on_cells("a", Data::Label(vec![1, 2])).to_vtu();
    assert!(matches!(twice, Err(VtuError::SameName { .. })));
}
