//! The electrodes bend between and beyond the beads under load.

use crate::{
    data::context::Context,
    effects::composed::words::{Driver, InWords, Kinetics, Place},
    effects::effect::{About, Effect, Family, FittedParameter},
    text::{percent_with_sd, significant},
};
use truegap_core::{Drive, EffectId, Geometry, Parameter, Stage, simulator::StageName};

/// Load-driven bending: a sag from centre to rim, and a mean closing between the beads with it.
pub struct PlateBending;

/// Standard deviation of the sag at full load: thin electrodes on soft beads bend by a good part of the gap before calibration lets it be seen.
const USUAL: f64 = 0.2;

struct Bending {
    sag: f64,
    closing_ratio: f64,
}

impl Bending {
    /// Adds the bending at each row, `bent(load)` being 1 at full load.
    fn apply(&self, drive: &Drive<'_>, geometry: &mut Geometry<'_>, bent: impl Fn(f64) -> f64) {
        for (row, &load) in drive.load.iter().enumerate() {
            let sag = self.sag * bent(load);
            geometry.sag[row] += sag;
            geometry.gap[row] -= self.closing_ratio * sag;
        }
    }
}

impl Stage for Bending {
    fn geometry(&self, drive: &Drive<'_>, geometry: &mut Geometry<'_>) {
        self.apply(drive, geometry, |load| load);
    }
}

/// Sibling: a plate that is held by its own stretch as it bends, so that the deflection falls behind the load.
struct Stretched(Bending);

impl Stage for Stretched {
    fn geometry(&self, drive: &Drive<'_>, geometry: &mut Geometry<'_>) {
        self.0.apply(drive, geometry, |load| 1.25 * load / (1.0 + 0.25 * load.abs()));
    }
}

fn bending(values: &[f64]) -> Bending {
    Bending { sag: values[0], closing_ratio: values[1] }
}

impl Effect for PlateBending {
    fn id(&self) -> EffectId {
        EffectId("plate_bending")
    }
    fn stage(&self) -> StageName {
        StageName::Geometry
    }
    fn family(&self) -> Family {
        Family::Field
    }
    fn in_words(&self, _: &Context<'_>) -> Option<InWords> {
        Some(InWords { place: Place::Geometry, driver: Driver::Load, kinetics: Kinetics::Static })
    }
    fn about(&self) -> About {
        About {
            physics: "the electrodes are thin: under load they bend into the gaps between the beads, and as a whole from centre to rim",
            equation: "rim sag + s L, gap - q s L, in unloaded gaps, L over the full load: thin-plate deflection in proportion to the load",
            excitation: "load; two temperatures tell it from a softer dielectric",
            impostors: &["strain_stiffening", "eccentric_load", "contact_toe_in", "dead_gap"],
            separates: "in proportion to the load at once and at every temperature, while strain grows as the silicone softens",
            source: "Timoshenko & Woinowsky-Krieger, Theory of Plates and Shells, ch. 3 and 8",
        }
    }
    fn parameters(&self, _: &Context<'_>) -> Vec<Parameter> {
        vec![
            Parameter::normal(
                "sag",
                "unloaded gaps",
                0.0,
                USUAL,
                "rise of the rim above the centre at full load; negative where the rim comes down",
            )
            .within(-1.0, 1.0),
            Parameter::normal("closing_ratio", "1", 0.0, 0.3, "mean closing between the beads over the sag").within(-10.0, 10.0),
        ]
    }
    fn starts(&self, _: &Context<'_>) -> Vec<Vec<f64>> {
        vec![vec![0.3], vec![0.0], vec![-0.3]]
    }
    fn testable(&self, context: &Context<'_>) -> Result<(), String> {
        context.has(StageName::Geometry)?;
        context.needs_load()
    }
    fn with(&self, values: &[f64], _: &Context<'_>) -> Box<dyn Stage> {
        Box::new(bending(values))
    }
    fn sibling(&self, values: &[f64], _: &Context<'_>) -> Option<Box<dyn Stage>> {
        Some(Box::new(Stretched(bending(values))))
    }
    fn says(&self, fitted: &[FittedParameter]) -> String {
        let way = if fitted[0].value < 0.0 { "down against" } else { "up above" };
        format!(
            "the electrodes bend under load: at full load the rim has come {way} the centre by {} of the gap, and the gap closes by {} of that \
             between the beads",
            percent_with_sd(fitted[0].value.abs(), fitted[0].sd),
            significant(fitted[1].value * fitted[0].value.signum(), 2)
        )
    }
}
