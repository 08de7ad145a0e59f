//! Tables as people and instruments write them: letters, separators, headers, remarks, numbers and dates.

#![allow(clippy::unwrap_used)]

use std::sync::atomic::{AtomicUsize, Ordering};
use truegap_core::recording::{Told, sketch};
use truegap_core::{Note, Recording, RecordingError};

/// A table in a folder of its own.
struct Bench(std::path::PathBuf);

impl Bench {
    fn new(name: &str, table: &[u8]) -> Self {
        // tests of one program run side by side, and two may choose the same name
        static NEXT: AtomicUsize = AtomicUsize::new(0);
        let place = NEXT.fetch_add(1, Ordering::Relaxed);
        let folder = std::env::temp_dir().join(format!("truegap-tables-{name}-{}-{place}", std::process::id()));
        std::fs::create_dir_all(&folder).unwrap();
        std::fs::write(folder.join("t.csv"), table).unwrap();
        Self(folder)
    }

    fn read(&self) -> Result<Recording, RecordingError> {
        Recording::open(self.0.join("t.csv"))
    }

    /// Reads the table with the TOML that is sketched of it.
    fn sketched(&self) -> Recording {
        let sketch = sketch(&self.0.join("t.csv"), &Told::default()).unwrap();
        std::fs::write(self.0.join("t.toml"), &sketch.toml).unwrap();
        Recording::open(self.0.join("t.toml")).unwrap_or_else(|error| panic!("{error}\n{}", sketch.toml))
    }
}

impl Drop for Bench {
    fn drop(&mut self) {
        let _ = std::fs::remove_dir_all(&self.0);
    }
}

const ROWS: &str = "0,1,20,74\n0.5,2,21,75\n1,3,22,76\n";

/// Whether a table is read as [`ROWS`] in N, degC and pF.
fn is_those_rows(recording: &Recording, milli: f64) {
    let inputs = &recording.inputs;
    assert_eq!(inputs.time_s.as_deref(), Some(&[0.0, 0.5 * milli, milli][..]));
    assert_eq!(inputs.force_n.as_deref(), Some(&[1.0, 2.0, 3.0][..]));
    assert_eq!(inputs.temperature_c.as_deref(), Some(&[20.0, 21.0, 22.0][..]));
    assert_eq!((recording.response.as_slice(), recording.response_unit.as_str()), (&[74.0, 75.0, 76.0][..], "pF"));
}

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
fn letters_of_four_kinds_are_read_alike() {
    let text = format!("time_s,force_n,temperature [°C],capacitance_pf\n{ROWS}");
    let utf16 =
        |bytes: fn(u16) -> [u8; 2]| "\u{feff}".encode_utf16().chain(text.encode_utf16()).flat_map(bytes).collect::<Vec<u8>>();
    let latin: Vec<u8> = text.chars().map(|c| u8::try_from(u32::from(c)).unwrap()).collect();
    for (name, bytes, foreign) in [
        ("utf8", text.clone().into_bytes(), false),
        ("bom", format!("\u{feff}{text}").into_bytes(), false),
        ("le", utf16(u16::to_le_bytes), false),
        ("be", utf16(u16::to_be_bytes), false),
        ("latin", latin, true),
    ] {
        let read = Bench::new(name, &bytes).read().unwrap();
        is_those_rows(&read, 1.0);
        let told = read.notes.contains(&Note::Windows1252 { text: "temperature [°C]".into() });
        assert_eq!(told, foreign, "{name}: {:?}", read.notes);
    }
}

/// A table longer than what is read at a time; a letter of two units lies across a border, and a fault is found on its line.
#[test]
fn utf16_is_read_in_pieces() {
    let mut text = String::from("time_s,capacitance_pf,label\n");
    (0..20_000)
        .for_each(|k| text.push_str(&format!("{k},{},\u{1f321}{}\n", 74.0 + f64::from(k) * 1e-3, "x".repeat(k as usize % 5))));
    let encode =
        |text: &str| "\u{feff}".encode_utf16().chain(text.encode_utf16()).flat_map(u16::to_le_bytes).collect::<Vec<u8>>();
    let read = Bench::new("pieces", &encode(&text)).read().unwrap();
    assert_eq!((read.len(), read.response[19_999]), (20_000, 74.0 + 19_999.0 * 1e-3));
    text.push_str("20000,x,end\n");
    assert!(matches!(Bench::new("fault", &encode(&text)).read(), Err(RecordingError::NotANumber { line: 20_002, .. })));
}

