//! Figures above one another with one x axis: load, temperature, response, residual.

use super::chart::Figure;
use super::error::FigureError;
use super::legend;
use super::panel::{self, Panel, XAxis};
use super::series::colours;
use super::svg::{Anchor, Svg};

const BETWEEN: f64 = 16.0;

/// Panels that share the x axis of the first; colours and legend are common to all.
#[derive(Debug, Clone, PartialEq)]
pub struct Stack {
    title: String,
    panels: Vec<Figure>,
}

impl Stack {
    /// An empty stack; an empty title draws none.
    pub fn new(title: &str) -> Self {
        Self { title: title.into(), panels: Vec::new() }
    }

    /// Adds a panel below; its own title, if any, stands above it.
    pub fn panel(mut self, figure: Figure) -> Self {
        self.panels.push(figure);
        self
    }

    /// Draws all panels.
    ///
    /// # Errors
    /// As [`Figure::to_svg`]; a stack without panel is empty.
    pub fn to_svg(&self) -> Result<String, FigureError> {
        let figures: Vec<&Figure> = self.panels.iter().collect();
        if figures.is_empty() {
            return Err(FigureError::Empty { figure: self.title.clone(), axis: "x" });
        }
        let x_range = panel::x_range(&figures)?;
        let panels = figures.iter().map(|f| Panel::with_x(f, &figures[0].x, x_range)).collect::<Result<Vec<_>, _>>()?;
        let left = panels.iter().map(Panel::left_margin).fold(0.0, f64::max);
        let all = || figures.iter().flat_map(|f| f.series.iter());
        let colours = colours(all());
        let mut svg = Svg::default();
        let mut top = svg.heading(&self.title);
        top += legend::draw(&mut svg, left, top, all(), &colours) + 8.0;
        let last = panels.len() - 1;
        for (i, panel) in panels.into_iter().enumerate() {
            let figure = figures[i];
            if !figure.title.is_empty() {
                svg.styled_text(left, top + 9.0, Anchor::Start, &figure.title, r#"font-weight="600""#);
                top += 16.0;
            }
            let area = panel::plot_area(left, top, figure.height);
            panel.draw(&mut svg, area, &colours, if i == last { XAxis::Labelled } else { XAxis::Bare });
            top = area.bottom() + BETWEEN;
        }
        Ok(svg.finish(&self.title, top - BETWEEN + panel::X_AXIS_HEIGHT))
    }
}
