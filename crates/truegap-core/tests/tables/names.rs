//! Which column is what: headers as people write them, what is read, sketched, asked for, and told as not read.

use crate::bench::{Bench, ROWS, is_those_rows};
use truegap_core::recording::{Told, sketch};
use truegap_core::{Note, Recording};

#[test]
fn what_is_sketched_of_a_header_is_read() {
    for (number, header) in [
        "t/s,Fz/N,T/°C,C_meas/pF",
        "Time (s),Force (N),temp (°C),Capacitance (pF)",
        "Zeit [s],Kraft [N],Temperatur [°C],Kapazität [pF]",
        "time,force,temp,cap\ns,N,°C,pF",
        "t,F,T,C\n[s],[N],[degC],[pF]",
        "# rig 3\n% operator JK\n// load cell 20 N\nt/s,Fz/N,T in °C,C/pF",
        "% t/s,Fz/N,T/°C,C_meas/pF",
        "# rig 3\n# t/s,Fz/N,T/°C,C_meas/pF",
        "Rig;3\nOperator;JK\n\nt/s,Fz/N,T/°C,C_meas/pF",
        "t/s,Fz/N,T/°C,C_meas/pF\n# zeroed\n% again\n// twice",
        "timeS,forceN,tempC,cap.pF",
    ]
    .into_iter()
    .enumerate()
    {
        let bench = Bench::new(&format!("sketch-{number}"), format!("{header}\n{ROWS}").as_bytes());
        is_those_rows(&bench.sketched(), 1.0);
    }
    let milli = Bench::new("milli", format!("t/ms,F [mN],T [K],C [fF]\n{ROWS}").as_bytes()).sketched();
    assert_eq!(milli.inputs.time_s.as_deref(), Some(&[0.0, 0.0005, 0.001][..]));
    assert_eq!(milli.inputs.force_n.as_deref(), Some(&[0.001, 0.002, 0.003][..]));
    assert_eq!(milli.inputs.temperature_c.as_deref().unwrap()[0], 20.0 - 273.15);
}

#[test]
fn default_names_carry_their_unit_in_any_notation() {
    for header in ["time/s,force in N,temperature [°C],capacitance (pF)", "Time {s},Force N,Temperature deg C,Capacitance/pF"] {
        is_those_rows(&Bench::new("default", format!("{header}\n{ROWS}").as_bytes()).read().unwrap(), 1.0);
    }
}

#[test]
fn a_temperature_in_another_unit_is_a_doubt() {
    let doubt = |unit: &str, shift: f64| {
        let rows: String = (0..4).map(|k| format!("{k},{},74\n", 20.0 + f64::from(k) + shift)).collect();
        let read = Bench::new("degrees", format!("time_s,temperature_{unit},capacitance_pf\n{rows}").as_bytes()).read().unwrap();
        read.notes.iter().find(|note| matches!(note, Note::OtherDegrees { .. })).map(ToString::to_string)
    };
    assert_eq!((doubt("c", 0.0), doubt("k", 273.15), doubt("degf", 273.15)), (None, None, None));
    let told = doubt("c", 273.15).unwrap();
    assert!(told.contains("between 293.15 and 296.15") && told.contains("temperature = \"K\""), "{told}");
    assert!(doubt("k", 0.0).unwrap().contains("temperature = \"degC\""));
    assert_eq!(doubt("c", 150.0), None, "an oven");
}

/// Errors asked for a TOML that stood there all the time.
#[test]
fn an_error_of_a_bare_csv_names_the_toml_beside_it() {
    let bench = Bench::new("beside", b"t,F,C\n0,1,74\n1,2,75\n");
    let told = || bench.read().unwrap_err().to_string();
    assert!(!told().contains("stands beside"), "{}", told());
    std::fs::write(bench.0.join("t.toml"), "schema = \"truegap.recording/1\"\nfile = \"t.csv\"\n").unwrap();
    assert!(told().contains("no column for response") && told().contains("t.toml stands beside this CSV"), "{}", told());
}

