//! `.vtu` out (VTK XML, ASCII): quadratic triangles with fields at nodes and on triangles.

use crate::space::Nodes;
use std::io::{Result, Write};

/// A named field; `values` holds `components` numbers a node (or a triangle).
#[derive(Debug, Clone, Copy)]
pub struct Field<'a> {
    /// Name, with its unit.
    pub name: &'a str,
    /// Numbers per item: 1 for scalars; vectors are best given three.
    pub components: usize,
    /// Values, item by item.
    pub values: &'a [f64],
}

/// Writes nodes (m), triangles and fields: `at_nodes` over the quadratic nodes, `on_triangles` over the triangles.
pub fn write_vtu(out: &mut impl Write, nodes: &Nodes, at_nodes: &[Field], on_triangles: &[Field]) -> Result<()> {
    let (points, cells) = (nodes.points.len(), nodes.triangles.len());
    writeln!(out, "<?xml version=\"1.0\"?>\n<VTKFile type=\"UnstructuredGrid\" version=\"0.1\" byte_order=\"LittleEndian\">")?;
    writeln!(out, "<UnstructuredGrid>\n<Piece NumberOfPoints=\"{points}\" NumberOfCells=\"{cells}\">")?;
    writeln!(out, "<Points>\n<DataArray type=\"Float64\" NumberOfComponents=\"3\" format=\"ascii\">")?;
    for p in &nodes.points {
        writeln!(out, "{:?} {:?} 0", p[0], p[1])?;
    }
    writeln!(out, "</DataArray>\n</Points>\n<Cells>\n<DataArray type=\"Int64\" Name=\"connectivity\" format=\"ascii\">")?;
    for t in &nodes.triangles {
        writeln!(out, "{} {} {} {} {} {}", t[0], t[1], t[2], t[3], t[4], t[5])?;
    }
    writeln!(out, "</DataArray>\n<DataArray type=\"Int64\" Name=\"offsets\" format=\"ascii\">")?;
    for i in 1..=cells {
        writeln!(out, "{}", 6 * i)?;
    }
    writeln!(out, "</DataArray>\n<DataArray type=\"UInt8\" Name=\"types\" format=\"ascii\">")?;
    for _ in 0..cells {
        // VTK_QUADRATIC_TRIANGLE
        writeln!(out, "22")?;
    }
    writeln!(out, "</DataArray>\n</Cells>")?;
    fields(out, "PointData", at_nodes)?;
    fields(out, "CellData", on_triangles)?;
    writeln!(out, "</Piece>\n</UnstructuredGrid>\n</VTKFile>")
}

fn fields(out: &mut impl Write, kind: &str, fields: &[Field]) -> Result<()> {
    writeln!(out, "<{kind}>")?;
    for f in fields {
        let name = f.name.replace('&', "&amp;").replace('<', "&lt;").replace('"', "&quot;");
        writeln!(out, "<DataArray type=\"Float64\" Name=\"{name}\" NumberOfComponents=\"{}\" format=\"ascii\">", f.components)?;
        for v in f.values.chunks(f.components) {
            let row: Vec<String> = v.iter().map(|x| format!("{x:?}")).collect();
            writeln!(out, "{}", row.join(" "))?;
        }
        writeln!(out, "</DataArray>")?;
    }
    writeln!(out, "</{kind}>")
}
