//! What is read, in which units, and that writing and reading are inverse.

use super::*;

#[test]
fn a_bare_csv_with_default_names_is_read_in_si() {
    let text = "run,time_s,force_mn,temperature_k,gap_um,pressure_kpa,humidity_pct,capacitance_ff\n\
                1,0.0,1500,293.15,180,101.325,40,75000\n1,0.5,2500,294.15,170,102,41,76500\n2,10,0,295.15,180,101,42,75100\n";
    let r = csv(text).unwrap();
    assert_eq!(r.inputs.force_n.as_deref(), Some(&[1.5, 2.5, 0.0][..]));
    for (found, wanted) in r.inputs.temperature_c.as_ref().unwrap().iter().zip([20.0, 21.0, 22.0]) {
        approx::assert_abs_diff_eq!(*found, wanted, epsilon = 1e-12); // one rounding of 293.15 and of the difference
    }
    approx::assert_relative_eq!(r.inputs.gap_m.as_ref().unwrap()[1], 170e-6, max_relative = 1e-15);
    approx::assert_relative_eq!(r.inputs.pressure_pa.as_ref().unwrap()[0], 101_325.0, max_relative = 1e-15);
    approx::assert_relative_eq!(r.response[1], 76.5, max_relative = 1e-15);
    assert_eq!((r.response_unit.as_str(), r.inputs.run.as_slice()), ("pF", &[1, 1, 2][..]));
    assert_eq!(r.inputs.runs(), vec![0..2, 2..3]);
    assert_eq!(r.sha256, Sha256::digest(text).iter().map(|b| format!("{b:02x}")).collect::<String>());
}

#[test]
fn without_time_and_run_there_is_one_run_and_no_clock() {
    let r = csv("gap_mm,capacitance_pf\n8,1.07\n7.5,1.07\n7.5,1.08\n").unwrap();
    assert_eq!((r.inputs.time_s, r.inputs.run.as_slice()), (None, &[1, 1, 1][..]));
    assert_eq!(r.base.model, "gap-plate");
    assert!(r.notes.iter().any(|n| matches!(n, Note::BaseAssumed { .. })));
}

#[test]
fn columns_are_named_and_units_given_in_the_toml() {
    let toml = "[columns]\ntime = \"t\"\nforce = \"Load [kgf]\"\nresponse = \"out\"\n[units]\ntime = \"min\"\nresponse = \"mV\"\n\
                [base]\nmodel = \"stack\"\nsensor = \"x.toml\"\nwarp = false\ngain = 2.5\n";
    let r = with_toml(toml, "t,Load [kgf],out\n0,1,3\n1,2,5\n").unwrap();
    assert_eq!(r.inputs.time_s.as_deref(), Some(&[0.0, 60.0][..]));
    assert_eq!(r.inputs.force_n.as_deref(), Some(&[9.80665, 19.6133][..]));
    assert_eq!((r.response.as_slice(), r.response_unit.as_str()), (&[3.0, 5.0][..], "mV"));
    assert_eq!((r.base.sensor.as_deref(), r.base.warp), (Some("x.toml"), Some(false)));
    assert_eq!(r.base.further.get("gain").and_then(|v| v.as_float()), Some(2.5));
    assert!(r.notes.is_empty(), "{:?}", r.notes);
}

#[test]
fn a_response_that_is_no_capacitance_keeps_its_name() {
    let counts = with_toml("[columns]\nresponse = \"counts\"\n", "pressure_bar,counts\n0.1,240\n0.2,230\n").unwrap();
    assert_eq!((counts.response_unit.as_str(), counts.response[0]), ("counts", 240.0));
    let ppm = with_toml("[columns]\nresponse = \"error_ppm\"\n", "temperature_c,error_ppm\n20,1\n21,2\n").unwrap();
    assert_eq!(ppm.response_unit, "ppm");
}

#[test]
fn a_simulated_column_without_a_unit_shares_the_responses() {
    let r = with_toml("[columns]\nsimulated = \"comsol\"\n", "time_s,capacitance_ff,comsol\n0,1000,2000\n1,1100,2100\n").unwrap();
    approx::assert_relative_eq!(r.inputs.simulated.as_ref().unwrap()[0], 2.0, max_relative = 1e-15);
    assert_eq!(r.base.model, "external");
    let differ = with_toml("[units]\nsimulated = \"V\"\n", "time_s,capacitance_ff,simulated\n0,1,2\n");
    assert!(matches!(differ, Err(RecordingError::UnitsDiffer { .. })), "{differ:?}");
    // a unit in the header counts; the last word of a name that is no unit does not
    let named = |column: &str| {
        with_toml(&format!("[columns]\nsimulated = \"{column}\"\n"), &format!("time_s,capacitance_ff,{column}\n0,1,2\n"))
    };
    assert!(matches!(named("Force model [N]"), Err(RecordingError::UnitsDiffer { .. })), "{:?}", named("Force model [N]"));
    assert_eq!(named("sensor_simulated").unwrap().inputs.simulated, named("comsol").unwrap().inputs.simulated);
}

