//! Figures as a reader of the SVG text sees them.

#![allow(clippy::unwrap_used)]

use truegap_scene::figure::{Bars, Figure, FigureError, HeatMap, Matrix, Stack};

/// Names of the elements in document order; fails on a tag that is not closed in turn or on a bare ampersand.
fn elements(svg: &str) -> Vec<String> {
    let (mut open, mut all, mut rest) = (Vec::new(), Vec::new(), svg);
    while let Some(start) = rest.find('<') {
        assert!(rest[..start].split('&').skip(1).all(|s| s.contains(';')), "bare ampersand");
        let end = start + rest[start..].find('>').expect("an open tag ends");
        let tag = &rest[start + 1..end];
        let name = tag.trim_start_matches('/').split([' ', '/']).next().unwrap_or("").to_owned();
        if tag.starts_with('/') {
            assert_eq!(open.pop(), Some(name), "closing tag out of turn");
        } else {
            all.push(name.clone());
            if !tag.ends_with('/') {
                open.push(name);
            }
        }
        rest = &rest[end + 1..];
    }
    assert!(open.is_empty(), "left open: {open:?}");
    all
}

/// Corners of the path whose title is `label`.
fn corners(svg: &str, label: &str) -> Vec<(f64, f64)> {
    let end = svg.find(&format!("<title>{label}</title></path>")).expect("the path is there");
    let data = &svg[svg[..end].rfind("d=\"").expect("it has data") + 3..end];
    let numbers: Vec<f64> = data[..data.find('"').expect("data ends")]
        .split(['M', 'L', ' '])
        .filter(|t| !t.is_empty())
        .map(|t| t.parse().expect("a number"))
        .collect();
    numbers.chunks(2).map(|pair| (pair[0], pair[1])).collect()
}

#[test]
fn a_million_points_give_a_small_figure_that_still_shows_one_outlier() {
    let x: Vec<f64> = (0..1_000_000).map(f64::from).collect();
    let mut y: Vec<f64> = x.iter().map(|x| (x * 0.7).sin()).collect();
    y[777_777] = 40.0;
    let svg = Figure::new("long").x("time", "s").y("value", "pF").line("a", &x, &y).to_svg().expect("drawable");
    assert!(svg.len() < 100_000, "{} bytes", svg.len());
    let highest = corners(&svg, "a").into_iter().min_by(|p, q| p.1.total_cmp(&q.1)).expect("points");
    let others = corners(&svg, "a").into_iter().filter(|p| p.1 < highest.1 + 50.0).count();
    assert_eq!(others, 1);
}

#[test]
fn a_logarithmic_axis_puts_equal_ratios_at_equal_distances() {
    let svg = Figure::new("").log_x().log_y().line("a", &[1.0, 10.0, 100.0], &[1e-6, 1e-4, 1e-2]).to_svg().expect("drawable");
    let p = corners(&svg, "a");
    // Coordinates carry two decimals.
    assert!(((p[1].0 - p[0].0) - (p[2].0 - p[1].0)).abs() < 0.021 && (p[1].0 - p[0].0) > 100.0);
    assert!(((p[0].1 - p[1].1) - (p[1].1 - p[2].1)).abs() < 0.021 && (p[0].1 - p[1].1) > 50.0);
}

#[test]
fn a_window_on_a_long_series_shows_its_own_heights_and_stays_small() {
    let x: Vec<f64> = (0..1_000_000).map(|i| f64::from(i) * 1e-3).collect();
    let y: Vec<f64> = x.iter().map(|x| if *x < 500.0 { x.sin() } else { 1e6 }).collect();
    let svg = Figure::new("").line("a", &x, &y).x_range(100.0, 110.0).to_svg().expect("drawable");
    assert!(svg.len() < 100_000, "{} bytes", svg.len());
    let (low, high) = corners(&svg, "a").iter().fold((f64::MAX, f64::MIN), |(a, b), p| (a.min(p.1), b.max(p.1)));
    // Ten radians hold a whole wave: it fills the height of 300 up to twice the margin of 5 %.
    assert!(((high - low) - 300.0 / 1.1).abs() < 0.1, "{low} {high}");
}

#[test]
fn a_stack_takes_its_x_axis_from_the_first_panel() {
    let (x, y) = ([1.0, 10.0, 100.0], [1.0, 2.0, 3.0]);
    let first = Figure::new("").x("time", "s").log_x().line("a", &x, &y);
    let svg = Stack::new("").panel(first).panel(Figure::new("").line("b", &x, &y)).to_svg().expect("drawable");
    assert!(svg.contains(">time (s)<"));
    let distances = |name| corners(&svg, name).iter().map(|p| p.0).collect::<Vec<_>>();
    assert_eq!(distances("a"), distances("b"));
}

