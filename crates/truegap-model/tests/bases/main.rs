//! The base models other than the stack: what they answer, what they are scaled with, what they refuse.
#![allow(clippy::unwrap_used)]

mod driven;

use approx::assert_relative_eq;
use std::sync::Arc;
use truegap_core::{
    Dielectric, Drive, FieldView, Geometry, Inputs, Parameter, Readout, Role, SimulationError, Simulator, Stage,
    simulator::StageName,
};
use truegap_model::{
    Asked, BaseError, BaseModel, BaseOptions, External, ExternalOptions, Grid, Recorded, Responder, ResponseScale, StackOptions,
    Who, base_model, cases::default_sensor,
};

fn built(model: &str, inputs: &Inputs, response: &[f64], unit: &str) -> Box<dyn Simulator> {
    base_model(model, Some(&default_sensor().unwrap()), tabled(), Recorded { inputs, response, unit }).unwrap()
}

fn pressed(pressures: &[f64]) -> Inputs {
    Inputs { run: vec![1; pressures.len()], pressure_pa: Some(pressures.to_vec()), ..Inputs::default() }
}

/// Strain, gap, permittivity and field of a row, as numbers.
#[derive(Default)]
struct Plug {
    strain: f64,
    gap: f64,
    beads: f64,
    sag: f64,
    per_plate: f64,
    zero_and_span: [f64; 2],
}

impl Stage for Plug {
    fn strain(&self, _: &Drive<'_>, strain: &mut [f64]) {
        strain.iter_mut().for_each(|e| *e += self.strain);
    }
    fn geometry(&self, _: &Drive<'_>, geometry: &mut Geometry<'_>) {
        geometry.gap.iter_mut().for_each(|g| *g += self.gap);
        geometry.sag.iter_mut().for_each(|s| *s += self.sag);
    }
    fn dielectric(&self, _: &Drive<'_>, factors: &mut Dielectric) {
        factors.beads.iter_mut().for_each(|f| *f *= 1.0 + self.beads);
    }
    fn field(&self, _: &Drive<'_>, view: &FieldView<'_>, extra: &mut [f64]) {
        for (row, extra) in extra.iter_mut().enumerate() {
            *extra += self.per_plate * view.aspect[row] * view.plates[row];
        }
    }
    fn readout(&self, _: &Drive<'_>, readout: &Readout, value: &mut [f64]) {
        value.iter_mut().for_each(|v| *v += self.zero_and_span[0] * readout.zero + self.zero_and_span[1] * readout.span);
    }
}

#[test]
fn parallel_plates_follow_equation_2() {
    let inputs = pressed(&[0.0, 20e3, 50e3, 100e3]);
    let model = built("parallel-plate", &inputs, &[240.0, 239.0, 237.0, 230.0], "counts");
    let values = [250.0, -10.0, 4.0];
    let response = model.respond(&values, &inputs, &[]).unwrap();
    for (value, pressure) in response.iter().zip([0.0, 0.2, 0.5, 1.0]) {
        assert_relative_eq!(*value, 250.0 - 10.0 / (1.0 - pressure / 4.0), max_relative = 1e-14);
    }
    assert_eq!((model.needs(), model.full_load(), model.unit()), (&[Role::Pressure][..], Some(100e3), "counts"));
    assert_eq!(model.load(&inputs).unwrap(), [0.0, 0.2, 0.5, 1.0]);
    // extra strain, gap and permittivity by hand at half load: 1 - 0.125 - 0.05 of the gap
    let plug = Plug { strain: 0.05, gap: 0.02, beads: 0.1, zero_and_span: [0.0, 0.5], ..Plug::default() };
    let expected = 250.0 - 10.0 / (0.825 / 1.1 + 0.02) - 0.5 * 10.0 / 3.0;
    assert_relative_eq!(model.respond(&values, &inputs, &[&plug]).unwrap()[2], expected, max_relative = 1e-14);
}

