//! Where the threads of a diagnosis and the one thread of Python meet: questions to a Python function, progress, and Ctrl-C.
//!
//! Work is done in a thread of its own. The thread that Python called from waits for it and meanwhile answers questions, so that a function is never called
//! from a thread that it does not know, and Ctrl-C reaches it in the middle of a long answer.
//!
//! Limits: one piece of work at a time for a function.

use numpy::{PyArray1, PyReadonlyArray1};
use pyo3::prelude::*;
use pyo3::types::PyDict;
use std::sync::atomic::{AtomicBool, Ordering};
use std::sync::mpsc::{Receiver, RecvTimeoutError, Sender, channel};
use std::sync::{Arc, Mutex, PoisonError};
use std::time::Duration;
use truegap::core::{Inputs, Parameter, SimulationError};
use truegap::diagnose::Progress;
use truegap::model::{Asked, Responder, Who};
use truegap::models::{Function, Programs, Remembered, columns, declared};

use crate::source::failed;

/// Longest time between two looks for Ctrl-C.
const LOOK: Duration = Duration::from_millis(50);

/// What happens while work is done.
enum Event {
    Question { values: Vec<f64>, inputs: Box<Inputs>, reply: Sender<Result<Vec<f64>, SimulationError>> },
    Progress { done: f64, step: String, what: String },
    Done,
}

/// Takes the questions of the work to whoever serves at the moment.
#[derive(Default)]
pub(crate) struct Desk(Mutex<Option<Sender<Event>>>);

impl Desk {
    fn open(&self, events: Option<Sender<Event>>) {
        *self.0.lock().unwrap_or_else(PoisonError::into_inner) = events;
    }

    fn is_open(&self) -> bool {
        self.0.lock().unwrap_or_else(PoisonError::into_inner).is_some()
    }
}

/// A [`Desk`] as the one who answers.
struct AtDesk(Arc<Desk>);

impl Responder for AtDesk {
    fn respond(&self, values: &[f64], inputs: &Inputs) -> Result<Vec<f64>, SimulationError> {
        let nobody = |_| SimulationError::Program { says: "nobody is there to call the function".into() };
        let events = self.0.0.lock().unwrap_or_else(PoisonError::into_inner).clone();
        let events = events.ok_or(()).map_err(nobody)?;
        let (reply, answer) = channel();
        let question = Event::Question { values: values.to_vec(), inputs: Box::new(inputs.clone()), reply };
        events.send(question).map_err(|_| nobody(()))?;
        answer.recv().map_err(|_| nobody(()))?
    }
}

/// A Python function `f(inputs, parameters) -> array`, with its parameters.
pub(crate) struct PythonFunction {
    call: Py<PyAny>,
    names: Vec<String>,
    desk: Arc<Desk>,
    /// what truegap asks
    pub programs: Programs,
}

/// A parameter as Python declares it.
#[derive(FromPyObject)]
pub(crate) struct Declared {
    name: String,
    value: f64,
    sd: f64,
    unit: String,
    low: f64,
    high: f64,
    meaning: String,
}

impl PythonFunction {
    /// A function named `name`.
    pub fn new(name: String, call: Py<PyAny>, parameters: &[Declared]) -> PyResult<Self> {
        let one = |p: &Declared| {
            let declared = declared(&p.name, &p.unit, p.value, p.sd, (p.low, p.high), &p.meaning);
            declared.map_err(|why| failed(format!("the parameter `{}` {why}", p.name)))
        };
        let parameters = parameters.iter().map(one).collect::<PyResult<Vec<Parameter>>>()?;
        let names = parameters.iter().map(|p| p.name.clone()).collect();
        let desk = Arc::new(Desk::default());
        let asked = Asked { who: Who::Function { name }, parameters, inside: true };
        let responder = Arc::new(Remembered::new(Box::new(AtDesk(desk.clone()))));
        Ok(Self { call, names, desk, programs: Programs::with_function(Function { asked, responder }) })
    }

