//! Self-contained HTML pages: text, tables, figures, foldable details; light, dark and on paper.
//!
//! No link, no font, and a script only for the figures (values under the pointer, zoom, saving), without which the page reads the same:
//! the file can be mailed. Everything that is not markup made here is escaped.
//!
//! ```
//! use truegap_scene::page::{Page, Tone};
//!
//! let html = Page::new("Gap & cap").callout(Tone::Good, "The model is adequate.").section("Data").text("12 runs").to_html();
//! assert!(html.contains("<h1>Gap &amp; cap</h1>") && html.contains("12 runs"));
//! ```

mod build;
mod escape;
mod table;

pub use build::{Page, Tone};
pub use escape::escape;
pub use table::Table;
