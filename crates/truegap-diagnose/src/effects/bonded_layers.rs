//! What bonding does, as finite elements have computed it for this sensor.

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
use truegap_core::{Corrections, Dielectric, Drive, EffectId, FieldView, Parameter, Stage, simulator::StageName};

/// Beads and insulators that stick to the metal beside them, where the paper lets them slide.
pub struct BondedLayers;

struct Bonded {
    share: f64,
    computed: Arc<Corrections>,
}

impl Stage for Bonded {
    fn strain(&self, drive: &Drive<'_>, strain: &mut [f64]) {
        // of beads by a load that would bring sliding ones to the strain as it is, and by heat
        let (bonded, growth) = (self.computed.bonded_strain.smooth(), self.computed.held_growth());
        for (strain, celsius) in strain.iter_mut().zip(drive.temperature_c) {
            *strain += self.share * (bonded.at(*strain) - growth * (celsius - drive.reference_c) - *strain);
        }
    }
    fn dielectric(&self, drive: &Drive<'_>, factors: &mut Dielectric) {
        let growth = self.share * self.computed.insulator_growth();
        for (factor, celsius) in factors.insulator.iter_mut().zip(drive.temperature_c) {
            *factor /= 1.0 + growth * (celsius - drive.reference_c);
        }
    }
    fn field(&self, drive: &Drive<'_>, view: &FieldView<'_>, extra: &mut [f64]) {
        let (growth, mixing) = (self.share * self.computed.held_growth(), self.computed.mixing.smooth());
        for (row, extra) in extra.iter_mut().enumerate() {
            // by the load alone
            let strain = view.strain[row] + growth * (drive.temperature_c[row] - drive.reference_c);
            *extra += self.share * view.plates[row] * (mixing.at(strain) - 1.0);
        }
    }
}

/// Sibling: bonded beads that stay as much stiffer as they are at first, and keep the field of straight-sided ones.
struct Linear(Bonded);

/// A small strain, at which the sibling's stiffness is read off.
const SMALL: f64 = 1e-4;

impl Stage for Linear {
    fn strain(&self, drive: &Drive<'_>, strain: &mut [f64]) {
        let Bonded { share, computed } = &self.0;
        let softer = computed.bonded_strain(SMALL) / SMALL;
        for (strain, celsius) in strain.iter_mut().zip(drive.temperature_c) {
            let held = computed.held_growth() * (celsius - drive.reference_c);
            *strain += share * (*strain * softer - held - *strain);
        }
    }
    fn dielectric(&self, drive: &Drive<'_>, factors: &mut Dielectric) {
        self.0.dielectric(drive, factors);
    }
}

impl BondedLayers {
    fn computed(values: &[f64], context: &Context<'_>) -> Option<Bonded> {
        Some(Bonded { share: values[0], computed: context.foreseen().ok()?.clone() })
    }
}

impl Effect for BondedLayers {
    fn id(&self) -> EffectId {
        EffectId("bonded_layers")
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
    fn foreseen(&self) -> bool {
        true
    }
    fn about(&self) -> About {
        About {
            physics: "beads bonded to the plates bulge, stiffen and push upwards when heated; insulators bonded to metal follow it in the plane",
            equation: "strain, field around the beads, growth of beads and insulator as finite elements have them for this sensor, times a share near 1",
            excitation: "load up to strains of several per cent, better at two temperatures",
            impostors: &["strain_stiffening", "dead_gap", "permittivity_temperature"],
            separates: "no free number but a share near 1: stiffness, curve of reading over load and reading over temperature are tied together",
            source: "finite elements of a bonded bead cell, truegap_audit::corrections (docs/audit.md)",
        }
    }
    fn touches(&self) -> Vec<StageName> {
        vec![StageName::Beads, StageName::Dielectric, StageName::Field]
    }
    fn parameters(&self, _: &Context<'_>) -> Vec<Parameter> {
        vec![share("share of what finite elements compute for bonded layers; 0: they slide, 1: they stick")]
    }
    fn testable(&self, context: &Context<'_>) -> Result<(), String> {
        context.foreseen()?;
        context.has(StageName::Beads)?;
        context.needs_load()
    }
    fn with(&self, values: &[f64], context: &Context<'_>) -> Box<dyn Stage> {
        stage(Self::computed(values, context))
    }
    fn sibling(&self, values: &[f64], context: &Context<'_>) -> Option<Box<dyn Stage>> {
        Self::computed(values, context).map(|bonded| Box::new(Linear(bonded)) as Box<dyn Stage>)
    }
    fn says(&self, fitted: &[FittedParameter]) -> String {
        format!(
            "beads and insulators are bonded to their neighbours: {} of what finite elements compute for this sensor, where 0 is sliding and 1 is bonded",
            with_sd(fitted[0].value, fitted[0].sd, "1")
        )
    }
}
