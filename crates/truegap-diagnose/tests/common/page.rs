//! The page of effects as it stands in `docs/effects.md`.

use super::{Plate, recording};
use std::fmt::Write;
use truegap_diagnose::{Context, Effect, Library};

/// Parameters that are listed one by one; an effect with more has one a run.
const LISTED: usize = 4;

const HEAD: &str = "# The library of omitted physics

Written by `cargo run -p truegap-diagnose --example effects > docs/effects.md`; a test compares the two.

Each effect is one stage of the physics chain that the base model takes to be the identity. The first parameter is its *size*: 0 means
that the effect is absent, and the response is smooth in it. Parameters are quoted as for the sensor stack; units in `full loads`,
`unloaded gaps` and `spans` are relative to the full load, the gap without load and the reading at full load less that at none.

Memory: creep, hysteresis, trapped air and lags start afresh with each run. A run that starts under load was loaded at its first
sample; a thermal lag starts in equilibrium, a readout lag at its first value. Drift, ageing, the greatest load so far and water go on
through all runs on the clock. A part of a recording is therefore predicted by simulating all of it and looking at the part.

Several effects act in the order of `library()`, which is that of the chain. Trapped air belongs to the beads, but what it carries is
load, so it acts on the load that the beads still see. Friction acts on the strain, whatever makes the beads move.
";

const TAIL: &str = "
## Add an effect: one file and one line

1. Write `crates/truegap-diagnose/src/effects/my_effect.rs`: a type that implements `Effect` (who it is, its parameters with priors
   and physical bounds, whether a recording can show it, what a reader is told) and a type that implements `Stage` (the equation, at
   one place of the chain). Memory comes from `memory.rs`: `Lag`, `Play`, `play_set`, `greatest_so_far`, `lag_through_runs`.
2. Add `mod my_effect;` and, at its place in the chain, `Box::new(my_effect::MyEffect),` to `src/effects/mod.rs`.
3. Write this page again with the command above.

The tests of `tests/effects.rs` take the new effect up by themselves: identity at size 0, a change at any other size, smoothness,
the right stage, no dependence on how finely time is divided, a sibling that differs and yet resembles it. Give `sibling` the same
physics by other equations: it serves to test whether the family is still found when the equation is not quite right, and is never
fitted. Equations take no scale from the recording (a fitted number has to mean the same in the next one); priors do.
";

/// One section per effect, in the order of the chain, between introduction and instructions.
pub fn page(library: &Library) -> String {
    let (inputs, plate) = (recording(), Plate::new(Some(true)));
    let context = Context::new(&inputs, &plate, 2.0, 0.004);
    let mut page = String::from(HEAD);
    table(&mut page, library);
    library.iter().for_each(|effect| section(&mut page, effect, &context));
    page.push_str(TAIL);
    page
}

fn name(value: impl serde::Serialize) -> String {
    let text = serde_json::to_value(value).ok().and_then(|v| v.as_str().map(str::to_owned));
    text.unwrap_or_default().replace('_', " ")
}

fn table(page: &mut String, library: &Library) {
    page.push_str("\n## All of them\n\n| effect | stage | family | physics |\n|---|---|---|---|\n");
    for effect in library.iter() {
        let row = (effect.id(), name(effect.stage()), name(effect.family()), effect.about().physics);
        let _ = writeln!(page, "| [`{0}`](#{0}) | {1} | {2} | {3} |", row.0, row.1, row.2, row.3);
    }
}

fn section(page: &mut String, effect: &dyn Effect, context: &Context<'_>) {
    let about = effect.about();
    let impostors: Vec<String> = about.impostors.iter().map(|id| format!("`{id}`")).collect();
    let _ = write!(page, "\n## {}\n\n{}.\n\n    {}\n\n", effect.id(), about.physics, about.equation);
    let _ = writeln!(page, "- **Needs:** {}.\n- **Mistaken for:** {}.", about.excitation, impostors.join(", "));
    let _ = writeln!(page, "- **Told apart by:** {}.\n- **Source:** {}.", about.separates, about.source);
    let words = effect.in_words(context).map_or_else(
        || "none say it".into(),
        |words| format!("follows the {}, {}, at the {}", name(words.driver.word()), name(words.kinetics), name(words.place)),
    );
    let _ = writeln!(page, "- **In words:** {words}.\n");
    page.push_str("| parameter | unit | meaning |\n|---|---|---|\n");
    let parameters = effect.parameters(context);
    for p in parameters.iter().take(LISTED) {
        let _ = writeln!(page, "| `{}` | {} | {} |", p.name, p.unit, p.meaning);
    }
    if parameters.len() > LISTED {
        page.push_str("| ... | | and so on |\n");
    }
}
