//! Small helpers between figures and the page.
//!
//! Limits: a figure that cannot be drawn becomes a sentence, never a report that is not written.

use truegap_scene::colour::{PALETTE, Rgb};
use truegap_scene::figure::FigureError;
use truegap_scene::page::{Page, escape};

/// Colour of what was recorded.
pub(super) const RECORDED: Rgb = PALETTE[6];
/// Colour of the calibrated base model; bar charts give it to their first series.
pub(super) const BEFORE: Rgb = PALETTE[0];
/// Colour of the model with the findings; bar charts give it to their second series.
pub(super) const AFTER: Rgb = PALETTE[1];
/// Colour of noise.
pub(super) const NOISE: Rgb = PALETTE[2];

/// `page` with a figure, or with the reason why there is none.
pub(super) fn figure(page: Page, drawn: Result<String, FigureError>, caption: &str) -> Page {
    match drawn {
        Ok(svg) => page.figure(&svg, caption),
        Err(reason) => page.text(&format!("A figure is left out ({caption}) {reason}")),
    }
}

/// Two figures side by side where the screen is wide enough.
pub(super) fn pair(page: Page, drawn: [(Result<String, FigureError>, &str); 2]) -> Page {
    let page = page.raw_html("<div class=\"pair\">\n");
    drawn.into_iter().fold(page, |page, (svg, caption)| figure(page, svg, caption)).raw_html("</div>\n")
}

/// Numbers to see first: large figure, small caption.
pub(super) fn tiles(page: Page, tiles: &[(String, String)]) -> Page {
    let tile = |(number, caption): &(String, String)| {
        format!("<div><strong>{}</strong><span>{}</span></div>\n", escape(number), escape(caption))
    };
    page.raw_html(&format!("<div class=\"tiles\">\n{}</div>\n", tiles.iter().map(tile).collect::<String>()))
}

/// Rules that the tiles and pairs need beside those of every page.
pub(super) const STYLE: &str = "<style>
.tiles { display: flex; flex-wrap: wrap; gap: .8rem; margin: 1rem 0 1.2rem; }
.tiles div { flex: 1 1 7.5rem; padding: .6rem .9rem; background: var(--shade); border-radius: .3rem; }
.tiles strong { display: block; font-size: 1.1rem; white-space: nowrap; }
.tiles span { color: var(--soft); font-size: .85rem; }
.verdict .callout { font-size: 1.3rem; font-weight: 600; line-height: 1.35; }
pre { white-space: pre-wrap; }
.says { font-size: 1.06rem; }
@media (min-width: 1180px) {
  .pair { display: grid; grid-template-columns: 1fr 1fr; gap: 1rem; width: min(94vw, 1500px); margin-left: 50%; transform: translateX(-50%); }
}
@media print { .tiles { gap: .5rem; } .tiles div { flex-basis: 5.2rem; padding: .4rem .6rem; border: 1px solid var(--line); } .pair { display: block; width: auto; margin: 0; transform: none; } }
</style>
";
