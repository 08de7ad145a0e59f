//! A load off centre tilts the plate.

use crate::{
    data::context::Context,
    effects::composed::words::{Driver, InWords, Kinetics, Place},
    effects::{
        effect::{About, Effect, Family, FittedParameter},
        scale::full_strain,
    },
    text::percent_with_sd,
};
use truegap_core::{Drive, EffectId, Geometry, Parameter, Stage, simulator::StageName};

/// A rigid disc pressed down off its centre, on an even bed of springs or in a fixture that yields.
pub struct EccentricLoad;

/// Greatest tilt, as a share of the mean gap; the rim of a tilted plate comes down on the other one there.
const TOUCHES: f64 = 0.999;

struct Wedge {
    squared: f64,
    bed: f64,
    /// strain of a full load
    full: f64,
}

impl Wedge {
    fn of(values: &[f64], context: &Context<'_>) -> Self {
        Self { squared: values[0], bed: values[1], full: full_strain(context) }
    }
}

impl Stage for Wedge {
    fn geometry(&self, drive: &Drive<'_>, geometry: &mut Geometry<'_>) {
        let arm = 4.0 * self.squared.max(0.0).sqrt();
        // where the gap itself is given there is no load, and the bed is all there is
        let bed = if drive.load.iter().any(|load| *load > 0.0) { self.bed } else { 1.0 };
        for ((tilt, &strain), load) in geometry.tilt.iter_mut().zip(geometry.strain).zip(drive.load) {
            let own = arm * (bed * strain / (1.0 - strain) + (1.0 - bed) * self.full * load);
            *tilt = tilt.hypot(own).min(TOUCHES);
        }
    }
}

/// Sibling: a tilt that grows a little faster than the load.
struct Faster(Wedge);

impl Stage for Faster {
    fn geometry(&self, drive: &Drive<'_>, geometry: &mut Geometry<'_>) {
        let arm = 4.0 * self.0.squared.max(0.0).sqrt() * self.0.full;
        let own = |load: f64| arm * load.max(0.0).powf(1.2);
        geometry.tilt.iter_mut().zip(drive.load).for_each(|(tilt, load)| *tilt = tilt.hypot(own(*load)).min(TOUCHES));
    }
}

impl Effect for EccentricLoad {
    fn id(&self) -> EffectId {
        EffectId("eccentric_load")
    }
    fn stage(&self) -> StageName {
        StageName::LoadPath
    }
    fn family(&self) -> Family {
        Family::StaticMechanics
    }
    fn in_words(&self, _: &Context<'_>) -> Option<InWords> {
        Some(InWords { place: Place::Geometry, driver: Driver::Load, kinetics: Kinetics::Static })
    }
    fn about(&self) -> About {
        About {
            physics: "the load acts off centre, so the plate tilts as it comes down and the gap is a wedge",
            equation: "tilt t = 4 (a / r) (b e / (1 - e) + (1 - b) E L): rim against centre over the mean gap, E the strain of a full load at the reference temperature; a disc over a wedge reads 2 / (1 + sqrt(1 - t^2)) times the flat one, over dome and wedge their common integral",
            excitation: "load up to strains of several per cent",
            impostors: &["strain_stiffening", "contact_toe_in", "load_cell_error", "plate_bending", "dead_gap"],
            separates: "grows as the square of the load, the same up and down; gone when the load is centred",
            source: "Winkler bed under a rigid disc: moment F a against stiffness k pi r^4 / 4 (Timoshenko, Strength of Materials II, ch. 1)",
        }
    }
    fn touches(&self) -> Vec<StageName> {
        vec![StageName::Geometry]
    }
    fn parameters(&self, _: &Context<'_>) -> Vec<Parameter> {
        vec![
            Parameter::normal(
                "arm_squared",
                "1",
                0.0,
                0.05,
                "square of the distance from the centre over the radius; the reading is smooth in the square",
            )
            .within(0.0, 0.5),
            Parameter::normal(
                "bed",
                "1",
                0.5,
                0.5,
                "1: the beads alone resist the tilt, softer when warm; 0: it grows with the load alone",
            )
            .within(0.0, 1.0),
        ]
    }
    fn starts(&self, _: &Context<'_>) -> Vec<Vec<f64>> {
        vec![vec![1.0], vec![0.0]]
    }
    fn testable(&self, context: &Context<'_>) -> Result<(), String> {
        context.has(StageName::LoadPath)?;
        context.has(StageName::Geometry)?;
        context.needs_load()
    }
    fn with(&self, values: &[f64], context: &Context<'_>) -> Box<dyn Stage> {
        Box::new(Wedge::of(values, context))
    }
    fn sibling(&self, values: &[f64], context: &Context<'_>) -> Option<Box<dyn Stage>> {
        Some(Box::new(Faster(Wedge::of(values, context))))
    }
    fn says(&self, fitted: &[FittedParameter]) -> String {
        let arm = fitted[0].value.max(0.0).sqrt();
        let sd = if arm > 0.0 { fitted[0].sd / (2.0 * arm) } else { fitted[0].sd.sqrt() };
        format!("the load acts off centre, by {} of the radius, and tilts the plate as it comes down", percent_with_sd(arm, sd))
    }
}
