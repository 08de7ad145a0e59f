//! The numbers of a model file in the units in which the model takes them: converted where the two are of one kind, refused elsewhere.
//!
//! Limits: a unit that depends on what was recorded, as that of a driver, is not known to the file and is not looked at.

use super::model_file::ModelFile;
use super::model_file_error::ModelFileError;
use truegap_core::{Dimension, Driver, Inputs, Simulator};
use truegap_diagnose::answer::{AddedEffect, NamedValue};
use truegap_diagnose::{Augmented, Context, Effect};

/// Kinds of units of which one is so many times another. `K` and `degC` are none: a difference is not a point of the scale.
const CONVERTED: [Dimension; 9] = [
    Dimension::Time,
    Dimension::Ratio,
    Dimension::PerKelvin,
    Dimension::Capacitance,
    Dimension::Length,
    Dimension::Force,
    Dimension::Pressure,
    Dimension::PressurePerKelvin,
    Dimension::Voltage,
];

/// Unit of a driver of which nobody knows it.
const UNKNOWN: &str = "...";

/// A number of `of` in the unit `wanted`; one that has no unit beside it is in that.
///
/// # Errors
/// [`ModelFileError::NumberUnit`] where its own unit is of another kind.
pub(super) fn in_unit(of: &str, given: &NamedValue, wanted: &str) -> Result<NamedValue, ModelFileError> {
    let told = if given.unit.trim().is_empty() { wanted } else { &given.unit };
    let Some(factor) = factor(told, wanted) else {
        let (name, found) = (given.name.clone(), given.unit.clone());
        return Err(ModelFileError::NumberUnit { of: of.to_owned(), name, value: given.value, found, wanted: wanted.to_owned() });
    };
    if factor == 1.0 {
        return Ok(given.clone());
    }
    let (value, sd) = (factor * given.value, factor * given.sd);
    Ok(NamedValue { name: given.name.clone(), unit: wanted.to_owned(), value, sd })
}

/// How many `wanted` one `found` is.
fn factor(found: &str, wanted: &str) -> Option<f64> {
    let (found, wanted) = (plain(found), plain(wanted));
    if found == wanted {
        return Some(1.0);
    }
    CONVERTED.into_iter().find_map(|dimension| {
        let [one, other] = [&found, &wanted].map(|unit| dimension.scale(unit).ok());
        Some(one?.0 / other?.0)
    })
}

/// A unit as it is compared: without blanks; that of a pure number is nothing.
fn plain(unit: &str) -> String {
    let plain: String = unit.split_whitespace().collect();
    if plain == "1" { String::new() } else { plain }
}

impl ModelFile {
    /// What the file adds to a base model, with the numbers of that in its units.
    ///
    /// # Errors
    /// [`ModelFileError::NumberUnit`] with the first that is in a unit of another kind.
    pub(super) fn augmented(&self, simulator: &dyn Simulator) -> Result<Augmented, ModelFileError> {
        Ok(Augmented {
            parameters: of_base(&self.parameters, simulator)?,
            base_alone: of_base(&self.base_alone, simulator)?,
            effects: self.effects.clone(),
            scales: self.scales.clone(),
            rivals: Vec::new(),
        })
    }
}

/// The numbers of a base model that the file lists, in its units. A name that the model does not have stays as it is.
fn of_base(listed: &[NamedValue], simulator: &dyn Simulator) -> Result<Vec<NamedValue>, ModelFileError> {
    let needed = simulator.parameters();
    let converted = |given: &NamedValue| match needed.iter().find(|parameter| parameter.name == given.name) {
        Some(parameter) => in_unit(&format!("the base model `{}`", simulator.name()), given, &parameter.unit),
        None => Ok(given.clone()),
    };
    listed.iter().map(converted).collect()
}