/// At the centre of its priors the model is the straight line through the recording, to the curvature of 1 / (1 - strain).
#[test]
fn the_priors_of_parallel_plates_start_at_the_recording() {
    let pressures: Vec<f64> = (0..=10).map(|i| f64::from(i) * 1e4).collect();
    let counts: Vec<f64> = pressures.iter().map(|p| 240.0 - 8.0 * p / 1e5).collect();
    let inputs = pressed(&pressures);
    let model = built("parallel-plate", &inputs, &counts, "counts");
    let centre: Vec<f64> = model.parameters().iter().map(|p| p.centre()).collect();
    let response = model.respond(&centre, &inputs, &[]).unwrap();
    assert_relative_eq!(response[0], 240.0, epsilon = 1e-9);
    assert_relative_eq!(response[10], 232.0, epsilon = 1e-9);
    assert!(model.parameters()[1].centre() < 0.0 && model.parameters()[1].sd() > 100.0);
}

#[test]
fn gap_plates_follow_equation_1() {
    let gaps = vec![8e-3, 4e-3, 1e-3];
    let inputs = Inputs { run: vec![1; 3], gap_m: Some(gaps), ..Inputs::default() };
    let model = built("gap-plate", &inputs, &[1.0, 2.0, 8.0], "pF");
    assert_relative_eq!(model.parameters()[0].centre(), 8e-3, max_relative = 1e-14);
    assert_eq!(model.parameters()[0].unit, "pF m");
    let response = model.respond(&[4e-3], &inputs, &[]).unwrap();
    response.iter().zip([0.5, 1.0, 4.0]).for_each(|(a, b)| assert_relative_eq!(*a, b, max_relative = 1e-14));
    // 1 % of the widest gap is 80 um of dead gap; a strain of 1 % takes as much away
    let dead = model.respond(&[4e-3], &inputs, &[&Plug { gap: 0.01, ..Plug::default() }]).unwrap();
    assert_relative_eq!(dead[2], 4e-3 / 1.08e-3, max_relative = 1e-13);
    let both = model.respond(&[4e-3], &inputs, &[&Plug { gap: 0.01, strain: 0.01, ..Plug::default() }]).unwrap();
    assert_relative_eq!(both[2], 4.0, max_relative = 1e-13);
    // field: 4e-3 pF m is a disc of radius sqrt(4e-15 / (pi eps0)) = 11.99 mm
    let radius = (4e-15 / (8.854e-12 * std::f64::consts::PI)).sqrt();
    let field = model.respond(&[4e-3], &inputs, &[&Plug { per_plate: 1.0, ..Plug::default() }]).unwrap();
    field.iter().zip([0.5, 1.0, 4.0]).for_each(|(a, b)| assert_relative_eq!(*a, b + 4e-3 / radius, max_relative = 1e-13));
    let read = model.respond(&[4e-3], &inputs, &[&Plug { zero_and_span: [1.0, 1.0], ..Plug::default() }]).unwrap();
    assert_relative_eq!(read[0], 0.5 + 4.0, max_relative = 1e-13);
    let shut = model.respond(&[4e-3], &inputs, &[&Plug { strain: 0.2, ..Plug::default() }]);
    assert!(matches!(shut, Err(SimulationError::GapCloses { row: 2, .. })));
}

/// A dome whose rim sags by the mean gap: ln(3) times the flat capacitance.
#[test]
fn a_dome_over_plates_of_unknown_size_has_its_logarithm() {
    let inputs = Inputs { run: vec![1], gap_m: Some(vec![2e-3]), ..Inputs::default() };
    let model = built("gap-plate", &inputs, &[1.0], "pF");
    let bent = model.respond(&[2e-3], &inputs, &[&Plug { sag: 1.0, ..Plug::default() }]).unwrap();
    assert_relative_eq!(bent[0], 3f64.ln(), max_relative = 1e-13);
}

