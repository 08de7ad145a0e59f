//! A table of a TOML file that knows where it stands, and that notices keys nobody asked for.
//!
//! Limits: as much of TOML as sensor files need: text, numbers, tables.

use super::error::{SensorError, SensorProblem};
use crate::units::{Dimension, Measure, parse};
use std::cell::RefCell;
use toml::{
    Spanned,
    de::{DeTable, DeValue},
};

/// File being read.
#[derive(Clone, Copy)]
pub(super) struct Source<'a> {
    pub file: &'a str,
    pub text: &'a str,
}

impl Source<'_> {
    pub(super) fn line(self, offset: usize) -> usize {
        1 + self.text.bytes().take(offset).filter(|&b| b == b'\n').count()
    }

    pub(super) fn error(self, offset: usize, key: &str, problem: impl Into<SensorProblem>) -> SensorError {
        SensorError { file: self.file.to_owned(), line: Some(self.line(offset)), key: key.to_owned(), problem: problem.into() }
    }
}

/// A table, its dotted name, and the keys asked for so far.
pub(super) struct Table<'a> {
    pub source: Source<'a>,
    path: String,
    at: usize,
    entries: &'a DeTable<'a>,
    asked: RefCell<Vec<&'static str>>,
}

impl<'a> Table<'a> {
    pub(super) fn new(source: Source<'a>, path: String, at: usize, entries: &'a DeTable<'a>) -> Self {
        Self { source, path, at, entries, asked: RefCell::new(Vec::new()) }
    }

    /// Dotted name of a key.
    pub(super) fn dotted(&self, key: &str) -> String {
        if self.path.is_empty() { key.to_owned() } else { format!("{}.{key}", self.path) }
    }

    fn get(&self, key: &'static str) -> Option<&'a Spanned<DeValue<'a>>> {
        self.asked.borrow_mut().push(key);
        self.entries.iter().find(|(name, _)| name.get_ref() == key).map(|(_, value)| value)
    }

    /// Names of all entries, with their offsets.
    pub(super) fn names(&self) -> impl Iterator<Item = (&'a str, usize)> {
        self.entries.iter().map(|(name, _)| (name.get_ref().as_ref(), name.span().start))
    }

    /// An error at this table.
    pub(super) fn error(&self, key: &str, problem: impl Into<SensorProblem>) -> SensorError {
        self.source.error(self.at, &self.dotted(key), problem)
    }

    fn missing(&self, key: &str, example: &str) -> SensorError {
        self.error(key, SensorProblem::Missing { example: format!("{key} = {example}") })
    }

    /// A table below this one.
    pub(super) fn table(&self, key: &'static str) -> Result<Option<Table<'a>>, SensorError> {
        let Some(value) = self.get(key) else { return Ok(None) };
        self.as_table(key, value).map(Some)
    }

    /// A table below this one, by a name that the file chose.
    pub(super) fn named(&self, name: &str) -> Result<Option<Table<'a>>, SensorError> {
        let found = self.entries.iter().find(|(key, _)| key.get_ref() == name);
        found.map(|(_, value)| self.as_table(name, value)).transpose()
    }

    fn as_table(&self, key: &str, value: &'a Spanned<DeValue<'a>>) -> Result<Table<'a>, SensorError> {
        match value.get_ref() {
            DeValue::Table(entries) => Ok(Table::new(self.source, self.dotted(key), value.span().start, entries)),
            other => Err(self.wrong(key, value, other, "a table")),
        }
    }

    fn wrong(&self, key: &str, value: &Spanned<DeValue<'_>>, found: &DeValue<'_>, expected: &'static str) -> SensorError {
        let problem = SensorProblem::WrongType { found: format!("a TOML {}", found.type_str()), expected };
        self.source.error(value.span().start, &self.dotted(key), problem)
    }

    /// A table that must be there.
    pub(super) fn needed_table(&self, key: &'static str, example: &str) -> Result<Table<'a>, SensorError> {
        self.table(key)?.ok_or_else(|| self.missing(key, example))
    }

    /// A text, and where it stands.
    pub(super) fn text(&self, key: &'static str) -> Result<Option<(&'a str, usize)>, SensorError> {
        let Some(value) = self.get(key) else { return Ok(None) };
        match value.get_ref() {
            DeValue::String(text) => Ok(Some((text, value.span().start))),
            other => Err(self.wrong(key, value, other, "a text in quotes, a quantity with its unit")),
        }
    }

    /// A text that must be there.
    pub(super) fn needed_text(&self, key: &'static str, example: &str) -> Result<(&'a str, usize), SensorError> {
        self.text(key)?.ok_or_else(|| self.missing(key, example))
    }

    /// A quantity with its spread.
    pub(super) fn measure(&self, key: &'static str, dimension: Dimension) -> Result<Option<Measure>, SensorError> {
        let Some((text, at)) = self.text(key)? else { return Ok(None) };
        Measure::parse(text, dimension).map(Some).map_err(|error| self.source.error(at, &self.dotted(key), error))
    }

    /// A quantity with its spread that must be there.
    pub(super) fn needed_measure(&self, key: &'static str, dimension: Dimension, example: &str) -> Result<Measure, SensorError> {
        self.measure(key, dimension)?.ok_or_else(|| self.missing(key, example))
    }

    /// A quantity without spread that must be there.
    pub(super) fn needed_exact(&self, key: &'static str, dimension: Dimension, example: &str) -> Result<f64, SensorError> {
        let (text, at) = self.needed_text(key, example)?;
        parse(text, dimension).map_err(|error| self.source.error(at, &self.dotted(key), error))
    }

    /// A pure number, as number or as text (`3.4`, `"85 %"`).
    pub(super) fn number(&self, key: &'static str, dimension: Dimension) -> Result<Option<f64>, SensorError> {
        let Some(value) = self.get(key) else { return Ok(None) };
        let text = match value.get_ref() {
            DeValue::String(text) => text.as_ref(),
            DeValue::Float(number) => number.as_str(),
            DeValue::Integer(number) => number.as_str(),
            other => return Err(self.wrong(key, value, other, "a number")),
        };
        let number = parse(&text.replace('_', ""), dimension);
        number.map(Some).map_err(|error| self.source.error(value.span().start, &self.dotted(key), error))
    }

    /// A pure number that must be there.
    pub(super) fn needed_number(&self, key: &'static str, example: &str) -> Result<f64, SensorError> {
        self.number(key, Dimension::Ratio)?.ok_or_else(|| self.missing(key, example))
    }

    /// A count that must be there.
    pub(super) fn needed_count(&self, key: &'static str, example: &str) -> Result<u32, SensorError> {
        let value = self.get(key).ok_or_else(|| self.missing(key, example))?;
        let count = value.get_ref().as_integer().and_then(|number| number.as_str().replace('_', "").parse().ok());
        count.ok_or_else(|| self.wrong(key, value, value.get_ref(), "a whole number, 0 or more"))
    }

    /// Whether every key was asked for.
    pub(super) fn finish(&self) -> Result<(), SensorError> {
        let asked = self.asked.borrow();
        match self.names().find(|(name, _)| !asked.contains(name)) {
            None => Ok(()),
            Some((name, at)) => {
                let problem = SensorProblem::UnknownKey { known: asked.join(", ") };
                Err(self.source.error(at, &self.dotted(name), problem))
            }
        }
    }
}
