//! A part of what the greatest load so far has moved stays: what yields, packs or is pressed flat.

use crate::{
    data::context::Context,
    effects::composed::words::{Driver, InWords, Kinetics, Place},
    effects::{
        course::Course,
        delay::is_temperature,
        effect::{About, Effect, Family, FittedParameter},
        memory::greatest_so_far,
    },
    stats::spread,
    text::with_sd,
};
use truegap_core::{Drive, EffectId, Parameter, Readout, Stage, ends, simulator::StageName, units::Dimension};

/// A power of the way that the moving driver has gone at most, as it adds to the reading.
pub struct PermanentSet;

struct Set {
    /// set by the whole range of the driver, in the unit of the reading
    size: f64,
    exponent: f64,
    course: Course,
    /// range of a recorded driver in the recording to which it was fitted, or a full load
    span: f64,
    /// part of the whole set that a part of the way leaves
    law: fn(f64, f64) -> f64,
}

/// A power, as plastic indentation and packed beds have it.
fn power(way: f64, exponent: f64) -> f64 {
    way.powf(exponent)
}

/// For the sibling: parts that give way at different loads, so that the exponent is spread.
fn powers(way: f64, exponent: f64) -> f64 {
    [0.7, 1.0, 1.4].map(|factor| way.powf(factor * exponent)).iter().sum::<f64>() / 3.0
}

impl Stage for Set {
    fn readout(&self, drive: &Drive<'_>, _: &Readout, value: &mut [f64]) {
        let Some(x) = self.course.column(drive).filter(|_| self.size != 0.0) else { return };
        for (value, way) in value.iter_mut().zip(farthest_so_far(x)) {
            *value += self.size * (self.law)(way / self.span, self.exponent);
        }
    }
}

/// Greatest distance from the first row so far, to the side to which the column goes farther.
fn farthest_so_far(x: &[f64]) -> Vec<f64> {
    let Some(first) = x.first() else { return Vec::new() };
    let away: Vec<f64> = x.iter().map(|x| x - first).collect();
    let (least, most) = ends(away.iter().copied());
    let side = if most >= -least { 1.0 } else { -1.0 };
    greatest_so_far(&away.iter().map(|x| side * x).collect::<Vec<f64>>(), 0.0).collect()
}

/// Part of the rows in which the greatest way must grow, and part that must lie clearly below it, so that a set is seen to be left and to stay.
const GROWS: f64 = 0.05;
const BELOW: f64 = 0.1;

/// Part of its range by which a driver lies clearly below the greatest so far.
const CLEARLY: f64 = 0.2;

/// Whether a column grows beyond what it has been in enough rows, and lies below it in enough.
fn leaves_and_stays(column: &[f64]) -> bool {
    let (range, first) = (spread(column), column.first().copied().unwrap_or(0.0));
    let farthest = farthest_so_far(column);
    let grows = farthest.windows(2).filter(|pair| pair[1] > pair[0]).count() as f64;
    let below = column.iter().zip(&farthest).filter(|(x, way)| **way - (*x - first).abs() > CLEARLY * range).count() as f64;
    let rows = column.len() as f64;
    grows >= GROWS * rows && below >= BELOW * rows
}

/// Whether a column says how far or how hard something is pressed: it has the unit of a force, a pressure or a length.
fn presses(course: Course, context: &Context<'_>) -> bool {
    match course {
        Course::Load => true,
        Course::Driver(_) => {
            let unit = course.unit(context);
            [Dimension::Force, Dimension::Pressure, Dimension::Length].iter().any(|dimension| dimension.scale(&unit).is_ok())
        }
        Course::Humidity | Course::Gap | Course::Simulated => false,
    }
}

fn set(values: &[f64], context: &Context<'_>, law: fn(f64, f64) -> f64) -> Box<dyn Stage> {
    let course = Course::or_load(context, 0);
    let [least, greatest] = course.ends(context);
    let span = if greatest > least { greatest - least } else { 1.0 };
    Box::new(Set { size: values[0], exponent: values[1], course, span, law })
}

