//! Which base model, with everything it needs to be built again without the recording: written beside a diagnosis.
//!
//! Limits: a sensor is named, not contained; the caller finds it.

use super::{
    constant::Constant,
    external::{External, ExternalOptions},
    gap_plate::GapPlate,
    parallel_plate::{Load, ParallelPlate},
    scale::{Recorded, ResponseScale, greatest},
};
use crate::stack::{SeriesOrder, Stack, StackOptions};
use serde::{Deserialize, Serialize};
use truegap_core::{Corrections, Inputs, Sensor, Simulator};

/// Temperature at which a model without a sensor file is described, degrees Celsius.
const REFERENCE_C: f64 = 20.0;

/// Names of the base models.
pub const BASE_MODELS: [&str; 5] = ["stack", "parallel-plate", "gap-plate", "constant", "external"];

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
    },
}

/// Why there is no base model.
#[derive(Clone, Debug, PartialEq, thiserror::Error)]
#[non_exhaustive]
pub enum BaseError {
    /// No such model.
    #[error("there is no base model `{name}`; use one of {}", BASE_MODELS.join(", "))]
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
    pub fn of(model: &str, sensor: Option<&str>, options: StackOptions, recorded: Recorded<'_>) -> Result<Self, BaseError> {
        let reference_c = REFERENCE_C;
        if model != "stack" && recorded.response.is_empty() {
            return Err(BaseError::Empty { model: model.to_owned() });
        }
        match model {
            "stack" => {
                let sensor = sensor.ok_or(BaseError::NoSensor)?.to_owned();
                Ok(Self::Stack { sensor, warp: options.warp, series: options.series })
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
                Ok(Self::External { scale: ResponseScale::of(recorded, None), reference_c, options: ExternalOptions::default() })
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
            Self::External { scale, reference_c, options } => Box::new(External::new(scale, *reference_c, *options)),
        })
    }
}

/// A base model by its name, scaled by a recording.
///
/// # Errors
/// [`BaseError`] as [`BaseModel::of`] and [`BaseModel::build`].
pub fn base_model(
    model: &str,
    sensor: Option<&Sensor>,
    options: StackOptions,
    recorded: Recorded<'_>,
) -> Result<Box<dyn Simulator>, BaseError> {
    BaseModel::of(model, sensor.map(|s| s.name.as_str()), options, recorded)?.build(sensor)
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
