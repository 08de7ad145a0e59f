//! The page: every claim once with its verdicts side by side, then the numbers behind them.
//!
//! Limits: Markdown; verdicts are those of the rows, joined by a rule that is printed.

/// A claim for one reconstruction.
struct Row {
    claim: String,
    pair: &'static str,
    found: String,
    verdict: &'static str,
    rule: &'static str,
}

/// Rows, and why each claim comes out as it does.
#[derive(Default)]
pub struct Page {
    rows: Vec<Row>,
    whys: Vec<(String, &'static str)>,
}

impl Page {
    /// What one reconstruction makes of a claim.
    pub fn row(&mut self, claim: &str, pair: &'static str, found: &str, verdict: &'static str, rule: &'static str) {
        self.rows.push(Row { claim: claim.to_owned(), pair, found: found.to_owned(), verdict, rule });
    }

    /// Why a claim comes out as it does, for both reconstructions.
    pub fn why(&mut self, claim: &str, why: &'static str) {
        if self.whys.iter().all(|(c, _)| c != claim) {
            self.whys.push((claim.to_owned(), why));
        }
    }

    /// Claims in the order in which they were first made.
    fn claims(&self) -> Vec<&str> {
        let mut claims: Vec<&str> = Vec::new();
        for row in &self.rows {
            if !claims.contains(&row.claim.as_str()) {
                claims.push(&row.claim);
            }
        }
        claims
    }

    /// The page as Markdown.
    pub fn print(&self, pairs: &[&str]) {
        println!("# The claims, computed\n");
        println!(
            "Written by `cargo run -p truegap-design --example claims > validation/published/claims.md`; what it rests on is in [README.md](README.md).\n"
        );
        println!("Together: `agrees` or `differs` where both reconstructions say so, else `depends on the lost defaults`.\n");
        println!("| claim of the paper | {} | together | why |\n|---|{}---|---|", pairs.join(" | "), "---|".repeat(pairs.len()));
        for claim in self.claims() {
            let verdicts: Vec<&str> = pairs
                .iter()
                .map(|pair| self.rows.iter().find(|r| r.claim == claim && r.pair == *pair).map_or("-", |r| r.verdict))
                .collect();
            let same = verdicts.windows(2).all(|v| v[0] == v[1]);
            let together = if same { verdicts[0] } else { "depends on the lost defaults" };
            let why = self.whys.iter().find(|(c, _)| c == claim).map_or("", |(_, why)| why);
            println!("| {claim} | {} | {together} | {why} |", verdicts.join(" | "));
        }
        println!(
            "\n## The numbers\n\n| claim of the paper | reconstruction | what we get | verdict | rule of the verdict |\n|---|---|---|---|---|"
        );
        for claim in self.claims() {
            for r in self.rows.iter().filter(|r| r.claim == claim) {
                println!("| {claim} | {} | {} | {} | {} |", r.pair, r.found, r.verdict, r.rule);
            }
        }
    }
}
