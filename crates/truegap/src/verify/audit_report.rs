//! The report of an audit: the register as a table, effects ranked, both routes drawn, the numbers to copy.
//!
//! Limits: tells what the audit says; decides nothing.

use crate::verify::audited::{Audited, Body};
use truegap_audit::{Audit, Figure, Finding, Verdict};
use truegap_scene::Viewer;
use truegap_scene::figure::{Bars, Figure as Plot, FigureError};
use truegap_scene::page::{Page, Table, Tone};

/// The page as HTML.
pub fn html(audited: &Audited, bodies: &[Body]) -> String {
    let audit = &audited.audit;
    let page = Page::new(&format!("Audit of {}", audit.sensor));
    let page = summary(page, audited);
    let page = register(page, audit);
    let page = ranking(page, audit);
    let page = figures(page, audit);
    let page = viewers(page, bodies);
    provenance(page, audited).to_html()
}

/// The audit as lines for a terminal.
pub fn summary_lines(audit: &Audit) -> Vec<[String; 6]> {
    let line = |f: &Finding| {
        let (name, worst) = f.effect_on.worst();
        let fem = format!("{} ± {}", number(f.fem.value), error(f.fem.error_estimate));
        let analytic = format!("{} {}", number(f.analytic.value), f.analytic.unit);
        [
            f.id.clone(),
            word(f.verdict).into(),
            analytic,
            fem,
            percent(100.0 * f.relative_error),
            format!("{} on {name}", percent(worst)),
        ]
    };
    audit.assumptions.iter().map(line).collect()
}

/// Number of assumptions with a verdict.
pub fn count(audit: &Audit, verdict: Verdict) -> usize {
    audit.assumptions.iter().filter(|f| f.verdict == verdict).count()
}

/// The verdict as a word.
pub fn word(verdict: Verdict) -> &'static str {
    match verdict {
        Verdict::Holds => "holds",
        Verdict::Strained => "strained",
        Verdict::Broken => "broken",
    }
}

fn summary(page: Page, audited: &Audited) -> Page {
    let audit = &audited.audit;
    let [broken, strained, holds] = [Verdict::Broken, Verdict::Strained, Verdict::Holds].map(|v| count(audit, v));
    let tone = if broken > 0 {
        Tone::Bad
    } else if strained > 0 {
        Tone::Watch
    } else {
        Tone::Good
    };
    let told = format!(
        "{broken} assumptions are broken, {strained} strained, {holds} hold, between {} and {} degC and up to {} N.",
        audited.options.cold_c, audited.options.hot_c, audited.full_n
    );
    let c = &audit.coefficients;
    let numbers = [
        ("baseline", c.baseline_pf, "pF"),
        ("span", c.span_pf, "pF"),
        ("K_baseline", c.k_baseline_pct_fsr_per_k, "%FSR/K"),
        ("K_sensitivity", c.k_sensitivity_pct_per_k, "%/K"),
        ("K_linearity", c.k_linearity_pct_per_k, "%/K"),
    ];
    let head = Table::new(&["coefficient", "analytic model", "unit"]);
    let table = numbers.iter().fold(head, |t, (name, value, unit)| t.row(&[*name, &number(*value), unit]));
    page.callout(tone, &told)
        .text(
            "Each row below replaces one piece of the analytic chain by what finite elements find and keeps the rest: effects of two rows do not simply add. \
             An assumption holds where no coefficient moves by 1 %, is strained from 1 % or outside of the range in which its equation is known to be good, \
             and is broken from 10 %.",
        )
        .table(&table)
}

/// Column headings of how far off an assumption is, and how far it moves each coefficient.
pub(crate) const MOVED: [&str; 6] = ["off by %", "baseline %", "span %", "K_b %", "K_s %", "K_l %"];

fn register(page: Page, audit: &Audit) -> Page {
    let own = ["assumption", "verdict", "analytic", "finite elements", "unit"];
    let head = Table::new(&[&own[..], &MOVED].concat()).dense();
    let table = audit.assumptions.iter().fold(head, |table, f| {
        let fem = format!("{} ± {}", short(f.fem.value), error(f.fem.error_estimate));
        let mut row = vec![f.id.clone(), word(f.verdict).into(), short(f.analytic.value), fem, f.fem.unit.clone()];
        row.push(short_percent(100.0 * f.relative_error));
        row.extend(f.effect_on.values().map(|v| v.map_or("–".into(), short_percent)));
        table.row(&row)
    });
    let page = page
        .section("The register")
        .text("Columns from baseline on: what the coefficient does when this row's piece is replaced; K_b, K_s, K_l stand for K_baseline, K_sensitivity, K_linearity. All digits are in audit.json.")
        .table(&table);
    let page = audit.assumptions.iter().fold(page, |page, f| {
        page.details(&format!("{}: {}", f.id, f.says))
            .text(&format!("{}: {}.", word(f.verdict), f.reason))
            .text(&format!("Source: {}.", f.source))
            .end_details()
    });
    if audit.not_applicable.is_empty() {
        return page;
    }
    let lines: Vec<String> = audit.not_applicable.iter().map(|n| format!("{}: {}", n.id, n.says)).collect();
    page.subsection("Not for this sensor").list(&lines)
}