#[test]
fn a_band_that_reaches_zero_runs_to_the_bottom_of_a_logarithmic_axis() {
    let x = [0.0, 1.0, 2.0];
    let svg = Figure::new("").log_y().band("b", &x, &[1.0, -1.0, 1.0], &[10.0; 3]).to_svg().expect("drawable");
    let end = svg.find("<title>b</title></path>").expect("the band");
    let data = &svg[svg[..end].rfind("d=\"").expect("data")..end];
    assert!(data.matches('M').count() == 1 && data.contains(" 300L"), "{data}");
}

#[test]
fn values_that_are_not_numbers_break_the_line() {
    let svg = Figure::new("").line("a", &[0.0, 1.0, 2.0, 3.0, 4.0], &[1.0, 2.0, f64::NAN, 2.0, 1.0]).to_svg().expect("drawable");
    let end = svg.find("<title>a</title>").expect("there");
    let data = &svg[svg[..end].rfind("d=\"").expect("data")..end];
    assert_eq!(data.matches('M').count(), 2);
    assert!(!svg.contains("NaN"));
}

#[test]
fn every_figure_is_well_formed_whatever_the_labels() {
    let (x, y) = ([1.0, 2.0, 3.0], [2.0, -1.0, 4.0]);
    let odd = "a < b & \"c\"";
    let figure = || {
        Figure::new(odd)
            .x(odd, "µm")
            .y(odd, "pF")
            .line(odd, &x, &y)
            .points("p", &x, &y)
            .steps("s", &x, &y)
            .band(odd, &x, &y, &[3.0, 0.0, 5.0])
            .error_bars("e", &x, &y, &[0.1; 3])
            .shade_x(1.0, 2.0, odd)
            .mark_y(0.0, odd)
    };
    let all = [
        figure().to_svg(),
        Stack::new(odd).panel(figure()).panel(figure()).to_svg(),
        Bars::new(odd, &[odd, "b"]).series(odd, &[1.0, -2.0]).series("second", &[0.5, f64::NAN]).ranked().to_svg(),
        HeatMap::new(odd, &[0.0, 1.0, 2.0], &[0.0, 1.0], &[1.0, f64::NAN]).x(odd, "N").value(odd, "fF").diverging().to_svg(),
        Matrix::new(odd, &[odd], &[odd, "b"], &[0.5, f64::NAN]).axes(odd, odd).to_svg(),
    ];
    for svg in all {
        let svg = svg.expect("drawable");
        assert!(elements(&svg).len() > 10 && !svg.contains("NaN") && !svg.contains("inf"));
    }
}

#[test]
fn bars_are_ranked_by_magnitude_and_start_at_zero() {
    let svg = Bars::new("", &["small", "large"]).series("effect", &[1.0, -3.0]).ranked().to_svg().expect("drawable");
    assert!(svg.find(">large<").expect("label") < svg.find(">small<").expect("label"));
    let hinted = |name: &str| {
        let end = svg.find(&format!("<title>{name}, effect")).expect("bar");
        let data = &svg[svg[..end].rfind("d=\"M").expect("data") + 4..end];
        let zero: f64 = data.split(' ').next().expect("x").parse().expect("number");
        let tip: f64 = data.split(['H', 'v']).nth(1).expect("tip").parse().expect("number");
        (zero, tip)
    };
    let ((zero, right), (same, left)) = (hinted("small"), hinted("large"));
    assert_eq!(zero, same);
    // -3 is three times as long as 1; coordinates carry two decimals.
    assert!(((zero - left) / (right - zero) - 3.0).abs() < 1e-3);
}

