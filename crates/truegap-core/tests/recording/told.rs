//! What is refused or noted: with file, line, value and what to do.

use super::*;

/// What the TOML says of a column goes before what its name says; a thermometer is not taken away by it.
#[test]
fn a_column_that_is_named_is_not_taken_for_what_its_name_says() {
    let toml = |columns: &str, drivers: &str| {
        format!("schema = \"truegap.recording/1\"\nfile = \"a.csv\"\n[columns]\n{columns}\n[drivers]\n{drivers}\n")
    };
    let csv = "time_s,pressure,flow,temperature_c\n0,3,1,20\n1,4,2,21\n";
    let without = "time_s,flow,temperature_c\n0,1,20\n1,2,21\n";
    let read = |columns: &str, drivers: &str| Recording::from_text("a", &toml(columns, drivers), csv);
    let response = read("response = \"pressure\"", "flow = { column = \"flow\", unit = \"l/s\" }").unwrap();
    assert_eq!((response.response, response.inputs.pressure_pa), (vec![3.0, 4.0], None));
    let driver = read("response = \"flow\"", "supply = { column = \"pressure\", unit = \"bar\" }").unwrap();
    assert_eq!((&driver.inputs.drivers[0].values, &driver.inputs.pressure_pa), (&vec![3.0, 4.0], &None));
    let room = toml("response = \"flow\"", "room = { column = \"temperature_c\", unit = \"degC\" }");
    let warm = Recording::from_text("a", &room, without).unwrap_err().to_string();
    assert!(warm.contains("is the temperature already"), "{warm}");
}

#[test]
fn a_column_of_another_length_is_refused() {
    let inputs = Inputs { run: vec![1, 1], force_n: Some(vec![1.0]), ..Inputs::default() };
    let made = Recording::new(inputs, vec![1.0, 2.0], "pF", BaseSpec::default());
    assert!(matches!(made, Err(RecordingError::Lengths { found: 1, expected: 2, .. })));
}

#[test]
fn what_is_wrong_is_told_with_file_line_value_and_remedy() {
    let cases: [(&str, &[&str]); 16] = [
        ("", &["bare.csv", "empty", "header line"]),
        ("\n\n", &["bare.csv", "empty"]),
        ("time_s,capacitance_pf\n", &["bare.csv", "no row below the header"]),
        ("0,74.5\n1,75\n", &["line 1", "`0`", "write a header"]),
        ("time_s,force_n\n0,1\n", &["`capacitance_pf`", "`time_s`, `force_n`", "[columns]", "response"]),
        ("time_s,capacitance_pf\n0,74\n1,abc\n", &["line 3", "`abc`", "`capacitance_pf`", "correct it"]),
        ("time_s,capacitance_pf\n\n0,74\n\n1,\n2,\n", &["2 of 3 rows", "line 5", "`capacitance_pf`", "fill the column"]),
        ("time_s,capacitance_pf\r\n0,NaN\r\n", &["1 of 1 rows", "line 2", "`capacitance_pf`", "rename it"]),
        ("time_s,capacitance_pf\n0,74\n5,74\n4,75", &["line 4", "from 5 s to 4 s", "run 1", "start a new run"]),
        // a clock that is carried on behind it would be infinite
        ("time_s,capacitance_pf,run\n0,74,1\n1e308,75,1\n0,74,2\n1,75,2", &["line 3", "1e308 s", "no time of a clock"]),
        ("time_s,capacitance_pf\n0,74\n5,74\n5,75\n5,76\n5,76\n", &["3 of 5 rows", "line 4", "average"]),
        ("time_s,capacitance_pf\n0,74,5\n", &["line 2", "3 cells", "header has 2"]),
        ("run,time_s,capacitance_pf\n1,0,74\nb,1,75\n", &["line 3", "`b`", "number the runs"]),
        ("time_s,temperature_c,capacitance_pf\n0,20,74\n1,-300,75\n", &["line 3", "-300", "absolute zero", "unit"]),
        ("time_s,capacitance_f\n0,75\n1,1e308\n", &["line 3", "`1e308`", "`capacitance_f`", "unit"]),
        ("time_s,force_n,force_kgf,capacitance_pf\n0,1,2,3\n", &["`force_n`, `force_kgf`", "force = \"force_n\""]),
    ];
    for (text, parts) in cases {
        let told = message(csv(text));
        assert!(told.contains("bare.csv"), "{told}");
        for part in parts {
            assert!(told.contains(part), "`{part}` is missing in: {told}");
        }
    }
}

