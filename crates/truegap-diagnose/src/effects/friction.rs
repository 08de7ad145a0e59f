//! The reading depends on which way something moves: dry friction against the motion of a driver.

use crate::{
    data::context::Context,
    effects::composed::words::{InWords, Kinetics, Place},
    effects::{
        course::Course,
        delay::is_temperature,
        effect::{About, Effect, Family, FittedParameter},
        friction_of_speed::{self, is_speed},
        memory::{half_widths, plays, rates, walk},
    },
    text::{percent_of, rounded, with_sd},
};
use std::f64::consts::{FRAC_2_PI, FRAC_PI_2};
use truegap_core::{Drive, EffectId, Parameter, Readout, Stage, simulator::StageName};

/// Dry and viscous friction against the motion of the moving driver of this number, as it adds to the reading.
pub struct Friction(pub usize);

struct Against {
    force: f64,
    /// travel, in the driver's unit
    width: f64,
    /// how far the three plays are apart: 0 for one play, which turns over in a straight line; 1 for the spread of [`PLAY_SET`]
    gradual: f64,
    /// force per speed, over `force`
    viscous: f64,
    /// share of the force that builds up with the speed and is gone at standstill; the rest builds up with the travel and stays
    by_speed: f64,
    /// speed at which 76 % of that share are there, in the driver's unit a second
    onset: f64,
    course: Course,
}

impl Against {
    /// Adds `force ((1 - by_speed) way + by_speed rise(speed / onset) + viscous speed)`; `way` and `rise` are -1 to 1.
    fn apply(&self, drive: &Drive<'_>, value: &mut [f64], way: impl Fn(&[f64]) -> Vec<f64>, rise: impl Fn(f64) -> f64) {
        let Some(x) = self.course.column(drive).filter(|_| self.force != 0.0) else { return };
        let speed = rates(drive.inputs.time_s.as_deref(), x, &drive.inputs.runs());
        let way = way(x);
        for (row, value) in value.iter_mut().enumerate() {
            let by_travel = if self.by_speed < 1.0 { (1.0 - self.by_speed) * way[row] } else { 0.0 };
            let by_speed = if self.by_speed > 0.0 { self.by_speed * rise(speed[row] / self.onset) } else { 0.0 };
            *value += self.force * (by_travel + by_speed + self.viscous * speed[row]);
        }
    }
}

impl Stage for Against {
    fn readout(&self, drive: &Drive<'_>, _: &Readout, value: &mut [f64]) {
        let way = |x: &[f64]| {
            let mut way = vec![0.0; x.len()];
            plays(drive.inputs, half_widths(self.width, self.gradual), |row| x[row], |first| first, |row, slip| way[row] = -slip);
            way
        };
        self.apply(drive, value, way, f64::tanh);
    }
}

/// Sibling: Dahl's law, which approaches the full force exponentially with the travel; with the speed it rises as an arc tangent.
struct Dahl(Against);

impl Stage for Dahl {
    fn readout(&self, drive: &Drive<'_>, _: &Readout, value: &mut [f64]) {
        let way = |x: &[f64]| {
            let (mut way, mut state) = (vec![0.0; x.len()], 0.0);
            walk(drive.inputs, |row, step| {
                if step.is_none() {
                    state = 0.0;
                } else {
                    let travel: f64 = x[row] - x[row - 1];
                    state = travel.signum() + (state - travel.signum()) * (-travel.abs() / self.0.width).exp();
                }
                way[row] = state;
            });
            way
        };
        self.0.apply(drive, value, way, |u| FRAC_2_PI * (FRAC_PI_2 * u).atan());
    }
}

/// Widest travel after a turn, in ranges of the driver: the widest play has turned over within 3.6 of it, half of the range. What takes longer is seen to the end on no way.
const WIDEST: f64 = 0.15;

const IDS: [&str; 2] = ["friction", "friction_of_second_driver"];

impl Friction {
    fn course(&self, context: &Context<'_>) -> Course {
        Course::or_load(context, self.0)
    }

    /// Whether the force may grow with the speed: against a recorded driver. What is proportional to the speed of a simulation is a reading that comes late.
    fn may_grow(&self, context: &Context<'_>) -> bool {
        matches!(self.course(context), Course::Driver(_))
    }

    /// Whether a share may build up with the speed: of a driver that the base model does not follow, for what follows it late looks the same.
    fn may_follow_the_speed(&self, context: &Context<'_>) -> bool {
        let course = self.course(context);
        matches!(course, Course::Driver(_)) && !course.is_followed(context)
    }

    fn against(&self, values: &[f64], context: &Context<'_>) -> Against {
        let course = self.course(context);
        let [force, width, gradual] = [0, 1, 2].map(|place| values[place]);
        let viscous = values.get(3).copied().unwrap_or(0.0);
        let (by_speed, onset) = if let Some([by_speed, onset]) = values.get(4..) { (*by_speed, *onset) } else { (0.0, 1.0) };
        Against { force, width, gradual, viscous, by_speed, onset, course }
    }
}

