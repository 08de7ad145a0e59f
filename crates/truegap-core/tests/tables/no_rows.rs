//! Lines that are no rows, and rows that are none of these: remarks, quotes that do not close, what a spreadsheet writes below its numbers.

use crate::bench::Bench;
use truegap_core::{Note, Recording, RecordingError};

fn read(text: &str) -> Result<Recording, RecordingError> {
    Bench::new("no_rows", text.as_bytes()).read()
}

/// Rows `first` to `last` of a table `time_s,force_n,capacitance_pf`, each behind `before`.
fn rows(first: usize, last: usize, before: &str) -> String {
    (first..=last).map(|k| format!("{before}{k},{},{}\n", k % 7, 74 + k % 7)).collect()
}

/// Read with 31 rows fewer, and without a word.
#[test]
fn a_quote_that_does_not_close_is_told_by_the_line_where_it_opens() {
    let head = "time_s,force_n,capacitance_pf,note\n";
    let noted = |first, last| rows(first, last, "").replace('\n', ",\n");
    for text in [
        format!("{head}{}30,1,74,\"heater on\n{}", noted(0, 29), noted(31, 60)),
        format!("{head}{}30,1,74,\"12\n{}40,1,74,\"12\n{}", noted(0, 29), noted(31, 39), noted(41, 60)),
    ] {
        let told = read(&text).unwrap_err().to_string();
        assert!(told.contains("line 32:") && told.contains("`note`") && told.contains("close it"), "{told}");
    }
    let several_lines = format!("{head}{}30,1,74,\"heater on,\nby hand\"\n{}", noted(0, 29), noted(31, 60));
    assert_eq!(read(&several_lines).unwrap().len(), 61);
}

/// Rows were left out without a word where none of the first 200 lines began so, and refused where one did.
#[test]
fn rows_behind_a_sign_of_remarks_are_left_out_and_told_wherever_they_stand() {
    let head = "time_s,force_n,capacitance_pf\n";
    for (first, line) in [(250, 252), (50, 52)] {
        let text = format!(
            "{head}{}{}# heater on, at last\n{}",
            rows(0, first - 1, ""),
            rows(first, first + 1, "#"),
            rows(first + 2, 299, "")
        );
        let read = read(&text).unwrap();
        let told = Note::MarkedRows { lines: 2, first_line: line, taken: false };
        assert!(read.len() == 298 && read.notes.contains(&told), "{} {:?}", read.len(), read.notes);
        assert!(
            told.to_string().contains(&format!("2 lines begin as a remark does and look like a row (the first on line {line})")),
            "{told}"
        );
    }
}

/// Labels that begin with a hash were remarks where they came late.
#[test]
fn words_of_a_first_column_may_begin_as_remarks_do() {
    let head = "event,time_s,force_n,capacitance_pf\n";
    let text = format!(
        "{head}{}# a remark, of 2 cells\n{}{}",
        rows(0, 249, "hold,"),
        rows(250, 255, "#touch,"),
        rows(256, 299, "hold,")
    );
    let read = read(&text).unwrap();
    let told = Note::MarkedRows { lines: 6, first_line: 253, taken: true };
    assert!(read.len() == 300 && read.notes.contains(&told), "{} {:?}", read.len(), read.notes);
}

#[test]
fn a_quote_in_a_remark_holds_no_rows() {
    let text = format!("time_s,force_n,capacitance_pf\n{}# see,\"the drawing\n{}", rows(0, 9, ""), rows(10, 19, ""));
    assert_eq!(read(&text).unwrap().len(), 20);
}

/// Rows of a mean, a deviation and a sum were data.
#[test]
fn rows_that_sum_up_others_are_left_out_and_told() {
    let table = |label: &dyn Fn(usize) -> String, end: &str| {
        let rows: String = (0..40).map(|k| format!("{},{},{}\n", label(k), k % 7, 74 + k % 7)).collect();
        read(&format!("sample,force_n,capacitance_pf\n{rows}{end}"))
    };
    let (end, one) = ("Mean,2.9,76.9\nStd. Dev.,2.0,2.0\nSum,116,3076\n", "Max,6,80\n");
    let told = |lines: &[usize]| {
        let words = if lines.len() == 1 { "`Max`" } else { "`Mean`, `Std. Dev.`, `Sum`" };
        Note::Summaries { rows: lines.len(), words: words.into(), lines: lines.to_vec() }
    };
    let (numbers, nothing): (&dyn Fn(usize) -> String, &dyn Fn(usize) -> String) = (&|k| k.to_string(), &|_| String::new());
    let words: &dyn Fn(usize) -> String = &|k| if k % 9 == 3 { "Max".into() } else { "hold".into() };
    let hold: &dyn Fn(usize) -> String = &|_| "hold".into();
    for (label, end, rows, lines) in [
        (numbers, end, 40, &[42, 43, 44][..]),
        (numbers, one, 40, &[42]),
        (nothing, end, 40, &[42, 43, 44]),
        (nothing, one, 40, &[42]),
        (hold, end, 40, &[42, 43, 44]),
        (hold, one, 41, &[]),
        (words, one, 41, &[]),
    ] {
        let read = table(label, end).unwrap();
        let found: Vec<&Note> = read.notes.iter().filter(|note| matches!(note, Note::Summaries { .. })).collect();
        let wanted = told(lines);
        assert_eq!((read.len(), found), (rows, if lines.is_empty() { vec![] } else { vec![&wanted] }));
    }
    let of_a_clock = format!("time_s,force_n,capacitance_pf\n{}Mean,3,76\n{}", rows(0, 9, ""), rows(10, 19, ""));
    assert_eq!(read(&of_a_clock).unwrap().len(), 20);
}
