//! Drawing of [`Figure`]: heading, legend, one panel.

use super::chart::Figure;
use super::error::FigureError;
use super::legend;
use super::panel::{Panel, X_AXIS_HEIGHT, XAxis, plot_area};
use super::series::colours;
use super::svg::Svg;

impl Figure {
    /// Draws the figure.
    ///
    /// # Errors
    /// Arrays of different length, an axis without a finite value, an empty range, a band whose x falls.
    pub fn to_svg(&self) -> Result<String, FigureError> {
        let panel = Panel::new(self)?;
        let colours = colours(self.series.iter());
        let mut svg = Svg::default();
        let mut top = svg.heading(&self.title);
        let left = panel.left_margin();
        top += legend::draw(&mut svg, left, top, self.series.iter(), &colours);
        let area = plot_area(left, top + 8.0, self.height);
        panel.draw(&mut svg, area, &colours, XAxis::Labelled);
        Ok(svg.finish(&self.title, area.bottom() + X_AXIS_HEIGHT))
    }
}
