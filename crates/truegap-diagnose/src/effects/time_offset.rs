//! The clocks of load and response differ.
//!
//! Drivers that the base model does not follow may stand on either clock, or on a third: a simulation is made elsewhere, and a tilt is recorded by the logger of the reading.
//!
//! A logger that writes means over some time writes them at the end of it, or at its beginning: the reading is late or early by half of it, and smoothed. A lag and a clock the other way do nearly the same together.
//! So the shift may come with a mean, where rows left out bear it out.
//!
//! Limits: of several recordings together, drivers are as late as the load.

use crate::{
    data::{context::Context, problem::Problem},
    effects::composed::words::{Driver, InWords, Kinetics, Place},
    effects::{
        course::Course,
        each_recording::EachRecording,
        effect::{About, Effect, Family, FittedParameter, Separation},
        mean_to_both_sides::{self, Mean},
        memory::rates,
        most_alike::most_alike_s,
    },
    text::with_sd,
};
use truegap_core::{Drive, EffectId, Inputs, Parameter, Readout, Stage, simulator::StageName};

/// A constant difference of clocks.
pub struct TimeOffset;

struct Shift {
    late_s: f64,
    /// part of that by which drivers beside the base model are not late
    apart: f64,
    /// whether each driver is beside the base model
    beside: Vec<bool>,
    /// half the time over which the reading is a mean
    half_width_s: f64,
}

impl Stage for Shift {
    fn late_s(&self, _: f64) -> f64 {
        self.late_s
    }
    fn driver_late_s(&self, driver: usize, _: f64) -> f64 {
        let beside = self.beside.get(driver).is_some_and(|beside| *beside);
        if beside { self.late_s * (1.0 - self.apart) } else { self.late_s }
    }
    fn readout(&self, drive: &Drive<'_>, readout: &Readout, value: &mut [f64]) {
        Mean { share: 1.0, half_width_s: self.half_width_s }.readout(drive, readout, value);
    }
}

impl Shift {
    /// All inputs by as much.
    fn of_all(late_s: f64) -> Self {
        Self { late_s, apart: 0.0, beside: Vec::new(), half_width_s: 0.0 }
    }
}

/// Whether each recorded driver is one that the base model does not follow; none where several recordings are one problem.
fn beside_the_base(context: &Context<'_>) -> Vec<bool> {
    if context.simulator.joined().is_some_and(|joined| joined.count() > 1) {
        return Vec::new();
    }
    (0..context.inputs.drivers.len()).map(|index| !Course::Driver(index).is_followed(context)).collect()
}

/// Whether a driver moved that may be on another clock than the load.
fn moves_beside_the_base(context: &Context<'_>) -> bool {
    let drivers = context.inputs.drivers.iter().zip(beside_the_base(context));
    drivers.into_iter().any(|(driver, beside)| beside && context.moved.drivers.contains(&driver.name))
}

/// Name of the number that tells half the time over which the reading is a mean.
const HALF_WIDTH: &str = "half_width";

/// Whether the reading may be a mean: beside base models without plates, of one recording.
fn may_be_a_mean(context: &Context<'_>) -> bool {
    let one = context.simulator.joined().is_none_or(|joined| joined.count() < 2);
    one && !context.has_plates() && context.has(StageName::Readout).is_ok()
}

/// Sibling: the shift to first order, along the slope between the neighbouring rows.
struct Slope(f64);

impl Stage for Slope {
    fn load(&self, inputs: &Inputs, load: &mut [f64]) {
        let Some(time) = &inputs.time_s else { return };
        let rates = rates(Some(time), load, &inputs.runs());
        load.iter_mut().zip(rates).for_each(|(load, rate)| *load += self.0 * rate);
    }
}

/// The same, of each recording where there are several: clocks belong to a recording, not to the sensor.
pub fn of_each_recording() -> EachRecording<TimeOffset> {
    EachRecording { inner: TimeOffset, make: |values| Box::new(Shift::of_all(values[0])) }
}

