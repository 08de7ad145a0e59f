//! Where the bytes of a CSV come from: a file, a file packed by gzip, or standard input (`-`, `/dev/stdin`).
//!
//! Limits: what is packed or comes through a pipe is held in memory, since a CSV is read from its beginning more than once; a packed file is known by its first
//! bytes, whatever it is called.

use super::{columnar::kind::Kind, error::RecordingError};
use flate2::read::MultiGzDecoder;
use std::fs::File;
use std::io::{self, Cursor, ErrorKind, Read, Seek, SeekFrom};
use std::path::Path;
use truegap_limits::Need;

/// Names of standard input.
const STANDARD_INPUT: [&str; 2] = ["-", "/dev/stdin"];
/// How a gzip file begins.
const GZIP: [u8; 2] = [0x1f, 0x8b];
/// Memory that a CSV takes while it is read, over its length: columns of numbers of 8 bytes that double as they grow, from cells of seven characters.
const MEMORY_OF_A_BYTE: f64 = 4.0;
/// Bytes after which the memory is looked at again.
const CHUNK: u64 = 1 << 24;

/// Bytes that can be read again.
pub(in crate::recording) trait Bytes: Read + Seek {}
impl<T: Read + Seek> Bytes for T {}

/// Whether a path stands for standard input.
pub fn is_standard_input(path: &Path) -> bool {
    STANDARD_INPUT.iter().any(|name| path == Path::new(name))
}

/// Opens a CSV that can be read within the memory there is.
pub(in crate::recording) fn open_csv(path: &Path) -> Result<Box<dyn Bytes>, RecordingError> {
    if is_standard_input(path) {
        return plain_or_packed(path, io::stdin().lock());
    }
    let mut file = truegap_limits::open(path).map_err(|source| unread(path, source))?;
    if begins_as_gzip(&mut file).map_err(|source| unread(path, source))? {
        return Ok(Box::new(held(path, MultiGzDecoder::new(file), MEMORY_OF_A_BYTE + 1.0)?));
    }
    let bytes = file.metadata().map_err(|source| unread(path, source))?.len();
    check(path, bytes, MEMORY_OF_A_BYTE)?;
    Ok(Box::new(file))
}

pub(in crate::recording) fn unread(path: &Path, source: io::Error) -> RecordingError {
    match source.kind() {
        ErrorKind::NotFound => RecordingError::NotFound { file: path.to_owned() },
        _ => RecordingError::Read { file: path.to_owned(), source },
    }
}

/// A stream as it stands, or unpacked.
fn plain_or_packed(path: &Path, stream: impl Read) -> Result<Box<dyn Bytes>, RecordingError> {
    let bytes = held(path, stream, MEMORY_OF_A_BYTE + 1.0)?;
    if let Some(kind) = Kind::of(bytes.get_ref()) {
        return Err(RecordingError::ColumnarStream { file: path.to_owned(), kind: kind.told() });
    }
    match bytes.get_ref().starts_with(&GZIP) {
        true => Ok(Box::new(held(path, MultiGzDecoder::new(bytes), MEMORY_OF_A_BYTE + 1.0)?)),
        false => Ok(Box::new(bytes)),
    }
}

fn begins_as_gzip(file: &mut File) -> io::Result<bool> {
    let mut first = Vec::new();
    file.by_ref().take(GZIP.len() as u64).read_to_end(&mut first)?;
    file.seek(SeekFrom::Start(0))?;
    Ok(first == GZIP)
}

/// The whole stream in memory; little can unpack to much, so it is measured while it grows.
fn held(path: &Path, mut stream: impl Read, memory_of_a_byte: f64) -> Result<Cursor<Vec<u8>>, RecordingError> {
    let mut bytes = Vec::new();
    while stream.by_ref().take(CHUNK).read_to_end(&mut bytes).map_err(|source| unread(path, source))? > 0 {
        check(path, bytes.len() as u64, memory_of_a_byte)?;
    }
    Ok(Cursor::new(bytes))
}

fn check(path: &Path, bytes: u64, memory_of_a_byte: f64) -> Result<(), RecordingError> {
    let bytes = bytes as f64;
    let (place, asked) = (path.display().to_string(), format!("a table of {:.0} MB", 1e-6 * bytes));
    let remedy = "record more slowly, or split it into several recordings";
    Ok(truegap_limits::check(Need { place: &place, asked: &asked, bytes: memory_of_a_byte * bytes, remedy })?)
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::Recording;
    use flate2::{Compression, write::GzEncoder};
    use std::io::Write;

    const CSV: &str = "time_s,simulated,response_mm\n0,1.0,1.1\n1,2.0,2.1\n2,3.0,3.0\n";

    fn packed(text: &[u8]) -> Vec<u8> {
        let mut encoder = GzEncoder::new(Vec::new(), Compression::default());
        encoder.write_all(text).unwrap();
        encoder.finish().unwrap()
    }

    fn folder(name: &str) -> std::path::PathBuf {
        let folder = std::env::temp_dir().join(format!("truegap-packed-{}-{name}", std::process::id()));
        std::fs::create_dir_all(&folder).unwrap();
        folder
    }

    #[test]
    fn a_packed_csv_is_the_csv_whatever_it_is_called() {
        let folder = folder("same");
        std::fs::write(folder.join("plain.csv"), CSV).unwrap();
        let plain = Recording::open(folder.join("plain.csv")).unwrap();
        for name in ["a.csv.gz", "b.csv"] {
            std::fs::write(folder.join(name), packed(CSV.as_bytes())).unwrap();
            let read = Recording::open(folder.join(name)).unwrap();
            assert_eq!((&read.inputs, &read.response, &read.sha256), (&plain.inputs, &plain.response, &plain.sha256));
        }
        let toml = "schema = \"truegap.recording/1\"\nfile = \"a.csv.gz\"\n";
        std::fs::write(folder.join("a.toml"), toml).unwrap();
        assert_eq!(Recording::open(folder.join("a.toml")).unwrap().response, plain.response);
        std::fs::remove_dir_all(&folder).unwrap();
    }

    #[test]
    fn a_packed_csv_that_is_cut_is_told_with_its_file() {
        let folder = folder("cut");
        let whole = packed(CSV.as_bytes());
        std::fs::write(folder.join("cut.csv.gz"), &whole[..whole.len() - 6]).unwrap();
        let told = Recording::open(folder.join("cut.csv.gz")).unwrap_err().to_string();
        assert!(told.contains("cut.csv.gz") && told.contains("cannot be read"), "{told}");
        std::fs::remove_dir_all(&folder).unwrap();
    }

    #[test]
    fn a_frame_on_standard_input_is_told_by_its_kind() {
        for (first, kind) in [("PAR1", "a Parquet file"), ("ARROW1", "an Arrow file")] {
            let told =
                plain_or_packed(Path::new("-"), Cursor::new(first)).err().map(|error| error.to_string()).unwrap_or_default();
            assert!(told.contains(kind) && told.contains("write it to a file"), "{told}");
        }
    }

    #[test]
    fn a_stream_is_read_packed_or_not() {
        for bytes in [CSV.as_bytes().to_vec(), packed(CSV.as_bytes())] {
            let mut text = String::new();
            plain_or_packed(Path::new("-"), Cursor::new(bytes)).unwrap().read_to_string(&mut text).unwrap();
            assert_eq!(text, CSV);
        }
    }
}