impl Effect for Friction {
    fn id(&self) -> EffectId {
        EffectId(IDS[self.0.min(1)])
    }
    fn stage(&self) -> StageName {
        StageName::Readout
    }
    fn family(&self) -> Family {
        Family::MechanicalMemory
    }
    fn in_words(&self, context: &Context<'_>) -> Option<InWords> {
        let course = Course::of(context, self.0)?;
        let kinetics = if is_speed(course, context) { Kinetics::Static } else { Kinetics::RateIndependent };
        Some(InWords { place: Place::Readout, driver: course.driver(context), kinetics })
    }
    fn about(&self) -> About {
        About {
            physics: "friction, or the play (backlash) of a gear or a thread, acts on the reading against the motion of a driver (a piston, a slide, a gap), whether the base model follows it or not",
            equation: "value = true + F [(1 - r) s(x) + r tanh((dx/dt) / v0) + c dx/dt], s from -1 to 1 by three plays on the driver x with half widths w (1 - 0.6 g, 1 - 0.2 g, 1 + 0.8 g), one play of half width w for g = 0, at rest when a run starts; F (tanh(x / v0) + c x + d x |x|), c and d not below 0, where x is a speed that goes both ways, d = 0 until rows left out bear it out; r = 0 where the base model follows x, c = 0 where x is a simulation: a lag looks like them there",
            excitation: "a driver that turns around",
            impostors: &["driver_coefficient", "readout_lag", "slow_response", "time_offset"],
            separates: "the reading jumps where the driver turns and stays there, at any speed; a lag grows with the speed",
            source: "Armstrong-Helouvry, Dupont & Canudas de Wit, Automatica 30 (1994) 1083; Dahl, AIAA J. 14 (1976) 1675; Andersson, Soderberg & Bjorklund, Tribol. Int. 40 (2007) 580 (tanh)",
        }
    }
    fn parameters(&self, context: &Context<'_>) -> Vec<Parameter> {
        let course = self.course(context);
        if is_speed(course, context) {
            return friction_of_speed::parameters(course, context);
        }
        let (span, unit) = (course.span(context), course.unit(context));
        let speed = course.usual_speed(context).max(span / context.run_s());
        let mut list = vec![
            Parameter::normal(
                "force",
                context.simulator.unit(),
                0.0,
                0.2 * context.response_span.abs(),
                "half the difference between rising and falling driver",
            ),
            Parameter::log_normal(
                "width",
                &unit,
                0.03 * span,
                1.2,
                "travel after a turn in which half of the force has changed sign",
            )
            .within(1e-4 * span, WIDEST * span),
            Parameter::normal(
                "gradual",
                "",
                1.0,
                0.5,
                "how gradually it changes sign: 0 in a straight line, as a play (backlash) does",
            )
            .within(0.0, 1.0),
        ];
        if self.may_grow(context) {
            list.push(Parameter::normal(
                "viscous",
                &per_speed(&unit),
                0.0,
                0.3 / speed,
                "speed-proportional part over the force",
            ));
        }
        if self.may_follow_the_speed(context) {
            list.extend([
                Parameter::normal("by_speed", "", 0.0, 0.5, "share of the force that is gone at standstill").within(0.0, 1.0),
                Parameter::log_normal(
                    "onset",
                    &format!("{unit}/s"),
                    0.1 * speed,
                    1.2,
                    "speed at which 76 % of that share are there",
                )
                // at half the usual speed it has levelled off: what grows on is viscous, or a lag
                .within(1e-3 * speed, 0.5 * speed),
            ]);
        }
        list
    }
    fn starts(&self, context: &Context<'_>) -> Vec<Vec<f64>> {
        let course = self.course(context);
        if is_speed(course, context) {
            return friction_of_speed::starts(course, context);
        }
        let (span, speed) = (course.span(context), course.usual_speed(context));
        if !self.may_follow_the_speed(context) {
            let viscous = if self.may_grow(context) { &[0.0][..] } else { &[] };
            return [0.003, 0.01, 0.03, 0.1].map(|share| [&[share * span, 0.8], viscous].concat()).to_vec();
        }
        let by_travel = [0.003, 0.01, 0.03, 0.1].map(|share| vec![share * span, 0.8, 0.0, 0.0, 0.1 * speed]);
        let by_speed = [0.03, 0.2].map(|share| vec![0.03 * span, 0.8, 0.0, 1.0, share * speed]);
        by_travel.into_iter().chain(by_speed).collect()
    }
    fn may_be_nothing(&self) -> &'static [&'static str] {
        &["gradual", "viscous", "by_speed"]
    }
    fn may_be_more(&self) -> &'static [&'static str] {
        &[friction_of_speed::DRAG]
    }
    fn at_once(&self) -> &'static [&'static str] {
        &["width", "onset"]
    }
    fn smooths(&self) -> bool {
        true
    }
    fn testable(&self, context: &Context<'_>) -> Result<(), String> {
        context.has(StageName::Readout)?;
        if is_temperature(context) {
            return Err("the reading is a temperature, in which nothing rubs".into());
        }
        match Course::of(context, self.0) {
            None => Err(Course::missing(self.0)),
            Some(course) if is_speed(course, context) && course.is_followed(context) => {
                Err("the base model follows this speed by itself; a bent law of it is a nonlinearity".into())
            }
            Some(course) if is_speed(course, context) => Ok(()),
            Some(course) if !course.turns(context) => {
                Err(format!("{} goes one way only inside the runs; friction shows where it turns", course.name(context)))
            }
            Some(Course::Driver(_)) => Ok(()),
            Some(_) if context.has(StageName::Beads).is_ok() => {
                Err("the base model has a place for friction of its own (hysteresis of the strain)".into())
            }
            Some(_) => Ok(()),
        }
    }
    fn with(&self, values: &[f64], context: &Context<'_>) -> Box<dyn Stage> {
        let course = self.course(context);
        if is_speed(course, context) {
            return friction_of_speed::stage(values, course, context);
        }
        Box::new(self.against(values, context))
    }
    fn sibling(&self, values: &[f64], context: &Context<'_>) -> Option<Box<dyn Stage>> {
        let course = self.course(context);
        if is_speed(course, context) {
            return Some(friction_of_speed::sibling(values, course, context));
        }
        Some(Box::new(Dahl(self.against(values, context))))
    }
    fn says(&self, fitted: &[FittedParameter]) -> String {
        told(fitted, "the driver", 0.0)
    }
    fn told(&self, fitted: &[FittedParameter], context: &Context<'_>, _: &[(EffectId, Vec<FittedParameter>)]) -> String {
        let course = self.course(context);
        if is_speed(course, context) {
            return friction_of_speed::told(fitted, course, context);
        }
        told(fitted, course.name(context), course.usual_speed(context))
    }
}

