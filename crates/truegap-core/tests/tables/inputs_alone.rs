//! Tables without a response: enough where only what was done is asked for, refused everywhere else.

use crate::bench::Bench;
use truegap_core::recording::{FrameColumn, Told};
use truegap_core::{Recording, RecordingError, Role};

fn alone(map: &[&str]) -> Told {
    Told { map: map.iter().map(|text| text.parse().unwrap()).collect(), inputs_alone: true, ..Told::default() }
}

/// A planned load was refused for want of what nobody had measured yet.
#[test]
fn what_was_done_needs_no_response() {
    // by its unit the last column might be one
    for header in ["time_s,force_n,temperature_c", "time_s,force_n,temperature_c,c_total_pf"] {
        let more = if header.ends_with("pf") { ",74" } else { "" };
        let rows = ["0,1,20", "0.5,2,20", "0.5,4,20", "1.5,,20", "2,3,20"].map(|row| format!("{row}{more}\n")).concat();
        let bench = Bench::new("alone", format!("{header}\n{rows}").as_bytes());
        let file = bench.0.join("t.csv");
        let read = Recording::open_told(&file, &alone(&[])).unwrap();
        assert_eq!((read.len(), read.is_empty(), read.response.len(), read.response_unit.as_str()), (3, false, 0, ""));
        assert_eq!(read.inputs.force_n.as_deref(), Some(&[1.0, 3.0, 3.0][..]), "rows of one instant are one");
        assert_eq!(
            read.quantities().iter().map(|(role, _)| *role).collect::<Vec<_>>(),
            [Role::Time, Role::Force, Role::Temperature]
        );
        let last = read.select(&[2, 0]);
        assert_eq!((last.len(), last.response.len(), last.inputs.time_s), (2, 0, Some(vec![2.0, 0.0])));
        assert!(matches!(Recording::open(&file), Err(RecordingError::MissingColumn { .. })), "a diagnosis asks for it");
        let toml = "schema = \"truegap.recording/1\"\nfile = \"t.csv\"\n[columns]\nresponse = \"c_pf\"\n";
        std::fs::write(bench.0.join("t.toml"), toml).unwrap();
        let named = Recording::open_told(bench.0.join("t.toml"), &alone(&[])).unwrap_err().to_string();
        assert!(named.contains("no column for response: `c_pf`"), "{named}");
    }
}

#[test]
fn a_table_with_a_response_is_read_as_before() {
    let bench = Bench::new("with", b"time_s,force_n,capacitance_pf,c_mv\n0,1,74,5\n1,2,nan,6\n2,3,76,7\n");
    let file = bench.0.join("t.csv");
    assert_eq!(Recording::open_told(&file, &alone(&[])).unwrap(), bench.read().unwrap());
    let mapped = Recording::open_told(&file, &alone(&["response=c_mv"])).unwrap();
    assert_eq!((mapped.response, mapped.response_unit.as_str()), (vec![5.0, 6.0, 7.0], "mV"));
    let of_another = Recording::open_told(&file, &alone(&["response=c_kv"])).unwrap_err().to_string();
    assert!(of_another.contains("`c_kv`"), "{of_another}");
}

#[test]
fn half_of_the_rows_are_counted_by_what_was_done() {
    let gaps = Bench::new("gaps", b"time_s,force_n\n0,1\n1,\n2,\n3,4\n");
    assert_eq!(Recording::open_told(gaps.0.join("t.csv"), &alone(&[])).unwrap().len(), 2);
    let most = Bench::new("most", b"time_s,force_n\n0,1\n1,\n2,\n");
    let refused = Recording::open_told(most.0.join("t.csv"), &alone(&[])).unwrap_err();
    assert!(matches!(refused, RecordingError::FewWhole { gone: 2, rows: 3, .. }), "{refused}");
    let none = Bench::new("none", b"time_s,force_n\n");
    assert!(Recording::open_told(none.0.join("t.csv"), &alone(&[])).unwrap_err().to_string().contains("no row"));
}

#[test]
fn a_recording_without_a_response_is_written_without_one() {
    let bench = Bench::new("written", b"time_s,force_n\n0,1\n1,2\n");
    let toml = "schema = \"truegap.recording/1\"\nfile = \"t.csv\"\n[base]\nmodel = \"linear\"\n";
    std::fs::write(bench.0.join("t.toml"), toml).unwrap();
    let read = Recording::open_told(bench.0.join("t.toml"), &alone(&[])).unwrap();
    read.write(&bench.0).unwrap();
    let again = Recording::open_told(bench.0.join("recording.toml"), &alone(&[])).unwrap();
    assert_eq!((again.inputs, again.response), (read.inputs, vec![]));
}

#[test]
fn columns_in_memory_ask_for_a_response_as_ever() {
    let values = [0.0, 1.0, 2.0];
    let table = [FrameColumn::numbers("time_s", &values), FrameColumn::numbers("force_n", &values)];
    let toml = "schema = \"truegap.recording/1\"\nfile = \"frame\"\n";
    assert!(matches!(Recording::from_columns("frame", toml, &table), Err(RecordingError::MissingColumn { .. })));
    let inputs = truegap_core::Inputs { run: vec![1, 1], ..truegap_core::Inputs::default() };
    let made = Recording::new(inputs, vec![], "pF", truegap_core::recording::BaseSpec::default());
    assert!(matches!(made, Err(RecordingError::Lengths { found: 0, expected: 2, .. })));
}
