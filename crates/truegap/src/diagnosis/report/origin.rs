//! The noise model, doubts about the recording, the recovery bank, and where everything comes from.
//!
//! Limits: told as the diagnosis tells it.

use super::subject::Subject;
use super::text::{Scale, capitalised, significant};
use truegap_core::Role;
use truegap_diagnose::answer::NoiseFacts;
use truegap_scene::page::{Page, Table, Tone};

/// Doubts, where there are any.
pub(super) fn issues(page: Page, subject: &Subject<'_>) -> Page {
    let issues = &subject.diagnosis.recording_issues;
    if issues.is_empty() { page } else { page.section("Doubts").list(issues) }
}

/// Noise and what it rests on.
pub(super) fn noise(page: Page, subject: &Subject<'_>) -> Page {
    let noise = &subject.diagnosis.noise;
    let page = page.section("Noise").text(&format!("{}.", capitalised(noise.says.trim_end_matches('.'))));
    let page = if noise.measured {
        page
    } else {
        page.callout(
            Tone::Watch,
            "The noise could not be measured apart from the mismatch; record some minutes at rest to be surer.",
        )
    };
    page.table(&noise_table(noise, subject))
}

fn noise_table(noise: &NoiseFacts, subject: &Subject<'_>) -> Table {
    let scale = subject.error_scale();
    let mut table = Table::new(&["part", "standard deviation"])
        .row(&["white, of each reading".to_owned(), scale.text(noise.white_sd)])
        .row(&[format!("correlated from row to row ({} a row)", significant(noise.ar_correlation, 2)), scale.text(noise.ar_sd)]);
    if noise.lasting_sd > 0.0 {
        table = table.row(&["lasting, slow or held from step to step".to_owned(), scale.text(noise.lasting_sd)]);
    }
    if noise.load_sd > 0.0 {
        let unit = load_unit(subject);
        table = table.row(&["recorded load".to_owned(), Scale::of(unit, noise.load_sd).text(noise.load_sd)]);
    }
    if noise.temperature_sd > 0.0 {
        table = table.row(&["recorded temperature".to_owned(), format!("{} K", significant(noise.temperature_sd, 2))]);
    }
    table
}

fn load_unit(subject: &Subject<'_>) -> &'static str {
    let recorded = |role: &Role| subject.inputs.column(*role).is_some();
    [Role::Force, Role::Pressure, Role::Gap].into_iter().find(recorded).map_or("", Role::unit)
}

/// Rows of the recovery bank, where it was run.
pub(super) fn bank(page: Page, subject: &Subject<'_>) -> Page {
    let Some(bank) = &subject.diagnosis.bank else { return page };
    let page = page.section("How often this tool is right on a recording like this");
    let page = page.text("Recordings with a known cause were simulated for this protocol, noise and prior knowledge, and diagnosed in the same way.");
    let lines = bank.get("says").and_then(|s| s.as_array()).into_iter().flatten().filter_map(|l| l.as_str());
    let page = lines.fold(page, |page, line| page.text(&format!("{line}.")));
    page.code(&format!("{bank:#}"))
}

/// Files, hashes, command, version, time.
pub(super) fn provenance(page: Page, subject: &Subject<'_>) -> Page {
    let (diagnosis, made) = (subject.diagnosis, subject.provenance);
    let mut table = Table::new(&["", ""])
        .row(&["command", &made.command])
        .row(&["program", &format!("truegap {}", diagnosis.version)])
        .row(&["made", &made.made_at])
        .row(&["took", &format!("{} s", significant(diagnosis.seconds, 3))])
        .row(&[
            "rows, runs",
            &format!(
                "{} rows in {} run{}",
                diagnosis.recording.rows,
                diagnosis.recording.runs,
                if diagnosis.recording.runs == 1 { "" } else { "s" }
            ),
        ]);
    if let Some(seeds) = &diagnosis.seeds {
        let each = seeds.named().map(|(what, seed)| format!("{what} {seed}"));
        table = table.row(&["seeds", &each.join(", ")]);
    }
    for (file, hash) in &made.files {
        table = table.row(&["recording", file]).row(&["its SHA-256", hash]);
    }
    let page = page.section("Where this comes from").table(&table);
    if !made.has_model {
        return page.text("Beside this page: diagnosis.json (everything above for a program).");
    }
    let model = if subject.is_augmented() { "calibrated model with what was missing" } else { "calibrated model" };
    page.text(&format!(
        "Beside this page: diagnosis.json (everything above for a program), augmented.toml (the {model}, \
         which `truegap simulate --model augmented.toml` runs), prediction.csv (every row with all predictions)."
    ))
}
