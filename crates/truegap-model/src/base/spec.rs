//! Which base model, with everything it needs to be built again without the recording: written beside a diagnosis.
//!
//! Limits: a sensor is named, not contained; the caller finds it.

use super::{
    black_box::{BlackBox, BlackBoxFacts, Responder},
    constant::Constant,
    driver::{DRIVERS, Driver, Followed, NamedDriver},
    external::{External, ExternalOptions},
    gap_plate::GapPlate,
    grid::Grid,
    linear::{HIGHEST_ORDER, Linear},
    options::{Asked, BaseOptions, Who},
    parallel_plate::{Load, ParallelPlate},
    scale::{Recorded, ResponseScale, greatest},
    surface::Surface,
    table::Table,
};
use crate::stack::{SeriesOrder, Stack, StackOptions};
use serde::{Deserialize, Serialize};
use std::{path::PathBuf, sync::Arc};
use truegap_core::nearest::meant;
use truegap_core::{Corrections, Inputs, Role, Sensor, SimulationError, Simulator};

/// Temperature at which a model without a sensor file is described, degrees Celsius.
const REFERENCE_C: f64 = 20.0;

/// Names of the base models that are built from a file alone. Beside them there are `command`, which a program answers, and `function`, which the program that
/// called answers.
pub const BASE_MODELS: [&str; 7] = ["stack", "parallel-plate", "gap-plate", "linear", "table", "constant", "external"];

/// A base model with its options.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
#[serde(tag = "model", rename_all = "kebab-case")]
pub enum BaseModel {
    /// the paper's sensor
    Stack {
        /// name or file of the sensor
        sensor: String,
        /// whether the base model warps
        warp: bool,
        /// order of (19) and (21)
        #[serde(default)]
        series: SeriesOrder,
    },
    /// (2)
    ParallelPlate {
        /// column of the load
        load: Load,
        /// full load, SI
        full_load: f64,
        /// scale of the priors
        scale: ResponseScale,
        /// reference temperature, degrees Celsius
        reference_c: f64,
    },
    /// (1)
    GapPlate {
        /// scale of the priors
        scale: ResponseScale,
        /// reference temperature, degrees Celsius
        reference_c: f64,
    },
    /// a value that should not move
    Constant {
        /// scale of the priors
        scale: ResponseScale,
        /// reference temperature, degrees Celsius
        reference_c: f64,
    },
    /// a simulated column
    External {
        /// scale of the priors
        scale: ResponseScale,
        /// reference temperature, degrees Celsius
        reference_c: f64,
        /// what may be adjusted
        #[serde(default)]
        options: ExternalOptions,
        /// how it follows load and temperature, where it does
        #[serde(default, skip_serializing_if = "Option::is_none")]
        surface: Option<Surface>,
    },
    /// a polynomial in one column
    Linear {
        /// scale of the priors
        scale: ResponseScale,
        /// reference temperature, degrees Celsius
        reference_c: f64,
        /// what drives it
        driver: Followed,
        /// order of the polynomial
        order: usize,
    },
    /// a curve or a field of values
    Table {
        /// scale of the priors
        scale: ResponseScale,
        /// reference temperature, degrees Celsius
        reference_c: f64,
        /// what may be adjusted
        #[serde(default)]
        options: ExternalOptions,
        /// the values
        grid: Grid,
    },
    /// a program that stays up and answers
    Command {
        /// program and arguments
        run: Vec<String>,
        /// folder in which it is started
        folder: PathBuf,
        /// longest time that an answer may take, s
        timeout_s: f64,
        /// what is known of it
        simulator: BlackBoxFacts,
    },
    /// a function of the program that called
    Function {
        /// its name
        name: String,
        /// what is known of it
        simulator: BlackBoxFacts,
    },
}

/// What a misspelt name may have meant, as the middle of a message.
fn near(name: &str) -> String {
    let names: Vec<&str> = BASE_MODELS.into_iter().chain(["command"]).collect();
    meant(name, &names).map_or_else(String::new, |near| format!("did you mean `{near}`? "))
}

