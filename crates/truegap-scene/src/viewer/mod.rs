//! A page that shows a GLB of this crate from a local file, without network: orbit, morph, layers, colour bar.
//!
//! The file is embedded as base64 and drawn by a small WebGL 2 program made for what [`crate::glb`] writes; it is no general
//! glTF viewer. Flat stacks open with their height stretched, by a factor that stands in the picture; a button goes to 1:1. Without WebGL the page says so and still offers the file.

use crate::page::{Page, escape};
use base64::Engine;
use base64::engine::general_purpose::STANDARD;

const PROGRAM: &str = include_str!("viewer.js");
const STYLE: &str = include_str!("viewer.css");
const CONTROLS: &str = include_str!("controls.html");

/// A GLB made by [`crate::glb::Scene::to_glb`], to be shown in a page.
#[derive(Debug, Clone, Copy)]
pub struct Viewer<'a> {
    title: &'a str,
    glb: &'a [u8],
}

impl<'a> Viewer<'a> {
    /// A viewer for the bytes of a `.glb` file.
    pub fn new(title: &'a str, glb: &'a [u8]) -> Self {
        Self { title, glb }
    }

    /// Markup for [`Page::raw_html`]; a page may hold several.
    pub fn to_fragment(&self) -> String {
        format!(
            "<div class=\"tg-viewer\" data-title=\"{}\">\n<style>\n{STYLE}</style>\n{CONTROLS}\
             <script type=\"text/plain\" class=\"tg-glb\">{}</script>\n<script>\n{PROGRAM}</script>\n</div>\n",
            escape(self.title),
            STANDARD.encode(self.glb)
        )
    }

    /// A page of its own.
    pub fn to_html(&self) -> String {
        Page::new(self.title).raw_html(&self.to_fragment()).to_html()
    }
}
