//! The viewer page as text: whole, self-contained, with the very file in it.

#![allow(clippy::unwrap_used)]

use base64::Engine;
use truegap_scene::Viewer;
use truegap_scene::page::Page;

fn embedded(html: &str) -> Vec<Vec<u8>> {
    let pieces = html.split("class=\"tg-glb\">").skip(1).map(|rest| rest.split('<').next().unwrap_or(""));
    pieces.map(|text| base64::engine::general_purpose::STANDARD.decode(text).expect("base64")).collect()
}

#[test]
fn the_page_holds_the_file_and_nothing_from_elsewhere() {
    let glb: Vec<u8> = (0..=255).cycle().take(1000).collect();
    let html = Viewer::new("a < b", &glb).to_html();
    assert_eq!(embedded(&html), [glb]);
    assert!(html.contains("<h1>a &lt; b</h1>") && html.contains("data-title=\"a &lt; b\""));
    for foreign in ["http://", "https://", "src=", "@import", "url("] {
        assert!(!html.contains(foreign), "{foreign}");
    }
}

#[test]
fn a_page_can_hold_several_viewers_between_its_text() {
    let page = Page::new("two")
        .raw_html(&Viewer::new("one", b"first").to_fragment())
        .text("between")
        .raw_html(&Viewer::new("two", b"second").to_fragment())
        .to_html();
    assert_eq!(embedded(&page), [b"first".to_vec(), b"second".to_vec()]);
    assert_eq!(page.matches("<script").count(), page.matches("</script>").count());
}

/// A disc of 15 mm by 0.3 mm opened as a flat spot, and nothing in the picture said at which scale it is drawn.
#[test]
fn a_flat_stack_opens_stretched_and_says_so() {
    let html = Viewer::new("disc", b"x").to_html();
    for part in ["class=\"tg-scale\"", "class=\"tg-true\">1:1<", "stretch: stretched", "heights ×", "true to scale"] {
        assert!(html.contains(part), "{part} is missing");
    }
}
