//! The numbers of `docs/errata.md` are those that the code prints.
#![allow(clippy::unwrap_used)]

#[test]
fn the_errata_page_shows_what_the_code_computes() {
    let page = std::fs::read_to_string(concat!(env!("CARGO_MANIFEST_DIR"), "/../../docs/errata.md")).unwrap();
    let table = truegap_model::errata_table().unwrap();
    assert_eq!(table.lines().count(), 2 + 3 + 3 + 3 + 1 + 1 + 3 + 3);
    // the printed form of (18) is all rounding error: its digits may differ between machines
    for row in table.lines().filter(|row| !row.starts_with("| 18")) {
        assert!(
            page.contains(row),
            "docs/errata.md lacks the row below; run `cargo run -p truegap-model --example errata` and put its output there\n{row}"
        );
    }
}