#[test]
fn a_simulation_in_a_unit_of_its_own_is_read_where_the_gain_is_free() {
    let with = |base: &str| {
        let toml = format!(
            "[columns]\nresponse = \"sonic\"\n[units]\nsimulated = \"g/m3\"\nresponse = \"degC\"\n[base]\nmodel = \"external\"\n{base}"
        );
        with_toml(&toml, "time_s,sonic,simulated\n0,1,2\n1,2,3\n")
    };
    for free in ["free = [\"gain\", \"offset\"]", "gain = true", "gain = 0.5"] {
        let r = with(free).unwrap();
        assert_eq!((r.simulated_unit.as_deref(), r.inputs.simulated.as_deref()), (Some("g/m3"), Some(&[2.0, 3.0][..])), "{free}");
        assert!(r.notes.iter().any(|note| note.to_string().contains("in g/m3 and the response in degC")), "{:?}", r.notes);
    }
    for held in ["", "free = []", "free = [\"offset\"]", "gain = false", "free = [\"gain\"]\ngain = false"] {
        let refused = with(held).unwrap_err().to_string();
        assert!(refused.contains("free = [\"gain\", \"offset\"]"), "{held}: {refused}");
    }
}

#[test]
fn semicolons_tabs_windows_line_ends_and_a_byte_order_mark_are_read() {
    let plain = csv("time_s,capacitance_pf\n0,74.5\n1,75.25\n").unwrap();
    for text in [
        "\u{feff}time_s;capacitance_pf\r\n0;74,5\r\n1;75,25\r\n",
        "time_s\tcapacitance_pf\n0\t74.5\n1\t75,25",
        "time_s , capacitance_pf,\n0, 74.5,\n\n1,75.25,\n",
    ] {
        let other = csv(text).unwrap();
        assert_eq!((other.response, other.inputs.time_s), (plain.response.clone(), plain.inputs.time_s.clone()), "{text:?}");
    }
}

const VENDOR: &str = "Start Time;08/05/2026 11:59:31\r\n\r\nTime(s);COM5 - PPS Sensor (N);(Selected Full Scale Range: 1N)\r\n\
                      0;1;\r\n0;0;\r\n0,033;null;\r\n0,054;1,5;\r\n0,071;-1;\r\n0;-0,001953125;\r\n0,5;0,25;\r\n";

#[test]
fn the_singletact_tool_speaks_in_semicolons_and_decimal_commas() {
    let r = csv(VENDOR).unwrap();
    assert_eq!(r.response, [1.0, 1.5, -1.0, -0.001_953_125, 0.25]);
    assert_eq!((r.response_unit.as_str(), r.base.model.as_str()), ("N", "constant"));
    assert_eq!(r.inputs.run, [1, 1, 1, 2, 2]);
    let time = r.inputs.time_s.unwrap();
    assert!(time.windows(2).all(|w| w[1] > w[0]), "one clock through the tare: {time:?}");
    approx::assert_relative_eq!(time[4] - time[3], 0.5, max_relative = 1e-12);
    assert!(r.notes.contains(&Note::RepeatedStamps { rows: 1, first_line: 5 }), "{:?}", r.notes);
    assert!(r.notes.contains(&Note::TareReset { line: 9, run: 2 }), "{:?}", r.notes);
    let missing = r.notes.iter().find(|n| matches!(n, Note::RowsWithoutValue { .. }));
    assert!(matches!(missing, Some(Note::RowsWithoutValue { rows: 1, first_line: 6, .. })), "{:?}", r.notes);
}

#[test]
fn the_singletact_tool_speaks_in_commas_and_points_as_well() {
    let text = VENDOR.replace(',', ".").replace(';', ",");
    let (points, commas) = (csv(text).unwrap(), csv(VENDOR).unwrap());
    assert_eq!((points.response, points.inputs), (commas.response, commas.inputs));
}

