//! Finite-element cases and meshes as files.
//!
//! Limits: the ending of a mesh's name says its format; a mesh file is there whole or not at all.

use std::fs;
use std::io::{self, BufWriter, Write};
use std::path::{Path, PathBuf};
use truegap_fem::FemError;
use truegap_fem::case::{
    Case, CaseError, CaseResult, InTriangles, Physics, SolvedCase, mesh_case, read_case, solve_case_with_fields,
};
use truegap_fem::elasticity::Components;
use truegap_fem::io::write_msh;
use truegap_fem::mesh::{Mesh, Topology};
use truegap_fem::space::Nodes;
use truegap_scene::vtu::{Cells, Data, Grid, VtuError};

/// Why a case cannot be read, or its mesh not be written.
#[derive(Debug, thiserror::Error)]
#[non_exhaustive]
#[allow(missing_docs)] // the fields are named by the messages
pub enum CaseFileError {
    /// The file cannot be read.
    #[error("{file}: cannot be read: {source}; give a TOML that begins with schema = \"truegap.case/1\"")]
    Read { file: PathBuf, source: io::Error },
    /// The file is no case.
    #[error(transparent)]
    Case(#[from] CaseError),
    /// The case cannot be meshed or solved.
    #[error("{file}: {source}")]
    Fem { file: String, source: FemError },
    /// No such format.
    #[error("{file}: the ending says the format, and `{ending}` is none; end the name with .msh (gmsh 4.1) or .vtu (VTK)")]
    Format { file: PathBuf, ending: String },
    /// The grid cannot be written.
    #[error(transparent)]
    Grid(#[from] VtuError),
    /// The disk says no.
    #[error("{file}: cannot be written: {source}; check that its folder is there and may be written to")]
    Write { file: PathBuf, source: io::Error },
}

/// Reads a case.
///
/// # Errors
/// [`CaseFileError`] where the file is not there or is no case.
pub fn open_case(file: &Path) -> Result<Case, CaseFileError> {
    let text = truegap_limits::read_text(file).map_err(|source| CaseFileError::Read { file: file.to_owned(), source })?;
    Ok(read_case(&text, &file.display().to_string())?)
}

/// A reason with the file it belongs to, which some reasons name already.
pub fn told(file: &str, reason: &FemError) -> CaseFileError {
    match reason {
        FemError::Case(source) => CaseFileError::Case(source.clone()),
        source => CaseFileError::Fem { file: file.to_owned(), source: source.clone() },
    }
}

/// A mesh to be written, with the solution on it where there is one.
pub struct Meshed {
    /// the mesh
    pub mesh: Mesh,
    /// what a solution says, where the case was solved
    pub result: Option<CaseResult>,
    /// at the quadratic nodes
    at_nodes: Vec<(&'static str, Data)>,
    /// in the middle of the triangles
    in_triangles: Vec<(&'static str, Data)>,
}

/// The first mesh of a case, before any refinement.
///
/// # Errors
/// [`CaseFileError::Fem`] where the drawing cannot be meshed.
pub fn first_mesh(case: &Case) -> Result<Meshed, CaseFileError> {
    let mesh = mesh_case(case).map_err(|source| told(&case.file, &source))?;
    Ok(Meshed { mesh, result: None, at_nodes: Vec::new(), in_triangles: Vec::new() })
}

/// The last mesh of a solved case, with the potential (V) and the electric field, or the displacement (m), strain and stress.
///
/// # Errors
/// [`CaseFileError::Fem`] where the case cannot be solved.
pub fn solved_mesh(case: &Case) -> Result<Meshed, CaseFileError> {
    let SolvedCase { result, mesh, at_nodes, in_triangles } =
        solve_case_with_fields(case).map_err(|source| told(&case.file, &source))?;
    let at_nodes = match case.physics {
        Physics::Electrostatics => ("potential (V)", Data::Scalar(at_nodes)),
        Physics::Elasticity => ("displacement (m)", Data::Vector(at_nodes.as_chunks::<2>().0.to_vec())),
    };
    Ok(Meshed { mesh, result: Some(result), at_nodes: vec![at_nodes], in_triangles: arrays(&in_triangles) })
}

fn arrays(in_triangles: &InTriangles) -> Vec<(&'static str, Data)> {
    let tensor = |values: &[Components]| Data::Tensor(values.iter().map(|c| [c.rr, c.zz, c.tt, c.rz]).collect());
    match in_triangles {
        InTriangles::Electric(field) => vec![("electric field (V/m)", Data::Vector(field.clone()))],
        InTriangles::Elastic { strain, stress } => vec![
            ("strain (1)", tensor(strain)),
            ("stress (Pa)", tensor(stress)),
            ("von Mises stress (Pa)", Data::Scalar(stress.iter().map(von_mises).collect())),
        ],
    }
}

/// Size of the part of a stress that changes the shape, `sqrt(3/2 s:s)` of its deviator `s`.
fn von_mises(c: &Components) -> f64 {
    let mean = (c.rr + c.zz + c.tt) / 3.0;
    let deviator = [c.rr - mean, c.zz - mean, c.tt - mean];
    (1.5 * (deviator.iter().map(|d| d * d).sum::<f64>() + 2.0 * c.rz * c.rz)).sqrt()
}

/// Formats of mesh files.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum MeshFormat {
    /// gmsh 4.1, text
    Msh,
    /// VTK's XML, text
    Vtu,
}

impl MeshFormat {
    /// The format that the ending of a name says.
    ///
    /// # Errors
    /// [`CaseFileError::Format`] for any other ending.
    pub fn of(file: &Path) -> Result<Self, CaseFileError> {
        let ending = file.extension().map(|e| e.to_string_lossy().into_owned()).unwrap_or_default();
        match ending.to_lowercase().as_str() {
            "msh" => Ok(Self::Msh),
            "vtu" => Ok(Self::Vtu),
            _ => Err(CaseFileError::Format { file: file.to_owned(), ending }),
        }
    }
}

impl Meshed {
    /// Writes the mesh; both keep regions by name, `.msh` the boundaries, `.vtu` the fields.
    ///
    /// # Errors
    /// [`CaseFileError`] for another ending, or where the disk refuses.
    pub fn write(&self, file: &Path) -> Result<(), CaseFileError> {
        let format = MeshFormat::of(file)?;
        let mut name = file.file_name().map(ToOwned::to_owned).unwrap_or_default();
        name.push(format!(".{}.part", std::process::id()));
        let part = file.with_file_name(name);
        let written = match format {
            MeshFormat::Msh => write_whole(&part, |out| write_msh(out, &self.mesh)),
            MeshFormat::Vtu => {
                let text = self.vtu()?;
                write_whole(&part, |out| out.write_all(text.as_bytes()))
            }
        };
        written.and_then(|()| fs::rename(&part, file)).map_err(|source| {
            let _ = fs::remove_file(&part); // nothing more can be done where even removing fails
            CaseFileError::Write { file: file.to_owned(), source }
        })
    }

    fn vtu(&self) -> Result<String, VtuError> {
        let nodes = Nodes::new(&self.mesh, &Topology::new(&self.mesh));
        let cells = nodes.triangles.iter().map(|t| t.map(|n| n as usize)).collect();
        let regions = self.mesh.triangle_regions.iter().map(|&r| i32::from(r)).collect();
        let grid = Grid::new(nodes.points, Cells::QuadraticTriangles(cells))
            .on_cells("region", Data::Label(regions))
            .legend("region", &self.mesh.region_names);
        let grid = self.at_nodes.iter().fold(grid, |grid, (name, data)| grid.on_points(name, data.clone()));
        self.in_triangles.iter().fold(grid, |grid, (name, data)| grid.on_cells(name, data.clone())).to_vtu()
    }
}

fn write_whole(file: &Path, write: impl FnOnce(&mut BufWriter<fs::File>) -> io::Result<()>) -> io::Result<()> {
    let mut out = BufWriter::new(fs::File::create(file)?);
    write(&mut out)?;
    out.flush()
}
