#!/usr/bin/env python3
"""Plots of convergence and scaling from the CSV files beside this script, as SVG; needs nothing but Python.

    cargo run -p truegap-fem --example convergence > validation/verification/convergence.csv
    cargo run -p truegap-fem --example scaling > validation/verification/scaling.csv
    python3 validation/peers/fem/fem.py                      # peers.csv
    python3 validation/verification/plots.py
"""

import csv
import math
from pathlib import Path

HERE = Path(__file__).resolve().parent
WIDTH, HEIGHT, LEFT, TOP, RIGHT, BOTTOM = 460, 340, 62, 34, 14, 46
LEGEND = 20
TICKS = 0.008  # s, two ticks of the clock that counts processor time
COLOURS = ["#c1121f", "#1d4e89", "#2a9d8f", "#e09f3e", "#6a4c93", "#555555"]
MARKS = ["circle", "square", "diamond", "triangle", "circle", "square"]


class Panel:
    """One pair of logarithmic axes with its curves: name -> list of (x, y)."""

    def __init__(self, title, x, y, curves):
        self.title, self.x, self.y = title, x, y
        self.curves = {n: sorted(p) for n, p in curves.items() if p}
        points = [p for c in self.curves.values() for p in c]
        self.spans = [span([p[k] for p in points]) for k in (0, 1)]

    def place(self, point):
        (x0, x1), (y0, y1) = self.spans
        x = LEFT + (math.log10(point[0]) - x0) / (x1 - x0) * (WIDTH - LEFT - RIGHT)
        y = HEIGHT - BOTTOM - (math.log10(point[1]) - y0) / (y1 - y0) * (HEIGHT - TOP - BOTTOM)
        return x, y

    def svg(self):
        out = [text(WIDTH / 2, 18, self.title, 13, "middle", bold=True)]
        out += self.grid(0) + self.grid(1)
        out.append(f'<rect x="{LEFT}" y="{TOP}" width="{WIDTH - LEFT - RIGHT}" height="{HEIGHT - TOP - BOTTOM}" fill="none" stroke="#333"/>')
        out.append(text((LEFT + WIDTH - RIGHT) / 2, HEIGHT - 10, self.x, 12, "middle"))
        middle = (TOP + HEIGHT - BOTTOM) / 2
        out.append(f'<g transform="rotate(-90 14 {middle})">' + text(14, middle, self.y, 12, "middle") + "</g>")
        for k, (name, points) in enumerate(self.curves.items()):
            out.append(curve(k, [self.place(p) for p in points]))
            out.append(mark(k, LEFT + 8, HEIGHT + LEGEND * (k + 0.4)))
            out.append(text(LEFT + 20, HEIGHT + LEGEND * (k + 0.4) + 4, name, 12, "start"))
        return "\n".join(out)

    def grid(self, k):
        """Lines and numbers at the powers of ten."""
        out, (low, high) = [], self.spans[k]
        for n in range(math.ceil(low - 1e-9), math.floor(high + 1e-9) + 1):
            ends = [(10.0**n, 10.0 ** self.spans[1][0]), (10.0**n, 10.0 ** self.spans[1][1])]
            if k == 1:
                ends = [(10.0 ** self.spans[0][0], 10.0**n), (10.0 ** self.spans[0][1], 10.0**n)]
            (x0, y0), (x1, y1) = map(self.place, ends)
            out.append(f'<line x1="{x0:.1f}" y1="{y0:.1f}" x2="{x1:.1f}" y2="{y1:.1f}" stroke="#ddd"/>')
            where = (x0, HEIGHT - BOTTOM + 16, "middle") if k == 0 else (LEFT - 6, y0 + 4, "end")
            out.append(text(where[0], where[1], power(n), 11, where[2]))
        return out


def span(values):
    """Whole powers of ten around positive values."""
    logs = [math.log10(v) for v in values]
    low, high = math.floor(min(logs)), math.ceil(max(logs))
    return low, max(high, low + 1)


def power(n):
    plain = {-2: "0.01", -1: "0.1", 0: "1", 1: "10", 2: "100"}
    digits = str(n).translate(str.maketrans("-0123456789", "⁻⁰¹²³⁴⁵⁶⁷⁸⁹"))
    return plain.get(n, f"10{digits}")


