//! Columns of Arrow's types as columns of 64-bit floats.
//!
//! Limits: whole columns in memory; an integer beyond 2^53 is rounded.

use super::kind::Kind;
use super::of_file::{Frame, Texts};
use crate::recording::date_text::first_text;
use crate::recording::error::RecordingError;
use crate::recording::frame::{Cells, FrameColumn};
use crate::recording::packed::unread;
use crate::recording::stamp::{is_date, iso};
use crate::recording::table::hexadecimal;
use arrow_array::cast::AsArray;
use arrow_array::types::{
    ArrowPrimitiveType, Date32Type, Date64Type, Decimal128Type, DurationMicrosecondType, DurationMillisecondType,
    DurationNanosecondType, DurationSecondType, Float16Type, Float32Type, Float64Type, Int8Type, Int16Type, Int32Type, Int64Type,
    TimestampMicrosecondType, TimestampMillisecondType, TimestampNanosecondType, TimestampSecondType, UInt8Type, UInt16Type,
    UInt32Type, UInt64Type,
};
use arrow_array::{Array, RecordBatch};
use arrow_ipc::reader::FileReader;
use arrow_schema::{ArrowError, DataType, SchemaRef, TimeUnit};
use parquet::arrow::arrow_reader::ParquetRecordBatchReaderBuilder;
use sha2::{Digest, Sha256};
use std::borrow::Cow;
use std::fs::File;
use std::io::{self, BufReader, Read as _, Seek, SeekFrom};
use std::path::Path;
use truegap_limits::Need;

/// Memory of a value: as it is decoded, and as a number of the recording.
const BYTES_OF_A_VALUE: f64 = 24.0;
/// How much longer the values of a packed file may be than the file.
const UNPACKED: f64 = 6.0;

/// The frame in a file, with the hash of its bytes.
pub(super) fn of_kind(path: &Path, mut file: File, kind: Kind) -> Result<Frame, RecordingError> {
    let hash = sha256(&mut file).map_err(|source| unread(path, source))?;
    Ok(Frame { sha256: hexadecimal(hash), ..columns(path, file, kind)? })
}

fn sha256(file: &mut File) -> io::Result<Sha256> {
    let (mut hash, mut chunk) = (Sha256::new(), vec![0; 1 << 16]);
    loop {
        let read = file.read(&mut chunk)?;
        if read == 0 {
            file.seek(SeekFrom::Start(0))?;
            return Ok(hash);
        }
        hash.update(&chunk[..read]);
    }
}

/// Reads all columns of a file.
fn columns(path: &Path, file: File, kind: Kind) -> Result<Frame, RecordingError> {
    let damaged = |says: String| RecordingError::Columnar { file: path.to_owned(), kind: kind.told(), says };
    match kind {
        Kind::Parquet => {
            let builder = ParquetRecordBatchReaderBuilder::try_new(file).map_err(|e| damaged(e.to_string()))?;
            let rows = builder.metadata().file_metadata().num_rows() as f64;
            let schema = builder.schema().clone();
            check(path, BYTES_OF_A_VALUE * rows * schema.fields().len() as f64)?;
            let reader = builder.build().map_err(|e| damaged(e.to_string()))?;
            gathered(&schema, reader).map_err(|e| damaged(e.to_string()))
        }
        Kind::Arrow => {
            let bytes = file.metadata().map_or(0.0, |data| data.len() as f64);
            check(path, UNPACKED * bytes)?;
            let reader = FileReader::try_new(BufReader::new(file), None).map_err(|e| damaged(e.to_string()))?;
            gathered(&reader.schema(), reader).map_err(|e| damaged(e.to_string()))
        }
    }
}

fn check(path: &Path, bytes: f64) -> Result<(), RecordingError> {
    let (place, remedy) = (path.display().to_string(), "record more slowly, or split it into several recordings");
    Ok(truegap_limits::check(Need { place: &place, asked: "a table of columns", bytes, remedy })?)
}

