//! Base models that follow recorded columns: a line, a table, an external simulation, a program that is asked.

use super::*;

fn with(model: &str, options: BaseOptions, inputs: &Inputs, response: &[f64]) -> Result<Box<dyn Simulator>, BaseError> {
    base_model(model, None, options, Recorded { inputs, response, unit: "mV" })
}

/// Takes part of the load away before it arrives, warms the sensor, and lets what it deforms creep.
struct Upstream {
    load: f64,
    kelvin: f64,
    creep: f64,
}

impl Stage for Upstream {
    fn load(&self, _: &Inputs, load: &mut [f64]) {
        load.iter_mut().for_each(|load| *load *= self.load);
    }
    fn thermal(&self, _: &Inputs, temperature_c: &mut [f64]) {
        temperature_c.iter_mut().for_each(|t| *t += self.kelvin);
    }
    fn strain(&self, _: &Drive<'_>, strain: &mut [f64]) {
        strain.iter_mut().for_each(|e| *e *= self.creep);
    }
}

const NOTHING: Upstream = Upstream { load: 1.0, kelvin: 0.0, creep: 1.0 };

#[test]
fn a_line_is_driven_by_the_column_that_is_asked_for() {
    let mut inputs = pressed(&[0.0, 50.0, 100.0]);
    inputs.temperature_c = Some(vec![10.0, 30.0, 20.0]);
    let response = [2.0, 5.0, 3.0];
    let line = with("linear", BaseOptions::default(), &inputs, &response).unwrap();
    // pressure comes before temperature; 2 + 3 u + 0 at u = 0, 0.5, 1
    assert_eq!((line.needs(), line.full_load(), line.parameters().len()), (&[Role::Pressure][..], Some(100.0), 2));
    assert_eq!(line.respond(&[2.0, 3.0], &inputs, &[]).unwrap(), [2.0, 3.5, 5.0]);
    let half = line.respond(&[2.0, 3.0], &inputs, &[&Upstream { load: 0.5, ..NOTHING }]).unwrap();
    half.iter().zip([2.0, 2.75, 3.5]).for_each(|(a, b)| assert_relative_eq!(*a, b, max_relative = 1e-13));
    let crept = line.respond(&[2.0, 3.0], &inputs, &[&Upstream { creep: 1.1, ..NOTHING }]).unwrap();
    assert_relative_eq!(crept[2], 5.3, max_relative = 1e-13);
    let warm = BaseOptions { driver: Some(Role::Temperature), order: Some(2), ..BaseOptions::default() };
    let parabola = with("linear", warm, &inputs, &response).unwrap();
    assert_eq!(parabola.parameters().iter().map(|p| p.name.as_str()).collect::<Vec<_>>(), ["offset", "slope", "order_2"]);
    assert_eq!(parabola.respond(&[1.0, 2.0, 4.0], &inputs, &[]).unwrap(), [1.0, 7.0, 3.0]);
    // a thermometer that is 10 K off is half of the range: 1 + 2 u + 4 u^2 at u = 0.5
    assert_relative_eq!(parabola.respond(&[1.0, 2.0, 4.0], &inputs, &[&Upstream { kelvin: 10.0, ..NOTHING }]).unwrap()[0], 3.0);
    assert!(parabola.lacks(StageName::Beads).is_some() && line.lacks(StageName::Beads).is_none());
}

/// 2 + 3 u over a pump of 4 to 8 V, by hand; the named one is taken although a pressure moves, and where it was not recorded, that is said.
#[test]
fn a_line_follows_a_column_under_drivers() {
    let pump = |name: &str| truegap_core::Driver { name: name.into(), unit: "V".into(), values: vec![4.0, 8.0, 5.0] };
    let inputs = Inputs { drivers: vec![pump("pump")], ..pressed(&[0.0, 50.0, 100.0]) };
    let options = BaseOptions { named_driver: Some("pump".into()), ..BaseOptions::default() };
    let line = with("linear", options.clone(), &inputs, &[2.0, 5.0, 3.0]).unwrap();
    assert_eq!((line.needs().len(), line.full_load()), (0, None));
    assert_eq!(line.respond(&[2.0, 3.0], &inputs, &[]).unwrap(), [2.0, 5.0, 2.75]);
    let other = Inputs { drivers: vec![pump("valve")], ..inputs.clone() };
    let error = line.respond(&[2.0, 3.0], &other, &[]).unwrap_err().to_string();
    assert!(error.contains("`pump`") && error.contains("[drivers]"), "{error}");
    let error = with("linear", options, &other, &[2.0, 5.0, 3.0]).err().unwrap().to_string();
    assert!(error.contains("a column for pump that moves"), "{error}");
    let still = Inputs { pressure_pa: None, ..inputs };
    let line = with("linear", BaseOptions::default(), &still, &[2.0, 5.0, 3.0]).unwrap();
    assert_eq!(line.respond(&[0.0, 4.0], &still, &[]).unwrap(), [0.0, 4.0, 1.0]);
}

