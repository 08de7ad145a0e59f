//! Drawing of [`Panel`]: grid, guides, series, axes.

use super::panel::{Panel, XAxis};
use super::series::{Mark, Series, colour_of};
use super::svg::{Anchor, Area, Svg, px};
use super::ticks::Ticks;
use crate::colour::Rgb;

impl Panel<'_> {
    /// Draws the panel into `area`, over its whole width.
    pub fn draw(mut self, svg: &mut Svg, area: Area, colours: &[(String, Rgb)], x_axis: XAxis) {
        self.x.pixels = area.width;
        let x_ticks = Ticks::new(&self.x, (area.width / 95.0) as usize);
        self.draw_grid(svg, area, &x_ticks);
        svg.open_window(area);
        self.figure.guides.iter().for_each(|guide| self.draw_span(svg, area, guide));
        // Bands first: they must not cover lines.
        let is_band = |s: &&Series| matches!(s.mark, Mark::Band { .. });
        for series in self.figure.series.iter().filter(is_band) {
            self.draw_band(svg, series, &colour_of(colours, &series.label).css());
        }
        for series in self.figure.series.iter().filter(|s| !is_band(s)) {
            self.draw_series(svg, series, &colour_of(colours, &series.label).css());
        }
        self.figure.guides.iter().for_each(|guide| self.draw_guide(svg, area, guide));
        svg.close_window();
        svg.rect(area, r#"fill="none" stroke="currentColor" stroke-opacity="0.55""#);
        self.draw_y_axis(svg, area);
        if x_axis == XAxis::Labelled {
            self.draw_x_axis(svg, area, &x_ticks);
        }
    }

    fn draw_grid(&self, svg: &mut Svg, area: Area, x_ticks: &Ticks) {
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
    }

    fn draw_y_axis(&self, svg: &mut Svg, area: Area) {
        for (value, label) in &self.y_ticks.major {
            svg.text(area.left - 7.0, area.top + self.y.at(*value) + 4.0, Anchor::End, label);
        }
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
        for (value, label) in &ticks.major {
            svg.text(area.left + self.x.at(*value), area.bottom() + 17.0, Anchor::Middle, label);
        }
        let title = ticks.title(&self.x_axis.label, &self.x_axis.unit);
        svg.text(area.left + area.width / 2.0, area.bottom() + 36.0, Anchor::Middle, &title);
    }
}
