//! A stage for every place of the chain, and the reading with it.

use super::centre;
use truegap_core::{Dielectric, Drive, FieldView, Geometry, Inputs, Readout, SimulationError, Simulator, Stage};
use truegap_model::Stack;

/// A stage made of closures' worth of numbers: each field acts at its own place.
#[derive(Default)]
pub struct Plug {
    pub modulus: f64,
    pub stiffening: [f64; 2],
    pub strain: f64,
    pub gap: f64,
    pub warp: Option<f64>,
    pub tilt: f64,
    pub sag: f64,
    pub beads: f64,
    pub insulator: f64,
    pub field_pf: f64,
    pub readout_span: f64,
    pub hotter: f64,
    pub load: f64,
}

impl Stage for Plug {
    fn load(&self, _: &Inputs, load: &mut [f64]) {
        load.iter_mut().for_each(|l| *l += self.load);
    }
    fn thermal(&self, _: &Inputs, temperature_c: &mut [f64]) {
        temperature_c.iter_mut().for_each(|t| *t += self.hotter);
    }
    fn modulus(&self, _: &Drive<'_>, factor: &mut [f64]) {
        factor.iter_mut().for_each(|f| *f *= 1.0 + self.modulus);
    }
    fn stiffening(&self) -> [f64; 2] {
        self.stiffening
    }
    fn strain(&self, _: &Drive<'_>, strain: &mut [f64]) {
        strain.iter_mut().for_each(|e| *e += self.strain);
    }
    fn geometry(&self, _: &Drive<'_>, geometry: &mut Geometry<'_>) {
        geometry.gap.iter_mut().for_each(|g| *g += self.gap);
        geometry.tilt.iter_mut().for_each(|t| *t += self.tilt);
        geometry.sag.iter_mut().for_each(|s| *s += self.sag);
        geometry.warp_factor = self.warp.unwrap_or(geometry.warp_factor);
    }
    fn dielectric(&self, _: &Drive<'_>, factors: &mut Dielectric) {
        factors.beads.iter_mut().for_each(|f| *f *= 1.0 + self.beads);
        factors.insulator.iter_mut().for_each(|f| *f *= 1.0 + self.insulator);
    }
    fn field(&self, _: &Drive<'_>, view: &FieldView<'_>, extra: &mut [f64]) {
        assert!(view.aspect.iter().all(|a| (0.01..0.04).contains(a)) && view.plates.iter().all(|c| (10.0..20.0).contains(c)));
        extra.iter_mut().for_each(|x| *x += self.field_pf);
    }
    fn readout(&self, _: &Drive<'_>, readout: &Readout, value: &mut [f64]) {
        value.iter_mut().for_each(|v| *v += self.readout_span * readout.span);
    }
}

/// One row: 2 N at 40 degrees Celsius.
pub fn respond(model: &Stack, plug: Plug) -> f64 {
    at(model, 2.0, 40.0, &plug).unwrap()
}

pub fn at(model: &Stack, force_n: f64, temperature_c: f64, plug: &Plug) -> Result<f64, SimulationError> {
    let inputs =
        Inputs { run: vec![1], force_n: Some(vec![force_n]), temperature_c: Some(vec![temperature_c]), ..Inputs::default() };
    Ok(model.respond(&centre(model), &inputs, &[plug])?[0])
}
