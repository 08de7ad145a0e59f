//! The library of omitted physics: one file an effect, one line in [`library`].

use crate::effect::Effect;

mod thermal_lag;
mod viscoelastic_creep;

/// Every effect that a diagnosis tries, in the order of the chain.
pub fn library() -> Vec<Box<dyn Effect>> {
    vec![Box::new(thermal_lag::ThermalLag), Box::new(viscoelastic_creep::ViscoelasticCreep)]
}
