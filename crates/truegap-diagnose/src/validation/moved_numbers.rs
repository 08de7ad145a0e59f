//! How much the numbers of a model move from part to part of a recording, beside what its noise lets them move.
//!
//! Noise tells how well a number is known only where nothing else is in what the model leaves. What lasts longer than the memory of the noise moves a number as a few large errors do, and not as many small ones. Each
//! part that is left out shows by how much: a number without a part differs from that of all rows by as much as the part has its say, in the square the variance without it less that of all rows (of independent
//! errors). The mean of what was found over what was to be expected is the dispersion of the number (McCullagh & Nelder, Generalized Linear Models, ch. 4, with parts for rows; leaving groups out: Wu, Ann. Stat. 14 (1986) 1261).
//!
//! Limits: what lasts longer than a part is not seen; six parts or more, so that chance alone makes a dispersion of 0.2 to 2.2.

/// A fit without one part.
#[derive(Clone, Debug, PartialEq)]
pub struct Refit {
    /// coordinates, as those of a fit to all rows
    pub z: Vec<f64>,
    /// their standard deviations, by noise and prior
    pub sd: Vec<f64>,
}

/// Parts below which no dispersion is told.
const LEAST_PARTS: usize = 3;

/// Least variance of the difference to one part, over that of parts that know as much as each other: a part that says next to nothing of a number is not weighed by its rounding.
const LEAST_SAY: f64 = 0.25;

/// Standard deviations of the coordinates of a fit to all rows, with those that noise makes: each no less than that, and larger where the number moves more between the fits without one part.
pub(crate) fn by_parts((z, sd): (&[f64], &[f64]), without: &[Refit]) -> Vec<f64> {
    (0..z.len()).map(|i| sd[i] * wider((z[i], sd[i]), without, i)).collect()
}

/// The same for a fit that is calibrated in another way than those without one part: what all rows would tell in their way is made of them. Each part is left out of one and is in all others, so that the information of all
/// is one less than their number of the whole (where numbers do not stand for each other).
pub(crate) fn by_parts_alone(sd: &[f64], without: &[Refit]) -> Vec<f64> {
    let all = |i: usize| {
        let told = told(without, i);
        let weight = |(_, sd): &(f64, f64)| sd.powi(-2);
        let information: f64 = told.iter().map(weight).sum();
        let mean = told.iter().map(|part| weight(part) * part.0).sum::<f64>() / information;
        (mean, ((told.len() as f64 - 1.0) / information).sqrt())
    };
    sd.iter().enumerate().map(|(i, sd)| sd * wider(all(i), without, i)).collect()
}

/// How much larger the deviation of a number is than the noise makes it.
fn wider(all: (f64, f64), without: &[Refit], i: usize) -> f64 {
    dispersion(all, &told(without, i)).sqrt().max(1.0)
}

/// A number without each part, with its deviation, where it has one.
fn told(without: &[Refit], i: usize) -> Vec<(f64, f64)> {
    let each = without.iter().map(|part| (part.z[i], part.sd[i]));
    each.filter(|(z, sd)| z.is_finite() && sd.is_finite() && *sd > 0.0).collect()
}

/// Mean square of the differences to a number of all rows, each over its variance; numbers with their standard deviations. 1 where too few parts tell it.
fn dispersion((number, sd): (f64, f64), told: &[(f64, f64)]) -> f64 {
    if told.len() < LEAST_PARTS || !(sd > 0.0 && sd.is_finite()) {
        return 1.0;
    }
    let parts = told.len() as f64;
    let least = LEAST_SAY * sd * sd / (parts - 1.0);
    told.iter().map(|(z, own)| (z - number).powi(2) / (own * own - sd * sd).max(least)).sum::<f64>() / parts
}

#[cfg(test)]
mod tests {
    use super::*;
    use rand::{RngExt, SeedableRng};
    use rand_chacha::ChaCha8Rng;

    const PARTS: usize = 6;
    const ROWS: usize = 60;

