//! Text as HTML and XML want it.

/// `text` with the characters that mean something to HTML and XML replaced; control characters that XML forbids become `�`.
pub fn escape(text: &str) -> String {
    let mut out = String::with_capacity(text.len());
    for c in text.chars() {
        match c {
            '&' => out.push_str("&amp;"),
            '<' => out.push_str("&lt;"),
            '>' => out.push_str("&gt;"),
            '"' => out.push_str("&quot;"),
            '\'' => out.push_str("&#39;"),
            '\t' | '\n' | '\r' => out.push(c),
            c if c.is_control() => out.push('\u{FFFD}'),
            c => out.push(c),
        }
    }
    out
}

/// A sentence as HTML: no line begins with the `%`, `°C` or `±` of a number, or ends with its `>`.
pub(super) fn sentence(text: &str) -> String {
    let letters: Vec<char> = text.chars().collect();
    let bound = |at: usize| {
        let [Some(before), Some(after)] = [at.checked_sub(1).and_then(|at| letters.get(at)), letters.get(at + 1)] else {
            return false;
        };
        (before.is_ascii_digit() && matches!(after, '%' | '°' | '±'))
            || (matches!(before, '>' | '<' | '±') && after.is_ascii_digit())
    };
    let kept = letters.iter().enumerate().map(|(at, c)| if *c == ' ' && bound(at) { '\u{a0}' } else { *c });
    escape(&kept.collect::<String>())
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_number_stays_with_its_sign_on_one_line() {
        let (said, kept) = ("p > 99.9 % at 1.2 ± 0.3 °C", "p &gt;\u{a0}99.9\u{a0}% at 1.2\u{a0}±\u{a0}0.3\u{a0}°C");
        assert_eq!(sentence(said), kept);
        assert_eq!(sentence(" % of 5 or < more "), " % of 5 or &lt; more ");
    }
}