#[test]
fn a_line_without_a_driver_and_of_no_order_is_refused() {
    let inputs = pressed(&[5.0, 5.0, 5.0]);
    let fails = |options| with("linear", options, &inputs, &[1.0, 2.0, 3.0]).err().unwrap();
    assert!(fails(BaseOptions::default()).to_string().contains("a recorded column that moves"));
    let asked = fails(BaseOptions { driver: Some(Role::Pressure), ..BaseOptions::default() });
    assert!(asked.to_string().contains("a column for pressure that moves"), "{asked}");
    assert_eq!(fails(BaseOptions { order: Some(7), ..BaseOptions::default() }), BaseError::Order { order: 7 });
}

/// 0 to 2 N at 20 and 40 degrees Celsius: `10 + F + 0.1 (T - 20) F`, which straight pieces follow exactly on the edges.
fn field() -> Grid {
    let (mut force, mut warm, mut value) = (Vec::new(), Vec::new(), Vec::new());
    for t in [40.0, 20.0] {
        for f in [2.0, 0.0, 1.0] {
            force.push(f);
            warm.push(t);
            value.push(10.0 + f + 0.1 * (t - 20.0) * f);
        }
    }
    let inputs = Inputs { run: vec![1; 6], force_n: Some(force), temperature_c: Some(warm), ..Inputs::default() };
    Grid::of(&inputs, &value, "mV").unwrap()
}

fn pushed(force: &[f64], temperature: &[f64]) -> Inputs {
    let (force_n, temperature_c) = (Some(force.to_vec()), Some(temperature.to_vec()));
    Inputs { run: vec![1; force.len()], force_n, temperature_c, ..Inputs::default() }
}

#[test]
fn a_table_is_straight_between_its_values_and_ends_where_they_end() {
    let options = BaseOptions { table: Some(field()), ..BaseOptions::default() };
    let inputs = pushed(&[0.5, 1.5, 2.0], &[30.0, 20.0, 40.0]);
    let table = with("table", options.clone(), &inputs, &[1.0, 2.0, 3.0]).unwrap();
    let exact = [10.0 + 0.5 + 0.5, 11.5, 16.0];
    let found = table.respond(&[], &inputs, &[]).unwrap();
    found.iter().zip(exact).for_each(|(a, b)| assert_relative_eq!(*a, b, max_relative = 1e-13));
    // half the load, and 10 K more
    let moved = table.respond(&[], &inputs, &[&Upstream { load: 0.5, kelvin: 10.0, ..NOTHING }]).unwrap();
    assert_relative_eq!(moved[1], 10.0 + 0.75 + 0.75, max_relative = 1e-13);
    let outside = pushed(&[0.5, 3.0], &[30.0, 20.0]);
    let refused = with("table", options, &outside, &[1.0, 2.0]).err().unwrap().to_string();
    assert!(refused.contains("row 2: force is 3") && refused.contains("extend the table"), "{refused}");
    assert!(matches!(table.respond(&[], &outside, &[]), Err(SimulationError::OutsideTable { row: 1, .. })));
}

#[test]
fn rows_that_are_no_table_are_refused() {
    let twice = pushed(&[0.0, 1.0, 1.0], &[20.0, 20.0, 20.0]);
    assert!(Grid::of(&twice, &[1.0, 2.0, 3.0], "mV").is_err());
    let holes = pushed(&[0.0, 1.0, 0.0], &[20.0, 20.0, 30.0]);
    let told = Grid::of(&holes, &[1.0, 2.0, 3.0], "mV").unwrap_err().to_string();
    assert!(told.contains("3 rows do not fill 2 values of force times 2 of temperature"), "{told}");
}