/// The numbers of an effect in its units, whatever was recorded where it was fitted.
pub(super) fn of_effect(added: &mut AddedEffect, effect: &dyn Effect, context: &Context<'_>) -> Result<(), ModelFileError> {
    let names = ["a", "b"].map(|name| format!("{UNKNOWN}{name}"));
    let driver = |name: &String| Driver { name: name.clone(), unit: UNKNOWN.into(), values: vec![0.0; 2] };
    let clockless = Inputs { run: vec![1; 2], drivers: names.iter().map(driver).collect(), ..Inputs::default() };
    let column = || Some(vec![0.0, 1.0]);
    let clocked = Inputs { time_s: column(), temperature_c: column(), force_n: column(), ..clockless.clone() };
    let moving = |rows: &Inputs, temperature_k: f64, load: f64, others: bool, drivers: &[String]| {
        let mut other = Context::new(rows, context.simulator, 0.0, 0.0).with_runs(context.runs);
        other.moved = Default::default();
        (other.moved.temperature_k, other.moved.load) = (temperature_k, load);
        (other.moved.gap, other.moved.simulated) = (others, others);
        other.moved.drivers = drivers.to_vec();
        // no simulator is asked what it follows on rows that hold nothing else
        other.moved.followed = Some(Vec::new());
        effect.parameters(&other)
    };
    let asked = [
        moving(&clockless, 0.0, 0.0, false, &[]),
        moving(&clocked, 50.0, 0.0, false, &[]),
        moving(&clocked, 0.0, 1.0, false, &[]),
        moving(&clocked, 0.0, 0.0, true, &[]),
        moving(&clocked, 50.0, 1.0, true, &names),
    ];
    let fixed = |name: &str| {
        let mut units = asked.iter().flatten().filter(|parameter| parameter.name == name).map(|parameter| &parameter.unit);
        let first = units.next()?;
        units.all(|unit| unit == first).then_some(first).filter(|unit| !unit.contains(UNKNOWN))
    };
    let of = added.id.clone();
    for given in &mut added.parameters {
        if let Some(wanted) = fixed(&given.name) {
            *given = in_unit(&of, given, wanted)?;
        }
    }
    Ok(())
}

/// The same of a mechanism, whose words fix the units of these numbers alone.
pub(super) fn of_mechanism(added: &mut AddedEffect) -> Result<(), ModelFileError> {
    let of = added.id.clone();
    for (name, wanted) in [("tau", "s"), ("exponent", "1"), ("phase", "rad")] {
        for given in added.parameters.iter_mut().filter(|given| given.name == name) {
            *given = in_unit(&of, given, wanted)?;
        }
    }
    Ok(())
}

#[cfg(test)]
mod tests {
    use super::*;
    use truegap_diagnose::library;

    #[test]
    fn units_of_one_kind_are_converted_and_others_are_not() {
        for (found, wanted, times) in [
            ("min", "s", 60.0),
            ("ppm/K", "1/K", 1e-6),
            ("%", "1", 0.01),
            ("", "1", 1.0),
            ("nF", "pF", 1e3),
            ("pF/mm", "pF/mm", 1.0),
        ] {
            approx::assert_relative_eq!(factor(found, wanted).unwrap_or(0.0), times, max_relative = 1e-12);
        }
        for (found, wanted) in [("kg", "s"), ("1/s", "1/h"), ("degC", "K"), ("pF/mm", "pF/m"), ("s", "1")] {
            assert_eq!(factor(found, wanted), None, "{found} {wanted}");
        }
    }

    /// The units of every effect as a fit writes them, whatever moved: none of them is refused or converted.
    #[test]
    fn what_a_diagnosis_writes_is_taken_as_it_stands() -> Result<(), ModelFileError> {
        let driver = Driver { name: "pump".into(), unit: "V".into(), values: vec![0.0, 1.0, 0.5] };
        let column = |moves: bool, scale: f64| moves.then(|| vec![0.0, scale, 0.5 * scale]);
        for (what, moves) in (0..16).map(|bits| (bits, [1, 2, 4, 8].map(|bit| bits & bit > 0))) {
            let inputs = Inputs {
                run: vec![1, 1, 2],
                time_s: Some(vec![0.0, 1.0, 2.0]),
                temperature_c: column(moves[0], 30.0),
                force_n: column(moves[1], 3.0),
                simulated: column(moves[2], 7.0),
                drivers: if moves[3] { vec![driver.clone()] } else { Vec::new() },
                ..Inputs::default()
            };
            let recorded = truegap_model::Recorded { inputs: &inputs, response: &[0.0, 1.0, 2.0], unit: "mV" };
            let bases = ["linear", "external", "constant", "parallel-plate"];
            let specs =
                bases.map(|base| truegap_model::BaseModel::of(base, None, truegap_model::BaseOptions::default(), recorded));
            for spec in specs.into_iter().flatten() {
                let simulator = super::super::base::Programs::default().model(&spec, None, None)?;
                let fitted = Context::new(&inputs, simulator.as_ref(), 1.0, 0.1);
                let row = fitted.moved.one_row();
                let bare = Context::new(&row, simulator.as_ref(), 0.0, 0.0).with_runs(2);
                for effect in library() {
                    let named = |p: truegap_core::Parameter| NamedValue { name: p.name, unit: p.unit, value: 1.5, sd: 0.5 };
                    let parameters: Vec<NamedValue> = effect.parameters(&fitted).into_iter().map(named).collect();
                    let mut added = AddedEffect {
                        id: effect.id().to_string(),
                        parameters: parameters.clone(),
                        mechanism: None,
                        carried: false,
                    };
                    of_effect(&mut added, effect.as_ref(), &bare)?;
                    assert_eq!(added.parameters, parameters, "{} {what}", added.id);
                }
            }
        }
        Ok(())
    }
}
