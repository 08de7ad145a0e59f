//! The deformed stack of a sensor as a 3D scene, a page that shows it, and a section for ParaView.
//!
//! Limits: the physics is [`truegap_audit::disc`]'s: beads as rings, one temperature, no field outside of the plates.

mod colour;
mod layers;
mod section;

pub use colour::Colour;

use std::fs;
use std::io;
use std::path::{Path, PathBuf};
use truegap_audit::disc::{Beads, Charged, Coupled, CoupledOptions, Whole};
use truegap_audit::{AuditError, Options, Study, Watch};
use truegap_core::Sensor;
use truegap_core::units::twelve_digits;
use truegap_scene::Viewer;
use truegap_scene::glb::{Provenance, Scene, SceneError, suggested_exaggeration};
use truegap_scene::solid::Sweep;
use truegap_scene::vtu::VtuError;

/// Why nothing can be exported.
#[derive(Debug, thiserror::Error)]
#[non_exhaustive]
#[allow(missing_docs)] // the fields are named by the messages
pub enum ExportError {
    /// The disc has no solution.
    #[error(transparent)]
    Disc(#[from] AuditError),
    /// The scene cannot be made.
    #[error(transparent)]
    Scene(#[from] SceneError),
    /// The section cannot be made.
    #[error(transparent)]
    Section(#[from] VtuError),
    /// No such format.
    #[error(
        "{file}: the ending says the format, and `{ending}` is none; end the name with .glb (glTF), .html (a page that shows it) or .vtu (ParaView)"
    )]
    Format { file: PathBuf, ending: String },
    /// A temperature at which nobody knows the materials.
    #[error(
        "{} degC lies outside the range of {} to {} degC in which the materials are known; give a temperature within it",
        twelve_digits(*temperature_c), KNOWN_C.start(), KNOWN_C.end()
    )]
    Temperature { temperature_c: f64 },
    /// The disk says no.
    #[error("{file}: cannot be written: {source}; check that its folder is there and may be written to")]
    Write { file: PathBuf, source: io::Error },
}

/// How the beads behave.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub enum BeadModel {
    /// they stick to both plates, by finite elements of the bead cell
    #[default]
    Bonded,
    /// they spread freely, as the paper's (11), (12)
    Free,
}

/// What to export.
#[derive(Clone, Debug)]
pub struct Request<'a> {
    /// the sensor
    pub sensor: &'a Sensor,
    /// load, N
    pub force_n: f64,
    /// temperature, degrees Celsius
    pub temperature_c: f64,
    /// what colours the file
    pub colour: Colour,
    /// whether a quarter is cut out
    pub wedge: bool,
    /// how the beads behave
    pub beads: BeadModel,
    /// mesh and load plate
    pub options: CoupledOptions,
    /// the command, for the file
    pub command: String,
}

/// Temperatures in which the materials are known, degrees Celsius: those of a diagnosis.
const KNOWN_C: std::ops::RangeInclusive<f64> = -40.0..=125.0;

/// A solved disc and what it was asked.
pub struct Solved<'a> {
    request: Request<'a>,
    /// the disc
    pub coupled: Coupled,
}