fn gathered(schema: &SchemaRef, batches: impl Iterator<Item = Result<RecordBatch, ArrowError>>) -> Result<Frame, ArrowError> {
    let mut cells: Vec<Option<Gathered>> = schema.fields().iter().map(|field| Gathered::of(field.data_type())).collect();
    for batch in batches {
        let batch = batch?;
        let filled = cells.iter_mut().zip(batch.columns()).filter_map(|(cells, array)| Some((cells.as_mut()?, array)));
        filled.for_each(|(cells, array)| cells.extend(array));
    }
    let mut frame = Frame { columns: Vec::new(), texts: Vec::new(), left_out: Vec::new(), sha256: String::new() };
    for (field, cells) in schema.fields().iter().zip(cells) {
        let (name, at) = (field.name().clone(), frame.columns.len() + frame.texts.len());
        match cells {
            Some(Gathered::Texts(Some(cells))) => frame.texts.push(Texts { name, at, cells }),
            None | Some(Gathered::Texts(None)) => frame.left_out.push((name, field.data_type().to_string())),
            Some(cells) => frame.columns.extend(cells.column(name)),
        }
    }
    Ok(frame)
}

/// Cells of one column so far.
enum Gathered {
    Numbers(Vec<f64>),
    Durations(Vec<f64>),
    /// while they may be dates
    Texts(Option<Vec<Option<String>>>),
    /// ticks since 1970, so many a second, and whether they are those of Greenwich
    Dates {
        ticks: Vec<Option<i64>>,
        a_second: i64,
        zoned: bool,
    },
}

impl Gathered {
    /// Nothing yet of a type; `None` where it is no number and no time.
    fn of(kind: &DataType) -> Option<Self> {
        use DataType as T;
        let dates = |a_second, zoned| Some(Self::Dates { ticks: Vec::new(), a_second, zoned });
        match kind {
            T::Null | T::Boolean | T::Decimal128(..) => Some(Self::Numbers(Vec::new())),
            kind if kind.is_integer() || kind.is_floating() => Some(Self::Numbers(Vec::new())),
            T::Duration(_) => Some(Self::Durations(Vec::new())),
            T::Dictionary(_, kind) if kind.is_string() => Some(Self::Texts(Some(Vec::new()))),
            kind if kind.is_string() => Some(Self::Texts(Some(Vec::new()))),
            T::Timestamp(unit, zone) => dates(ticks_a_second(*unit), zone.is_some()),
            T::Date32 => dates(1, false),
            T::Date64 => dates(1000, false),
            _ => None,
        }
    }

    fn extend(&mut self, array: &dyn Array) {
        match self {
            Self::Numbers(values) => values.extend(numbers(array)),
            Self::Durations(values) => values.extend(durations(array)),
            Self::Texts(cells) => {
                cells.iter_mut().for_each(|cells| cells.extend(texts(array)));
                let first = cells.as_ref().and_then(|cells| first_text(cells.iter().flatten().map(String::as_str)));
                if first.is_some_and(|first| !is_date(first.as_bytes())) {
                    *cells = None;
                }
            }
            Self::Dates { ticks, .. } => ticks.extend(dates(array)),
        }
    }

    fn column(self, name: String) -> Option<FrameColumn<'static>> {
        let (values, cells) = match self {
            Self::Texts(_) => return None,
            Self::Numbers(values) => (values, Cells::Numbers),
            Self::Durations(values) => (values, Cells::Durations),
            Self::Dates { ticks, a_second, zoned } => since_first(&ticks, a_second, zoned),
        };
        Some(FrameColumn { name, values: Cow::Owned(values), cells })
    }
}

/// Texts as they stand.
fn texts(array: &dyn Array) -> Vec<Option<String>> {
    fn owned<'a>(texts: impl Iterator<Item = Option<&'a str>>) -> Vec<Option<String>> {
        texts.map(|text| text.map(str::to_owned)).collect()
    }
    match array.data_type() {
        DataType::LargeUtf8 => owned(array.as_string::<i64>().iter()),
        DataType::Utf8View => owned(array.as_string_view().iter()),
        DataType::Dictionary(..) => {
            let array = array.as_any_dictionary();
            let (values, keys) = (texts(array.values()), array.normalized_keys());
            let text = |(row, key): (usize, &usize)| values.get(*key).filter(|_| array.keys().is_valid(row)).cloned().flatten();
            keys.iter().enumerate().map(text).collect()
        }
        _ => owned(array.as_string::<i32>().iter()),
    }
}

