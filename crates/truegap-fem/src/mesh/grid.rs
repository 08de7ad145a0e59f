//! Flat stacks of layers on a grid of columns and rows: long thin triangles where a layer is much thinner than wide.
//!
//! Rectangles only. Quadratic elements bend well at aspect ratios of a hundred; free triangulations would need a
//! triangle per thickness.

use super::error::MeshError;
use super::mesh::{BoundaryEdge, Mesh};

/// A layer of a stack.
#[derive(Debug, Clone, PartialEq)]
pub struct Layer {
    /// Name of its region; its upper side is the boundary `NAME.top`.
    pub name: String,
    /// Thickness (m).
    pub thickness: f64,
    /// Rows of cells across it.
    pub rows: usize,
}

/// Meshes a stack of layers from `bottom` (m) upwards between the first and last of the increasing `columns` (m).
///
/// Boundaries: `left`, `right`, `bottom`, `top`, and `NAME.top` of every layer.
///
/// # Errors
/// `BadSize` where columns do not increase or a layer has no thickness or row; `NoRegion` without layers.
pub fn layered_grid(columns: &[f64], bottom: f64, layers: &[Layer]) -> Result<Mesh, MeshError> {
    if layers.is_empty() || columns.len() < 2 {
        return Err(MeshError::NoRegion);
    }
    let steps = columns.windows(2).map(|w| w[1] - w[0]);
    if let Some(size) = steps.chain(layers.iter().map(|l| l.thickness / l.rows as f64)).find(|s| !(*s > 0.0 && s.is_finite())) {
        return Err(MeshError::BadSize { size });
    }
    let mut mesh = Mesh { region_names: layers.iter().map(|l| l.name.clone()).collect(), ..Mesh::default() };
    let (levels, region_of_row) = levels(bottom, layers);
    for z in &levels {
        mesh.points.extend(columns.iter().map(|r| [*r, *z]));
    }
    add_triangles(&mut mesh, columns.len(), &region_of_row);
    name_sides(&mut mesh, columns.len(), levels.len(), layers);
    Ok(mesh)
}

fn levels(bottom: f64, layers: &[Layer]) -> (Vec<f64>, Vec<u16>) {
    let mut levels = vec![bottom];
    let mut regions = Vec::new();
    let mut base = bottom;
    for (region, layer) in layers.iter().enumerate() {
        for row in 1..=layer.rows {
            levels.push(base + layer.thickness * row as f64 / layer.rows as f64);
            regions.push(region as u16);
        }
        base += layer.thickness;
    }
    (levels, regions)
}

/// Two triangles a cell, diagonals in turn so that no direction is preferred.
fn add_triangles(mesh: &mut Mesh, width: usize, region_of_row: &[u16]) {
    for (row, &region) in region_of_row.iter().enumerate() {
        for column in 0..width - 1 {
            let a = (row * width + column) as u32;
            let [b, c, d] = [a + 1, a + 1 + width as u32, a + width as u32];
            let pair = if (row + column) % 2 == 0 { [[a, b, c], [a, c, d]] } else { [[a, b, d], [b, c, d]] };
            mesh.triangles.extend(pair);
            mesh.triangle_regions.extend([region; 2]);
        }
    }
}

fn name_sides(mesh: &mut Mesh, width: usize, height: usize, layers: &[Layer]) {
    let node = |row: usize, column: usize| (row * width + column) as u32;
    let along_row = |row: usize| (0..width - 1).map(|c| [node(row, c), node(row, c + 1)]).collect::<Vec<_>>();
    let along_column = |column: usize| (0..height - 1).map(|r| [node(r, column), node(r + 1, column)]).collect::<Vec<_>>();
    let mut sides = vec![
        ("left".to_string(), along_column(0)),
        ("right".to_string(), along_column(width - 1)),
        ("bottom".to_string(), along_row(0)),
        ("top".to_string(), along_row(height - 1)),
    ];
    let mut row = 0;
    for layer in layers {
        row += layer.rows;
        sides.push((format!("{}.top", layer.name), along_row(row)));
    }
    for (name, edges) in sides {
        let boundary = mesh.boundary_names.len() as u16;
        mesh.boundary_names.push(name);
        mesh.boundary_edges.extend(edges.into_iter().map(|nodes| BoundaryEdge { nodes, boundary }));
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn layer(name: &str, thickness: f64, rows: usize) -> Layer {
        Layer { name: name.into(), thickness, rows }
    }

    #[test]
    fn a_stack_has_its_area_its_regions_and_its_sides() {
        let mesh = layered_grid(&[0.0, 1.0, 3.0], -1.0, &[layer("low", 2.0, 2), layer("high", 0.5, 1)]).unwrap();
        mesh.check().unwrap();
        assert_eq!(mesh.triangles.len(), 12);
        let area = |region: u16| -> f64 {
            (0..12)
                .filter(|&t| mesh.triangle_regions[t] == region)
                .map(|t| {
                    let [a, b, c] = mesh.corners(t);
                    0.5 * super::super::plane::twice_area(a, b, c)
                })
                .sum()
        };
        assert!((area(0) - 6.0).abs() < 1e-14 && (area(1) - 1.5).abs() < 1e-14);
        for (name, z) in [("bottom", -1.0), ("low.top", 1.0), ("high.top", 1.5), ("top", 1.5)] {
            let edges: Vec<_> = mesh.edges_of(mesh.boundary(name).unwrap()).collect();
            assert_eq!(edges.len(), 2, "{name}");
            assert!(edges.iter().flatten().all(|&n| mesh.points[n as usize][1] == z), "{name}");
        }
    }

    #[test]
    fn a_stack_without_thickness_is_refused() {
        assert!(matches!(layered_grid(&[0.0, 1.0], 0.0, &[layer("a", 0.0, 1)]), Err(MeshError::BadSize { .. })));
        assert!(matches!(layered_grid(&[0.0, 0.0], 0.0, &[layer("a", 1.0, 1)]), Err(MeshError::BadSize { .. })));
        assert!(matches!(layered_grid(&[0.0, 1.0], 0.0, &[layer("a", 1.0, 0)]), Err(MeshError::BadSize { .. })));
        assert!(matches!(layered_grid(&[0.0, 1.0], 0.0, &[]), Err(MeshError::NoRegion)));
    }
}
