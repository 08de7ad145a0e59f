//! One attack: what lies in the folder, what is typed, and what must come of it.
//!
//! Limits: the words are looked for in what is printed, results and errors together.

use std::ffi::OsString;
use std::path::Path;

/// What lies in the folder before the command runs.
#[derive(Clone, Debug)]
pub enum Put {
    /// a file
    File(String, Vec<u8>),
    /// a file of this many bytes, none of them written
    Hole(String, u64),
    /// a pipe that nobody writes to
    Pipe(String),
    /// a link and what it points at
    Link(String, String),
    /// a folder
    Folder(String),
}

/// What is looked at afterwards; a sentence where something is wrong.
pub type Look = fn(&Path) -> Option<String>;

/// One attack.
#[derive(Clone, Debug)]
pub struct Attack {
    /// number in the list of what once went through, or a word for a class of its own
    pub class: &'static str,
    /// what is tried
    pub name: String,
    /// what lies in the folder
    pub put: Vec<Put>,
    /// what is typed behind `truegap`
    pub typed: Vec<OsString>,
    /// exit code that is due
    pub exit: i32,
    /// words that the answer must hold
    pub words: Vec<String>,
    /// names of files that may be new afterwards
    pub leaves: Vec<&'static str>,
    /// longest time, s
    pub seconds: u64,
    /// most memory, MB
    pub megabytes: u64,
    /// largest file that may be written, blocks of 512 bytes: a disk that is full behind it
    pub blocks: Option<u64>,
    /// whether nobody reads what it prints
    pub unread: bool,
    /// whether it belongs to the short version
    pub is_short: bool,
    /// what else is looked at
    pub look: Option<Look>,
}

impl Attack {
    /// An attack that must be refused.
    pub fn new(class: &'static str, name: impl Into<String>, typed: &[&str]) -> Self {
        Self {
            class,
            name: name.into(),
            put: Vec::new(),
            typed: typed.iter().map(OsString::from).collect(),
            exit: 2,
            words: Vec::new(),
            leaves: Vec::new(),
            seconds: 20,
            megabytes: 2500,
            blocks: None,
            unread: false,
            is_short: true,
            look: None,
        }
    }

    /// Puts a file into the folder.
    #[must_use]
    pub fn file(mut self, name: &str, text: impl Into<Vec<u8>>) -> Self {
        self.put.push(Put::File(name.into(), text.into()));
        self
    }

    /// Puts something else into the folder.
    #[must_use]
    pub fn with(mut self, put: Put) -> Self {
        self.put.push(put);
        self
    }

    /// Types one more word, which need not be UTF-8.
    #[must_use]
    pub fn word(mut self, word: impl Into<OsString>) -> Self {
        self.typed.push(word.into());
        self
    }

    /// What the answer must hold.
    #[must_use]
    pub fn says(mut self, words: &[&str]) -> Self {
        self.words.extend(words.iter().map(|word| (*word).to_owned()));
        self
    }

    /// An answer instead of a refusal, and what it leaves.
    #[must_use]
    pub fn ends(mut self, exit: i32, leaves: &[&'static str]) -> Self {
        self.exit = exit;
        self.leaves = leaves.to_vec();
        self
    }

    /// Longer than usual, so not in the short version.
    #[must_use]
    pub fn long(mut self, seconds: u64) -> Self {
        (self.seconds, self.is_short) = (seconds, false);
        self
    }

    /// Another limit of memory, MB.
    #[must_use]
    pub fn memory(mut self, megabytes: u64) -> Self {
        self.megabytes = megabytes;
        self
    }

    /// A disk that is full behind this many blocks of 512 bytes of any file.
    #[must_use]
    pub fn full_disk(mut self, blocks: u64) -> Self {
        self.blocks = Some(blocks);
        self
    }

    /// Nobody reads what it prints.
    #[must_use]
    pub fn unread(mut self) -> Self {
        self.unread = true;
        self
    }

    /// Looks at the folder afterwards.
    #[must_use]
    pub fn look(mut self, look: Look) -> Self {
        self.look = Some(look);
        self
    }
}
