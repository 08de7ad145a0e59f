//! What a file holds that is a frame.
//!
//! Limits: numbers and times; of other columns the names alone.

use crate::inputs::Role;
use crate::recording::{
    date_text::{dates_of_text, first_text},
    default_names::is_default,
    error::RecordingError,
    frame::FrameColumn,
    heading::Heading,
    manifest::Manifest,
    stamp::is_day,
    words::told,
};
use std::path::Path;

/// The columns of a file.
pub(in crate::recording) struct Frame {
    pub columns: Vec<FrameColumn<'static>>,
    /// columns of texts that begin with a date, until [`Frame::read_dates`]
    pub texts: Vec<Texts>,
    /// names of what is neither numbers nor times, and what it is
    pub left_out: Vec<(String, String)>,
    pub sha256: String,
}

/// A column of texts that begins with a date.
pub(in crate::recording) struct Texts {
    pub name: String,
    /// columns before it
    pub at: usize,
    pub cells: Vec<Option<String>>,
}

impl Texts {
    fn cells(&self) -> Vec<Option<&str>> {
        self.cells.iter().map(Option::as_deref).collect()
    }

    /// Whether the name says that these are a clock, or a time of day does.
    fn tells_time(&self) -> bool {
        let first = first_text(self.cells.iter().flatten().map(String::as_str));
        told(Role::Time, &self.name) || first.is_some_and(|first| !is_day(first.as_bytes()))
    }
}

impl Frame {
    /// The columns as a header.
    pub fn header(&self) -> Vec<Heading> {
        let texts = self.texts.iter().map(|texts| Heading::of(&texts.name));
        self.columns.iter().map(FrameColumn::heading).chain(texts).collect()
    }

    /// Makes clocks of texts that are dates, in the order of day and month that `manifest` says. Texts that cannot be read are left out where they are not the clock.
    ///
    /// # Errors
    /// Those of [`dates_of_text`].
    pub fn read_dates(&mut self, file: &Path, manifest: &Manifest) -> Result<(), RecordingError> {
        let named = manifest.columns.get(&Role::Time);
        let has_clock = self.columns.iter().any(|column| is_default(Role::Time, &column.heading()));
        let is_clock = |texts: &Texts| named.map_or(!has_clock && texts.tells_time(), |named| named.text == texts.name);
        let read = |texts: &Texts| match dates_of_text(file, &texts.name, &texts.cells(), manifest.dayfirst) {
            Err(error) if is_clock(texts) => Err(error),
            read => Ok(read.ok().flatten()),
        };
        let read = self.texts.iter().map(read).collect::<Result<Vec<_>, _>>()?;
        for (texts, column) in std::mem::take(&mut self.texts).into_iter().zip(read) {
            match column {
                Some(column) => self.columns.insert(texts.at.min(self.columns.len()), column),
                None => self.left_out.push((texts.name, "text".to_owned())),
            }
        }
        Ok(())
    }

    /// Names of what is neither numbers nor times, once [`Frame::read_dates`] has looked at the texts.
    pub fn left_out_names(&self) -> Vec<String> {
        self.left_out.iter().map(|(name, _)| name.clone()).collect()
    }

    /// Refuses a file whose columns of text are named for numbers.
    ///
    /// # Errors
    /// [`RecordingError::NoNumbersInColumn`].
    pub fn holds_numbers(&self, file: &Path, manifest: &Manifest) -> Result<(), RecordingError> {
        let roles = manifest.columns.values().map(|named| &named.text);
        let mut wanted = roles.chain(manifest.drivers.iter().map(|driver| &driver.column));
        match wanted.find_map(|name| self.left_out.iter().find(|(column, _)| column == name)) {
            None => Ok(()),
            Some((column, holds)) => {
                let (file, column, holds) = (file.to_owned(), column.clone(), holds.clone());
                Err(RecordingError::NoNumbersInColumn { file, column, holds })
            }
        }
    }
}
