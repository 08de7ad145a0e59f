//! Bytes of a cell as text: UTF-8, else Windows-1252.
//!
//! Limits: one cell at a time; nothing tells Windows-1252 from another set of 256 signs, so whoever asks should say what was read.

use std::borrow::Cow;

/// Text of a cell, and whether it was no UTF-8 and read as Windows-1252.
pub(super) fn text(cell: &[u8]) -> (Cow<'_, str>, bool) {
    match std::str::from_utf8(cell) {
        Ok(text) => (Cow::Borrowed(text), false),
        Err(_) => (encoding_rs::WINDOWS_1252.decode_without_bom_handling(cell).0, true),
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn what_is_no_utf8_is_windows_1252() {
        assert_eq!(text("Kapazität [°C]".as_bytes()), ("Kapazität [°C]".into(), false));
        assert_eq!(text(b"Kapazit\xe4t [\xb0C]"), ("Kapazität [°C]".into(), true));
        // the sign at 0x80 is where Windows-1252 and Latin-1 differ
        assert_eq!(text(b"price [\x80]"), ("price [€]".into(), true));
    }
}
