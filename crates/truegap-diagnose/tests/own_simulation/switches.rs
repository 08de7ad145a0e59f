//! Something is switched inside a recording, beside a temperature that moves.

use crate::given::{Given, noisy, said};
use truegap_core::Inputs;
use truegap_diagnose::Verdict;

const ROWS: usize = 900;

fn inputs(temperature_c: impl Fn(f64) -> f64) -> Inputs {
    let at = |row: usize| row as f64;
    Inputs {
        time_s: Some((0..ROWS).map(|row| 60.0 * at(row)).collect()),
        run: vec![1; ROWS],
        temperature_c: Some((0..ROWS).map(|row| temperature_c(at(row))).collect()),
        ..Inputs::default()
    }
}

/// While a jump was told from where a changed coefficient turns about, none was found without a coefficient, and none before the temperature had moved.
#[test]
fn a_jump_of_the_zero_needs_no_coefficient_of_the_temperature() {
    let swings = |row: f64| 21.0 + 4.0 * (row / 60.0).sin();
    let stands_at_first = |row: f64| if row < 400.0 { 24.0 + 0.2 * (row / 60.0).sin() } else { 20.0 + 4.0 * (row / 80.0).cos() };
    let of =
        |inputs: &Inputs| said(&Given::with_level(), inputs, &noisy(71, |row| 3.0 + if row < 330 { 0.0 } else { 0.12 }, ROWS));
    for inputs in [inputs(swings), inputs(stands_at_first)] {
        let said = of(&inputs);
        let named: Vec<&str> = said.findings.iter().map(|f| f.effect.as_str()).collect();
        assert_eq!((said.verdict, named), (Verdict::Explained, vec!["regime_change"]), "{}", said.says);
        let switch = &said.findings[0];
        assert!(switch.says.contains("the zero changes by 1"), "{}", switch.says);
        let change = &switch.parameters[0];
        assert!((change.value - 0.12).abs() < 4.0 * change.sd && change.sd < 0.01, "{} (sd {})", change.value, change.sd);
    }
}

/// An altimeter that is set to the pressure at the field while the jet climbs: what goes one way only has no law before and another after, but a zero that jumps within a row is no law of the way.
/// The stretch that holds the jump is predicted by no model, and those beside it bear it out.
#[test]
fn a_zero_that_jumps_while_the_input_goes_one_way_is_told() {
    let climbs = |row: usize| 2.0 + 3.0 * (1.0 - (-2.0 * row as f64 / ROWS as f64).exp());
    let inputs = Inputs {
        time_s: Some((0..ROWS).map(|row| row as f64).collect()),
        run: vec![1; ROWS],
        simulated: Some((0..ROWS).map(climbs).collect()),
        ..Inputs::default()
    };
    let said = said(&Given::fixed(), &inputs, &noisy(73, |row| climbs(row) - if row < 400 { 0.0 } else { 0.4 }, ROWS));
    let named: Vec<&str> = said.findings.iter().map(|f| f.effect.as_str()).collect();
    assert_eq!((said.verdict, named), (Verdict::Explained, vec!["regime_change"]), "{}", said.says);
    let [change, when] = [&said.findings[0].parameters[0], &said.findings[0].parameters[1]];
    assert!((change.value + 0.4).abs() < 4.0 * change.sd && change.sd < 0.01, "{} (sd {})", change.value, change.sd);
    assert!((when.value - 399.5).abs() < 1.0, "{}", when.value);
    // block 3 holds row 400
    let held_out = &said.fit.held_out;
    assert!(held_out.how.contains("block 3 not predicted"), "{}", held_out.how);
    assert_eq!(held_out.parts.len(), 5);
    assert!(held_out.rmse_before.unwrap() > 0.1 && held_out.rmse_after.unwrap() < 0.011, "{held_out:?}");
}

/// The coefficient may be all that changes.
#[test]
fn a_coefficient_that_is_switched_off_is_told_before_and_after() {
    let swings = |row: f64| 21.0 + 4.0 * (row / 60.0).sin();
    let truth = |row: usize| 3.0 + if row < 500 { 0.05 * (swings(row as f64) - 25.0) } else { 0.0 };
    let said = said(&Given::with_level(), &inputs(swings), &noisy(72, truth, ROWS));
    let regime = said.findings.iter().find(|f| f.effect == "regime_change").unwrap_or_else(|| panic!("{}", said.says));
    assert!(regime.says.contains("is 0.05") && regime.says.contains("before and about none"), "{}", regime.says);
    assert!(said.findings.iter().any(|f| f.effect == "temperature_coefficient"), "{}", said.says);
}
