//! Lines and shaded spans that explain a panel.

use super::panel::Panel;
use super::series::Guide;
use super::svg::{Anchor, Area, Svg, text_width};

impl Panel<'_> {
    pub(super) fn draw_span(&self, svg: &mut Svg, area: Area, guide: &Guide) {
        if let Some(place) = self.span(area, guide) {
            svg.rect(place, r#"fill="currentColor" fill-opacity="0.08""#);
        }
    }

    fn span(&self, area: Area, guide: &Guide) -> Option<Area> {
        match guide {
            Guide::SpanX(from, to, _) => {
                let (a, b) = (self.x.at(*from), self.x.at(*to));
                Some(Area { left: a.min(b), top: 0.0, width: (b - a).abs(), height: area.height })
            }
            Guide::SpanY(from, to, _) => {
                let (a, b) = (self.y.at(*from), self.y.at(*to));
                Some(Area { left: 0.0, top: a.min(b), width: area.width, height: (b - a).abs() })
            }
            _ => None,
        }
    }

    pub(super) fn draw_guide(&self, svg: &mut Svg, area: Area, guide: &Guide) {
        let style = r#"stroke="currentColor" stroke-opacity="0.7" stroke-dasharray="2 3""#;
        match guide {
            Guide::AtX(at, label) => {
                let x = self.x.at(*at);
                svg.line((x, 0.0), (x, area.height), style);
                let near_end = x + text_width(label, 11.0) + 8.0 > area.width;
                let (x, anchor) = if near_end { (x - 4.0, Anchor::End) } else { (x + 4.0, Anchor::Start) };
                svg.note(x, 14.0, anchor, label);
            }
            Guide::AtY(at, label) => {
                let y = self.y.at(*at);
                svg.line((0.0, y), (area.width, y), style);
                svg.note(area.width - 6.0, if y < 18.0 { y + 13.0 } else { y - 5.0 }, Anchor::End, label);
            }
            Guide::SpanX(_, _, label) | Guide::SpanY(_, _, label) => {
                if let Some(place) = self.span(area, guide) {
                    svg.note(place.left.max(0.0) + 5.0, place.top.max(0.0) + 14.0, Anchor::Start, label);
                }
            }
        }
    }
}