#[test]
fn a_bare_csv_says_what_it_did_not_read() {
    let bench = Bench::new("spare", b"time_s,Oven [\xb0C],capacitance_pf\n0,20,74\n1,21,75\n");
    let told: Vec<String> = bench.read().unwrap().notes.iter().map(ToString::to_string).collect();
    assert!(told.iter().any(|note| note.contains("not read: `Oven [°C]`") && note.contains("--map")), "{told:?}");
}

/// `truegap init` read `t [s]` and `Load [N]`; a diagnosis of the table alone left them out, and its answer was wrong.
#[test]
fn a_bare_csv_is_read_by_the_words_that_init_knows() {
    let read = |name: &str, header: &str, map: &[&str]| {
        let bench = Bench::new(name, format!("{header}\n0,1,20,74\n1,2,21,75\n").as_bytes());
        let told = Told { map: map.iter().map(|text| text.parse().unwrap()).collect(), ..Told::default() };
        Recording::open_told(bench.0.join("t.csv"), &told).unwrap()
    };
    let cell = read("words", "t [s],Load [N],T [C],bridge [mV/V]", &["response=bridge [mV/V]"]);
    let inputs = &cell.inputs;
    assert_eq!(inputs.time_s.as_deref(), Some(&[0.0, 1.0][..]));
    assert_eq!((inputs.force_n.as_deref(), inputs.temperature_c.as_deref()), (Some(&[1.0, 2.0][..]), Some(&[20.0, 21.0][..])));
    let told: Vec<String> = cell.notes.iter().map(ToString::to_string).collect();
    assert!(told.iter().any(|note| note.contains("`t [s]` as time, `Load [N]` as force, `T [C]` as temperature")), "{told:?}");
    // what is told goes first; no unit, several columns, or a unit without a word are no reason to read one
    let mapped = ["response=bridge [mV/V]", "driver.weight=Load [N]", "simulated=T [C]"];
    let driven = read("driven", "t,Load [N],T [C],bridge [mV/V]", &mapped[..2]);
    assert_eq!((driven.inputs.time_s, driven.inputs.force_n), (None, None));
    let several = read("several", "age [s],Load 1 [N],Load 2 [N],bridge [mV/V]", &mapped[..1]);
    assert_eq!((several.inputs.time_s, several.inputs.force_n), (None, None));
    let toml = "schema = \"truegap.recording/1\"\nfile = \"t.csv\"\n[columns]\nresponse = \"x_mv\"\n";
    let named = Recording::from_text("t", toml, "t [s],Load [N],x_mv\n0,1,2\n1,2,3\n").unwrap();
    assert_eq!((named.inputs.time_s, named.inputs.force_n), (None, None), "a TOML says all");
}

/// Only `truegap init` took these for a clock; a note said that they were not read.
#[test]
fn dates_are_the_clock_of_a_bare_csv_whatever_they_are_called() {
    let times = |name: &str, header: &str, rows: [&str; 2]| {
        let bench = Bench::new(name, format!("{header},force_n,capacitance_pf\n{},1,74\n{},2,75\n", rows[0], rows[1]).as_bytes());
        bench.read().unwrap().inputs.time_s
    };
    let (stamps, days) = (["2026-03-01 12:00:00", "2026-03-01 12:00:01.5"], ["2026-03-01", "2026-03-02"]);
    for name in ["timestamp", "Timestamp", "datetime", "DateTime", "Zeitstempel", "Recorded at"] {
        assert_eq!(times("stamps", name, stamps), Some(vec![0.0, 1.5]), "{name}");
    }
    assert_eq!(times("daily", "timestamp", days), Some(vec![0.0, 86_400.0]));
    // days without a name that says so may be all one and the same; a clock that is called `time` goes before dates
    assert_eq!(times("days", "Delivered", days), None);
    assert_eq!(times("both", "timestamp,time_s", ["2026-03-01 12:00,0", "2026-03-01 12:01,1"]), Some(vec![0.0, 1.0]));
    assert_eq!(
        times("two", "calibrated,logged", ["2026-01-01 10:00,2026-03-01 12:00", "2026-01-01 10:00,2026-03-01 12:01"]),
        None
    );
    let named = ["2026-01-01 10:00,2026-03-01 12:00", "2026-01-01 10:00,2026-03-01 12:01"];
    assert_eq!(times("named", "calibrated,timestamp", named), Some(vec![0.0, 60.0]));
}

