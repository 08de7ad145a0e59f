//! What is told of every effect, whatever its numbers are: three digits, a unit that fits, and no number that cannot be.

#![allow(clippy::unwrap_used)]

mod common;

use truegap_core::{Parameter, Prior};
use truegap_diagnose::{Context, Effect, FittedParameter, library, sentence, sentence_of_seen};

/// Numbers of a text as they stand there, each with the text before it.
fn numbers(text: &str) -> Vec<(String, String)> {
    let mut list = Vec::new();
    let mut rest = 0;
    while let Some(start) = text[rest..].find(|c: char| c.is_ascii_digit()).map(|at| rest + at) {
        let is_part = |at: usize, c: char| {
            let next = text[at + c.len_utf8()..].chars().next();
            let digit = |c: Option<char>| c.is_some_and(|c| c.is_ascii_digit());
            c.is_ascii_digit()
                || (c == '.' && digit(next))
                || (c == 'e' && (digit(next) || next == Some('-')))
                || (c == '-' && digit(next))
        };
        let end = text[start..].char_indices().find(|(at, c)| !is_part(start + at, *c)).map_or(text.len(), |(at, _)| start + at);
        list.push((text[..start].to_owned(), text[start..end].to_owned()));
        rest = end;
    }
    list
}

/// Significant digits of a number as it is printed; zeros at the end of a whole number only hold its place.
fn digits(number: &str) -> usize {
    let mantissa = number.split('e').next().unwrap();
    let bare: String = mantissa.chars().filter(char::is_ascii_digit).collect();
    let bare = bare.trim_start_matches('0');
    if mantissa.contains('.') { bare.len() } else { bare.trim_end_matches('0').len() }
}

/// The last place of a number as it is printed, as a power of ten.
fn last_place(number: &str) -> i32 {
    let (mantissa, exponent) = number.split_once('e').unwrap_or((number, "0"));
    let decimals = mantissa.split_once('.').map_or(0, |(_, d)| d.len() as i32);
    let zeros = if decimals == 0 { mantissa.len() - mantissa.trim_end_matches('0').len() } else { 0 };
    exponent.parse::<i32>().unwrap() - decimals + zeros as i32
}

/// What is wrong with a sentence, if anything.
fn fault(text: &str) -> Option<String> {
    if text.contains("NaN") || text.contains("inf ") || text.contains("–") {
        return Some("not a number".into());
    }
    let all = numbers(text);
    for (index, (before, number)) in all.iter().enumerate() {
        if digits(number) > 4 {
            return Some(format!("{number} has too many digits"));
        }
        if digits(number) == 0 && number.contains('.') {
            return Some(format!("{number} is no size"));
        }
        let previous = index.checked_sub(1).map(|i| &all[i].1);
        if let Some(previous) = previous.filter(|p| before.ends_with("(sd ") && *p != "0" && last_place(p) > last_place(number)) {
            // an error of two digits beside a round number, as in `100 s (sd 12)`, or beside nothing, is as coarse as the number is
            let coarse = last_place(previous) - previous.len() as i32 > last_place(number);
            let round = previous.ends_with('0') && !previous.contains('.');
            if coarse || !round {
                return Some(format!("an error of {number} beside {previous}"));
            }
        }
    }
    None
}

fn fitted(effect: &dyn Effect, context: &Context<'_>, factor: f64, error: f64) -> Vec<FittedParameter> {
    let number = |parameter: truegap_core::Parameter| {
        let scale = match parameter.prior {
            Prior::Normal { mean, sd } => mean + 0.731_234_567 * sd,
            Prior::LogNormal { median, .. } => 1.237_654_321 * median,
            Prior::Wide { sd } => 0.731_234_567 * sd,
        };
        let value = scale * factor;
        let (low, high) = parameter.bounds;
        FittedParameter {
            value: value.clamp(low, high),
            sd: (value * error).abs(),
            sd_of_fit: (value * error).abs(),
            at_limit: value <= low || value >= high,
            parameter,
        }
    };
    effect.parameters(context).into_iter().map(number).collect()
}

/// From a billionth of what is usual to a billion times that, with errors as far apart: what a fit gone wrong hands on.
#[test]
fn no_effect_says_what_cannot_be_whatever_its_numbers() {
    let plate = common::Plate::new(Some(false));
    let inputs = common::recording();
    let context = Context::new(&inputs, &plate, 10.0, 0.004);
    let mut faults = Vec::new();
    for effect in library() {
        for factor in [0.0, 1e-9, 1e-3, 0.1, 1.0, -1.0, 30.0, 1e3, 1e9, f64::NAN] {
            for error in [0.0, 1e-9, 1e-3, 0.02, 0.3, 3.0, 1e6, f64::NAN] {
                let fitted = fitted(effect.as_ref(), &context, factor, error);
                let says = sentence(effect.as_ref(), &fitted, &context, &[]);
                if let Some(fault) = fault(&says) {
                    faults.push(format!("{fault} in {} x {factor}, sd {error}: {says}", effect.id()));
                }
                assert!(says.len() > 20, "{says}");
            }
        }
    }
    assert!(faults.is_empty(), "{} sentences, among them:\n{}", faults.len(), faults[..faults.len().min(20)].join("\n"));
}

