//! Which column of the header plays which role, and how its numbers become SI.
//!
//! Limits: a unit is the end of a column's name ([`super::notation`]), stands in a line of units under the header, or under `[units]`.

use super::{
    date_and_time::date_and_time,
    default_names::{called_after, default_name, dimension, is_default},
    error::RecordingError,
    guess::by_name,
    heading::{FAHRENHEIT, FARAD, Heading},
    idle_units::units_of_nothing,
    manifest::{BaseSpec, Manifest, Named},
    map::NO_LINE,
    note::Note,
    roles::ROLES,
    words::told,
};
use crate::given_again;
use crate::inputs::Role;
use crate::nearest::nearest;
use crate::units::{Dimension, UnitError, is_same_unit, is_unit};
use std::cell::OnceCell;
use std::collections::BTreeMap;
use std::path::Path;

/// A column that plays a role.
#[derive(Clone, Debug)]
pub(super) struct Column {
    pub role: Role,
    pub index: usize,
    pub name: String,
    /// unit after conversion
    pub unit: String,
    /// value = cell x factor + offset
    pub scale: (f64, f64),
    /// whether its cells are dates, or times of day alone
    pub dated: bool,
    /// whether they are times of day alone
    pub times: bool,
    /// the column of their times of day, where that is another one
    pub of_day: Option<usize>,
}

/// The columns of a header, and what was assumed about them.
pub(super) fn bind(
    file: &Path,
    toml: Option<&Path>,
    header: &[Heading],
    manifest: &Manifest,
) -> Result<(Vec<Column>, Vec<Note>), RecordingError> {
    let binder = Binder { file, toml: toml.unwrap_or(file), bare: toml.is_none(), header, manifest, by_words: OnceCell::new() };
    let mut found = Vec::new();
    for role in ROLES {
        found.extend(binder.find(role)?.map(|index| (role, index)));
    }
    let same = |(one, before): &(Role, usize), (other, index): &(Role, usize)| before == index && both_are_read(*one, *other);
    if let Some(((one, _), (other, index))) = given_again(&found, same) {
        return Err(binder.two_roles(*one, *other, *index));
    }
    let mut notes: Vec<Note> = binder.told_by_name(&found).into_iter().collect();
    let idle = units_of_nothing(manifest, &found);
    notes.extend(idle.map_err(|(role, line, source)| binder.wrong_unit(role, line, source))?);
    let columns = found.into_iter().map(|(role, index)| binder.column(role, index, &mut notes));
    let mut columns = columns.collect::<Result<Vec<_>, _>>()?;
    binder.match_simulated(&mut columns)?;
    Ok((columns, notes))
}

struct Binder<'a> {
    file: &'a Path,
    toml: &'a Path,
    /// whether no TOML says which column is what
    bare: bool,
    header: &'a [Heading],
    manifest: &'a Manifest,
    /// what words of names tell of all roles at once, when the first role asks
    by_words: OnceCell<BTreeMap<Role, usize>>,
}

/// Whether both roles are read as numbers: what numbers the runs may be a clock or a sensor's name as well.
fn both_are_read(one: Role, other: Role) -> bool {
    [one, other].iter().all(|role| !matches!(role, Role::Run | Role::Sensor | Role::Time))
}

