//! Answers of a program on disk, so that a second diagnosis of a slow simulator asks for what is new only.
//!
//! One folder for all programs; each process appends what is new to a file of its own, `PROGRAM.PROCESS.answers`, so that none waits for another. An answer is its key (128 bits of what was asked),
//! the number of its values, and the values, in the order of bytes of the smallest machines.
//!
//! Limits: [`MOST_BYTES`] in all; beyond three quarters of it the files that were used longest ago go when a program is opened. What cannot be read or written costs time and no answer.

use std::collections::HashMap;
use std::fs::{self, File};
use std::io::{self, BufReader, Read, Seek, SeekFrom, Write};
use std::path::{Path, PathBuf};
use std::time::SystemTime;

/// Most bytes of all answers: 1 GB.
const MOST_BYTES: u64 = 1 << 30;
/// Most values of an answer; a number beyond is no answer but a damaged file.
const MOST_VALUES: u64 = 1 << 28;
/// Bytes before the values.
const HEAD: u64 = 24;

/// What was asked, 128 bits.
pub(super) type Key = [u64; 2];

/// Where an answer stands.
#[derive(Clone, Copy, Debug)]
struct Place {
    file: usize,
    first_byte: u64,
    values: u64,
}

/// The answers of one program.
pub(super) struct Kept {
    /// file of what is new, made with the first of it
    own: PathBuf,
    writes: Option<File>,
    /// bytes that may still be written
    room: u64,
    reads: Vec<File>,
    places: HashMap<Key, Place>,
}

impl Kept {
    /// The answers in `folder` of the program with this identity.
    pub fn open(folder: &Path, program: &str) -> Self {
        Self::within(folder, program, MOST_BYTES)
    }

    fn within(folder: &Path, program: &str, most: u64) -> Self {
        let there = make_room(folder, most / 4 * 3);
        let started = SystemTime::UNIX_EPOCH.elapsed().map_or(0, |since| since.as_nanos());
        let own = folder.join(format!("{program}.{}-{started}.answers", std::process::id()));
        let mut kept = Self { own, writes: None, room: most.saturating_sub(there), reads: Vec::new(), places: HashMap::new() };
        for (file, _, _) in files(folder) {
            let is_of_program = file.file_name().is_some_and(|name| name.to_string_lossy().starts_with(&format!("{program}.")));
            if is_of_program {
                let _ = kept.read(&file); // what is damaged is asked for again
            }
        }
        kept
    }

    /// Finds the answers of a file.
    fn read(&mut self, path: &Path) -> io::Result<()> {
        let file = File::options().read(true).append(true).open(path)?;
        let _ = file.set_modified(SystemTime::now()); // only its age suffers
        let length = file.metadata()?.len();
        let (index, mut reader) = (self.reads.len(), BufReader::new(file.try_clone()?));
        self.reads.push(file);
        let mut first_byte = HEAD;
        while first_byte <= length {
            let [a, b, values] = [number(&mut reader)?, number(&mut reader)?, number(&mut reader)?];
            let next = first_byte.saturating_add(8 * values.min(MOST_VALUES));
            if values > MOST_VALUES || next > length {
                break; // the process was ended while it wrote
            }
            self.places.insert([a, b], Place { file: index, first_byte, values });
            reader.seek_relative(8 * values as i64)?;
            first_byte = next + HEAD;
        }
        Ok(())
    }

    /// An answer of so many values.
    pub fn get(&mut self, key: Key, values: usize) -> Option<Vec<f64>> {
        let place = self.places.get(&key).copied().filter(|place| place.values == values as u64)?;
        let file = self.reads.get_mut(place.file)?;
        let mut bytes = vec![0; 8 * values];
        file.seek(SeekFrom::Start(place.first_byte)).and_then(|_| file.read_exact(&mut bytes)).ok()?;
        let value = |bytes: &[u8]| f64::from_bits(bytes.iter().rev().fold(0, |bits, byte| bits << 8 | u64::from(*byte)));
        Some(bytes.chunks_exact(8).map(value).collect())
    }

    /// Keeps an answer, where there is room for it.
    pub fn put(&mut self, key: Key, answer: &[f64]) {
        let bytes = HEAD + 8 * answer.len() as u64;
        if bytes <= self.room && self.append(key, answer).is_ok() {
            self.room -= bytes;
        } else {
            self.room = 0; // half of an answer may stand at the end of the file
        }
    }

    fn append(&mut self, key: Key, answer: &[f64]) -> io::Result<()> {
        if self.writes.is_none() {
            self.own.parent().map_or(Ok(()), fs::create_dir_all)?;
            self.writes = Some(File::options().append(true).create(true).open(&self.own)?);
        }
        let head = [key[0], key[1], answer.len() as u64];
        let words = head.into_iter().chain(answer.iter().map(|value| value.to_bits()));
        let bytes: Vec<u8> = words.flat_map(u64::to_le_bytes).collect();
        self.writes.as_mut().map_or(Ok(()), |file| file.write_all(&bytes))
    }
}

