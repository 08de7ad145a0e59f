//! What beads leave of the electrode's warp, as finite elements have computed it for this sensor.

use crate::{
    data::context::Context,
    effects::composed::words::{Driver, InWords, Kinetics, Place},
    effects::{
        effect::{About, Effect, Family, FittedParameter},
        foreseen::{share, stage},
    },
    text::with_sd,
};
use std::sync::Arc;
use truegap_core::{Corrections, Drive, EffectId, FieldView, Geometry, Parameter, Stage, simulator::StageName};

/// An electrode that wants to warp and is held down by the beads.
pub struct HeldWarp;

struct Held {
    share: f64,
    /// curvature of the free plate in the base model
    free: f64,
    computed: Arc<Corrections>,
}

impl Held {
    fn add(&self, drive: &Drive<'_>, view: &FieldView<'_>, extra: &mut [f64], warp: impl Fn(f64, f64) -> f64) {
        for (row, extra) in extra.iter_mut().enumerate() {
            let kelvin = drive.temperature_c[row] - drive.reference_c;
            *extra += self.share * view.plates[row] * (warp(kelvin, drive.load[row]) - 1.0);
        }
    }
}

impl Stage for Held {
    fn geometry(&self, _: &Drive<'_>, geometry: &mut Geometry<'_>) {
        geometry.warp_factor -= self.share * self.free;
    }
    fn field(&self, drive: &Drive<'_>, view: &FieldView<'_>, extra: &mut [f64]) {
        self.add(drive, view, extra, self.computed.warps());
    }
}

/// Sibling: what is left of the warp is the same under load.
struct Unpressed(Held);

impl Stage for Unpressed {
    fn geometry(&self, drive: &Drive<'_>, geometry: &mut Geometry<'_>) {
        self.0.geometry(drive, geometry);
    }
    fn field(&self, drive: &Drive<'_>, view: &FieldView<'_>, extra: &mut [f64]) {
        let warp = self.0.computed.warps();
        self.0.add(drive, view, extra, |kelvin, _| warp(kelvin, 0.0));
    }
}

impl HeldWarp {
    fn computed(values: &[f64], context: &Context<'_>) -> Option<Held> {
        let free = if context.simulator.warps() == Some(true) { 1.0 } else { 0.0 };
        Some(Held { share: values[0], free, computed: context.foreseen().ok()?.clone() })
    }
}

impl Effect for HeldWarp {
    fn id(&self) -> EffectId {
        EffectId("held_warp")
    }
    fn stage(&self) -> StageName {
        StageName::Geometry
    }
    fn family(&self) -> Family {
        Family::Thermal
    }
    fn in_words(&self, _: &Context<'_>) -> Option<InWords> {
        Some(InWords { place: Place::Geometry, driver: Driver::Temperature, kinetics: Kinetics::Static })
    }
    fn foreseen(&self) -> bool {
        true
    }
    fn about(&self) -> About {
        About {
            physics: "beads hold the bimetal electrode down: only its rim beyond the last bead curls",
            equation: "curvature = (1 - h) k(T), C + h C_plates (w(T, L) - 1), k of the free bimetal, w by a plate on bonded beads for this sensor, h near 1",
            excitation: "temperature that moves by several kelvin",
            impostors: &["electrode_warp", "permittivity_temperature", "gain_drift"],
            separates: "no free number but a share near 1: the even part of the reading over temperature is gone, and most of what is left goes under little load",
            source: "plate on rings of springs and disc with contact, truegap_audit::corrections (docs/audit.md, docs/disc.md)",
        }
    }
    fn touches(&self) -> Vec<StageName> {
        vec![StageName::Geometry, StageName::Field]
    }
    fn parameters(&self, _: &Context<'_>) -> Vec<Parameter> {
        vec![share("how far beads hold the electrode as finite elements compute; 0: as in the base model, 1: as on bonded beads")]
    }
    fn testable(&self, context: &Context<'_>) -> Result<(), String> {
        context.foreseen()?;
        context.has(StageName::Geometry)?;
        context.simulator.warps().ok_or("the base model has no electrode of two metals")?;
        context.needs_temperature(2.0)
    }
    fn with(&self, values: &[f64], context: &Context<'_>) -> Box<dyn Stage> {
        stage(Self::computed(values, context))
    }
    fn sibling(&self, values: &[f64], context: &Context<'_>) -> Option<Box<dyn Stage>> {
        Self::computed(values, context).map(|held| Box::new(Unpressed(held)) as Box<dyn Stage>)
    }
    fn says(&self, fitted: &[FittedParameter]) -> String {
        format!(
            "the beads hold the warping electrode: {}, where 0 is the base model's electrode and 1 one on bonded beads as finite elements compute it",
            with_sd(fitted[0].value, fitted[0].sd, "1")
        )
    }
}
