//! How cells are written: letters, separators, remarks, numbers, dates, and what is no row.

use crate::bench::{Bench, ROWS, is_those_rows};
use truegap_core::recording::{Told, sketch};
use truegap_core::{Note, Recording, RecordingError};

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
    let cases: [(&str, &[&str]); 15] = [
        ("time_s,force_n,force_n,capacitance_pf\n0,1,1,74\n", &["columns 2 and 3", "both called `force_n`"]),
        (
            "time_s,temperature_c,capacitance_pf\n0,nan,74\n1,nan,75\n",
            &["2 of 2 rows", "no value in `temperature_c`", "rename it"],
        ),
        ("time_s,temperature_c,capacitance_pf\n0,warm,74\n1,cold,75\n", &["`temperature_c`", "no number in any", "`warm`"]),
        ("time_s,temperature_c,capacitance_pf\n0,warm,74\n1,20,75\n", &["line 2", "`warm`", "correct it"]),
        ("time_s;capacitance_pf\n0;1.23,5\n1;1.237,5\n", &["line 2", "`1.23,5`", "no sign between thousands"]),
        ("time_s;capacitance_pf\n0.5;1,236\n1.5;1,237\n", &["line 2", "`1,236`", "three decimals or one in thousands"]),
        (
            "time\tcapacitance_pf\n2026-03-01 12:00Z\t74\n2026-03-01 12:01\t75\n",
            &["line 3", "`2026-03-01 12:01`", "has no zone", "12:00Z`"],
        ),
        (
            "time,capacitance_pf\n01.01.02,74\n01.02.02,75\n",
            &["line 2", "`01.01.02`", "with the day or with the year", "--dayfirst=false"],
        ),
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

/// The last line was the measure of the table, so that nothing of it was seen.
#[test]
fn what_stands_below_a_table_is_told_with_its_line() {
    let bench = Bench::new("footer", b"time_s,force_n,capacitance_pf\n0,1,74\n1,2,75\nStopped,,\nEnd of file\n");
    let told = bench.read().unwrap_err().to_string();
    assert!(told.contains("line 4: `Stopped` in column `time_s`"), "{told}");
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
    // two columns of times of day, of which nobody knows which belongs to the date
    let rows = ["12:00:00,11:00:00,1,74", "12:00:01,11:00:00,2,75"].map(|row| format!("2026-03-01,{row}\n")).concat();
    let day = told("day", format!("Date,time,Since,force_n,capacitance_pf\n{rows}").as_bytes());
    assert!(day.contains("holds times of day without their dates") && day.contains("2026-03-01 12:00:00"), "{day}");
}

/// A recorder that writes the time of day alone was refused. What it writes is a clock, which goes on past midnight; of what day it is, is not known.
#[test]
fn times_of_day_alone_are_a_clock() {
    let table = "Uhrzeit,force_n,capacitance_pf\n23:59:58,1,74\n23:59:59.5,2,75\n00:00:01,3,76\n";
    let read = Bench::new("night", table.as_bytes()).read().unwrap();
    assert_eq!(read.inputs.time_s.as_deref(), Some([0.0, 1.5, 3.0].as_slice()));
    assert_eq!(read.inputs.began_s, None);
    let told = Note::TimesOfDay { column: "Uhrzeit".into(), first: "23:59:58".into() };
    assert!(read.notes.contains(&told), "{:?}", read.notes);
    let wrong = Bench::new("wrong", table.replace("00:00:01", "00:61:01").as_bytes()).read().unwrap_err().to_string();
    assert!(wrong.contains("line 4") && wrong.contains("`00:61:01`"), "{wrong}");
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

/// `1,112` in a table of tabs was 1.112, and `1.236,5` refused.
#[test]
fn signs_between_thousands_are_left_out_where_the_column_shows_them() {
    for (rows, wanted) in [
        ("0.0\t800\n0.5\t1,112\n", [800.0, 1112.0]),
        ("0\t1,234.5\n1\t12.5\n", [1234.5, 12.5]),
        ("0\t1.234,5\n1\t12,5\n", [1234.5, 12.5]),
        ("0\t-1.234.567\n1\t12,5\n", [-1_234_567.0, 12.5]),
    ] {
        let read = Bench::new("thousands", format!("time_s\tcapacitance_pf\n{rows}").as_bytes()).read().unwrap();
        assert_eq!(read.response, wanted, "{rows}");
        assert!(read.notes.contains(&Note::Thousands { columns: "`capacitance_pf`".into() }), "{:?}", read.notes);
    }
}

/// Half an hour was a year: the day was taken to be first wherever dots stand.
#[test]
fn two_digits_of_a_year_may_stand_first() {
    let read = |rows: &str| Bench::new("years", format!("time,capacitance_pf\n{rows}").as_bytes()).read().unwrap().inputs.time_s;
    assert_eq!(read("26.03.01 23:30:00,74\n26.03.02 00:00:00,75\n").as_deref(), Some(&[0.0, 1800.0][..]));
    assert_eq!(read("01.03.26 23:30:00,74\n02.03.26 00:00:00,75\n").as_deref(), Some(&[0.0, 1800.0][..]));
}

/// The line of units was taken, whatever the name said.
#[test]
fn units_that_contradict_one_another_are_refused() {
    let read = |header: &str, units: &str| Bench::new("units", format!("{header}\n{units}\n0,1,74\n1,2,75\n").as_bytes()).read();
    let told = |header: &str, units: &str| read(header, units).unwrap_err().to_string();
    let text = told("Time [s],Force [N],Capacitance [pF]", "s,mN,pF");
    assert!(text.contains("`Force [N]`") && text.contains("unit N in its name and mN in the line"), "{text}");
    let text = told("Time [s],Force [N],Capacitance [pF]", "s,N,fF");
    assert!(text.contains("`Capacitance [pF]`") && text.contains("unit pF in its name and fF"), "{text}");
    assert_eq!(read("Time [s],Force [N],Capacitance [pF]", "s,Newton,pF").unwrap().response, [74.0, 75.0]);
}

/// Days and times of day in two columns were left out both, and the order of rows was the clock.
#[test]
fn a_day_and_a_time_of_day_in_two_columns_are_one_clock() {
    let rows = "31.03.2026;23:59:59;1;74\n01.04.2026;00:00:01,5;2;75\n01.04.2026;;2;75\n01.04.2026;00:00:03;3;76\n";
    for header in ["Datum;Uhrzeit;force_n;capacitance_pf", "date;time;force_n;capacitance_pf"] {
        let bench = Bench::new("joined", format!("{header}\n{rows}").as_bytes());
        for read in [bench.read().unwrap(), bench.sketched()] {
            assert_eq!(read.inputs.time_s.as_deref(), Some(&[0.0, 2.5, 4.0][..]), "{header}");
            let told = read.notes.iter().any(|note| matches!(note, Note::Dates { first, .. } if first == "31.03.2026 23:59:59"));
            assert!(told && !read.notes.iter().any(|note| matches!(note, Note::NotRead { .. })), "{:?}", read.notes);
            let (day, time) = header.split_once(';').map(|(day, rest)| (day, rest.split(';').next().unwrap())).unwrap();
            let says = format!("columns `{day}` and `{time}` hold dates");
            assert!(read.notes.iter().any(|note| note.to_string().starts_with(&says)), "{:?}", read.notes);
        }
    }
}

/// The first ended in a panic of the fit, the others in a verdict or in something that was not the matter.
#[test]
fn numbers_whose_squares_are_none_are_refused() {
    let table = |time: &str, reading: &dyn Fn(usize) -> String| {
        let rows: String = (0..30).map(|k| format!("{k}{time},{},{}\n", k % 7, reading(k))).collect();
        Bench::new("spans", format!("time_s,force_n,capacitance_pf\n{rows}").as_bytes()).read()
    };
    let usual: &dyn Fn(usize) -> String = &|k| (74 + k % 7).to_string();
    for (time, reading, parts) in [
        ("e-300", usual, ["`time_s`", "within 1e-15 s"]),
        ("", &|k| format!("{}e-200", 74 + k % 7), ["`capacitance_pf`", "less than 1e-100"]),
        ("", &|k| format!("{}e160", 74 + k % 7), ["`capacitance_pf`", "more than 1e100"]),
        ("", &|k| format!("74.00000000000{}", k % 2), ["`capacitance_pf`", ""]),
    ] as [(&str, &dyn Fn(usize) -> String, [&str; 2]); 4]
    {
        match table(time, reading) {
            Err(told) => parts.iter().for_each(|part| assert!(told.to_string().contains(part), "{told}")),
            Ok(_) => assert_eq!(parts[1], "", "{parts:?}"),
        }
    }
    let last = table("", &|k| if k % 2 == 0 { "74".into() } else { "74.00000000000001421".into() }).unwrap_err().to_string();
    assert!(last.contains("last digits"), "{last}");
    assert_eq!(table("e-9", usual).unwrap().len(), 30);
}
