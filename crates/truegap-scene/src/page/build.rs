//! The page builder.

use super::escape::{escape, sentence};
use super::table::Table;

const STYLE: &str = include_str!("style.css");
/// Buttons, values and zoom of the figures; a page without figures has none.
const FIGURES: &str = concat!(include_str!("figures.js"), include_str!("plots.js"));

/// An HTML page, built top to bottom; blocks that are opened are closed by [`Page::to_html`].
#[derive(Debug, Clone, PartialEq)]
pub struct Page {
    title: String,
    body: String,
    open_details: usize,
}

impl Page {
    /// A page with its main heading.
    pub fn new(title: &str) -> Self {
        Self { title: title.into(), body: String::new(), open_details: 0 }
    }

    /// A second-level heading.
    pub fn section(self, heading: &str) -> Self {
        self.close_all().add(&format!("<h2>{}</h2>\n", escape(heading)))
    }

    /// A third-level heading.
    pub fn subsection(self, heading: &str) -> Self {
        self.add(&format!("<h3>{}</h3>\n", escape(heading)))
    }

    /// A paragraph of plain text.
    pub fn text(self, paragraph: &str) -> Self {
        self.add(&format!("<p>{}</p>\n", sentence(paragraph)))
    }

    /// A paragraph that stands out: the verdict, a warning. `tone` is one of the three of [`Tone`].
    pub fn callout(self, tone: Tone, text: &str) -> Self {
        let class = match tone {
            Tone::Good => "good",
            Tone::Watch => "watch",
            Tone::Bad => "bad",
        };
        self.add(&format!("<p class=\"callout {class}\">{}</p>\n", sentence(text)))
    }

    /// A bullet list.
    pub fn list<S: AsRef<str>>(self, items: &[S]) -> Self {
        let items: String = items.iter().map(|i| format!("<li>{}</li>\n", sentence(i.as_ref()))).collect();
        self.add(&format!("<ul>\n{items}</ul>\n"))
    }

    /// Text as it stands, in a fixed-width font: commands, files.
    pub fn code(self, text: &str) -> Self {
        self.add(&format!("<pre><code>{}</code></pre>\n", escape(text)))
    }

    /// A table.
    pub fn table(self, table: &Table) -> Self {
        let html = table.to_html();
        self.add(&html)
    }

    /// An SVG from this crate's figures with a caption below, which is also what a screen reader says of a figure without a title.
    pub fn figure(self, svg: &str, caption: &str) -> Self {
        let svg = svg.replacen("aria-label=\"\"", &format!("aria-label=\"{}\"", escape(caption)), 1);
        self.add(&format!("<figure>\n<div class=\"plot\">{svg}</div><figcaption>{}</figcaption>\n</figure>\n", sentence(caption)))
    }

    /// Markup as it stands; the caller answers for it being well-formed and self-contained.
    pub fn raw_html(self, markup: &str) -> Self {
        self.add(markup)
    }

    /// Opens a foldable block (closed at first); it ends at [`Page::end_details`] or the next section.
    pub fn details(mut self, summary: &str) -> Self {
        self.open_details += 1;
        self.add(&format!("<details><summary>{}</summary>\n", escape(summary)))
    }

    /// Ends the innermost foldable block.
    pub fn end_details(mut self) -> Self {
        if self.open_details == 0 {
            return self;
        }
        self.open_details -= 1;
        self.add("</details>\n")
    }

    /// What stands on the page, without its heading, style and script: a part of somebody else's page.
    pub fn fragment(&self) -> String {
        self.clone().close_all().body
    }

    /// The finished page.
    pub fn to_html(&self) -> String {
        let page = self.clone().close_all();
        let title = escape(&page.title);
        let has_figures = page.body.contains("tg-figure");
        let script = if has_figures { format!("<script>\n{FIGURES}</script>\n") } else { String::new() };
        format!(
            "<!DOCTYPE html>\n<html lang=\"en\">\n<head>\n<meta charset=\"utf-8\">\n\
             <meta name=\"viewport\" content=\"width=device-width, initial-scale=1\">\n\
             <title>{title}</title>\n<style>\n{STYLE}</style>\n</head>\n<body>\n<main>\n<h1>{title}</h1>\n{}</main>\n{script}</body>\n</html>\n",
            page.body
        )
    }

    fn add(mut self, markup: &str) -> Self {
        self.body.push_str(markup);
        self
    }

    fn close_all(mut self) -> Self {
        self.body.push_str(&"</details>\n".repeat(self.open_details));
        self.open_details = 0;
        self
    }
}

/// How a callout reads.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Tone {
    /// Holds, agrees.
    Good,
    /// Strained, ambiguous.
    Watch,
    /// Broken, missing.
    Bad,
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn nothing_of_the_caller_reaches_the_page_as_markup() {
        let evil = "<script>alert(\"x\")</script>&\u{1}";
        let page = Page::new(evil)
            .section(evil)
            .text(evil)
            .list(&[evil])
            .code(evil)
            .callout(Tone::Bad, evil)
            .table(&Table::new(&[evil]).row(&[evil]).caption(evil))
            .details(evil)
            .figure("<svg/>", evil)
            .to_html();
        assert!(!page.contains("<script") && !page.contains('\u{1}'));
        assert_eq!(page.matches("&lt;script&gt;").count(), 12);
    }

    #[test]
    fn a_figure_without_a_title_is_called_by_its_caption_and_can_be_saved() {
        let svg = "<svg class=\"tg-figure\" aria-label=\"\"></svg>";
        let html = Page::new("t").figure(svg, "error & noise").to_html();
        assert!(html.contains("aria-label=\"error &amp; noise\"") && !html.contains("aria-label=\"\""));
        assert_eq!(html.matches("<script>").count(), 1);
        assert!(!Page::new("t").to_html().contains("<script"));
    }

    #[test]
    fn every_opened_block_is_closed() {
        let page = Page::new("t").details("a").details("b").end_details().section("c").details("d").end_details().end_details();
        let html = page.to_html();
        assert_eq!(html.matches("<details>").count(), 3);
        assert_eq!(html.matches("</details>").count(), 3);
    }

    #[test]
    fn the_page_needs_nothing_from_elsewhere() {
        let html = Page::new("t").text("x").to_html();
        assert!(!html.contains("http://") && !html.contains("https://") && !html.contains("url("));
    }
}
