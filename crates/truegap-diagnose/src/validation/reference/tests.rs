use super::{columns::moving, least_squares::Design, references, spline::basis};
use crate::{
    data::problem::Problem,
    validation::cross_validation::{HeldOutFit, PartError, parts_of},
};
use truegap_core::{Driver, Inputs, Parameter, Role, SimulationError, Simulator, Stage, StageName};

/// A base model that does nothing.
struct Still;

impl Simulator for Still {
    fn name(&self) -> &str {
        "still"
    }
    fn unit(&self) -> &str {
        "V"
    }
    fn parameters(&self) -> &[Parameter] {
        &[]
    }
    fn needs(&self) -> &[Role] {
        &[]
    }
    fn lacks(&self, _: StageName) -> Option<&'static str> {
        None
    }
    fn full_load(&self) -> Option<f64> {
        None
    }
    fn respond(&self, _: &[f64], inputs: &Inputs, _: &[&dyn Stage]) -> Result<Vec<f64>, SimulationError> {
        Ok(vec![0.0; inputs.len()])
    }
}

const ROWS: usize = 240;

/// Something like noise, the same each time.
fn jitter(row: usize) -> f64 {
    ((row as f64 * 12.9898).sin() * 43_758.545_3).rem_euclid(1.0) - 0.5
}

/// A force that goes up and down, a pump that does not follow it, and a thermometer that stands still.
fn inputs() -> Inputs {
    let column = |f: &dyn Fn(f64) -> f64| (0..ROWS).map(|row| f(row as f64)).collect::<Vec<_>>();
    Inputs {
        time_s: Some(column(&|t| t)),
        run: vec![1; ROWS],
        force_n: Some(column(&|t| 2.0 + 2.0 * (t / 17.0).sin())),
        temperature_c: Some(vec![21.0; ROWS]),
        drivers: vec![Driver { name: "pump".into(), unit: "V".into(), values: column(&|t| 4.0 + (t / 31.0).cos()) }],
        ..Inputs::default()
    }
}

fn predicted(parts: usize) -> HeldOutFit {
    let part = |k: usize| PartError {
        name: format!("block {}", k + 1),
        squares: (k != 2).then_some(1.0),
        rows: ROWS / parts,
        score: None,
        warned: None,
    };
    HeldOutFit { parts: (0..parts).map(part).collect(), ..HeldOutFit::default() }
}

/// `[line, curve]` of a response, as (in sample, held out).
fn errors(response: &[f64]) -> [(f64, f64); 2] {
    let inputs = inputs();
    let problem = Problem { inputs: &inputs, response, simulator: &Still };
    let (_, parts) = parts_of(&problem);
    let told = predicted(parts.len());
    let list = references(&problem, &parts, [&told, &told]);
    assert_eq!(list.iter().map(|r| r.name).collect::<Vec<_>>(), ["straight_line", "smooth_curve"]);
    assert_eq!(list[0].inputs, ["force", "pump"], "what stands still is no input, and nobody is driven by the clock");
    [0, 1].map(|k: usize| (list[k].rmse, list[k].held_out.unwrap_or(f64::NAN)))
}

fn response(f: impl Fn(f64, f64) -> f64) -> Vec<f64> {
    let inputs = inputs();
    let force = inputs.force_n.as_deref().unwrap_or_default();
    (0..ROWS).map(|row| f(force[row], inputs.drivers[0].values[row]) + 0.01 * jitter(row)).collect()
}

/// Rows that lie on a line, far from zero, are followed to their scatter: 0.01 / sqrt(12) for numbers spread evenly over 0.01.
#[test]
fn a_straight_line_in_two_inputs_is_followed_to_its_scatter() {
    let [line, curve] = errors(&response(|force, pump| 2000.0 + 3.0 * force - 0.7 * pump));
    let scatter = 0.01 / 12f64.sqrt();
    for error in [line.0, line.1, curve.0, curve.1] {
        assert!((error / scatter - 1.0).abs() < 0.15, "{error} of {scatter}");
    }
    assert!(curve.0 <= line.0, "the curve holds the line");
}

/// A bend in the force is 100 times the scatter for a line and none for the curve, on rows left out as well.
#[test]
fn a_bend_is_seen_by_the_curve_alone() {
    let [line, curve] = errors(&response(|force, pump| 0.1 * (force - 2.0).powi(2) + pump));
    assert!(line.0 > 0.1 && line.1 > 0.1, "{line:?}");
    assert!(curve.0 < 0.01 && curve.1 < 0.012, "{curve:?}");
}

/// Part 3 was not predicted by the models, so it does not count here either: a jump inside it changes what the others are told from, and not what is counted.
#[test]
fn only_parts_that_the_models_predict_are_counted() {
    let mut jumped = response(|force, _| force);
    let third = 2 * ROWS / 6..3 * ROWS / 6;
    third.for_each(|row| jumped[row] += if row % 2 == 0 { 50.0 } else { -50.0 });
    let [line, _] = errors(&jumped);
    // +-50 in a sixth of the rows is 20 in sample; counted it would be as much held out
    assert!(line.0 > 15.0 && line.1 < 10.0, "{line:?}");
}

/// The same by deleting the rows and solving the normal equations of two unknowns by hand.
#[test]
fn sums_less_those_of_a_part_are_sums_without_it() {
    let (inputs, response) = (inputs(), response(|force, pump| force * force + pump));
    let problem = Problem { inputs: &inputs, response: &response, simulator: &Still };
    let force = moving(&problem).remove(0).values;
    let design = Design::new((vec![0; ROWS], 1), vec![force.clone()], &response);
    let fitted = design.without(std::slice::from_ref(&(40..80)));
    let kept: Vec<usize> = (0..ROWS).filter(|row| !(40..80).contains(row)).collect();
    let mean = |column: &[f64]| kept.iter().map(|row| column[*row]).sum::<f64>() / kept.len() as f64;
    let (x, y) = (mean(&force), mean(&response));
    let sum = |f: &dyn Fn(usize) -> f64| kept.iter().map(|row| f(*row)).sum::<f64>();
    let slope = sum(&|row| (force[row] - x) * (response[row] - y)) / sum(&|row| (force[row] - x).powi(2));
    let row = 55;
    assert!((design.predict(&fitted, row) - (y + slope * (force[row] - x))).abs() < 1e-9);
}

/// Straight beyond the outer knots, smooth at the inner ones: second differences vanish outside and do not jump inside.
#[test]
fn a_spline_is_straight_beyond_its_outer_knots() {
    let x: Vec<f64> = (0..=1000).map(|k| f64::from(k) / 1000.0).collect();
    let columns = basis(&x, 5);
    assert_eq!(columns.len(), 4);
    for column in &columns {
        let bend: Vec<f64> = column.windows(3).map(|w| (w[2] - 2.0 * w[1] + w[0]) * 1e6).collect();
        assert!(bend[..48].iter().chain(&bend[952..]).all(|b| b.abs() < 1e-6), "bent outside");
        assert!(bend.windows(2).all(|w| (w[1] - w[0]).abs() < 0.1), "a jump of the curvature");
    }
    // two positions only: a line is all that can be drawn
    assert_eq!(basis(&[0.0, 1.0, 0.0, 1.0], 5).len(), 1);
}