impl Binder<'_> {
    /// Refuses a column that is named for two roles, by the line of the later one.
    fn two_roles(&self, one: Role, other: Role, index: usize) -> RecordingError {
        let line = |role| self.manifest.columns.get(&role).map_or(NO_LINE, |named| named.line);
        let place = match line(one).max(line(other)) {
            NO_LINE => String::new(),
            line => format!(", line {line}"),
        };
        let (file, column) = (self.toml.to_owned(), self.header[index].name.clone());
        RecordingError::TwoRoles { file, place, column, first: one.key().to_owned(), second: other.key().to_owned() }
    }

    /// Whether the TOML names a column of this name for a role.
    fn has_role(&self, name: &str) -> bool {
        self.manifest.columns.values().any(|named| named.text == name)
    }

    /// Whether it stands under `[drivers]`.
    fn is_driver(&self, name: &str) -> bool {
        self.manifest.drivers.iter().any(|driver| driver.column == name)
    }

    /// Index of a role's column.
    fn find(&self, role: Role) -> Result<Option<usize>, RecordingError> {
        let named = self.manifest.columns.get(&role);
        let by_default = |heading: &Heading| is_default(role, heading) && !self.is_meant_otherwise(role, heading);
        let fits = |heading: &Heading| named.map_or_else(|| by_default(heading), |named| heading.name == named.text);
        let found: Vec<usize> = (0..self.header.len()).filter(|index| fits(&self.header[*index])).collect();
        let name = |index: usize| &self.header[index].name;
        match (found.as_slice(), named) {
            ([index], _) => Ok(Some(*index)),
            (_, None) if role == Role::Response && self.manifest.inputs_alone => Ok(None),
            ([], None) if role != Role::Response => match self.almost(role) {
                Some(refused) => Err(refused),
                None => Ok(self.dates().filter(|_| role == Role::Time).or_else(|| self.by_a_word(role))),
            },
            ([], _) => Err(self.missing(role, named)),
            ([first, rest @ ..], _) if rest.iter().all(|index| name(*index) == name(*first)) => {
                Err(twice(self.file, name(*first), &found))
            }
            ([first, ..], _) => Err(RecordingError::AmbiguousColumn {
                file: self.file.to_owned(),
                role: role.key().to_owned(),
                found: quoted(found.iter().map(|index| name(*index).as_str())),
                first: name(*first).clone(),
            }),
        }
    }

    /// The column that is the clock as it alone holds dates: where several do, the one that is called after a clock. Days alone need such a name, as a table of one day has no other clock.
    fn dates(&self) -> Option<usize> {
        let dated: Vec<usize> = (0..self.header.len())
            .filter(|index| self.bare && self.header[*index].dated && !self.has_role(&self.header[*index].name))
            .collect();
        let only = |found: Vec<usize>| if let [index] = found[..] { Some(index) } else { None };
        let of =
            |fits: &dyn Fn(&Heading) -> bool| only(dated.iter().copied().filter(|index| fits(&self.header[*index])).collect());
        of(&|heading| told(Role::Time, &heading.name)).or_else(|| of(&|heading| !heading.days)).or_else(|| {
            let days = dated.iter().copied().filter(|index| date_and_time(self.header, *index).is_some());
            only(days.collect())
        })
    }

    /// The column of a table without a TOML that a word of its name and its unit tell, as they tell it to `truegap init`.
    fn by_a_word(&self, role: Role) -> Option<usize> {
        let dimension = dimension(role).filter(|_| self.bare)?;
        let index = *self.by_words.get_or_init(|| by_name(self.header, &self.free()).found).get(&role)?;
        self.header[index].unit_of(dimension).map(|_| index)
    }

    /// The columns of which nobody has said anything and that alone have their name; dates and times of day are none of them.
    fn free(&self) -> Vec<usize> {
        let is_free = |index: &usize| {
            let heading = &self.header[*index];
            let alone = self.header.iter().filter(|other| other.name == heading.name).count() == 1;
            alone && !heading.dated && !heading.of_day && !self.has_role(&heading.name) && !self.is_driver(&heading.name)
        };
        (0..self.header.len()).filter(is_free).collect()
    }

    /// A note of columns that were read by a word of their names.
    fn told_by_name(&self, found: &[(Role, usize)]) -> Option<Note> {
        let by_a_word = |(role, index): &&(Role, usize)| {
            let heading = &self.header[*index];
            !heading.dated && !self.manifest.columns.contains_key(role) && !is_default(*role, heading)
        };
        let told = found.iter().filter(by_a_word);
        let told: Vec<String> = told.map(|(role, index)| format!("`{}` as {}", self.header[*index].name, role.key())).collect();
        (!told.is_empty()).then(|| Note::ReadByName { columns: told.join(", ") })
    }

    /// Whether the TOML says of a column that is called after `role`, which it does not name, that it is something else: another role, or a driver in place of a load. A thermometer and
    /// a clock are what effects of their own follow, so a driver does not take these away without a word.
    fn is_meant_otherwise(&self, role: Role, heading: &Heading) -> bool {
        let may_be_driver = matches!(role, Role::Force | Role::Pressure | Role::Gap | Role::Humidity);
        self.has_role(&heading.name) || (may_be_driver && self.is_driver(&heading.name))
    }

    /// Why a role has no column although the header holds one that is called after it: what stands behind the word is no unit of it. To leave the column out
    /// without a word would be to diagnose another recording.
    fn almost(&self, role: Role) -> Option<RecordingError> {
        let dimension = dimension(role)?;
        let heading =
            self.header.iter().find(|heading| called_after(role, heading) && !self.is_meant_otherwise(role, heading))?;
        Some(self.not_its_unit(role, dimension, heading))
    }

    fn not_its_unit(&self, role: Role, dimension: Dimension, heading: &Heading) -> RecordingError {
        RecordingError::NotItsUnit {
            file: self.file.to_owned(),
            column: heading.name.clone(),
            role: role.key().to_owned(),
            unit: heading.unit().unwrap_or_default().to_owned(),
            known: dimension.unit_names().join(", "),
        }
    }

    fn two_units(&self, role: Role, heading: &Heading, named: &str, below: &str) -> RecordingError {
        RecordingError::TwoUnits {
            file: self.file.to_owned(),
            column: heading.name.clone(),
            role: role.key().to_owned(),
            named: named.to_owned(),
            below: below.to_owned(),
        }
    }

    fn missing(&self, role: Role, named: Option<&Named>) -> RecordingError {
        RecordingError::MissingColumn {
            file: self.file.to_owned(),
            role: role.key().to_owned(),
            wanted: named.map_or_else(|| format!("`{}`", default_name(role)), |n| format!("`{}`", n.text)),
            near: named.map_or_else(String::new, |named| almost_called(&named.text, self.header)),
            found: names(self.header),
        }
    }

    fn column(&self, role: Role, index: usize, notes: &mut Vec<Note>) -> Result<Column, RecordingError> {
        let pair = date_and_time(self.header, index).filter(|_| role == Role::Time);
        let (index, of_day) = pair.map_or((index, None), |(date, time)| (date, Some(time)));
        let (given, heading) = (self.manifest.units.get(&role), &self.header[index]);
        let dated = role == Role::Time && heading.dated;
        let (unit, scale) = match (role, dimension(role)) {
            (Role::Run | Role::Sensor, _) => (String::new(), (1.0, 0.0)),
            (_, None) => self.reading(role, heading, given, notes)?,
            (Role::Time, _) if heading.of_day && !dated => {
                return Err(RecordingError::TimeOfDay { file: self.file.to_owned(), column: heading.name.clone() });
            }
            (_, Some(dimension)) if dated => (dimension.si_unit().to_owned(), (1.0, 0.0)),
            (_, Some(dimension)) => self.quantity(role, dimension, heading, given, notes)?,
        };
        let times = dated && heading.of_day;
        Ok(Column { role, index, name: heading.name.clone(), unit, scale, dated, times, of_day })
    }

    /// SI unit and scale of a quantity.
    fn quantity(
        &self,
        role: Role,
        dimension: Dimension,
        heading: &Heading,
        given: Option<&Named>,
        notes: &mut Vec<Note>,
    ) -> Result<(String, (f64, f64)), RecordingError> {
        let in_name = heading.unit_of(dimension);
        let other = heading.unit_above(dimension);
        let scale = match (given, in_name) {
            (Some(given), _) => {
                let scale = dimension.scale(&given.text).map_err(|source| self.wrong_unit(role, given.line, source))?;
                // `pressure_kpa` read as a force in N is told as well
                let shown = in_name.or_else(|| heading.unit().filter(|unit| is_unit(unit)));
                if let Some(named) = shown.filter(|named| dimension.scale(named) != Ok(scale)) {
                    notes.push(overrides(heading, given, named));
                }
                scale
            }
            (None, Some(unit)) if other.is_some_and(|other| dimension.scale(other) != dimension.scale(unit)) => {
                return Err(self.two_units(role, heading, other.unwrap_or_default(), unit));
            }
            (None, Some(unit)) => dimension.scale(unit).map_err(|source| self.wrong_unit(role, 1, source))?,
            (None, None) if heading.below.is_some() => return Err(self.not_its_unit(role, dimension, heading)),
            (None, None) => return Err(self.missing_unit(role, dimension, &heading.name)),
        };
        Ok((dimension.si_unit().to_owned(), scale))
    }

    /// Unit and scale of a reading: picofarads for capacitances, anything else as it stands.
    fn reading(
        &self,
        role: Role,
        heading: &Heading,
        given: Option<&Named>,
        notes: &mut Vec<Note>,
    ) -> Result<(String, (f64, f64)), RecordingError> {
        let farads = Dimension::Capacitance;
        let in_name = heading.unit_of(farads);
        let unit = match (given, in_name) {
            (Some(given), named) => {
                if let Some(named) = named.filter(|named| !is_same_unit(named, &given.text)) {
                    notes.push(overrides(heading, given, named));
                }
                // the same letter as in a header
                let is_fahrenheit = given.text.trim() == FARAD && told(Role::Temperature, &heading.name);
                if is_fahrenheit { FAHRENHEIT.to_owned() } else { given.text.clone() }
            }
            (None, Some(named)) => named.to_owned(),
            (None, None) if role == Role::Simulated => heading
                .below
                .clone()
                .or(heading.proper_unit().filter(|unit| is_unit(unit)).map(str::to_owned))
                .unwrap_or_default(),
            (None, None) => heading.proper_unit().unwrap_or(&heading.name).to_owned(),
        };
        let other = |below: &&str| {
            let (_, named) = heading.unit_in_name()?;
            (is_unit(named) && is_unit(below) && !is_same_unit(named, below)).then_some(named)
        };
        let below = heading.below.as_deref().filter(|_| given.is_none());
        if let Some((below, named)) = below.and_then(|below| Some((below, other(&below)?))) {
            return Err(self.two_units(role, heading, named, below));
        }
        if let Some(given) = given {
            self.not_another_case(role, given)?;
        }
        Ok(match farads.scale(&unit) {
            Ok((factor, _)) => ("pF".to_owned(), (factor / 1e-12, 0.0)),
            Err(_) => (unit, (1.0, 0.0)),
        })
    }

    /// A reading may be in any unit, but `PF` is a slip of the pen.
    fn not_another_case(&self, role: Role, given: &Named) -> Result<(), RecordingError> {
        match Dimension::Capacitance.scale(&given.text) {
            Err(source) if Dimension::Capacitance.unit_like(&given.text).is_some() => {
                Err(self.wrong_unit(role, given.line, source))
            }
            _ => Ok(()),
        }
    }

    /// Gives a simulated column without a unit the response's; refuses two different ones, but where the gain is free and may hold their ratio.
    fn match_simulated(&self, columns: &mut [Column]) -> Result<(), RecordingError> {
        let Some(response) = columns.iter().find(|c| c.role == Role::Response).cloned() else { return Ok(()) };
        let Some(simulated) = columns.iter_mut().find(|c| c.role == Role::Simulated) else { return Ok(()) };
        if simulated.unit.is_empty() {
            simulated.unit = response.unit;
            simulated.scale = response.scale;
        } else if simulated.unit != response.unit && !self.manifest.base.as_ref().is_some_and(BaseSpec::frees_gain) {
            return Err(RecordingError::UnitsDiffer {
                file: self.file.to_owned(),
                column: simulated.name.clone(),
                unit: simulated.unit.clone(),
                response: response.unit,
            });
        }
        Ok(())
    }

    fn wrong_unit(&self, role: Role, line: usize, source: UnitError) -> RecordingError {
        if line == NO_LINE {
            return RecordingError::MappedUnit { file: self.file.to_owned(), role: role.key().to_owned(), source };
        }
        RecordingError::WrongUnit { file: self.toml.to_owned(), line, role: role.key().to_owned(), source }
    }

    fn missing_unit(&self, role: Role, dimension: Dimension, name: &str) -> RecordingError {
        RecordingError::MissingUnit {
            file: self.file.to_owned(),
            column: name.to_owned(),
            role: role.key().to_owned(),
            example: dimension.si_unit().to_owned(),
            known: dimension.unit_names().join(", "),
        }
    }
}