/// Any table whose first words were these was read as an export of the tool: its loads were a second sensor, and a clock that ran back was a tare.
#[test]
fn a_start_time_alone_makes_no_export_of_the_tool() {
    let rows = "0,1,74\n1,2,75\n2,3,76\n";
    for head in ["Start time [s],force_n,capacitance_pf\n", "Start Time: 2026-03-01 12:00:00\ntime_s,force_n,capacitance_pf\n"] {
        let r = csv(format!("{head}{rows}")).unwrap();
        assert_eq!((r.inputs.force_n.as_deref(), r.response.as_slice()), (Some(&[1.0, 2.0, 3.0][..]), &[74.0, 75.0, 76.0][..]));
    }
    let back = csv("Start Time,2026-03-01\ntime_s,force_n,capacitance_pf\n0,1,74\n1,2,75\n0,3,76\n");
    assert!(matches!(back, Err(RecordingError::TimeRunsBack { .. })), "{back:?}");
}

#[test]
fn several_sensors_of_the_tool_become_runs_of_their_own() {
    let text =
        "Start Time,01/01/2026\n\nTime(s),COM5 - PPS Sensor (N),COM6 - PPS Sensor (N),\n0,1,10,\n0.1,null,20,\n0.2,3,30,\n";
    let r = csv(text).unwrap();
    assert_eq!(r.response, [1.0, 3.0, 10.0, 20.0, 30.0]);
    assert_eq!(r.inputs.run, [1, 1, 2, 2, 2]);
    let sensors = r.sensors.as_ref().unwrap();
    assert_eq!((sensors.of_row.as_slice(), sensors.names.len()), (&[0, 0, 1, 1, 1][..], 2));
    let second = r.of_sensor("COM6 - PPS Sensor (N)");
    assert_eq!(
        (second.response.as_slice(), second.inputs.time_s.as_deref()),
        (&[10.0, 20.0, 30.0][..], Some(&[0.0, 0.1, 0.2][..]))
    );
}

#[test]
fn a_sensor_column_begins_a_run_where_the_sensor_changes() {
    let r = csv("sensor,run,time_s,capacitance_pf\na,1,0,1\na,2,9,2\nb,1,0,3\nb,1,1,4\n").unwrap();
    assert_eq!(r.inputs.run, [1, 2, 3, 3]);
    assert_eq!(r.of_sensor("b").response, [3.0, 4.0]);
    let mixed = csv("sensor,time_s,capacitance_pf\na,0,1\nb,0,2\na,1,3\n");
    assert!(matches!(mixed, Err(RecordingError::RunReturns { line: 4, .. })), "{mixed:?}");
}

#[test]
fn a_clock_that_restarts_with_a_run_is_carried_on_and_said_aloud() {
    let r = csv("run,time_s,capacitance_pf\n1,0,1\n1,2,2\n2,0,3\n2,2,4\n").unwrap();
    assert_eq!(r.inputs.time_s.as_deref(), Some(&[0.0, 2.0, 4.0, 6.0][..]));
    assert!(r.notes.contains(&Note::ClockCarriedOn { line: 4, run: 2, shift_s: 4.0 }), "{:?}", r.notes);
}

/// A daily cycle is carried over by the date: noon of 1 March 2026 is 20 513.5 days after the begin of 1970.
#[test]
fn a_clock_of_dates_tells_when_it_began_and_one_that_was_carried_on_does_not() {
    let began = |rows: &str| csv(format!("run,time,capacitance_pf\n{rows}")).unwrap().inputs.began_s;
    let noon = 20_513.5 * 86_400.0;
    assert_eq!(began("1,2026-03-01 12:00:00,1\n1,2026-03-01 12:00:10,2\n"), Some(noon));
    assert_eq!(began("1,2026-03-01T13:00:00+01:00,1\n1,2026-03-01T13:00:10+01:00,2\n"), Some(noon));
    assert_eq!(began("1,2026-03-01 12:00:00,1\n1,2026-03-01 12:00:10,2\n2,2026-03-01 11:00:00,3\n"), None);
    assert_eq!(csv("time_s,capacitance_pf\n0,1\n1,2\n").unwrap().inputs.began_s, None);
}

