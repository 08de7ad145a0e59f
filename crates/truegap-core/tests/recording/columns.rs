//! Columns in memory, and headers: sketched, below remarks, behind a hash.

use super::*;

/// The same numbers as a CSV and as columns in memory are the same recording; the route over text shares neither the parser nor the rows.
#[test]
fn columns_in_memory_are_read_as_a_csv_is() {
    let toml = "schema = \"truegap.recording/1\"\nfile = \"a.csv\"\n[columns]\nforce = \"load\"\n[units]\nforce = \"mN\"\n\
                [drivers]\npump = { column = \"pump [V]\" }\n[base]\nmodel = \"linear\"\n";
    let csv = "time_s,load,temperature_c,capacitance_ff,pump [V],run\n0,0,20,240000,5,1\n1,1500,21,238000,5.5,1\n0,4500,22,229000,6,2\n";
    let from_text = truegap_core::Recording::from_text("a", toml, csv).unwrap();
    let table: [(&str, &[f64]); 6] = [
        ("time_s", &[0.0, 1.0, 0.0]),
        ("load", &[0.0, 1500.0, 4500.0]),
        ("temperature_c", &[20.0, 21.0, 22.0]),
        ("capacitance_ff", &[240_000.0, 238_000.0, 229_000.0]),
        ("pump [V]", &[5.0, 5.5, 6.0]),
        ("run", &[1.0, 1.0, 2.0]),
    ];
    let table: Vec<FrameColumn<'_>> = table.into_iter().map(|(name, column)| FrameColumn::numbers(name, column)).collect();
    let from_columns = truegap_core::Recording::from_columns("frame", toml, &table).unwrap();
    assert_eq!(from_columns.inputs, from_text.inputs);
    assert_eq!((&from_columns.response, &from_columns.response_unit), (&from_text.response, &from_text.response_unit));
    assert_eq!((&from_columns.columns, &from_columns.base), (&from_text.columns, &from_text.base));
    assert_eq!(from_columns.inputs.drivers[0].unit, "V");
}

/// The note of columns that were not read was that of a CSV alone.
#[test]
fn what_was_not_read_of_columns_is_told_as_of_a_csv() {
    let spare = |notes: &[Note]| -> Vec<Note> {
        notes.iter().filter(|note| matches!(note, Note::NotRead { .. } | Note::NoInput { .. })).cloned().collect()
    };
    let header = "schema = \"truegap.recording/1\"\nfile = \"a.csv\"\n";
    let command = "[drivers]\ncommand = { column = \"cmd\", unit = \"mm\" }\n";
    let table: Vec<FrameColumn<'_>> = [("cmd", &[1.0, 2.0]), ("spare", &[3.0, 4.0]), ("capacitance_pf", &[7.0, 8.0])]
        .into_iter()
        .map(|(name, column)| FrameColumn::numbers(name, column))
        .collect();
    let folder = std::env::temp_dir().join(format!("truegap-spare-{}", std::process::id()));
    std::fs::create_dir_all(&folder).unwrap();
    let csv = folder.join("a.csv");
    std::fs::write(&csv, "cmd,spare,capacitance_pf,who\n1,3,7,x\n2,4,8,y\n").unwrap();
    let read = |toml: &str| {
        let by_frame = Recording::from_frame("frame", toml, &table, &["who".to_owned()]).unwrap();
        let by_csv = Recording::open_table(&csv, toml).unwrap();
        assert_eq!(spare(&by_frame.notes), spare(&by_csv.notes));
        spare(&by_frame.notes)
    };
    assert_eq!(read(&format!("{header}{command}")), [Note::NotRead { columns: "`spare`, `who`".into() }]);
    // where there is nothing to follow, columns of numbers are what was meant
    assert_eq!(read(header), [Note::NoInput { columns: "`cmd`, `spare`".into() }]);
    let all = format!("{header}{command}spare = {{ column = \"spare\", unit = \"mm\" }}\n");
    assert!(spare(&Recording::from_columns("frame", &all, &table).unwrap().notes).is_empty());
    std::fs::remove_dir_all(&folder).unwrap();
}

#[test]
fn rows_of_a_frame_with_holes_are_left_out_and_counted() {
    let toml = "schema = \"truegap.recording/1\"\nfile = \"frame\"\n";
    let table: Vec<FrameColumn<'_>> = vec![
        FrameColumn::numbers("force_n", &[0.0, f64::NAN, 2.0, 3.0]),
        FrameColumn::numbers("capacitance_pf", &[1.0, 2.0, 3.0, f64::NAN]),
        FrameColumn::numbers("notes", &[f64::NAN; 4]),
    ];
    let read = truegap_core::Recording::from_columns("frame", toml, &table).unwrap();
    assert_eq!(read.response, [1.0, 3.0]);
    assert!(read.notes.iter().any(|n| n.to_string().starts_with("2 rows without a value in `force_n`")), "{:?}", read.notes);
    let short: Vec<FrameColumn<'_>> =
        vec![FrameColumn::numbers("force_n", &[0.0]), FrameColumn::numbers("capacitance_pf", &[1.0, 2.0])];
    assert!(truegap_core::Recording::from_columns("frame", toml, &short).is_err());
    let back: Vec<FrameColumn<'_>> =
        vec![FrameColumn::numbers("time_s", &[1.0, 0.0]), FrameColumn::numbers("capacitance_pf", &[1.0, 2.0])];
    assert!(truegap_core::Recording::from_columns("frame", toml, &back).unwrap_err().to_string().contains("line 2"));
}