    /// Mean of all rows and of all but one part, as if they were independent with a deviation of 1: what is told of the first, over the root-mean-square deviation that it has.
    fn told_over_true(error: impl Fn(&mut ChaCha8Rng, &[f64]) -> f64) -> f64 {
        let random = &mut ChaCha8Rng::seed_from_u64(7);
        let mean = |y: &[f64]| y.iter().sum::<f64>() / y.len() as f64;
        let (mut told, mut found) = (0.0, 0.0);
        for _ in 0..400 {
            let y = (0..PARTS * ROWS).fold(Vec::new(), |mut y, _| {
                let next = error(random, &y);
                y.push(next);
                y
            });
            let without = |part: usize| {
                let kept: Vec<f64> = y.iter().enumerate().filter(|(row, _)| row / ROWS != part).map(|(_, v)| *v).collect();
                (mean(&kept), (kept.len() as f64).sqrt().recip())
            };
            let sd = (y.len() as f64).sqrt().recip();
            told += sd * sd * dispersion((mean(&y), sd), &(0..PARTS).map(without).collect::<Vec<_>>());
            found += mean(&y).powi(2);
        }
        (told / found).sqrt()
    }

    fn normal(random: &mut ChaCha8Rng) -> f64 {
        // sum of twelve uniform numbers
        (0..12).map(|_| random.random::<f64>()).sum::<f64>() - 6.0
    }

    /// 400 draws: the ratio of two root-mean-squares is known to 5 %.
    #[test]
    fn of_independent_errors_the_dispersion_is_one() {
        let ratio = told_over_true(|random, _| normal(random));
        assert!((0.85..1.15).contains(&ratio), "{ratio}");
    }

    /// Errors that last ten rows make a mean of 360 rows 4.4 times less sure than independent ones: (1 + 0.9) / (1 - 0.9) in the square.
    #[test]
    fn errors_that_last_are_seen_in_the_parts() {
        let last = |random: &mut ChaCha8Rng, y: &[f64]| 0.9 * y.last().copied().unwrap_or(0.0) + 0.19f64.sqrt() * normal(random);
        let ratio = told_over_true(last);
        assert!((0.8..1.15).contains(&ratio), "{ratio}");
    }

    /// Six means of all but one of six parts that know as much as each other: all rows know 6 / 5 of what each knows, and their mean is the mean of the six.
    #[test]
    fn what_all_rows_tell_is_made_of_the_fits_without_a_part() {
        let without: Vec<Refit> =
            [0.3, -0.5, 0.1, 0.4, -0.6, 0.3].iter().map(|z| Refit { z: vec![*z], sd: vec![1.2f64.sqrt()] }).collect();
        let [known, alone] = [by_parts((&[0.0], &[1.0]), &without), by_parts_alone(&[1.0], &without)];
        // squares 0.96 over 6 parts, each with a variance of 0.2: 0.8, told as 1
        assert_eq!([known[0], alone[0]], [1.0; 2]);
        let wide: Vec<Refit> = without.iter().map(|part| Refit { z: vec![3.0 * part.z[0]], ..part.clone() }).collect();
        approx::assert_relative_eq!(by_parts((&[0.0], &[1.0]), &wide)[0], 7.2f64.sqrt(), max_relative = 1e-12);
        approx::assert_relative_eq!(by_parts_alone(&[2.0], &wide)[0], 2.0 * 7.2f64.sqrt(), max_relative = 1e-12);
    }

    #[test]
    fn a_number_that_one_part_alone_tells_is_not_less_sure_for_it() {
        // without its part nothing but the prior is left, a hundred deviations wide, and the number is somewhere in it
        let without = [(0.0, 1.0), (0.1, 1.0), (-0.1, 1.0), (60.0, 100.0), (0.0, 1.0), (0.0, 1.0)];
        assert!(dispersion((0.0, 1.0), &without) < 1.0);
    }

    #[test]
    fn two_parts_tell_nothing_and_one_without_an_answer_is_left_out() {
        assert_eq!(dispersion((0.0, 1.0), &[(9.0, 1.1), (9.0, 1.1)]), 1.0);
        let without =
            [(0.1, 1.1), (f64::NAN, 1.1), (0.1, 1.1), (9.0, 0.0), (0.1, 1.1)].map(|(z, sd)| Refit { z: vec![z], sd: vec![sd] });
        approx::assert_relative_eq!(dispersion((0.0, 1.0), &told(&without, 0)), 0.01 / 0.21, max_relative = 1e-12);
    }
}
