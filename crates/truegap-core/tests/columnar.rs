//! Files that hold a frame: read as the CSV of the same numbers, and refused where this build does not read them.

#![allow(clippy::unwrap_used)]

#[cfg(not(feature = "columnar"))]
use truegap_core::Recording;

const PARQUET: &[u8] = include_bytes!("columnar/bench.parquet");

fn folder(name: &str) -> std::path::PathBuf {
    let folder = std::env::temp_dir().join(format!("truegap-columnar-{}-{name}", std::process::id()));
    std::fs::create_dir_all(&folder).unwrap();
    folder
}

#[cfg(not(feature = "columnar"))]
#[test]
fn a_build_that_reads_none_says_which_does() {
    let folder = folder("absent");
    std::fs::write(folder.join("bench.parquet"), PARQUET).unwrap();
    let told = Recording::open(folder.join("bench.parquet")).unwrap_err().to_string();
    assert!(told.contains("bench.parquet: it is a Parquet file") && told.contains("--features columnar"), "{told}");
    std::fs::remove_dir_all(&folder).unwrap();
}

#[cfg(feature = "columnar")]
mod read {
    use super::{PARQUET, folder};
    use truegap_core::recording::{Told, sketch};
    use truegap_core::{Note, Recording};

    const ARROW: &[u8] = include_bytes!("columnar/bench.arrow");
    const CSV: &str = include_str!("columnar/bench.csv");

    /// The files were written by `columnar/write.py`, with pyarrow and polars.
    #[test]
    fn a_file_of_columns_is_read_as_the_csv_of_its_numbers() {
        let folder = folder("same");
        std::fs::write(folder.join("bench.csv"), CSV).unwrap();
        let csv = Recording::open(folder.join("bench.csv")).unwrap();
        assert!(csv.len() == 4 && csv.inputs.time_s.as_ref().unwrap()[1] == 0.75, "{csv:?}");
        for (name, bytes) in [("bench.parquet", PARQUET), ("bench.arrow", ARROW), ("called.csv", PARQUET)] {
            std::fs::write(folder.join(name), bytes).unwrap();
            let read = Recording::open(folder.join(name)).unwrap();
            assert_eq!((&read.inputs, &read.response, &read.columns), (&csv.inputs, &csv.response, &csv.columns), "{name}");
            assert!(read.notes.iter().any(|note| matches!(note, Note::Dates { .. })), "{:?}", read.notes);
            assert!(read.notes.iter().any(|note| matches!(note, Note::RowsWithoutValue { rows: 1, .. })), "{:?}", read.notes);
            // text among them, as of the CSV
            for notes in [&read.notes, &csv.notes] {
                assert!(notes.contains(&Note::NotRead { columns: "`fan`, `who`".into() }), "{notes:?}");
            }
        }
        let toml =
            "schema = \"truegap.recording/1\"\nfile = \"bench.arrow\"\n[drivers]\nfan = { column = \"fan\", unit = \"1\" }\n";
        std::fs::write(folder.join("bench.toml"), toml).unwrap();
        let read = Recording::open(folder.join("bench.toml")).unwrap();
        assert_eq!(
            (read.inputs.drivers[0].values.as_slice(), read.path.file_name().unwrap()),
            (&[1.0, 2.0, 4.0, 5.0][..], "bench.toml".as_ref())
        );
        // a TOML says which column is what
        assert!(read.notes.iter().all(|note| !matches!(note, Note::NotRead { .. })), "{:?}", read.notes);
        std::fs::remove_dir_all(&folder).unwrap();
    }

