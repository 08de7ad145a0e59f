//! The dielectric stiffens as it is compressed.

use crate::{
    data::context::Context,
    effects::composed::words::{Driver, InWords, Kinetics, Place},
    effects::effect::{About, Effect, Family, FittedParameter},
    text::percent_with_sd,
};
use truegap_core::{EffectId, Inputs, Parameter, Stage, simulator::StageName};

/// Stress that grows faster than strain.
pub struct StrainStiffening;

/// Strain at which the size is quoted.
const QUOTED_AT: f64 = 0.2;

struct Stiffening([f64; 2]);

impl Stiffening {
    /// `excess` of the stress at the quoted strain, a share `curved` of it quadratic in strain.
    fn new(values: &[f64]) -> Self {
        let (excess, curved) = (values[0], values[1]);
        Self([excess * (1.0 - curved) / QUOTED_AT, excess * curved / (QUOTED_AT * QUOTED_AT)])
    }
}

impl Stage for Stiffening {
    fn stiffening(&self) -> [f64; 2] {
        self.0
    }
}

/// Sibling: less and less of the load goes into strain, as a rational function of the load.
struct Saturating(f64);

impl Stage for Saturating {
    fn load(&self, _: &Inputs, load: &mut [f64]) {
        load.iter_mut().for_each(|load| *load /= 1.0 + 0.7 * self.0 * load.max(0.0));
    }
}

impl Effect for StrainStiffening {
    fn id(&self) -> EffectId {
        EffectId("strain_stiffening")
    }
    fn stage(&self) -> StageName {
        StageName::Beads
    }
    fn family(&self) -> Family {
        Family::StaticMechanics
    }
    fn in_words(&self, _: &Context<'_>) -> Option<InWords> {
        Some(InWords { place: Place::Mechanics, driver: Driver::Load, kinetics: Kinetics::Static })
    }
    fn about(&self) -> About {
        About {
            physics: "bonded, nearly incompressible beads bulge and stiffen as they are flattened; a foam closes its pores",
            equation: "stress = E e (1 + a e + b e^2), a = s (1 - c) / 0.2, b = s c / 0.04: s is the excess at a strain of 0.2",
            excitation: "load up to strains of several per cent",
            impostors: &["contact_toe_in", "load_cell_error", "dead_gap", "saturation", "plate_bending"],
            separates: "a curve of reading over load, the same at every rate and direction, that a thicker or stiffer layer cannot give; scales with strain, so a hotter, softer sensor shows more of it",
            source: "Gent & Meinecke, Polym. Eng. Sci. 10 (1970) 48 (bonded blocks); Gibson & Ashby, Cellular Solids, ch. 5 (foams)",
        }
    }
    fn parameters(&self, _: &Context<'_>) -> Vec<Parameter> {
        vec![
            Parameter::normal("excess", "1", 0.0, 0.5, "extra stress at a strain of 0.2, relative to a linear dielectric")
                .within(0.0, 10.0),
            Parameter::normal("curved", "1", 0.5, 0.5, "share of it that is quadratic in strain").within(0.0, 1.0),
        ]
    }
    fn starts(&self, _: &Context<'_>) -> Vec<Vec<f64>> {
        vec![vec![0.1], vec![0.9]]
    }
    fn testable(&self, context: &Context<'_>) -> Result<(), String> {
        context.has(StageName::Beads)?;
        context.needs_load()
    }
    fn with(&self, values: &[f64], _: &Context<'_>) -> Box<dyn Stage> {
        Box::new(Stiffening::new(values))
    }
    fn sibling(&self, values: &[f64], _: &Context<'_>) -> Option<Box<dyn Stage>> {
        Some(Box::new(Saturating(values[0])))
    }
    fn says(&self, fitted: &[FittedParameter]) -> String {
        format!(
            "the dielectric stiffens as it is compressed: {} more stress at a strain of 0.2 than a linear one",
            percent_with_sd(fitted[0].value, fitted[0].sd)
        )
    }
    fn told(&self, fitted: &[FittedParameter], context: &Context<'_>, _: &[(EffectId, Vec<FittedParameter>)]) -> String {
        if context.has_plates() {
            return self.says(fitted);
        }
        // such a base model is at a strain of 0.2 at its full load
        format!(
            "the instrument gives way less and less as the load grows: what the base model reaches at its full load takes {} more load",
            percent_with_sd(fitted[0].value, fitted[0].sd)
        )
    }
}