/// Such a column was a remark in the TOML, and the recording had no clock or no load without a word.
#[test]
fn a_column_called_after_a_role_that_holds_no_number_is_left_to_somebody() {
    let bench = Bench::new("no-number", "Zeit [s];Kraft [N];C [pF]\n1.000,0;5 N;74,5\n1.000,5;6 N;75,5\n".as_bytes());
    let open = sketch(&bench.0.join("t.csv"), &Told::default()).unwrap().open;
    for part in ["`Zeit [s]` is called after the time", "`Kraft [N]` is called after the force"] {
        assert!(open.iter().any(|says| says.contains(part)), "{open:?}");
    }
    let bench =
        Bench::new("thousands", "t/s,Kraft [N],Messwert [mV],Prüfer\n0.5,5.1,\"1,074\",A\n1.5,6.2,\"1,075\",B\n".as_bytes());
    let open = sketch(&bench.0.join("t.csv"), &Told::default()).unwrap().open;
    assert!(open.iter().any(|says| says.contains("`Messwert [mV]` is called after the response")), "{open:?}");
    assert!(!open.iter().any(|says| says.contains("Prüfer")), "{open:?}");
    let header = Bench::new("header-only", b"time_s,force_n,capacitance_pf\n");
    let none = sketch(&header.0.join("t.csv"), &Told::default()).unwrap_err().to_string();
    assert!(none.contains("no row below the header"), "{none}");
}

/// A driver needed a TOML, and `truegap init` left it as a remark whatever was said.
#[test]
fn columns_that_are_told_of_are_read_and_sketched() {
    let bench = Bench::new("told", b"clock,x,stroke [mm],pump\n0,1,20,5\n0.5,2,21,6\n1,3,22,7\n");
    let map = ["time=clock:s", "response=x:mV", "driver.position=stroke [mm]", "driver.pump=pump:V"];
    let told = Told { map: map.map(|text| text.parse().unwrap()).to_vec(), ..Told::default() };
    let read = Recording::open_told(bench.0.join("t.csv"), &told).unwrap();
    let drivers: Vec<_> = read.inputs.drivers.iter().map(|d| (d.name.as_str(), d.unit.as_str(), d.values[2])).collect();
    assert_eq!(drivers, [("position", "mm", 22.0), ("pump", "V", 7.0)]);
    assert!(read.notes.iter().all(|note| !matches!(note, Note::NotRead { .. })), "{:?}", read.notes);
    let sketch = sketch(&bench.0.join("t.csv"), &told).unwrap();
    std::fs::write(bench.0.join("t.toml"), &sketch.toml).unwrap();
    let again = Recording::open(bench.0.join("t.toml")).unwrap_or_else(|error| panic!("{error}\n{}", sketch.toml));
    assert_eq!((again.inputs, again.response_unit), (read.inputs, read.response_unit));
    let refused = |text: &str| {
        let told = Told { map: vec![text.parse().unwrap()], ..Told::default() };
        truegap_core::recording::sketch(&bench.0.join("t.csv"), &told).unwrap_err().to_string()
    };
    assert!(
        refused("driver.pump=pump")
            .contains("--map driver.pump: column `pump` has no unit in its name; write driver.pump=\"pump:mm\"")
    );
    assert!(refused("driver.pump=pumpe:V").contains("did you mean `pump`") && refused("force=fors:N").contains("`fors`"));
}

