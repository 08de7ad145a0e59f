//! A string that SVG elements are written to.
//!
//! Colours are presentation attributes (any viewer shows them) with a class beside them, so that the page's style sheet can
//! restyle them for dark screens. Text widths are estimated from DejaVu Sans, one of the widest fonts a viewer may fall back to.

use std::fmt::Write;

/// Width of every figure in user units (CSS pixels at natural size).
pub(super) const WIDTH: f64 = 760.0;
/// Size of ordinary text.
pub(super) const TEXT: f64 = 12.0;
/// Size of titles.
pub(super) const TITLE: f64 = 14.5;

/// Where a text sits relative to its point.
#[derive(Debug, Clone, Copy)]
pub(super) enum Anchor {
    Start,
    Middle,
    End,
}

/// A rectangle in user units.
#[derive(Debug, Clone, Copy)]
pub(super) struct Area {
    pub left: f64,
    pub top: f64,
    pub width: f64,
    pub height: f64,
}

impl Area {
    pub fn right(self) -> f64 {
        self.left + self.width
    }
    pub fn bottom(self) -> f64 {
        self.top + self.height
    }
}

/// Elements written so far.
#[derive(Debug, Default)]
pub(super) struct Svg {
    body: String,
}

impl Svg {
    /// Appends ready markup.
    pub fn raw(&mut self, markup: &str) {
        self.body.push_str(markup);
    }

    pub fn text(&mut self, x: f64, y: f64, anchor: Anchor, text: &str) {
        self.styled_text(x, y, anchor, text, "");
    }

    /// Text with further attributes, written as they stand.
    pub fn styled_text(&mut self, x: f64, y: f64, anchor: Anchor, text: &str, attributes: &str) {
        let anchor = match anchor {
            Anchor::Start => "start",
            Anchor::Middle => "middle",
            Anchor::End => "end",
        };
        let _ = writeln!(
            self.body,
            r#"<text x="{}" y="{}" text-anchor="{anchor}" {attributes}>{}</text>"#,
            px(x),
            px(y),
            escape(text)
        );
    }

    /// Small text inside a plot, with a halo that keeps it readable over data.
    pub fn note(&mut self, x: f64, y: f64, anchor: Anchor, text: &str) {
        if !text.is_empty() {
            let halo = r##"class="tg-halo" font-size="11" stroke="#ffffff" stroke-width="3" stroke-linejoin="round" paint-order="stroke""##;
            self.styled_text(x, y, anchor, text, halo);
        }
    }

    pub fn line(&mut self, from: (f64, f64), to: (f64, f64), attributes: &str) {
        let _ = writeln!(
            self.body,
            r#"<line x1="{}" y1="{}" x2="{}" y2="{}" {attributes}/>"#,
            px(from.0),
            px(from.1),
            px(to.0),
            px(to.1)
        );
    }

    pub fn rect(&mut self, area: Area, attributes: &str) {
        let _ = writeln!(
            self.body,
            r#"<rect x="{}" y="{}" width="{}" height="{}" {attributes}/>"#,
            px(area.left),
            px(area.top),
            px(area.width),
            px(area.height)
        );
    }

    /// A path that a pointer names by `hint`.
    pub fn path(&mut self, data: &str, hint: &str, attributes: &str) {
        if !data.is_empty() {
            let _ = writeln!(self.body, r#"<path d="{data}" {attributes}><title>{}</title></path>"#, escape(hint));
        }
    }

    /// Opens a window that clips; coordinates inside are relative to its corner.
    pub fn open_window(&mut self, area: Area) {
        let _ = writeln!(
            self.body,
            r#"<svg x="{}" y="{}" width="{}" height="{}" overflow="hidden">"#,
            px(area.left),
            px(area.top),
            px(area.width),
            px(area.height)
        );
    }

    /// Opens a group with attributes, written as they stand.
    pub fn open_group(&mut self, attributes: &str) {
        let _ = writeln!(self.body, "<g {attributes}>");
    }

    pub fn close_group(&mut self) {
        self.body.push_str("</g>\n");
    }

    pub fn close_window(&mut self) {
        self.body.push_str("</svg>\n");
    }

    /// The title line of a figure; returns the height it takes.
    pub fn heading(&mut self, title: &str) -> f64 {
        if title.is_empty() {
            return 8.0;
        }
        let attributes = format!(r#"font-size="{TITLE}" font-weight="600""#);
        self.styled_text(10.0, 21.0, Anchor::Start, title, &attributes);
        30.0
    }

    /// The finished document of the given height.
    pub fn finish(self, title: &str, height: f64) -> String {
        let title = escape(title);
        let (width, height) = (px(WIDTH), px(height));
        format!(
            concat!(
                r##"<svg xmlns="http://www.w3.org/2000/svg" class="tg-figure" viewBox="0 0 {width} {height}" "##,
                r##"width="{width}" height="{height}" role="img" aria-label="{title}" color="#1b1f24" fill="currentColor" "##,
                r##"font-family="system-ui, 'Segoe UI', Roboto, Helvetica, Arial, 'DejaVu Sans', sans-serif" font-size="{text}">"##,
                "\n<title>{title}</title>\n",
                r##"<rect class="tg-paper" width="{width}" height="{height}" fill="#ffffff"/>"##,
                "\n{body}</svg>\n"
            ),
            width = width,
            height = height,
            title = title,
            text = TEXT,
            body = self.body
        )
    }
}

/// A coordinate with at most two decimals and no trailing zeros.
pub(super) fn px(value: f64) -> String {
    let text = format!("{value:.2}");
    let text = text.trim_end_matches('0').trim_end_matches('.');
    if text == "-0" { "0".into() } else { text.into() }
}

/// Text as element or attribute content.
pub(super) fn escape(text: &str) -> String {
    crate::page::escape(text)
}

/// Estimated width of `text` at font size `size`.
pub(super) fn text_width(text: &str, size: f64) -> f64 {
    let ems: f64 = text
        .chars()
        .map(|c| match c {
            'i' | 'j' | 'l' | '|' | '\'' | '.' | ',' | ':' | ';' | '!' | ' ' | 'I' => 0.33,
            'f' | 't' | 'r' | '(' | ')' | '[' | ']' | '-' | '/' => 0.42,
            'm' | 'w' | 'M' | 'W' | '%' | '@' => 0.93,
            'A'..='Z' => 0.70,
            '⁰'..='⁹' | '¹' | '²' | '³' | '⁻' => 0.40,
            '\u{2212}' => 0.8,
            _ => 0.61,
        })
        .sum();
    ems * size
}

/// `text`, cut with an ellipsis where it is wider than `room`.
pub(super) fn fit(text: &str, size: f64, room: f64) -> String {
    if text_width(text, size) <= room {
        return text.to_owned();
    }
    let mut short = String::new();
    for c in text.chars() {
        if text_width(&short, size) + size * 1.6 > room {
            break;
        }
        short.push(c);
    }
    format!("{}…", short.trim_end())
}
