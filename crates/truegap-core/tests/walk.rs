//! The walk down the chain: its places in order, each seen once, and what is checked before it begins.
#![allow(clippy::unwrap_used)]

use std::sync::Mutex;
use truegap_core::{
    Dielectric, Drive, FieldView, GapReading, Geometry, Inputs, Parameter, PlateReading, Plates, Readout, Refusal, Role,
    SimulationError, Simulator, Stage, StageName, Stiffness, walk, walk_without_plates,
};

/// Springs of stiffness 10 full loads below a plate that reads 1 / gap; `sized` says whether a field outside of it can be told.
struct Spring {
    parameters: Vec<Parameter>,
    sized: bool,
    plates: bool,
}

impl Spring {
    fn new(sized: bool, plates: bool) -> Self {
        Self { parameters: vec![Parameter::normal("gain", "pF", 1.0, 0.1, "reading without load")], sized, plates }
    }
}

struct Filled {
    gain: f64,
    sized: bool,
}

impl Plates for Filled {
    fn strain(&self, drive: &Drive<'_>, row: usize, stiffness: Stiffness) -> Result<f64, Refusal> {
        let strain = drive.load[row] / (10.0 * stiffness.modulus) - stiffness.stiffening[0];
        if strain < 1.0 { Ok(strain) } else { Err(Refusal::Touches { strain }) }
    }
    fn reading(&self, _: &Drive<'_>, row: usize, geometry: &Geometry<'_>, factors: &Dielectric) -> Result<PlateReading, Refusal> {
        let plates = self.gain * factors.beads[row] / (1.0 - geometry.strain[row] + geometry.gap[row]);
        Ok(PlateReading { value: plates, gap: self.sized.then_some(GapReading { aspect: 0.1, plates }) })
    }
    fn readout(&self) -> Result<Readout, SimulationError> {
        Ok(Readout { zero: self.gain, span: self.gain / 9.0 })
    }
}

impl Simulator for Spring {
    fn name(&self) -> &str {
        "spring"
    }
    fn unit(&self) -> &str {
        "pF"
    }
    fn parameters(&self) -> &[Parameter] {
        &self.parameters
    }
    fn needs(&self) -> &[Role] {
        &[Role::Force]
    }
    fn lacks(&self, _: StageName) -> Option<&'static str> {
        None
    }
    fn full_load(&self) -> Option<f64> {
        Some(2.0)
    }
    fn respond(&self, values: &[f64], inputs: &Inputs, stages: &[&dyn Stage]) -> Result<Vec<f64>, SimulationError> {
        if self.plates {
            let gain = values.first().copied().unwrap_or(f64::NAN);
            return walk(self, &Filled { gain, sized: self.sized }, values, inputs, stages);
        }
        walk_without_plates(self, values, inputs, stages, |drive| Ok((drive.load.to_vec(), Readout { zero: 0.0, span: 1.0 })))
    }
}

