//! Surfaces and fields as glTF, VTU and figures.
//!
//! Everything here takes plain arrays and returns text or bytes; nothing here knows a sensor, a solver or a file format of
//! the project. What is drawn is what was given: no smoothing, no silent clamps; thinning keeps every extreme.
//!
//! | you have | you want | you call |
//! |---|---|---|
//! | columns | a plot as SVG | [`figure::Figure`], [`figure::Stack`], [`figure::Bars`], [`figure::HeatMap`], [`figure::Matrix`] |
//! | figures, tables, text | one HTML file | [`page::Page`] |
//! | triangulated sections of round parts | a 3D file as GLB | [`solid::Layer`], [`glb::Scene`] |
//! | a GLB | a page that turns it | [`Viewer`] |
//! | a section with fields | a file for ParaView | [`vtu::Grid`] |
//!
//! # Example: a chart
//!
//! ```
//! use truegap_scene::figure::Figure;
//!
//! let force_n = [0.0, 5.0, 10.0, 15.0];
//! let svg = Figure::new("Capacitance under load")
//!     .x("force", "N")
//!     .y("capacitance", "pF")
//!     .line("model", &force_n, &[12.00, 12.21, 12.39, 12.55])
//!     .points("measured", &force_n, &[12.01, 12.20, 12.40, 12.53])
//!     .to_svg()?;
//! assert!(svg.starts_with("<svg") && svg.contains("capacitance"));
//! # Ok::<(), truegap_scene::figure::FigureError>(())
//! ```

pub mod colour;
pub mod figure;
pub mod glb;
pub mod page;
pub mod solid;
mod viewer;
pub mod vtu;

pub use viewer::Viewer;