#[test]
fn what_is_wrong_in_a_toml_is_told_with_its_line() {
    let text = "time_s,force,capacitance_pf\n0,1,74\n1,2,75\n";
    let cases: [(&str, &[&str]); 10] = [
        ("[units]\nforce = \"N\"\ngap = \"parsec\"\n", &["r.toml, line 5", "`parsec`", "gap", "mm"]),
        ("base = \"linear\"\n", &["r.toml, line 3", "[base] on a line of its own", "model = \"linear\""]),
        ("columns = \"force\"\n", &["r.toml, line 3", "[columns] on a line of its own"]),
        ("[base]\norder = 2\n", &["r.toml, line 3", "[base] names no model", "model = \"linear\""]),
        ("[units]\nforce = \"pF\"\n", &["r.toml, line 4", "`pF`", "mN, kN"]),
        ("", &["`force`", "[units]", "\"N\""]),
        ("[colums]\nforce = \"force\"\n", &["r.toml, line 3", "colums", "columns"]),
        ("[columns]\nforse = \"force\"\n", &["r.toml, line 4", "forse", "force"]),
        ("[columns]\nresponse = \"c\"\n", &["`c`", "`time_s`, `force`, `capacitance_pf`"]),
        ("[units]\nforce = \"N\"\nresponse = \"PF\"\n", &["r.toml, line 5", "`PF`", "pF"]),
    ];
    for (toml, parts) in cases {
        let told = message(with_toml(toml, text));
        for part in parts {
            assert!(told.contains(part), "`{part}` is missing in: {told}");
        }
    }
}

#[test]
fn another_schema_a_missing_csv_and_a_missing_file_are_told_apart() {
    let folder = Folder::new();
    let other = folder.file("a.toml", "schema = \"truegap.case/1\"\nfile = \"a.csv\"\n");
    let told = message(Recording::open(other));
    assert!(told.contains("line 1") && told.contains("truegap.case/1") && told.contains("truegap.recording/1"), "{told}");
    let lost = folder.file("b.toml", "schema = \"truegap.recording/1\"\nfile = \"b.csv\"\n");
    assert!(matches!(Recording::open(lost), Err(RecordingError::NotFound { file }) if file.ends_with("b.csv")));
    assert!(matches!(Recording::open(Path::new("/nowhere.csv")), Err(RecordingError::NotFound { .. })));
}

#[test]
fn a_unit_in_the_toml_outranks_the_name_and_is_said_aloud() {
    let r = with_toml("[units]\nforce = \"kN\"\n", "time_s,force_n,capacitance_pf\n0,1,74\n1,2,75\n").unwrap();
    assert_eq!(r.inputs.force_n.as_deref(), Some(&[1000.0, 2000.0][..]));
    assert!(r.notes.iter().any(|n| matches!(n, Note::UnitOverridesName { .. })));
}

/// `sea_f` in degF was told to be in farads by its name, and `cap_pf` in picofarads not to be in pF.
#[test]
fn a_name_that_says_the_unit_in_another_way_is_no_doubt() {
    for (name, unit) in
        [("sea_f", "degF"), ("sea_temperature_f", "degF"), ("Sea [F]", "°F"), ("sea_f", "F"), ("cap_pf", "picofarad")]
    {
        for role in ["response", "simulated"] {
            let other = if role == "response" { "simulated" } else { "response" };
            let toml = format!(
                "[columns]\n{role} = \"{name}\"\n{other} = \"other\"\n[units]\n{role} = \"{unit}\"\n{other} = \"{unit}\"\n"
            );
            let r = with_toml(&toml, &format!("time_s,{name},other\n0,50,51\n1,51,52\n")).unwrap();
            let doubts: Vec<_> = r.notes.iter().filter(|n| matches!(n, Note::UnitOverridesName { .. })).collect();
            assert!(doubts.is_empty(), "{name} {unit}: {doubts:?}");
        }
    }
    let farads =
        with_toml("[columns]\nresponse = \"cap_f\"\n[units]\nresponse = \"mV\"\n", "time_s,cap_f\n0,50\n1,51\n").unwrap();
    assert!(farads.notes.iter().any(|n| matches!(n, Note::UnitOverridesName { .. })), "{:?}", farads.notes);
}