/// Writes down where it is asked, and adds a little there.
#[derive(Default)]
struct Diary(Mutex<Vec<&'static str>>);

impl Diary {
    fn note(&self, place: &'static str) {
        self.0.lock().unwrap().push(place);
    }
}

impl Stage for Diary {
    fn load(&self, _: &Inputs, load: &mut [f64]) {
        self.note("load path");
        load.iter_mut().for_each(|l| *l += 1.0);
    }
    fn thermal(&self, _: &Inputs, temperature_c: &mut [f64]) {
        self.note("thermal path");
        assert_eq!(temperature_c, [20.0; 2], "no thermometer: the reference temperature");
        temperature_c.iter_mut().for_each(|t| *t += 5.0);
    }
    fn modulus(&self, drive: &Drive<'_>, factor: &mut [f64]) {
        self.note("modulus");
        assert_eq!((drive.load, drive.temperature_c, drive.full_load), (&[1.0, 2.0][..], &[25.0; 2][..], 2.0));
        factor.iter_mut().for_each(|f| *f *= 2.0);
    }
    fn stiffening(&self) -> [f64; 2] {
        [-0.05, 0.0]
    }
    fn strain(&self, _: &Drive<'_>, strain: &mut [f64]) {
        self.note("strain");
        strain.iter_mut().for_each(|e| *e += 0.2);
    }
    fn geometry(&self, _: &Drive<'_>, geometry: &mut Geometry<'_>) {
        self.note("geometry");
        assert_eq!((geometry.warp_kelvin.as_slice(), geometry.warp_factor), (&[5.0; 2][..], 0.0));
        geometry.gap.iter_mut().for_each(|g| *g += 0.1);
    }
    fn dielectric(&self, _: &Drive<'_>, factors: &mut Dielectric) {
        self.note("dielectric");
        factors.beads.iter_mut().for_each(|f| *f *= 3.0);
    }
    fn field(&self, _: &Drive<'_>, view: &FieldView<'_>, extra: &mut [f64]) {
        self.note("field");
        extra.iter_mut().zip(view.plates).zip(view.aspect).for_each(|((extra, plates), aspect)| *extra += aspect * plates);
    }
    fn readout(&self, _: &Drive<'_>, readout: &Readout, value: &mut [f64]) {
        self.note("readout");
        value.iter_mut().for_each(|v| *v += readout.zero);
    }
}

fn pressed() -> Inputs {
    Inputs { run: vec![1; 2], force_n: Some(vec![0.0, 2.0]), ..Inputs::default() }
}

fn walked(model: &Spring) -> (Vec<f64>, Vec<&'static str>) {
    let diary = Diary::default();
    let response = model.respond(&[7.0], &pressed(), &[&diary]).unwrap();
    (response, diary.0.into_inner().unwrap())
}

#[test]
fn every_place_is_passed_once_and_in_the_order_of_the_chain() {
    let (response, places) = walked(&Spring::new(true, true));
    assert_eq!(places, ["load path", "thermal path", "modulus", "strain", "geometry", "dielectric", "field", "readout"]);
    // by hand: strain load / 20 + 0.05 + 0.2, gap 0.1 more, permittivity times 3, a tenth more by the field, 7 added by the readout
    for (value, load) in response.iter().zip([1.0, 2.0]) {
        let plates = 7.0 * 3.0 / (1.0 - (load / 20.0 + 0.25) + 0.1);
        approx::assert_relative_eq!(*value, 1.1 * plates + 7.0, max_relative = 1e-14);
    }
}

#[test]
fn plates_of_unknown_size_have_no_field_outside() {
    let (_, places) = walked(&Spring::new(false, true));
    assert_eq!(places, ["load path", "thermal path", "modulus", "strain", "geometry", "dielectric", "readout"]);
}

#[test]
fn without_plates_only_the_two_paths_and_the_readout_act() {
    let (response, places) = walked(&Spring::new(true, false));
    assert_eq!((response, places), (vec![1.0, 2.0], vec!["load path", "thermal path", "readout"]));
}

#[test]
fn what_the_model_cannot_answer_is_an_error_with_its_row() {
    let model = Spring::new(true, true);
    let error = |values: &[f64], inputs: &Inputs| model.respond(values, inputs, &[]).unwrap_err();
    let wrong = SimulationError::WrongNumberOfValues { model: "spring".into(), expected: 1, given: 2 };
    assert_eq!(error(&[1.0, 2.0], &pressed()), wrong);
    let missing = SimulationError::MissingColumn { model: "spring".into(), role: Role::Force };
    assert_eq!(error(&[1.0], &Inputs { force_n: None, ..pressed() }), missing);
    let heavy = Inputs { force_n: Some(vec![0.0, 24.0]), ..pressed() };
    assert_eq!(error(&[1.0], &heavy), SimulationError::GapCloses { row: 1, load_si: 24.0, strain: 1.2 });
    assert!(matches!(error(&[f64::INFINITY], &pressed()), SimulationError::NotFinite { row: 0, .. }));
}

/// By hand: a load of one full load strains a tenth, less what both stiffenings take.
#[test]
fn stiffenings_of_several_stages_add_up() {
    struct Stiff(f64);
    impl Stage for Stiff {
        fn stiffening(&self) -> [f64; 2] {
            [self.0, 0.0]
        }
    }
    let response = Spring::new(false, true).respond(&[7.0], &pressed(), &[&Stiff(0.02), &Stiff(0.03)]).unwrap();
    approx::assert_relative_eq!(response[1], 7.0 / (1.0 - 0.1 + 0.05), max_relative = 1e-14);
}
