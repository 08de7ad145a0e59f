"""A recording by other people: a solar module on a roof, beside the textbook's simulation of its temperature.

Faiman (2008): module = air + light / (u0 + u1 wind), everything at once. The module has mass, so it is late; the diagnosis is asked what the textbook leaves out.
The recording (National Renewable Energy Laboratory, RSF II) ships inside the package pvanalytics (MIT). Fetch it, then run this:

    python validation/recordings/packages/fetch.py RECORDINGS pv-module-temperature
    python crates/truegap-python/examples/real_recording.py RECORDINGS
"""

from __future__ import annotations

import sys
from pathlib import Path

import numpy as np
import numpy.typing as npt

import truegap as tg

Column = npt.NDArray[np.float64]
NAME = "pv-module-temperature"
COLUMNS = {"time": "time_s", "temperature": "ambient", "response": "module"}
UNITS = {"temperature": "degC", "response": "degC"}
DRIVERS = {"irradiance": {"column": "poa", "unit": "W/m2"}, "wind": {"column": "wind", "unit": "m/s"}}
#: Coefficients of the paper, with what modules differ by.
KNOWN = {
    "u0": tg.Parameter(25.0, sd=8.0, unit="W/(m2 K)", low=1.0, meaning="heat loss in still air"),
    "u1": tg.Parameter(6.8, sd=3.0, unit="W s/(m3 K)", low=0.0, meaning="heat loss that wind adds"),
}


def faiman(inputs: dict[str, Column], parameters: dict[str, float]) -> Column:
    """Temperature of a module without mass, degC."""
    return inputs["temperature_c"] + inputs["irradiance"] / (parameters["u0"] + parameters["u1"] * inputs["wind"])


def rows(folder: Path) -> dict[str, Column]:
    """The columns of the recording."""
    file = folder / NAME / f"{NAME}.csv"
    header = file.read_text().splitlines()[0].split(",")
    table = np.loadtxt(file, delimiter=",", skiprows=1, unpack=True)
    return dict(zip(header, table))


def main(folder: str) -> tuple[tg.Diagnosis, tg.Confirmation]:
    whole = rows(Path(folder))
    half = len(whole["time_s"]) // 2
    first, rest = ({name: column[part] for name, column in whole.items()} for part in (slice(half), slice(half, None)))
    d = tg.diagnose(first, base=faiman, parameters=KNOWN, columns=COLUMNS, units=UNITS, drivers=DRIVERS)
    print(d, "\n")
    print(*d.base_parameters, sep="\n")
    confirmation = d.confirm(rest)
    print("\nThe days that took no part:", confirmation.verdict, "-", confirmation.says)
    return d, confirmation


if __name__ == "__main__":
    main(*sys.argv[1:2])
