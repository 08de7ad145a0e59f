//! Legend rows above a plot: never over the data.

use super::series::{Mark, Series, colour_of};
use super::svg::{Anchor, Area, Svg, TEXT, WIDTH, text_width};
use crate::colour::Rgb;

const KEY: f64 = 22.0;
const ROW: f64 = 19.0;

/// One entry: the marks that share a label.
struct Entry<'a> {
    label: &'a str,
    marks: Vec<&'a Mark>,
    colour: Rgb,
}

/// Draws the legend of `series` from height `top` down; returns the height it took (zero where there is nothing to tell).
pub(super) fn draw<'a>(
    svg: &mut Svg,
    left: f64,
    top: f64,
    series: impl Iterator<Item = &'a Series>,
    colours: &[(String, Rgb)],
) -> f64 {
    let entries = entries(series, colours);
    if entries.is_empty() {
        return 0.0;
    }
    let (mut x, mut y) = (left, top + 10.0);
    for entry in &entries {
        let width = KEY + 6.0 + text_width(entry.label, TEXT) + 16.0;
        if x > left && x + width > WIDTH - 8.0 {
            (x, y) = (left, y + ROW);
        }
        for mark in &entry.marks {
            key(svg, x, y, mark, &entry.colour.css());
        }
        svg.text(x + KEY + 6.0, y + 4.0, Anchor::Start, entry.label);
        x += width;
    }
    y - top + ROW * 0.5 + 4.0
}

fn entries<'a>(series: impl Iterator<Item = &'a Series>, colours: &[(String, Rgb)]) -> Vec<Entry<'a>> {
    let mut entries: Vec<Entry> = Vec::new();
    for one in series.filter(|s| !s.label.is_empty()) {
        match entries.iter_mut().find(|e| e.label == one.label) {
            Some(entry) if entry.marks.contains(&&one.mark) => {}
            Some(entry) => entry.marks.push(&one.mark),
            None => entries.push(Entry { label: &one.label, marks: vec![&one.mark], colour: colour_of(colours, &one.label) }),
        }
    }
    entries
}

fn key(svg: &mut Svg, x: f64, y: f64, mark: &Mark, colour: &str) {
    let middle = x + KEY / 2.0;
    match mark {
        Mark::Line { dashed } => {
            let dash = if *dashed { r#" stroke-dasharray="6 4""# } else { "" };
            svg.line((x, y), (x + KEY, y), &format!(r#"stroke="{colour}" stroke-width="2"{dash}"#));
        }
        Mark::Steps => svg.raw(&format!(
            "<path d=\"M{} {}h{}v-6h{}\" fill=\"none\" stroke=\"{colour}\" stroke-width=\"2\"/>\n",
            x,
            y + 3.0,
            KEY / 2.0,
            KEY / 2.0
        )),
        Mark::Points => {
            svg.raw(&format!("<circle cx=\"{middle}\" cy=\"{y}\" r=\"3\" fill=\"{colour}\"/>\n"));
        }
        Mark::Band { .. } => {
            let area = Area { left: x, top: y - 5.0, width: KEY, height: 10.0 };
            svg.rect(area, &format!(r#"fill="{colour}" fill-opacity="0.22""#));
        }
        Mark::Errors { .. } => {
            svg.raw(&format!("<circle cx=\"{middle}\" cy=\"{y}\" r=\"3\" fill=\"{colour}\"/>\n"));
            svg.line((middle, y - 6.0), (middle, y + 6.0), &format!(r#"stroke="{colour}" stroke-width="1.5""#));
        }
    }
}