#[test]
fn writing_and_reading_are_inverse() {
    let time: Vec<f64> = (0..50).map(|k| 0.1 * f64::from(k) + 1e-3 * f64::from(k * k)).collect();
    let wave = |a: f64| Some(time.iter().map(|t| a * (1.0 + t).ln()).collect::<Vec<f64>>());
    let inputs = Inputs {
        began_s: None,
        run: (0..50).map(|k| 1 + k / 20).collect(),
        force_n: wave(4.5),
        pressure_pa: wave(1e4),
        gap_m: wave(1e-4),
        temperature_c: wave(20.0),
        humidity_pct: wave(40.0),
        simulated: wave(75.0),
        time_s: Some(time.clone()),
        drivers: vec![
            Driver { name: "position".into(), unit: "mm".into(), values: wave(0.7).unwrap() },
            Driver { name: "temperature_of_room".into(), unit: "degF".into(), values: wave(70.0).unwrap() },
        ],
    };
    let further = [("gain".to_owned(), toml::Value::Float(0.1))].into_iter().collect();
    let base = BaseSpec { model: "stack".into(), sensor: Some("s".into()), warp: Some(true), further };
    for unit in ["pF", "counts"] {
        let made = Recording::new(inputs.clone(), wave(75.1).unwrap(), unit, base.clone()).unwrap();
        let folder = Folder::new();
        made.write(&folder.0).unwrap();
        let read = Recording::open(&folder.0).unwrap();
        assert_eq!((&read.inputs, &read.response, &read.base), (&made.inputs, &made.response, &made.base));
        assert_eq!((&read.response_unit, &read.sha256, &read.columns), (&made.response_unit, &made.sha256, &made.columns));
    }
}

/// `run` under [columns], which is written for every recording, was refused where no [base] stands.
#[test]
fn a_recording_without_a_base_is_written_and_read_back() {
    let inputs =
        Inputs { run: vec![1, 1, 2], force_n: Some(vec![0.0, 1.0, 2.0]), time_s: Some(vec![0.0, 1.0, 2.0]), ..Inputs::default() };
    let made = Recording::new(inputs, vec![3.0, 4.0, 5.0], "mV", BaseSpec::default()).unwrap();
    let folder = Folder::new();
    made.write(&folder.0).unwrap();
    let read = Recording::open(&folder.0).unwrap();
    assert_eq!((&read.inputs, &read.response, &read.base), (&made.inputs, &made.response, &made.base));
    // a program is a list, and stands under [base]
    let program = message(with_toml("[columns]\nrun = [\"python3\", \"sim.py\"]\n", "time_s,capacitance_pf\n0,1\n"));
    assert!(program.contains("line 4") && program.contains("it belongs under [base]"), "{program}");
}

const TWO_DRIVERS: &str = "schema = \"truegap.recording/1\"\nfile = \"a.csv\"\n[columns]\nresponse = \"pull_n\"\n[units]\nresponse = \"N\"\n\
    [drivers]\nposition = { column = \"x_mm\" }\npump = { column = \"speed\", unit = \"rpm\" }\n";

#[test]
fn drivers_are_read_with_their_own_units_and_follow_the_rows() {
    let r = Recording::from_text("a", TWO_DRIVERS, "time_s,x_mm,speed,pull_n\n0,1.5,300,7\n1,2.5,310,8\n2,3.5,320,9\n").unwrap();
    let told: Vec<_> = r.inputs.drivers.iter().map(|d| (d.name.as_str(), d.unit.as_str(), d.values.clone())).collect();
    assert_eq!(told, [("position", "mm", vec![1.5, 2.5, 3.5]), ("pump", "rpm", vec![300.0, 310.0, 320.0])]);
    assert_eq!(r.select(&[2, 0]).inputs.drivers[0].values, [3.5, 1.5]);
}

#[test]
fn a_driver_that_cannot_be_taken_is_refused_with_its_line_and_what_to_do() {
    let csv = "time_s,x_mm,speed,pull_n\n0,1.5,300,7\n";
    let refused = |from: &str, to: &str, csv: &str| {
        let toml = TWO_DRIVERS.replace(from, to);
        assert!(toml != TWO_DRIVERS || from.is_empty());
        Recording::from_text("a", &toml, csv).unwrap_err().to_string()
    };
    let cases = [
        (refused("\"x_mm\"", "\"y_mm\"", csv), ["a.toml, line 8", "`y_mm` is not in the header", "`x_mm`"]),
        (refused("position =", "simulated =", csv), ["a.toml, line 8", "`simulated` is a role", "under [columns]"]),
        (refused("\"x_mm\"", "\"time_s\"", csv), ["a.toml, line 8", "is the time already", "leave it out of [drivers]"]),
        (refused(", unit = \"rpm\"", "", csv), ["a.toml, line 9", "`speed` has no unit in its name", "unit = \"1\""]),
        (refused("", "", "time_s,x_mm,speed,pull_n\n0,,300,7\n"), ["1 of 1 rows", "no value in `x_mm`", "fill the column"]),
    ];
    for (message, parts) in cases {
        parts.iter().for_each(|part| assert!(message.contains(part), "`{part}` is not in: {message}"));
    }
}
