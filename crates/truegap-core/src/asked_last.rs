//! A few answers, those asked last first.
//!
//! Limits: each is compared with what is asked, so some ten of them.

use std::collections::VecDeque;

/// What `is_asked` of `known`, or else what is made anew, put first; the last of more than `most` is forgotten.
pub fn asked_last<T>(known: &mut VecDeque<T>, most: usize, is_asked: impl Fn(&T) -> bool, make: impl FnOnce() -> T) -> &mut T {
    let found = known.iter().position(is_asked).and_then(|place| known.remove(place)).unwrap_or_else(make);
    known.truncate(most - 1);
    known.push_front(found);
    &mut known[0]
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn what_is_asked_again_is_first_and_what_is_asked_least_lately_goes() {
        let (mut known, mut made) = (VecDeque::new(), 0);
        let mut ask = |value: i32| {
            let make = || {
                made += 1;
                value
            };
            *asked_last(&mut known, 2, |other| *other == value, make)
        };
        assert_eq!([1, 2, 1, 3].map(&mut ask), [1, 2, 1, 3]);
        assert_eq!((known, made), (VecDeque::from([3, 1]), 3));
    }
}