/// A simulation that is `5 + 2 F - 0.1 (T - 20)`: physics at load and temperature moves it as its own slope does.
#[test]
fn an_external_simulation_is_moved_by_what_moves_its_load_and_temperature() {
    let force: Vec<f64> = (0..40).map(|i| f64::from(i % 10)).collect();
    let warm: Vec<f64> = (0..40).map(|i| 20.0 + f64::from(i / 10)).collect();
    let mut inputs = pushed(&force, &warm);
    let simulated: Vec<f64> = force.iter().zip(&warm).map(|(f, t)| 5.0 + 2.0 * f - 0.1 * (t - 20.0)).collect();
    inputs.simulated = Some(simulated.clone());
    let model = with("external", BaseOptions::default(), &inputs, &simulated).unwrap();
    assert_eq!(model.full_load(), Some(9.0));
    assert!(model.lacks(StageName::Beads).is_none() && model.lacks(StageName::LoadPath).is_none());
    let moved = model.respond(&[], &inputs, &[&Upstream { load: 0.5, kelvin: 1.0, ..NOTHING }]).unwrap();
    // rounding of the fit of the surface, with a ridge of 1e-9
    for row in 0..40 {
        assert_relative_eq!(moved[row], simulated[row] - force[row] - 0.1, epsilon = 1e-6);
    }
    let crept = model.respond(&[], &inputs, &[&Upstream { creep: 1.1, ..NOTHING }]).unwrap();
    assert_relative_eq!(crept[9], simulated[9] + 0.1 * 18.0, epsilon = 1e-6);
    // what has nothing to do with the load does not pretend to
    inputs.simulated = Some((0..40).map(|i| f64::from((i * 7) % 13)).collect());
    let apart = with("external", BaseOptions::default(), &inputs, &simulated).unwrap();
    assert!(apart.full_load().is_none() && apart.lacks(StageName::Beads).is_some());
}

/// `k x force + temperature` at each row; counts nothing, keeps nothing.
struct Spring;

impl Responder for Spring {
    fn respond(&self, values: &[f64], inputs: &Inputs) -> Result<Vec<f64>, SimulationError> {
        let (force, warmth) = (inputs.force_n.as_ref().unwrap(), inputs.temperature_c.as_ref().unwrap());
        Ok(force.iter().zip(warmth).map(|(f, t)| values[0] * f + t).collect())
    }
}

/// What is plugged in arrives at the simulator as other inputs, and the rest untouched; the other route is the formula by hand.
#[test]
fn a_black_box_is_asked_with_what_arrives() {
    struct Warmer;
    impl Stage for Warmer {
        fn load(&self, _: &Inputs, load: &mut [f64]) {
            load.iter_mut().for_each(|l| *l *= 0.5);
        }
        fn thermal(&self, _: &Inputs, temperature: &mut [f64]) {
            temperature.iter_mut().for_each(|t| *t += 3.0);
        }
    }
    let inputs = Inputs {
        run: vec![1; 3],
        force_n: Some(vec![0.0, -1.0, 4.0]),
        temperature_c: Some(vec![20.0, 21.0, 22.0]),
        ..Inputs::default()
    };
    let asked = Asked {
        who: Who::Function { name: "spring".into() },
        parameters: vec![Parameter::normal("k", "V/N", 2.0, 0.3, "stiffness")],
        inside: false,
    };
    let options = BaseOptions { asked: Some(asked), ..BaseOptions::default() };
    let recorded = Recorded { inputs: &inputs, response: &[20.0, 19.0, 30.0], unit: "V" };
    let written = BaseModel::of("function", None, options, recorded).unwrap();
    let again: BaseModel = toml::from_str(&toml::to_string(&written).unwrap()).unwrap();
    assert_eq!(written, again);
    again.check().unwrap();
    assert!(matches!(again.build(None), Err(BaseError::NobodyToAsk { model: "function" })));
    let responder: Arc<dyn Responder> = Arc::new(Spring);
    let model = again.answered_by(&responder).unwrap();
    assert_eq!((model.name(), model.full_load(), model.parameters().len()), ("function", Some(4.0), 1));
    assert_eq!(model.respond(&[2.0], &inputs, &[]).unwrap(), [20.0, 19.0, 30.0]);
    assert_eq!(model.respond(&[2.0], &inputs, &[&Warmer]).unwrap(), [23.0, 23.0, 29.0]);
}