impl Effect for PermanentSet {
    fn id(&self) -> EffectId {
        EffectId("permanent_set")
    }
    fn stage(&self) -> StageName {
        StageName::Readout
    }
    fn family(&self) -> Family {
        Family::MechanicalMemory
    }
    fn in_words(&self, context: &Context<'_>) -> Option<InWords> {
        let course = Course::of(context, 0)?;
        let driver = if course == Course::Load { Driver::LoadHistory } else { course.driver(context) };
        Some(InWords { place: Place::Readout, driver, kinetics: Kinetics::Accumulating })
    }
    fn about(&self) -> About {
        About {
            physics: "a part of what the greatest load so far has moved stays when the load goes back: plastic indentation, a foam that is pressed flat, a bed that packs, a seat that beds in",
            equation: "value = true + A (m / X)^p, m the greatest way of the driver from its first value so far, X its range or a full load",
            excitation: "loads that grow, and go back in between",
            impostors: &["friction", "nonlinearity", "settling", "offset_drift", "viscoelastic_creep"],
            separates: "it grows only while the load is greater than ever before, and what has been left does not come back",
            source: "Oliver & Pharr, J. Mater. Res. 7 (1992) 1564 (residual depth after unloading); Johnson, Contact Mechanics (1985), ch. 6",
        }
    }
    fn parameters(&self, context: &Context<'_>) -> Vec<Parameter> {
        vec![
            Parameter::normal(
                "left",
                context.simulator.unit(),
                0.0,
                0.5 * context.response_span.abs(),
                "what the whole range of the driver, or a full load, leaves",
            ),
            Parameter::log_normal("exponent", "1", 1.0, 0.5, "power of the greatest way with which it grows").within(0.2, 4.0),
        ]
    }
    fn starts(&self, _: &Context<'_>) -> Vec<Vec<f64>> {
        [0.5, 1.0, 2.0].map(|exponent| vec![exponent]).to_vec()
    }
    fn testable(&self, context: &Context<'_>) -> Result<(), String> {
        context.has(StageName::Readout)?;
        if context.has_plates() {
            return Err("the base model has a place for what the greatest load leaves: softening of its beads".into());
        }
        if is_temperature(context) {
            return Err("the reading is a temperature, which takes no set".into());
        }
        if context.inputs.time_s.is_none() {
            return Err("without a clock nothing says which load came first".into());
        }
        let Some(course) = Course::of(context, 0) else { return Err(Course::missing(0)) };
        if !presses(course, context) {
            return Err(format!("{} is no force, pressure or way that could leave a set", course.name(context)));
        }
        match course.recorded(context) {
            Some(column) if leaves_and_stays(&column) => Ok(()),
            _ => Err(format!("{} does not grow beyond what it has been and go back again in enough rows", course.name(context))),
        }
    }
    fn with(&self, values: &[f64], context: &Context<'_>) -> Box<dyn Stage> {
        set(values, context, power)
    }
    fn sibling(&self, values: &[f64], context: &Context<'_>) -> Option<Box<dyn Stage>> {
        Some(set(values, context, powers))
    }
    fn says(&self, fitted: &[FittedParameter]) -> String {
        told(fitted, "the driver")
    }
    fn told(&self, fitted: &[FittedParameter], context: &Context<'_>, _: &[(EffectId, Vec<FittedParameter>)]) -> String {
        told(fitted, Course::of(context, 0).map_or("the driver", |course| course.name(context)))
    }
}

fn told(fitted: &[FittedParameter], name: &str) -> String {
    let [left, exponent] = [&fitted[0], &fitted[1]];
    format!(
        "{} of the reading stays after the greatest {}, and grows with the power {} of the greatest so far",
        with_sd(left.value, left.sd, &left.parameter.unit),
        name.strip_prefix("the ").unwrap_or(name),
        with_sd(exponent.value, exponent.sd, "")
    )
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn what_was_pressed_flat_stays_flat() {
        assert_eq!(farthest_so_far(&[1.0, 3.0, 2.0, 1.0, 4.0, 0.5]), [0.0, 2.0, 2.0, 2.0, 3.0, 3.0]);
        // a distance that closes goes farther down than up
        assert_eq!(farthest_so_far(&[5.0, 5.5, 2.0, 4.0]), [0.0, 0.0, 3.0, 3.0]);
    }

    #[test]
    fn a_set_is_seen_where_the_load_grows_and_goes_back() {
        let up = |k: usize| k as f64 / 50.0;
        let once: Vec<f64> = (0..50).map(up).collect();
        assert!(!leaves_and_stays(&once));
        let back: Vec<f64> = (0..100).map(|k| up(50 - usize::abs_diff(k, 50))).collect();
        assert!(leaves_and_stays(&back));
        // the same way a hundred times: what the first one has left is in its rows alone
        let again: Vec<f64> = back.iter().copied().cycle().take(10_000).collect();
        assert!(!leaves_and_stays(&again));
    }
}