/// Seconds over a unit; in brackets where that is more than a word.
fn per_speed(unit: &str) -> String {
    if unit.chars().all(char::is_alphanumeric) { format!("s/{unit}") } else { format!("s/({unit})") }
}

/// Viscous part below which it is not spoken of, in standard deviations.
const SPOKEN_OF: f64 = 3.0;

/// How gradually it changes sign where it is told as a play: the three plays are within 24 % and 32 % of one.
const SHARP: f64 = 0.4;

/// `usual` is the driver's usual speed, in its unit a second.
fn told(fitted: &[FittedParameter], name: &str, usual: f64) -> String {
    let (force, width) = (&fitted[0], &fitted[1]);
    let turn = rounded(2.0 * width.value, &width.parameter.unit);
    let viscous = fitted.get(3).filter(|viscous| usual > 0.0 && viscous.value.abs() > SPOKEN_OF * viscous.sd);
    let factor = viscous.map_or(1.0, |viscous| 1.0 + viscous.value * usual);
    let (whole, unit) = (force.value * factor, force.parameter.unit.as_str());
    // rising and falling lie as far from the middle, by size and its relative error
    let size = with_sd(whole.abs(), force.sd * factor.abs(), unit);
    let way = if whole < 0.0 { "lower" } else { "higher" };
    let speed = viscous.map_or_else(String::new, |_| {
        let usual = rounded(usual, &format!("{}/s", width.parameter.unit));
        format!(", at the usual {usual}; {} of it without speed", rounded(force.value.abs(), unit))
    });
    let sharp = fitted[2].value < SHARP;
    let turned = match fitted.get(4..) {
        Some([by_speed, onset]) if by_speed.value > 0.9 => format!(
            "it is gone at standstill, and three quarters of it are there at {}",
            rounded(onset.value, &onset.parameter.unit)
        ),
        Some([by_speed, _]) if by_speed.value > 0.1 && by_speed.value > SPOKEN_OF * by_speed.sd => format!(
            "{} of it is gone at standstill, the rest changes over within {turn} after a turn",
            percent_of(by_speed.value)
        ),
        _ if sharp => format!("after a turn it changes over in a straight line within {turn}, as a play (backlash) does"),
        _ => format!("it changes over within {turn} after a turn"),
    };
    format!(
        "friction against the motion of {name}: the reading is {size} {way} than midway while {name} rises, as much the other way while it \
         falls{speed}; {turned}"
    )
}

#[cfg(test)]
mod tests {
    use super::*;
    use truegap_core::{Driver, Inputs};

