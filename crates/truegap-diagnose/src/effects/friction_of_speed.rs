//! The law of [`super::friction`] where what is recorded is the speed itself: dry friction turns over with its sign, viscous friction is in proportion to it, and drag to its square.
//!
//! Limits: a speed that goes both ways; what is dry near standstill has one number.

use crate::{
    data::context::Context,
    effects::{course::Course, effect::FittedParameter},
    text::{rounded, with_sd},
};
use std::f64::consts::{FRAC_2_PI, FRAC_PI_2};
use truegap_core::{Drive, Parameter, Readout, Stage};

/// Units of a speed along a line or of a turning.
const SPEEDS: [&str; 16] = [
    "m/s", "mm/s", "cm/s", "um/s", "km/h", "m/min", "mm/min", "in/s", "rad/s", "deg/s", "°/s", "rpm", "1/min", "r/min", "rev/s",
    "rev/min",
];

/// Least part of its range that a speed goes to each side of standstill.
const BOTH_WAYS: f64 = 0.1;

/// Whether the column is a speed that goes both ways, by its unit and its signs.
pub fn is_speed(course: Course, context: &Context<'_>) -> bool {
    if !matches!(course, Course::Driver(_)) || !SPEEDS.contains(&course.unit(context).as_str()) {
        return false;
    }
    // a model file knows the range of the recording in which it was found
    let [low, high] = course.ends(context);
    let least = BOTH_WAYS * (high - low);
    least > 0.0 && low < -least && high > least
}

struct OfSpeed {
    force: f64,
    onset: f64,
    /// viscous part at the speed `fastest`, over the dry part: against the motion as that is
    viscous: f64,
    /// drag at that speed, over the dry part
    drag: f64,
    fastest: f64,
    course: Course,
    rise: fn(f64) -> f64,
}

impl Stage for OfSpeed {
    fn readout(&self, drive: &Drive<'_>, _: &Readout, value: &mut [f64]) {
        let Some(speed) = self.course.column(drive) else { return };
        value.iter_mut().zip(speed).for_each(|(value, speed)| {
            let of_fastest = speed / self.fastest;
            let flows = (self.viscous + self.drag * of_fastest.abs()) * of_fastest;
            *value += self.force * ((self.rise)(speed / self.onset) + flows)
        });
    }
}

/// `force (tanh(v / onset) + viscous u + drag u |u|)`, u = v / fastest; the sibling rises as an arc tangent.
pub fn stage(values: &[f64], course: Course, context: &Context<'_>) -> Box<dyn Stage> {
    Box::new(of_speed(values, course, fastest(course, context), f64::tanh))
}

pub fn sibling(values: &[f64], course: Course, context: &Context<'_>) -> Box<dyn Stage> {
    Box::new(of_speed(values, course, fastest(course, context), arc_tangent))
}

fn of_speed(values: &[f64], course: Course, fastest: f64, rise: fn(f64) -> f64) -> OfSpeed {
    OfSpeed {
        force: values[0],
        onset: values[1],
        viscous: values[2],
        drag: values.get(3).copied().unwrap_or(0.0),
        fastest,
        course,
        rise,
    }
}

fn arc_tangent(u: f64) -> f64 {
    FRAC_2_PI * (FRAC_PI_2 * u).atan()
}

/// Largest speed of the recording in which the effect was found.
fn fastest(course: Course, context: &Context<'_>) -> f64 {
    let [low, high] = course.ends(context);
    high.max(-low)
}

/// The number of a richer law: air and water resist with the square of the speed.
pub const DRAG: &str = "drag";

/// Its numbers: `force`, `onset`, `viscous`, `drag`.
pub fn parameters(course: Course, context: &Context<'_>) -> Vec<Parameter> {
    let (response, unit, span) = (context.simulator.unit(), course.unit(context), course.span(context));
    vec![
        Parameter::normal("force", response, 0.0, 0.2 * context.response_span.abs(), "dry part, against the motion"),
        Parameter::log_normal("onset", &unit, 0.02 * span, 1.2, "speed at which 76 % of the dry part are there")
            .within(1e-4 * span, 0.25 * span),
        Parameter::normal("viscous", "1", 0.0, 2.0, "viscous part at the largest speed, over the dry part").within(0.0, 50.0),
        Parameter::normal(DRAG, "1", 0.0, 2.0, "drag, with the square of the speed, at the largest one, over the dry part")
            .within(0.0, 50.0),
    ]
}

/// Where its numbers after the first are tried from.
pub fn starts(course: Course, context: &Context<'_>) -> Vec<Vec<f64>> {
    let span = course.span(context);
    [0.003, 0.02, 0.1].map(|share| vec![share * span, 0.0, 0.0]).to_vec()
}

/// Viscous part below which it is not spoken of, in standard deviations.
const SPOKEN_OF: f64 = 3.0;

pub fn told(fitted: &[FittedParameter], course: Course, context: &Context<'_>) -> String {
    let [force, onset, viscous] = [0, 1, 2].map(|place| &fitted[place]);
    let way = if force.value < 0.0 { "lower" } else { "higher" };
    let size = with_sd(force.value.abs(), force.sd, &force.parameter.unit);
    let at_most = rounded(fastest(course, context), &onset.parameter.unit);
    let grows = |number: Option<&FittedParameter>, what: &str| {
        let seen = number.filter(|number| number.value > SPOKEN_OF * number.sd);
        let most = seen.map(|number| rounded((number.value * force.value).abs(), &force.parameter.unit));
        most.map_or_else(String::new, |most| format!("; {what} comes to {most} at {at_most}"))
    };
    let grows = grows(Some(viscous), "a viscous part") + &grows(fitted.get(3), "drag, with the square of the speed,");
    format!(
        "friction against the motion whose speed is {}: the reading is {size} {way} than at standstill where it is positive, as much the other way where it is negative; three quarters of it are there at {}{grows}",
        course.name(context),
        rounded(onset.value, &onset.parameter.unit)
    )
}

#[cfg(test)]
mod tests {
    use super::*;
    use truegap_core::{Driver, Inputs};

    #[test]
    fn dry_friction_has_the_sign_of_the_speed_and_viscous_friction_its_size() {
        let values = vec![-2.0, -1e-9, 0.0, 1e-9, 2.0];
        let inputs = Inputs {
            run: vec![1; 5],
            drivers: vec![Driver { name: "speed".into(), unit: "rad/s".into(), values }],
            ..Inputs::default()
        };
        let drive = Drive { inputs: &inputs, load: &[], temperature_c: &[], reference_c: 20.0, full_load: 1.0 };
        for rise in [f64::tanh, arc_tangent] {
            let mut value = vec![1.0; 5];
            let law = of_speed(&[0.5, 1e-12, 2.0], Course::Driver(0), 4.0, rise);
            law.readout(&drive, &Readout { zero: 0.0, span: 1.0 }, &mut value);
            for (at, exact) in value.iter().zip([0.0, 0.5, 1.0, 1.5, 2.0]) {
                approx::assert_abs_diff_eq!(*at, exact, epsilon = 1e-3);
            }
            // drag 8 times the dry part at a speed of 4: twice the dry part at half of it
            let law = of_speed(&[0.5, 1e-12, 0.0, 8.0], Course::Driver(0), 4.0, rise);
            let mut value = vec![1.0; 5];
            law.readout(&drive, &Readout { zero: 0.0, span: 1.0 }, &mut value);
            approx::assert_abs_diff_eq!(value[0], 1.0 - 1.5, epsilon = 1e-3);
            approx::assert_abs_diff_eq!(value[4], 1.0 + 1.5, epsilon = 1e-3);
        }
    }
}
