//! Drawing of [`Panel`]: grid, guides, series, axes.

use super::chart::Axis;
use super::panel::{Panel, XAxis};
use super::scale::Scale;
use super::series::{Mark, Series, colour_of};
use super::svg::{Anchor, Area, Svg, escape, px};
use super::ticks::{Counts, Ticks};
use crate::colour::Rgb;

impl Panel<'_> {
    /// Draws the panel into `area`, over its whole width.
    pub fn draw(mut self, svg: &mut Svg, area: Area, colours: &[(String, Rgb)], x_axis: XAxis) {
        self.x.pixels = area.width;
        let x_ticks = Ticks::new(&self.x, (area.width / 95.0) as usize);
        svg.open_group(&self.told_to_pointers(area, &x_ticks, x_axis));
        self.draw_grid(svg, area, &x_ticks);
        svg.open_window(area);
        self.draw_data(svg, area, colours);
        self.draw_guides(svg, area);
        svg.close_window();
        svg.rect(area, r#"fill="none" stroke="currentColor" stroke-opacity="0.55""#);
        self.draw_y_axis(svg, area);
        if x_axis == XAxis::Labelled {
            self.draw_x_axis(svg, area, &x_ticks);
        }
        svg.close_group();
    }

    /// Attributes from which the script of a page makes values out of pixels.
    fn told_to_pointers(&self, area: Area, x_ticks: &Ticks, x_axis: XAxis) -> String {
        let place = [area.left, area.top, area.width, area.height].map(px).join(" ");
        let axis = |name: &str, scale: &Scale, ticks: &Ticks, axis: &Axis| {
            let Counts { times, from } = ticks.counts;
            let numbers = format!("{:e} {:e} {} {times:e} {from:e}", scale.low, scale.high, u8::from(scale.log));
            let (label, unit) = (escape(&axis.label), escape(&axis.unit));
            format!(r#" data-{name}="{numbers}" data-{name}-name="{label}" data-{name}-unit="{unit}""#)
        };
        let x = axis("x", &self.x, x_ticks, self.x_axis);
        let y = axis("y", &self.y, &self.y_ticks, &self.figure.y);
        let labelled = if x_axis == XAxis::Labelled { " data-labelled=\"\"" } else { "" };
        format!(r#"class="tg-panel" data-area="{place}"{x}{y}{labelled}"#)
    }

    /// Bands first: they must not cover lines.
    fn draw_data(&self, svg: &mut Svg, area: Area, colours: &[(String, Rgb)]) {
        svg.open_group(r#"class="tg-data""#);
        self.figure.guides.iter().for_each(|guide| self.draw_span(svg, area, guide));
        let is_band = |s: &&Series| matches!(s.mark, Mark::Band { .. });
        for series in self.figure.series.iter().filter(is_band) {
            self.draw_band(svg, series, &colour_of(colours, &series.label).css());
        }
        for series in self.figure.series.iter().filter(|s| !is_band(s)) {
            self.draw_series(svg, series, &colour_of(colours, &series.label).css());
        }
        svg.close_group();
    }

    fn draw_guides(&self, svg: &mut Svg, area: Area) {
        svg.open_group(r#"class="tg-guides""#);
        self.figure.guides.iter().for_each(|guide| self.draw_guide(svg, area, guide));
        svg.close_group();
    }

    fn draw_grid(&self, svg: &mut Svg, area: Area, x_ticks: &Ticks) {
        svg.open_group(r#"class="tg-grid""#);
        let mut strokes = String::new();
        for (value, _) in &x_ticks.major {
            strokes += &format!("M{} {}v{}", px(area.left + self.x.at(*value)), px(area.top), px(area.height));
        }
        for (value, _) in &self.y_ticks.major {
            strokes += &format!("M{} {}h{}", px(area.left), px(area.top + self.y.at(*value)), px(area.width));
        }
        svg.raw(&format!("<path d=\"{strokes}\" stroke=\"currentColor\" stroke-opacity=\"0.12\" fill=\"none\"/>\n"));
        let mut small = String::new();
        for value in &x_ticks.minor {
            small += &format!("M{} {}v-4", px(area.left + self.x.at(*value)), px(area.bottom()));
        }
        for value in &self.y_ticks.minor {
            small += &format!("M{} {}h4", px(area.left), px(area.top + self.y.at(*value)));
        }
        if !small.is_empty() {
            svg.raw(&format!("<path d=\"{small}\" stroke=\"currentColor\" stroke-opacity=\"0.45\" fill=\"none\"/>\n"));
        }
        svg.close_group();
    }

    fn draw_y_axis(&self, svg: &mut Svg, area: Area) {
        svg.open_group(r#"class="tg-ticks""#);
        for (value, label) in &self.y_ticks.major {
            svg.text(area.left - 7.0, area.top + self.y.at(*value) + 4.0, Anchor::End, label);
        }
        svg.close_group();
        let axis = &self.figure.y;
        let (x, y) = (15.0, area.top + area.height / 2.0);
        let turn = format!(r#"transform="rotate(-90 {} {})""#, px(x), px(y));
        svg.styled_text(x, y, Anchor::Middle, &self.y_ticks.title(&axis.label, &axis.unit), &turn);
        if self.not_drawn > 0 {
            let note = format!("{} values ≤ 0 not drawn (logarithmic axis)", self.not_drawn);
            let style = r#"font-size="10.5" opacity="0.75""#;
            svg.styled_text(area.right() - 6.0, area.top + 14.0, Anchor::End, &note, style);
        }
    }

    fn draw_x_axis(&self, svg: &mut Svg, area: Area, ticks: &Ticks) {
        svg.open_group(r#"class="tg-ticks""#);
        for (value, label) in &ticks.major {
            svg.text(area.left + self.x.at(*value), area.bottom() + 17.0, Anchor::Middle, label);
        }
        svg.close_group();
        let title = ticks.title(&self.x_axis.label, &self.x_axis.unit);
        svg.text(area.left + area.width / 2.0, area.bottom() + 36.0, Anchor::Middle, &title);
    }
}