#[test]
fn a_constant_stays_and_an_external_simulation_is_repeated() {
    let inputs = Inputs { run: vec![1; 3], simulated: Some(vec![1.0, 2.0, 4.0]), ..Inputs::default() };
    let constant = built("constant", &inputs, &[5.0, 6.0, 9.0], "ppm");
    assert_eq!(constant.respond(&[7.0], &inputs, &[]).unwrap(), [7.0; 3]);
    assert_eq!(constant.respond(&[7.0], &inputs, &[&Plug { zero_and_span: [0.0, 0.5], ..Plug::default() }]).unwrap(), [9.0; 3]);
    assert_eq!((constant.parameters()[0].centre(), constant.parameters()[0].sd()), (7.0, 40.0));
    let external = built("external", &inputs, &[5.0, 6.0, 9.0], "pF");
    assert!(external.parameters().is_empty());
    assert_eq!(external.respond(&[], &inputs, &[]).unwrap(), [1.0, 2.0, 4.0]);
    let scale = ResponseScale { unit: "pF".into(), range: 4.0, ..ResponseScale::default() };
    let free = External::new(&scale, 20.0, ExternalOptions { gain_sd: Some(0.05), offset: true, own_unit: None });
    assert_eq!(free.respond(&[1.5, 0.25], &inputs, &[]).unwrap(), [1.75, 3.25, 6.25]);
    let offset = External::new(&scale, 20.0, ExternalOptions { gain_sd: None, offset: true, own_unit: None });
    assert_eq!(offset.respond(&[0.25], &inputs, &[]).unwrap(), [1.25, 2.25, 4.25]);
}

/// Options that every base model can be built with: the table rises in proportion to the pressure.
fn tabled() -> BaseOptions {
    let table = Grid::of(&pressed(&[0.0, 60e3]), &[1.0, 2.0], "pF").unwrap();
    BaseOptions { table: Some(table), ..BaseOptions::default() }
}

/// What is written beside a diagnosis builds the same model without the recording.
#[test]
fn a_written_base_model_is_the_same_when_read_again() {
    let mut inputs = pressed(&[0.0, 20e3, 50e3]);
    inputs.gap_m = Some(vec![3e-3, 2e-3, 1e-3]);
    inputs.simulated = Some(vec![1.0, 2.0, 3.0]);
    let response = [1.0, 1.3, 2.1];
    for name in truegap_model::BASE_MODELS {
        let recorded = Recorded { inputs: &inputs, response: &response, unit: "pF" };
        let written = BaseModel::of(name, Some("singletact-s15-4.5n"), tabled(), recorded).unwrap();
        let text = toml::to_string(&written).unwrap();
        let again: BaseModel = toml::from_str(&text).unwrap();
        assert_eq!(written, again, "{text}");
        // whatever is made for a recording can be
        again.check().unwrap();
        let sensor = default_sensor().unwrap();
        let model = again.build(Some(&sensor)).unwrap();
        assert_eq!(model.name(), name);
        assert_eq!(model.parameters(), written.build(Some(&sensor)).unwrap().parameters());
    }
}

/// A model that says so answers for one row by itself as it does for that row among others.
#[test]
fn rows_that_do_not_depend_on_one_another_may_be_asked_for_alone() {
    let pressures = [0.0, 20e3, 5e3, 50e3];
    let gaps = [3e-3, 2e-3, 2.5e-3, 1e-3];
    let inputs = |rows: &[usize]| {
        let pick = |column: &[f64]| Some(rows.iter().map(|row| column[*row]).collect::<Vec<_>>());
        let force = pick(&pressures.map(|p| p / 5e4 * 3.0));
        Inputs { gap_m: pick(&gaps), force_n: force, time_s: pick(&[0.0, 1.0, 2.0, 3.0]), ..pressed(&pick(&pressures).unwrap()) }
    };
    let all = inputs(&[0, 1, 2, 3]);
    let response = [1.0, 1.3, 1.1, 2.1];
    for name in ["stack", "parallel-plate", "gap-plate", "linear", "table"] {
        let model = built(name, &all, &response, "pF");
        assert!(model.row_by_row(), "{name}");
        let whole = model.respond(&model.centre(), &all, &[]).unwrap();
        for (row, value) in whole.iter().enumerate() {
            assert_eq!(model.respond(&model.centre(), &inputs(&[row]), &[]).unwrap(), [*value], "{name}, row {row}");
        }
    }
}

