//! Drawing of [`HeatMap`]: cells of one colour share a path, neighbours of one colour share a stroke.

use super::error::FigureError;
use super::heat::{HeatMap, Spans};
use super::scale::Scale;
use super::svg::{Anchor, Area, Svg, TEXT, WIDTH, px, text_width};
use super::ticks::Ticks;
use crate::colour::ColourMap;

/// Colours told apart in the plane.
const LEVELS: usize = 96;
const NO_VALUE: &str = r##"fill="#b9b9b9" fill-opacity="0.6""##;

impl HeatMap {
    /// Draws the map.
    ///
    /// # Errors
    /// Edges that do not rise, a number of cells that does not fit the edges, no finite value, an empty value range.
    pub fn to_svg(&self) -> Result<String, FigureError> {
        Ok(draw(self, &self.checked()?))
    }
}

fn draw(map: &HeatMap, spans: &Spans) -> String {
    let (low, high) = spans.colours;
    let mut svg = Svg::default();
    let top = svg.heading(&map.title) + 4.0;
    let axis =
        |edges: &[f64], pixels, flipped| Scale { low: edges[0], high: edges[edges.len() - 1], log: false, pixels, flipped };
    let y = axis(&map.y_edges, map.height, true);
    let y_ticks = Ticks::new(&y, (map.height / 36.0) as usize);
    let widest = y_ticks.major.iter().map(|(_, l)| text_width(l, TEXT)).fold(0.0, f64::max);
    let area = Area { left: widest + 38.0, top, width: WIDTH - widest - 38.0 - 112.0, height: map.height };
    let x = axis(&map.x_edges, area.width, false);
    let missing = cells(&mut svg, map, area, (&x, &y), (low, high));
    svg.rect(area, r#"fill="none" stroke="currentColor" stroke-opacity="0.55""#);
    y_axis(&mut svg, area, &y, &y_ticks, &y_ticks.title(&map.y.0, &map.y.1));
    x_axis(&mut svg, area, &x, &map.x);
    let bar = Area { left: area.right() + 34.0, top, width: 14.0, height: map.height };
    colour_bar(&mut svg, bar, map.map, (low, high), spans.values, &map.value);
    if missing {
        let style = r#"font-size="10.5" opacity="0.8""#;
        svg.styled_text(area.right(), area.bottom() + 36.0, Anchor::End, "grey: no value", style);
    }
    svg.finish(&map.title, area.bottom() + 46.0)
}

fn cells(svg: &mut Svg, map: &HeatMap, area: Area, (x, y): (&Scale, &Scale), (low, high): (f64, f64)) -> bool {
    let columns = map.x_edges.len() - 1;
    let mut paths = vec![String::new(); LEVELS + 1];
    let level = |v: f64| {
        if v.is_finite() { (((v - low) / (high - low)).clamp(0.0, 1.0) * (LEVELS - 1) as f64).round() as usize } else { LEVELS }
    };
    for (j, row) in map.cells.chunks(columns).enumerate() {
        let (bottom, top) = (y.at(map.y_edges[j]), y.at(map.y_edges[j + 1]));
        let mut start = 0;
        for i in 1..=columns {
            if i < columns && level(row[i]) == level(row[start]) {
                continue;
            }
            let (left, right) = (x.at(map.x_edges[start]), x.at(map.x_edges[i]));
            paths[level(row[start])] +=
                &format!("M{} {}h{}v{}h{}z", px(left), px(top), px(right - left), px(bottom - top), px(left - right));
            start = i;
        }
    }
    svg.open_window(area);
    svg.raw("<g shape-rendering=\"crispEdges\">\n");
    for (n, data) in paths.iter().enumerate().filter(|(_, data)| !data.is_empty()) {
        let fill = format!(r#"fill="{}""#, map.map.at(n as f64 / (LEVELS - 1) as f64).css());
        svg.raw(&format!("<path d=\"{data}\" {}/>\n", if n == LEVELS { NO_VALUE } else { &fill }));
    }
    svg.raw("</g>\n");
    svg.close_window();
    !paths[LEVELS].is_empty()
}

fn y_axis(svg: &mut Svg, area: Area, y: &Scale, ticks: &Ticks, title: &str) {
    for (value, label) in &ticks.major {
        let at = area.top + y.at(*value);
        svg.line((area.left - 4.0, at), (area.left, at), r#"stroke="currentColor" stroke-opacity="0.55""#);
        svg.text(area.left - 7.0, at + 4.0, Anchor::End, label);
    }
    let (x, y) = (15.0, area.top + area.height / 2.0);
    svg.styled_text(x, y, Anchor::Middle, title, &format!(r#"transform="rotate(-90 {} {})""#, px(x), px(y)));
}

fn x_axis(svg: &mut Svg, area: Area, x: &Scale, (label, unit): &(String, String)) {
    let ticks = Ticks::new(x, (area.width / 95.0) as usize);
    for (value, text) in &ticks.major {
        let at = area.left + x.at(*value);
        svg.line((at, area.bottom()), (at, area.bottom() + 4.0), r#"stroke="currentColor" stroke-opacity="0.55""#);
        svg.text(at, area.bottom() + 17.0, Anchor::Middle, text);
    }
    svg.text(area.left + area.width / 2.0, area.bottom() + 36.0, Anchor::Middle, &ticks.title(label, unit));
}

/// A vertical colour bar with ticks on its right and its title along it.
fn colour_bar(
    svg: &mut Svg,
    area: Area,
    map: ColourMap,
    (low, high): (f64, f64),
    found: (f64, f64),
    (label, unit): &(String, String),
) {
    let slice = area.height / LEVELS as f64;
    for n in 0..LEVELS {
        let part = Area { top: area.bottom() - slice * (n + 1) as f64, height: slice + 0.3, ..area };
        let colour = map.at(n as f64 / (LEVELS - 1) as f64).css();
        svg.rect(part, &format!(r#"fill="{colour}" shape-rendering="crispEdges""#));
    }
    svg.rect(area, r#"fill="none" stroke="currentColor" stroke-opacity="0.55""#);
    let scale = Scale { low, high, log: false, pixels: area.height, flipped: true };
    let ticks = Ticks::new(&scale, (area.height / 36.0) as usize);
    for (value, text) in &ticks.major {
        svg.text(area.right() + 5.0, area.top + scale.at(*value) + 4.0, Anchor::Start, text);
    }
    // Arrows where the data go beyond the colours.
    let small = r#"font-size="10""#;
    let middle = area.left + area.width / 2.0;
    if found.1 > high {
        svg.styled_text(middle, area.top - 2.0, Anchor::Middle, "▲", small);
    }
    if found.0 < low {
        svg.styled_text(middle, area.bottom() + 10.0, Anchor::Middle, "▼", small);
    }
    let (x, y) = (area.left - 8.0, area.top + area.height / 2.0);
    let turn = format!(r#"transform="rotate(-90 {} {})""#, px(x), px(y));
    svg.styled_text(x, y, Anchor::Middle, &ticks.title(label, unit), &turn);
}
