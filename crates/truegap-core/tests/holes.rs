//! Rows without a value and rows of one instant: the same from a CSV and from a frame, counted, and too many refused.

#![allow(clippy::unwrap_used)]

use truegap_core::Recording;
use truegap_core::recording::FrameColumn;

/// The command stopped at the first hole, where a frame with the same holes was read: one had to be mended at a time.
#[test]
fn a_csv_with_holes_is_read_as_the_frame_with_the_same_holes() {
    let toml = "schema = \"truegap.recording/1\"\nfile = \"a.csv\"\n[drivers]\nfan = { column = \"fan\", unit = \"V\" }\n";
    let csv = "run,time_s,force_n,capacitance_pf,fan\n1,0,0.5,230,1\n1,1,,231,2\n1,2,1.5,nan,3\n1,3,2,233,\n1,4,2.5,234,5\n,5,3,235,6\n1,6,3.5,236,7\n1,7,4,237,8\n1,8,4,238,9\n";
    let csv = Recording::from_text("a", toml, csv).unwrap();
    const NAN: f64 = f64::NAN;
    let table: Vec<FrameColumn<'_>> = vec![
        FrameColumn::numbers("run", &[1.0, 1.0, 1.0, 1.0, 1.0, NAN, 1.0, 1.0, 1.0]),
        FrameColumn::numbers("time_s", &[0.0, 1.0, 2.0, 3.0, 4.0, 5.0, 6.0, 7.0, 8.0]),
        FrameColumn::numbers("force_n", &[0.5, NAN, 1.5, 2.0, 2.5, 3.0, 3.5, 4.0, 4.0]),
        FrameColumn::numbers("capacitance_pf", &[230.0, 231.0, NAN, 233.0, 234.0, 235.0, 236.0, 237.0, 238.0]),
        FrameColumn::numbers("fan", &[1.0, 2.0, 3.0, NAN, 5.0, 6.0, 7.0, 8.0, 9.0]),
    ];
    let frame = Recording::from_columns("a", toml, &table).unwrap();
    assert_eq!((&csv.inputs, &csv.response), (&frame.inputs, &frame.response));
    assert_eq!(csv.response, [230.0, 234.0, 236.0, 237.0, 238.0]);
    let note = |recording: &Recording| recording.notes.iter().map(ToString::to_string).find(|n| n.contains("without"));
    let (told, of_frame) = (note(&csv).unwrap(), note(&frame).unwrap());
    assert!(told.starts_with("4 rows without a value in `force_n`, `capacitance_pf`, `fan`, `run`"), "{told}");
    assert!(told.ends_with("the first on line 3") && of_frame.ends_with("the first on line 2"), "{told}\n{of_frame}");
}

#[test]
fn rows_of_one_instant_are_taken_as_one() {
    let toml = "schema = \"truegap.recording/1\"\nfile = \"a.csv\"\n[drivers]\nvane = { column = \"vane\", unit = \"deg\" }\n";
    let text = "time_s,force_n,capacitance_pf,vane\n0,1,230,10\n1,2,231,359\n1,3,233,1\n1,7,235,3\n2,4,240,20\n3,5,250,30\n3,6,252,40\n4,7,260,50\n";
    let csv = Recording::from_text("a", toml, text).unwrap();
    assert_eq!(csv.inputs.time_s.as_deref().unwrap(), [0.0, 1.0, 2.0, 3.0, 4.0]);
    assert_eq!(csv.inputs.force_n.as_deref().unwrap(), [1.0, 4.0, 4.0, 5.5, 7.0]);
    assert_eq!(csv.response, [230.0, 233.0, 240.0, 251.0, 260.0]);
    // half-way from 359 degrees to 1 is no 180
    assert_eq!(csv.inputs.drivers[0].values, [10.0, 359.0, 20.0, 30.0, 50.0]);
    let told: Vec<String> = csv.notes.iter().map(ToString::to_string).collect();
    assert!(told.iter().any(|n| n.starts_with("3 rows have the time of the row before, the first on line 4")), "{told:?}");
    let columns: Vec<Vec<f64>> =
        (0..4).map(|at| text.lines().skip(1).map(|line| line.split(',').nth(at).unwrap().parse().unwrap()).collect()).collect();
    let names = ["time_s", "force_n", "capacitance_pf", "vane"];
    let table: Vec<FrameColumn<'_>> = names.iter().zip(&columns).map(|(n, c)| FrameColumn::numbers(n, c)).collect();
    let frame = Recording::from_columns("a", toml, &table).unwrap();
    assert_eq!((&csv.inputs, &csv.response), (&frame.inputs, &frame.response));
}

#[test]
fn a_table_of_which_less_than_half_is_left_is_refused() {
    let toml = "schema = \"truegap.recording/1\"\nfile = \"a.csv\"\n";
    let refused = |rows: &str| Recording::from_text("a", toml, &format!("time_s,force_n,capacitance_pf\n{rows}"));
    let told = refused("0,1,230\n1,,231\n2,,232\n3,3,\n").unwrap_err().to_string();
    assert!(told.contains("3 of 4 rows") && told.contains("`force_n`, `capacitance_pf`") && told.contains("line 3"), "{told}");
    let told = refused("0,1,230\n0,1,231\n0,1,232\n").unwrap_err().to_string();
    assert!(told.contains("2 of 3 rows have the time of the row before") && told.contains("line 3"), "{told}");
    // a cell of text is a mistake, however few there are
    assert!(refused("0,1,230\n1,broken,231\n2,3,232\n").unwrap_err().to_string().contains("line 3: `broken`"));
}