def text(x, y, words, size, anchor, bold=False):
    weight = ' font-weight="bold"' if bold else ""
    return f'<text x="{x:.1f}" y="{y:.1f}" font-size="{size}" text-anchor="{anchor}"{weight}>{words}</text>'


def curve(k, points):
    path = " ".join(f"{x:.1f},{y:.1f}" for x, y in points)
    line = f'<polyline points="{path}" fill="none" stroke="{COLOURS[k]}" stroke-width="1.6"/>'
    return line + "".join(mark(k, x, y) for x, y in points)


def mark(k, x, y):
    r = 3.6
    if MARKS[k] == "circle":
        return f'<circle cx="{x:.1f}" cy="{y:.1f}" r="{r}" fill="{COLOURS[k]}"/>'
    corners = {
        "square": [(-r, -r), (r, -r), (r, r), (-r, r)],
        "diamond": [(0, -1.3 * r), (1.3 * r, 0), (0, 1.3 * r), (-1.3 * r, 0)],
        "triangle": [(0, -1.2 * r), (1.2 * r, r), (-1.2 * r, r)],
    }[MARKS[k]]
    path = " ".join(f"{x + a:.1f},{y + b:.1f}" for a, b in corners)
    return f'<polygon points="{path}" fill="{COLOURS[k]}"/>'


def write(name, panels):
    """Panels side by side, their legends below."""
    width = WIDTH * len(panels)
    height = HEIGHT + LEGEND * max(len(p.curves) for p in panels) + 8
    parts = [f'<svg xmlns="http://www.w3.org/2000/svg" viewBox="0 0 {width} {height}" width="{width}" height="{height}" font-family="sans-serif">']
    parts.append(f'<rect width="{width}" height="{height}" fill="white"/>')
    parts += [f'<g transform="translate({WIDTH * i} 0)">\n{p.svg()}\n</g>' for i, p in enumerate(panels)]
    (HERE / name).write_text("\n".join(parts) + "\n</svg>\n")


def rows(name):
    with open(HERE / name) as file:
        return list(csv.DictReader(file))


def grouped(table, key, x, y):
    """Curves of a table: points (x, y) by the name that `key` gives a row."""
    out = {}
    for r in table:
        out.setdefault(key(r), []).append((float(r[x]), abs(float(r[y]))))
    return out


def convergence():
    table = rows("convergence.csv")
    for problem, file in [("disc capacitor", "convergence_disc.svg"), ("rubber disc", "convergence_rubber.svg")]:
        chosen = [r for r in table if r["problem"] == problem]
        key = lambda r: f"{r['elements']}, {r['mesh']}"
        panels = [
            Panel(f"{problem}: error", "unknowns", "relative error", grouped(chosen, key, "unknowns", "relative_error")),
            Panel(f"{problem}: accuracy and time", "processor seconds", "relative error", grouped(chosen, key, "seconds", "relative_error")),
        ]
        write(file, panels)


def scaling():
    table = rows("scaling.csv")
    steps = {"mesh": "mesh_s", "pattern": "pattern_s", "assembly": "assemble_s", "analysis": "analyse_s", "factorisation": "factorise_s", "whole solve with estimate": "whole_s"}
    # Below a few ticks of the processor clock a time says nothing.
    curves = {n: [(float(r["unknowns"]), float(r[c])) for r in table if float(r[c]) > TICKS] for n, c in steps.items()}
    memory = {"factor, scaled matrix, workspace": [(float(r["unknowns"]), float(r["solver_mb"])) for r in table]}
    left = Panel("truegap: time of the steps", "unknowns", "processor seconds", curves)
    write("scaling.svg", [left, Panel("truegap: memory of the solver", "unknowns", "MB", memory)])


def peers():
    table = [r for r in rows("peers.csv") if r["table"] == "sizes"]
    for problem, title, file in [("disc", "disc capacitor", "peers_disc.svg"), ("rubber", "rubber disc", "peers_rubber.svg")]:
        chosen = [r for r in table if r["problem"] == problem]
        key = lambda r: r["program"]
        panels = [
            Panel(f"{title}: time to solution", "unknowns", "processor seconds", grouped(chosen, key, "unknowns", "seconds")),
            Panel(f"{title}: memory of the process", "unknowns", "MB", grouped(chosen, key, "unknowns", "peak_mb")),
        ]
        write(file, panels)


if __name__ == "__main__":
    convergence()
    scaling()
    peers()
