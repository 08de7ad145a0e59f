//! Diagnosis and confirmation, as Python asks for them and as it holds what was found.
//!
//! Limits: the words of the command line; results leave as JSON, text and arrays.

use crate::desk::{Declared, PythonFunction, serve};
use crate::source::{Source, failed, note_in_python, rebased};
use numpy::{IntoPyArray, PyArray1};
use pyo3::prelude::*;
use serde::Deserialize;
use std::path::{Path, PathBuf};
use std::sync::atomic::AtomicBool;
use truegap::diagnose::Library;
use truegap::diagnosis::compensate::{Wanted, compensate_with};
use truegap::diagnosis::confirm::{Confirmed, Free, confirm_with};
use truegap::diagnosis::{Diagnosed, FILES, Request, cache_folder, open_with, report};
use truegap::models::{ModelFile, ModelFileError, Programs, with_effects};
use truegap::{OutputFolder, Recording};

/// Columns by their names.
type Column<'py> = Bound<'py, PyArray1<f64>>;
type Columns<'py> = Vec<(String, Column<'py>)>;

/// What the Python half asks for beside recordings, as JSON.
#[derive(Deserialize)]
#[serde(deny_unknown_fields)]
struct Asked {
    sensor: Option<String>,
    base: Option<String>,
    no_warp: bool,
    effects: Vec<String>,
    conceal: Vec<String>,
    channel: Option<String>,
    free: Vec<String>,
    bank: Option<usize>,
    effect_files: Vec<PathBuf>,
    library_only: bool,
    select_in_folds: bool,
    permuted_searches: Option<usize>,
    /// folder in which answers of programs are kept
    cache: Option<PathBuf>,
    /// whether they are kept in the user's cache folder
    remember: bool,
    command: String,
}

impl Asked {
    /// As the command line asks; numbers of effects from files stand in the units that `recording` gives them.
    fn request(self, recording: Option<&Recording>) -> PyResult<Request> {
        let library = with_effects(Library::default(), &self.effect_files, recording).map_err(failed)?;
        let Self { sensor, base, no_warp, effects, conceal, channel, free, bank, .. } = self;
        let Self { library_only, select_in_folds, permuted_searches, cache, remember, command, .. } = self;
        Ok(Request {
            sensor,
            base,
            no_warp,
            effects,
            conceal,
            channel,
            free,
            bank,
            library,
            library_only,
            select_in_folds,
            permuted_searches: permuted_searches.unwrap_or(0),
            command,
            // of programs alone: nobody can tell whether a function has changed
            answers: cache.or_else(|| cache_folder("answers").filter(|_| remember)),
        })
    }
}

/// A Python function as it is given: name, function, parameters.
type Given = (String, Py<PyAny>, Vec<Declared>);

fn function(given: Option<Given>) -> PyResult<Option<PythonFunction>> {
    given.map(|(name, call, parameters)| PythonFunction::new(name, call, &parameters)).transpose()
}

/// Who is asked: a function, or the programs that recordings name, their answers kept in a folder where one is given.
fn programs(function: Option<&PythonFunction>, answers: Option<PathBuf>) -> Programs {
    function.map_or_else(|| Programs::keeping(answers), |f| f.programs.clone())
}

/// What was found.
#[pyclass(frozen, module = "truegap._truegap")]
pub(crate) struct NativeDiagnosis {
    diagnosed: Diagnosed,
    function: Option<PythonFunction>,
}

/// Diagnoses recordings; `asked` are the words of the command line as JSON, `base` a table of a base model as JSON.
#[pyfunction]
#[pyo3(signature = (sources, asked, base, given, progress))]
pub(crate) fn diagnose(
    py: Python<'_>,
    sources: Vec<Source<'_>>,
    asked: &str,
    base: Option<&str>,
    given: Option<Given>,
    progress: Option<Py<PyAny>>,
) -> PyResult<NativeDiagnosis> {
    let asked: Asked = serde_json::from_str(asked).map_err(failed)?;
    let function = function(given)?;
    let read = sources.iter().map(Source::read).collect::<PyResult<Vec<_>>>()?;
    let files = read.iter().map(|(recording, name)| (name.clone(), recording.sha256.clone())).collect();
    let recordings = read.into_iter().map(|(r, _)| rebased(r, base)).collect::<PyResult<Vec<_>>>()?;
    let request = asked.request(recordings.first())?;
    let opened = open_with(recordings, &request, programs(function.as_ref(), request.answers.clone())).map_err(failed)?;
    let stop = AtomicBool::new(false);
    let work =
        |tell: &(dyn Fn(truegap::diagnose::Progress) + Sync)| truegap::diagnosis::diagnose(opened, files, &request, tell, &stop);
    let diagnosed = serve(py, function.as_ref(), progress.as_ref(), &stop, work)?;
    Ok(NativeDiagnosis { diagnosed: diagnosed.map_err(failed)?, function })
}

#[pymethods]
impl NativeDiagnosis {
    /// `diagnosis.json`.
    fn json(&self) -> PyResult<String> {
        serde_json::to_string_pretty(&self.diagnosed.outcome.diagnosis).map_err(failed)
    }

    /// What the command line prints.
    fn summary(&self) -> String {
        report::terminal::summary(&self.diagnosed.outcome.diagnosis)
    }

    /// `report.html`.
    fn html(&self) -> String {
        report::html(&self.diagnosed.subject())
    }

