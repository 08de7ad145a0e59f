//! Who is asked for the responses of `command` and `function` models: started once, remembered, and asked by every recording that names them.
//!
//! Limits: one program for each `run` and folder; a program lives as long as what asks it.

use super::command::Program;
use super::identity::identity;
use super::kept::Kept;
use super::remembered::{Calls, Remembered};
use std::path::PathBuf;
use std::sync::{Arc, Mutex, PoisonError};
use truegap_core::{Corrections, Sensor, SimulationError, Simulator};
use truegap_model::{Asked, BaseError, BaseModel, Responder};

/// A function of the program that called.
#[derive(Clone)]
pub struct Function {
    /// name and parameters
    pub asked: Asked,
    /// who answers
    pub responder: Arc<Remembered>,
}

/// Everybody who can be asked; clones share them.
#[derive(Clone, Default)]
pub struct Programs {
    function: Option<Function>,
    started: Arc<Mutex<Vec<Started>>>,
    /// where answers are kept for the next time
    answers: Option<PathBuf>,
}

struct Started {
    run: Vec<String>,
    folder: PathBuf,
    responder: Arc<Remembered>,
}

impl Programs {
    /// Whatever programs the recordings name, their answers kept in a folder for the next time.
    pub fn keeping(answers: Option<PathBuf>) -> Self {
        Self { answers, ..Self::default() }
    }

    /// A function, and whatever programs the recordings name.
    pub fn with_function(function: Function) -> Self {
        Self { function: Some(function), ..Self::default() }
    }

    /// What a `function` model is made of.
    pub(super) fn function(&self) -> Option<&Asked> {
        self.function.as_ref().map(|function| &function.asked)
    }

    /// The model that `spec` describes.
    ///
    /// # Errors
    /// [`BaseError`] as [`BaseModel::informed`].
    pub fn model(
        &self,
        spec: &BaseModel,
        sensor: Option<&Sensor>,
        corrections: Option<Corrections>,
    ) -> Result<Box<dyn Simulator>, BaseError> {
        let responder = match spec {
            BaseModel::Command { run, folder, timeout_s, .. } => Some(self.program(run, folder, *timeout_s, spec)),
            BaseModel::Function { .. } => self.function.as_ref().map(|function| function.responder.clone()),
            _ => None,
        };
        let responder = responder.map(|responder| responder as Arc<dyn Responder>);
        match responder.and_then(|responder| spec.answered_by(&responder)) {
            Some(model) => Ok(Box::new(model)),
            None => spec.informed(sensor, corrections),
        }
    }

    /// The program of a `command`, the one that was started where there is one.
    fn program(&self, run: &[String], folder: &std::path::Path, timeout_s: f64, spec: &BaseModel) -> Arc<Remembered> {
        let mut started = self.started.lock().unwrap_or_else(PoisonError::into_inner);
        let same = |s: &&Started| s.run == run && s.folder == folder;
        if let Some(found) = started.iter().find(same) {
            return found.responder.clone();
        }
        let names: Vec<String> = match spec {
            BaseModel::Command { simulator, .. } => simulator.parameters.iter().map(|p| p.name.clone()).collect(),
            _ => Vec::new(),
        };
        let known = self.answers.as_ref().and_then(|answers| Some((answers, identity(run, folder, &names)?)));
        let kept = known.map(|(answers, identity)| Kept::open(answers, &identity));
        let program = Program::new(run.to_vec(), folder.to_owned(), timeout_s, names);
        let responder = Arc::new(Remembered::keeping(Box::new(program), kept));
        started.push(Started { run: run.to_vec(), folder: folder.to_owned(), responder: responder.clone() });
        responder
    }

    fn all(&self) -> Vec<Arc<Remembered>> {
        let started = self.started.lock().unwrap_or_else(PoisonError::into_inner);
        let function = self.function.iter().map(|function| function.responder.clone());
        started.iter().map(|s| s.responder.clone()).chain(function).collect()
    }

    /// What went wrong with the first that failed: its answers are not to be trusted from there on.
    pub fn failure(&self) -> Option<SimulationError> {
        self.all().iter().find_map(|responder| responder.failure().cloned())
    }

    /// Asks no slow one any further.
    pub fn stop(&self) {
        self.all().iter().for_each(|responder| responder.stop());
    }

    /// How often all of them were asked.
    pub fn calls(&self) -> Calls {
        let add = |sum: Calls, next: Calls| Calls {
            count: sum.count + next.count,
            found: sum.found + next.found,
            seconds: sum.seconds + next.seconds,
        };
        self.all().iter().map(|responder| responder.calls()).fold(Calls::default(), add)
    }
}