#[test]
fn lines_are_counted_through_remarks() {
    let text = "# rig\n\ntime_s,capacitance_pf\n0,74\n# a\n% b\n1,75\n# c\n2,x\n";
    let found = Bench::new("remarks", text.as_bytes()).read();
    assert!(matches!(found, Err(RecordingError::NotANumber { line: 9, .. })), "{found:?}");
}

#[test]
fn a_row_that_begins_with_a_marker_is_a_row() {
    let text = "label,time_s,capacitance_pf\n#1,0,74\n#2,1,75\n#3,2,76\n";
    assert_eq!(Bench::new("labels", text.as_bytes()).read().unwrap().response, [74.0, 75.0, 76.0]);
}

#[test]
fn separators_are_found_by_the_rows() {
    for rows in [
        "time_s;force_n;temperature_c;capacitance_pf\n0,0;1,0;20,0;74,0\n0,5;2,0;21,0;75,0\n1,0;3,0;22,0;76,0\n".to_owned(),
        "time, s;force, N;temperature, °C;capacitance, pF\n0,0;1,0;20,0;74,0\n0,5;2,0;21,0;75,0\n1,0;3,0;22,0;76,0\n".to_owned(),
        format!("time_s,force_n,temperature_c,capacitance_pf\n{ROWS}").replace(',', "\t"),
        format!("# time_s,force_n,temperature_c,capacitance_pf\n{ROWS}").replace(',', "   "),
    ] {
        is_those_rows(&Bench::new("separators", rows.as_bytes()).read().unwrap(), 1.0);
    }
}

/// Cells in quotes were refused, with the remedy of another separator.
#[test]
fn commas_in_quotes_are_decimal_points_where_they_can_be_nothing_else() {
    let header = "time_s,force_n,temperature_c,capacitance_pf\n";
    let quoted = "\"0,0\",1,\"20,000\",\"74,0\"\n\"0,5\",2,\"21,000\",\"75,0\"\n\"1,0\",3,\"22,000\",\"76,0\"\n";
    let read = Bench::new("quoted", format!("{header}{quoted}").as_bytes()).read().unwrap();
    is_those_rows(&read, 1.0);
    assert!(read.notes.contains(&Note::DecimalCommas), "{:?}", read.notes);
    let refused = |rows: &str| Bench::new("grouped", format!("{header}{rows}").as_bytes()).read().unwrap_err().to_string();
    for rows in [
        "0,1,20,\"1,074\"\n1,2,21,\"1,075\"\n",     // nothing tells which of the two it is
        "0.5,1,20,\"1,074\"\n1.5,2,21,\"1,075\"\n", // points are decimal ones
        "0.5,1,20,\"74,5\"\n1.5,2,21,\"1,075\"\n",  // both
    ] {
        let told = refused(rows);
        assert!(told.contains("line 2: `") && told.contains("comma"), "{told}");
    }
    assert!(refused("0,1,20,\"1,074\"\n1,2,21,\"1,075\"\n").contains("between thousands or before decimals"));
}

#[test]
fn a_clock_may_be_a_date() {
    let rows = "time,force_n,capacitance_pf\n2026-03-01T12:00:00.250+01:00,1,74\n2026-03-01T11:00:00.500Z,2,75\n2026-03-01T11:00:01Z,3,76\n";
    let read = Bench::new("dates", rows.as_bytes()).read().unwrap();
    assert_eq!(read.inputs.time_s.as_deref(), Some(&[0.25, 0.5, 1.0][..]));
    assert!(read.notes.iter().any(|note| matches!(note, Note::Dates { .. })), "{:?}", read.notes);
    let broken = Bench::new("broken", rows.replace("2026-03-01T11:00:01Z", "noon").as_bytes()).read().unwrap_err().to_string();
    assert!(broken.contains("line 4") && broken.contains("`noon`") && broken.contains("no date"), "{broken}");
}