impl Effect for TimeOffset {
    fn id(&self) -> EffectId {
        EffectId("time_offset")
    }
    fn stage(&self) -> StageName {
        StageName::Inputs
    }
    fn family(&self) -> Family {
        Family::Readout
    }
    fn touches(&self) -> Vec<StageName> {
        vec![StageName::Inputs, StageName::Readout]
    }
    fn in_words(&self, _: &Context<'_>) -> Option<InWords> {
        Some(InWords { place: Place::Inputs, driver: Driver::LoadRate, kinetics: Kinetics::Static })
    }
    fn about(&self) -> About {
        About {
            physics: "load and response were stamped by two clocks, or one of them was buffered",
            equation: "the load at time t stands in the row of t + s, a driver beside the base model in that of t + s (1 - a), a = 0 until rows left out bear it out; between rows straight or by a cubic, as the rows say; the reading is its mean over h to both sides, h = 0 until rows left out bear it out",
            excitation: "load that changes fast, at more than one rate, with a clock",
            impostors: &["readout_lag", "rate_independent_hysteresis", "viscoelastic_creep", "trapped_air_stiffness"],
            separates: "the loop over load grows with the rate and may run the wrong way round; corners stay sharp, where a lag rounds them",
            source: "Oppenheim & Willsky, Signals and Systems, sec. 1.2 (time shift)",
        }
    }
    fn separations(&self) -> &'static [Separation] {
        &[
            Separation { rival: "readout_lag", says: "sample load and response on one clock, or mark both with one common edge" },
            Separation {
                rival: "clock_rate",
                says: "sample load and response on one clock, or mark both with a common edge at the start and at the end",
            },
        ]
    }
    fn parameters(&self, context: &Context<'_>) -> Vec<Parameter> {
        let scale = context.of_device_s(0.05);
        let most = (LARGEST_SHARE * context.longest_run_s).max(scale);
        let mut list =
            vec![Parameter::normal("late", "s", 0.0, scale, "time by which the load's clock is late").within(-most, most)];
        if moves_beside_the_base(context) {
            let meaning =
                "part of it by which drivers beside the base model are not late: 1 where they were recorded with the reading";
            list.push(Parameter::normal("apart", "1", 0.0, 0.7, meaning).within(-1.0, 2.0));
        }
        if may_be_a_mean(context) {
            let (usual, widest) = mean_to_both_sides::widths_s(context);
            let meaning = "half the time over which the reading is a mean";
            list.push(Parameter::normal(HALF_WIDTH, "s", 0.0, usual, meaning).within(0.0, widest));
        }
        list
    }
    fn starts(&self, context: &Context<'_>) -> Vec<Vec<f64>> {
        let apart = if moves_beside_the_base(context) { vec![vec![0.0], vec![1.0]] } else { vec![Vec::new()] };
        let width = may_be_a_mean(context).then_some(0.0);
        apart.into_iter().map(|start| start.into_iter().chain(width).collect()).collect()
    }
    fn came_later(&self) -> Vec<&'static str> {
        vec!["apart", HALF_WIDTH]
    }
    fn at_once(&self) -> &'static [&'static str] {
        &[HALF_WIDTH]
    }
    fn may_be_nothing(&self) -> &'static [&'static str] {
        &["apart", HALF_WIDTH]
    }
    fn far_sizes(&self, context: &Context<'_>, searched: &Problem<'_>) -> Vec<f64> {
        let followed = Course::on_a_clock(context).ok().and_then(|course| course.among(searched.inputs, searched.simulator));
        let run = searched.runs().into_iter().max_by_key(ExactSizeIterator::len);
        let most = self.parameters(context).first().map(|late| late.bounds.1);
        let Some((((column, time), run), most)) = followed.zip(searched.inputs.time_s.as_deref()).zip(run).zip(most) else {
            return Vec::new();
        };
        // a reading that is late stands beside a load that is early
        most_alike_s(time, &run, [&column, searched.response], most).into_iter().map(|late| -late).collect()
    }
    fn smooths(&self) -> bool {
        true
    }
    fn testable(&self, context: &Context<'_>) -> Result<(), String> {
        context.has(StageName::Inputs)?;
        context.needs_clock()?;
        Course::on_a_clock(context).map(|_| ())
    }
    fn with(&self, values: &[f64], context: &Context<'_>) -> Box<dyn Stage> {
        let mut further = values[1..].iter().copied();
        let mut next = |there: bool| if there { further.next().unwrap_or(0.0) } else { 0.0 };
        let [apart, half_width_s] = [moves_beside_the_base(context), may_be_a_mean(context)].map(&mut next);
        Box::new(Shift { late_s: values[0], apart, beside: beside_the_base(context), half_width_s })
    }
    fn sibling(&self, values: &[f64], context: &Context<'_>) -> Option<Box<dyn Stage>> {
        context.simulator.full_load().map(|_| Box::new(Slope(values[0])) as Box<dyn Stage>)
    }
    fn says(&self, fitted: &[FittedParameter]) -> String {
        said("the load", fitted)
    }
    fn told(&self, fitted: &[FittedParameter], context: &Context<'_>, _: &[(EffectId, Vec<FittedParameter>)]) -> String {
        said(Course::on_a_clock(context).map_or("the load", |course| course.name(context)), fitted)
    }
}

/// Greatest shift, share of the longest run: two rows of three are met by what was recorded for them.
pub(crate) const LARGEST_SHARE: f64 = 1.0 / 3.0;

fn said(whose: &str, fitted: &[FittedParameter]) -> String {
    let late = fitted[0].value;
    let way = if late < 0.0 { "early" } else { "late" };
    let mean = fitted.iter().find(|p| p.parameter.name == HALF_WIDTH && p.value > 0.0);
    let mean = mean.map_or(String::new(), |p| format!(", and the reading is {}", mean_to_both_sides::said(p.value)));
    format!("{whose} stands {} too {way} in the rows{mean}", with_sd(late.abs(), fitted[0].sd, "s"))
}