fn ranking(page: Page, audit: &Audit) -> Page {
    let page = page.section("What moves each coefficient");
    audit.ranking.iter().fold(page, |page, ranking| {
        let names: Vec<&str> = ranking.order.iter().map(|r| r.id.as_str()).collect();
        let values: Vec<f64> = ranking.order.iter().map(|r| r.pct).collect();
        if names.is_empty() {
            return page
                .text(&format!("{} of the analytic model is zero, so there are no percentages of it.", ranking.coefficient));
        }
        let drawn =
            Bars::new("", &names).x(&format!("change of {}", ranking.coefficient), "%").series("change", &values).to_svg();
        drawing(page, drawn, &format!("Change of {} when finite elements replace one assumption.", ranking.coefficient))
    })
}

fn figures(page: Page, audit: &Audit) -> Page {
    let drawn = |verdict: Verdict| audit.assumptions.iter().filter(move |f| f.verdict == verdict && f.figure.is_some());
    let page = page.section("Both routes");
    let one = |page: Page, f: &Finding| match &f.figure {
        Some(figure) => drawing(page, plot(figure), &format!("{}: {}.", f.id, f.says)),
        None => page,
    };
    let page = drawn(Verdict::Broken).fold(page, one);
    let page = drawn(Verdict::Strained).fold(page.details("Strained assumptions"), one).end_details();
    drawn(Verdict::Holds).fold(page.details("Assumptions that hold"), one).end_details()
}

fn plot(figure: &Figure) -> Result<String, FigureError> {
    let start = Plot::new(&figure.title).x(&figure.x, "").y(&figure.y, "");
    let plot = figure.curves.iter().fold(start, |plot, curve| {
        let (x, y): (Vec<f64>, Vec<f64>) = curve.points.iter().copied().unzip();
        if curve.errors.len() != y.len() {
            return plot.dashed_line(&curve.name, &x, &y);
        }
        let low: Vec<f64> = y.iter().zip(&curve.errors).map(|(y, e)| y - e).collect();
        let high: Vec<f64> = y.iter().zip(&curve.errors).map(|(y, e)| y + e).collect();
        plot.band(&curve.name, &x, &low, &high).line(&curve.name, &x, &y)
    });
    plot.to_svg()
}

fn drawing(page: Page, drawn: Result<String, FigureError>, caption: &str) -> Page {
    match drawn {
        Ok(svg) => page.figure(&svg, caption),
        Err(reason) => page.text(&format!("A figure is left out ({caption}) {reason}")),
    }
}

fn viewers(page: Page, bodies: &[Body]) -> Page {
    if bodies.is_empty() {
        return page;
    }
    bodies.iter().fold(page.section("The deformed stack"), |page, body| {
        page.text(&body.says).raw_html(&Viewer::new(&body.name, &body.glb).to_fragment())
    })
}

fn provenance(page: Page, audited: &Audited) -> Page {
    page.section("How to make this page again").code(&audited.command)
}

fn number(value: f64) -> String {
    significant(value, 6)
}

/// For a cell of a wide table; all digits are in audit.json.
fn short(value: f64) -> String {
    significant(value, 5)
}

/// Two decimals at most, powers of ten from a thousand on.
pub(crate) fn short_percent(value: f64) -> String {
    match value.abs() {
        size if size >= 1000.0 => format!("{value:+.1e}"),
        size if size >= 9.95 => format!("{value:+.0}"),
        size if size >= 0.005 => format!("{value:+.2}"),
        _ => "0".into(),
    }
}

fn error(value: f64) -> String {
    significant(value, 2)
}

fn percent(value: f64) -> String {
    if value == 0.0 { "0".into() } else { format!("{}{}", if value > 0.0 { "+" } else { "" }, significant(value, 3)) }
}

/// `value` with so many significant digits, in powers of ten where it is very small or large.
fn significant(value: f64, digits: i32) -> String {
    if value == 0.0 || !value.is_finite() {
        return value.to_string();
    }
    let exponent = value.abs().log10().floor() as i32;
    if !(-4..7).contains(&exponent) {
        return format!("{value:.*e}", (digits - 1).max(0) as usize);
    }
    format!("{value:.*}", (digits - 1 - exponent).max(0) as usize)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn numbers_keep_their_digits_and_their_sign() {
        assert_eq!(number(234.620_670_3), "234.621");
        assert_eq!(error(1.84e-3), "0.0018");
        assert_eq!(percent(194.162), "+194");
        assert_eq!(percent(-0.004_56), "-0.00456");
        assert_eq!(number(2.4e-10), "2.40000e-10");
        let cells = [2_631_775.0, -92.6, 1.9, -0.006_73, 2.3e-12].map(short_percent);
        assert_eq!(cells, ["+2.6e6", "-93", "+1.90", "-0.01", "0"]);
    }
}
