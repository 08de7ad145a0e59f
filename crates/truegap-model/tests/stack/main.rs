//! The stack as a simulator: parameters, columns, series orders, errors.
#![allow(clippy::unwrap_used)]

mod plug;
mod stages;

use plug::{Plug, at};

use approx::assert_relative_eq;
use truegap_core::{Drive, Geometry, Inputs, Readout, Sensor, SimulationError, Simulator, Stage, sensor::builtin_sensor};
use truegap_model::{
    CoefficientOptions, Point, SeriesOrder, Stack, StackOptions,
    cases::{default_sensor, staircase},
    coefficients, states,
};

fn centre(model: &dyn Simulator) -> Vec<f64> {
    model.parameters().iter().map(|p| p.centre()).collect()
}

fn named(name: &str) -> Sensor {
    builtin_sensor(name).unwrap().unwrap()
}

fn stack() -> Stack {
    Stack::new(&default_sensor().unwrap(), StackOptions::default())
}

#[test]
fn parameters_are_the_tolerances_of_the_sensor() {
    let names =
        |options| Stack::new(&default_sensor().unwrap(), options).parameters().iter().map(|p| p.name.clone()).collect::<Vec<_>>();
    let all = names(StackOptions::default());
    assert_eq!(
        all,
        [
            "young_rtv",
            "softening_rtv",
            "height_rtv",
            "thickness_copper",
            "thickness_tin",
            "thickness_polyimide",
            "bead_diameter",
            "electrode_diameter",
            "stray_capacitance"
        ]
    );
    let flat = names(StackOptions { warp: false, ..StackOptions::default() });
    assert_eq!(all.iter().filter(|name| !flat.contains(name)).collect::<Vec<_>>(), ["thickness_copper", "thickness_tin"]);
    let mut exact = default_sensor().unwrap();
    exact.insulator.thickness.sd = 0.0;
    assert_eq!(Stack::new(&exact, StackOptions::default()).parameters().len(), 8);
    let stray = stack().parameters()[8].clone();
    assert_eq!((stray.unit.as_str(), stray.sd()), ("pF", 0.3));
}

/// Each parameter moves the response, and by what the sensor file with that value says: another route through file, sensor and states.
#[test]
fn a_parameter_is_the_number_of_the_file() {
    let file = truegap_core::sensor::builtin_sensors()[0].toml;
    let changes = [
        ("\"1.075 MPa", "\"1.2 MPa", 0, 1.2e6),
        ("\"-7.6 kPa/K", "\"-5 kPa/K", 1, -5e3),
        ("\"162 um", "\"170 um", 2, 170e-6),
        ("\"34 um", "\"30 um", 3, 30e-6),
        ("\"5 um", "\"6 um", 4, 6e-6),
        ("\"25 um", "\"27 um", 5, 27e-6),
        ("\"700 um", "\"650 um", 6, 650e-6),
        ("\"15 mm", "\"14 mm", 7, 14e-3),
        ("\"0 pF", "\"0.7 pF", 8, 0.7),
    ];
    let model = stack();
    let inputs = Inputs { run: vec![1], force_n: Some(vec![2.0]), temperature_c: Some(vec![40.0]), ..Inputs::default() };
    let point = Point { force_n: 2.0, temperature_c: 40.0 };
    let nominal = model.respond(&centre(&model), &inputs, &[]).unwrap()[0];
    for (old, new, index, value) in changes {
        let mut values = centre(&model);
        values[index] = value;
        let response = model.respond(&values, &inputs, &[]).unwrap()[0];
        let sensor = Sensor::from_toml(&file.replacen(old, new, 1), "changed.toml").unwrap();
        let from_file = states(&sensor, StackOptions::default(), &[point]).unwrap()[0].c_total_pf;
        assert_relative_eq!(response, from_file, max_relative = 1e-14);
        assert!((response - nominal).abs() > 1e-5, "{old} does nothing");
    }
}

#[test]
fn the_plain_pass_and_the_staged_pass_agree() {
    let model = stack();
    let inputs = staircase(700, 4.5);
    let plain = model.respond(&centre(&model), &inputs, &[]).unwrap();
    let staged = model.respond(&centre(&model), &inputs, &[&Plug::default()]).unwrap();
    let spread = plain.iter().copied().fold(f64::NEG_INFINITY, f64::max) - plain.iter().copied().fold(f64::INFINITY, f64::min);
    assert!(spread > 2.0);
    plain.iter().zip(&staged).for_each(|(a, b)| assert_relative_eq!(a, b, max_relative = 4e-16));
}

#[test]
fn without_a_thermometer_the_sensor_is_at_its_reference_temperature() {
    let model = stack();
    let warm = Inputs { run: vec![1], force_n: Some(vec![3.0]), temperature_c: Some(vec![20.0]), ..Inputs::default() };
    let unknown = Inputs { temperature_c: None, ..warm.clone() };
    let values = centre(&model);
    assert_eq!(model.respond(&values, &warm, &[]).unwrap(), model.respond(&values, &unknown, &[]).unwrap());
}

