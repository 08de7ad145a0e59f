//! Which column of a header most likely is what: the guess of each role, what is told, and what two columns of one quantity are to one another.
//!
//! Limits: where two columns of a quantity may both be the reading, neither is taken for anything.

use super::{
    default_names::is_default,
    guess::{Guess, guess, surely_read},
    heading::Heading,
    map::Part,
    twins::{self, Twins, alike},
    words::is_called_simulation,
};
use crate::inputs::Role;

/// A header, and what is known of it.
pub(super) struct Likely<'a> {
    pub header: &'a [Heading],
    /// the columns that hold something and have a name of their own
    pub usable: &'a [usize],
    /// columns that are told of
    pub told: Vec<(Part, usize)>,
}

impl Likely<'_> {
    /// The columns of the roles, and the reading with the column beside it where their names tell it.
    pub fn roles(&self) -> (Guess, Option<Twins>) {
        let twins = self.twins();
        let guess = self.with_told(self.with_twins(twins));
        let known = twins.is_some() || self.told_to_be(Role::Response).is_some();
        (if known { guess } else { self.without_doubtful(guess) }, twins)
    }

    fn is_told_of(&self, index: usize) -> bool {
        self.told.iter().any(|(_, told)| *told == index)
    }

    /// The columns among which roles are guessed: those that nothing is told of, and that are not called after a simulation.
    fn guessed(&self) -> Vec<usize> {
        let computed =
            |index: usize| is_called_simulation(&self.header[index].name) && !is_default(Role::Simulated, &self.header[index]);
        self.usable.iter().filter(|index| !self.is_told_of(**index) && !computed(**index)).copied().collect()
    }

    /// The column that is told to play a role.
    fn told_to_be(&self, role: Role) -> Option<usize> {
        self.told.iter().find_map(|(part, index)| (*part == Part::Role(role)).then_some(*index))
    }

    /// A reading and the column of its quantity beside it, where their names tell which is which, and no other column is a reading by its name or unit.
    fn twins(&self) -> Option<Twins> {
        let response = self.told_to_be(Role::Response);
        let free: Vec<usize> =
            self.usable.iter().copied().filter(|index| !self.is_told_of(*index) || response == Some(*index)).collect();
        let sure = response.map_or_else(|| surely_read(self.header, &self.guessed()), |told| vec![told]);
        let fits = |twins: &Twins| sure.is_empty() || sure == [twins.reading];
        let of_simulation = twins::of_simulation(self.header, &free).filter(fits);
        // a column beside them may be the reading, and both may be what was done
        let alone = |twins: &Twins| {
            let taken = self.with_twins(Some(*twins)).found;
            let spare = |index: &usize| !self.header[*index].dated && taken.values().all(|used| used != index);
            sure.is_empty() && free.iter().all(|index| *index == twins.beside || !spare(index))
        };
        let of_reference = || twins::of_reference(self.header, &free).filter(alone);
        of_simulation.filter(|_| self.told_to_be(Role::Simulated).is_none()).or_else(of_reference)
    }

    fn with_twins(&self, twins: Option<Twins>) -> Guess {
        let Some(Twins { reading, beside, is_simulated }) = twins else { return guess(self.header, &self.guessed()) };
        let mut others = self.guessed();
        others.retain(|index| *index != reading && !(is_simulated && *index == beside));
        let mut guess = guess(self.header, &others);
        guess.several.remove(&Role::Response);
        guess.found.insert(Role::Response, reading);
        guess.found.extend(is_simulated.then_some((Role::Simulated, beside)));
        guess
    }

    /// Takes back what a word or a unit made of one of two columns of a quantity, and what is left over made a reading of the other: either may be the reading.
    fn without_doubtful(&self, mut guess: Guess) -> Guess {
        use Role::{Force, Gap, Humidity, Pressure, Temperature};
        if !surely_read(self.header, &self.guessed()).is_empty() {
            return guess;
        }
        let reading = guess.found.get(&Role::Response).copied();
        for role in [Force, Pressure, Gap, Temperature, Humidity] {
            let Some(index) = guess.found.get(&role).copied() else { continue };
            let heading = &self.header[index];
            let twin = |other: &usize| *other != index && !self.is_told_of(*other) && alike(heading, &self.header[*other]);
            let mut fit: Vec<usize> = self.usable.iter().copied().filter(twin).collect();
            let elsewhere = reading.is_some_and(|reading| !fit.contains(&reading));
            if fit.is_empty() || elsewhere || self.is_told_of(index) || is_default(role, heading) {
                continue;
            }
            fit.push(index);
            fit.sort_unstable();
            guess.found.remove(&role);
            guess.found.remove(&Role::Response);
            guess.several.insert(role, fit);
        }
        guess
    }

    fn with_told(&self, mut guess: Guess) -> Guess {
        for (part, index) in &self.told {
            if let Part::Role(role) = part {
                guess.several.remove(role);
                guess.found.insert(*role, *index);
            }
        }
        guess
    }
}
