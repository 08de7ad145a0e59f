//! Drawing of [`HeatMap`]: cells of one colour share a path, neighbours of one colour share a stroke.

use super::error::FigureError;
use super::heat::{HeatMap, Spans};
use super::scale::Scale;
use super::svg::{Anchor, Area, Svg, TEXT, WIDTH, escape, px, text_width};
use super::ticks::Ticks;

/// Colours told apart in the plane.
const LEVELS: usize = 96;
/// Cells that a pointer can tell apart.
const TOLD: usize = 2500;
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
    svg.open_group(&told_to_pointers(map, area));
    let missing = cells(&mut svg, map, area, (&x, &y), (low, high));
    svg.close_group();
    svg.rect(area, r#"fill="none" stroke="currentColor" stroke-opacity="0.55""#);
    y_axis(&mut svg, area, &y, &y_ticks, &y_ticks.title(&map.y.0, &map.y.1));
    x_axis(&mut svg, area, &x, &map.x);
    let bar = Area { left: area.right() + 34.0, top, width: 14.0, height: map.height };
    colour_bar(&mut svg, bar, map, spans);
    if missing {
        let style = r#"font-size="10.5" opacity="0.8""#;
        svg.styled_text(area.right(), area.bottom() + 36.0, Anchor::End, "grey: no value", style);
    }
    svg.finish(&map.title, area.bottom() + 46.0)
}

/// Edges and values for the script of a page; of maps finer than a pointer nothing.
fn told_to_pointers(map: &HeatMap, area: Area) -> String {
    if map.cells.len() > TOLD {
        return r#"class="tg-cells""#.into();
    }
    let place = [area.left, area.top, area.width, area.height].map(px).join(" ");
    let number = |v: &f64| if v.is_finite() { format!("{v:.4e}") } else { "-".into() };
    let numbers = |values: &[f64]| values.iter().map(number).collect::<Vec<_>>().join(" ");
    let name =
        |(label, unit): &(String, String)| escape(&if unit.is_empty() { label.clone() } else { format!("{label} ({unit})") });
    format!(
        r#"class="tg-cells" data-area="{place}" data-x="{}" data-y="{}" data-cells="{}" data-x-name="{}" data-y-name="{}" data-name="{}""#,
        numbers(&map.x_edges),
        numbers(&map.y_edges),
        numbers(&map.cells),
        name(&map.x),
        name(&map.y),
        name(&map.value)
    )
}

fn cells(svg: &mut Svg, map: &HeatMap, area: Area, (x, y): (&Scale, &Scale), (low, high): (f64, f64)) -> bool {
    let columns = map.x_edges.len() - 1;
    let mut paths = vec![String::new(); LEVELS + 1];
    let level = |v: f64| {
        if v.is_finite() { (map.place(v, (low, high)).clamp(0.0, 1.0) * (LEVELS - 1) as f64).round() as usize } else { LEVELS }
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
fn colour_bar(svg: &mut Svg, area: Area, map: &HeatMap, spans: &Spans) {
    let slice = area.height / LEVELS as f64;
    for n in 0..LEVELS {
        let part = Area { top: area.bottom() - slice * (n + 1) as f64, height: slice + 0.3, ..area };
        let colour = map.map.at(n as f64 / (LEVELS - 1) as f64).css();
        svg.rect(part, &format!(r#"fill="{colour}" shape-rendering="crispEdges""#));
    }
    svg.rect(area, r#"fill="none" stroke="currentColor" stroke-opacity="0.55""#);
    let (low, high) = spans.colours;
    let scale = Scale { low, high, log: false, pixels: area.height, flipped: true };
    let ticks = Ticks::new(&scale, (area.height / 36.0) as usize);
    let title = ticks.title(&map.value.0, &map.value.1);
    let marks = if map.bend.is_some() { bent_marks(map, spans.colours) } else { ticks.major };
    for (value, text) in &marks {
        let y = area.bottom() - area.height * map.place(*value, spans.colours);
        svg.text(area.right() + 5.0, y + 4.0, Anchor::Start, text);
    }
    beyond(svg, area, spans);
    let (x, y) = (area.left - 8.0, area.top + area.height / 2.0);
    svg.styled_text(x, y, Anchor::Middle, &title, &format!(r#"transform="rotate(-90 {} {})""#, px(x), px(y)));
}

/// Zero, the unit of the bend and 10, 30, 100, ... beyond it, on both sides.
fn bent_marks(map: &HeatMap, (low, high): (f64, f64)) -> Vec<(f64, String)> {
    let unit = map.bend.unwrap_or(1.0);
    let steps = (0..12).flat_map(|k| [1.0, 3.0].map(|m| m * 10f64.powi(k))).filter(|v| *v > 1.5 * unit);
    let sizes: Vec<f64> = [unit].into_iter().chain(steps).collect();
    let both = sizes.iter().flat_map(|v| [-v, *v]).chain([0.0]);
    let label = |v: f64| if v < 0.0 { format!("\u{2212}{}", -v) } else { v.to_string() };
    both.filter(|v| (low..=high).contains(v)).map(|v| (v, label(v))).collect()
}

/// Arrows where the data go beyond the colours, and how far.
fn beyond(svg: &mut Svg, area: Area, spans: &Spans) {
    let ((low, high), (least, largest)) = (spans.colours, spans.values);
    let (small, middle) = (r#"font-size="10""#, area.left + area.width / 2.0);
    let told = |v: f64| if v.abs() < 10.0 { format!("{v:.2}") } else { format!("{v:.0}") }.replace('-', "\u{2212}");
    if largest > high {
        svg.styled_text(middle, (area.top - 9.0).max(9.0), Anchor::Middle, &format!("▲ beyond, to {}", told(largest)), small);
    }
    if least < low {
        svg.styled_text(middle, area.bottom() + 17.0, Anchor::Middle, &format!("▼ beyond, to {}", told(least)), small);
    }
}
