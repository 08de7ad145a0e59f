//! The command as it was typed, for the record.
//!
//! Limits: bytes that are not UTF-8 become U+FFFD, as a record is text.

/// `truegap` and its arguments; what holds more than letters, digits and plain signs stands in quotes.
pub fn command_line() -> String {
    let words = std::env::args_os().skip(1).map(|word| quoted(word.to_string_lossy().into_owned()));
    std::iter::once("truegap".to_owned()).chain(words).collect::<Vec<_>>().join(" ")
}

fn quoted(word: String) -> String {
    if word.contains(char::is_whitespace) { format!("\"{word}\"") } else { word }
}
