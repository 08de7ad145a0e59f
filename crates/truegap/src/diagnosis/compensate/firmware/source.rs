//! The file in C99: a comment that says what it is, a table, and the step from one reading to the next.
//!
//! Limits: `float` alone, no library besides `<stdint.h>`; text of others stands in comments, where nothing of it can end one.

use super::FirmwareError;
use super::document::{FIRST_LINE, FirmwareFacts};
use super::grid::Grid;
use super::lags::Lags;
use std::fmt::Write;
use truegap_diagnose::text::{significant, spoken, spoken_list};

/// Longest line of a comment.
const WIDE: usize = 110;
/// Numbers of a table in a line.
const IN_A_LINE: usize = 8;
/// Bytes of the counter and the flag of the state, of a lag of an input, and of the lag of the reading.
const STATE: [usize; 3] = [8, 12, 8];

/// What the file is written from.
pub(super) struct Source<'a> {
    pub facts: &'a FirmwareFacts,
    pub grid: &'a Grid,
    /// name in C of what each axis of the table follows, the reading first; with the lags of what comes late
    pub axes: &'a [(String, Option<Lags>)],
    /// time constant of the reading and the shortest time of a derivative, s
    pub undone_s: Option<[f64; 2]>,
    /// name of the recording, and its SHA-256
    pub recording: [&'a str; 2],
}

/// Bytes of a state with these lags.
pub(super) fn state_bytes(lags: usize, undoes: bool) -> usize {
    STATE[0] + STATE[1] * lags + if undoes { STATE[2] } else { 0 }
}

