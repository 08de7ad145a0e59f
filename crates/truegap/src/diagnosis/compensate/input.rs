//! The input that a base model follows, which a sensor in use does not know.
//!
//! Limits: one column; a second axis of a table is taken to be known.

use truegap_core::{Driver, Inputs, Role, Simulator};
use truegap_diagnose::compensation::Span;
use truegap_model::{BaseModel, Followed};

/// A column of inputs.
#[derive(Clone, Debug, PartialEq, Eq)]
pub(super) enum Column {
    /// with a role of its own
    Of(Role),
    /// under `[drivers]`
    Driver(String),
}

/// The column to be estimated.
pub(super) struct Sought {
    pub column: Column,
    pub span: Span,
    /// whether the base model is a straight line in it
    pub straight: bool,
}

/// How a base model gets its input.
pub(super) enum Way {
    /// it follows what is known anyway, or nothing
    Known,
    /// from the reading
    Estimated(Sought),
    /// its answer at a row may depend on other rows: the input has to be recorded
    Recorded,
}

impl Way {
    pub fn of(base: &BaseModel, simulator: &dyn Simulator) -> Self {
        let sought = |column, zero, width| Sought { column, span: Span { zero, width, ends: false }, straight: false };
        Self::Estimated(match base {
            BaseModel::Command { .. } | BaseModel::Function { .. } => return Self::Recorded,
            BaseModel::Constant { .. } => return Self::Known,
            BaseModel::Linear { driver: Followed::Column(driver), .. } if driver.role == Role::Time => return Self::Known,
            BaseModel::Stack { .. } => sought(Column::Of(Role::Force), 0.0, simulator.full_load().unwrap_or(1.0)),
            BaseModel::ParallelPlate { load, full_load, .. } => sought(Column::Of(load.role()), 0.0, *full_load),
            BaseModel::GapPlate { scale, .. } => sought(Column::Of(Role::Gap), scale.gaps_m.0, scale.gaps_m.1 - scale.gaps_m.0),
            BaseModel::External { scale, .. } => {
                let range = scale.range;
                Sought { straight: true, ..sought(Column::Of(Role::Simulated), scale.centre - 0.5 * range, range) }
            }
            BaseModel::Linear { driver, order, .. } => {
                let (column, zero, width) = match driver {
                    Followed::Column(driver) => (Column::Of(driver.role), driver.zero, driver.width),
                    Followed::Named(driver) => (Column::Driver(driver.name.clone()), driver.zero, driver.width),
                };
                Sought { straight: *order == 1, ..sought(column, zero, width) }
            }
            BaseModel::Table { grid, .. } => {
                let first = |roles: &[Role]| grid.axes.iter().find(|axis| roles.contains(&axis.role));
                let axis = first(&[Role::Force, Role::Pressure, Role::Gap]).or(grid.axes.first());
                let Some(axis) = axis.filter(|axis| axis.role != Role::Time) else { return Self::Known };
                let (low, high) = axis.ends();
                let found = sought(Column::Of(axis.role), low, high - low);
                Sought { span: Span { ends: true, ..found.span }, ..found }
            }
        })
    }
}

impl Column {
    pub fn values<'a>(&self, inputs: &'a Inputs) -> Option<&'a [f64]> {
        match self {
            Self::Of(role) => inputs.column(*role),
            Self::Driver(name) => inputs.drivers.iter().find(|driver| driver.name == *name).map(|d| d.values.as_slice()),
        }
    }

    /// Puts values in its place, or takes them away.
    pub fn put(&self, inputs: &mut Inputs, values: Option<Vec<f64>>) {
        match (self, values) {
            (Self::Of(role), values) => {
                if let Some(place) = inputs.column_mut(*role) {
                    *place = values;
                }
            }
            (Self::Driver(name), None) => inputs.drivers.retain(|driver| driver.name != *name),
            (Self::Driver(name), Some(values)) => match inputs.drivers.iter_mut().find(|driver| driver.name == *name) {
                Some(driver) => driver.values = values,
                None => inputs.drivers.push(Driver { name: name.clone(), unit: "1".into(), values }),
            },
        }
    }

    /// As a recording calls it.
    pub fn name(&self) -> String {
        match self {
            Self::Of(role) => role.key().into(),
            Self::Driver(name) => name.clone(),
        }
    }

    /// How a user names it on the command line.
    pub fn map(&self) -> String {
        match self {
            Self::Of(role) => format!("--map {}=COLUMN", role.key()),
            Self::Driver(name) => format!("--map driver.{name}=COLUMN:UNIT"),
        }
    }

    /// Its unit, where one is known.
    pub fn unit(&self, simulator: &dyn Simulator) -> String {
        match self {
            Self::Of(Role::Simulated) => simulator.simulated_unit().into(),
            Self::Of(role) => role.unit().into(),
            Self::Driver(_) => String::new(),
        }
    }

    /// Name of the column that holds its estimate.
    pub fn estimate(&self) -> String {
        let name = if let Self::Of(role) = self { role.column_name() } else { &self.name() };
        format!("estimated_{name}")
    }
}
