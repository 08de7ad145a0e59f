//! The native half of the Python package `truegap`: arrays and texts in, arrays and JSON out; everything a person sees is written in Python.
//!
//! Limits: no physics and no files of its own; one scalar response, as everywhere.

mod ask;
mod desk;
mod diagnosis;
mod source;
mod study;

use pyo3::prelude::*;

/// Native half of the package `truegap`; use the package itself.
#[pymodule]
fn _truegap(module: &Bound<'_, PyModule>) -> PyResult<()> {
    module.add("__version__", env!("CARGO_PKG_VERSION"))?;
    module.add("TruegapError", module.py().get_type::<source::TruegapError>())?;
    module.add_class::<diagnosis::NativeDiagnosis>()?;
    module.add_function(wrap_pyfunction!(diagnosis::diagnose, module)?)?;
    module.add_function(wrap_pyfunction!(diagnosis::confirm, module)?)?;
    module.add_function(wrap_pyfunction!(source::read_columns, module)?)?;
    module.add_function(wrap_pyfunction!(source::read_dates, module)?)?;
    module.add_function(wrap_pyfunction!(ask::simulate, module)?)?;
    module.add_function(wrap_pyfunction!(ask::coefficients, module)?)?;
    module.add_function(wrap_pyfunction!(ask::audit, module)?)?;
    module.add_function(wrap_pyfunction!(ask::sensors, module)?)?;
    module.add_function(wrap_pyfunction!(ask::explain, module)?)?;
    module.add_function(wrap_pyfunction!(study::solve, module)?)?;
    module.add_function(wrap_pyfunction!(study::sensitivity, module)?)?;
    module.add_function(wrap_pyfunction!(study::tolerance, module)?)?;
    module.add_function(wrap_pyfunction!(study::optimise, module)?)
}