impl Source<'_> {
    /// The whole file.
    ///
    /// # Errors
    /// [`FirmwareError::NoFloat`].
    pub fn text(&self) -> Result<String, FirmwareError> {
        let mut text = self.comment();
        text += &self.declarations();
        text += "#ifndef TRUEGAP_DECLARATIONS_ONLY\n\n";
        text += &self.table()?;
        text += ADD.trim_start_matches('\n');
        if self.lags() > 0 {
            text += LATE;
        }
        text += &self.begin();
        text += &self.correct()?;
        text += "#endif /* TRUEGAP_DECLARATIONS_ONLY */\n#endif /* TRUEGAP_CORRECTION */\n";
        // without anything that lags nothing is added up
        if self.lags() == 0 && self.undone_s.is_none() {
            text = text.replace(ADD.trim_start_matches('\n'), "");
        }
        Ok(text)
    }

    fn lags(&self) -> usize {
        self.axes.iter().filter_map(|(_, lags)| lags.as_ref()).map(Lags::states).sum()
    }

    /// Axes along which the table has more than one node.
    fn followed(&self) -> Vec<usize> {
        (0..self.axes.len()).filter(|axis| self.grid.nodes[*axis] > 1).collect()
    }

    fn float(&self, value: f64) -> Result<String, FirmwareError> {
        let float = value as f32;
        match float.is_finite() {
            true => Ok(format!("{float:e}f")),
            false => Err(FirmwareError::NoFloat { model: self.facts.model.file.clone(), value }),
        }
    }

    fn comment(&self) -> String {
        let facts = self.facts;
        let unit = &facts.unit;
        let mut lines = vec![
            format!("{FIRST_LINE} ({}). Write it again where the model changes; do not change it here.", facts.made_by),
            String::new(),
            format!("Corrects the readings of a sensor one after the other for {}.", spoken_list(&facts.corrected_for, "and")),
            format!("Model: {}, fitted to {} (SHA-256 {}).", facts.model.file, self.recording[0], self.recording[1]),
        ];
        lines.extend(facts.left_out.iter().map(|left| format!("Not corrected for {}: {}.", spoken(&left.effect), left.why)));
        lines.push(String::new());
        lines.push(
            "truegap_begin(state): before the first reading, and after a pause in which what is late has come to rest.".into(),
        );
        lines.push(format!("truegap_correct(state, dt_s, ...): the corrected reading, {unit}. Its arguments:"));
        let unused = if self.lags() == 0 && self.undone_s.is_none() { "; plays no part here" } else { "" };
        lines.push(format!("  dt_s: time since the call before, s{unused}"));
        let of_table = facts.readings.map_or_else(String::new, |[low, high]| range(low, high, unit));
        lines.push(format!("  reading: as the sensor gives it, {unit}{of_table}"));
        for argument in &facts.arguments {
            let unit = if argument.unit.is_empty() { "unit as recorded" } else { &argument.unit };
            lines.push(format!("  {}: {}, {unit}{}", argument.name, argument.column, range(argument.low, argument.high, unit)));
        }
        lines.push(
            "Beyond the table its edge holds, and state->outside counts such calls. A number that is none gives none, and changes no state."
                .into(),
        );
        lines.push(String::new());
        lines.push(facts.says.clone());
        lines.extend(facts.doubts().iter().map(|doubt| format!("Note: {doubt}.")));
        lines.push(String::new());
        lines.push("Compile this file once. Elsewhere include it behind #define TRUEGAP_DECLARATIONS_ONLY.".into());
        lines.push("Not for -ffast-math: small steps of a slow lag are added up with what each rounds off.".into());
        commented(&lines)
    }

    fn declarations(&self) -> String {
        let mut text = "#ifndef TRUEGAP_CORRECTION\n#define TRUEGAP_CORRECTION\n\n#include <stdint.h>\n\n".to_owned();
        if self.lags() > 0 || self.undone_s.is_some() {
            text += "/* A sum of small steps: its value, and what was rounded off. */\ntypedef struct {\n    float value, rest;\n} truegap_sum;\n\n";
        }
        text += "typedef struct {\n    uint32_t outside; /* calls beyond the table */\n    uint32_t begun;\n";
        if self.undone_s.is_some() {
            text += "    truegap_sum reading;\n";
        }
        if self.lags() > 0 {
            let _ = writeln!(text, "    truegap_sum late[{0}];\n    float before[{0}];", self.lags()); // writing to a String cannot fail
        }
        let _ = write!(text, "}} truegap_state;\n\nvoid truegap_begin(truegap_state *state);\nfloat {};\n\n", self.signature());
        text
    }

    fn signature(&self) -> String {
        let arguments: String = self.facts.arguments.iter().map(|argument| format!(", float {}", argument.name)).collect();
        format!("truegap_correct(truegap_state *state, float dt_s, float reading{arguments})")
    }

    fn table(&self) -> Result<String, FirmwareError> {
        let (grid, followed) = (self.grid, self.followed());
        let mut text = format!("/* What is added to a reading, {}; the last axis runs fastest. */\n", quoted(&self.facts.unit));
        let _ = writeln!(text, "static const float truegap_table[{}] = {{", grid.values.len());
        for line in grid.values.chunks(IN_A_LINE) {
            let numbers = line.iter().map(|value| self.float(*value)).collect::<Result<Vec<_>, _>>()?;
            let _ = writeln!(text, "    {},", numbers.join(", "));
        }
        text += "};\n\n";
        if followed.is_empty() {
            return Ok(text);
        }
        let names: Vec<&str> = followed.iter().map(|axis| self.axes[*axis].0.as_str()).collect();
        let each = |of: &dyn Fn(usize) -> f64| followed.iter().map(|axis| self.float(of(*axis))).collect::<Result<Vec<_>, _>>();
        let low = each(&|axis| grid.ends[axis][0])?.join(", ");
        let per_unit = each(&|axis| (grid.nodes[axis] - 1) as f64 / (grid.ends[axis][1] - grid.ends[axis][0]))?.join(", ");
        let nodes: Vec<String> = followed.iter().map(|axis| grid.nodes[*axis].to_string()).collect();
        let _ = write!(
            text,
            "/* Axes: {}. */\n#define TRUEGAP_AXES {}\nstatic const float truegap_low[TRUEGAP_AXES] = {{{low}}};\n\
             static const float truegap_steps_per_unit[TRUEGAP_AXES] = {{{per_unit}}};\n\
             static const int32_t truegap_nodes[TRUEGAP_AXES] = {{{}}};\n",
            names.join(", "),
            followed.len(),
            nodes.join(", ")
        );
        Ok(text + LOOK_UP)
    }

    fn begin(&self) -> String {
        "\nvoid truegap_begin(truegap_state *state)\n{\n    state->outside = 0;\n    state->begun = 0;\n}\n".into()
    }

    fn correct(&self) -> Result<String, FirmwareError> {
        let followed = self.followed();
        let numbers = std::iter::once("reading").chain(self.facts.arguments.iter().map(|argument| argument.name.as_str()));
        let nothing: Vec<String> = numbers.map(|name| format!("({name} - {name})")).collect();
        let mut text = format!("\nfloat {}\n{{\n", self.signature());
        if !followed.is_empty() {
            text += "    float at[TRUEGAP_AXES];\n";
        }
        let _ = writeln!(
            text,
            "    /* 0 of finite numbers, and no number else */\n    const float nothing = {};",
            nothing.join(" + ")
        );
        text += "    if (!(nothing == 0.0f)) return nothing;\n";
        text += if self.lags() > 0 || self.undone_s.is_some() {
            "    if (!(dt_s > 0.0f)) dt_s = 0.0f;\n"
        } else {
            "    (void)dt_s;\n"
        };
        if let Some([tau_s, shortest_s]) = self.undone_s {
            let (tau, shortest) = (self.float(tau_s)?, self.float(shortest_s)?);
            let _ = write!(
                text,
                "    {{ /* reading + tau d(reading)/dt, the derivative over the last step or over a time that bounds the noise */\n        \
                 const float over = dt_s > {shortest} ? dt_s : {shortest};\n        float rate;\n        \
                 if (!state->begun) truegap_put(&state->reading, reading);\n        \
                 rate = (reading - state->reading.value) / over;\n        truegap_add(&state->reading, dt_s * rate);\n        \
                 reading = state->reading.value + {tau} * rate;\n    }}\n"
            );
        }
        let mut state = 0;
        let mut late = Vec::new();
        for (axis, (name, lags)) in self.axes.iter().enumerate() {
            let Some(lags) = lags else { continue };
            let (code, value) = self.late(name, lags, &mut state)?;
            text += &code;
            late.push((axis, value));
        }
        text += "    state->begun = 1;\n";
        for (place, axis) in followed.iter().enumerate() {
            let value = late.iter().find(|(late, _)| late == axis).map_or(&self.axes[*axis].0, |(_, value)| value);
            let _ = writeln!(text, "    at[{place}] = {value};");
        }
        let added = if followed.is_empty() { "truegap_table[0]" } else { "truegap_added(state, at)" };
        let _ = write!(text, "    return reading + {added};\n}}\n\n");
        Ok(text)
    }

    /// The steps of the lags of one input, and the expression of what comes late of it.
    fn late(&self, name: &str, lags: &Lags, state: &mut usize) -> Result<(String, String), FirmwareError> {
        let (mut code, mut input, mut parts) = (String::new(), name.to_owned(), Vec::new());
        let mut step = |tau: f64, input: &str, code: &mut String| -> Result<String, FirmwareError> {
            let tau = self.float(tau)?;
            let _ = writeln!(code, "    truegap_late(state, {state}, {input}, dt_s, {tau});");
            *state += 1;
            Ok(format!("state->late[{}].value", *state - 1))
        };
        if lags.first_s > 0.0 {
            input = step(lags.first_s, &input, &mut code)?;
        }
        for (tau_s, share) in &lags.parts {
            let value = step(*tau_s, &input, &mut code)?;
            parts.push(if *share == 1.0 { value } else { format!("{} * {value}", self.float(*share)?) });
        }
        Ok((code, parts.join(" + ")))
    }
}