/// Seconds since the whole second of the first date, as a CSV of the same dates gives them.
fn since_first(ticks: &[Option<i64>], a_second: i64, zoned: bool) -> (Vec<f64>, Cells) {
    let first = ticks.iter().flatten().next().copied().unwrap_or(0);
    let epoch = first.div_euclid(a_second);
    let seconds = |tick: i64| (tick.div_euclid(a_second) - epoch) as f64 + tick.rem_euclid(a_second) as f64 / a_second as f64;
    let values = ticks.iter().map(|tick| tick.map_or(f64::NAN, seconds)).collect();
    let text = iso(epoch, first.rem_euclid(a_second) * (1_000_000_000 / a_second));
    (values, Cells::Dates { first: format!("{text}{}", if zoned { "Z" } else { "" }) })
}

fn ticks_a_second(unit: TimeUnit) -> i64 {
    match unit {
        TimeUnit::Second => 1,
        TimeUnit::Millisecond => 1000,
        TimeUnit::Microsecond => 1_000_000,
        TimeUnit::Nanosecond => 1_000_000_000,
    }
}

/// Values of one of Arrow's types.
fn of<'a, T: ArrowPrimitiveType>(array: &'a dyn Array) -> impl Iterator<Item = Option<T::Native>> + 'a {
    array.as_primitive::<T>().iter()
}

fn numbers(array: &dyn Array) -> Vec<f64> {
    fn read<T: ArrowPrimitiveType>(array: &dyn Array, number: impl Fn(T::Native) -> f64) -> Vec<f64> {
        of::<T>(array).map(|value| value.map_or(f64::NAN, &number)).collect()
    }
    use DataType as D;
    match array.data_type() {
        D::Int8 => read::<Int8Type>(array, f64::from),
        D::Int16 => read::<Int16Type>(array, f64::from),
        D::Int32 => read::<Int32Type>(array, f64::from),
        D::Int64 => read::<Int64Type>(array, |value| value as f64),
        D::UInt8 => read::<UInt8Type>(array, f64::from),
        D::UInt16 => read::<UInt16Type>(array, f64::from),
        D::UInt32 => read::<UInt32Type>(array, f64::from),
        D::UInt64 => read::<UInt64Type>(array, |value| value as f64),
        D::Float16 => read::<Float16Type>(array, f64::from),
        D::Float32 => read::<Float32Type>(array, f64::from),
        D::Float64 => read::<Float64Type>(array, |value| value),
        D::Decimal128(_, scale) => {
            let one = 10f64.powi(i32::from(*scale));
            read::<Decimal128Type>(array, |value| value as f64 / one)
        }
        D::Boolean => array.as_boolean().iter().map(|value| value.map_or(f64::NAN, f64::from)).collect(),
        _ => vec![f64::NAN; array.len()],
    }
}

fn durations(array: &dyn Array) -> Vec<f64> {
    let (ticks, a_second): (Vec<Option<i64>>, i64) = match array.data_type() {
        DataType::Duration(TimeUnit::Second) => (of::<DurationSecondType>(array).collect(), 1),
        DataType::Duration(TimeUnit::Millisecond) => (of::<DurationMillisecondType>(array).collect(), 1000),
        DataType::Duration(TimeUnit::Microsecond) => (of::<DurationMicrosecondType>(array).collect(), 1_000_000),
        _ => (of::<DurationNanosecondType>(array).collect(), 1_000_000_000),
    };
    ticks.into_iter().map(|tick| tick.map_or(f64::NAN, |tick| tick as f64 / a_second as f64)).collect()
}

/// Ticks since 1970; whole days as seconds.
fn dates(array: &dyn Array) -> Vec<Option<i64>> {
    match array.data_type() {
        DataType::Timestamp(TimeUnit::Second, _) => of::<TimestampSecondType>(array).collect(),
        DataType::Timestamp(TimeUnit::Millisecond, _) => of::<TimestampMillisecondType>(array).collect(),
        DataType::Timestamp(TimeUnit::Microsecond, _) => of::<TimestampMicrosecondType>(array).collect(),
        DataType::Timestamp(TimeUnit::Nanosecond, _) => of::<TimestampNanosecondType>(array).collect(),
        DataType::Date32 => of::<Date32Type>(array).map(|day| day.map(|day| 86_400 * i64::from(day))).collect(),
        _ => of::<Date64Type>(array).collect(),
    }
}