#[test]
fn what_is_wrong_with_a_column_is_told_once_for_all_rows() {
    let cases: [(&str, &[&str]); 12] = [
        ("time_s,force_n,force_n,capacitance_pf\n0,1,1,74\n", &["columns 2 and 3", "both called `force_n`"]),
        (
            "time_s,temperature_c,capacitance_pf\n0,nan,74\n1,nan,75\n",
            &["2 of 2 rows", "no value in `temperature_c`", "rename it"],
        ),
        ("time_s,temperature_c,capacitance_pf\n0,warm,74\n1,cold,75\n", &["`temperature_c`", "no number in any", "`warm`"]),
        ("time_s,temperature_c,capacitance_pf\n0,warm,74\n1,20,75\n", &["line 2", "`warm`", "correct it"]),
        ("time_s;capacitance_pf\n0;1.236,5\n1;1.237,5\n", &["line 2", "`1.236,5`", "no sign between thousands"]),
        ("time_s;capacitance_pf\n0,5;1.236\n1,5;1.237\n", &["line 2", "`1.236`", "three decimals or one in thousands"]),
        ("time_s,capacitance_pf\n0,\"1,236.5\"\n", &["line 2", "no comma between thousands"]),
        ("time_s,capacitance_pf\n\"0,5\",\"74.5\"\n", &["line 2", "decimal points", "semicolons"]),
        ("time_s,force_n,capacitance_pf\n0,1.5 N,74\n", &["line 2", "`1.5 N`", "unit into the header"]),
        ("0,0;2,0;74,5\n1,0;2,5;75,5\n", &["line 1", "`0,0`", "write a header"]),
        ("# rig 3\n0,1,74\n1,2,75\n", &["line 2", "`0`", "write a header"]),
        ("time,force,capacitance\ns,pF,pF\n0,1,74\n", &["`force`", "`pF` is no unit of force"]),
    ];
    for (text, parts) in cases {
        let told = Bench::new("wrong", text.as_bytes()).read().unwrap_err().to_string();
        parts.iter().for_each(|part| assert!(told.contains(part), "`{part}` is missing in: {told}"));
    }
    let points = "time_s;capacitance_pf\n0,5;1.236\n1,5;1.23\n";
    assert_eq!(
        Bench::new("points", points.as_bytes()).read().unwrap().response,
        [1.236, 1.23],
        "a point that can only be a decimal one"
    );
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

/// The last line was the measure of the table, so that nothing of it was seen.
#[test]
fn what_stands_below_a_table_is_told_with_its_line() {
    let bench = Bench::new("footer", b"time_s,force_n,capacitance_pf\n0,1,74\n1,2,75\nTotal,,\nEnd of file\n");
    let told = bench.read().unwrap_err().to_string();
    assert!(told.contains("line 4: `Total` in column `time_s`"), "{told}");
    let sketch = sketch(&bench.0.join("t.csv"), &Told::default()).unwrap();
    assert!(sketch.toml.contains("force = \"force_n\""), "{}", sketch.toml);
}

/// A line of words ended the reading with an error; a row that was cut off still does.
#[test]
fn words_below_a_table_are_left_out_and_told() {
    let table =
        |below: &str| Bench::new("below", format!("time_s,force_n,capacitance_pf\n0,1,74\n1,2,75\n{below}").as_bytes()).read();
    let read = table("\nEnd of file\nOperator,A. B.\n").unwrap();
    assert_eq!(read.response, [74.0, 75.0]);
    assert!(read.notes.contains(&Note::BelowTable { lines: 2, first_line: 5 }), "{:?}", read.notes);
    for (below, part) in [("2,3\n", "line 4: 2 cells"), ("pause\n2,3,76\n", "line 4: 1 cells")] {
        let told = table(below).unwrap_err().to_string();
        assert!(told.contains(part), "{told}");
    }
}

#[test]
fn a_header_that_comes_again_and_times_of_day_are_told_as_what_they_are() {
    let told = |name: &str, table: &[u8]| Bench::new(name, table).read().unwrap_err().to_string();
    let again = told("again", b"time_s,force_n,capacitance_pf\n0,1,74\ntime_s,force_n,capacitance_pf\n1,2,75\n");
    assert!(again.contains("line 3") && again.contains("it is the header once more"), "{again}");
    for header in ["time", "Date,Time"] {
        let date = if header == "time" { "" } else { "2026-03-01," };
        let table = format!("{header},force_n,capacitance_pf\n{date}12:00:00,1,74\n{date}12:00:01,2,75\n");
        let day = told("day", table.as_bytes());
        assert!(day.contains("holds times of day without their dates") && day.contains("2026-03-01 12:00:00"), "{day}");
    }
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
    assert_eq!(sketch(&header.0.join("t.csv"), &Told::default()).unwrap().open.len(), 2, "the reading and the base");
}

fn with_dates(name: &str, dates: [&str; 3], told: Option<bool>) -> Result<Vec<f64>, String> {
    let rows: String = dates.iter().enumerate().map(|(row, date)| format!("{date},{row},7{row}\n")).collect();
    let bench = Bench::new(name, format!("time,force_n,capacitance_pf\n{rows}").as_bytes());
    let told = Told { dayfirst: told, ..Told::default() };
    let read = Recording::open_told(bench.0.join("t.csv"), &told).map_err(|error| error.to_string())?;
    Ok(read.inputs.time_s.unwrap())
}

/// `01/03/2026` was refused, whatever the other rows showed.
#[test]
fn a_number_above_twelve_shows_the_order_of_dates() {
    const DAY: f64 = 86_400.0;
    let day_first = ["01/03/2026 12:00", "02/03/2026 12:00", "13/03/2026 12:00"];
    assert_eq!(with_dates("dayfirst", day_first, None).unwrap(), [0.0, DAY, 12.0 * DAY]);
    let month_first = ["3/1/2026 9:00 AM", "3/2/2026 9:00 PM", "3/13/2026 9:00 AM"];
    assert_eq!(with_dates("monthfirst", month_first, None).unwrap(), [0.0, 1.5 * DAY, 12.0 * DAY]);
    // one day needs no order, and days alone are a clock
    let one_day = ["01/03/2026 12:00", "01/03/2026 12:01", "01/03/2026 12:02"];
    assert_eq!(with_dates("oneday", one_day, None).unwrap(), [0.0, 60.0, 120.0]);
    assert_eq!(with_dates("days", ["2026-02-28", "2026-03-01", "2026-03-02"], None).unwrap(), [0.0, DAY, 2.0 * DAY]);
}

#[test]
fn an_order_that_no_date_shows_is_asked_for() {
    const DAY: f64 = 86_400.0;
    let open = ["01/03/2026 12:00", "02/03/2026 12:00", "03/03/2026 12:00"];
    let asked = with_dates("open", open, None).unwrap_err();
    assert!(asked.contains("line 2: `01/03/2026 12:00`") && asked.contains("`time`"), "{asked}");
    assert!(asked.contains("dayfirst = true or false in the TOML") && asked.contains("--dayfirst"), "{asked}");
    assert_eq!(with_dates("told", open, Some(true)).unwrap(), [0.0, DAY, 2.0 * DAY]);
    assert_eq!(with_dates("told2", open, Some(false)).unwrap(), [0.0, 31.0 * DAY, 59.0 * DAY]);
    let both = with_dates("both", ["13/03/2026 12:00", "01/03/2026 12:00", "03/14/2026 12:00"], None).unwrap_err();
    assert!(both.contains("line 4: `03/14/2026 12:00`") && both.contains("`13/03/2026 12:00`"), "{both}");
    let wrong = with_dates("wrong", ["01/03/2026 12:00", "13/03/2026 12:00", "14/03/2026 12:00"], Some(false)).unwrap_err();
    assert!(wrong.contains("line 3") && wrong.contains("dayfirst = false"), "{wrong}");
}

#[test]
fn the_toml_says_the_order_of_dates_and_is_sketched_with_it() {
    let table = b"Date,force_n,capacitance_pf\n01/03/2026,0,70\n02/03/2026,1,71\n03/03/2026,2,72\n";
    let bench = Bench::new("order", table);
    let open = sketch(&bench.0.join("t.csv"), &Told::default()).unwrap();
    assert!(open.open.iter().any(|says| says.contains("`01/03/2026` begins with the day")), "{:?}", open.open);
    assert!(open.toml.contains("# dayfirst = true") && open.toml.contains("time = \"Date\""), "{}", open.toml);
    std::fs::write(bench.0.join("t.toml"), open.toml.replace("# dayfirst = true ", "dayfirst = true ")).unwrap();
    let read = Recording::open(bench.0.join("t.toml")).unwrap();
    assert_eq!(read.inputs.time_s.as_deref(), Some(&[0.0, 86_400.0, 172_800.0][..]));
    let told = sketch(&bench.0.join("t.csv"), &Told { dayfirst: Some(false), ..Told::default() }).unwrap();
    assert!(told.toml.contains("\ndayfirst = false\n") && told.open.len() + 1 == open.open.len(), "{}", told.toml);
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
    let asked = sketched(&[]);
    assert!(
        asked.toml.contains("\nresponse = \"bridge [mV/V]\"") && asked.toml.contains("\n# simulated = \"model [mV/V]\""),
        "{}",
        asked.toml
    );
    assert!(asked.open.iter().any(|says| says.contains("`model [mV/V]` is your own simulation")), "{:?}", asked.open);
    let told = sketched(&["simulated=model [mV/V]"]);
    assert!(told.toml.contains("\n[base]\nmodel = \"external\"") && told.open.is_empty(), "{:?}\n{}", told.open, told.toml);
    std::fs::write(bench.0.join("t.toml"), &told.toml).unwrap();
    let read = Recording::open(bench.0.join("t.toml")).unwrap();
    assert_eq!((read.base.model.as_str(), read.inputs.simulated.as_deref()), ("external", Some(&[1.0, 2.0][..])));
}
