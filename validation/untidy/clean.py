"""The clean table that every untidy one is made of, and its twins: plain CSV with default names, which need nothing but a reader of numbers.

A load cell whose reading follows the temperature too: a straight line through the load leaves that out.
"""
import dataclasses
import math
import pathlib
import random

ROWS = 240
STEP_S = 0.5


@dataclasses.dataclass(frozen=True)
class Row:
    """One row, with as many decimals as the table has of it: s, N, degC, mV."""

    time: float
    force: float
    temperature: float
    reading: float


def rows() -> list[Row]:
    noise = random.Random(6)
    found = []
    for index in range(ROWS):
        time = STEP_S * index
        force = 5.0 + 4.0 * math.sin(time / 4.5) + 0.3 * math.sin(time / 1.3)
        temperature = 22.0 + 5.0 * math.sin(time / 19.0) + noise.gauss(0.0, 0.01)
        reading = 110.0 + 12.0 * force + 1.5 * (temperature - 22.0) + noise.gauss(0.0, 0.1)
        found.append(Row(time, round(force, 3), round(temperature, 2), round(reading, 3)))
    return found


def write_twin(path: pathlib.Path, kept: list[Row]) -> None:
    """The same rows as plain as can be: units in the names, repr of each number."""
    lines = ["time_s,force_n,temperature_c,response_mv"]
    lines += [f"{row.time!r},{row.force!r},{row.temperature!r},{row.reading!r}" for row in kept]
    path.write_text("\n".join(lines) + "\n", encoding="ascii")
