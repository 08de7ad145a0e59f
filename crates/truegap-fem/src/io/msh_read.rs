//! gmsh `.msh` 4.1 ASCII in: triangles with their physical surfaces, lines with their physical curves.
//!
//! Linear and quadratic triangles in the plane z = 0; the middle node of a quadratic line or triangle becomes an arc
//! where it is off the chord. Surfaces without a physical group are named after their number, curves without one are
//! left out.

use crate::mesh::{BoundaryEdge, Circle, CurvedEdge, Mesh, MeshError, Point, plane};
use std::collections::{BTreeMap, HashMap};

/// Reads a mesh; `file` is its name in messages. Coordinates are taken as metres.
pub fn read_msh(text: &str, file: &str) -> Result<Mesh, MeshError> {
    let mut reader = Reader { file, lines: text.lines().enumerate(), line: 0 };
    let mut parts = Parts::default();
    let mut versioned = false;
    while let Some(section) = reader.next_section() {
        match section.as_str() {
            "$MeshFormat" => {
                reader.format()?;
                versioned = true;
            }
            "$PhysicalNames" => reader.names(&mut parts)?,
            "$Entities" => reader.entities(&mut parts)?,
            "$Nodes" => reader.nodes(&mut parts)?,
            "$Elements" => reader.elements(&mut parts)?,
            _ => {}
        }
    }
    if !versioned {
        return Err(reader.wrong("no $MeshFormat section; is this a gmsh .msh file?"));
    }
    if parts.triangles.is_empty() {
        return Err(reader.wrong("no triangles; mesh the surfaces (gmsh -2) before saving"));
    }
    parts.mesh()
}

#[derive(Default)]
struct Parts {
    /// (dimension, physical tag) -> name.
    names: HashMap<(usize, i64), String>,
    /// (dimension, entity tag) -> physical tags.
    groups: HashMap<(usize, i64), Vec<i64>>,
    points: Vec<Point>,
    numbers: HashMap<u64, u32>,
    /// Nodes and entity.
    triangles: Vec<(Vec<u32>, i64)>,
    lines: Vec<(Vec<u32>, i64)>,
}

struct Reader<'a> {
    file: &'a str,
    lines: std::iter::Enumerate<std::str::Lines<'a>>,
    line: usize,
}

impl<'a> Reader<'a> {
    fn next(&mut self) -> Option<&'a str> {
        let (i, text) = self.lines.next()?;
        self.line = i + 1;
        Some(text.trim())
    }

    fn next_section(&mut self) -> Option<String> {
        loop {
            let text = self.next()?;
            if text.starts_with('$') && !text.starts_with("$End") {
                return Some(text.to_owned());
            }
        }
    }

    fn wrong(&self, what: impl Into<String>) -> MeshError {
        MeshError::File { file: self.file.into(), line: self.line, what: what.into() }
    }

    fn row(&mut self) -> Result<Vec<&'a str>, MeshError> {
        match self.next() {
            Some(text) => Ok(text.split_whitespace().collect()),
            None => Err(self.wrong("the file ends in the middle of a section; save it again")),
        }
    }

    fn number<T: std::str::FromStr>(&self, row: &[&str], k: usize) -> Result<T, MeshError> {
        let found = row.get(k).copied().unwrap_or("(nothing)");
        found.parse().map_err(|_| self.wrong(format!("entry {} is `{found}`, where a number is needed", k + 1)))
    }

    fn format(&mut self) -> Result<(), MeshError> {
        let row = self.row()?;
        if row.first() != Some(&"4.1") {
            let found = row.first().unwrap_or(&"(none)");
            return Err(self.wrong(format!("the version is {found}; save the mesh as version 4.1 (gmsh -format msh41)")));
        }
        if row.get(1) != Some(&"0") {
            return Err(self.wrong("the file is binary; save it as ASCII (gmsh -bin 0)"));
        }
        Ok(())
    }

    fn names(&mut self, parts: &mut Parts) -> Result<(), MeshError> {
        let row = self.row()?;
        for _ in 0..self.number::<usize>(&row, 0)? {
            let text = self.next().unwrap_or_default();
            let row: Vec<&str> = text.split_whitespace().collect();
            let key = (self.number(&row, 0)?, self.number(&row, 1)?);
            let name = text.split('"').nth(1).ok_or_else(|| self.wrong("a physical name must stand in quotes"))?;
            parts.names.insert(key, name.to_owned());
        }
        Ok(())
    }

    fn entities(&mut self, parts: &mut Parts) -> Result<(), MeshError> {
        let row = self.row()?;
        for dimension in 0..3 {
            for _ in 0..self.number::<usize>(&row, dimension)? {
                let row = self.row()?;
                let tag = self.number(&row, 0)?;
                // Points carry three coordinates, the others a box of six.
                let first = if dimension == 0 { 4 } else { 7 };
                let count: usize = self.number(&row, first)?;
                let groups = (0..count).map(|k| self.number(&row, first + 1 + k)).collect::<Result<Vec<i64>, _>>()?;
                parts.groups.insert((dimension, tag), groups);
            }
        }
        Ok(())
    }

    fn nodes(&mut self, parts: &mut Parts) -> Result<(), MeshError> {
        let row = self.row()?;
        for _ in 0..self.number::<usize>(&row, 0)? {
            let row = self.row()?;
            let count: usize = self.number(&row, 3)?;
            let mut tags = Vec::new();
            for _ in 0..count {
                let row = self.row()?;
                tags.push(self.number::<u64>(&row, 0)?);
            }
            for tag in tags {
                let row = self.row()?;
                let p: [f64; 3] = [self.number(&row, 0)?, self.number(&row, 1)?, self.number(&row, 2)?];
                if p[2].abs() > 1e-9 * (p[0].abs() + p[1].abs()) {
                    return Err(self.wrong(format!("node {tag} has z = {}; the mesh must lie in the plane z = 0", p[2])));
                }
                parts.numbers.insert(tag, parts.points.len() as u32);
                parts.points.push([p[0], p[1]]);
            }
        }
        Ok(())
    }

    fn elements(&mut self, parts: &mut Parts) -> Result<(), MeshError> {
        let row = self.row()?;
        for _ in 0..self.number::<usize>(&row, 0)? {
            let row = self.row()?;
            let (entity, kind, count) = (self.number(&row, 1)?, self.number::<u32>(&row, 2)?, self.number::<usize>(&row, 3)?);
            for _ in 0..count {
                let row = self.row()?;
                let nodes = || (1..row.len()).map(|k| self.node(parts, &row, k)).collect::<Result<Vec<_>, _>>();
                match (kind, row.len()) {
                    (1, 3) | (8, 4) => parts.lines.push((nodes()?, entity)),
                    (2, 4) | (9, 7) => parts.triangles.push((nodes()?, entity)),
                    (15, _) => {}
                    _ => {
                        return Err(self.wrong(format!(
                            "element type {kind} with {} nodes; only lines and triangles of order 1 and 2 can be read",
                            row.len().saturating_sub(1)
                        )));
                    }
                }
            }
        }
        Ok(())
    }

    fn node(&self, parts: &Parts, row: &[&str], k: usize) -> Result<u32, MeshError> {
        let tag: u64 = self.number(row, k)?;
        parts.numbers.get(&tag).copied().ok_or_else(|| self.wrong(format!("node {tag} is not among the nodes of the file")))
    }
}

