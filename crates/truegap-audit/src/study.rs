//! A sensor under audit: its analytic chain, the range, and finite-element results that several assumptions share.
//!
//! Limits: one sensor; shared results live as long as the study.

use crate::{
    effect::{Corners, EffectOn, coefficients_of},
    error::AuditError,
    swap::{Chain, Swap},
};
use std::{
    any::{Any, TypeId},
    collections::HashMap,
    sync::{Arc, Mutex, OnceLock, PoisonError, atomic::AtomicBool, atomic::Ordering},
};
use truegap_core::Sensor;
use truegap_model::{Coefficients, StackOptions, stack::Device};

/// Range and accuracy of an audit.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Options {
    /// lower temperature, degrees Celsius
    pub cold_c: f64,
    /// upper temperature, degrees Celsius
    pub hot_c: f64,
    /// relative error wanted of finite-element goals
    pub target: f64,
    /// what the analytic model takes to be true
    pub stack: StackOptions,
}

impl Default for Options {
    fn default() -> Self {
        Self { cold_c: 20.0, hot_c: 50.0, target: 2e-4, stack: StackOptions::default() }
    }
}

/// What an audit reports while it runs.
#[derive(Clone, Debug, PartialEq)]
pub struct Progress {
    /// assumption at work
    pub id: &'static str,
    /// what is being done, as a clause
    pub says: String,
    /// assumptions finished
    pub done: usize,
    /// assumptions in all
    pub total: usize,
}

/// Who watches an audit: progress out, a wish to stop in.
#[derive(Default)]
pub struct Watch<'a> {
    /// called with every step, from any thread
    pub progress: Option<&'a (dyn Fn(&Progress) + Sync)>,
    /// set to stop
    pub cancel: Option<&'a AtomicBool>,
}

impl Watch<'_> {
    /// Whether the caller wants to stop.
    pub(crate) fn stopped(&self) -> bool {
        self.cancel.is_some_and(|flag| flag.load(Ordering::Relaxed))
    }

    /// Tells the caller.
    pub fn tell(&self, progress: &Progress) {
        if let Some(tell) = self.progress {
            tell(progress);
        }
    }
}

type Slot = Arc<OnceLock<Result<Arc<dyn Any + Send + Sync>, AuditError>>>;

/// A sensor under audit.
pub struct Study<'a> {
    /// the sensor
    pub sensor: &'a Sensor,
    /// its analytic chain
    pub device: Device,
    /// range and accuracy
    pub options: Options,
    watch: &'a Watch<'a>,
    base: Coefficients,
    shared: Mutex<HashMap<TypeId, Slot>>,
}

impl<'a> Study<'a> {
    /// Prepares a sensor.
    ///
    /// # Errors
    /// [`AuditError::NoResponse`] where the analytic model has no answer between no and full load at the two temperatures.
    pub fn new(sensor: &'a Sensor, options: Options, watch: &'a Watch<'a>) -> Result<Self, AuditError> {
        let device = Device::new(sensor, options.stack);
        let corners = corners(sensor, options);
        let base = {
            let chain = Chain { device: &device, swap: Swap::none() };
            coefficients_of(&|force, temperature| chain.capacitance_pf(force, temperature), corners)?
        };
        Ok(Self { sensor, device, options, watch, base, shared: Mutex::default() })
    }

    /// Coefficients of the analytic model.
    pub fn base(&self) -> &Coefficients {
        &self.base
    }

    /// No and full load, cold and hot.
    pub fn corners(&self) -> Corners {
        corners(self.sensor, self.options)
    }

    /// Full load, N.
    pub(crate) fn full_n(&self) -> f64 {
        self.sensor.full_scale
    }

    /// Kelvins from the sensor's reference temperature to the hot one.
    pub(crate) fn hot_kelvin(&self) -> f64 {
        self.options.hot_c - self.sensor.reference_c
    }

    /// The analytic chain with pieces replaced.
    pub fn chain<'s>(&'s self, swap: Swap<'s>) -> Chain<'s> {
        Chain { device: &self.device, swap }
    }

    /// Coefficients with pieces replaced.
    ///
    /// # Errors
    /// What the replacements refuse.
    pub fn coefficients<'s>(&'s self, swap: Swap<'s>) -> Result<Coefficients, AuditError> {
        let chain = self.chain(swap);
        coefficients_of(&|force, temperature| chain.capacitance_pf(force, temperature), self.corners())
    }

    /// What the replacements do to the coefficients.
    ///
    /// # Errors
    /// What the replacements refuse.
    pub fn effect<'s>(&'s self, swap: Swap<'s>) -> Result<EffectOn, AuditError> {
        Ok(EffectOn::between(&self.base, &self.coefficients(swap)?))
    }

    /// A result of its own type that several assumptions use: computed by whoever comes first, the others wait.
    ///
    /// `make` must not ask for the same type again.
    ///
    /// # Errors
    /// What `make` refuses, to every asker.
    pub fn shared<T: Send + Sync + 'static>(
        &self,
        make: impl FnOnce(&Self) -> Result<T, AuditError>,
    ) -> Result<Arc<T>, AuditError> {
        let slot = {
            let mut slots = self.shared.lock().unwrap_or_else(PoisonError::into_inner);
            Arc::clone(slots.entry(TypeId::of::<T>()).or_default())
        };
        let made = slot.get_or_init(|| make(self).map(|value| Arc::new(value) as Arc<dyn Any + Send + Sync>));
        match made.clone()?.downcast::<T>() {
            Ok(value) => Ok(value),
            // the slot's key is the type, so this cannot happen; an error all the same
            Err(_) => Err(AuditError::Lacks { sensor: self.sensor.name.clone(), part: "result of the type asked for" }),
        }
    }

    /// Stops here if the caller wants to; call it between solves.
    ///
    /// # Errors
    /// [`AuditError::Cancelled`].
    pub(crate) fn keep_going(&self) -> Result<(), AuditError> {
        if self.watch.stopped() { Err(AuditError::Cancelled) } else { Ok(()) }
    }
}

fn corners(sensor: &Sensor, options: Options) -> Corners {
    Corners { cold_c: options.cold_c, hot_c: options.hot_c, full_n: sensor.full_scale }
}