fn range(low: f64, high: f64, unit: &str) -> String {
    format!("; the table goes from {} to {} {unit}", significant(low, 4), significant(high, 4))
}

/// Text of others in a comment: on one line, and never the end of it.
fn quoted(text: &str) -> String {
    let plain: String = text.chars().map(|c| if c.is_control() { ' ' } else { c }).collect();
    plain.replace("*/", "* /").replace("/*", "/ *").replace("??/", "?? /").replace('\\', "/")
}

/// Lines as a comment; the first one begins it.
fn commented(lines: &[String]) -> String {
    let mut text = String::new();
    for (k, line) in lines.iter().enumerate() {
        let line = if k == 0 { format!("/*{}", quoted(&line[2..])) } else { quoted(line) };
        let indent = line.len() - line.trim_start().len();
        let mut wide = if k == 0 { String::new() } else { format!(" * {}", " ".repeat(indent)).trim_end().to_owned() };
        for word in line.split_whitespace() {
            if !wide.is_empty() && wide.len() + word.len() + 1 > WIDE {
                text += &(wide + "\n");
                wide = format!(" * {}", " ".repeat(indent)).trim_end().to_owned();
            }
            let first = wide.is_empty();
            wide = if first {
                word.to_owned()
            } else {
                format!("{wide} {}{word}", if wide == " *" { " ".repeat(indent) } else { String::new() })
            };
        }
        text += &(wide + "\n");
    }
    text + " */\n"
}