    /// The top of the report, as a part of a page.
    fn first_screen(&self) -> String {
        report::first_screen(&self.diagnosed.subject())
    }

    /// `augmented.toml`.
    fn model_toml(&self) -> PyResult<String> {
        self.diagnosed.model_file().and_then(|model| model.to_toml()).map_err(failed)
    }

    /// Rows and predictions, as in `prediction.csv`.
    fn table<'py>(&self, py: Python<'py>) -> Columns<'py> {
        arrays(py, self.diagnosed.prediction_table())
    }

    /// What reading the recordings changed, left out or assumed.
    fn notes(&self) -> Vec<String> {
        self.diagnosed.recording.notes.iter().map(note_in_python).collect()
    }

    /// How often a function or a program was asked, and the seconds that it took.
    fn calls(&self) -> (u64, f64) {
        let calls = self.diagnosed.programs.calls();
        (calls.count, calls.seconds)
    }

    /// Writes the folder that the command line writes; where it was written.
    fn save(&self, folder: PathBuf) -> PyResult<PathBuf> {
        OutputFolder::check(&folder, &FILES).map_err(failed)?;
        self.diagnosed.write(&folder).map_err(failed)
    }

    /// Response of the augmented model, and of the base model calibrated alone, for each row of `source`.
    fn predict<'py>(&self, py: Python<'py>, source: Source<'_>) -> PyResult<(Column<'py>, Column<'py>)> {
        let (recording, _) = source.read()?;
        let predicted = self.serve(py, |programs| {
            let model = self.diagnosed.model_file()?.build_with(programs)?;
            Ok::<_, ModelFileError>((model.respond(&recording.inputs)?, model.respond_alone(&recording.inputs)?))
        })?;
        let (augmented, base) = predicted.map_err(failed)?;
        Ok((augmented.into_pyarray(py), base.into_pyarray(py)))
    }

    /// Judges what was added on a recording that took no part: `confirmation.json` and the columns of `confirmation.csv`.
    #[pyo3(signature = (source, free, channel))]
    fn confirm<'py>(
        &self,
        py: Python<'py>,
        source: Source<'_>,
        free: Vec<String>,
        channel: Option<String>,
    ) -> PyResult<(String, Columns<'py>)> {
        let free = Free::of(&free).map_err(failed)?;
        let (recording, _) = source.read()?;
        let model = self.diagnosed.model_file().map_err(failed)?;
        let name = Path::new("augmented.toml");
        let confirmed = self.serve(py, |programs| confirm_with(&model, name, recording, channel.as_deref(), free, programs))?;
        confirmation(py, confirmed.map_err(failed)?)
    }

    /// Corrects readings for what was added: the document of `truegap --json compensate` and the columns of its CSV.
    #[pyo3(signature = (source, channel, all, carried))]
    fn compensate<'py>(
        &self,
        py: Python<'py>,
        source: Source<'_>,
        channel: Option<String>,
        all: bool,
        carried: bool,
    ) -> PyResult<(String, Columns<'py>)> {
        let wanted = Wanted { of_the_clock: all, carried };
        let (recording, _) = source.read()?;
        let model = self.diagnosed.model_file().map_err(failed)?;
        let name = Path::new("augmented.toml");
        let compensated =
            self.serve(py, |programs| compensate_with(&model, name, recording, channel.as_deref(), wanted, programs))?;
        let compensated = compensated.map_err(failed)?;
        Ok((serde_json::to_string(&compensated.document).map_err(failed)?, arrays(py, compensated.table())))
    }
}

impl NativeDiagnosis {
    fn serve<T: Send>(&self, py: Python<'_>, work: impl FnOnce(&Programs) -> T + Send) -> PyResult<T> {
        let programs = &self.diagnosed.programs;
        serve(py, self.function.as_ref(), None, &AtomicBool::new(false), |_| work(programs))
    }
}

/// Judges a model file on a recording that took no part in it.
#[pyfunction]
#[pyo3(signature = (file, source, free, channel, given))]
pub(crate) fn confirm<'py>(
    py: Python<'py>,
    file: PathBuf,
    source: Source<'_>,
    free: Vec<String>,
    channel: Option<String>,
    given: Option<Given>,
) -> PyResult<(String, Columns<'py>)> {
    let free = Free::of(&free).map_err(failed)?;
    let function = function(given)?;
    let model = ModelFile::open(&file).map_err(failed)?;
    let recording: Recording = source.read()?.0;
    let programs = programs(function.as_ref(), None);
    let work = |_: &(dyn Fn(truegap::diagnose::Progress) + Sync)| {
        confirm_with(&model, &file, recording, channel.as_deref(), free, &programs)
    };
    let confirmed = serve(py, function.as_ref(), None, &AtomicBool::new(false), work)?;
    confirmation(py, confirmed.map_err(failed)?)
}

fn confirmation(py: Python<'_>, confirmed: Confirmed) -> PyResult<(String, Columns<'_>)> {
    let json = serde_json::to_string(&confirmed.document).map_err(failed)?;
    Ok((json, arrays(py, confirmed.table())))
}

fn arrays(py: Python<'_>, columns: Vec<(String, Vec<f64>)>) -> Columns<'_> {
    columns.into_iter().map(|(name, column)| (name, column.into_pyarray(py))).collect()
}