#[test]
fn a_base_model_that_cannot_be_built_says_why() {
    let inputs = Inputs { run: vec![1], ..Inputs::default() };
    let fails = |model: &str, response: &[f64]| {
        let recorded = Recorded { inputs: &inputs, response, unit: "pF" };
        base_model(model, None, StackOptions::default(), recorded).err().unwrap()
    };
    assert_eq!(fails("stack", &[1.0]), BaseError::NoSensor);
    assert!(fails("plate", &[1.0]).to_string().contains("parallel-plate"));
    assert_eq!(fails("parallel-plate", &[1.0]), BaseError::NoColumn { model: "parallel-plate", role: "pressure or force" });
    assert!(matches!(fails("gap-plate", &[1.0]), BaseError::NoColumn { role: "gap", .. }));
    assert!(matches!(fails("external", &[1.0]), BaseError::NoColumn { role: "simulated", .. }));
    assert!(matches!(fails("constant", &[]), BaseError::Empty { .. }));
}

#[test]
fn stages_that_mean_nothing_are_refused_with_a_reason() {
    let mut inputs = pressed(&[0.0, 1e3]);
    inputs.gap_m = Some(vec![1e-3, 2e-3]);
    inputs.simulated = Some(vec![1.0, 2.0]);
    let model = |name| built(name, &inputs, &[1.0, 2.0], "pF");
    assert!(model("constant").lacks(StageName::Beads).unwrap().contains("no load"));
    assert!(model("external").lacks(StageName::Field).unwrap().contains("column"));
    assert!(model("parallel-plate").lacks(StageName::Field).unwrap().contains("size"));
    assert!(model("gap-plate").lacks(StageName::LoadPath).unwrap().contains("gap is given"));
    for name in truegap_model::BASE_MODELS {
        assert_eq!(model(name).lacks(StageName::Readout), None);
    }
    assert_eq!(model("stack").lacks(StageName::Beads), None);
}

/// One value too many, one too few: what is expected and what was given, whatever the model.
#[test]
fn a_wrong_number_of_parameter_values_says_how_many_are_expected() {
    let mut inputs = pressed(&[0.0, 1e3]);
    inputs.force_n = Some(vec![0.0, 1.0]);
    inputs.gap_m = Some(vec![1e-3, 2e-3]);
    inputs.simulated = Some(vec![1.0, 2.0]);
    for name in truegap_model::BASE_MODELS {
        let model = built(name, &inputs, &[1.0, 2.0], "pF");
        let expected = model.parameters().len();
        for given in [expected + 1, expected.saturating_sub(1)].into_iter().filter(|given| *given != expected) {
            let wrong = SimulationError::WrongNumberOfValues { model: name.into(), expected, given };
            let error = model.respond(&vec![1.0; given], &inputs, &[]).unwrap_err();
            assert_eq!(error, wrong);
            assert!(error.to_string().contains(&format!("`{name}` has {expected} parameters, but {given} values")), "{error}");
        }
    }
}

#[test]
fn base_models_say_what_they_can() {
    let mut inputs = pressed(&[0.0, 1e3]);
    inputs.gap_m = Some(vec![1e-3, 2e-3]);
    inputs.simulated = Some(vec![1.0, 2.0]);
    let can = |name: &str| {
        let model = built(name, &inputs, &[1.0, 2.0], "pF");
        (model.has_insulator(), model.moves(), model.knows_its_level())
    };
    assert_eq!(can("stack"), (true, true, true));
    // their priors come from the recording, and they have one dielectric at most
    for name in ["parallel-plate", "gap-plate", "external"] {
        assert_eq!(can(name), (false, true, false), "{name}");
    }
    assert_eq!(can("constant"), (false, false, false));
}