#[test]
fn a_column_that_never_changes_is_noted() {
    let r = csv("time_s,force_n,capacitance_pf\n0,1,74\n1,1,75\n").unwrap();
    assert!(r.notes.contains(&Note::Constant { role: Role::Force, value: 1.0 }), "{:?}", r.notes);
}

#[test]
fn lines_are_right_far_into_a_long_file() {
    let mut text = String::from("time_s,capacitance_pf\r\n");
    (0..20_000).for_each(|k| text.push_str(&format!("{k},{}\r\n", 74.0 + f64::from(k) * 1e-3)));
    text.push_str("20000,x\r\n");
    assert!(matches!(csv(&text), Err(RecordingError::NotANumber { line: 20_002, .. })));
}

/// A key that is missing was told as a field of a struct.
#[test]
fn what_every_toml_has_is_asked_for() {
    let read = |toml: &str| Recording::from_text("r", toml, "time_s,capacitance_pf\n0,74\n1,75\n").unwrap_err().to_string();
    assert!(read("file = \"a.csv\"\n").contains("no `schema`; write schema = \"truegap.recording/1\""));
    assert!(read("schema = \"truegap.recording/1\"\n").contains("no `file`; write file = \"NAME.csv\""));
}

/// Milliseconds since 1970 in a column of seconds were a clock of the year 57 000, a thousand times too slow.
#[test]
fn a_clock_from_1970_in_another_unit_is_refused() {
    let clock = |name: &str, first: &str, second: &str| csv(format!("{name},capacitance_pf\n{first},74\n{second},75\n"));
    let told = message(clock("time_s", "1770000000000", "1770000001000"));
    for part in ["`time_s`", "the year 58058", "count from 1970 in ms", "--map time=\"time_s:ms\"", "time = \"ms\" under [units]"]
    {
        assert!(told.contains(part), "`{part}` is missing in: {told}");
    }
    assert!(message(clock("time_s", "1770000000000000000", "1770000001000000000")).contains("divide them by 1e9"));
    assert!(clock("time_s", "1770000000", "1770000001").is_ok() && clock("time_ms", "1770000000000", "1770000001000").is_ok());
}

/// Units of roles that no column plays, and an order of dates where there are none, were left out without a word.
#[test]
fn what_is_told_and_not_used_is_noted() {
    let text = "time_s,force_n,capacitance_pf\n0,1,74\n1,2,75\n";
    let notes = |toml: &str| {
        let read = with_toml(toml, text).unwrap();
        read.notes.iter().map(ToString::to_string).collect::<Vec<_>>().join("; ")
    };
    assert!(notes("[units]\ngap = \"mm\"\n").contains("a unit of gap, and no column was read as that"));
    assert!(notes("dayfirst = true\n").contains("dayfirst was told and not used"));
    let plain = notes("[units]\nforce = \"N\"\n");
    assert!(!plain.contains("no column was read as that") && !plain.contains("dayfirst"), "{plain}");
}

/// It was said to be as [units] says where there was no such file, and a column that stands still had no unit.
#[test]
fn notes_say_where_a_unit_was_told_and_in_which_one_a_number_is() {
    let told = Told { map: vec!["force=force_n:lbs".parse().unwrap()], ..Told::default() };
    let text = "time_s,force_n,capacitance_pf\n0,1,74\n1,1,75\n";
    let toml = "schema = \"truegap.recording/1\"\nfile = \"a.csv\"\n";
    let read = Recording::from_text_told("r", toml, text, &told).unwrap();
    let notes: Vec<String> = read.notes.iter().map(ToString::to_string).collect();
    assert!(notes.iter().any(|note| note.contains("in lbs, as --map says")), "{notes:?}");
    assert!(notes.iter().any(|note| note.contains("never changes from 4.44822161526 N")), "{notes:?}");
}