const ADD: &str = r"
static void truegap_put(truegap_sum *sum, float value)
{
    sum->value = value;
    sum->rest = 0.0f;
}

static void truegap_add(truegap_sum *sum, float step)
{
    const float all = step + sum->rest;
    const float value = sum->value + all;
    sum->rest = all - (value - sum->value);
    sum->value = value;
}
";

const LATE: &str = r"
/* A lag of an input that is straight between calls: tau dy/dt + y = x, integrated. */
static void truegap_late(truegap_state *state, int32_t k, float x, float dt_s, float tau_s)
{
    const float ratio = dt_s / tau_s;
    float small = ratio, gain, of_slope;
    int32_t halved = 0;
    if (!state->begun) {
        truegap_put(&state->late[k], x);
        state->before[k] = x;
        return;
    }
    if (!(ratio > 0.0f)) return;
    while (small > 0.5f && halved < 6) {
        small *= 0.5f;
        halved++;
    }
    if (small > 0.5f) small = 0.5f; /* beyond 32 time constants nothing is left */
    /* 1 - (1 - exp(-r)) / r by its series, and 1 - exp(-r) from it */
    of_slope = small * (1.0f / 2 - small * (1.0f / 6 - small * (1.0f / 24 - small * (1.0f / 120 - small * (1.0f / 720 - small / 5040)))));
    gain = small * (1.0f - of_slope);
    for (; halved > 0; halved--) gain *= 2.0f - gain;
    if (ratio > 0.5f) of_slope = 1.0f - gain / ratio;
    truegap_add(&state->late[k], gain * (state->before[k] - state->late[k].value) + of_slope * (x - state->before[k]));
    state->before[k] = x;
}
";

const LOOK_UP: &str = r"
/* The table at a place, straight between its nodes. */
static float truegap_added(truegap_state *state, const float at[TRUEGAP_AXES])
{
    float share[TRUEGAP_AXES], added = 0.0f;
    int32_t cell[TRUEGAP_AXES];
    uint32_t corner;
    int32_t axis;
    int outside = 0;
    for (axis = 0; axis < TRUEGAP_AXES; axis++) {
        const int32_t last = truegap_nodes[axis] - 1;
        float place = (at[axis] - truegap_low[axis]) * truegap_steps_per_unit[axis];
        if (place < 0.0f) {
            place = 0.0f;
            outside = 1;
        }
        if (place > (float)last) {
            place = (float)last;
            outside = 1;
        }
        cell[axis] = (int32_t)place;
        if (cell[axis] == last) cell[axis]--;
        share[axis] = place - (float)cell[axis];
    }
    if (outside && state->outside < UINT32_MAX) state->outside++;
    for (corner = 0; corner < (1u << TRUEGAP_AXES); corner++) {
        float weight = 1.0f;
        int32_t node = 0;
        for (axis = 0; axis < TRUEGAP_AXES; axis++) {
            const int32_t upper = (int32_t)((corner >> axis) & 1u);
            weight *= upper ? share[axis] : 1.0f - share[axis];
            node = node * truegap_nodes[axis] + cell[axis] + upper;
        }
        added += weight * truegap_table[node];
    }
    return added;
}
";