#[test]
fn a_load_cell_may_read_slightly_below_zero() {
    let model = stack();
    let response = |force| at(&model, force, 20.0, &Plug::default()).unwrap();
    let (below, zero, above) = (response(-0.01), response(0.0), response(0.01));
    assert!(below < zero && zero < above);
    assert_relative_eq!(zero - below, above - zero, max_relative = 0.01);
}

/// The exact order of (21) reads less than the printed one where the gap varies (0.2 % of C_main for the optimised design at 50 degC), and the same where it does not.
#[test]
fn both_orders_of_series_and_integral_agree_on_flat_plates_only() {
    let sensor = named("singletact-s8-optimised");
    let exact = StackOptions { series: SeriesOrder::SeriesThenIntegrate, ..StackOptions::default() };
    let main = |options, temperature_c| states(&sensor, options, &[Point { force_n: 4.5, temperature_c }]).unwrap()[0].c_main_pf;
    assert_relative_eq!(main(exact, 20.0), main(StackOptions::default(), 20.0), max_relative = 1e-14);
    let (printed, ordered) = (main(StackOptions::default(), 50.0), main(exact, 50.0));
    println!("C_main at 50 degC: integrate then series {printed} pF, series then integrate {ordered} pF");
    assert!(printed / ordered - 1.0 > 1e-3);
    // extra gap in series: both orders again the same on flat plates
    let plug = |options| at(&Stack::new(&sensor, options), 0.0, 20.0, &FieldFree { gap: 0.1 });
    assert_relative_eq!(plug(exact), plug(StackOptions::default()), max_relative = 1e-14);

    struct FieldFree {
        gap: f64,
    }
    impl Stage for FieldFree {
        fn geometry(&self, _: &Drive<'_>, geometry: &mut Geometry<'_>) {
            geometry.gap.iter_mut().for_each(|g| *g += self.gap);
        }
    }
    fn at(model: &Stack, force_n: f64, temperature_c: f64, stage: &FieldFree) -> f64 {
        let inputs =
            Inputs { run: vec![1], force_n: Some(vec![force_n]), temperature_c: Some(vec![temperature_c]), ..Inputs::default() };
        model.respond(&centre(model), &inputs, &[stage]).unwrap()[0]
    }
}

/// Solid sheet: strain is load over A E, permittivity that of the sheet; by hand at the reference temperature.
#[test]
fn a_solid_dielectric_follows_equation_2() {
    let s = states(&named("foam-s15"), StackOptions::default(), &[Point { force_n: 10.0, temperature_c: 20.0 }]).unwrap()[0];
    let area = std::f64::consts::PI * 7.5e-3 * 7.5e-3;
    assert_relative_eq!(s.strain, -10.0 / (area * 300e3), max_relative = 1e-14);
    assert_relative_eq!(s.c_rtv_pf, 1.4 * 8.854 * area / (500e-6 * (1.0 + s.strain)), max_relative = 1e-13);
    assert_eq!(s.curvature_per_m, 0.0);
}

#[test]
fn mutual_capacitance_reads_the_main_gap_alone() {
    let s = states(&named("mutual-s10"), StackOptions::default(), &[Point { force_n: 1.0, temperature_c: 35.0 }]).unwrap()[0];
    assert_eq!((s.c_backing_pf, s.c_tail_pf), (0.0, 0.0));
    assert_eq!(s.c_total_pf, s.c_main_pf);
    assert!(s.c_main_pf > 4.0);
}

#[test]
fn a_load_that_closes_the_gap_is_an_error_that_says_so() {
    let model = stack();
    let error = at(&model, 60.0, 20.0, &Plug::default()).unwrap_err();
    assert!(matches!(error, SimulationError::GapCloses { row: 0, load_si: 60.0, strain } if strain >= 1.0), "{error}");
    let error =
        states(&default_sensor().unwrap(), StackOptions::default(), &[Point { force_n: 60.0, temperature_c: 20.0 }]).unwrap_err();
    assert!(error.to_string().contains("closes the gap"), "{error}");
    for plug in
        [Plug { tilt: 1.0, ..Plug::default() }, Plug { sag: 5.0, ..Plug::default() }, Plug { strain: 1.0, ..Plug::default() }]
    {
        assert!(matches!(at(&model, 2.0, 20.0, &plug), Err(SimulationError::GapCloses { .. })));
    }
    let no_modulus = at(&model, 2.0, 20.0, &Plug { modulus: -1.0, ..Plug::default() });
    assert!(matches!(no_modulus, Err(SimulationError::NotFinite { .. })));
    let error = model.respond(&centre(&model), &Inputs { run: vec![1], ..Inputs::default() }, &[]).unwrap_err();
    assert!(matches!(error, SimulationError::MissingColumn { .. }));
}