/// `init` asked for nothing but the reading; with that alone the base was a constant, and nothing said that the command was not read. It asked for a unit that a diagnosis reads from the name.
#[test]
fn what_a_reading_follows_is_asked_for_where_nothing_was_read() {
    let bench = Bench::new("follows", b"time_ms,cmd_mm,enc_mm\n0,1,1.1\n20,2,2.1\n40,3,3.2\n");
    let told = |map: &[&str]| Told { map: map.iter().map(|text| text.parse().unwrap()).collect(), ..Told::default() };
    let sketched = |map: &[&str]| sketch(&bench.0.join("t.csv"), &told(map)).unwrap();
    let named = sketched(&["response=enc_mm"]);
    assert!(named.toml.contains("response = \"mm\"") && !named.open.iter().any(|says| says.contains("unit")), "{}", named.toml);
    assert!(named.open.iter().any(|says| says.starts_with("what `cmd_mm` may be")), "{:?}", named.open);
    assert!(named.open.iter().any(|says| says.contains("complete [base]")), "{:?}", named.open);
    assert!(sketched(&[]).open.iter().any(|says| says.contains("complete [base]")));
    std::fs::write(bench.0.join("t.toml"), &named.toml).unwrap();
    let notes = |recording: Recording| recording.notes.iter().map(ToString::to_string).collect::<Vec<_>>().join("; ");
    let read = notes(Recording::open(bench.0.join("t.toml")).unwrap());
    assert!(read.contains("these columns of numbers were not read: `cmd_mm`"), "{read}");
    let bare = |map: &[&str]| notes(Recording::open_told(bench.0.join("t.csv"), &told(map)).unwrap());
    assert!(bare(&["response=enc_mm"]).contains("not read: `cmd_mm`; if one is what was done"));
    assert!(!bare(&["response=enc_mm", "driver.command=cmd_mm"]).contains("`cmd_mm`"));
}

/// The column of a simulation was proposed as the reading or as a driver, and the base that goes with it was not written.
#[test]
fn a_column_that_is_called_after_a_simulation_is_proposed_as_one() {
    let bench = Bench::new("computed", b"t [s],Load [N],bridge [mV/V],model [mV/V]\n0,1,1.1,1\n1,2,2.1,2\n");
    let sketched = |map: &[&str]| {
        let told = Told { map: map.iter().map(|text| text.parse().unwrap()).collect(), ..Told::default() };
        sketch(&bench.0.join("t.csv"), &told).unwrap()
    };
    let found = sketched(&[]);
    assert!(
        found.toml.contains("\nresponse = \"bridge [mV/V]\"")
            && found.toml.contains("\nsimulated = \"model [mV/V]\"   # by its name")
            && found.toml.contains("\n[base]\nmodel = \"external\""),
        "{}",
        found.toml
    );
    let other = Bench::new("input", b"t [s],Load [N],Load model [N],C [pF]\n0,1,1.1,1\n1,2,2.1,2\n");
    let asked = sketch(&other.0.join("t.csv"), &Told::default()).unwrap();
    assert!(asked.toml.contains("\n# simulated = \"Load model [N]\""), "{}", asked.toml);
    assert!(asked.open.iter().any(|says| says.contains("`Load model [N]` is your own simulation")), "{:?}", asked.open);
    let told = sketched(&["simulated=model [mV/V]"]);
    assert!(told.toml.contains("\n[base]\nmodel = \"external\"") && told.open.is_empty(), "{:?}\n{}", told.open, told.toml);
    std::fs::write(bench.0.join("t.toml"), &told.toml).unwrap();
    let read = Recording::open(bench.0.join("t.toml")).unwrap();
    assert_eq!((read.base.model.as_str(), read.inputs.simulated.as_deref()), ("external", Some(&[1.0, 2.0][..])));
}