impl Parts {
    fn mesh(self) -> Result<Mesh, MeshError> {
        let mut mesh = Mesh::default();
        let mut corner: HashMap<u32, u32> = HashMap::new();
        let mut curved: BTreeMap<(u32, u32), CurvedEdge> = BTreeMap::new();
        for (nodes, entity) in &self.triangles {
            let c: Vec<u32> = nodes[..3].iter().map(|&n| number_corner(n, &self.points, &mut corner, &mut mesh.points)).collect();
            mesh.triangles.push([c[0], c[1], c[2]]);
            let name = self.name(2, *entity).unwrap_or_else(|| format!("surface {entity}"));
            let region = index_of(&mut mesh.region_names, name)?;
            mesh.triangle_regions.push(region);
            for k in 0..nodes.len().saturating_sub(3) {
                let ends = [c[k], c[(k + 1) % 3]];
                if let Some(edge) = arc(&mesh, ends, self.points[nodes[3 + k] as usize]) {
                    curved.insert((ends[0].min(ends[1]), ends[0].max(ends[1])), edge);
                }
            }
        }
        for (nodes, entity) in &self.lines {
            let (Some(name), Some(&a), Some(&b)) = (self.name(1, *entity), corner.get(&nodes[0]), corner.get(&nodes[1])) else {
                continue;
            };
            let boundary = index_of(&mut mesh.boundary_names, name)?;
            mesh.boundary_edges.push(BoundaryEdge { nodes: [a, b], boundary });
        }
        mesh.curved_edges = curved.into_values().collect();
        mesh.check()?;
        Ok(mesh)
    }

    fn name(&self, dimension: usize, entity: i64) -> Option<String> {
        let group = *self.groups.get(&(dimension, entity))?.first()?;
        Some(self.names.get(&(dimension, group)).cloned().unwrap_or_else(|| format!("physical {group}")))
    }
}

fn number_corner(node: u32, points: &[Point], corner: &mut HashMap<u32, u32>, out: &mut Vec<Point>) -> u32 {
    *corner.entry(node).or_insert_with(|| {
        out.push(points[node as usize]);
        (out.len() - 1) as u32
    })
}

fn index_of(names: &mut Vec<String>, name: String) -> Result<u16, MeshError> {
    if let Some(i) = names.iter().position(|n| *n == name) {
        return Ok(i as u16);
    }
    names.push(name);
    truegap_limits::count("the mesh", names.len(), "names of surfaces or curves", usize::from(u16::MAX) - 1, "join some groups")?;
    Ok((names.len() - 1) as u16)
}

fn arc(mesh: &Mesh, nodes: [u32; 2], middle: Point) -> Option<CurvedEdge> {
    let [a, b] = nodes.map(|i| mesh.points[i as usize]);
    let off = plane::distance(middle, plane::along(a, b, 0.5));
    if off <= 1e-9 * plane::distance(a, b) {
        return None;
    }
    Circle::through(a, middle, b).map(|circle| CurvedEdge { nodes, circle })
}