    /// Dates as text were left out, and with them the clock.
    #[test]
    fn dates_as_text_are_a_clock_as_in_a_csv() {
        use arrow_array::types::Int32Type;
        use arrow_array::{ArrayRef, DictionaryArray, Float64Array, LargeStringArray, RecordBatch, StringArray, StringViewArray};
        use std::sync::Arc;
        let folder = folder("text");
        let file = folder.join("t.arrow");
        let write = |name: &str, times: ArrayRef| {
            let who: ArrayRef = Arc::new(StringArray::from(vec!["a", "b", "c"]));
            let reading: ArrayRef = Arc::new(Float64Array::from(vec![1.0, 2.0, 3.0]));
            let batch = RecordBatch::try_from_iter([("who", who), (name, times), ("response_mv", reading)]).unwrap();
            let mut writer =
                arrow_ipc::writer::FileWriter::try_new(std::fs::File::create(&file).unwrap(), &batch.schema()).unwrap();
            writer.write(&batch).unwrap();
            writer.finish().unwrap();
        };
        let texts = vec!["2026-03-01 12:00:00", "2026-03-01 12:00:01.5", "2026-03-01 12:00:03"];
        let kinds: [ArrayRef; 4] = [
            Arc::new(StringArray::from(texts.clone())),
            Arc::new(LargeStringArray::from(texts.clone())),
            Arc::new(StringViewArray::from(texts.clone())),
            Arc::new(texts.into_iter().collect::<DictionaryArray<Int32Type>>()),
        ];
        for (name, times) in ["time", "Timestamp", "logged", "datetime"].into_iter().zip(kinds) {
            write(name, times);
            assert_eq!(Recording::open(&file).unwrap().inputs.time_s, Some(vec![0.0, 1.5, 3.0]), "{name}");
            let sketch = sketch(&file, &Told::default()).unwrap();
            assert!(sketch.toml.contains(&format!("time = \"{name}\"")), "{}", sketch.toml);
        }
        write("time", Arc::new(StringArray::from(vec!["01/03/2026 12:00", "02/03/2026 12:00", "03/03/2026 12:00"])));
        let asked = Recording::open(&file).unwrap_err().to_string();
        assert!(asked.contains("`01/03/2026 12:00` in column `time`") && asked.contains("--dayfirst"), "{asked}");
        let told = Told { dayfirst: Some(true), ..Told::default() };
        assert_eq!(Recording::open_told(&file, &told).unwrap().inputs.time_s.unwrap()[2], 2.0 * 86_400.0);
        let sketch = sketch(&file, &Told::default()).unwrap();
        assert!(sketch.toml.contains("# dayfirst = true") && sketch.open[0].contains("01/03/2026"), "{:?}", sketch);
        // what is no clock may be anything
        write("note", Arc::new(StringArray::from(vec!["2026-03-01", "twice", "thrice"])));
        assert_eq!(Recording::open(&file).unwrap().inputs.time_s, None);
        std::fs::remove_dir_all(&folder).unwrap();
    }

    /// As [`Told::inputs_alone`] says of a CSV.
    #[test]
    fn what_was_done_needs_no_response() {
        use arrow_array::{ArrayRef, Float64Array, RecordBatch};
        use std::sync::Arc;
        let folder = folder("alone");
        let file = folder.join("t.arrow");
        let column = |values: [f64; 3]| -> ArrayRef { Arc::new(Float64Array::from(values.to_vec())) };
        let (times, forces, others) = (column([0.0, 1.0, 2.0]), column([3.0, f64::NAN, 5.0]), column([7.0; 3]));
        let batch = RecordBatch::try_from_iter([("time_s", times), ("force_n", forces), ("c_total_pf", others)]).unwrap();
        let mut writer = arrow_ipc::writer::FileWriter::try_new(std::fs::File::create(&file).unwrap(), &batch.schema()).unwrap();
        writer.write(&batch).unwrap();
        writer.finish().unwrap();
        assert!(Recording::open(&file).unwrap_err().to_string().contains("no column for response"));
        let told = |map: &[&str]| Told {
            map: map.iter().map(|text| text.parse().unwrap()).collect(),
            inputs_alone: true,
            ..Told::default()
        };
        let read = Recording::open_told(&file, &told(&[])).unwrap();
        assert_eq!((read.len(), read.response.len(), read.inputs.force_n.as_deref()), (2, 0, Some(&[3.0, 5.0][..])));
        let named = Recording::open_told(&file, &told(&["response=c_pf"])).unwrap_err().to_string();
        assert!(named.contains("no column for response: `c_pf`"), "{named}");
        std::fs::remove_dir_all(&folder).unwrap();
    }

    #[test]
    fn a_column_of_text_and_a_damaged_file_are_told() {
        let folder = folder("broken");
        let parquet = folder.join("bench.parquet");
        std::fs::write(&parquet, PARQUET).unwrap();
        let told = Told { map: vec!["response=who:mV".parse().unwrap()], ..Told::default() };
        let refused = Recording::open_told(&parquet, &told).unwrap_err().to_string();
        assert!(refused.contains("column `who` holds neither numbers nor dates but"), "{refused}");
        let sketch = sketch(&parquet, &Told::default()).unwrap();
        assert!(sketch.toml.contains("file = \"bench.parquet\"") && sketch.toml.contains("time = \"time\""), "{}", sketch.toml);
        for length in [6, 40, PARQUET.len() - 5] {
            std::fs::write(&parquet, &PARQUET[..length]).unwrap();
            let refused = Recording::open(&parquet).unwrap_err().to_string();
            assert!(refused.contains("bench.parquet: cannot be read as a Parquet file"), "{refused}");
        }
        std::fs::remove_dir_all(&folder).unwrap();
    }
}
