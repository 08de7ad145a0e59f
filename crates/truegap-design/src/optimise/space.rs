//! The space of designs: continuous ranges, levels that can be bought, whole numbers.
//!
//! Limits: axes are independent; what they exclude together is for the constraints to say.

use crate::{error::DesignError, quantity::Quantity};
use serde::{Deserialize, Serialize};
use truegap_core::{Sensor, sensor::Filling};

/// What one axis may be, SI.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
#[serde(rename_all = "snake_case")]
pub enum Choice {
    /// anything from the first to the second
    Continuous(f64, f64),
    /// one of these
    Levels(Vec<f64>),
    /// a whole number from the first to the second, both included
    Whole(u32, u32),
}

/// A quantity and what it may be.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
pub struct Axis {
    /// the quantity
    pub quantity: Quantity,
    /// its values
    pub choice: Choice,
}

impl Axis {
    /// Value at a coordinate between 0 and 1.
    fn value(&self, unit: f64) -> f64 {
        let step = |count: usize| ((unit * count as f64) as usize).min(count - 1);
        match &self.choice {
            Choice::Continuous(low, high) => low + unit * (high - low),
            Choice::Levels(levels) => levels[step(levels.len())],
            Choice::Whole(low, high) => f64::from(*low) + step((high - low + 1) as usize) as f64,
        }
    }

    fn check(&self) -> Result<(), DesignError> {
        let quantity = self.quantity;
        let (low, high) = match &self.choice {
            Choice::Continuous(low, high) => (*low, *high),
            Choice::Whole(low, high) => (f64::from(*low), f64::from(*high) + 0.5),
            Choice::Levels(levels) if levels.is_empty() => return Err(DesignError::NoLevel { quantity }),
            Choice::Levels(_) => return Ok(()),
        };
        if low > 0.0 && low < high && high.is_finite() { Ok(()) } else { Err(DesignError::EmptyRange { quantity, low, high }) }
    }
}

/// A sensor with axes along which it may change.
#[derive(Clone, Debug)]
pub struct Space {
    base: Sensor,
    axes: Vec<Axis>,
}

impl Space {
    /// A space around a sensor.
    ///
    /// # Errors
    /// [`DesignError::EmptyRange`], [`DesignError::NoLevel`], [`DesignError::NoAxis`], [`DesignError::NoSuchPart`].
    pub fn new(base: Sensor, axes: Vec<Axis>) -> Result<Self, DesignError> {
        axes.iter().try_for_each(Axis::check)?;
        if axes.is_empty() {
            return Err(DesignError::NoAxis);
        }
        if let Some(axis) = axes.iter().find(|axis| axis.quantity.of(&base).is_none()) {
            return Err(DesignError::NoSuchPart { sensor: base.name, quantity: axis.quantity });
        }
        Ok(Self { base, axes })
    }

    /// The axes of the paper's Table 2, with foils that can be bought inside its ranges (copper of 0.3, 0.5 and 1 oz/ft²; tin 0, 5, 9 um; polyimide 10,
    /// 25, 50, 75 um).
    ///
    /// **Source:** [hampson2023] Table 2 for the ranges; the levels inside them are ours, the paper does not list them.
    fn paper_axes() -> Vec<Axis> {
        let um = |levels: &[f64]| Choice::Levels(levels.iter().map(|l| l * 1e-6).collect());
        let axes = [
            (Quantity::Young, Choice::Continuous(0.7e6, 1.5e6)),
            (Quantity::Height, Choice::Continuous(150e-6, 210e-6)),
            (Quantity::Conductor, um(&[10.0, 17.0, 34.0])),
            (Quantity::Plating, um(&[0.0, 5.0, 9.0])),
            (Quantity::Insulator, um(&[10.0, 25.0, 50.0, 75.0])),
            (Quantity::BeadDiameter, Choice::Continuous(300e-6, 760e-6)),
            (Quantity::BeadCount, Choice::Whole(50, 97)),
            (Quantity::Diameter, Choice::Continuous(6e-3, 15e-3)),
        ];
        axes.map(|(quantity, choice)| Axis { quantity, choice }).to_vec()
    }

    /// The paper's space around a sensor; parts that the sensor has not are no axes.
    ///
    /// # Errors
    /// [`DesignError::NoAxis`].
    pub fn paper(base: Sensor) -> Result<Self, DesignError> {
        let axes = Self::paper_axes().into_iter().filter(|axis| axis.quantity.of(&base).is_some()).collect();
        Self::new(base, axes)
    }

    /// The axes.
    pub fn axes(&self) -> &[Axis] {
        &self.axes
    }

    /// The sensor that the space was made around.
    pub fn base(&self) -> &Sensor {
        &self.base
    }

    /// Values at a point of the unit cube, SI, in the order of the axes.
    pub fn values(&self, unit: &[f64]) -> Vec<f64> {
        self.axes.iter().zip(unit).map(|(axis, &u)| axis.value(u)).collect()
    }

    /// The sensor with these values.
    pub fn sensor(&self, values: &[f64]) -> Sensor {
        let mut sensor = self.base.clone();
        for (axis, &value) in self.axes.iter().zip(values) {
            match (&mut sensor.dielectric.filling, axis.quantity) {
                (Filling::Beads { count, .. }, Quantity::BeadCount) => *count = value.round() as u32,
                _ => axis.quantity.set(&mut sensor, value),
            }
        }
        sensor
    }
}
