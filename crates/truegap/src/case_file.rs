//! Finite-element cases and meshes as files.
//!
//! Limits: the ending of a mesh's name says its format; a mesh file is there whole or not at all.

use std::fs;
use std::io::{self, BufWriter, Write};
use std::path::{Path, PathBuf};
use truegap_fem::FemError;
use truegap_fem::case::{Case, CaseError, CaseResult, Physics, mesh_case, read_case, solve_case_with_fields};
use truegap_fem::io::{Field, write_msh, write_vtu};
use truegap_fem::mesh::{Mesh, Topology};
use truegap_fem::space::Nodes;

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
    /// name and values at the quadratic nodes: a number a node, or three of a vector
    field: Option<(&'static str, usize, Vec<f64>)>,
}

/// The first mesh of a case, before any refinement.
///
/// # Errors
/// [`CaseFileError::Fem`] where the drawing cannot be meshed.
pub fn first_mesh(case: &Case) -> Result<Meshed, CaseFileError> {
    let mesh = mesh_case(case).map_err(|source| told(&case.file, &source))?;
    Ok(Meshed { mesh, result: None, field: None })
}

/// The last mesh of a solved case, with the potential (V) or the displacement (m).
///
/// # Errors
/// [`CaseFileError::Fem`] where the case cannot be solved.
pub fn solved_mesh(case: &Case) -> Result<Meshed, CaseFileError> {
    let (result, mesh, values) = solve_case_with_fields(case).map_err(|source| told(&case.file, &source))?;
    let field = match case.physics {
        Physics::Electrostatics => ("potential (V)", 1, values),
        Physics::Elasticity => ("displacement (m)", 3, values.chunks(2).flat_map(|u| [u[0], u[1], 0.0]).collect()),
    };
    Ok(Meshed { mesh, result: Some(result), field: Some(field) })
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
    /// Writes the mesh; `.msh` keeps regions and boundaries by name, `.vtu` the field.
    ///
    /// # Errors
    /// [`CaseFileError`] for another ending, or where the disk refuses.
    pub fn write(&self, file: &Path) -> Result<(), CaseFileError> {
        let format = MeshFormat::of(file)?;
        let mut name = file.file_name().map(ToOwned::to_owned).unwrap_or_default();
        name.push(format!(".{}.part", std::process::id()));
        let part = file.with_file_name(name);
        let written = self.write_as(format, &part).and_then(|()| fs::rename(&part, file));
        written.map_err(|source| {
            let _ = fs::remove_file(&part); // nothing more can be done where even removing fails
            CaseFileError::Write { file: file.to_owned(), source }
        })
    }

    fn write_as(&self, format: MeshFormat, file: &Path) -> io::Result<()> {
        let mut out = BufWriter::new(fs::File::create(file)?);
        match format {
            MeshFormat::Msh => write_msh(&mut out, &self.mesh)?,
            MeshFormat::Vtu => {
                let nodes = Nodes::new(&self.mesh, &Topology::new(&self.mesh));
                let field = self.field.as_ref().map(|(name, components, values)| Field { name, components: *components, values });
                write_vtu(&mut out, &nodes, field.as_slice(), &[])?;
            }
        }
        out.flush()
    }
}
