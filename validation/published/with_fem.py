#!/usr/bin/env python3
"""Which of the paper's conclusions survive the physics that it left out: the audit's replacements, one at a time, on both designs.

    cargo build -p truegap-cli
    python3 validation/published/with_fem.py [target/debug/truegap] > validation/published/with_fem.md

`truegap audit` says what the coefficients of a design become when finite elements (or measured material data) replace one piece of the
analytic chain. Here it is asked for the original and the optimised design of both reconstructions, and the paper's conclusions are drawn
again from the replaced coefficients. Needs nothing but Python's own library.
"""

import json
import subprocess
import sys
import tempfile
from pathlib import Path

HERE = Path(__file__).resolve().parent
SENSORS = HERE.parent.parent / "meshes" / "sensors"
NAMES = ["K_baseline", "K_sensitivity", "K_linearity"]


def audit(program, sensor, folder):
    command = [program, "audit", "--sensor", str(sensor), "-o", str(folder / Path(sensor).stem), "--cache", str(folder / "cache"), "--json", "-q"]
    done = subprocess.run(command, capture_output=True, text=True)
    if done.returncode == 2:
        sys.exit(done.stderr)
    return json.loads(done.stdout)


def coefficients(told, effect):
    """K_baseline in pF/K, K_sensitivity, K_linearity, and K_baseline in % of span/K, with a piece replaced; None where the audit has no number."""
    c = told["coefficients"]
    moved = lambda name, key: None if effect.get(key) is None else c[name] + 0.01 * effect[key] * abs(c[name])
    span, share = moved("span_pf", "span_pct"), moved("k_baseline_pct_fsr_per_k", "k_baseline_pct")
    others = [moved("k_sensitivity_pct_per_k", "k_sensitivity_pct"), moved("k_linearity_pct_per_k", "k_linearity_pct")]
    numbers = [None if None in (share, span) else 0.01 * share * span, *others, share]
    return None if None in numbers else numbers


def row(name, before, after):
    """A line of the table, and which conclusions hold."""
    falls = [100.0 * (1.0 - abs(a / b)) for a, b in zip(after, before)]
    flips = before[2] * after[2] < 0.0
    near = abs(before[3] - 0.2) < 0.05
    told = [f"{fall:+.0f} %" for fall in falls[:3]]
    told += ["yes" if all(fall > 0.0 for fall in falls[:3]) else "no: " + ", ".join(n for n, fall in zip(NAMES, falls) if fall <= 0.0)]
    told += [f"{before[3]:.3f}{'' if near else ' (far from 0.2)'} to {after[3]:.3f}", "flips" if flips else "keeps"]
    return f"| {name} | " + " | ".join(told) + " |"


def main():
    program = sys.argv[1] if len(sys.argv) > 1 else "target/debug/truegap"
    with tempfile.TemporaryDirectory(prefix="truegap-fem-") as folder:
        folder = Path(folder)
        text = (SENSORS / "singletact-s8-optimised.toml").read_text()
        stiffening = folder / "singletact-s8-optimised-stiffening.toml"
        stiffening.write_text(text.replace('softening = "-7.6 kPa/K', 'softening = "+7.6 kPa/K'))
        assert stiffening.read_text() != text, "the softening of the optimised design is written otherwise by now"
        pairs = {
            "softening": ("singletact-s15-4.5n", "singletact-s8-optimised"),
            "stiffening": ("singletact-s15-4.5n-stiffening", stiffening),
        }
        told = {name: [audit(program, sensor, folder) for sensor in pair] for name, pair in pairs.items()}

    print("# The conclusions with one assumption replaced\n")
    print("Written by `python3 validation/published/with_fem.py > validation/published/with_fem.md`; what the two reconstructions are is in [README.md](README.md), what each")
    print("assumption is and how it was replaced in `truegap audit --sensor singletact-s15-4.5n`.\n")
    print("By how much the size of each coefficient falls from the original to the optimised design; a plus is the paper's direction. The data sheet says 0.2 % of span/K.")
    for name, (before, after) in told.items():
        print(f"\n## {name}\n")
        print("| replaced | K_baseline, pF/K | K_sensitivity | K_linearity | all three fall | K_baseline, % of span/K | sign of K_linearity |")
        print("|---|---|---|---|---|---|---|")
        nothing = {key: 0.0 for key in ("span_pct", "k_baseline_pct", "k_sensitivity_pct", "k_linearity_pct")}
        print(row("nothing", coefficients(before, nothing), coefficients(after, nothing)))
        others = {finding["id"]: finding for finding in after["assumptions"]}
        left_out = []
        for finding in before["assumptions"]:
            other = others.get(finding["id"])
            pair = other and (coefficients(before, finding["effect_on"]), coefficients(after, other["effect_on"]))
            if not pair or None in pair:
                left_out.append(finding["id"])
                continue
            print(row(f"{finding['id']} ({finding['verdict']}, {other['verdict']})", *pair))
        if left_out:
            print(f"\nWithout a number for both designs: {', '.join(left_out)}.")


if __name__ == "__main__":
    main()
