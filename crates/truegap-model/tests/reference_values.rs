//! The stack against values in 40-digit arithmetic: ten rows pinned here, all 144 where the reference folder is at hand.
//!
//! The other route: mpmath, quadrature instead of closed forms, no shared code (project reference, `model_values.csv`; conventions in `docs/theory.md`).
//! Tolerance 1e-12 relative: the values are printed to 15 digits, the model takes some fifty roundings of 1e-16.
#![allow(clippy::unwrap_used)]

use std::path::PathBuf;
use truegap_core::sensor::builtin_sensor;
use truegap_model::{Point, StackOptions, State, states};

const HEADER: &str = "sensor,warp,force_n,temperature_c,strain,curvature_per_m,eps_r,c_rtv_pf,c_polyimide_pf,c_main_pf,c_backing_pf,c_tail_pf,c_total_pf";

/// Ten rows of the reference: each sensor, warp on and off, cold, hot, nearly flat, full load.
const PINNED: &str = "\
singletact-s15-4.5n,true,0,-10,0.0,-1.43707619560344,1.33600535676313,13.0369115795785,212.704269948303,12.2840092407877,212.704269948303,9.63893536121673,234.627214550308
singletact-s15-4.5n,true,0,20.001,0.0,4.78857333693839e-5,1.33973345787958,12.9394326256798,212.789812216246,12.1977081017186,212.789812216246,9.63315180733696,234.620672125302
singletact-s15-4.5n,true,4.5,50,-0.177604440438502,1.43606811740411,1.40586263612787,16.5547429462652,212.877358674672,15.3602304430859,212.877358674672,9.62737557465521,237.864964692414
singletact-s15-4.5n,false,2.25,20,-0.077649664387828,0.0,1.3660777327998,14.3046226176823,212.790812822928,13.4035819259691,212.790812822928,9.633152,235.827546748897
singletact-s15-4.5n-stiffening,true,2.25,20.001,-0.0679870252690987,4.78857333693839e-5,1.30024190113307,13.9923108727479,212.790815674292,13.1289981274807,212.790815674292,9.63315180733696,235.552965609109
singletact-s15-4.5n-stiffening,true,4.5,50,-0.111891510242002,1.43606811740411,1.31632248719706,14.8968442319947,212.877358674672,13.9225637154112,212.877358674672,9.62737557465521,236.427297964739
singletact-s15-4.5n-stiffening,false,4.5,50,-0.111891510242002,0.0,1.31632248719706,14.7917879073307,212.877358674672,13.8307574261247,212.877358674672,9.62737557465521,236.335491675452
singletact-s8-optimised,true,2.25,20,-0.0630257995293795,0.0,2.1919814676984,5.25839768407458,60.5278825781971,4.83808593983786,60.5278825781971,9.633152,74.999120518035
singletact-s8-optimised,true,4.5,50,-0.138138238153704,11.2537596034933,2.29270808716075,6.09238103717808,60.5532172761814,5.53544843185211,60.5532172761814,9.62737557465521,75.7160412826887
singletact-s8-optimised,false,4.5,50,-0.138138238153704,0.0,2.29270808716075,5.94966353410832,60.5532172761814,5.4173783798745,60.5532172761814,9.62737557465521,75.5979712307111
";

/// The reference folder: `TRUEGAP_REFERENCE`, beside the recordings, or beside the workspace.
fn reference_file() -> Option<PathBuf> {
    let beside = |name: &str, tail: &str| std::env::var_os(name).map(|folder| PathBuf::from(folder).join(tail));
    let workspace = PathBuf::from(env!("CARGO_MANIFEST_DIR")).join("../../../shared/reference");
    let folders = [beside("TRUEGAP_REFERENCE", ""), beside("TRUEGAP_RECORDINGS", "../reference"), Some(workspace)];
    folders.into_iter().flatten().map(|folder| folder.join("model_values.csv")).find(|file| file.is_file())
}

fn computed(fields: &[&str]) -> State {
    let sensor = builtin_sensor(fields[0]).expect("a built-in sensor").unwrap();
    let options = StackOptions { warp: fields[1] == "true", ..StackOptions::default() };
    let point = Point { force_n: fields[2].parse().unwrap(), temperature_c: fields[3].parse().unwrap() };
    states(&sensor, options, &[point]).unwrap()[0]
}

/// Largest relative error of the rows' columns, and the number of rows. Column `eps_r` is inside `c_rtv_pf`.
fn worst(rows: &str) -> (f64, usize) {
    let names: Vec<_> = HEADER.split(',').collect();
    let mut worst = 0f64;
    for row in rows.lines() {
        let fields: Vec<_> = row.split(',').collect();
        assert_eq!(fields.len(), names.len(), "{row}");
        let s = computed(&fields);
        let columns = [
            ("strain", s.strain),
            ("curvature_per_m", s.curvature_per_m),
            ("c_rtv_pf", s.c_rtv_pf),
            ("c_polyimide_pf", s.c_polyimide_pf),
            ("c_main_pf", s.c_main_pf),
            ("c_backing_pf", s.c_backing_pf),
            ("c_tail_pf", s.c_tail_pf),
            ("c_total_pf", s.c_total_pf),
        ];
        for (name, value) in columns {
            let expected: f64 = fields[names.iter().position(|n| *n == name).unwrap()].parse().unwrap();
            let error = if expected == 0.0 { value.abs() } else { (value / expected - 1.0).abs() };
            assert!(error <= 1e-12, "{name} is {value}, not {expected}, in {row}");
            worst = worst.max(error);
        }
    }
    (worst, rows.lines().count())
}

#[test]
fn ten_rows_of_the_reference_are_reproduced() {
    let (worst, rows) = worst(PINNED);
    assert_eq!(rows, 10);
    println!("largest relative error over {rows} rows: {worst:.1e}");
}

#[test]
fn every_row_of_the_reference_is_reproduced_where_it_is_at_hand() {
    let Some(file) = reference_file() else {
        println!("model_values.csv is not at hand (TRUEGAP_REFERENCE is not set): only the ten pinned rows were compared");
        return;
    };
    let text = std::fs::read_to_string(&file).unwrap();
    let (header, rows) = text.split_once('\n').unwrap();
    assert_eq!(header.trim(), HEADER);
    let (worst, rows) = worst(rows);
    assert_eq!(rows, 144);
    println!("largest relative error over {rows} rows: {worst:.1e}");
}