/// Why there is no base model.
#[derive(Clone, Debug, PartialEq, thiserror::Error)]
#[non_exhaustive]
pub enum BaseError {
    /// No such model.
    #[error("there is no base model `{name}`; {}use one of {}, command", near(name), BASE_MODELS.join(", "))]
    Unknown {
        /// the name
        name: String,
    },
    /// The stack needs a sensor.
    #[error("the base model `stack` needs a sensor; name a built-in one or a sensor file as `sensor` under [base]")]
    NoSensor,
    /// A column without which the model cannot be scaled.
    #[error(
        "the base model `{model}` needs a column `{role}` with at least one positive value; name it under [columns] or choose another [base] model"
    )]
    NoColumn {
        /// model
        model: &'static str,
        /// what is missing
        role: &'static str,
    },
    /// A line without anything that drives it.
    #[error(
        "the base model `linear` needs {}; name it under [columns], or another one as driver = \"...\" under [base]",
        .driver.as_ref().map_or("a recorded column that moves (force, pressure, gap, temperature, humidity, time, or one under [drivers])".to_owned(), |name| format!("a column for {name} that moves"))
    )]
    NoDriver {
        /// the driver asked for
        driver: Option<String>,
    },
    /// A polynomial of an order that is none.
    #[error("the base model `linear` has an order from 1 to {HIGHEST_ORDER}, not {order}; for a richer curve give a table")]
    Order {
        /// the order asked for
        order: usize,
    },
    /// A table base without a table.
    #[error("the base model `table` needs a CSV; name it as table = \"curve.csv\" under [base] of the recording's TOML")]
    NoTable,
    /// A table in another unit.
    #[error("the table is in {table}, the response in {response}; convert one")]
    TableUnit {
        /// unit of the table
        table: String,
        /// unit of the response
        response: String,
    },
    /// A recorded row that the table does not hold.
    #[error("{}", outside(.source))]
    Outside {
        /// which row, and what of it
        source: SimulationError,
    },
    /// A command or a function without anybody to ask.
    #[error("the base model `{model}` needs {}", if *.model == "command" { "a program; name it as run = [\"python3\", \"sim.py\"] under [base] (docs/command-base.md)" } else { "the function itself; only a program that has it can run this model, as Python does with base=f (docs/python.md)" })]
    NobodyToAsk {
        /// the model
        model: &'static str,
    },
    /// A number that cannot be.
    #[error("the base model cannot be: {what}; write {wanted}")]
    Impossible {
        /// the number, under its key
        what: String,
        /// what may stand there
        wanted: &'static str,
    },
    /// No rows.
    #[error("the recording has no rows, so the base model `{model}` cannot be scaled; give at least two rows")]
    Empty {
        /// model
        model: String,
    },
}