fn number(reader: &mut impl Read) -> io::Result<u64> {
    let mut bytes = [0; 8];
    reader.read_exact(&mut bytes)?;
    Ok(u64::from_le_bytes(bytes))
}

/// Files of answers with their length and when they were used last, those first that were used longest ago.
fn files(folder: &Path) -> Vec<(PathBuf, u64, SystemTime)> {
    let entries = fs::read_dir(folder).into_iter().flatten().filter_map(|entry| entry.ok().map(|entry| entry.path()));
    let answers = entries.filter(|path| path.extension().is_some_and(|ending| ending == "answers"));
    let of = |path: PathBuf| {
        let data = fs::metadata(&path).ok()?;
        Some((path, data.len(), data.modified().ok()?))
    };
    let mut files: Vec<_> = answers.filter_map(of).collect();
    files.sort_by_key(|(_, _, used)| *used);
    files
}

/// Removes what was used longest ago until no more than `most` bytes are left, and says how many are.
fn make_room(folder: &Path, most: u64) -> u64 {
    let files = files(folder);
    let mut there: u64 = files.iter().map(|(_, bytes, _)| bytes).sum();
    for (path, bytes, _) in files {
        if there <= most {
            break;
        }
        there -= if fs::remove_file(path).is_ok() { bytes } else { 0 };
    }
    there
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn what_one_process_keeps_another_finds() {
        let folder = tempfile::tempdir().unwrap();
        let answers = folder.path().join("answers");
        let mut first = Kept::open(&answers, "abc");
        assert!(!answers.exists() && first.get([1, 2], 3).is_none());
        first.put([1, 2], &[0.1, f64::NAN, -3e300]);
        first.put([3, 4], &[7.0]);
        let mut second = Kept::open(&answers, "abc");
        let found = second.get([1, 2], 3).unwrap();
        assert!(found[0] == 0.1 && found[1].is_nan() && found[2] == -3e300);
        assert_eq!((second.get([3, 4], 1), second.get([3, 4], 2), second.get([5, 6], 1)), (Some(vec![7.0]), None, None));
        second.put([5, 6], &[8.0]);
        assert_eq!(Kept::open(&answers, "abc").get([5, 6], 1), Some(vec![8.0]));
        assert!(Kept::open(&answers, "ab").get([3, 4], 1).is_none());
    }

    /// A process that is ended while it writes leaves half of an answer at the end.
    #[test]
    fn a_damaged_file_gives_what_is_whole() {
        let folder = tempfile::tempdir().unwrap();
        let mut kept = Kept::open(folder.path(), "abc");
        kept.put([1, 1], &[1.0, 2.0]);
        kept.put([2, 2], &[3.0, 4.0]);
        let bytes = fs::read(&kept.own).unwrap();
        for length in 0..bytes.len() {
            fs::write(&kept.own, &bytes[..length]).unwrap();
            let mut cut = Kept::open(folder.path(), "abc");
            let (one, two) = (cut.get([1, 1], 2), cut.get([2, 2], 2));
            assert!((one.is_some() == (length >= 40)) && two.is_none(), "{length}: {one:?} {two:?}");
        }
        fs::write(&kept.own, vec![0xff; 100]).unwrap();
        assert!(Kept::open(folder.path(), "abc").get([u64::MAX; 2], 1).is_none());
    }

    #[test]
    fn what_was_used_longest_ago_goes_first_and_nothing_is_written_beyond_the_bound() {
        let folder = tempfile::tempdir().unwrap();
        let answer = |program: &str, key: u64| {
            let mut kept = Kept::within(folder.path(), program, 400);
            kept.put([key, key], &[1.0; 10]);
        };
        answer("old", 1);
        answer("new", 2);
        std::thread::sleep(std::time::Duration::from_millis(20));
        assert!(Kept::within(folder.path(), "old", 400).get([1, 1], 10).is_some());
        answer("third", 3);
        // 312 bytes are more than three quarters: `new` goes, which nobody has used since
        assert!(Kept::within(folder.path(), "old", 400).get([1, 1], 10).is_some());
        assert!(Kept::within(folder.path(), "new", 400).get([2, 2], 10).is_none());
        let mut kept = Kept::within(folder.path(), "old", 400);
        (10..20).for_each(|key| kept.put([key, key], &[1.0; 10]));
        let all: u64 = files(folder.path()).iter().map(|(_, bytes, _)| bytes).sum();
        assert!(all <= 400, "{all}");
    }
}