/// Solves the disc of a request.
///
/// # Errors
/// [`ExportError::Disc`] where the sensor has no beads, the load closes the gap or no equilibrium is found.
pub fn solve(request: Request<'_>) -> Result<Solved<'_>, ExportError> {
    let temperature_c = request.temperature_c;
    if !KNOWN_C.contains(&temperature_c) {
        return Err(ExportError::Temperature { temperature_c });
    }
    let watch = Watch::default();
    let study = Study::new(request.sensor, Options::default(), &watch)?;
    let beads = match request.beads {
        BeadModel::Bonded => Beads::bonded(&study)?,
        BeadModel::Free => Beads::free(request.sensor, &study.device),
    };
    let whole = Whole::new(request.sensor, &study.device, beads, request.options)?;
    let coupled = whole.solve(request.force_n, request.temperature_c)?;
    Ok(Solved { request, coupled })
}

/// The deformed stack of a request as a scene: one node and material a layer, all fields, true scale and exaggerated.
///
/// # Errors
/// As [`solve`].
pub fn scene(request: Request<'_>) -> Result<Scene, ExportError> {
    Ok(solve(request)?.scene())
}

impl Solved<'_> {
    /// Capacitances, F.
    pub fn charged(&self) -> &Charged {
        &self.coupled.charged
    }

    /// The stack as a scene.
    pub fn scene(&self) -> Scene {
        let mut order = vec![self.request.colour];
        order.extend(Colour::ALL.into_iter().filter(|c| *c != self.request.colour));
        let layers = layers::layers(&self.coupled, self.request.sensor, &order);
        Scene {
            title: self.title(),
            exaggeration: suggested_exaggeration(&layers),
            layers,
            fields: order.iter().map(|c| layers::legend(*c)).collect(),
            sweep: Sweep { segments: 64, ..if self.request.wedge { Sweep::CUT_AWAY } else { Sweep::FULL } },
            provenance: Provenance {
                source: format!("sensor {}", self.request.sensor.name),
                command: self.request.command.clone(),
                version: env!("CARGO_PKG_VERSION").into(),
                notes: self.notes(),
            },
        }
    }

    /// The section, air included, with all fields.
    ///
    /// # Errors
    /// [`ExportError::Section`], which a solved disc does not cause.
    pub fn vtu(&self) -> Result<String, ExportError> {
        let grid = section::section(&self.coupled, self.request.temperature_c);
        let notes = self.notes();
        let command = [("command".to_owned(), self.request.command.clone())];
        let grid = notes.iter().chain(&command).fold(grid, |grid, (name, text)| grid.note(name, text));
        Ok(grid.to_vtu()?)
    }

    /// Writes the stack in the format that the ending of `file` says, whole or not at all.
    ///
    /// # Errors
    /// [`ExportError`] for another ending, or where the disk refuses.
    pub fn write(&self, file: &Path) -> Result<(), ExportError> {
        let bytes = match Format::of(file)? {
            Format::Glb => self.scene().to_glb()?,
            Format::Page => Viewer::new(&self.title(), &self.scene().to_glb()?).to_html().into_bytes(),
            Format::Vtu => self.vtu()?.into_bytes(),
        };
        let mut name = file.file_name().map(ToOwned::to_owned).unwrap_or_default();
        name.push(format!(".{}.part", std::process::id()));
        let part = file.with_file_name(name);
        fs::write(&part, bytes).and_then(|()| fs::rename(&part, file)).map_err(|source| {
            let _ = fs::remove_file(&part); // nothing more can be done where even removing fails
            ExportError::Write { file: file.to_owned(), source }
        })
    }

    fn title(&self) -> String {
        let Request { sensor, force_n, temperature_c, .. } = &self.request;
        format!("{} at {} N and {} °C", sensor.name, twelve_digits(*force_n), twelve_digits(*temperature_c))
    }

    fn notes(&self) -> Vec<(String, String)> {
        let Charged { main, backing, tail, error_estimate, .. } = self.coupled.charged;
        let total = self.coupled.charged.total();
        let picofarads = |c: f64| format!("{:.6} pF", 1e12 * c);
        let note = |name: &str, value: String| (name.to_owned(), value);
        vec![
            note("load", format!("{} N", twelve_digits(self.request.force_n))),
            note("temperature", format!("{} degC, uniform", twelve_digits(self.request.temperature_c))),
            note("reference temperature", format!("{} degC, free of stress", self.request.sensor.reference_c)),
            note("voltage", "1 V on the electrode, shields at 0 V".into()),
            note("capacitance", picofarads(total)),
            note("of it across the gap", picofarads(main)),
            note("of it behind the electrode", picofarads(backing)),
            note("of it the tail, by formula", picofarads(tail)),
            note("estimated error of the mesh", picofarads(error_estimate)),
            note(
                "beads",
                format!("{} rings of equal area share, {:?}", self.coupled.disc.section.rings.len(), self.request.beads),
            ),
            note("triangles of the section", self.coupled.deformed.triangles.len().to_string()),
        ]
    }
}

/// Formats of exported files.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Format {
    /// glTF 2.0, binary
    Glb,
    /// a page that shows it
    Page,
    /// VTK's XML
    Vtu,
}

impl Format {
    /// The format that the ending of a name says.
    ///
    /// # Errors
    /// [`ExportError::Format`] for any other ending.
    pub fn of(file: &Path) -> Result<Self, ExportError> {
        let ending = file.extension().map(|e| e.to_string_lossy().into_owned()).unwrap_or_default();
        match ending.to_lowercase().as_str() {
            "glb" => Ok(Self::Glb),
            "html" => Ok(Self::Page),
            "vtu" => Ok(Self::Vtu),
            _ => Err(ExportError::Format { file: file.to_owned(), ending }),
        }
    }
}