impl BaseModel {
    /// The base model `model` for a recording, priors scaled by it; `sensor` and `options` matter to `stack` only.
    ///
    /// # Errors
    /// [`BaseError`] where the model is unknown or the recording lacks what it needs.
    pub fn of(
        model: &str,
        sensor: Option<&str>,
        options: impl Into<BaseOptions>,
        recorded: Recorded<'_>,
    ) -> Result<Self, BaseError> {
        let options = options.into();
        let reference_c = REFERENCE_C;
        if model != "stack" && recorded.response.is_empty() {
            return Err(BaseError::Empty { model: model.to_owned() });
        }
        match model {
            "stack" => {
                let sensor = sensor.ok_or(BaseError::NoSensor)?.to_owned();
                Ok(Self::Stack { sensor, warp: options.stack.warp, series: options.stack.series })
            }
            "parallel-plate" => {
                let (load, full_load) = loading(recorded.inputs)?;
                let scale = ResponseScale::of(recorded, load.column(recorded.inputs).map(|column| (column, full_load)));
                Ok(Self::ParallelPlate { load, full_load, scale, reference_c })
            }
            "gap-plate" => {
                let missing = BaseError::NoColumn { model: "gap-plate", role: "gap" };
                recorded.inputs.gap_m.as_ref().filter(|gaps| greatest(gaps) > 0.0).ok_or(missing)?;
                Ok(Self::GapPlate { scale: ResponseScale::of(recorded, None), reference_c })
            }
            "constant" => Ok(Self::Constant { scale: ResponseScale::of(recorded, None), reference_c }),
            "external" => {
                let missing = BaseError::NoColumn { model: "external", role: "simulated" };
                recorded.inputs.simulated.as_ref().ok_or(missing)?;
                Ok(Self::External {
                    scale: ResponseScale::of(recorded, None),
                    reference_c,
                    options: options.adjusted,
                    surface: Surface::of(recorded.inputs),
                })
            }
            "linear" => linear(&options, recorded, reference_c),
            "table" => table(options, recorded, reference_c),
            "command" | "function" => {
                asked(options.asked, recorded, reference_c, if model == "command" { "command" } else { "function" })
            }
            other => Err(BaseError::Unknown { name: other.to_owned() }),
        }
    }

    /// Name of the sensor, where there is one.
    pub fn sensor(&self) -> Option<&str> {
        match self {
            Self::Stack { sensor, .. } => Some(sensor),
            _ => None,
        }
    }

    /// The model itself; `sensor` is what [`BaseModel::sensor`] names.
    ///
    /// # Errors
    /// [`BaseError::NoSensor`] where the stack is given none.
    pub fn build(&self, sensor: Option<&Sensor>) -> Result<Box<dyn Simulator>, BaseError> {
        self.informed(sensor, None)
    }

    /// As [`BaseModel::build`], with what finite elements say of the sensor.
    ///
    /// # Errors
    /// As [`BaseModel::build`].
    pub fn informed(&self, sensor: Option<&Sensor>, corrections: Option<Corrections>) -> Result<Box<dyn Simulator>, BaseError> {
        Ok(match self {
            Self::Stack { warp, series, .. } => {
                let options = StackOptions { warp: *warp, series: *series };
                Box::new(Stack::new(sensor.ok_or(BaseError::NoSensor)?, options).informed(corrections))
            }
            Self::ParallelPlate { load, full_load, scale, reference_c } => {
                Box::new(ParallelPlate::new(*load, *full_load, scale, *reference_c))
            }
            Self::GapPlate { scale, reference_c } => Box::new(GapPlate::new(scale, *reference_c)),
            Self::Constant { scale, reference_c } => Box::new(Constant::new(scale, *reference_c)),
            Self::External { scale, reference_c, options, surface } => {
                Box::new(External::new(scale, *reference_c, options.clone()).following(surface.clone()))
            }
            Self::Linear { scale, reference_c, driver, order } => {
                Box::new(Linear::new(driver.clone(), *order, scale, *reference_c))
            }
            Self::Table { scale, reference_c, options, grid } => {
                Box::new(Table::new(grid.clone(), scale, *reference_c, options.clone()))
            }
            Self::Command { .. } => return Err(BaseError::NobodyToAsk { model: "command" }),
            Self::Function { .. } => return Err(BaseError::NobodyToAsk { model: "function" }),
        })
    }

    /// The model itself, where it is one that somebody else answers; `None` for every other.
    pub fn answered_by(&self, responder: &Arc<dyn Responder>) -> Option<BlackBox> {
        match self {
            Self::Command { simulator, .. } => Some(BlackBox::new("command", simulator.clone(), responder.clone())),
            Self::Function { simulator, .. } => Some(BlackBox::new("function", simulator.clone(), responder.clone())),
            _ => None,
        }
    }
}