#[test]
fn impossible_figures_are_typed_errors_that_name_the_series() {
    let lengths = Figure::new("f").line("a", &[1.0, 2.0], &[1.0]).to_svg().expect_err("lengths differ");
    assert!(matches!(lengths, FigureError::Lengths { left: 2, right: 1, .. }) && lengths.to_string().contains("`a`"));
    let empty = Figure::new("f").line("a", &[f64::NAN], &[1.0]).to_svg().expect_err("nothing to draw");
    assert!(matches!(empty, FigureError::Empty { axis: "x", .. }));
    let logarithm = Figure::new("f").log_y().line("a", &[1.0], &[-1.0]).to_svg().expect_err("no positive value");
    assert!(matches!(logarithm, FigureError::Empty { axis: "y", .. }));
    let range = Figure::new("f").y_range(2.0, 1.0).line("a", &[1.0], &[1.0]).to_svg().expect_err("empty range");
    assert!(matches!(range, FigureError::Range { .. }));
    let order = Figure::new("f").band("b", &[2.0, 1.0], &[0.0, 0.0], &[1.0, 1.0]).to_svg().expect_err("x falls");
    assert!(matches!(order, FigureError::NotOrdered { index: 1, .. }));
    assert!(HeatMap::new("h", &[0.0, 1.0], &[0.0, 1.0], &[1.0, 2.0]).to_svg().is_err());
    assert!(Bars::new("b", &["x"]).series("s", &[1.0, 2.0]).to_svg().is_err());
    assert!(Stack::new("s").to_svg().is_err());
}

/// Colours of the cells of a map of one row from left to right; neighbours of one colour are one.
fn colours_of_cells(svg: &str) -> Vec<String> {
    let group = &svg[svg.find("crispEdges").unwrap()..];
    let mut cells: Vec<(f64, &str)> = group[..group.find("</g>").unwrap()]
        .lines()
        .filter_map(|line| line.strip_prefix("<path d=\""))
        .flat_map(|line| {
            let (data, rest) = line.split_once('"').unwrap();
            let fill = rest.split('"').nth(1).unwrap();
            data.split('M').skip(1).map(move |cell| (cell.split(' ').next().unwrap().parse().unwrap(), fill))
        })
        .collect();
    cells.sort_by(|a, b| a.0.total_cmp(&b.0));
    cells.iter().map(|cell| cell.1.to_owned()).collect()
}

/// One cell at 2700 left those at 3, which are no chance, as white as zero.
#[test]
fn one_huge_cell_leaves_the_others_their_colours_and_the_bar_says_what_lies_beyond() {
    let cells = [0.0, 3.0, -3.0, 30.0, 2700.0];
    let map = HeatMap::new("h", &[0.0, 1.0, 2.0, 3.0, 4.0, 5.0], &[0.0, 1.0], &cells).diverging();
    let bytes = |colour: &String| [1, 3, 5].map(|i| i32::from_str_radix(&colour[i..i + 2], 16).unwrap());
    let apart = |a: &String, b: &String| bytes(a).iter().zip(bytes(b)).map(|(x, y)| (x - y).abs()).max().unwrap();
    let even = colours_of_cells(&map.clone().value_range(-2700.0, 2700.0).to_svg().unwrap());
    assert!(even[..even.len() - 1].iter().all(|c| apart(c, &even[0]) < 8), "all but the huge one look alike: {even:?}");
    let bent = map.bent(3.0).value_range(-100.0, 100.0).to_svg().unwrap();
    let c = colours_of_cells(&bent);
    assert!([(0, 1), (0, 2), (1, 3), (3, 4)].iter().all(|&(a, b)| apart(&c[a], &c[b]) > 25), "{c:?}");
    assert!(bent.contains("▲ beyond, to 2700") && !bent.contains("▼"));
    assert!(bent.contains(">\u{2212}30<") && bent.contains(">100<"), "marks of the bar");
}

/// A page's script makes values of pixels with these; see `page/plots.js`.
#[test]
fn panels_and_maps_carry_their_axes_for_pointers() {
    let svg = Figure::new("").x("time", "s").y("level <1>", "pF").line("a", &[0.0, 10.0], &[820.0, 821.0]).y_range(820.0, 821.0);
    let svg = svg.mark_x(5.0, "half").to_svg().unwrap();
    for part in [
        "data-x=\"0e0 1e1 0 1e0 0e0\"",
        "data-x-name=\"time\"",
        "data-x-unit=\"s\"",
        "data-y-name=\"level &lt;1&gt;\"",
        "data-labelled",
    ] {
        assert!(svg.contains(part), "{part} is missing");
    }
    assert!(svg.contains("<g data-x=\""), "a guide that moves along x");
    let map = HeatMap::new("h", &[0.0, 1.0, 2.0], &[0.0, 1.0], &[1.0, f64::NAN]).value("gap", "um").to_svg().unwrap();
    assert!(map.contains("data-cells=\"1.0000e0 -\"") && map.contains("data-name=\"gap (um)\""));
    let fine: Vec<f64> = (0..=100).map(f64::from).collect();
    let big = HeatMap::new("h", &fine, &fine, &[0.0; 10_000]).to_svg().unwrap();
    assert!(!big.contains("data-cells"), "a map finer than a pointer stays small");
}