/// Coefficients from states at the four corners, by hand, and the linearity by a scan 100 times finer.
#[test]
fn the_greatest_deviation_is_that_of_a_fine_scan() {
    for name in ["singletact-s15-4.5n", "singletact-s15-4.5n-stiffening", "singletact-s8-optimised"] {
        let sensor = named(name);
        let k = coefficients(&sensor, CoefficientOptions::default()).unwrap();
        let response = |force_n: f64, temperature_c: f64| {
            states(&sensor, StackOptions::default(), &[Point { force_n, temperature_c }]).unwrap()[0].c_total_pf
        };
        let (c0, cl, h0, hl) = (response(0.0, 20.0), response(4.5, 20.0), response(0.0, 50.0), response(4.5, 50.0));
        assert_relative_eq!(k.baseline_pf, c0, max_relative = 1e-15);
        assert_relative_eq!(k.span_pf, cl - c0, max_relative = 1e-12);
        assert_relative_eq!(k.k_baseline_pf_per_k, (h0 - c0) / 30.0, max_relative = 1e-11);
        assert_relative_eq!(k.k_baseline_pct_fsr_per_k, 100.0 * (h0 - c0) / (cl - c0) / 30.0, max_relative = 1e-10);
        assert_relative_eq!(k.k_sensitivity_pct_per_k, 100.0 * ((hl - h0) / (cl - c0) - 1.0) / 30.0, max_relative = 1e-9);
        let scan = |temperature_c: f64, from: f64, to: f64| {
            let off = |i: i32| {
                let force = 4.5 * f64::from(i) / 1e4;
                (response(force, temperature_c) - from - (to - from) * force / 4.5).abs()
            };
            100.0 * (0..=10_000).map(off).fold(0.0, f64::max) / (to - from)
        };
        let (cold, hot) = (scan(20.0, c0, cl), scan(50.0, h0, hl));
        assert_relative_eq!(k.linearity_pct, cold, max_relative = 1e-6);
        assert_relative_eq!(k.k_linearity_pct_per_k, (hot - cold) / 30.0, max_relative = 1e-5);
        println!("{name}: {k:?}");
    }
}

/// Improvements by the optimised design: 16.16, 16.47 and 14.74 % in the paper's abstract, K_baseline as (24) is printed. The paper's default dimensions are lost;
/// both reconstructions are held to 1.5 points, which is how well they are known to fit. The second has silicone that stiffens, in both designs.
#[test]
fn both_reconstructions_give_the_papers_improvements() {
    let k = |sensor: &Sensor| coefficients(sensor, CoefficientOptions::default()).unwrap();
    for (name, sign) in [("singletact-s15-4.5n", -1.0), ("singletact-s15-4.5n-stiffening", 1.0)] {
        let mut optimised = named("singletact-s8-optimised");
        optimised.dielectric.layer.material.softening.value = sign * 7600.0;
        let (before, after) = (k(&named(name)), k(&optimised));
        let improved = |before: f64, after: f64| 100.0 * (1.0 - after.abs() / before.abs());
        let improvements = [
            (improved(before.k_baseline_pf_per_k, after.k_baseline_pf_per_k), 16.16),
            (improved(before.k_sensitivity_pct_per_k, after.k_sensitivity_pct_per_k), 16.47),
            (improved(before.k_linearity_pct_per_k, after.k_linearity_pct_per_k), 14.74),
        ];
        println!("{name}: {improvements:.2?}");
        improvements.iter().for_each(|(ours, papers)| assert!((ours - papers).abs() < 1.5, "{ours} % against {papers} %"));
        // the paper's sign flip of K_linearity is there in the second only
        assert_eq!(before.k_linearity_pct_per_k * after.k_linearity_pct_per_k < 0.0, sign > 0.0);
    }
}

/// Zero and span that a stage of the readout is told, against the plain responses without and with full load.
#[test]
fn the_readout_is_told_zero_and_span() {
    struct Span;
    impl Stage for Span {
        fn readout(&self, _: &Drive<'_>, readout: &Readout, value: &mut [f64]) {
            value.copy_from_slice(&[readout.zero, readout.span]);
        }
    }
    let model = stack();
    let ends = Inputs { run: vec![1; 2], force_n: Some(vec![0.0, model.full_load().unwrap()]), ..Inputs::default() };
    let plain = model.respond(&centre(&model), &ends, &[]).unwrap();
    let told = model.respond(&centre(&model), &ends, &[&Span]).unwrap();
    assert_relative_eq!(told[0], plain[0], max_relative = 1e-14);
    assert_relative_eq!(told[1], plain[1] - plain[0], max_relative = 1e-12);
}