/// What a header tells is read back as the roles and units that a person would write; what it does not tell is said and left open.
#[test]
fn a_header_is_sketched_and_read_back() {
    let folder = std::env::temp_dir().join(format!("truegap-sketch-{}", std::process::id()));
    std::fs::create_dir_all(&folder).unwrap();
    let csv = folder.join("bench 1.csv");
    std::fs::write(
        &csv,
        "Elapsed (s),Load cell [mN],Chamber temp [K],cap_pF,pump [V],label\n0,0,293.15,240,5,a\n1,1500,294.15,239,5,b\n",
    )
    .unwrap();
    let sketch = truegap_core::recording::sketch(&csv, &Told::default()).unwrap();
    assert_eq!(sketch.open.len(), 2, "{:?}", sketch.open);
    assert!(
        sketch.open[0].contains("`pump [V]`")
            && sketch.open[1].contains("[base]")
            && sketch.toml.contains("# Not used: pump [V]"),
        "{}",
        sketch.toml
    );
    std::fs::write(folder.join("b.toml"), &sketch.toml).unwrap();
    let read = truegap_core::Recording::open(folder.join("b.toml")).unwrap();
    assert_eq!(read.inputs.force_n, Some(vec![0.0, 1.5]));
    assert_eq!(read.inputs.temperature_c, Some(vec![20.0, 21.0]));
    assert_eq!((read.inputs.time_s, read.response_unit.as_str()), (Some(vec![0.0, 1.0]), "pF"));
    std::fs::write(&csv, "force,a,b\n1,2,3\n").unwrap();
    let sketch = truegap_core::recording::sketch(&csv, &Told::default()).unwrap();
    let open = sketch.open.join("\n");
    assert!(open.contains("which column is the reading") && open.contains("unit of `force`"), "{open}");
    assert!(sketch.toml.contains("# force = \"N\"") && sketch.toml.contains("one of: `a`, `b`"), "{}", sketch.toml);
    std::fs::remove_dir_all(&folder).unwrap();
}

#[test]
fn remarks_above_the_header_are_left_out_and_a_header_behind_a_hash_is_not() {
    let plain = "time_s,capacitance_pf\n0,210.1\n0.1,210.2\n0.2,210.4\n";
    let remarks = csv(format!("# rig 3, load cell 20 N\n# operator JK\n{plain}# end\n")).unwrap();
    assert_eq!(remarks.inputs.time_s.as_deref(), Some(&[0.0, 0.1, 0.2][..]));
    // names of the columns behind a hash, as numpy writes them
    let numpy = csv(format!("# {plain}")).unwrap();
    assert_eq!((numpy.response, numpy.inputs), (remarks.response, remarks.inputs));
}

#[test]
fn commas_are_told_of_only_where_one_was_read_as_a_point() {
    let told = |text: &str| csv(text).unwrap().notes.contains(&Note::DecimalCommas);
    assert!(!told("time_s;capacitance_pf\n0;210.1\n0.1;210.2\n"));
    assert!(told("time_s;capacitance_pf\n0;210,1\n0,1;210,2\n"));
}

/// A frame whose clock was a date was refused.
#[test]
fn dates_and_durations_of_a_frame_are_a_clock() {
    let toml = "schema = \"truegap.recording/1\"\nfile = \"frame\"\n[columns]\ntime = \"when\"\n";
    let read = |cells: Cells| {
        let when = FrameColumn { cells, ..FrameColumn::numbers("when", &[0.25, 60.0]) };
        Recording::from_columns("frame", toml, &[when, FrameColumn::numbers("response_mm", &[1.0, 2.0])]).unwrap()
    };
    let dates = read(Cells::Dates { first: "2026-03-01T12:00:00.25".into() });
    assert_eq!(dates.inputs.time_s.as_deref(), Some(&[0.25, 60.0][..]));
    assert!(
        dates.notes.iter().any(|note| note.to_string().contains("seconds from `2026-03-01T12:00:00.25`")),
        "{:?}",
        dates.notes
    );
    let durations = read(Cells::Durations);
    assert_eq!(durations.inputs.time_s, dates.inputs.time_s);
    assert!(durations.notes.iter().all(|note| !matches!(note, Note::Dates { .. })));
}

/// A column of pressures was a force without a word.
#[test]
fn a_unit_that_overrules_one_of_something_else_is_told() {
    let read =
        with_toml("[columns]\nforce = \"pressure_kpa\"\n[units]\nforce = \"N\"\n", "pressure_kpa,capacitance_pf\n1,74\n2,75\n")
            .unwrap();
    let told =
        Note::UnitOverridesName { column: "pressure_kpa".into(), unit: "N".into(), named: "kpa".into(), by: "[units]".into() };
    assert!(read.notes.contains(&told), "{:?}", read.notes);
}

/// `F` behind a column of a temperature was a farad where somebody gave it beside the header.
#[test]
fn f_is_fahrenheit_for_a_reading_that_is_a_temperature() {
    for (column, unit) in [("Sea temperature [F]", "degF"), ("Sea temperature", "degF"), ("C1", "pF")] {
        let toml = format!("[columns]\nresponse = \"{column}\"\n[units]\nresponse = \"F\"\n");
        let read = with_toml(&toml, &format!("time_s,force_n,{column}\n0,1,60\n1,2,61\n")).unwrap();
        assert_eq!(read.response_unit, unit, "{column}");
    }
}