    /// Calls the function; an exception gets a note with the parameters that caused it.
    fn answer(&self, py: Python<'_>, values: &[f64], inputs: &Inputs) -> PyResult<Vec<f64>> {
        let given = PyDict::new(py);
        for (name, column) in columns(inputs) {
            given.set_item(name, PyArray1::from_slice(py, &column))?;
        }
        let parameters = PyDict::new(py);
        for (name, value) in self.names.iter().zip(values) {
            parameters.set_item(name, value)?;
        }
        let answer = self.call.bind(py).call1((given, parameters)).and_then(|answer| numbers(&answer));
        answer.inspect_err(|error| {
            let shown: Vec<String> = self.names.iter().zip(values).map(|(name, value)| format!("{name} = {value}")).collect();
            let note = format!("truegap called the simulator with {}", shown.join(", "));
            // Python 3.10 has no notes: the exception is the same without
            let _ = error.value(py).call_method1("add_note", (note,));
        })
    }
}

/// The numbers that a function answered with: the Python half has made an array of them.
fn numbers(answer: &Bound<'_, PyAny>) -> PyResult<Vec<f64>> {
    Ok(answer.extract::<PyReadonlyArray1<'_, f64>>()?.as_array().to_vec())
}

/// Tells the server that the work has ended, however it ended.
struct AtEnd(Sender<Event>);

impl Drop for AtEnd {
    fn drop(&mut self) {
        let _ = self.0.send(Event::Done); // nobody waits where nobody hears it
    }
}

/// Does `work` in a thread of its own and serves it until it ends: questions to `function`, progress to `progress`, Ctrl-C to `stop`.
///
/// The first exception ends the work, and is what comes back.
pub(crate) fn serve<T: Send>(
    py: Python<'_>,
    function: Option<&PythonFunction>,
    progress: Option<&Py<PyAny>>,
    stop: &AtomicBool,
    work: impl FnOnce(&(dyn Fn(Progress) + Sync)) -> T + Send,
) -> PyResult<T> {
    if function.is_some_and(|f| f.desk.is_open()) {
        return Err(failed("the simulator is being asked already; wait until that has ended"));
    }
    let (events, incoming) = channel();
    function.inspect(|f| f.desk.open(Some(events.clone())));
    let incoming = Mutex::new(incoming);
    let (outcome, raised) = std::thread::scope(|scope| {
        let worker = scope.spawn(move || {
            let end = AtEnd(events);
            let told = Mutex::new(end.0.clone());
            work(&|p: Progress| {
                let event = Event::Progress { done: p.done, step: p.step.to_string(), what: p.what.to_string() };
                let _ = told.lock().unwrap_or_else(PoisonError::into_inner).send(event); // as above
            })
        });
        let raised = until_done(py, &incoming, function, progress, stop);
        (py.detach(|| worker.join()), raised)
    });
    function.inspect(|f| f.desk.open(None));
    match (raised, outcome) {
        (Some(error), _) => Err(error),
        (None, Ok(outcome)) => Ok(outcome),
        (None, Err(panic)) => std::panic::resume_unwind(panic),
    }
}

fn until_done(
    py: Python<'_>,
    incoming: &Mutex<Receiver<Event>>,
    function: Option<&PythonFunction>,
    progress: Option<&Py<PyAny>>,
    stop: &AtomicBool,
) -> Option<PyErr> {
    let mut raised = None;
    loop {
        let event = py.detach(|| incoming.lock().unwrap_or_else(PoisonError::into_inner).recv_timeout(LOOK));
        let done = match (event, function) {
            (Err(RecvTimeoutError::Timeout), _) => Ok(()),
            (Ok(Event::Done) | Err(RecvTimeoutError::Disconnected), _) => return raised,
            (Ok(Event::Question { values, inputs, reply }), Some(function)) if raised.is_none() => {
                let answer = function.answer(py, &values, &inputs);
                let given =
                    answer.as_ref().map(Clone::clone).map_err(|error| SimulationError::Program { says: error.to_string() });
                let _ = reply.send(given); // the work may have been given up
                answer.map(|_| ())
            }
            (Ok(Event::Question { reply, .. }), _) => {
                let _ = reply.send(Err(SimulationError::Program { says: "it was stopped".into() })); // as above
                Ok(())
            }
            (Ok(Event::Progress { done, step, what }), _) => match progress {
                Some(progress) if raised.is_none() => progress.call1(py, (done, step, what)).map(|_| ()),
                _ => Ok(()),
            },
        };
        if let Err(error) = done.and_then(|()| py.check_signals()) {
            stop.store(true, Ordering::Relaxed);
            raised.get_or_insert(error);
        }
    }
}