/// The column of the instrument was taken for an input, and the simulation, or the bath, was offered as the reading.
#[test]
fn of_two_columns_of_one_quantity_the_one_that_was_measured_is_the_reading() {
    let sketched = |header: &str, row: &str| {
        let bench = Bench::new("twins", format!("{header}\n{row}\n").as_bytes());
        sketch(&bench.0.join("t.csv"), &Told::default()).unwrap()
    };
    let external = [
        ("Date/Time,Sim load (N),Load cell (N),Ambient (degC)", "17/03/2026 08:12:04,125.4,127.9,22.0", "Load cell (N)"),
        ("Time [s],F_sim [N],F_meas [N],T [°C]", "0.0,0.00,0.2,23.0", "F_meas [N]"),
        ("Datum;Uhrzeit;Bad Sim [°C];Fühler [°C]", "04.05.2026;06:30:00;74,19;73,1", "Fühler [°C]"),
        ("time_s,sim_lpm,flow_lpm,supply_V", "0.0,1.0,1.1,5.0", "flow_lpm"),
        ("t,torque_model,torque_sensor", "0.0,1.0,1.1", "torque_sensor"),
    ];
    for (header, row, reading) in external {
        let sketch = sketched(header, row);
        let found = |role: &str| sketch.found.iter().find(|(of, _)| of == role).map(|(_, column)| column.as_str());
        assert_eq!((found("response"), found("force")), (Some(reading), None), "{}", sketch.toml);
        assert!(found("simulated").is_some() && sketch.toml.contains("\nmodel = \"external\""), "{}", sketch.toml);
    }
    let bath = sketched("Time [s];Bath [degC];Thermocouple [degC]", "0;86.56;86.5");
    assert!(
        bath.toml.contains("response = \"Thermocouple [degC]\"") && bath.toml.contains("temperature = \"Bath [degC]\""),
        "{}",
        bath.toml
    );
    assert!(bath.open.iter().any(|says| says.contains("complete [base]")), "{:?}", bath.open);
    let gas = sketched("Date;Time;CO2 reference (ppm);Sensor (ppm);RH (%)", "01.03.2026;12:00:00;400;410;40");
    assert!(gas.toml.contains("response = \"Sensor (ppm)\""), "{}", gas.toml);
    // what no name tells is left to somebody: either column may be what was done, and so may both
    for (header, row, role) in [
        ("Time [s],Applied [N],Load cell [N]", "0,1.0,1.1", "force"),
        ("Time [s],Bath [degC],Thermocouple [degC],bridge [mV/V]", "0,1.0,1.1,2.0", "temperature"),
        ("Time [s],Setpoint [degC],Thermocouple [degC]", "0,1.0,1.1", "temperature"),
    ] {
        let sketch = sketched(header, row);
        assert!(sketch.found.iter().all(|(of, _)| of == "time"), "{:?}", sketch.found);
        assert!(sketch.open.iter().any(|says| says.starts_with("which of") && says.contains(role)), "{:?}", sketch.open);
        assert!(sketch.open.iter().any(|says| says.starts_with("which column is the reading")), "{:?}", sketch.open);
    }
}

/// `response_mA` was read in mA by a diagnosis and asked for here, a torque in nanometres, and the set point of a buffer was a pressure.
#[test]
fn units_and_quantities_that_look_like_others_are_told_apart() {
    let bench = Bench::new("look-alikes", b"elapsed_s,pH set,torque_nm,response_mA\n0,4.0,1.0,5.0\n1,7.0,2.0,6.0\n");
    let sketch = sketch(&bench.0.join("t.csv"), &Told::default()).unwrap();
    assert!(!sketch.toml.contains("pressure ="), "{}", sketch.toml);
    let bench = Bench::new("acid", b"t_s,pH,mV,T_C\n0,4.0,1.0,20\n1,7.0,2.0,21\n");
    let acid = truegap_core::recording::sketch(&bench.0.join("t.csv"), &Told::default()).unwrap();
    assert!(!acid.toml.contains("pressure ="), "{}", acid.toml);
    assert!(sketch.toml.contains("response = \"mA\"") && sketch.toml.contains("unit = \"Nm\""), "{}", sketch.toml);
}
