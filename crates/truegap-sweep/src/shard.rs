//! Which cases one of several processes computes.
//!
//! Limits: dealt in turn, whatever a case costs.

use crate::error::SweepError;
use std::fmt;
use std::str::FromStr;

/// Share `index` (from 1) of `of` equal shares, written `3/16`.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Shard {
    index: usize,
    of: usize,
}

impl Shard {
    /// Everything.
    pub const WHOLE: Self = Self { index: 1, of: 1 };

    /// Share `index` of `of`, counted from 1.
    ///
    /// # Errors
    /// [`SweepError::NoSuchShard`] where `index` is not between 1 and `of`.
    pub fn new(index: usize, of: usize) -> Result<Self, SweepError> {
        if (1..=of).contains(&index) {
            Ok(Self { index, of })
        } else {
            Err(SweepError::NoSuchShard { text: format!("{index}/{of}") })
        }
    }

    /// Whether the case at this place of the list, from 0, is in the share.
    pub fn holds(self, place: usize) -> bool {
        place % self.of == self.index - 1
    }
}

impl FromStr for Shard {
    type Err = SweepError;

    fn from_str(text: &str) -> Result<Self, SweepError> {
        let refused = || SweepError::NoSuchShard { text: text.to_owned() };
        let (index, of) = text.split_once('/').ok_or_else(refused)?;
        let number = |part: &str| part.trim().parse::<usize>().map_err(|_| refused());
        Self::new(number(index)?, number(of)?).map_err(|_| refused())
    }
}

impl fmt::Display for Shard {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        write!(f, "{}/{}", self.index, self.of)
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn every_case_is_in_one_share() {
        for of in [1, 2, 16] {
            for place in 0..50 {
                let holders = (1..=of).filter(|&index| Shard::new(index, of).unwrap().holds(place)).count();
                assert_eq!(holders, 1);
            }
        }
    }

    #[test]
    fn shares_that_are_none_are_refused() {
        assert_eq!("3/16".parse::<Shard>().unwrap(), Shard::new(3, 16).unwrap());
        assert_eq!(Shard::new(3, 16).unwrap().to_string(), "3/16");
        for text in ["0/4", "5/4", "1/0", "1", "a/b", ""] {
            assert!(text.parse::<Shard>().unwrap_err().to_string().contains(text), "{text}");
        }
    }
}
