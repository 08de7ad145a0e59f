//! A table on disk that is read as a user has it, and the rows that most tests write.

use std::sync::atomic::{AtomicUsize, Ordering};
use truegap_core::recording::{Told, sketch};
use truegap_core::{Recording, RecordingError};

/// A table in a folder of its own.
pub struct Bench(pub std::path::PathBuf);

impl Bench {
    pub fn new(name: &str, table: &[u8]) -> Self {
        // tests of one program run side by side, and two may choose the same name
        static NEXT: AtomicUsize = AtomicUsize::new(0);
        let place = NEXT.fetch_add(1, Ordering::Relaxed);
        let folder = std::env::temp_dir().join(format!("truegap-tables-{name}-{}-{place}", std::process::id()));
        std::fs::create_dir_all(&folder).unwrap();
        std::fs::write(folder.join("t.csv"), table).unwrap();
        Self(folder)
    }

    pub fn read(&self) -> Result<Recording, RecordingError> {
        Recording::open(self.0.join("t.csv"))
    }

    /// Reads the table with the TOML that is sketched of it.
    pub fn sketched(&self) -> Recording {
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

pub const ROWS: &str = "0,1,20,74\n0.5,2,21,75\n1,3,22,76\n";

/// Whether a table is read as [`ROWS`] in N, degC and pF.
pub fn is_those_rows(recording: &Recording, milli: f64) {
    let inputs = &recording.inputs;
    assert_eq!(inputs.time_s.as_deref(), Some(&[0.0, 0.5 * milli, milli][..]));
    assert_eq!(inputs.force_n.as_deref(), Some(&[1.0, 2.0, 3.0][..]));
    assert_eq!(inputs.temperature_c.as_deref(), Some(&[20.0, 21.0, 22.0][..]));
    assert_eq!((recording.response.as_slice(), recording.response_unit.as_str()), (&[74.0, 75.0, 76.0][..], "pF"));
}
