//! The XML of a `.vtu` file, version 1.0 with 64-bit block lengths.
//!
//! **Source:** VTK file formats, "XML file formats", docs.vtk.org (unstructured grid, binary inline encoding).

use super::error::VtuError;
use super::grid::{Cells, Data, Grid};
use crate::page::escape;
use base64::Engine;
use base64::engine::general_purpose::STANDARD;
use std::fmt::Write;

impl Grid {
    /// The text of the `.vtu` file.
    ///
    /// # Errors
    /// No cell, indices or lengths that do not fit, coordinates that are not finite, two fields of one name.
    pub fn to_vtu(&self) -> Result<String, VtuError> {
        self.check()?;
        Ok(file(self))
    }
}

/// The whole file; `grid` has been checked.
fn file(grid: &Grid) -> String {
    let mut out = String::from(
        "<?xml version=\"1.0\"?>\n<VTKFile type=\"UnstructuredGrid\" version=\"1.0\" byte_order=\"LittleEndian\" \
         header_type=\"UInt64\">\n<UnstructuredGrid>\n",
    );
    if !(grid.notes.is_empty() && grid.legend.is_empty()) {
        out += "<FieldData>\n";
        grid.legend.iter().for_each(|(name, number)| whole(&mut out, name, "Int32", 1, &number.to_le_bytes()));
        grid.notes.iter().for_each(|(name, text)| whole(&mut out, name, "UInt8", text.len(), text.as_bytes()));
        out += "</FieldData>\n";
    }
    let (points, cells) = (grid.points.len(), grid.cells.len());
    let _ = writeln!(out, "<Piece NumberOfPoints=\"{points}\" NumberOfCells=\"{cells}\">");
    section(&mut out, "PointData", &grid.on_points);
    section(&mut out, "CellData", &grid.on_cells);
    out += "<Points>\n";
    array(&mut out, "Points", "Float64", 3, &flat(grid.points.iter().map(|p| [p[0], p[1], 0.0])));
    out += "</Points>\n<Cells>\n";
    topology(&mut out, &grid.cells);
    out += "</Cells>\n</Piece>\n</UnstructuredGrid>\n</VTKFile>\n";
    out
}

fn topology(out: &mut String, cells: &Cells) {
    let width = cells.width();
    let connectivity = cells.flat().iter().flat_map(|&p| (p as i64).to_le_bytes()).collect::<Vec<u8>>();
    array(out, "connectivity", "Int64", 1, &connectivity);
    let offsets = (1..=cells.len()).flat_map(|i| ((i * width) as i64).to_le_bytes()).collect::<Vec<u8>>();
    array(out, "offsets", "Int64", 1, &offsets);
    // VTK_TRIANGLE = 5, VTK_QUADRATIC_TRIANGLE = 22.
    let kind = match cells {
        Cells::Triangles(_) => 5u8,
        Cells::QuadraticTriangles(_) => 22,
    };
    array(out, "types", "UInt8", 1, &vec![kind; cells.len()]);
}

fn section(out: &mut String, tag: &str, fields: &[(String, Data)]) {
    let _ = writeln!(out, "<{tag}>");
    for (name, data) in fields {
        match data {
            Data::Scalar(values) => array(out, name, "Float64", 1, &flat(values.iter().map(|&v| [v]))),
            Data::Vector(values) => array(out, name, "Float64", 3, &flat(values.iter().map(|v| [v[0], v[1], 0.0]))),
            Data::Tensor(values) => {
                let six = values.iter().map(|t| [t[0], t[1], t[2], t[3], 0.0, 0.0]);
                array(out, name, "Float64", 6, &flat(six));
            }
            Data::Label(values) => {
                let bytes: Vec<u8> = values.iter().flat_map(|v| v.to_le_bytes()).collect();
                array(out, name, "Int32", 1, &bytes);
            }
        }
    }
    let _ = writeln!(out, "</{tag}>");
}

fn flat<const N: usize>(rows: impl Iterator<Item = [f64; N]>) -> Vec<u8> {
    rows.flat_map(|row| row.into_iter().flat_map(f64::to_le_bytes)).collect()
}

/// A data array; the block length goes before the data into one base64 stream.
fn array(out: &mut String, name: &str, kind: &str, components: usize, bytes: &[u8]) {
    data(out, name, kind, &format!("NumberOfComponents=\"{components}\""), bytes);
}

/// An array of the file as a whole, which has to say how long it is.
fn whole(out: &mut String, name: &str, kind: &str, tuples: usize, bytes: &[u8]) {
    data(out, name, kind, &format!("NumberOfTuples=\"{tuples}\""), bytes);
}

fn data(out: &mut String, name: &str, kind: &str, size: &str, bytes: &[u8]) {
    let mut block = (bytes.len() as u64).to_le_bytes().to_vec();
    block.extend_from_slice(bytes);
    let _ = writeln!(
        out,
        "<DataArray type=\"{kind}\" Name=\"{}\" {size} format=\"binary\">{}</DataArray>",
        escape(name),
        STANDARD.encode(block)
    );
}
