//! What is given twice where it may stand once.
//!
//! Limits: each is compared with all before it, so lists that a person writes.

/// The first of `all` that is the `same` as one before it: that one, and it; `None` where each stands once.
pub fn given_again<T>(all: &[T], same: impl Fn(&T, &T) -> bool) -> Option<(&T, &T)> {
    let before = |(place, again)| all[..place].iter().find(|first| same(first, again)).map(|first| (first, again));
    all.iter().enumerate().find_map(before)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn the_first_that_stands_again_is_told_with_the_one_before() {
        assert_eq!(given_again(&[3, -1, 2, 1, -3], |a, b: &i32| a.abs() == b.abs()), Some((&-1, &1)));
        assert_eq!(given_again(&[3, 1, 2], |a, b| a == b), None);
        assert_eq!(given_again(&[0; 0], |a, b| a == b), None);
    }
}
