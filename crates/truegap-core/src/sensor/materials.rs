//! Materials by name: those of the paper's Table 1, which a file may override key by key, and those of the file.
//!
//! Limits: Poisson's ratios of metals and polyimide are handbook values, used by finite elements only.

use super::{
    description::Material,
    error::{SensorError, SensorProblem},
    table::Table,
};
use crate::units::{Dimension, Measure};

/// A material as far as it is known.
#[derive(Clone, Copy, Debug, Default)]
struct Known {
    young: Option<Measure>,
    softening: Option<Measure>,
    poisson: Option<f64>,
    expansion: Option<f64>,
    permittivity: Option<f64>,
}

/// Built-in materials. Young's modulus, expansion and permittivity: [hampson2023] Table 1; silicone has no modulus there (Table 2 gives 0.7-1.5 MPa),
/// so a file must give it. Poisson's ratios except that of silicone: usual handbook values.
const BUILT_IN: [(&str, Known); 4] = [
    ("copper", metal(117e9, 0.34, 16.7e-6)),
    ("tin", metal(41.6e9, 0.36, 22.4e-6)),
    (
        "polyimide",
        Known {
            young: Some(Measure::exact(2.7e9)),
            softening: Some(Measure::exact(0.0)),
            poisson: Some(0.34),
            expansion: Some(20e-6),
            permittivity: Some(3.4),
        },
    ),
    (
        "silicone",
        Known {
            young: None,
            softening: Some(Measure::exact(7600.0)),
            poisson: Some(0.49),
            expansion: Some(200e-6),
            permittivity: Some(3.4),
        },
    ),
];

const fn metal(young: f64, poisson: f64, expansion: f64) -> Known {
    Known {
        young: Some(Measure::exact(young)),
        softening: Some(Measure::exact(0.0)),
        poisson: Some(poisson),
        expansion: Some(expansion),
        permittivity: Some(1.0),
    }
}

/// What can be looked up.
pub(super) struct Materials<'a> {
    file: Option<Table<'a>>,
}

impl<'a> Materials<'a> {
    /// Materials of a file's `[materials]`, all of them read so that a mistake in an unused one is found as well.
    pub(super) fn new(file: Option<Table<'a>>) -> Result<Self, SensorError> {
        let materials = Self { file };
        for name in materials.named() {
            materials.described(name)?;
        }
        Ok(materials)
    }

    fn named(&self) -> Vec<&'a str> {
        self.file.iter().flat_map(Table::names).map(|(name, _)| name).collect()
    }

    /// A material; `user` and `at` say who asks for it.
    pub(super) fn get(&self, name: &str, user: &Table<'_>, at: usize) -> Result<Material, SensorError> {
        let built_in = BUILT_IN.iter().any(|(known, _)| *known == name);
        if !built_in && !self.named().contains(&name) {
            let mut known: Vec<_> = BUILT_IN.iter().map(|(name, _)| *name).collect();
            known.extend(self.named());
            let problem = SensorProblem::UnknownMaterial { name: name.to_owned(), known: known.join(", ") };
            return Err(user.source.error(at, &user.dotted("material"), problem));
        }
        let known = self.described(name)?;
        let lacking = |key: &str, example: &str| {
            let problem = SensorProblem::Missing { example: format!("{key} = {example}") };
            user.source.error(at, &format!("materials.{name}.{key}"), problem)
        };
        Ok(Material {
            name: name.to_owned(),
            young: known.young.ok_or_else(|| lacking("young", "\"1.1 MPa +- 5 %\""))?,
            softening: known.softening.unwrap_or(Measure::exact(0.0)),
            poisson: known.poisson.ok_or_else(|| lacking("poisson", "0.49"))?,
            expansion: known.expansion.ok_or_else(|| lacking("expansion", "\"200 ppm/K\""))?,
            permittivity: known.permittivity.unwrap_or(1.0),
        })
    }

    /// Built-in values with those of the file over them.
    fn described(&self, name: &str) -> Result<Known, SensorError> {
        let base = BUILT_IN.iter().find(|(known, _)| *known == name).map(|(_, known)| *known).unwrap_or_default();
        let Some(table) = self.file.as_ref().map(|file| file.named(name)).transpose()?.flatten() else { return Ok(base) };
        let known = Known {
            young: table.measure("young", Dimension::Pressure)?.or(base.young),
            softening: table.measure("softening", Dimension::PressurePerKelvin)?.or(base.softening),
            poisson: table.number("poisson", Dimension::Ratio)?.or(base.poisson),
            expansion: table.measure("expansion", Dimension::PerKelvin)?.map(|m| m.value).or(base.expansion),
            permittivity: table.number("permittivity", Dimension::Ratio)?.or(base.permittivity),
        };
        table.finish()?;
        Ok(known)
    }
}