fn overrides(heading: &Heading, given: &Named, named: &str) -> Note {
    let by = if given.line == NO_LINE { "--map" } else { "[units]" };
    Note::UnitOverridesName { column: heading.name.clone(), unit: given.text.clone(), named: named.to_owned(), by: by.to_owned() }
}

/// Refuses a name for a role that stands over no column.
pub(super) fn there(file: &Path, header: &[Heading], role: Role, named: &Named) -> Result<(), RecordingError> {
    let manifest = &Manifest::default();
    let binder = Binder { file, toml: file, bare: true, header, manifest, by_words: OnceCell::new() };
    let is_there = header.iter().any(|heading| heading.name == named.text);
    if is_there { Ok(()) } else { Err(binder.missing(role, Some(named))) }
}

/// A name that stands over two columns.
pub(super) fn twice(file: &Path, name: &str, columns: &[usize]) -> RecordingError {
    let numbers: Vec<String> = columns.iter().map(|index| (index + 1).to_string()).collect();
    RecordingError::Twice { file: file.to_owned(), name: name.to_owned(), columns: numbers.join(" and ") }
}

/// The names that a wrong one may have meant, as the middle of a message.
pub(super) fn almost_called(wanted: &str, header: &[Heading]) -> String {
    let near = nearest(wanted, header.iter().map(|heading| heading.name.as_str()));
    near.first().map_or_else(String::new, |near| format!("did you mean `{near}`? "))
}

/// The columns of a header for a message.
pub(super) fn names(header: &[Heading]) -> String {
    quoted(header.iter().map(|heading| heading.name.as_str()).filter(|name| !name.is_empty()))
}

/// Names for a message.
pub(super) fn quoted<'a>(names: impl Iterator<Item = &'a str>) -> String {
    let names: Vec<String> = names.map(|name| format!("`{name}`")).collect();
    names.join(", ")
}