/// A base model by its name, scaled by a recording.
///
/// # Errors
/// [`BaseError`] as [`BaseModel::of`] and [`BaseModel::build`].
pub fn base_model(
    model: &str,
    sensor: Option<&Sensor>,
    options: impl Into<BaseOptions>,
    recorded: Recorded<'_>,
) -> Result<Box<dyn Simulator>, BaseError> {
    BaseModel::of(model, sensor.map(|s| s.name.as_str()), options, recorded)?.build(sensor)
}

fn asked(asked: Option<Asked>, recorded: Recorded<'_>, reference_c: f64, model: &'static str) -> Result<BaseModel, BaseError> {
    let Asked { who, parameters, inside } = asked.ok_or(BaseError::NobodyToAsk { model })?;
    let load = [Role::Force, Role::Pressure].into_iter().find_map(|role| Driver::of(recorded.inputs, role));
    let simulator = BlackBoxFacts { unit: recorded.unit.to_owned(), parameters, load, reference_c, inside };
    Ok(match who {
        Who::Command { run, folder, timeout_s } => BaseModel::Command { run, folder, timeout_s, simulator },
        Who::Function { name } => BaseModel::Function { name, simulator },
    })
}

fn linear(options: &BaseOptions, recorded: Recorded<'_>, reference_c: f64) -> Result<BaseModel, BaseError> {
    let order = options.order.unwrap_or(1);
    if !(1..=HIGHEST_ORDER).contains(&order) {
        return Err(BaseError::Order { order });
    }
    let role_name = options.driver.map(|role| role.key().to_owned());
    let missing = || BaseError::NoDriver { driver: options.named_driver.clone().or(role_name.clone()) };
    let column = |role| Driver::of(recorded.inputs, role).map(Followed::Column);
    let named = |name| NamedDriver::of(recorded.inputs, name).map(Followed::Named);
    let driver = match (&options.named_driver, options.driver) {
        (Some(name), _) => named(Some(name.as_str())),
        (None, Some(role)) => column(role),
        // the clock moves in every recording: it drives where nothing else does
        (None, None) => {
            let recorded = DRIVERS.into_iter().filter(|role| *role != Role::Time).find_map(column);
            recorded.or_else(|| named(None)).or_else(|| column(Role::Time))
        }
    };
    let driver = driver.ok_or_else(missing)?;
    let column = driver.recorded(recorded.inputs, "linear").map_err(|_| missing())?;
    Ok(BaseModel::Linear { scale: ResponseScale::of(recorded, Some((&column, 1.0))), reference_c, driver, order })
}

fn table(options: BaseOptions, recorded: Recorded<'_>, reference_c: f64) -> Result<BaseModel, BaseError> {
    let grid = options.table.ok_or(BaseError::NoTable)?;
    if grid.unit != recorded.unit {
        return Err(BaseError::TableUnit { table: grid.unit, response: recorded.unit.to_owned() });
    }
    grid.holds(recorded.inputs).map_err(|source| BaseError::Outside { source })?;
    Ok(BaseModel::Table { scale: ResponseScale::of(recorded, None), reference_c, options: options.adjusted, grid })
}

/// The sentence of a row outside a table, rows counted from 1.
fn outside(source: &SimulationError) -> String {
    match source {
        SimulationError::OutsideTable { row, role, value, low, high } => format!(
            "row {}: {} is {value:.6e} (SI), outside the table, which goes from {low:.6e} to {high:.6e}; extend the table, or leave the row out",
            row + 1,
            role.key()
        ),
        other => other.to_string(),
    }
}

/// Column of the load, pressure before force, and its greatest value.
fn loading(inputs: &Inputs) -> Result<(Load, f64), BaseError> {
    let usable = |load: Load| {
        let full = greatest(load.column(inputs)?);
        (full > 0.0).then_some((load, full))
    };
    usable(Load::Pressure)
        .or_else(|| usable(Load::Force))
        .ok_or(BaseError::NoColumn { model: "parallel-plate", role: "pressure or force" })
}
