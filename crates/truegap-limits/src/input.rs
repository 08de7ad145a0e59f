//! Files that are given to be read: regular ones, and no larger than what they are for.
//!
//! Limits: a device or a pipe is refused, as it may have no end and cannot be read twice.

use std::fs::{File, Metadata};
use std::io::{self, Read};
use std::path::Path;

/// Largest file that is read as one text: a description, not data, bytes.
const LARGEST_TEXT: u64 = 64_000_000;

/// Opens a regular file; never waits for anybody.
///
/// # Errors
/// [`io::Error`] of the system, or one that says what stands there in place of a file.
pub fn open(path: &Path) -> io::Result<File> {
    // looked at before it is opened: to open a pipe is to wait for somebody who writes
    regular(&std::fs::metadata(path)?)?;
    File::open(path)
}

/// Text of a regular file that describes something: a sensor, a case, a model.
///
/// # Errors
/// As [`open`]; one that says how large the file is, or that it is no text.
pub fn read_text(path: &Path) -> io::Result<String> {
    let file = open(path)?;
    let bytes = file.metadata()?.len();
    if bytes > LARGEST_TEXT {
        return Err(too_long(bytes));
    }
    let mut text = String::new();
    // a file that grows while it is read ends here as well
    let read = file.take(LARGEST_TEXT + 1).read_to_string(&mut text).map_err(no_utf8)? as u64;
    if read > LARGEST_TEXT { Err(too_long(read)) } else { Ok(text) }
}

/// An editor may have saved it in the letters of its country.
fn no_utf8(error: io::Error) -> io::Error {
    match error.kind() {
        io::ErrorKind::InvalidData => io::Error::new(error.kind(), "it is no UTF-8 text; save it again with the encoding UTF-8"),
        _ => error,
    }
}

fn too_long(bytes: u64) -> io::Error {
    let (megabytes, most) = (bytes / 1_000_000, LARGEST_TEXT / 1_000_000);
    io::Error::other(format!("it is {megabytes} MB long, and a description has at most {most} MB; data belong into a CSV"))
}

fn regular(metadata: &Metadata) -> io::Result<()> {
    let kind = metadata.file_type();
    if kind.is_file() {
        return Ok(());
    }
    let what = if kind.is_dir() { "a folder" } else { other(kind) };
    Err(io::Error::other(format!("it is {what}, not a file; save what it holds to a file and give that")))
}

#[cfg(unix)]
fn other(kind: std::fs::FileType) -> &'static str {
    use std::os::unix::fs::FileTypeExt;
    if kind.is_fifo() {
        "a pipe"
    } else if kind.is_socket() {
        "a socket"
    } else {
        "a device"
    }
}

#[cfg(not(unix))]
fn other(_: std::fs::FileType) -> &'static str {
    "a device"
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_file_is_read_and_anything_else_is_named() {
        let folder = tempfile::tempdir().unwrap();
        let file = folder.path().join("a.toml");
        std::fs::write(&file, "x = 1").unwrap();
        assert_eq!(read_text(&file).unwrap(), "x = 1");
        assert!(read_text(folder.path()).unwrap_err().to_string().contains("a folder, not a file"));
        assert_eq!(read_text(&folder.path().join("b.toml")).unwrap_err().kind(), io::ErrorKind::NotFound);
    }

    #[test]
    fn a_text_in_other_letters_is_told_how_to_be_saved() {
        let folder = tempfile::tempdir().unwrap();
        let file = folder.path().join("a.toml");
        std::fs::write(&file, b"temperature = \"Temperatur [\xb0C]\"").unwrap();
        let told = read_text(&file).unwrap_err().to_string();
        assert!(told.contains("no UTF-8 text") && told.contains("save it again"), "{told}");
    }

    #[cfg(unix)]
    #[test]
    fn a_device_without_an_end_is_refused_at_once() {
        let told = read_text(Path::new("/dev/zero")).unwrap_err().to_string();
        assert!(told.contains("a device, not a file"), "{told}");
    }

    #[test]
    fn a_text_that_is_too_long_is_refused_unread() {
        let folder = tempfile::tempdir().unwrap();
        let file = folder.path().join("long.toml");
        // a hole: nothing is written
        File::create(&file).unwrap().set_len(LARGEST_TEXT + 1).unwrap();
        let told = read_text(&file).unwrap_err().to_string();
        assert!(told.contains("64 MB long") && told.contains("at most 64 MB"), "{told}");
    }
}