/// Sentences that were told: none of them passes.
#[test]
fn what_was_told_before_is_found_out() {
    for text in [
        "the electronics follow with a time constant of 445817.71 ms",
        "the modulus drifts with the clock, by 138743.902 % in the first hour (sd 4.379)",
        "the electronics follow with a time constant of 0.00 ms (sd 0.00)",
        "by 2.341 % (sd 0.0521)",
        "by 12 % (sd 0.4)",
    ] {
        assert!(fault(text).is_some(), "{text}");
    }
    for text in ["252 s (sd 6)", "by 2.34 % (sd 0.05)", "a strain of 0.2", "as t^0.18", "1.23e-9 V (sd < 1e-11)", "100 s (sd 12)"]
    {
        assert_eq!(fault(text), None, "{text}");
    }
}

fn one(id: &str, change: impl Fn(&mut FittedParameter)) -> String {
    let plate = common::Plate::new(Some(false));
    let inputs = common::recording();
    let context = Context::new(&inputs, &plate, 10.0, 0.004);
    let library = library();
    let effect = library.iter().find(|e| e.id().0 == id).unwrap();
    let mut fitted = fitted(effect.as_ref(), &context, 1.0, 0.02);
    change(&mut fitted[0]);
    sentence(effect.as_ref(), &fitted, &context, &[])
}

/// A curve at 797 times the noise was told as "asked for, but its size is less sure than it is large": its other numbers make up for it.
#[test]
fn what_is_plainly_seen_is_told_however_unsure_its_size_is_alone() {
    let plate = common::Plate::new(Some(false));
    let inputs = common::recording();
    let context = Context::new(&inputs, &plate, 10.0, 0.004);
    let library = library();
    let curve = library.iter().find(|e| e.id().0 == "nonlinearity").unwrap();
    let fitted = fitted(curve.as_ref(), &context, 1.0, 1.4);
    assert!(sentence(curve.as_ref(), &fitted, &context, &[]).contains("is asked for, but"));
    let seen = sentence_of_seen(curve.as_ref(), &fitted, &context, &[]);
    assert!(seen.starts_with("the characteristic is bent") && seen.contains("make up for one another"), "{seen}");
}

#[test]
fn a_number_that_cannot_be_is_a_finding_about_the_fit() {
    let about_the_fit = "this says more of the fit than of the instrument";
    let wild = one("ageing", |size| (size.value, size.sd) = (1387.439, 0.04));
    assert!(wild.contains("ran to 1390 for the relative change"), "{wild}");
    assert!(wild.ends_with(about_the_fit), "{wild}");
    let limit = one("readout_lag", |size| (size.value, size.at_limit) = (40.0, true));
    assert!(
        limit.contains("ran to the limit of the time constant of the electronics, 40.0 s") && limit.ends_with(about_the_fit),
        "{limit}"
    );
    let unsure = one("readout_lag", |size| (size.value, size.sd_of_fit) = (0.2, 0.5));
    assert!(unsure.contains("less sure than it is large, 200 ms (sd 500)") && unsure.ends_with(about_the_fit), "{unsure}");
    // what else may act is told beside the number, and is no finding about the fit
    let beside = one("readout_lag", |size| (size.value, size.sd) = (0.2, 0.5));
    assert_eq!(beside, "the electronics follow with a time constant of 200 ms (sd 500)");
    let plain = one("readout_lag", |size| (size.value, size.sd) = (0.2, 0.01));
    assert_eq!(plain, "the electronics follow with a time constant of 200 ms (sd 10)");
    // a hard ceiling is the natural end of a saturation
    assert!(!one("saturation", |size| (size.value, size.at_limit) = (1.0, true)).contains("fit"));
}

/// A slow way may be 60 times as slow as the quick one: nothing strange, although no share is as large.
#[test]
fn a_number_beside_the_size_may_be_large_where_its_prior_has_it() {
    let plate = common::Plate::new(Some(false));
    let inputs = common::recording();
    let context = Context::new(&inputs, &plate, 10.0, 0.004);
    let library = library();
    let slow = library.iter().find(|e| e.id().0 == "slow_response").unwrap();
    let mut fitted = fitted(slow.as_ref(), &context, 1.0, 0.02);
    let slower = fitted.iter_mut().find(|f| f.parameter.name == "slower").unwrap();
    (slower.value, slower.at_limit) = (60.0, false);
    let says = sentence(slow.as_ref(), &fitted, &context, &[]);
    assert!(!says.contains("the fit"), "{says}");
}

/// A load cell beside a straight line was told of a dielectric and of a strain.
#[test]
fn stiffening_is_told_in_words_that_hold_for_any_instrument() {
    let line = common::Line { parameters: vec![Parameter::normal("slope", "V/N", 1.0, 0.1, "slope")] };
    let inputs = common::recording();
    let library = library();
    let effect = library.iter().find(|e| e.id().0 == "strain_stiffening").unwrap();
    let told = |context: &Context<'_>| sentence(effect.as_ref(), &fitted(effect.as_ref(), context, 0.0632, 0.1), context, &[]);
    let beside_a_line = told(&Context::new(&inputs, &line, 3.0, 0.004));
    assert!(!["dielectric", "strain", "plate"].iter().any(|word| beside_a_line.contains(word)), "{beside_a_line}");
    assert!(beside_a_line.contains("more load"), "{beside_a_line}");
    let plate = common::Plate::new(Some(false));
    assert!(told(&Context::new(&inputs, &plate, 10.0, 0.004)).contains("the dielectric stiffens"));
}