    fn zigzag() -> Inputs {
        let x: Vec<f64> = (0..400).map(|i| 10.0 * (f64::from(i) / 40.0).sin()).collect();
        let drivers = vec![Driver { name: "position".into(), unit: "mm".into(), values: x }];
        Inputs { time_s: Some((0..400).map(f64::from).collect()), run: vec![1; 400], drivers, ..Inputs::default() }
    }

    fn by_travel() -> Against {
        Against { force: 7.0, width: 0.5, gradual: 1.0, viscous: 0.0, by_speed: 0.0, onset: 0.5, course: Course::Driver(0) }
    }

    #[test]
    fn a_long_way_either_way_shows_the_whole_force() {
        let inputs = zigzag();
        let friction = |viscous| Against { viscous, ..by_travel() };
        let drive = Drive { inputs: &inputs, load: &[0.0; 400], temperature_c: &[20.0; 400], reference_c: 20.0, full_load: 1.0 };
        for stage in [Box::new(friction(0.0)) as Box<dyn Stage>, Box::new(Dahl(friction(0.0)))] {
            let mut value = vec![150.0; 400];
            stage.readout(&drive, &Readout { zero: 150.0, span: 1.0 }, &mut value);
            // at the zero crossings the driver has come 10 mm: 20 widths, 5.5 times the widest play; e^-20 of Dahl's approach is left
            let crossing = |k: f64| value[(40.0 * k * std::f64::consts::PI) as usize];
            approx::assert_abs_diff_eq!(crossing(1.0), 143.0, epsilon = 1e-3);
            approx::assert_abs_diff_eq!(crossing(2.0), 157.0, epsilon = 1e-3);
        }
        let mut value = vec![0.0; 400];
        friction(0.1).readout(&drive, &Readout { zero: 0.0, span: 1.0 }, &mut value);
        // a quarter of a millimetre a second at the crossing adds 0.1 of it
        approx::assert_abs_diff_eq!(value[251], 7.0 * 1.025, epsilon = 1e-3);
    }

    /// A play alone turns over in a straight line: half of it half a width after a turn has taken back half a width.
    #[test]
    fn one_play_turns_over_in_a_straight_line() {
        // up by 3 in steps of 0.1, and down again
        let x: Vec<f64> = (0..=60_i32).map(|i| 3.0 - 0.1 * f64::from((i - 30).abs())).collect();
        let drivers = vec![Driver { name: "position".into(), unit: "mm".into(), values: x }];
        let inputs = Inputs { time_s: Some((0..=60).map(f64::from).collect()), run: vec![1; 61], drivers, ..Inputs::default() };
        let drive = Drive { inputs: &inputs, load: &[0.0; 61], temperature_c: &[20.0; 61], reference_c: 20.0, full_load: 1.0 };
        let mut value = vec![0.0; 61];
        Against { gradual: 0.0, ..by_travel() }.readout(&drive, &Readout { zero: 0.0, span: 1.0 }, &mut value);
        // the play of half width 0.5 is at its end at the turn, in the middle 0.5 after it, at its other end 1.0 after it
        for (row, expected) in [(29, 7.0), (30, 7.0), (35, 0.0), (40, -7.0), (60, -7.0)] {
            approx::assert_abs_diff_eq!(value[row], expected, epsilon = 1e-9);
        }
    }

    /// A driver that goes, stops and goes on: the force of a motor is gone while it stands, that of a piston is not.
    #[test]
    fn the_share_by_speed_is_gone_at_standstill() {
        // 9 steps out, 10 rows still, 10 steps on
        let x: Vec<f64> = (0..30_i32).map(|i| f64::from(i.min(9) + (i - 19).max(0))).collect();
        let drivers = vec![Driver { name: "position".into(), unit: "mm".into(), values: x }];
        let inputs = Inputs { time_s: Some((0..30).map(f64::from).collect()), run: vec![1; 30], drivers, ..Inputs::default() };
        let drive = Drive { inputs: &inputs, load: &[0.0; 30], temperature_c: &[20.0; 30], reference_c: 20.0, full_load: 1.0 };
        for (by_speed, standing, moving) in
            [(0.0, 7.0, 7.0), (0.4, 0.6 * 7.0, 7.0 * (0.6 + 0.4 * 2.0_f64.tanh())), (1.0, 0.0, 7.0 * 2.0_f64.tanh())]
        {
            let mut value = vec![0.0; 30];
            let friction = Against { by_speed, ..by_travel() };
            friction.readout(&drive, &Readout { zero: 0.0, span: 1.0 }, &mut value);
            approx::assert_abs_diff_eq!(value[15], standing, epsilon = 1e-12);
            approx::assert_abs_diff_eq!(value[8], moving, epsilon = 1e-12);
        }
    }
}
